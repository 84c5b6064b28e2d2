function d = stage11_disturbance(self) %#codegen
%STAGE11_DISTURBANCE The estimate of the constant that is added to u.
%
%   d = stage11_disturbance(self), with self from stage11_init.

d = self.d_hat;
end
