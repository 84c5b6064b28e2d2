function self = stage39_arm(self, k) %#codegen
%STAGE39_ARM Starts again: the deadline is N samples after tick `k`.
%
%   self = stage39_arm(self, k), with self from stage39_init. Keep self: it is what the next call
%   needs.

k = double(k);
if ~(isfinite(k) && (k == floor(k)))
    error('stage39:param', 'k is %g; legal: whole', k);
end
k = uint32(mod(k, 4294967296));
self.start = k;
end
