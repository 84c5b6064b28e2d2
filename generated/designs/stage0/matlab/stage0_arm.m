function self = stage0_arm(self, k) %#codegen
%STAGE0_ARM Starts again: the deadline is N samples after tick `k`.
%
%   self = stage0_arm(self, k), with self from stage0_init. Keep self: it is what the next call
%   needs.

k = double(k);
if ~(isfinite(k) && (k == floor(k)))
    error('stage0:param', 'k is %g; legal: whole', k);
end
k = uint32(mod(k, 4294967296));
self.start = k;
end
