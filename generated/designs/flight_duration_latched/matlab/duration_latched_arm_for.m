function self = duration_latched_arm_for(self, t0, tau, x0) %#codegen
%DURATION_LATCHED_ARM_FOR Starts again at t0 [s] with another duration tau [s]: the deadline is t0 +
%tau, latching the state x0.
%
%   self = duration_latched_arm_for(self, t0, tau, x0), with self from duration_latched_init. Keep
%   self: it is what the next call needs.

t0 = double(t0);
tau = double(tau);
x0 = double(x0);
if ~(isfinite(t0) ...
    && isfinite(x0(1)) ...
    && isfinite(x0(2)) ...
    && isfinite(tau) ...
    && (1e-150 <= tau) ...
    && (tau <= 1e150) ...
    && (tau > self.eps))
    error('duration_latched:param', 't0 and tau and x0, and what follows, must be finite, and tau within its domain');
end
deadline = t0 + tau;
v1 = deadline - t0;
correction = (t0 - (deadline - v1)) + (tau - v1);
f44 = x0(1) * 0.125;
if ~(isfinite(deadline) && isfinite(f44))
    error('duration_latched:param', 't0 and tau and x0, and what follows, must be finite, and tau within its domain');
end
self.t0 = t0;
self.tau = tau;
self.deadline = deadline;
self.correction = correction;
self.f44 = f44;
end
