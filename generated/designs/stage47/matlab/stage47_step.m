function [u, status, self] = stage47_step(self, k, y) %#codegen
%STAGE47_STEP u from tick `k`, which may wrap, and what is measured, y = C x. Call it once for each
%tick.
%
%   [u, status, self] = stage47_step(self, k, y), with self from stage47_init. Keep self: it is what
%   the next call needs.
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
k = double(k);
if ~(isfinite(k) && (k == floor(k)))
    status = int32(-2);
    return;
end
k = uint32(mod(k, 4294967296));
y = double(y);
if ~(isfinite(y(1)) && isfinite(y(2)))
    status = int32(-2);
    return;
end
elapsed = uint32(mod(double(k) - double(self.start), 4294967296));

% The estimates; at first what y shows.
if self.seen == uint32(0)
    x1 = y(1);
    x2 = 0.0;
    x3 = y(2);
    d = 0.0;
else
    x1 = self.x1_next + (0.00010803832226644697 * self.u1);
    x2 = self.x2_next + (0.030892799233141147 * self.u1);
    x3 = self.x3_next + (0.3745921515889058 * self.u1);
    d = self.d_next;
end

% Prediction of the next sample.
miss1 = y(1) - x1;
miss2 = y(2) - x3;
off1 = miss1;
off2 = miss2;
left_o = uint32(20) - elapsed;
o0 = double(left_o);
if left_o == uint32(0)
    l1_1 = 0.5288853188994155;
    l1_2 = 11.043581739724111;
    l1_3 = -1.95232951580154;
    l1_4 = -4.310227400623051;
    l2_1 = 0.00186202868892253;
    l2_2 = 0.2724600360147846;
    l2_3 = 1.5302977387244094;
    l2_4 = 2.6662087225258313;
elseif 8.0 < o0
    r0 = 1.0 / o0;
    r1 = 1.0 / (o0 - 1.0);
    l1_1 = ((((-8.0) * r0) + 8.0) * r1) - 0.004980621942852573;
    s1 = ((1207.0156938434693 * r0) - 4.007471679722458) * r1;
    l1_2 = s1 + 0.007132886647707467;
    l1_3 = 0.056139026437663865;
    l1_4 = 359.9103398433305 * r0 * r1;
    l2_1 = 0.0014392695129337434;
    s2 = (((-1.8587963031465917) * r0) + 0.9913796378212842) * r1;
    l2_2 = s2 + 0.11089234841732894;
    l2_3 = ((((-12.0) * r0) + 12.0) * r1) - 0.4680369753891894;
    l2_4 = 79.82759275642569 * r0 * r1;
elseif left_o == uint32(8)
    l1_1 = 0.9950193780571475;
    l1_2 = -0.49380107331759976;
    l1_3 = 0.056139026437663865;
    l1_4 = 0.0;
    l2_1 = 0.0014392695129337434;
    l2_2 = 0.220357858722901;
    l2_3 = 1.0319630246108107;
    l2_4 = 1.3304598792737614;
else
    l1_1 = 1.9950193780571475;
    l1_2 = 99.25595014702932;
    l1_3 = 0.056139026437663865;
    l1_4 = 29.992528320277543;
    l2_1 = 0.0014392695129337434;
    l2_2 = 0.24720839921003274;
    l2_3 = 1.5319630246108107;
    l2_4 = 2.660919758547523;
end
s3 = x1 + (0.009942671770940647 * x2) + (0.000617855984662823 * x3);
x1_on = s3 + (0.00010803832226644697 * d) + (l1_1 * off1) + (l2_1 * off2);
s4 = (0.9857608243445873 * x2) + (0.11206871748434033 * x3);
x2_on = s4 + (0.030892799233141147 * d) + (l1_2 * off1) + (l2_2 * off2);
s5 = ((-0.11206871748434033) * x2) + (0.5412215783233707 * x3);
x3_on = s5 + (0.3745921515889058 * d) + (l1_3 * off1) + (l2_3 * off2);
d_on = d + (l1_4 * off1) + (l2_4 * off2);
left = self.samples - elapsed;
m0 = pick(double(left) < 6.0, 6.0, double(left));

% The exact law in samples.
s6 = ((-106850.90292251826) * x1) + (1124.1848178645955 * x2);
z1 = s6 - (61.894579201640425 * x3);
z2 = ((-642.8726851005619) * x2) + (53.018026963569255 * x3);
z3 = (0.8030787004640786 * x2) - (24.09236101392236 * x3);
s7 = (0.29872942459099683 * x2) + (1.238117262270095 * x3);
v = ((((((z1 / (m0 + 2.0)) + z2) / (m0 + 1.0)) + z3) / m0) + s7) - d;
if ~(isfinite(v) && isfinite(x1_on) && isfinite(x2_on) && isfinite(x3_on) && isfinite(d_on))
    status = int32(-3);
    return;
end
if self.u_max < v
    u_now = self.u_max;
elseif v < -self.u_max
    u_now = -self.u_max;
else
    u_now = v;
end
self.u1 = u_now;
self.x1_hat = x1;
self.x1_next = x1_on;
self.x2_hat = x2;
self.x2_next = x2_on;
self.x3_hat = x3;
self.x3_next = x3_on;
self.d_hat = d;
self.d_next = d_on;
self.seen = uint32(1);
if (self.u_max < v) || (v < -self.u_max)
    u = u_now;
    status = int32(2);
elseif double(left) <= 6.0
    u = u_now;
    status = int32(1);
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
