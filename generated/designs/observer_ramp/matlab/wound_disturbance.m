function d = wound_disturbance(self) %#codegen
%WOUND_DISTURBANCE The estimate of the ramp that is added to u.
%
%   d = wound_disturbance(self), with self from wound_init.

d = self.d_hat;
end
