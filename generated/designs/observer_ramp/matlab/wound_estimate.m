function xhat = wound_estimate(self) %#codegen
%WOUND_ESTIMATE The estimate of the state at the last sample.
%
%   xhat = wound_estimate(self), with self from wound_init.

xhat = [self.x1_hat; self.x2_hat];
end
