function self = too_soon_arm(self, k) %#codegen
%TOO_SOON_ARM Starts again: the deadline is N samples after tick `k`.
%
%   self = too_soon_arm(self, k), with self from too_soon_init. Keep self: it is what the next call
%   needs.

k = double(k);
if ~(isfinite(k) && (k == floor(k)))
    error('too_soon:param', 'k is %g; legal: whole', k);
end
k = uint32(mod(k, 4294967296));
self.start = k;
self.last = uint32(150);
end
