function self = stage24_arm(self, k) %#codegen
%STAGE24_ARM Starts again: the deadline is N samples after tick `k`. The time of the reference
%counts from there.
%
%   self = stage24_arm(self, k), with self from stage24_init. Keep self: it is what the next call
%   needs.

k = double(k);
if ~(isfinite(k) && (k == floor(k)))
    error('stage24:param', 'k is %g; legal: whole', k);
end
k = uint32(mod(k, 4294967296));
self.start = k;
end
