function self = stage21_arm(self, k) %#codegen
%STAGE21_ARM Starts again: the deadline is N samples after tick `k`. The time of the reference
%counts from there. Estimates and inputs under way are kept.
%
%   self = stage21_arm(self, k), with self from stage21_init. Keep self: it is what the next call
%   needs.

k = double(k);
if ~(isfinite(k) && (k == floor(k)))
    error('stage21:param', 'k is %g; legal: whole', k);
end
k = uint32(mod(k, 4294967296));
self.start = k;
end
