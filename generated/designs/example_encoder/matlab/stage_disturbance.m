function d = stage_disturbance(self) %#codegen
%STAGE_DISTURBANCE The estimate of the constant that is added to u.
%
%   d = stage_disturbance(self), with self from stage_init.

d = self.d_hat;
end
