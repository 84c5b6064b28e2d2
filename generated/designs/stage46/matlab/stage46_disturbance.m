function d = stage46_disturbance(self) %#codegen
%STAGE46_DISTURBANCE The estimate of the constant that is added to u.
%
%   d = stage46_disturbance(self), with self from stage46_init.

d = self.d_hat;
end
