function k = table_too_soon_deadline(self) %#codegen
%TABLE_TOO_SOON_DEADLINE The tick at which the loop is to be at rest.
%
%   k = table_too_soon_deadline(self), with self from table_too_soon_init.

k = uint32(mod(double(self.start) - double(uint32(mod(double(uint32(0)) - double(self.last), 4294967296))), 4294967296));
end
