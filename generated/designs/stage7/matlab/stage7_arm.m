function self = stage7_arm(self, k) %#codegen
%STAGE7_ARM Starts again: the deadline is N samples after tick `k`. Estimates and inputs under way
%are kept. Estimates too large to compute with begin anew.
%
%   self = stage7_arm(self, k), with self from stage7_init. Keep self: it is what the next call
%   needs.

k = double(k);
if ~(isfinite(k) && (k == floor(k)))
    error('stage7:param', 'k is %g; legal: whole', k);
end
k = uint32(mod(k, 4294967296));
self.start = k;
size = abs(self.x1_hat) + abs(self.d_hat);
if ~(size <= single(9.999999843067494e17))
    self.seen = uint32(0);
    self.x1_hat = single(0.0);
    self.d_hat = single(0.0);
end
end
