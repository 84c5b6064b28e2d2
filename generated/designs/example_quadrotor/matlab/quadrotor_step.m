function [u, axes, status] = quadrotor_step(self, t, x, r) %#codegen
%QUADROTOR_STEP u of 4 axes at time t [s], from the state x = (x1, x1', ...) and the reference r =
%(r, r', ...) of each. Its status is that of the first axis that fails, and then every u is 0; else
%SATURATED where an axis is.
%
%   [u, axes, status] = quadrotor_step(self, t, x, r), with self from quadrotor_init.
%
%   status (int32); on a negative one what is given is 0, and self is as it was:
%      0  tracking
%      1  hold: time-to-go held at eps, the deadline is near or over, u is valid
%      2  saturated: u clipped to its limits; wins over 1 and 3
%      3  after: the deadline is over, u is 0 or that of the user-defined law
%      4  gated: a reading was not believed, u by prediction alone; wins over all above
%     -2  an argument is not finite, or time lies before the start, or a tick is not whole
%     -3  u not finite

u = zeros(4, 1, 'double');
axes = repmat(int32(-2), 4, 1);
t = double(t);
x = double(x);
r = double(r);
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
gain = zeros(1, 8, 'double');
gain(1) = v1;
gain(2) = v2;
gain(3) = v3;
gain(4) = v4;
gain(5) = v3;
gain(6) = v4;
gain(7) = v1;
gain(8) = v2;
input_gain = zeros(1, 4, 'double');
input_gain(1) = 0.8333333333333334;
input_gain(2) = 83.33333333333333;
input_gain(3) = 76.92307692307692;
input_gain(4) = 45.45454545454545;
u_max = zeros(1, 4, 'double');
u_max(1) = 8.0;
u_max(2) = 0.4;
u_max(3) = 0.4;
u_max(4) = 0.1;
if late < -0.02
    status = int32(0);
else
    status = int32(1);
end
wanted = zeros(1, 4, 'double');
for axis = 0:3
    e1 = x(axis + 1, 1) - r(axis + 1, 1);
    e2 = x(axis + 1, 2) - r(axis + 1, 2);
    v5 = (gain((2 * axis) + 1) * e1) + (gain((2 * axis) + 2) * e2) + r(axis + 1, 3);
    g = input_gain(axis + 1);
    wanted(axis + 1) = pick((g < 0.0) || (g > 0.0), v5 / g, double(NaN));
end
u(1) = wanted(1);
u(2) = wanted(2);
u(3) = wanted(3);
u(4) = wanted(4);
for axis = 0:3
    axes(axis + 1) = status;
end
outside = uint32(0);
for axis = 0:3
    v = wanted(axis + 1);
    if ~(isfinite(v) && (abs(v) <= u_max(axis + 1)))
        outside = uint32(1);
        break;
    end
end
if outside == uint32(1)
    for axis = 0:3
        v = wanted(axis + 1);
        if ~(isfinite(v) && (abs(v) <= u_max(axis + 1)))
            if isfinite(x(axis + 1, 1)) ...
                && isfinite(x(axis + 1, 2)) ...
                && isfinite(r(axis + 1, 1)) ...
                && isfinite(r(axis + 1, 2)) ...
                && isfinite(r(axis + 1, 3))
                if isfinite(v)
                    if u_max(axis + 1) < v
                        u(axis + 1) = u_max(axis + 1);
                        axes(axis + 1) = int32(2);
                    else
                        u(axis + 1) = -u_max(axis + 1);
                        axes(axis + 1) = int32(2);
                    end
                else
                    axes(axis + 1) = int32(-3);
                end
            else
                axes(axis + 1) = int32(-2);
            end
            if status >= int32(0)
                status = axes(axis + 1);
            end
        end
    end
    if status < int32(0)
        for axis = 0:3
            u(axis + 1) = 0.0;
        end
    end
end
end

function r = pick(condition, yes, no)
if condition
    r = yes;
else
    r = no;
end
end
