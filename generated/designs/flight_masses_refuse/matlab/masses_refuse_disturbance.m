function d = masses_refuse_disturbance(self) %#codegen
%MASSES_REFUSE_DISTURBANCE The estimate of the constant that is added to u.
%
%   d = masses_refuse_disturbance(self), with self from masses_refuse_init.

d = self.d_hat;
end
