function xhat = late_stage_estimate(self) %#codegen
%LATE_STAGE_ESTIMATE The estimate of the state at the last sample.
%
%   xhat = late_stage_estimate(self), with self from late_stage_init.

xhat = [self.x1_hat; self.x2_hat];
end
