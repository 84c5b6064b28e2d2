function self = ceiling_filter_arm(self, k) %#codegen
%CEILING_FILTER_ARM From tick `k` on a state outside has N samples to return. Estimates and inputs
%under way are kept.
%
%   self = ceiling_filter_arm(self, k), with self from ceiling_filter_init. Keep self: it is what
%   the next call needs.

k = double(k);
if ~(isfinite(k) && (k == floor(k)))
    error('ceiling_filter:param', 'k is %g; legal: whole', k);
end
k = uint32(mod(k, 4294967296));
self.start = k;
end
