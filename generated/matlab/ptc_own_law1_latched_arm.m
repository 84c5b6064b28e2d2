function self = ptc_own_law1_latched_arm(self, t0, x0) %#codegen
%PTC_OWN_LAW1_LATCHED_ARM  Starts again at t0 [s], latching the state x0.
%
%   self = ptc_own_law1_latched_arm(self, t0, x0). An error ptc_own_law1_latched:param where t0, x0 or the deadline is not finite.

t0 = double(t0);
if ~isfinite(t0)
    error('ptc_own_law1_latched:param', 't0 must be finite');
end
x0 = double(x0);
if ~(isfinite(x0(1)))
    error('ptc_own_law1_latched:param', 'x0 must be finite');
end
x1_0 = x0(1);
deadline = t0 + self.tau;
v1 = deadline - t0;
correction = (t0 - (deadline - v1)) + (self.tau - v1);
if ~isfinite(deadline)
    error('ptc_own_law1_latched:param', 't0 + tau must be finite');
end
self.t0 = t0;
self.deadline = deadline;
self.correction = correction;
self.x1_0 = x1_0;
end
