function d = stage12_disturbance(self) %#codegen
%STAGE12_DISTURBANCE The estimate of the constant that is added to u.
%
%   d = stage12_disturbance(self), with self from stage12_init.

d = self.d_hat;
end
