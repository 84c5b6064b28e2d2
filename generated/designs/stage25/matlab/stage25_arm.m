function self = stage25_arm(self, k) %#codegen
%STAGE25_ARM Starts again: the deadline is N samples after tick `k`.
%
%   self = stage25_arm(self, k), with self from stage25_init. Keep self: it is what the next call
%   needs.

k = double(k);
if ~(isfinite(k) && (k == floor(k)))
    error('stage25:param', 'k is %g; legal: whole', k);
end
k = uint32(mod(k, 4294967296));
self.start = k;
end
