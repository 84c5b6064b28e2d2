function xhat = stage41_observer_estimate(self) %#codegen
%STAGE41_OBSERVER_ESTIMATE The estimate of the state at the last sample.
%
%   xhat = stage41_observer_estimate(self), with self from stage41_observer_init.

xhat = [self.x1_hat; self.x2_hat; self.x3_hat];
end
