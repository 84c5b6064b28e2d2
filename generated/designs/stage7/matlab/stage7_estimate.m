function xhat = stage7_estimate(self) %#codegen
%STAGE7_ESTIMATE The estimate of the state at the last sample.
%
%   xhat = stage7_estimate(self), with self from stage7_init.

xhat = [self.x1_hat];
end
