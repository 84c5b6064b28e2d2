function self = stage11_arm(self, k) %#codegen
%STAGE11_ARM Starts again: the deadline is N samples after tick `k`. Estimates and inputs under way
%are kept. Estimates too large to compute with begin anew.
%
%   self = stage11_arm(self, k), with self from stage11_init. Keep self: it is what the next call
%   needs.

k = double(k);
if ~(isfinite(k) && (k == floor(k)))
    error('stage11:param', 'k is %g; legal: whole', k);
end
k = uint32(mod(k, 4294967296));
self.start = k;
s1 = abs(self.x1_hat) + abs(self.x2_hat) + abs(self.x3_hat);
size = s1 + abs(self.x4_hat) + abs(self.d_hat);
if ~(size <= single(9.999999843067494e17))
    self.seen = uint32(0);
    self.x1_hat = single(0.0);
    self.x2_hat = single(0.0);
    self.x3_hat = single(0.0);
    self.x4_hat = single(0.0);
    self.d_hat = single(0.0);
end
end
