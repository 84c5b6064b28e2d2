function self = paced_arm(self, k) %#codegen
%PACED_ARM Starts again: the deadline is N samples after tick `k`. Estimates and inputs under way
%are kept.
%
%   self = paced_arm(self, k), with self from paced_init. Keep self: it is what the next call needs.

k = double(k);
if ~(isfinite(k) && (k == floor(k)))
    error('paced:param', 'k is %g; legal: whole', k);
end
k = uint32(mod(k, 4294967296));
self.start = k;
self.last = uint32(100);
end
