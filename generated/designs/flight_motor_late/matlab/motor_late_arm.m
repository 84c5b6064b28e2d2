function self = motor_late_arm(self, k) %#codegen
%MOTOR_LATE_ARM Starts again: the deadline is N samples after tick `k`.
%
%   self = motor_late_arm(self, k), with self from motor_late_init. Keep self: it is what the next
%   call needs.

k = double(k);
if ~(isfinite(k) && (k == floor(k)))
    error('motor_late:param', 'k is %g; legal: whole', k);
end
k = uint32(mod(k, 4294967296));
self.start = k;
self.last = uint32(20);
end
