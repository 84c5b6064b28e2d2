function self = stage16_observer_arm(self, k) %#codegen
%STAGE16_OBSERVER_ARM Starts a round of 20 samples at tick `k`. Estimates and inputs under way are
%kept.
%
%   self = stage16_observer_arm(self, k), with self from stage16_observer_init. Keep self: it is
%   what the next call needs.

k = double(k);
if ~(isfinite(k) && (k == floor(k)))
    error('stage16_observer:param', 'k is %g; legal: whole', k);
end
k = uint32(mod(k, 4294967296));
self.start = k;
end
