function d = stage38_disturbance(self) %#codegen
%STAGE38_DISTURBANCE The estimate of the constant that is added to u.
%
%   d = stage38_disturbance(self), with self from stage38_init.

d = self.d_hat;
end
