function self = drive_arm(self, t0) %#codegen
%DRIVE_ARM Starts again at t0 [s].
%
%   self = drive_arm(self, t0), with self from drive_init. Keep self: it is what the next call
%   needs.

t0 = double(t0);
if ~isfinite(t0)
    error('drive:param', 't0, and what follows, must be finite');
end
deadline = t0 + 0.4;
v1 = deadline - t0;
correction = (t0 - (deadline - v1)) + (0.4 - v1);
if ~isfinite(deadline)
    error('drive:param', 't0, and what follows, must be finite');
end
self.t0 = t0;
self.deadline = deadline;
self.correction = correction;
end
