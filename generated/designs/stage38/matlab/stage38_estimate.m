function xhat = stage38_estimate(self) %#codegen
%STAGE38_ESTIMATE The estimate of the state at the last sample.
%
%   xhat = stage38_estimate(self), with self from stage38_init.

xhat = [self.x1_hat; self.x2_hat];
end
