function d = shaken_disturbance(self) %#codegen
%SHAKEN_DISTURBANCE The estimate of the sine that is added to u.
%
%   d = shaken_disturbance(self), with self from shaken_init.

d = self.d_hat;
end
