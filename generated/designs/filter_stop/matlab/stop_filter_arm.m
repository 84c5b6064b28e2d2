function self = stop_filter_arm(self, k) %#codegen
%STOP_FILTER_ARM From tick `k` on a state outside has N samples to return.
%
%   self = stop_filter_arm(self, k), with self from stop_filter_init. Keep self: it is what the next
%   call needs.

k = double(k);
if ~(isfinite(k) && (k == floor(k)))
    error('stop_filter:param', 'k is %g; legal: whole', k);
end
k = uint32(mod(k, 4294967296));
self.start = k;
end
