function xhat = stage46_estimate(self) %#codegen
%STAGE46_ESTIMATE The estimate of the state at the last sample.
%
%   xhat = stage46_estimate(self), with self from stage46_init.

xhat = [self.x1_hat; self.x2_hat];
end
