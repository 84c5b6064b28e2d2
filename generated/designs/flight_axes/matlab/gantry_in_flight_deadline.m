function k = gantry_in_flight_deadline(self) %#codegen
%GANTRY_IN_FLIGHT_DEADLINE The tick at which the loop is to be at rest.
%
%   k = gantry_in_flight_deadline(self), with self from gantry_in_flight_init.

k = uint32(mod(double(self.start) - double(uint32(mod(double(uint32(0)) - double(self.last), 4294967296))), 4294967296));
end
