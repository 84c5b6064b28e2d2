function self = stage49_arm(self, k) %#codegen
%STAGE49_ARM Starts again: the deadline is N samples after tick `k`. Estimates and inputs under way
%are kept.
%
%   self = stage49_arm(self, k), with self from stage49_init. Keep self: it is what the next call
%   needs.

k = double(k);
if ~(isfinite(k) && (k == floor(k)))
    error('stage49:param', 'k is %g; legal: whole', k);
end
k = uint32(mod(k, 4294967296));
self.start = k;
end
