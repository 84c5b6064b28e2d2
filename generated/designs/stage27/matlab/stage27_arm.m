function self = stage27_arm(self, k) %#codegen
%STAGE27_ARM Starts again: the deadline is N samples after tick `k`.
%
%   self = stage27_arm(self, k), with self from stage27_init. Keep self: it is what the next call
%   needs.

k = double(k);
if ~(isfinite(k) && (k == floor(k)))
    error('stage27:param', 'k is %g; legal: whole', k);
end
k = uint32(mod(k, 4294967296));
self.start = k;
end
