function self = in_flight_arm(self, k) %#codegen
%IN_FLIGHT_ARM Starts again: the deadline is N samples after tick `k`. Estimates and inputs under
%way are kept. Estimates too large to compute with begin anew.
%
%   self = in_flight_arm(self, k), with self from in_flight_init. Keep self: it is what the next
%   call needs.

k = double(k);
if ~(isfinite(k) && (k == floor(k)))
    error('in_flight:param', 'k is %g; legal: whole', k);
end
k = uint32(mod(k, 4294967296));
self.start = k;
self.last = uint32(300);
size = abs(self.x1_next) + abs(self.x2_next) + abs(self.d_next);
if ~(size <= 1e150)
    self.seen = uint32(0);
    self.x1_hat = 0.0;
    self.x1_next = 0.0;
    self.x2_hat = 0.0;
    self.x2_next = 0.0;
    self.d_hat = 0.0;
    self.d_next = 0.0;
end
end
