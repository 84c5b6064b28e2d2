function xhat = stage23_estimate(self) %#codegen
%STAGE23_ESTIMATE The estimate of the state at the last sample.
%
%   xhat = stage23_estimate(self), with self from stage23_init.

xhat = [self.x1_hat; self.x2_hat; self.x3_hat];
end
