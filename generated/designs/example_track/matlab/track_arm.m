function self = track_arm(self, t0) %#codegen
%TRACK_ARM Starts again at t0 [s].
%
%   self = track_arm(self, t0), with self from track_init. Keep self: it is what the next call
%   needs.

t0 = double(t0);
if ~isfinite(t0)
    error('track:param', 't0, and what follows, must be finite');
end
deadline = t0 + 1.0;
v1 = deadline - t0;
correction = (t0 - (deadline - v1)) + (1.0 - v1);
if ~isfinite(deadline)
    error('track:param', 't0, and what follows, must be finite');
end
self.t0 = t0;
self.deadline = deadline;
self.correction = correction;
end
