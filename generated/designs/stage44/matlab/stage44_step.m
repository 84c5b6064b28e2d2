function [u, status, self] = stage44_step(self, k, y) %#codegen
%STAGE44_STEP u from tick `k`, which may wrap, and what is measured, y = C x. Call it once for each
%tick.
%
%   [u, status, self] = stage44_step(self, k, y), with self from stage44_init. Keep self: it is what
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

gamma1 = 9.353143640028875e-5; % prediction from u
late_gamma1 = 1.4506885866158227e-5; % prediction from u
gamma2 = 0.02240015856569381; % prediction from u
late_gamma2 = 0.008492640667447336; % prediction from u
gamma3 = 0.15880933131841984; % prediction from u
late_gamma3 = 0.21578282027048595; % prediction from u
q1_1 = 24.0; % weight in the observer's gain l1
q1_2 = -24.0; % weight in the observer's gain l1
q1_3 = 12.0; % weight in the observer's gain l1
q2_1 = -12889.952685745366; % weight in the observer's gain l2
q2_2 = 6304.212917508586; % weight in the observer's gain l2
q2_3 = -742.8703573620571; % weight in the observer's gain l2
q3_1 = 72521.99132748511; % weight in the observer's gain l3
q3_2 = -24808.851670034343; % weight in the observer's gain l3
q3_3 = 2767.4814294482285; % weight in the observer's gain l3
e0_1 = 1.026982402667958; % gain of the observer at its end
e0_2 = 9.393065010983802; % gain of the observer at its end
e0_3 = 72.1724949708503; % gain of the observer at its end
e1_1 = 1.2412681169536723; % gain of the observer at its end
e1_2 = -0.9955098611216602; % gain of the observer at its end
e1_3 = -271.5264302640074; % gain of the observer at its end
e2_1 = 2.526982402667958; % gain of the observer at its end
e2_2 = 168.91277532831796; % gain of the observer at its end
e2_3 = 171.81438886235838; % gain of the observer at its end
phi1_2 = 0.009942671770940647; % prediction of x1 from x2
phi1_3 = 0.000617855984662823; % prediction of x1 from x3
phi2_2 = 0.9857608243445873; % prediction of x2 from x2
phi2_3 = 0.11206871748434033; % prediction of x2 from x3
phi3_2 = -0.11206871748434033; % prediction of x3 from x2
phi3_3 = 0.5412215783233707; % prediction of x3 from x3
hold = 6.0; % samples to go at which the gains are held
w1_1 = -106850.90292251826; % weight of x1 in the law
w1_2 = -482.3692808208648; % weight of x2 in the law
w1_3 = 4.807633485406011; % weight of x3 in the law
w1_4 = -1.2197801784387233e-74; % weight of u1 in the law
w1_5 = 4.609258112111791; % weight of u2 in the law
w2_2 = -633.6322203514217; % weight of x2 in the law
w2_3 = -73.36956899710586; % weight of x3 in the law
w2_4 = -1.2733281521282373e-76; % weight of u1 in the law
w2_5 = -14.786896717013052; % weight of u2 in the law
w3_2 = 4.311208496599377; % weight of x2 in the law
w3_3 = -9.337493806987991; % weight of x3 in the law
w3_4 = -9.0; % weight of u1 in the law
w3_5 = -2.7645844206856207; % weight of u2 in the law
c_2 = 0.10945032226632541; % weight of x2 in the law
c_3 = 0.5296658086896372; % weight of x3 in the law
c_4 = 0.47301759733204196; % weight of u1 in the law
c_5 = 0.15314166966017376; % weight of u2 in the law
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

% The estimates; at first what y shows.
if self.seen == uint32(0)
    x1 = y(1);
    x2 = 0.0;
    x3 = 0.0;
else
    s1 = (gamma1 * self.u3) + (late_gamma1 * self.u2);
    x1 = self.x1_next + s1;
    s2 = (gamma2 * self.u3) + (late_gamma2 * self.u2);
    x2 = self.x2_next + s2;
    s3 = (gamma3 * self.u3) + (late_gamma3 * self.u2);
    x3 = self.x3_next + s3;
end

% Prediction of the next sample.
miss1 = y(1) - x1;
off1 = miss1;
left_o = bitshift(self.samples, -1) - elapsed;
o0 = double(left_o);
if o0 > 8.0
    o0f2 = o0 * (o0 - 1.0);
    r0 = 1.0 / (o0f2 * (o0 - 2.0));
    s4 = (q1_1 + (q1_2 * o0) + (q1_3 * o0f2)) * r0;
    l1 = s4 - 0.47301759733204196;
    s5 = (q2_1 + (q2_2 * o0) + (q2_3 * o0f2)) * r0;
    l2 = s5 + 26.72716299730578;
    s6 = (q3_1 + (q3_2 * o0) + (q3_3 * o0f2)) * r0;
    l3 = s6 - 98.86735283457841;
elseif left_o == uint32(8)
    l1 = e0_1;
    l2 = e0_2;
    l3 = e0_3;
elseif left_o == uint32(7)
    l1 = e1_1;
    l2 = e1_2;
    l3 = e1_3;
else
    l1 = e2_1;
    l2 = e2_2;
    l3 = e2_3;
end
x1_on = x1 + (phi1_2 * x2) + (phi1_3 * x3) + (l1 * off1);
x2_on = (phi2_2 * x2) + (phi2_3 * x3) + (l2 * off1);
x3_on = (phi3_2 * x2) + (phi3_3 * x3) + (l3 * off1);
left = self.samples - elapsed;
s7 = double(left) - 2.0;
m0 = pick(s7 < hold, hold, s7);

% The exact law in samples.
s8 = (w1_1 * x1) + (w1_2 * x2) + (w1_3 * x3);
z1 = s8 + (w1_4 * self.u1) + (w1_5 * self.u2);
s9 = (w2_2 * x2) + (w2_3 * x3);
z2 = s9 + (w2_4 * self.u1) + (w2_5 * self.u2);
s10 = (w3_2 * x2) + (w3_3 * x3);
z3 = s10 + (w3_4 * self.u1) + (w3_5 * self.u2);
m0f1 = m0 + 2.0;
m0f2 = m0f1 * (m0 + 1.0);
s11 = (c_2 * x2) + (c_3 * x3);
s12 = s11 + (c_4 * self.u1) + (c_5 * self.u2);
v = ((z1 + (z2 * m0f1) + (z3 * m0f2)) / (m0f2 * m0)) + s12;
if ~(isfinite(v) && isfinite(x1_on) && isfinite(x2_on) && isfinite(x3_on))
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
self.u3 = self.u2;
self.u2 = self.u1;
self.u1 = u_now;
self.x1_hat = x1;
self.x1_next = x1_on;
self.x2_hat = x2;
self.x2_next = x2_on;
self.x3_hat = x3;
self.x3_next = x3_on;
self.seen = uint32(1);
if (v > self.u_max) || (v < -self.u_max)
    u = u_now;
    status = int32(2);
elseif double(left) - 2.0 <= hold
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
