function d = stage48_disturbance(self) %#codegen
%STAGE48_DISTURBANCE The estimate of the constant that is added to u.
%
%   d = stage48_disturbance(self), with self from stage48_init.

d = self.d_hat;
end
