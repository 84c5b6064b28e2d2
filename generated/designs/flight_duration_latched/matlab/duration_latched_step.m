function [u, status] = duration_latched_step(self, t, x) %#codegen
%DURATION_LATCHED_STEP u at time t [s] and state x = (x1, x1', ...).
%
%   [u, status] = duration_latched_step(self, t, x), with self from duration_latched_init.
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
t = double(t);
x = double(x);
if ~(t >= self.t0)
    status = int32(-2);
    return;
end
past = (t - self.deadline) - self.correction;
late = pick(past < self.hold_from, past, self.hold_from);
T = -late;
v1 = T * T * self.p_c;
v2 = 1.0 + v1;
unit = (T * self.p_c) / v2;
v3 = T * unit;
inv_r1 = 1.0 / v3;
xi2 = x(2) * v3;
law = (((-6.0) * x(1)) - (5.0 * xi2)) + self.f44;
s1 = (-2.0) * ((((-(v1 * (-2.0) * (1.0 / v2))) - 1.0) - 1.0) * 0.5 * unit);
v = ((law * inv_r1) + (s1 * x(2))) * inv_r1;
if isfinite(v) && (abs(v) <= self.u_max) && (late < self.hold_from)
    u = v;
    status = int32(0);
elseif isfinite(t) && isfinite(x(1)) && isfinite(x(2))
    if isfinite(v)
        if v > self.u_max
            u = self.u_max;
            status = int32(2);
        elseif v < -self.u_max
            u = -self.u_max;
            status = int32(2);
        else
            u = v;
            status = int32(1);
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
