function [gains, status] = duration_tick(self, t) %#codegen
%DURATION_TICK The gains at time t [s], for several axes that share one deadline: tick once, then
%axis for each. The result of tick and axis may differ from that of step in the last bits.
%
%   [gains, status] = duration_tick(self, t), with self from duration_init.

gains.gain = zeros(1, 3, 'single');
status = int32(-2);
gains.status = status;
t = single(t);
if ~(isfinite(t) && (t >= self.t0))
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
gains.gain(1) = row1;
gains.gain(2) = row2;
gains.gain(3) = row3;
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
