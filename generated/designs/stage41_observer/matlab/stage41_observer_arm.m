function self = stage41_observer_arm(self, k) %#codegen
%STAGE41_OBSERVER_ARM Starts a round of 20 samples at tick `k`. The estimates are kept. Estimates
%that have had no reading for all samples of `coast`, and those too large to compute with, begin
%anew.
%
%   self = stage41_observer_arm(self, k), with self from stage41_observer_init. Keep self: it is
%   what the next call needs.

k = double(k);
if ~(isfinite(k) && (k == floor(k)))
    error('stage41_observer:param', 'k is %g; legal: whole', k);
end
k = uint32(mod(k, 4294967296));
self.start = k;
s1 = abs(self.x1_next) + abs(self.x2_next);
size = s1 + abs(self.x3_next);
if ~((self.trust > uint32(1)) && (size <= single(9.999999843067494e17)))
    self.seen = uint32(0);
    self.x1_hat = single(0.0);
    self.x1_next = single(0.0);
    self.x2_hat = single(0.0);
    self.x2_next = single(0.0);
    self.x3_hat = single(0.0);
    self.x3_next = single(0.0);
end
end
