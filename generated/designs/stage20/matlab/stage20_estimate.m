function xhat = stage20_estimate(self) %#codegen
%STAGE20_ESTIMATE The estimate of the state at the last sample.
%
%   xhat = stage20_estimate(self), with self from stage20_init.

xhat = [self.x1_hat; self.x2_hat];
end
