function self = ptc_tanh3_extern_arm(self, t0) %#codegen
%PTC_TANH3_EXTERN_ARM  Starts again at t0 [s].
%
%   self = ptc_tanh3_extern_arm(self, t0). An error ptc_tanh3_extern:param where t0 or the deadline is not finite.

t0 = double(t0);
if ~isfinite(t0)
    error('ptc_tanh3_extern:param', 't0 must be finite');
end
deadline = t0 + self.tau;
v1 = deadline - t0;
correction = (t0 - (deadline - v1)) + (self.tau - v1);
if ~isfinite(deadline)
    error('ptc_tanh3_extern:param', 't0 + tau must be finite');
end
self.t0 = t0;
self.deadline = deadline;
self.correction = correction;
end
