function xhat = stage9_estimate(self) %#codegen
%STAGE9_ESTIMATE The estimate of the state at the last sample.
%
%   xhat = stage9_estimate(self), with self from stage9_init.

xhat = [self.x1_hat; self.x2_hat; self.x3_hat];
end
