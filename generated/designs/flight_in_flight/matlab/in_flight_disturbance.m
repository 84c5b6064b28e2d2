function d = in_flight_disturbance(self) %#codegen
%IN_FLIGHT_DISTURBANCE The estimate of the constant that is added to u.
%
%   d = in_flight_disturbance(self), with self from in_flight_init.

d = self.d_hat;
end
