function [u, axes, status] = mix_fixed_step(self, t, x) %#codegen
%MIX_FIXED_STEP u = (a, b) at time t [s] and state x = (p, v, h). Where one of them is not finite,
%as at a state at which the inputs do not decouple the outputs, every u is 0; else the status is
%SATURATED where one was clipped.
%
%   [u, axes, status] = mix_fixed_step(self, t, x), with self from mix_fixed_init.
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
past = (t - self.deadline) - self.correction;
late = pick(past < -0.01, past, -0.01);
inv_T_axis1 = (-1.0) / late;
drift_axis1 = -x2;
s1 = (((-20.0) * x1 * inv_T_axis1) + ((-8.0) * x2)) * inv_T_axis1;
wanted_axis1 = s1 - drift_axis1;
drift_axis2 = x2 * x3;
wanted_axis2 = ((-3.0) * x3 * inv_T_axis1) - drift_axis2;
v1 = 2.0 + sin(x1);
v2 = x3 * x3;
v3 = 2.0 + v2;
determinant = (v1 * v3) - v2;
over_determinant = pick((determinant < 0.0) || (determinant > 0.0), 1.0 / determinant, double(NaN));
v4 = -x3;
s2 = ((v3 * wanted_axis1) + (v4 * wanted_axis2)) * over_determinant;
control1 = s2 + (t - t);
s3 = ((v4 * wanted_axis1) + (v1 * wanted_axis2)) * over_determinant;
control2 = s3 + (t - t);
if late < -0.01
    status = int32(0);
else
    status = int32(1);
end
if isfinite(control1) && isfinite(control2)
    u(1) = control1;
    axes(1) = status;
    u(2) = control2;
    axes(2) = status;
    if control1 > 40.0
        u(1) = 40.0;
        axes(1) = int32(2);
        status = int32(2);
    elseif control1 < -40.0
        u(1) = -40.0;
        axes(1) = int32(2);
        status = int32(2);
    end
    if control2 > 15.0
        u(2) = 15.0;
        axes(2) = int32(2);
        status = int32(2);
    elseif control2 < -15.0
        u(2) = -15.0;
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
