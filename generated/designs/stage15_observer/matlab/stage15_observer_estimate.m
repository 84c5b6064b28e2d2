function xhat = stage15_observer_estimate(self) %#codegen
%STAGE15_OBSERVER_ESTIMATE The estimate of the state at the last sample.
%
%   xhat = stage15_observer_estimate(self), with self from stage15_observer_init.

xhat = [self.x1_hat; self.x2_hat];
end
