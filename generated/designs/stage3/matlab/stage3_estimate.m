function xhat = stage3_estimate(self) %#codegen
%STAGE3_ESTIMATE The estimate of the state at the last sample.
%
%   xhat = stage3_estimate(self), with self from stage3_init.

xhat = [self.x1_hat; self.x2_hat];
end
