function xhat = stage_estimate(self) %#codegen
%STAGE_ESTIMATE The estimate of the state at the last sample.
%
%   xhat = stage_estimate(self), with self from stage_init.

xhat = [self.x1_hat; self.x2_hat];
end
