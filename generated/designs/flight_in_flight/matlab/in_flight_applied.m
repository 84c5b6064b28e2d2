function self = in_flight_applied(self, u) %#codegen
%IN_FLIGHT_APPLIED The drive applied `u` in place of the u that the last call of `step` gave.
%
%   self = in_flight_applied(self, u), with self from in_flight_init. Keep self: it is what the next
%   call needs.

u = double(u);
if ~isfinite(u)
    error('in_flight:param', 'u, and what follows, must be finite');
end
self.u1 = u;
end
