function xhat = stage12_estimate(self) %#codegen
%STAGE12_ESTIMATE The estimate of the state at the last sample.
%
%   xhat = stage12_estimate(self), with self from stage12_init.

xhat = [self.x1_hat; self.x2_hat; self.x3_hat];
end
