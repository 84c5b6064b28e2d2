function self = masses_refuse_assume_disturbance(self, d) %#codegen
%MASSES_REFUSE_ASSUME_DISTURBANCE The constant that is added to u is known.
%
%   self = masses_refuse_assume_disturbance(self, d), with self from masses_refuse_init. Keep self:
%   it is what the next call needs.

d = single(d);
if ~isfinite(d)
    error('masses_refuse:param', 'd, and what follows, must be finite');
end
self.d_hat = d;
self.d_next = d;
end
