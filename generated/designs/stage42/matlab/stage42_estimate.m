function xhat = stage42_estimate(self) %#codegen
%STAGE42_ESTIMATE The estimate of the state at the last sample.
%
%   xhat = stage42_estimate(self), with self from stage42_init.

xhat = [self.x1_hat; self.x2_hat];
end
