function self = ptc_own_law1_latched_arm(self, t0, x0) %#codegen
%PTC_OWN_LAW1_LATCHED_ARM Starts again at t0 [s], latching the state x0.
%
%   self = ptc_own_law1_latched_arm(self, t0, x0), with self from ptc_own_law1_latched_init. Keep
%   self: it is what the next call needs.

t0 = double(t0);
x0 = double(x0);
if ~(isfinite(t0) && isfinite(x0(1)))
    error('ptc_own_law1_latched:param', 't0 and x0, and what follows, must be finite');
end
deadline = t0 + self.tau;
v1 = deadline - t0;
correction = (t0 - (deadline - v1)) + (self.tau - v1);
if ~isfinite(deadline)
    error('ptc_own_law1_latched:param', 't0 and x0, and what follows, must be finite');
end
self.t0 = t0;
self.deadline = deadline;
self.correction = correction;
self.x1_0 = x0(1);
end
