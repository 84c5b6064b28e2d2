function xhat = stage6_estimate(self) %#codegen
%STAGE6_ESTIMATE The estimates of x2, ... at the last sample.
%
%   xhat = stage6_estimate(self), with self from stage6_init.

xhat = [self.x2_hat; self.x3_hat];
end
