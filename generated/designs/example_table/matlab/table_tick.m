function [gains, status] = table_tick(self, t) %#codegen
%TABLE_TICK The gains at time t [s], for several axes that share one deadline: tick once, then axis
%for each. The result of tick and axis may differ from that of step in the last bits.
%
%   [gains, status] = table_tick(self, t), with self from table_init.

gains.gain = zeros(1, 2, 'double');
status = int32(-2);
gains.status = status;
t = double(t);
if ~(isfinite(t) && (t >= self.t0))
    status = int32(-2);
    return;
end
past = (t - self.deadline) - self.correction;
late = pick(past < -0.0493, past, -0.0493);
inv_T = (-1.0) / late;
gains.gain(1) = (-20.0) * inv_T * inv_T;
gains.gain(2) = (-8.0) * inv_T;
if late < -0.0493
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
