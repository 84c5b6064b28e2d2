function [u, status, self] = stage11_step(self, k, y) %#codegen
%STAGE11_STEP u from tick `k`, which may wrap, and what is measured, y = (x1, ...). Call it once for
%each tick.
%
%   [u, status, self] = stage11_step(self, k, y), with self from stage11_init. Keep self: it is what
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

phi1_2 = single(0.009999999776482582); % 1/100, prediction of x1 from x2
phi1_3 = single(4.999999873689376e-5); % 1/20000, prediction of x1 from x3
phi1_4 = single(1.6666666624587378e-7); % 1/6000000, prediction of x1 from x4
phi1_5 = single(4.1666667338624563e-10); % 1/2400000000, prediction of x1 from d
gamma1 = single(4.1666667338624563e-10); % 1/2400000000, prediction from u
phi2_3 = single(0.009999999776482582); % 1/100, prediction of x2 from x3
phi2_4 = single(4.999999873689376e-5); % 1/20000, prediction of x2 from x4
phi2_5 = single(1.6666666624587378e-7); % 1/6000000, prediction of x2 from d
gamma2 = single(1.6666666624587378e-7); % 1/6000000, prediction from u
phi3_4 = single(0.009999999776482582); % 1/100, prediction of x3 from x4
phi3_5 = single(4.999999873689376e-5); % 1/20000, prediction of x3 from d
gamma3 = single(4.999999873689376e-5); % 1/20000, prediction from u
phi4_5 = single(0.009999999776482582); % 1/100, prediction of x4 from d
gamma4 = single(0.009999999776482582); % 1/100, prediction from u
q1_1 = single(6720.0); % weight in the observer's gain l1
q1_2 = -single(4200.0); % weight in the observer's gain l1
q1_3 = single(1200.0); % weight in the observer's gain l1
q1_4 = -single(200.0); % weight in the observer's gain l1
q1_5 = single(20.0); % weight in the observer's gain l1
q2_1 = -single(808000.0); % weight in the observer's gain l2
q2_2 = single(454000.0); % weight in the observer's gain l2
q2_3 = -single(108000.0); % weight in the observer's gain l2
q2_4 = single(12000.0); % weight in the observer's gain l2
q3_1 = single(38400000.0); % weight in the observer's gain l3
q3_2 = -single(16800000.0); % weight in the observer's gain l3
q3_3 = single(2400000.0); % weight in the observer's gain l3
q4_1 = -single(480000000.0); % weight in the observer's gain l4
q4_2 = single(120000000.0); % weight in the observer's gain l4
e0_2 = single(50.75757598876953); % 1675/33, gain of the observer at its end
e0_3 = single(3678.451171875); % 1092500/297, gain of the observer at its end
e0_4 = -single(166666.671875); % -500000/3, gain of the observer at its end
e0_5 = single(7070707.0); % 700000000/99, gain of the observer at its end
e1_2 = single(79.29293060302734); % 7850/99, gain of the observer at its end
e1_3 = -single(1414.141357421875); % -140000/99, gain of the observer at its end
e1_4 = single(696969.6875); % 23000000/33, gain of the observer at its end
e1_5 = -single(48484848.0); % -1600000000/33, gain of the observer at its end
e2_2 = single(105.55555725097656); % 950/9, gain of the observer at its end
e2_3 = -single(1111.111083984375); % -10000/9, gain of the observer at its end
e2_4 = -single(333333.34375); % -1000000/3, gain of the observer at its end
e2_5 = single(133333336.0); % 400000000/3, gain of the observer at its end
e3_2 = single(138.88888549804688); % 1250/9, gain of the observer at its end
e3_3 = single(3703.70361328125); % 100000/27, gain of the observer at its end
e3_4 = -single(1666666.625); % -5000000/3, gain of the observer at its end
e3_5 = -single(177777776.0); % -1600000000/9, gain of the observer at its end
e4_2 = single(208.3333282470703); % 625/3, gain of the observer at its end
e4_3 = single(29166.666015625); % 87500/3, gain of the observer at its end
e4_4 = single(2500000.0); % gain of the observer at its end
e4_5 = single(100000000.0); % gain of the observer at its end
b_1 = -single(100000000.0); % weight of x1 in the law
b_2 = -single(2500000.0); % weight of x2 in the law
b_3 = -single(29166.666015625); % -87500/3, weight of x3 in the law
b_4 = -single(208.3333282470703); % -625/3, weight of x4 in the law
u = single(0.0);
k = double(k);
if ~(isfinite(k) && (k == floor(k)))
    status = int32(-2);
    return;
end
k = uint32(mod(k, 4294967296));
y = single(y);
if ~isfinite(y(1))
    status = int32(-2);
    return;
end
elapsed = uint32(mod(double(k) - double(self.start), 4294967296));

% Predict.
s1 = self.x1_hat + (phi1_2 * self.x2_hat);
s2 = s1 + (phi1_3 * self.x3_hat);
s3 = s2 + (phi1_4 * self.x4_hat);
s4 = s3 + (phi1_5 * self.d_hat);
p1 = s4 + (gamma1 * self.u1);
s5 = self.x2_hat + (phi2_3 * self.x3_hat);
s6 = s5 + (phi2_4 * self.x4_hat);
s7 = s6 + (phi2_5 * self.d_hat);
p2 = s7 + (gamma2 * self.u1);
s8 = self.x3_hat + (phi3_4 * self.x4_hat);
s9 = s8 + (phi3_5 * self.d_hat);
p3 = s9 + (gamma3 * self.u1);
s10 = self.x4_hat + (phi4_5 * self.d_hat);
p4 = s10 + (gamma4 * self.u1);
p5 = self.d_hat;

% Correct by what is measured.
if self.seen == uint32(0)
    base = y(1);
    miss = single(0.0);
else
    base = p1;
    miss = y(1) - p1;
end
left_o = bitshift(self.samples, -1) - elapsed;
o0 = single(left_o);
if o0 > single(12.0)
    r0 = single(1.0) / o0;
    r1 = single(1.0) / (o0 - single(1.0));
    r2 = single(1.0) / (o0 - single(2.0));
    r3 = single(1.0) / (o0 - single(3.0));
    r4 = single(1.0) / (o0 - single(4.0));
    s11 = ((((q1_1 * r0) + q1_2) * r1) + q1_3) * r2;
    l1 = (((s11 + q1_4) * r3) + q1_5) * r4;
    s12 = ((((q2_1 * r0) + q2_2) * r1) + q2_3) * r2;
    l2 = (s12 + q2_4) * r3 * r4;
    s13 = ((((q3_1 * r0) + q3_2) * r1) + q3_3) * r2;
    l3 = s13 * r3 * r4;
    l4 = ((q4_1 * r0) + q4_2) * r1 * r2 * r3 * r4;
    l5 = single(0.0);
elseif left_o == uint32(12)
    l1 = single(1.0);
    l2 = e0_2;
    l3 = e0_3;
    l4 = e0_4;
    l5 = e0_5;
elseif left_o == uint32(11)
    l1 = single(1.0);
    l2 = e1_2;
    l3 = e1_3;
    l4 = e1_4;
    l5 = e1_5;
elseif left_o == uint32(10)
    l1 = single(1.0);
    l2 = e2_2;
    l3 = e2_3;
    l4 = e2_4;
    l5 = e2_5;
elseif left_o == uint32(9)
    l1 = single(1.0);
    l2 = e3_2;
    l3 = e3_3;
    l4 = e3_4;
    l5 = e3_5;
else
    l1 = single(1.0);
    l2 = e4_2;
    l3 = e4_3;
    l4 = e4_4;
    l5 = e4_5;
end
x1 = base + (l1 * miss);
x2 = p2 + (l2 * miss);
x3 = p3 + (l3 * miss);
x4 = p4 + (l4 * miss);
d = p5 + (l5 * miss);
left = self.samples - elapsed;
m0 = single(left);
if m0 > self.deadbeat
    % The exact law in samples.
    s14 = (self.w1_1 * x1) + (self.w1_2 * x2) + (self.w1_3 * x3);
    z1 = s14 + (self.w1_4 * x4);
    z2 = (self.w2_2 * x2) + (self.w2_3 * x3) + (self.w2_4 * x4);
    z3 = (self.w3_3 * x3) + (self.w3_4 * x4);
    z4 = self.w4_4 * x4;
    s15 = (((((z1 / m0) + z2) / (m0 - single(1.0))) + z3) / (m0 - single(2.0))) + z4;
    v = (s15 / (m0 - single(3.0))) - d;
else
    % Deadbeat.
    s16 = (b_1 * x1) + (b_2 * x2) + (b_3 * x3);
    v = (s16 + (b_4 * x4)) - d;
end
if ~isfinite(v)
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
self.x2_hat = x2;
self.x3_hat = x3;
self.x4_hat = x4;
self.d_hat = d;
self.seen = uint32(1);
if (v > self.u_max) || (v < -self.u_max)
    u = u_now;
    status = int32(2);
elseif elapsed < self.samples
    u = u_now;
    status = int32(0);
else
    u = u_now;
    status = int32(1);
end
end
