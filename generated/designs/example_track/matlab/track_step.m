function [u, status] = track_step(self, t, x) %#codegen
%TRACK_STEP u at time t [s] and state x = (x1, x1', ...).
%
%   [u, status] = track_step(self, t, x), with self from track_init.
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
if ~(isfinite(t) && (t >= self.t0))
    status = int32(-2);
    return;
end
past = (t - self.deadline) - self.correction;
late = pick(past < -0.0442, past, -0.0442);
inv_T = (-1.0) / late;
v1 = (2.0 * t) + 0.3;
v2 = sin(v1);
reference0 = 0.1 * v2;
e1 = x(1) - reference0;
reference1 = cos(v1) * 0.2;
e2 = x(2) - reference1;
reference2 = v2 * (-0.4);
v = (((((-20.0) * e1 * inv_T) + ((-8.0) * e2)) * inv_T) + reference2) * 1.5;
if isfinite(v) && (abs(v) <= 50.0) && (late < -0.0442)
    u = v;
    status = int32(0);
elseif isfinite(x(1)) && isfinite(x(2))
    if isfinite(v)
        if v > 50.0
            u = 50.0;
            status = int32(2);
        elseif v < -50.0
            u = -50.0;
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
