function self = stage43_arm(self, k) %#codegen
%STAGE43_ARM Starts again: the deadline is N samples after tick `k`. The time of the reference
%counts from there. Estimates and inputs under way are kept. Estimates too large to compute with
%begin anew.
%
%   self = stage43_arm(self, k), with self from stage43_init. Keep self: it is what the next call
%   needs.

k = double(k);
if ~(isfinite(k) && (k == floor(k)))
    error('stage43:param', 'k is %g; legal: whole', k);
end
k = uint32(mod(k, 4294967296));
self.start = k;
s1 = abs(self.x1_hat) + abs(self.x2_hat) + abs(self.x3_hat);
size = s1 + abs(self.d_hat);
if ~(size <= 1e150)
    self.seen = uint32(0);
    self.x1_hat = 0.0;
    self.x2_hat = 0.0;
    self.x3_hat = 0.0;
    self.d_hat = 0.0;
end
end
