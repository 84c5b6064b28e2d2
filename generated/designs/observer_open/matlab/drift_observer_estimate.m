function xhat = drift_observer_estimate(self) %#codegen
%DRIFT_OBSERVER_ESTIMATE The estimates of x2, ... at the last sample.
%
%   xhat = drift_observer_estimate(self), with self from drift_observer_init.

xhat = [self.x2_hat; self.x3_hat];
end
