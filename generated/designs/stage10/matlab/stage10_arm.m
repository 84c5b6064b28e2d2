function self = stage10_arm(self, k) %#codegen
%STAGE10_ARM Starts again: the deadline is N samples after tick `k`.
%
%   self = stage10_arm(self, k), with self from stage10_init. Keep self: it is what the next call
%   needs.

k = double(k);
if ~(isfinite(k) && (k == floor(k)))
    error('stage10:param', 'k is %g; legal: whole', k);
end
k = uint32(mod(k, 4294967296));
self.start = k;
end
