function d = stage7_disturbance(self) %#codegen
%STAGE7_DISTURBANCE The estimate of the constant that is added to u.
%
%   d = stage7_disturbance(self), with self from stage7_init.

d = self.d_hat;
end
