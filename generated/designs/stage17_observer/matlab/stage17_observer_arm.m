function self = stage17_observer_arm(self, k) %#codegen
%STAGE17_OBSERVER_ARM Starts a round of 8 samples at tick `k`. The estimates are kept. Estimates too
%large to compute with begin anew.
%
%   self = stage17_observer_arm(self, k), with self from stage17_observer_init. Keep self: it is
%   what the next call needs.

k = double(k);
if ~(isfinite(k) && (k == floor(k)))
    error('stage17_observer:param', 'k is %g; legal: whole', k);
end
k = uint32(mod(k, 4294967296));
self.start = k;
size = abs(self.x2_hat) + abs(self.d_hat);
if ~(size <= 1e150)
    self.seen = uint32(0);
    self.x2_hat = 0.0;
    self.d_hat = 0.0;
end
end
