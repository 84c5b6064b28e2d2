function xhat = stage17_observer_estimate(self) %#codegen
%STAGE17_OBSERVER_ESTIMATE The estimates of x2, ... at the last sample.
%
%   xhat = stage17_observer_estimate(self), with self from stage17_observer_init.

xhat = [self.x2_hat];
end
