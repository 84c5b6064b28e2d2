function [u, status, self] = ceiling_filter_step(self, k, x, u_nominal) %#codegen
%CEILING_FILTER_STEP u_nominal as it is, or as near to it as the bounds allow, from tick `k`, which
%may wrap, and the state x = (x1, x1', ...). Call it once for each tick.
%
%   [u, status, self] = ceiling_filter_step(self, k, x, u_nominal), with self from
%   ceiling_filter_init. Keep self: it is what the next call needs.
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

s1_1 = -single(0.5); % -1/2, weight of x1 in the law
s1_2 = -single(0.0024999999441206455); % -1/400, weight of x2 in the law
s1_3 = single(2.0833333564951317e-6); % 1/480000, weight of x3 in the law
s1_5 = -single(6.249999984220267e-8); % -1/16000000, weight of u2 in the law
s2_2 = -single(0.5); % -1/2, weight of x2 in the law
s2_3 = -single(0.004999999888241291); % -1/200, weight of x3 in the law
s2_5 = single(3.7500001781154424e-5); % 3/80000, weight of u2 in the law
s3_3 = -single(0.5); % -1/2, weight of x3 in the law
s3_4 = single(0.009999999776482582); % 1/100, weight of u1 in the law
s3_5 = single(0.004999999888241291); % 1/200, weight of u2 in the law
u = single(0.0);
k = double(k);
if ~(isfinite(k) && (k == floor(k)))
    status = int32(-2);
    return;
end
k = uint32(mod(k, 4294967296));
x = single(x);
u_nominal = single(u_nominal);
if ~(isfinite(x(1)) && isfinite(x(2)) && isfinite(x(3)) && isfinite(u_nominal))
    status = int32(-2);
    return;
end
x1 = x(1);
x2 = x(2);
x3 = x(3);
s1 = (s1_1 * x1) + (s1_2 * x2) + (s1_3 * x3);
z1 = s1 + (s1_5 * (self.u2 - single(0.25)));
s2 = (s2_2 * x2) + (s2_3 * x3);
z2 = s2 + (s2_5 * (self.u2 - single(0.25)));
s3 = (s3_3 * x3) + (s3_4 * (self.u1 - single(0.25)));
z3 = s3 + (s3_5 * (self.u2 - single(0.25)));

% The limits of u that keep a safe state safe.
q1_1 = z2 + (single(2.955446720123291) * z1);
q1_2 = z3 + (single(7.8325042724609375) * z2) + (single(14.413883209228516) * z1);
q1_3 = (single(15.520869255065918) * z3) + (single(74.6330337524414) * z2) + (single(110.81919860839844) * z1);
low1 = (-single(55.15959930419922)) - q1_3;
since = self.start;
safe = uint32(1);
if (z1 >= -single(0.5005000233650208)) ...
    && (q1_1 >= -single(1.479201078414917)) ...
    && (q1_2 >= -single(7.21414852142334))
    since = k;
else
    safe = uint32(0);

    % Outside: u is held to the law of return too.
    left = single(uint32(98) - uint32(mod(double(k) - double(since), 4294967296)));
    t1 = pick(left < single(3.0), single(3.0), left);
    s4 = ((((-single(120000000.0)) * z1) / (t1 + single(3.0))) - (single(600000.0) * z2)) / (t1 + single(2.0));
    law1 = ((s4 - (single(1200.0) * z3)) / (t1 + single(1.0))) + single(0.25);
    weight1 = (((-single(120000000.0)) / (t1 + single(3.0))) / (t1 + single(2.0))) / (t1 + single(1.0));
    low1_back = law1 - ((-single(0.5)) * weight1);
    if low1 < low1_back
        low1 = low1_back;
    end
end

% u within them, the bounds of x1 last.
u_now = u_nominal;
if u_now < low1
    u_now = low1;
end
if u_now > self.u_max
    u_now = self.u_max;
end
if u_now < -self.u_max
    u_now = -self.u_max;
end
if ~(isfinite(u_now) && isfinite(low1))
    status = int32(-3);
    return;
end
self.u2 = self.u1;
self.u1 = u_now;
self.start = since;
if (safe == uint32(0)) || (u_now < low1 - single(0.05540959909558296))
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
