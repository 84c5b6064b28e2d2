function k = masses_refuse_deadline(self) %#codegen
%MASSES_REFUSE_DEADLINE The tick at which the loop is to be at rest.
%
%   k = masses_refuse_deadline(self), with self from masses_refuse_init.

k = uint32(mod(double(self.start) - double(uint32(mod(double(uint32(0)) - double(self.last), 4294967296))), 4294967296));
end
