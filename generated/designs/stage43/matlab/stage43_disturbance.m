function d = stage43_disturbance(self) %#codegen
%STAGE43_DISTURBANCE The estimate of the constant that is added to u.
%
%   d = stage43_disturbance(self), with self from stage43_init.

d = self.d_hat;
end
