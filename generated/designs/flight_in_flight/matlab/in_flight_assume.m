function self = in_flight_assume(self, xhat) %#codegen
%IN_FLIGHT_ASSUME The estimates at the tick of the next call are known: it corrects them by what is
%measured then.
%
%   self = in_flight_assume(self, xhat), with self from in_flight_init. Keep self: it is what the
%   next call needs.

gamma1 = 1.4970872355502905e-5; % prediction from u
late_gamma1 = 4.995835936198459e-6; % prediction from u
gamma2 = 0.019925145638222487; % prediction from u
late_gamma2 = 0.019975020820319007; % prediction from u
xhat = double(xhat);
s1 = (gamma1 * self.u2) + (late_gamma1 * self.u1);
n1 = xhat(1) - s1;
s2 = (gamma2 * self.u2) + (late_gamma2 * self.u1);
n2 = xhat(2) - s2;
if ~(isfinite(n1) && isfinite(n2))
    error('in_flight:param', 'xhat, and what follows, must be finite');
end
self.x1_next = n1;
self.x1_hat = xhat(1);
self.x2_next = n2;
self.x2_hat = xhat(2);
self.seen = uint32(1);
end
