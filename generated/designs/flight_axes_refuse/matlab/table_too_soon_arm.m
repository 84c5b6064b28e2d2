function self = table_too_soon_arm(self, k) %#codegen
%TABLE_TOO_SOON_ARM Starts again: the deadline is N samples after tick `k`.
%
%   self = table_too_soon_arm(self, k), with self from table_too_soon_init. Keep self: it is what
%   the next call needs.

k = double(k);
if ~(isfinite(k) && (k == floor(k)))
    error('table_too_soon:param', 'k is %g; legal: whole', k);
end
k = uint32(mod(k, 4294967296));
self.start = k;
self.last = uint32(150);
end
