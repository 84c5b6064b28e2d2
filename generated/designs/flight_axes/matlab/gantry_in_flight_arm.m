function self = gantry_in_flight_arm(self, k) %#codegen
%GANTRY_IN_FLIGHT_ARM Starts again: the deadline is N samples after tick `k`.
%
%   self = gantry_in_flight_arm(self, k), with self from gantry_in_flight_init. Keep self: it is
%   what the next call needs.

k = double(k);
if ~(isfinite(k) && (k == floor(k)))
    error('gantry_in_flight:param', 'k is %g; legal: whole', k);
end
k = uint32(mod(k, 4294967296));
self.start = k;
self.last = uint32(1500);
end
