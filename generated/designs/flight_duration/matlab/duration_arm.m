function self = duration_arm(self, t0) %#codegen
%DURATION_ARM Starts again at t0 [s], with the tau last used.
%
%   self = duration_arm(self, t0), with self from duration_init. Keep self: it is what the next call
%   needs.

t0 = single(t0);
if ~isfinite(t0)
    error('duration:param', 't0, and what follows, must be finite');
end
deadline = t0 + self.tau;
v1 = deadline - t0;
correction = (t0 - (deadline - v1)) + (self.tau - v1);
if ~isfinite(deadline)
    error('duration:param', 't0, and what follows, must be finite');
end
self.t0 = t0;
self.deadline = deadline;
self.correction = correction;
end
