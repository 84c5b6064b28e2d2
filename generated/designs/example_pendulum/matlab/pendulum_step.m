function [u, status] = pendulum_step(self, t, x) %#codegen
%PENDULUM_STEP u at time t [s] and state x = (q, w).
%
%   [u, status] = pendulum_step(self, t, x), with self from pendulum_init.
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
x1 = x(1);
if ~((t >= self.t0) && isfinite(x1))
    status = int32(-2);
    return;
end
past = (t - self.deadline) - self.correction;
late = pick(past < -0.006, past, -0.006);
inv_T = (-1.0) / late;
drift = ((-4.905) * sin(x1)) - (0.02 * x(2));
v = ((((-3.0) * x1 * inv_T) + ((-1.5) * x(2))) * inv_T) - drift;
if isfinite(v) && (abs(v) <= 25.0) && (late < -0.006)
    u = v;
    status = int32(0);
elseif isfinite(t) && isfinite(x(2))
    if isfinite(v)
        if v > 25.0
            u = 25.0;
            status = int32(2);
        elseif v < -25.0
            u = -25.0;
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
