function self = stage50_arm(self, k) %#codegen
%STAGE50_ARM Starts again: the deadline is N samples after tick `k`.
%
%   self = stage50_arm(self, k), with self from stage50_init. Keep self: it is what the next call
%   needs.

k = double(k);
if ~(isfinite(k) && (k == floor(k)))
    error('stage50:param', 'k is %g; legal: whole', k);
end
k = uint32(mod(k, 4294967296));
self.start = k;
end
