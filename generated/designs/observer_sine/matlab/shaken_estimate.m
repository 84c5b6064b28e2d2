function xhat = shaken_estimate(self) %#codegen
%SHAKEN_ESTIMATE The estimate of the state at the last sample.
%
%   xhat = shaken_estimate(self), with self from shaken_init.

xhat = [self.x1_hat; self.x2_hat];
end
