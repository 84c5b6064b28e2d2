function [gains, status] = ptc_exp_sum2_tick(self, t) %#codegen
%PTC_EXP_SUM2_TICK  The gains at time t [s], for several axes that share one deadline.
%
%   [gains, status] = ptc_exp_sum2_tick(self, t): tick once, then ptc_exp_sum2_axis(gains, x) for each axis.
%   gains.status is 0 or 1, or -2 where t is not legal; then there are no gains. u
%   may differ from that of step in the last bits.

t = double(t);
gains.gain = zeros(1, 2, 'double');
gains.u_max = self.u_max;
status = int32(-2);
gains.status = status;
if ~(isfinite(t) && (t >= self.t0))
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
for attempt = 1:12
    v4 = exp(-(self.a1 * y));
    v5 = exp(-(self.a2 * y));
    v6 = self.a1 * v4;
    v7 = v4 + v5;
    v8 = self.a2 * v5;
    v9 = (2.0 * (v7 - target)) / (v7 + target);
    v10 = v9 * (1.0 + (0.08333333333333333 * (v9 * v9)));
    v11 = 1.0 / (v6 + v8);
    v12 = v7 * v11;
    v13 = 0.5 * v10 * ((((self.a1 * v6) + (self.a2 * v8)) * v11 * v12) - 1.0);
    v14 = v10 * v12 * (1.0 + v13);
    y_next = y + v14;
    y_size = abs(v14);
    if v10 > 0.0
        y_low = y;
    else
        y_high = y;
    end
    if (y_next >= y_low) && (y_next <= y_high)
        y = y_next;
    else
        y = 0.5 * (y_low + y_high);
    end
    if y_size <= self.tolerance
        break;
    end
end
v15 = exp(-(self.a1 * y));
v16 = exp(-(self.a2 * y));
v17 = self.a1 * v15;
v18 = self.a2 * v16;
v19 = 1.0 / (v17 + v18);
v20 = ((v15 + v16) - target) * v19;
v21 = v20 * (1.0 + (0.5 * (((self.a1 * v17) + (self.a2 * v18)) * v19 * v20)));
v22 = self.a1 * v21;
v23 = v15 - (v15 * (v22 * (1.0 - (0.5 * v22))));
v24 = self.a2 * v21;
v25 = v16 - (v16 * (v24 * (1.0 - (0.5 * v24))));
inv_r1 = 1.0 / ((self.b1_1 * v23) + (self.b1_2 * v25));
p2 = ((self.b2_1 * v23) + (self.b2_2 * v25)) * inv_r1;
gains.gain(1) = self.w1 * inv_r1 * inv_r1;
gains.gain(2) = (self.w2 + ((-2.0) * p2)) * inv_r1;
if late < self.hold_from
    status = int32(0);
else
    status = int32(1);
end
gains.status = status;
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
