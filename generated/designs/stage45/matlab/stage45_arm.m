function self = stage45_arm(self, k) %#codegen
%STAGE45_ARM Starts again: the deadline is N samples after tick `k`. Estimates and inputs under way
%are kept.
%
%   self = stage45_arm(self, k), with self from stage45_init. Keep self: it is what the next call
%   needs.

k = double(k);
if ~(isfinite(k) && (k == floor(k)))
    error('stage45:param', 'k is %g; legal: whole', k);
end
k = uint32(mod(k, 4294967296));
self.start = k;
end
