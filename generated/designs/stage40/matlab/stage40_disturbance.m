function d = stage40_disturbance(self) %#codegen
%STAGE40_DISTURBANCE The estimate of the constant that is added to u.
%
%   d = stage40_disturbance(self), with self from stage40_init.

d = self.d_hat;
end
