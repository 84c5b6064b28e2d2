function self = drift_observer_arm(self, k) %#codegen
%DRIFT_OBSERVER_ARM Starts a round of 60 samples at tick `k`. The estimates are kept. Estimates too
%large to compute with begin anew.
%
%   self = drift_observer_arm(self, k), with self from drift_observer_init. Keep self: it is what
%   the next call needs.

k = double(k);
if ~(isfinite(k) && (k == floor(k)))
    error('drift_observer:param', 'k is %g; legal: whole', k);
end
k = uint32(mod(k, 4294967296));
self.start = k;
s1 = abs(self.x2_hat) + abs(self.x3_hat) + abs(self.d_hat);
size = s1 + abs(self.d_rate_hat);
if ~(size <= 1e150)
    self.seen = uint32(0);
    self.x2_hat = 0.0;
    self.x3_hat = 0.0;
    self.d_hat = 0.0;
    self.d_rate_hat = 0.0;
end
end
