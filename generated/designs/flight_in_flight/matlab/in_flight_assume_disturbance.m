function self = in_flight_assume_disturbance(self, d) %#codegen
%IN_FLIGHT_ASSUME_DISTURBANCE The constant that is added to u is known.
%
%   self = in_flight_assume_disturbance(self, d), with self from in_flight_init. Keep self: it is
%   what the next call needs.

d = double(d);
if ~isfinite(d)
    error('in_flight:param', 'd, and what follows, must be finite');
end
self.d_hat = d;
self.d_next = d;
end
