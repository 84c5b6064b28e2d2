function [u, axes, status] = gantry_step(self, t, x) %#codegen
%GANTRY_STEP u of 3 axes at time t [s], from the state x = (x1, x1', ...) of each. Its status is
%that of the first axis that fails, and then every u is 0; else SATURATED where an axis is.
%
%   [u, axes, status] = gantry_step(self, t, x), with self from gantry_init.
%
%   status (int32); on a negative one what is given is 0, and self is as it was:
%      0  tracking
%      1  hold: time-to-go held at eps, the deadline is near or over, u is valid
%      2  saturated: u clipped to its limits; wins over 1 and 3
%      3  after: the deadline is over, u is 0 or that of the user-defined law
%      4  gated: a reading was not believed, u by prediction alone; wins over all above
%     -2  an argument is not finite, or time lies before the start, or a tick is not whole
%     -3  u not finite

u = zeros(3, 1, 'double');
axes = repmat(int32(-2), 3, 1);
t = double(t);
x = double(x);
if ~(isfinite(t) && (t >= self.t0))
    status = int32(-2);
    return;
end
past = (t - self.deadline) - self.correction;
late = pick(past < -0.0159, past, -0.0159);
inv_T = (-1.0) / late;
v1 = (-20.0) * inv_T * inv_T;
v2 = (-8.0) * inv_T;
gain = zeros(1, 6, 'double');
gain(1) = v1;
gain(2) = v2;
gain(3) = v1;
gain(4) = v2;
gain(5) = (-42.0) * inv_T * inv_T;
gain(6) = (-12.0) * inv_T;
input_gain = zeros(1, 3, 'double');
input_gain(1) = 0.008333333333333333;
input_gain(2) = 0.022222222222222223;
input_gain(3) = 0.08333333333333333;
u_max = zeros(1, 3, 'double');
u_max(1) = 900.0;
u_max(2) = 400.0;
u_max(3) = 150.0;
if late < -0.0159
    status = int32(0);
else
    status = int32(1);
end
wanted = zeros(1, 3, 'double');
for axis = 0:2
    v3 = (gain((2 * axis) + 1) * x(axis + 1, 1)) + (gain((2 * axis) + 2) * x(axis + 1, 2));
    g = input_gain(axis + 1);
    wanted(axis + 1) = pick((g < 0.0) || (g > 0.0), v3 / g, double(NaN));
end
u(1) = wanted(1);
u(2) = wanted(2);
u(3) = wanted(3);
for axis = 0:2
    axes(axis + 1) = status;
end
outside = uint32(0);
for axis = 0:2
    v = wanted(axis + 1);
    if ~(isfinite(v) && (abs(v) <= u_max(axis + 1)))
        outside = uint32(1);
        break;
    end
end
if outside == uint32(1)
    for axis = 0:2
        v = wanted(axis + 1);
        if ~(isfinite(v) && (abs(v) <= u_max(axis + 1)))
            if isfinite(x(axis + 1, 1)) && isfinite(x(axis + 1, 2))
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
        for axis = 0:2
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
