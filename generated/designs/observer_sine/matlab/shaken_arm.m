function self = shaken_arm(self, k) %#codegen
%SHAKEN_ARM Starts again: the deadline is N samples after tick `k`. Estimates and inputs under way
%are kept. Estimates too large to compute with begin anew.
%
%   self = shaken_arm(self, k), with self from shaken_init. Keep self: it is what the next call
%   needs.

k = double(k);
if ~(isfinite(k) && (k == floor(k)))
    error('shaken:param', 'k is %g; legal: whole', k);
end
k = uint32(mod(k, 4294967296));
self.start = k;
s1 = abs(self.x1_hat) + abs(self.x2_hat) + abs(self.d_hat);
size = s1 + abs(self.d_rate_hat);
if ~(size <= 1e150)
    self.seen = uint32(0);
    self.x1_hat = 0.0;
    self.x2_hat = 0.0;
    self.d_hat = 0.0;
    self.d_rate_hat = 0.0;
end
end
