function xhat = motor_estimate(self) %#codegen
%MOTOR_ESTIMATE The estimate of the state at the last sample.
%
%   xhat = motor_estimate(self), with self from motor_init.

xhat = [self.x1_hat; self.x2_hat; self.x3_hat];
end
