function self = ptc_rational_inputs4_arm(self, t0) %#codegen
%PTC_RATIONAL_INPUTS4_ARM Starts again at t0 [s].
%
%   self = ptc_rational_inputs4_arm(self, t0), with self from ptc_rational_inputs4_init. Keep self:
%   it is what the next call needs.

t0 = double(t0);
if ~isfinite(t0)
    error('ptc_rational_inputs4:param', 't0, and what follows, must be finite');
end
deadline = t0 + self.tau;
v1 = deadline - t0;
correction = (t0 - (deadline - v1)) + (self.tau - v1);
if ~isfinite(deadline)
    error('ptc_rational_inputs4:param', 't0, and what follows, must be finite');
end
self.t0 = t0;
self.deadline = deadline;
self.correction = correction;
end
