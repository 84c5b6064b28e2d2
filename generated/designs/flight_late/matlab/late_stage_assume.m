function self = late_stage_assume(self, xhat) %#codegen
%LATE_STAGE_ASSUME The estimates at the tick of the next call are known: it corrects them by what is
%measured then.
%
%   self = late_stage_assume(self, xhat), with self from late_stage_init. Keep self: it is what the
%   next call needs.

gamma1 = 3.3333333333333335e-7; % 1/3000000, prediction from u
gamma2 = 0.0006666666666666666; % 1/1500, prediction from u
back1_2 = -0.001; % -1/1000, a state of a sample ago
back1_3 = 3.3333333333333335e-7; % 1/3000000, a state of a sample ago
back2_3 = -0.0006666666666666666; % -1/1500, a state of a sample ago
xhat = double(xhat);
g1 = xhat(1) - (gamma1 * self.u2);
g2 = xhat(2) - (gamma2 * self.u2);
n1 = g1 + (back1_2 * g2) + (back1_3 * self.d_hat);
n2 = g2 + (back2_3 * self.d_hat);
if ~(isfinite(n1) && isfinite(n2))
    error('late_stage:param', 'xhat, and what follows, must be finite');
end
self.x1_hat = n1;
self.x2_hat = n2;
self.seen = uint32(1);
end
