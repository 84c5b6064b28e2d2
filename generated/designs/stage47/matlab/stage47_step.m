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

gamma1 = 0.00010803832226644697; % prediction from u
gamma2 = 0.030892799233141147; % prediction from u
gamma3 = 0.3745921515889058; % prediction from u
observer_samples = uint32(20); % samples of the round of the observer
q1_1_1 = -8.0; % weight in the observer's gain l1_1
q1_1_2 = 8.0; % weight in the observer's gain l1_1
q1_2_1 = 1207.0156938434693; % weight in the observer's gain l1_2
q1_2_2 = -4.007471679722458; % weight in the observer's gain l1_2
q1_4_1 = 359.9103398433305; % weight in the observer's gain l1_4
q2_2_1 = -1.8587963031465917; % weight in the observer's gain l2_2
q2_2_2 = 0.9913796378212842; % weight in the observer's gain l2_2
q2_3_1 = -12.0; % weight in the observer's gain l2_3
q2_3_2 = 12.0; % weight in the observer's gain l2_3
q2_4_1 = 79.82759275642569; % weight in the observer's gain l2_4
e0_1_1 = 0.9950193780571475; % gain of the observer at its end
e0_1_2 = -0.49380107331759976; % gain of the observer at its end
e0_1_3 = 0.056139026437663865; % gain of the observer at its end
e0_2_1 = 0.0014392695129337434; % gain of the observer at its end
e0_2_2 = 0.220357858722901; % gain of the observer at its end
e0_2_3 = 1.0319630246108107; % gain of the observer at its end
e0_2_4 = 1.3304598792737614; % gain of the observer at its end
e1_1_1 = 1.9950193780571475; % gain of the observer at its end
e1_1_2 = 99.25595014702932; % gain of the observer at its end
e1_1_3 = 0.056139026437663865; % gain of the observer at its end
e1_1_4 = 29.992528320277543; % gain of the observer at its end
e1_2_1 = 0.0014392695129337434; % gain of the observer at its end
e1_2_2 = 0.24720839921003274; % gain of the observer at its end
e1_2_3 = 1.5319630246108107; % gain of the observer at its end
e1_2_4 = 2.660919758547523; % gain of the observer at its end
phi1_2 = 0.009942671770940647; % prediction of x1 from x2
phi1_3 = 0.000617855984662823; % prediction of x1 from x3
phi1_4 = 0.00010803832226644697; % prediction of x1 from d
phi2_2 = 0.9857608243445873; % prediction of x2 from x2
phi2_3 = 0.11206871748434033; % prediction of x2 from x3
phi2_4 = 0.030892799233141147; % prediction of x2 from d
phi3_2 = -0.11206871748434033; % prediction of x3 from x2
phi3_3 = 0.5412215783233707; % prediction of x3 from x3
phi3_4 = 0.3745921515889058; % prediction of x3 from d
hold = 6.0; % samples to go at which the gains are held
w1_1 = -106850.90292251826; % weight of x1 in the law
w1_2 = 1124.1848178645955; % weight of x2 in the law
w1_3 = -61.894579201640425; % weight of x3 in the law
w2_2 = -642.8726851005619; % weight of x2 in the law
w2_3 = 53.018026963569255; % weight of x3 in the law
w3_2 = 0.8030787004640786; % weight of x2 in the law
w3_3 = -24.09236101392236; % weight of x3 in the law
c_2 = 0.29872942459099683; % weight of x2 in the law
c_3 = 1.238117262270095; % weight of x3 in the law
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
    x1 = self.x1_next + (gamma1 * self.u1);
    x2 = self.x2_next + (gamma2 * self.u1);
    x3 = self.x3_next + (gamma3 * self.u1);
    d = self.d_next;
end

% Prediction of the next sample.
miss1 = y(1) - x1;
miss2 = y(2) - x3;
off1 = miss1;
off2 = miss2;
left_o = observer_samples - elapsed;
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
elseif o0 > 8.0
    r0 = 1.0 / (o0 * (o0 - 1.0));
    s1 = (q1_1_1 + (q1_1_2 * o0)) * r0;
    l1_1 = s1 - 0.004980621942852573;
    s2 = (q1_2_1 + (q1_2_2 * o0)) * r0;
    l1_2 = s2 + 0.007132886647707467;
    l1_3 = 0.056139026437663865;
    l1_4 = q1_4_1 * r0;
    l2_1 = 0.0014392695129337434;
    s3 = (q2_2_1 + (q2_2_2 * o0)) * r0;
    l2_2 = s3 + 0.11089234841732894;
    s4 = (q2_3_1 + (q2_3_2 * o0)) * r0;
    l2_3 = s4 - 0.4680369753891894;
    l2_4 = q2_4_1 * r0;
elseif left_o == uint32(8)
    l1_1 = e0_1_1;
    l1_2 = e0_1_2;
    l1_3 = e0_1_3;
    l1_4 = 0.0;
    l2_1 = e0_2_1;
    l2_2 = e0_2_2;
    l2_3 = e0_2_3;
    l2_4 = e0_2_4;
else
    l1_1 = e1_1_1;
    l1_2 = e1_1_2;
    l1_3 = e1_1_3;
    l1_4 = e1_1_4;
    l2_1 = e1_2_1;
    l2_2 = e1_2_2;
    l2_3 = e1_2_3;
    l2_4 = e1_2_4;
end
s5 = x1 + (phi1_2 * x2) + (phi1_3 * x3);
x1_on = s5 + (phi1_4 * d) + (l1_1 * off1) + (l2_1 * off2);
s6 = (phi2_2 * x2) + (phi2_3 * x3);
x2_on = s6 + (phi2_4 * d) + (l1_2 * off1) + (l2_2 * off2);
s7 = (phi3_2 * x2) + (phi3_3 * x3);
x3_on = s7 + (phi3_4 * d) + (l1_3 * off1) + (l2_3 * off2);
d_on = d + (l1_4 * off1) + (l2_4 * off2);
left = self.samples - elapsed;
m0 = pick(double(left) < hold, hold, double(left));

% The exact law in samples.
z1 = (w1_1 * x1) + (w1_2 * x2) + (w1_3 * x3);
z2 = (w2_2 * x2) + (w2_3 * x3);
z3 = (w3_2 * x2) + (w3_3 * x3);
m0f1 = m0 + 2.0;
m0f2 = m0f1 * (m0 + 1.0);
s8 = (z1 + (z2 * m0f1) + (z3 * m0f2)) / (m0f2 * m0);
v = (s8 + ((c_2 * x2) + (c_3 * x3))) - d;
if ~(isfinite(v) && isfinite(x1_on) && isfinite(x2_on) && isfinite(x3_on) && isfinite(d_on))
    status = int32(-3);
    return;
end
if v > self.u_max
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
if (v > self.u_max) || (v < -self.u_max)
    u = u_now;
    status = int32(2);
elseif double(left) <= hold
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
