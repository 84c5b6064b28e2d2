function [u, axes, status] = ptc_rational_inputs4_step(self, t, x) %#codegen
%PTC_RATIONAL_INPUTS4_STEP u = (a, b, c, d) at time t [s] and state x = (p, q, r, s). Where one of
%them is not finite, as at a state at which the inputs do not decouple the outputs, every u is 0;
%else the status is SATURATED where one was clipped.
%
%   [u, axes, status] = ptc_rational_inputs4_step(self, t, x), with self from
%   ptc_rational_inputs4_init.
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
x1 = x(1);
x2 = x(2);
x3 = x(3);
x4 = x(4);
if ~(isfinite(t) && (t >= self.t0) && isfinite(x1) && isfinite(x2) && isfinite(x3) && isfinite(x4))
    status = int32(-2);
    return;
end
past = (t - self.deadline) - self.correction;
late = pick(past < self.hold_from, past, self.hold_from);
v1 = late * late;
wanted_axis1 = (self.c1_axis1 * x1) / v1;
drift_axis2 = x1 * x3;
wanted_axis2 = ((self.c1_axis1 * x2) / v1) - drift_axis2;
wanted_axis3 = (self.c1_axis1 * x3) / v1;
wanted_axis4 = (self.c1_axis1 * x4) / v1;
inputs = eliminate([wanted_axis1, wanted_axis2, wanted_axis3, wanted_axis4], [0.0, sin(x2), 3.0, x3, 2.0, x1, 0.0, self.p_m, x3, 3.0 + (x2 * x2), x4, 0.0, 1.0, 0.0, -x1, 4.0]);
control1 = inputs(1);
control2 = inputs(2);
control3 = inputs(3);
control4 = inputs(4);
if late < self.hold_from
    status = int32(0);
else
    status = int32(1);
end
if isfinite(control1) && isfinite(control2) && isfinite(control3) && isfinite(control4)
    u(1) = control1;
    axes(1) = status;
    u(2) = control2;
    axes(2) = status;
    u(3) = control3;
    axes(3) = status;
    u(4) = control4;
    axes(4) = status;
    if control1 > self.u_max
        u(1) = self.u_max;
        axes(1) = int32(2);
        status = int32(2);
    elseif control1 < -self.u_max
        u(1) = -self.u_max;
        axes(1) = int32(2);
        status = int32(2);
    end
    if control2 > self.u_max
        u(2) = self.u_max;
        axes(2) = int32(2);
        status = int32(2);
    elseif control2 < -self.u_max
        u(2) = -self.u_max;
        axes(2) = int32(2);
        status = int32(2);
    end
    if control3 > self.u_max
        u(3) = self.u_max;
        axes(3) = int32(2);
        status = int32(2);
    elseif control3 < -self.u_max
        u(3) = -self.u_max;
        axes(3) = int32(2);
        status = int32(2);
    end
    if control4 > self.u_max
        u(4) = self.u_max;
        axes(4) = int32(2);
        status = int32(2);
    elseif control4 < -self.u_max
        u(4) = -self.u_max;
        axes(4) = int32(2);
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
    u(3) = 0.0;
    if isfinite(control3)
        axes(3) = status;
    else
        axes(3) = int32(-3);
    end
    u(4) = 0.0;
    if isfinite(control4)
        axes(4) = status;
    else
        axes(4) = int32(-3);
    end
    status = int32(-3);
end
end

% Solves a x = b, with a row by row, by elimination with the largest pivot of each column: b becomes
% x, NaN where a is singular.
function b = eliminate(b, a)
    for k = 0:3
        most = k;
        largest = abs(a((4 * k) + k + 1));
        for i = (k + 1):3
            size = abs(a((4 * i) + k + 1));
            if largest < size
                largest = size;
                most = i;
            end
        end
        for i = (k + 1):3
            if most == i
                kept = b(k + 1);
                b(k + 1) = b(i + 1);
                b(i + 1) = kept;
                for j = k:3
                    entry = a((4 * k) + j + 1);
                    a((4 * k) + j + 1) = a((4 * i) + j + 1);
                    a((4 * i) + j + 1) = entry;
                end
            end
        end
        a((4 * k) + k + 1) = pick((a((4 * k) + k + 1) < 0.0) || (a((4 * k) + k + 1) > 0.0), a((4 * k) + k + 1), double(NaN));
        for i = (k + 1):3
            factor = a((4 * i) + k + 1) / a((4 * k) + k + 1);
            for j = (k + 1):3
                a((4 * i) + j + 1) = a((4 * i) + j + 1) - (factor * a((4 * k) + j + 1));
            end
            b(i + 1) = b(i + 1) - (factor * b(k + 1));
        end
    end
    for k = 3:-1:0
        for j = (k + 1):3
            b(k + 1) = b(k + 1) - (a((4 * k) + j + 1) * b(j + 1));
        end
        b(k + 1) = b(k + 1) / a((4 * k) + k + 1);
    end
end

function r = pick(condition, yes, no)
if condition
    r = yes;
else
    r = no;
end
end
