function xhat = in_flight_estimate(self) %#codegen
%IN_FLIGHT_ESTIMATE The estimate of the state at the last sample.
%
%   xhat = in_flight_estimate(self), with self from in_flight_init.

xhat = [self.x1_hat; self.x2_hat];
end
