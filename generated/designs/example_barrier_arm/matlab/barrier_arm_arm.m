function self = barrier_arm_arm(self, t0) %#codegen
%BARRIER_ARM_ARM Starts again at t0 [s].
%
%   self = barrier_arm_arm(self, t0), with self from barrier_arm_init. Keep self: it is what the
%   next call needs.

t0 = double(t0);
if ~isfinite(t0)
    error('barrier_arm:param', 't0, and what follows, must be finite');
end
deadline = t0 + 20.0;
v1 = deadline - t0;
correction = (t0 - (deadline - v1)) + (20.0 - v1);
if ~isfinite(deadline)
    error('barrier_arm:param', 't0, and what follows, must be finite');
end
self.t0 = t0;
self.deadline = deadline;
self.correction = correction;
end
