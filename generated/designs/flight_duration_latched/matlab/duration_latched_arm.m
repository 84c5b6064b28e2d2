function self = duration_latched_arm(self, t0, x0) %#codegen
%DURATION_LATCHED_ARM Starts again at t0 [s], with the tau last used, latching the state x0.
%
%   self = duration_latched_arm(self, t0, x0), with self from duration_latched_init. Keep self: it
%   is what the next call needs.

t0 = double(t0);
x0 = double(x0);
if ~(isfinite(t0) && isfinite(x0(1)) && isfinite(x0(2)))
    error('duration_latched:param', 't0 and x0, and what follows, must be finite');
end
deadline = t0 + self.tau;
v1 = deadline - t0;
correction = (t0 - (deadline - v1)) + (self.tau - v1);
f44 = x0(1) * 0.125;
if ~(isfinite(deadline) && isfinite(f44))
    error('duration_latched:param', 't0 and x0, and what follows, must be finite');
end
self.t0 = t0;
self.deadline = deadline;
self.correction = correction;
self.f44 = f44;
end
