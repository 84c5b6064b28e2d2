function [u, axes, status] = barrier_arm_step(self, t, x) %#codegen
%BARRIER_ARM_STEP u = (M1, M2) at time t [s] and state x = (q1, q2, w1, w2). Where one of them is
%not finite, as at a state at which the inputs do not decouple the outputs, every u is 0; else the
%status is SATURATED where one was clipped.
%
%   [u, axes, status] = barrier_arm_step(self, t, x), with self from barrier_arm_init.
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
T_axis1 = -late;
unit_axis1 = (0.05 * T_axis1) / 20.0;
v1 = T_axis1 * unit_axis1;
inv_r1_axis1 = 1.0 / v1;
xi2_axis1 = x3 * v1;
xi2_axis2 = x4 * v1;
v2 = cos(x2);
v3 = 1.635 + (0.8999999999999999 * v2);
v4 = 0.375 + (0.44999999999999996 * v2);
v5 = 1.0 / ((v3 * 0.375) - (v4 * v4));
v6 = sin(x2);
v7 = x1 * 0.8333333333333334;
s1 = (2.0 * xi2_axis1 * xi2_axis2) + (xi2_axis2 * xi2_axis2);
s2 = (0.45 * v6 * s1) - ((3.0 * x1) / (1.0 - (v7 * v7)));
v8 = s2 - (4.0 * xi2_axis1);
v9 = (-v4) * v5;
v10 = x2 * 1.25;
s3 = (-0.45) * v6 * (xi2_axis1 * xi2_axis1);
v11 = (s3 - ((3.0 * x2) / (1.0 - (v10 * v10)))) - (4.0 * xi2_axis2);
law_axis1 = (0.375 * v5 * v8) + (v9 * v11);
v12 = (-2.0) * (-unit_axis1);
wanted_axis1 = ((law_axis1 * inv_r1_axis1) + (v12 * x3)) * inv_r1_axis1;
law_axis2 = (v9 * v8) + (v3 * v5 * v11);
wanted_axis2 = ((law_axis2 * inv_r1_axis1) + (v12 * x4)) * inv_r1_axis1;
v13 = 7.3575 * cos(x1 + x2);
s4 = (-0.44999999999999996) * v6 * ((2.0 * x3 * x4) + (x4 * x4));
s5 = (v3 * wanted_axis1) + (v4 * wanted_axis2);
control1 = s5 + (s4 + (20.601 * cos(x1)) + v13);
s6 = (v4 * wanted_axis1) + (0.375 * wanted_axis2);
control2 = s6 + ((0.44999999999999996 * v6 * (x3 * x3)) + v13);
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
