function self = stage40_arm(self, k) %#codegen
%STAGE40_ARM Starts again: the deadline is N samples after tick `k`. Estimates and inputs under way
%are kept. Estimates that have had no reading for all samples of `coast`, and those too large to
%compute with, begin anew.
%
%   self = stage40_arm(self, k), with self from stage40_init. Keep self: it is what the next call
%   needs.

k = double(k);
if ~(isfinite(k) && (k == floor(k)))
    error('stage40:param', 'k is %g; legal: whole', k);
end
k = uint32(mod(k, 4294967296));
self.start = k;
size = abs(self.x1_hat) + abs(self.x2_hat) + abs(self.d_hat);
if ~((self.trust > uint32(1)) && (size <= 1e150))
    self.seen = uint32(0);
    self.x1_hat = 0.0;
    self.x2_hat = 0.0;
    self.d_hat = 0.0;
end
end
