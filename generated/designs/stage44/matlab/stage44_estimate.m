function xhat = stage44_estimate(self) %#codegen
%STAGE44_ESTIMATE The estimate of the state at the last sample.
%
%   xhat = stage44_estimate(self), with self from stage44_init.

xhat = [self.x1_hat; self.x2_hat; self.x3_hat];
end
