function self = stage33_arm(self, k) %#codegen
%STAGE33_ARM Starts again: the deadline is N samples after tick `k`. The time of the reference
%counts from there.
%
%   self = stage33_arm(self, k), with self from stage33_init. Keep self: it is what the next call
%   needs.

k = double(k);
if ~(isfinite(k) && (k == floor(k)))
    error('stage33:param', 'k is %g; legal: whole', k);
end
k = uint32(mod(k, 4294967296));
self.start = k;
end
