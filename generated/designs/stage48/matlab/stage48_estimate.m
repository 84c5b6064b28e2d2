function xhat = stage48_estimate(self) %#codegen
%STAGE48_ESTIMATE The estimate of the state at the last sample.
%
%   xhat = stage48_estimate(self), with self from stage48_init.

xhat = [self.x1_hat; self.x2_hat; self.x3_hat];
end
