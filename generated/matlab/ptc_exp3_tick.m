function [gains, status] = ptc_exp3_tick(self, t) %#codegen
%PTC_EXP3_TICK  The gains at time t [s], for several axes that share one deadline.
%
%   [gains, status] = ptc_exp3_tick(self, t): tick once, then ptc_exp3_axis(gains, x) for each axis.
%   gains.status is 0 or 1, or -2 where t is not legal; then there are no gains. u
%   may differ from that of step in the last bits.

t = double(t);
gains.gain = zeros(1, 3, 'double');
gains.u_max = self.u_max;
status = int32(-2);
gains.status = status;
if ~(isfinite(t) && (t >= self.t0))
    return;
end
past = (t - self.deadline) - self.correction;
late = pick(past < self.hold_from, past, self.hold_from);
inv_T = (-1.0) / late;
gains.gain(1) = self.c1 * (inv_T * inv_T) * inv_T;
gains.gain(2) = self.c2 * inv_T * inv_T;
gains.gain(3) = self.c3 * inv_T;
if late < self.hold_from
    status = int32(0);
else
    status = int32(1);
end
gains.status = status;
end
function r = pick(condition, yes, no)
if condition
    r = yes;
else
    r = no;
end
end
