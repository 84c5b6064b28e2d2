function self = mix_fixed_arm(self, t0) %#codegen
%MIX_FIXED_ARM Starts again at t0 [s].
%
%   self = mix_fixed_arm(self, t0), with self from mix_fixed_init. Keep self: it is what the next
%   call needs.

t0 = double(t0);
if ~isfinite(t0)
    error('mix_fixed:param', 't0, and what follows, must be finite');
end
deadline = t0 + 1.0;
v1 = deadline - t0;
correction = (t0 - (deadline - v1)) + (1.0 - v1);
if ~isfinite(deadline)
    error('mix_fixed:param', 't0, and what follows, must be finite');
end
self.deadline = deadline;
self.correction = correction;
end
