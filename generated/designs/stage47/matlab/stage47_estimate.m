function xhat = stage47_estimate(self) %#codegen
%STAGE47_ESTIMATE The estimate of the state at the last sample.
%
%   xhat = stage47_estimate(self), with self from stage47_init.

xhat = [self.x1_hat; self.x2_hat; self.x3_hat];
end
