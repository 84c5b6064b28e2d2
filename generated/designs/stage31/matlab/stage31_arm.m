function self = stage31_arm(self, k) %#codegen
%STAGE31_ARM Starts again: the deadline is N samples after tick `k`.
%
%   self = stage31_arm(self, k), with self from stage31_init. Keep self: it is what the next call
%   needs.

k = double(k);
if ~(isfinite(k) && (k == floor(k)))
    error('stage31:param', 'k is %g; legal: whole', k);
end
k = uint32(mod(k, 4294967296));
self.start = k;
end
