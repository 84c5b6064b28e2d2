function [gains, status] = ptc_exp3_tick(self, t) %#codegen
%PTC_EXP3_TICK The gains at time t [s], for several axes that share one deadline: tick once, then
%axis for each. The result of tick and axis may differ from that of step in the last bits.
%
%   [gains, status] = ptc_exp3_tick(self, t), with self from ptc_exp3_init.

gains.gain = zeros(1, 3, 'double');
gains.u_max = 0.0;
status = int32(-2);
gains.status = status;
t = double(t);
if ~(isfinite(t) && (t >= self.t0))
    status = int32(-2);
    return;
end
past = (t - self.deadline) - self.correction;
late = pick(past < self.hold_from, past, self.hold_from);
inv_T = (-1.0) / late;
gains.gain(1) = self.c1 * (inv_T * inv_T) * inv_T;
gains.gain(2) = self.c2 * inv_T * inv_T;
gains.gain(3) = self.c3 * inv_T;
gains.u_max = self.u_max;
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
