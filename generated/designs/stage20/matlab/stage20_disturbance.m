function d = stage20_disturbance(self) %#codegen
%STAGE20_DISTURBANCE The estimate of the constant that is added to u.
%
%   d = stage20_disturbance(self), with self from stage20_init.

d = self.d_hat;
end
