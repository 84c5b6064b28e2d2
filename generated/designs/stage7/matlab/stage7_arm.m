function self = stage7_arm(self, k) %#codegen
%STAGE7_ARM Starts again: the deadline is N samples after tick `k`. Estimates and inputs under way
%are kept.
%
%   self = stage7_arm(self, k), with self from stage7_init. Keep self: it is what the next call
%   needs.

k = double(k);
if ~(isfinite(k) && (k == floor(k)))
    error('stage7:param', 'k is %g; legal: whole', k);
end
k = uint32(mod(k, 4294967296));
self.start = k;
end
