function self = masses_refuse_assume(self, xhat) %#codegen
%MASSES_REFUSE_ASSUME The estimates at the tick of the next call are known: it corrects them by what
%is measured then.
%
%   self = masses_refuse_assume(self, xhat), with self from masses_refuse_init. Keep self: it is
%   what the next call needs.

gamma1 = single(0.0019801282323896885); % prediction from u
gamma2 = single(0.3933916389942169); % prediction from u
xhat = single(xhat);
n1 = xhat(1) - (gamma1 * self.u2);
n2 = xhat(2) - (gamma2 * self.u2);
if ~(isfinite(n1) && isfinite(n2))
    error('masses_refuse:param', 'xhat, and what follows, must be finite');
end
self.x1_next = n1;
self.x1_hat = xhat(1);
self.x2_next = n2;
self.x2_hat = xhat(2);
self.seen = uint32(1);
end
