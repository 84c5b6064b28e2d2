function xhat = stage40_estimate(self) %#codegen
%STAGE40_ESTIMATE The estimate of the state at the last sample.
%
%   xhat = stage40_estimate(self), with self from stage40_init.

xhat = [self.x1_hat; self.x2_hat];
end
