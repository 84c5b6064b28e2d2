function [u, status] = duration_step(self, t, x) %#codegen
%DURATION_STEP u at time t [s] and state x = (x1, x1', ...).
%
%   [u, status] = duration_step(self, t, x), with self from duration_init.
%
%   status (int32); on a negative one what is given is 0, and self is as it was:
%      0  tracking
%      1  hold: time-to-go held at eps, the deadline is near or over, u is valid
%      2  saturated: u clipped to its limits; wins over 1 and 3
%      3  after: the deadline is over, u is 0 or that of the user-defined law
%      4  gated: a reading was not believed, u by prediction alone; wins over all above
%     -2  an argument is not finite, or time lies before the start, or a tick is not whole
%     -3  u not finite

u = single(0.0);
t = single(t);
x = single(x);
if ~(t >= self.t0)
    status = int32(-2);
    return;
end
past = (t - self.deadline) - self.correction;
late = pick(past < self.hold_from, past, self.hold_from);
v1 = late * self.inv_tau;
inv_T_squared = single(1.0) / (late * late);
v2 = v1 * v1;
s1 = (((((-single(9.254479664377868e-5)) * v2) - single(7.244605360057221e-9)) * v2) - single(0.0006016576080583036)) * v2;
s2 = ((((s1 - single(0.001899098395369947)) * v2) - single(0.007859068922698498)) * v2) - single(0.03179009631276131);
th_cot_th = (((((s2 * v2) - single(0.1352904886007309)) * v2) - single(0.822467029094696)) * v2) + single(1.0);
cot_rate_squared = inv_T_squared * (th_cot_th * th_cot_th);
slope = self.angle_rate + (self.inv_angle_rate * cot_rate_squared);
row1 = self.c1_3 * slope * slope * slope;
T = -late;
cot_rate = T * inv_T_squared * th_cot_th;
s3 = (self.c2_4 * cot_rate_squared) + self.c2_2;
s4 = ((self.c2_3 * cot_rate_squared) + self.c2_1) * cot_rate;
row2 = (s3 * cot_rate_squared) + self.c2_0 + s4;
row3 = (self.c3_2 * cot_rate_squared) + self.c3_0 + (single(6.0) * cot_rate);
v = (row1 * x(1)) + (row2 * x(2)) + (row3 * x(3));
if isfinite(v) && (abs(v) <= single(100.0)) && (late < self.hold_from)
    u = v;
    status = int32(0);
elseif isfinite(t) && isfinite(x(1)) && isfinite(x(2)) && isfinite(x(3))
    if isfinite(v)
        if v > single(100.0)
            u = single(100.0);
            status = int32(2);
        elseif v < -single(100.0)
            u = -single(100.0);
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
