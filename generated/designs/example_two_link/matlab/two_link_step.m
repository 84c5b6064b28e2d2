function [u, axes, status] = two_link_step(self, t, x) %#codegen
%TWO_LINK_STEP u = (M1, M2) at time t [s] and state x = (q1, q2, w1, w2). Where one of them is not
%finite, as at a state at which the inputs do not decouple the outputs, every u is 0; else the
%status is SATURATED where one was clipped.
%
%   [u, axes, status] = two_link_step(self, t, x), with self from two_link_init.
%
%   status (int32); on a negative one what is given is 0, and self is as it was:
%      0  tracking
%      1  hold: time-to-go held at eps, the deadline is near or over, u is valid
%      2  saturated: u clipped to its limits; wins over 1 and 3
%      3  after: the deadline is over, u is 0 or that of the user-defined law
%      4  gated: a reading was not believed, u by prediction alone; wins over all above
%     -2  an argument is not finite, or time lies before the start, or a tick is not whole
%     -3  u not finite

u = zeros(2, 1, 'double');
axes = repmat(int32(-2), 2, 1);
t = double(t);
x = double(x);
x1 = x(1);
x2 = x(2);
x3 = x(3);
x4 = x(4);
if ~(isfinite(t) && (t >= self.t0) && isfinite(x1) && isfinite(x2) && isfinite(x3) && isfinite(x4))
    status = int32(-2);
    return;
end
past = (t - self.deadline) - self.correction;
late = pick(past < -1.0, past, -1.0);
row2_axis1 = ((-2.0) * late) - 1000.0;
inv_T_squared_axis1 = 1.0 / (late * late);
s1 = ((-240000.0) * x1 * inv_T_squared_axis1) + (row2_axis1 * x3);
wanted_axis1 = s1 * inv_T_squared_axis1;
s2 = ((-240000.0) * x2 * inv_T_squared_axis1) + (row2_axis1 * x4);
wanted_axis2 = s2 * inv_T_squared_axis1;
v1 = sin(x2);
v2 = 7.3575 * cos(x1 + x2);
v3 = cos(x2);
v4 = 0.375 + (0.44999999999999996 * v3);
s3 = (1.635 + (0.8999999999999999 * v3)) * wanted_axis1;
s4 = (-0.44999999999999996) * v1 * ((2.0 * x3 * x4) + (x4 * x4));
control1 = s3 + (v4 * wanted_axis2) + (s4 + (20.601 * cos(x1)) + v2);
s5 = (v4 * wanted_axis1) + (0.375 * wanted_axis2);
control2 = s5 + ((0.44999999999999996 * v1 * (x3 * x3)) + v2);
if late < -1.0
    status = int32(0);
else
    status = int32(1);
end
if isfinite(control1) && isfinite(control2)
    u(1) = control1;
    axes(1) = status;
    u(2) = control2;
    axes(2) = status;
    if control1 > 120.0
        u(1) = 120.0;
        axes(1) = int32(2);
        status = int32(2);
    elseif control1 < -120.0
        u(1) = -120.0;
        axes(1) = int32(2);
        status = int32(2);
    end
    if control2 > 60.0
        u(2) = 60.0;
        axes(2) = int32(2);
        status = int32(2);
    elseif control2 < -60.0
        u(2) = -60.0;
        axes(2) = int32(2);
        status = int32(2);
    end
else
    u(1) = 0.0;
    if isfinite(control1)
        axes(1) = status;
    else
        axes(1) = int32(-3);
    end
    u(2) = 0.0;
    if isfinite(control2)
        axes(2) = status;
    else
        axes(2) = int32(-3);
    end
    status = int32(-3);
end
end

function r = pick(condition, yes, no)
if condition
    r = yes;
else
    r = no;
end
end
