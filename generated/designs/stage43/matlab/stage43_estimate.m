function xhat = stage43_estimate(self) %#codegen
%STAGE43_ESTIMATE The estimate of the state at the last sample.
%
%   xhat = stage43_estimate(self), with self from stage43_init.

xhat = [self.x1_hat; self.x2_hat; self.x3_hat];
end
