function self = late_stage_move(self, dx) %#codegen
%LATE_STAGE_MOVE The target moves by `dx`: from now on y is measured from the new one, and so are
%the estimates.
%
%   self = late_stage_move(self, dx), with self from late_stage_init. Keep self: it is what the next
%   call needs.

dx = double(dx);
moved = self.x1_hat - dx;
if ~isfinite(moved)
    error('late_stage:param', 'dx, and what follows, must be finite');
end
self.x1_hat = moved;
end
