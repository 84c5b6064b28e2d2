function [u, status, self] = stop_filter_step(self, k, x, u_nominal) %#codegen
%STOP_FILTER_STEP u_nominal as it is, or as near to it as the bounds allow, from tick `k`, which may
%wrap, and the state x = (x1, x1', ...).
%
%   [u, status, self] = stop_filter_step(self, k, x, u_nominal), with self from stop_filter_init.
%   Keep self: it is what the next call needs.
%
%   status (int32); on a negative one what is given is 0, and self is as it was:
%      0  tracking
%      1  hold: time-to-go held at eps, the deadline is near or over, u is valid
%      2  saturated: u clipped to its limits; wins over 1 and 3
%      3  after: the deadline is over, u is 0 or that of the user-defined law
%      4  gated: a reading was not believed, u by prediction alone; wins over all above
%     -2  an argument is not finite, or time lies before the start, or a tick is not whole
%     -3  u not finite
%      6  infeasible: nothing is known from here that keeps all limits or bounds, u is valid

s1_2 = -0.0005; % -1/2000, weight of x2 in the law
u_max = 10.0; % bound of |u|
u = 0.0;
k = double(k);
if ~(isfinite(k) && (k == floor(k)))
    status = int32(-2);
    return;
end
k = uint32(mod(k, 4294967296));
x = double(x);
u_nominal = double(u_nominal);
if ~(isfinite(x(1)) && isfinite(x(2)) && isfinite(u_nominal))
    status = int32(-2);
    return;
end
x1 = x(1);
x2 = x(2);
z1 = x1 + (s1_2 * x2);
z2 = x2;

% The limits of u that keep a safe state safe.
q1_1 = z2 + (9.950166250831947 * z1);
q1_2 = (49.16072709850874 * z2) + (390.1515992227461 * z1);
low1 = (-195.07579961137304) - q1_2;
high1 = 195.07579961137304 - q1_2;
q2_1 = 39.21056084767679 * z2;
low2 = (-31.368448678141434) - q2_1;
high2 = 31.368448678141434 - q2_1;
since = self.start;
safe = uint32(1);
if (-0.5000000004656613 <= z1) ...
    && (z1 <= 0.5000000004656613) ...
    && (-4.975083130049381 <= q1_1) ...
    && (q1_1 <= 4.975083130049381) ...
    && (-0.8000000007450581 <= z2) ...
    && (z2 <= 0.8000000007450581)
    since = k;
else
    safe = uint32(0);

    % Outside: u is held to the law of return too.
    left = double(uint32(400) - uint32(mod(double(k) - double(since), 4294967296)));
    t1 = pick(left < 2.0, 2.0, left);
    law1 = ((((-6000000.0) * z1) / (t1 + 1.0)) - (4000.0 * z2)) / t1;
    weight1 = ((-6000000.0) / (t1 + 1.0)) / t1;
    low1_back = law1 - ((-0.5) * weight1);
    if low1 < low1_back
        low1 = low1_back;
    end
    high1_back = law1 - (0.5 * weight1);
    if high1_back < high1
        high1 = high1_back;
    end
    t2 = pick(left < 1.0, 1.0, left);
    law2 = ((-1000.0) * z2) / t2;
    weight2 = (-1000.0) / t2;
    low2_back = law2 - ((-0.8) * weight2);
    if low2 < low2_back
        low2 = low2_back;
    end
    high2_back = law2 - (0.8 * weight2);
    if high2_back < high2
        high2 = high2_back;
    end
end

% u within them, the bounds of x1 last.
u_now = u_nominal;
if u_now < low2
    u_now = low2;
end
if high2 < u_now
    u_now = high2;
end
if u_now < low1
    u_now = low1;
end
if high1 < u_now
    u_now = high1;
end
if u_now > u_max
    u_now = u_max;
end
if u_now < -u_max
    u_now = -u_max;
end
if ~(isfinite(u_now) && isfinite(low1) && isfinite(high1) && isfinite(low2) && isfinite(high2))
    status = int32(-3);
    return;
end
self.start = since;
if (safe == uint32(0)) || (high2 + 2.9214144384620184e-8 < u_now) || (u_now < low2 - 2.9214144384620184e-8) || (high1 + 1.816784959392371e-7 < u_now) || (u_now < low1 - 1.816784959392371e-7)
    u = u_now;
    status = int32(6);
elseif (u_now < u_nominal) || (u_nominal < u_now)
    u = u_now;
    status = int32(2);
else
    u = u_now;
    status = int32(0);
end
end

function r = pick(condition, yes, no)
if condition
    r = yes;
else
    r = no;
end
end
