function d = late_stage_disturbance(self) %#codegen
%LATE_STAGE_DISTURBANCE The estimate of the constant that is added to u.
%
%   d = late_stage_disturbance(self), with self from late_stage_init.

d = self.d_hat;
end
