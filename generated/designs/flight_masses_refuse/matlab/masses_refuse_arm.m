function self = masses_refuse_arm(self, k) %#codegen
%MASSES_REFUSE_ARM Starts again: the deadline is N samples after tick `k`. Estimates and inputs
%under way are kept. Estimates too large to compute with begin anew.
%
%   self = masses_refuse_arm(self, k), with self from masses_refuse_init. Keep self: it is what the
%   next call needs.

k = double(k);
if ~(isfinite(k) && (k == floor(k)))
    error('masses_refuse:param', 'k is %g; legal: whole', k);
end
k = uint32(mod(k, 4294967296));
self.start = k;
self.last = uint32(20);
size = abs(self.x1_next) + abs(self.x2_next) + abs(self.d_next);
if ~(size <= single(9.999999843067494e17))
    self.seen = uint32(0);
    self.x1_hat = single(0.0);
    self.x1_next = single(0.0);
    self.x2_hat = single(0.0);
    self.x2_next = single(0.0);
    self.d_hat = single(0.0);
    self.d_next = single(0.0);
end
end
