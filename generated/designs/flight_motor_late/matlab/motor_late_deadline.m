function k = motor_late_deadline(self) %#codegen
%MOTOR_LATE_DEADLINE The tick at which the loop is to be at rest.
%
%   k = motor_late_deadline(self), with self from motor_late_init.

k = uint32(mod(double(self.start) - double(uint32(mod(double(uint32(0)) - double(self.last), 4294967296))), 4294967296));
end
