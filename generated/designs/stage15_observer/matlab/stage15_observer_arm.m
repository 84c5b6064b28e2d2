function self = stage15_observer_arm(self, k) %#codegen
%STAGE15_OBSERVER_ARM Starts a round of 9 samples at tick `k`. Estimates and inputs under way are
%kept.
%
%   self = stage15_observer_arm(self, k), with self from stage15_observer_init. Keep self: it is
%   what the next call needs.

k = double(k);
if ~(isfinite(k) && (k == floor(k)))
    error('stage15_observer:param', 'k is %g; legal: whole', k);
end
k = uint32(mod(k, 4294967296));
self.start = k;
end
