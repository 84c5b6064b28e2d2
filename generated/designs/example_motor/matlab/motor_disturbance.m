function d = motor_disturbance(self) %#codegen
%MOTOR_DISTURBANCE The estimate of the constant that is added to u.
%
%   d = motor_disturbance(self), with self from motor_init.

d = self.d_hat;
end
