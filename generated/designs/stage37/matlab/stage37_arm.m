function self = stage37_arm(self, k) %#codegen
%STAGE37_ARM Starts again: the deadline is N samples after tick `k`.
%
%   self = stage37_arm(self, k), with self from stage37_init. Keep self: it is what the next call
%   needs.

k = double(k);
if ~(isfinite(k) && (k == floor(k)))
    error('stage37:param', 'k is %g; legal: whole', k);
end
k = uint32(mod(k, 4294967296));
self.start = k;
end
