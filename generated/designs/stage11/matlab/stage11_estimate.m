function xhat = stage11_estimate(self) %#codegen
%STAGE11_ESTIMATE The estimate of the state at the last sample.
%
%   xhat = stage11_estimate(self), with self from stage11_init.

xhat = [self.x1_hat; self.x2_hat; self.x3_hat; self.x4_hat];
end
