function d = stage3_disturbance(self) %#codegen
%STAGE3_DISTURBANCE The estimate of the constant that is added to u.
%
%   d = stage3_disturbance(self), with self from stage3_init.

d = self.d_hat;
end
