function [gains, status] = quadrotor_tick(self, t) %#codegen
%QUADROTOR_TICK The gains at time t [s] for all axes, from which step computes u of each.
%
%   [gains, status] = quadrotor_tick(self, t), with self from quadrotor_init.

gains.gain = zeros(1, 8, 'double');
gains.input_gain = zeros(1, 4, 'double');
gains.u_max = zeros(1, 4, 'double');
status = int32(-2);
gains.status = status;
t = double(t);
if ~(isfinite(t) && (t >= self.t0))
    status = int32(-2);
    return;
end
past = (t - self.deadline) - self.correction;
late = pick(past < -0.02, past, -0.02);
inv_T = (-1.0) / late;
v1 = (-20.0) * inv_T * inv_T;
v2 = (-8.0) * inv_T;
v3 = (-42.0) * inv_T * inv_T;
v4 = (-12.0) * inv_T;
gains.gain(1) = v1;
gains.gain(2) = v2;
gains.gain(3) = v3;
gains.gain(4) = v4;
gains.gain(5) = v3;
gains.gain(6) = v4;
gains.gain(7) = v1;
gains.gain(8) = v2;
gains.input_gain(1) = 0.8333333333333334;
gains.input_gain(2) = 83.33333333333333;
gains.input_gain(3) = 76.92307692307692;
gains.input_gain(4) = 45.45454545454545;
gains.u_max(1) = 8.0;
gains.u_max(2) = 0.4;
gains.u_max(3) = 0.4;
gains.u_max(4) = 0.1;
if late < -0.02
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
