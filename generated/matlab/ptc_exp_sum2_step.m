function [u, status] = ptc_exp_sum2_step(self, t, x) %#codegen
%PTC_EXP_SUM2_STEP u at time t [s] and state x = (x1, x1', ...).
%
%   [u, status] = ptc_exp_sum2_step(self, t, x), with self from ptc_exp_sum2_init.
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
target = T * self.target_rate;
v1 = -real_log(target / 2.0);
v2 = v1 * self.mean_period;
v3 = (v1 - 0.6931467056274414) * self.slowest;
y = pick(v2 < v3, v3, v2);
y_low = v2;
y_high = v1 * self.slowest;
for attempt = 0:11
    v4 = exp(-(self.a1 * y));
    v5 = exp(-(self.a2 * y));
    v6 = self.a1 * v4;
    v7 = v4 + v5;
    v8 = self.a2 * v5;
    v9 = (2.0 * (v7 - target)) / (v7 + target);
    v10 = v9 * (1.0 + (0.08333333333333333 * (v9 * v9)));
    v11 = 1.0 / (v6 + v8);
    v12 = v7 * v11;
    s1 = (((self.a1 * v6) + (self.a2 * v8)) * v11 * v12) - 1.0;
    v13 = v10 * v12 * (1.0 + (0.5 * v10 * s1));
    y_next = y + v13;
    y_size = abs(v13);
    if v10 > 0.0
        y_low = y;
    else
        y_high = y;
    end
    if (y_low <= y_next) && (y_next <= y_high)
        y = y_next;
    else
        y = 0.5 * (y_low + y_high);
    end
    if y_size <= self.tolerance
        break;
    end
end
v14 = exp(-(self.a1 * y));
v15 = exp(-(self.a2 * y));
v16 = self.a1 * v14;
v17 = self.a2 * v15;
v18 = 1.0 / (v16 + v17);
v19 = ((v14 + v15) - target) * v18;
s2 = 1.0 + (0.5 * (((self.a1 * v16) + (self.a2 * v17)) * v18 * v19));
v20 = v19 * s2;
v21 = self.a1 * v20;
v22 = v14 - (v14 * (v21 * (1.0 - (0.5 * v21))));
v23 = self.a2 * v20;
v24 = v15 - (v15 * (v23 * (1.0 - (0.5 * v23))));
inv_r1 = 1.0 / ((self.b1_1 * v22) + (self.b1_2 * v24));
p2 = ((self.b2_1 * v22) + (self.b2_2 * v24)) * inv_r1;
s3 = (self.w1 * x(1) * inv_r1) + ((self.w2 + ((-2.0) * p2)) * x(2));
v = s3 * inv_r1;
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

function r = real_log(a)
if a >= 0
    r = log(a);
else
    r = a * NaN;
end
end
