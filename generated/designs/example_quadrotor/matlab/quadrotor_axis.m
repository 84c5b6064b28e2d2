function [u, status] = quadrotor_axis(gains, axis, x, r) %#codegen
%QUADROTOR_AXIS u of one axis from its state x = (x1, x1', ...), its reference r = (r, r', ...) and
%the gains.
%
%   [u, status] = quadrotor_axis(gains, axis, x, r), with gains from quadrotor_tick.
%
%   status (int32); on a negative one what is given is 0, and self is as it was:
%      0  tracking
%      1  hold: time-to-go held at eps, the deadline is near or over, u is valid
%      2  saturated: u clipped to its limits; wins over 1 and 3
%      3  after: the deadline is over, u is 0 or that of the user-defined law
%      4  gated: a reading was not believed, u by prediction alone; wins over all above
%     -2  an argument is not finite, or time lies before the start, or a tick is not whole
%     -3  u not finite

u = 0.0;
status = gains.status;
if status < 0
    return;
end
axis = double(axis);
if ~(isfinite(axis) && (axis == floor(axis)))
    status = int32(-2);
    return;
end
axis = uint32(mod(axis, 4294967296));
x = double(x);
r = double(r);
if ~(axis < uint32(4))
    status = int32(-2);
    return;
end
e1 = x(1) - r(1);
e2 = x(2) - r(2);
s1 = gains.gain(2 * axis + 1) * e1;
v1 = s1 + (gains.gain(2 * axis + 2) * e2) + r(3);
g = gains.input_gain(axis + 1);
v = pick((g < 0.0) || (g > 0.0), v1 / g, double(NaN));
if isfinite(v) && (abs(v) <= gains.u_max(axis + 1))
    u = v;
    status = gains.status;
elseif isfinite(x(1)) && isfinite(x(2)) && isfinite(r(1)) && isfinite(r(2)) && isfinite(r(3))
    if isfinite(v)
        if v > gains.u_max(axis + 1)
            u = gains.u_max(axis + 1);
            status = int32(2);
        else
            u = -gains.u_max(axis + 1);
            status = int32(2);
        end
    else
        status = int32(-3);
    end
else
    status = int32(-2);
end
end

function r = pick(condition, yes, no)
if condition
    r = yes;
else
    r = no;
end
end
