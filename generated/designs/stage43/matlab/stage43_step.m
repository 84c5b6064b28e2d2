function [u, status, self] = stage43_step(self, k, y) %#codegen
%STAGE43_STEP u from tick `k`, which may wrap, and what is measured, y = (x1, ...). Call it once for
%each tick.
%
%   [u, status, self] = stage43_step(self, k, y), with self from stage43_init. Keep self: it is what
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

phi1_2 = 0.01; % 1/100, prediction of x1 from x2
phi1_3 = 5e-5; % 1/20000, prediction of x1 from x3
gamma1 = 1.640625e-7; % 21/128000000, prediction from u
late_gamma1 = 2.604166666666667e-9; % 1/384000000, prediction from u
phi1_4 = 1.6666666666666668e-7; % 1/6000000, prediction of x1 from d
phi2_3 = 0.01; % 1/100, prediction of x2 from x3
gamma2 = 4.6875e-5; % 3/64000, prediction from u
late_gamma2 = 3.125e-6; % 1/320000, prediction from u
phi2_4 = 5e-5; % 1/20000, prediction of x2 from d
gamma3 = 0.0075; % 3/400, prediction from u
late_gamma3 = 0.0025; % 1/400, prediction from u
phi3_4 = 0.01; % 1/100, prediction of x3 from d
observer_samples = uint32(20); % samples of the round of the observer
q1_1 = -840.0; % weight in the observer's gain l1
q1_2 = 480.0; % weight in the observer's gain l1
q1_3 = -120.0; % weight in the observer's gain l1
q1_4 = 16.0; % weight in the observer's gain l1
q2_1 = 90800.0; % weight in the observer's gain l2
q2_2 = -43200.0; % weight in the observer's gain l2
q2_3 = 7200.0; % weight in the observer's gain l2
q3_1 = -3360000.0; % weight in the observer's gain l3
q3_2 = 960000.0; % weight in the observer's gain l3
q4_1 = 24000000.0; % weight in the observer's gain l4
e0_2 = 47.77777777777778; % 430/9, gain of the observer at its end
e0_3 = 2666.6666666666665; % 8000/3, gain of the observer at its end
e0_4 = -66666.66666666667; % -200000/3, gain of the observer at its end
e1_2 = 81.48148148148148; % 2200/27, gain of the observer at its end
e1_3 = -2222.222222222222; % -20000/9, gain of the observer at its end
e1_4 = 444444.44444444444; % 4000000/9, gain of the observer at its end
e2_2 = 116.66666666666667; % 350/3, gain of the observer at its end
e2_4 = -1000000.0; % gain of the observer at its end
e3_2 = 183.33333333333334; % 550/3, gain of the observer at its end
e3_3 = 20000.0; % gain of the observer at its end
e3_4 = 1000000.0; % gain of the observer at its end
h = 0.01; % 1/100, sample period
w1_1 = -120000000.0; % weight of x1 in the law
w1_2 = -2100000.0; % weight of x2 in the law
w1_3 = -16375.0; % weight of x3 in the law
w1_6 = -72.1875; % -1155/16, weight of u3 in the law
w2_2 = -600000.0; % weight of x2 in the law
w2_3 = -13500.0; % weight of x3 in the law
w2_5 = -60.0; % weight of u2 in the law
w2_6 = -84.375; % -675/8, weight of u3 in the law
w3_3 = -1200.0; % weight of x3 in the law
w3_4 = -12.0; % weight of u1 in the law
w3_5 = -12.0; % weight of u2 in the law
w3_6 = -9.0; % weight of u3 in the law
u_max = 6.0; % bound of |u|
samples = uint32(40); % samples from the start to rest
u = 0.0;
k = double(k);
if ~(isfinite(k) && (k == floor(k)))
    status = int32(-2);
    return;
end
k = uint32(mod(k, 4294967296));
y = double(y);
if ~isfinite(y(1))
    status = int32(-2);
    return;
end
elapsed = uint32(mod(double(k) - double(self.start), 4294967296));

% Predict.
s1 = self.x1_hat + (phi1_2 * self.x2_hat);
s2 = s1 + (phi1_3 * self.x3_hat);
s3 = (gamma1 * self.u4) + (late_gamma1 * self.u3);
p1 = s2 + (phi1_4 * self.d_hat) + s3;
s4 = self.x2_hat + (phi2_3 * self.x3_hat);
s5 = (gamma2 * self.u4) + (late_gamma2 * self.u3);
p2 = s4 + (phi2_4 * self.d_hat) + s5;
s6 = (gamma3 * self.u4) + (late_gamma3 * self.u3);
p3 = self.x3_hat + (phi3_4 * self.d_hat) + s6;
p4 = self.d_hat;

% Correct by what is measured.
if self.seen == uint32(0)
    base = y(1);
    miss = 0.0;
else
    base = p1;
    miss = y(1) - p1;
end
left_o = observer_samples - elapsed;
o0 = double(left_o);
if o0 > 10.0
    o0f2 = o0 * (o0 - 1.0);
    o0f3 = o0f2 * (o0 - 2.0);
    r0 = 1.0 / (o0f3 * (o0 - 3.0));
    s7 = q1_1 + (q1_2 * o0) + (q1_3 * o0f2);
    l1 = (s7 + (q1_4 * o0f3)) * r0;
    l2 = (q2_1 + (q2_2 * o0) + (q2_3 * o0f2)) * r0;
    l3 = (q3_1 + (q3_2 * o0)) * r0;
    l4 = q4_1 * r0;
elseif left_o == uint32(10)
    l1 = 1.0;
    l2 = e0_2;
    l3 = e0_3;
    l4 = e0_4;
elseif left_o == uint32(9)
    l1 = 1.0;
    l2 = e1_2;
    l3 = e1_3;
    l4 = e1_4;
elseif left_o == uint32(8)
    l1 = 1.0;
    l2 = e2_2;
    l3 = 0.0;
    l4 = e2_4;
else
    l1 = 1.0;
    l2 = e3_2;
    l3 = e3_3;
    l4 = e3_4;
end
x1 = base + (l1 * miss);
x2 = p2 + (l2 * miss);
x3 = p3 + (l3 * miss);
d = p4 + (l4 * miss);

% The tracking error.
t = double(elapsed) * h;
reference1 = t;
reference0 = reference1 * reference1 * 0.5;
e1 = x1 - reference0;
e2 = x2 - reference1;
e3 = x3 - 1.0;

% The exact law in samples.
m0 = pick(elapsed < uint32(34), double(uint32(mod(double(uint32(40)) - double(elapsed), 4294967296))), 6.0);
s8 = (w1_1 * e1) + (w1_2 * e2) + (w1_3 * e3);
z1 = s8 + (w1_6 * (self.u3 + d));
s9 = (w2_2 * e2) + (w2_3 * e3);
s10 = s9 + (w2_5 * (self.u2 + d));
z2 = s10 + (w2_6 * (self.u3 + d));
s11 = (w3_3 * e3) + (w3_4 * (self.u1 + d));
s12 = s11 + (w3_5 * (self.u2 + d));
z3 = s12 + (w3_6 * (self.u3 + d));
m0f2 = m0 * (m0 - 1.0);
v = ((z1 + (z2 * m0) + (z3 * m0f2)) / (m0f2 * (m0 - 2.0))) - d;
if ~isfinite(v)
    status = int32(-3);
    return;
end
if v > u_max
    u_now = u_max;
elseif v < -u_max
    u_now = -u_max;
else
    u_now = v;
end
self.u4 = self.u3;
self.u3 = self.u2;
self.u2 = self.u1;
self.u1 = u_now;
self.x1_hat = x1;
self.x2_hat = x2;
self.x3_hat = x3;
self.d_hat = d;
self.seen = uint32(1);
if (v > u_max) || (v < -u_max)
    u = u_now;
    status = int32(2);
elseif elapsed < samples
    u = u_now;
    status = int32(0);
else
    u = u_now;
    status = int32(1);
end
end

function r = pick(condition, yes, no)
if condition
    r = yes;
else
    r = no;
end
end
