function self = wound_arm(self, k) %#codegen
%WOUND_ARM Starts again: the deadline is N samples after tick `k`. Estimates and inputs under way
%are kept. Estimates too large to compute with begin anew.
%
%   self = wound_arm(self, k), with self from wound_init. Keep self: it is what the next call needs.

k = double(k);
if ~(isfinite(k) && (k == floor(k)))
    error('wound:param', 'k is %g; legal: whole', k);
end
k = uint32(mod(k, 4294967296));
self.start = k;
s1 = abs(self.x1_next) + abs(self.x2_next) + abs(self.d_next);
size = s1 + abs(self.d_rate_next);
if ~(size <= 1e150)
    self.seen = uint32(0);
    self.x1_hat = 0.0;
    self.x1_next = 0.0;
    self.x2_hat = 0.0;
    self.x2_next = 0.0;
    self.d_hat = 0.0;
    self.d_next = 0.0;
    self.d_rate_hat = 0.0;
    self.d_rate_next = 0.0;
end
end
