function self = duration_arm_for(self, t0, tau) %#codegen
%DURATION_ARM_FOR Starts again at t0 [s] with another duration tau [s]: the deadline is t0 + tau.
%
%   self = duration_arm_for(self, t0, tau), with self from duration_init. Keep self: it is what the
%   next call needs.

t0 = single(t0);
tau = single(tau);
if ~(isfinite(t0) ...
    && isfinite(tau) ...
    && (single(1.000000045813705e-18) <= tau) ...
    && (tau <= single(9.999999843067494e17)) ...
    && (tau > self.eps))
    error('duration:param', 't0 and tau, and what follows, must be finite, and tau within its domain');
end
angle_rate = single(1.5707963705062866) / tau;
inv_angle_rate = single(0.6366197466850281) * tau;
deadline = t0 + tau;
v1 = deadline - t0;
correction = (t0 - (deadline - v1)) + (tau - v1);
inv_tau = single(1.0) / tau;
v2 = tau * tau;
c2_0 = self.f69 / v2;
c2_1 = self.f73 / tau;
c2_3 = self.f81 * tau;
c2_4 = self.f85 * v2;
c3_0 = self.f99 / tau;
c3_2 = self.f103 * tau;
if ~(isfinite(deadline) ...
    && (c2_4 <= -single(1.0000000031710769e-30)) ...
    && isfinite(angle_rate) ...
    && isfinite(inv_angle_rate) ...
    && isfinite(inv_tau) ...
    && isfinite(c2_0) ...
    && isfinite(c2_1) ...
    && isfinite(c2_3) ...
    && isfinite(c2_4) ...
    && isfinite(c3_0) ...
    && isfinite(c3_2))
    error('duration:param', 't0 and tau, and what follows, must be finite, and tau within its domain');
end
self.tau = tau;
self.angle_rate = angle_rate;
self.inv_angle_rate = inv_angle_rate;
self.t0 = t0;
self.deadline = deadline;
self.correction = correction;
self.inv_tau = inv_tau;
self.c2_0 = c2_0;
self.c2_1 = c2_1;
self.c2_3 = c2_3;
self.c2_4 = c2_4;
self.c3_0 = c3_0;
self.c3_2 = c3_2;
end
