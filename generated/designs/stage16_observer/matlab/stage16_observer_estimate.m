function xhat = stage16_observer_estimate(self) %#codegen
%STAGE16_OBSERVER_ESTIMATE The estimate of the state at the last sample.
%
%   xhat = stage16_observer_estimate(self), with self from stage16_observer_init.

xhat = [self.x1_hat; self.x2_hat; self.x3_hat];
end
