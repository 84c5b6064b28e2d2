function [gains, status] = gantry_tick(self, t) %#codegen
%GANTRY_TICK The gains at time t [s] for all axes, from which step computes u of each.
%
%   [gains, status] = gantry_tick(self, t), with self from gantry_init.

gains.gain = zeros(1, 6, 'double');
gains.input_gain = zeros(1, 3, 'double');
gains.u_max = zeros(1, 3, 'double');
status = int32(-2);
gains.status = status;
t = double(t);
if ~(isfinite(t) && (t >= self.t0))
    status = int32(-2);
    return;
end
past = (t - self.deadline) - self.correction;
late = pick(past < -0.0159, past, -0.0159);
inv_T = (-1.0) / late;
v1 = (-20.0) * inv_T * inv_T;
v2 = (-8.0) * inv_T;
gains.gain(1) = v1;
gains.gain(2) = v2;
gains.gain(3) = v1;
gains.gain(4) = v2;
gains.gain(5) = (-42.0) * inv_T * inv_T;
gains.gain(6) = (-12.0) * inv_T;
gains.input_gain(1) = 0.008333333333333333;
gains.input_gain(2) = 0.022222222222222223;
gains.input_gain(3) = 0.08333333333333333;
gains.u_max(1) = 900.0;
gains.u_max(2) = 400.0;
gains.u_max(3) = 150.0;
if late < -0.0159
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
