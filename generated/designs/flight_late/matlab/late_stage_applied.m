function self = late_stage_applied(self, u) %#codegen
%LATE_STAGE_APPLIED The drive applied `u` in place of the u that the last call of `step` gave.
%
%   self = late_stage_applied(self, u), with self from late_stage_init. Keep self: it is what the
%   next call needs.

u = double(u);
if ~isfinite(u)
    error('late_stage:param', 'u, and what follows, must be finite');
end
self.u1 = u;
end
