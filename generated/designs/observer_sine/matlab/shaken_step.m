function [u, status, self] = shaken_step(self, k, y) %#codegen
%SHAKEN_STEP u from tick `k`, which may wrap, and what is measured, y = (x1, ...). Call it once for
%each tick.
%
%   [u, status, self] = shaken_step(self, k, y), with self from shaken_init. Keep self: it is what
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

phi1_2 = 0.001; % 1/1000, prediction of x1 from x2
phi1_3 = 9.997000359976858e-7; % prediction of x1 from d
gamma1 = 9.375e-7; % 3/3200000, prediction from u
late_gamma1 = 6.25e-8; % 1/16000000, prediction from u
phi1_4 = 3.3327333847593334e-10; % prediction of x1 from d_rate
phi2_3 = 0.001998800215981487; % prediction of x2 from d
gamma2 = 0.0015; % 3/2000, prediction from u
late_gamma2 = 0.0005; % 1/2000, prediction from u
phi2_4 = 9.997000359976858e-7; % prediction of x2 from d_rate
phi3_4 = 0.0009994001079907434; % prediction of d from d_rate
phi3_3 = 0.9982005399352042; % prediction of d from d
phi4_4 = 0.9982005399352042; % prediction of d_rate from d_rate
phi4_3 = -3.597840388766676; % prediction of d_rate from d
observer_samples = uint32(200); % samples of the round of the observer
hold_o = 30.0; % samples to go at which the observer is held
q1_1 = -840.0; % weight in the observer's gain l1
q1_2 = 480.0; % weight in the observer's gain l1
q1_3 = -120.0; % weight in the observer's gain l1
q1_4 = 16.0; % weight in the observer's gain l1
q2_1 = 907032.0947896534; % weight in the observer's gain l2
q2_2 = -431395.04961199313; % weight in the observer's gain l2
q2_3 = 71827.15332755336; % weight in the observer's gain l2
q2_4 = 28.808643111533488; % weight in the observer's gain l2
q3_1 = -166538409.07329616; % weight in the observer's gain l3
q3_2 = 47150402.59237033; % weight in the observer's gain l3
q3_3 = 216000.0; % weight in the observer's gain l3
q3_4 = -28800.0; % weight in the observer's gain l3
q4_1 = 10370942877.471207; % weight in the observer's gain l4
q4_2 = 776511089.3015876; % weight in the observer's gain l4
q4_3 = -129288875.98959604; % weight in the observer's gain l4
q4_4 = -51855.55760076028; % weight in the observer's gain l4
d0_d = 0.990752702693308; % weight of d in d0
d0_d_rate = 0.002242835389486039; % weight of d_rate in d0
d1_d = 0.9970392465203709; % weight of d in d1
d1_d_rate = 0.0012486411387069352; % weight of d_rate in d1
d2_d = 0.9996625341702274; % weight of d in d2
d2_d_rate = 0.0003749367230213299; % weight of d_rate in d2
samples = uint32(600); % samples from the start to rest
hold = 10.0; % samples to go at which the gains are held
w1_1 = -6000000.0; % weight of x1 in the law
w1_2 = -7500.0; % weight of x2 in the law
w1_4 = -7.875; % -63/8, weight of u2 in the law
w2_2 = -3000.0; % weight of x2 in the law
w2_3 = -6.0; % weight of u1 in the law
w2_4 = -4.5; % -9/2, weight of u2 in the law
u_max = 8.0; % bound of |u|
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
s2 = s1 + (phi1_3 * self.d_hat);
s3 = (gamma1 * self.u3) + (late_gamma1 * self.u2);
p1 = s2 + (phi1_4 * self.d_rate_hat) + s3;
s4 = self.x2_hat + (phi2_3 * self.d_hat);
s5 = (gamma2 * self.u3) + (late_gamma2 * self.u2);
p2 = s4 + (phi2_4 * self.d_rate_hat) + s5;
s6 = phi3_4 * self.d_rate_hat;
p3 = (phi3_3 * self.d_hat) + s6;
s7 = phi4_4 * self.d_rate_hat;
p4 = (phi4_3 * self.d_hat) + s7;

% Correct by what is measured.
if self.seen == uint32(0)
    base = y(1);
    miss = 0.0;
else
    base = p1;
    miss = y(1) - p1;
end
left_o = observer_samples - elapsed;
o0 = pick(double(left_o) < hold_o, hold_o, double(left_o));
o0f2 = o0 * (o0 - 1.0);
o0f3 = o0f2 * (o0 - 2.0);
r0 = 1.0 / (o0f3 * (o0 - 3.0));
s8 = q1_1 + (q1_2 * o0) + (q1_3 * o0f2);
l1 = ((s8 + (q1_4 * o0f3)) * r0) - 3.8011523294569497e-121;
s9 = q2_1 + (q2_2 * o0) + (q2_3 * o0f2);
l2 = ((s9 + (q2_4 * o0f3)) * r0) - 3.601080388941686;
s10 = q3_1 + (q3_2 * o0) + (q3_3 * o0f2);
l3 = ((s10 + (q3_4 * o0f3)) * r0) + 1.3694003898462869e-117;
s11 = q4_1 + (q4_2 * o0) + (q4_3 * o0f2);
l4 = ((s11 + (q4_4 * o0f3)) * r0) + 6481.944700095035;
x1 = base + (l1 * miss);
x2 = p2 + (l2 * miss);
d = p3 + (l3 * miss);
d_rate = p4 + (l4 * miss);

% The disturbance while each input acts.
d0 = (d0_d * d) + (d0_d_rate * d_rate);
d1 = (d1_d * d) + (d1_d_rate * d_rate);
d2 = (d2_d * d) + (d2_d_rate * d_rate);
left = samples - elapsed;
s12 = double(left) - 2.0;
m0 = pick(s12 < hold, hold, s12);

% The exact law in samples.
s13 = (w1_1 * x1) + (w1_2 * x2);
z1 = s13 + (w1_4 * (self.u2 + d2));
s14 = (w2_2 * x2) + (w2_3 * (self.u1 + d1));
z2 = s14 + (w2_4 * (self.u2 + d2));
m0f1 = m0 + 2.0;
v = ((z1 + (z2 * m0f1)) / (m0f1 * (m0 + 1.0))) - d0;
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
self.u3 = self.u2;
self.u2 = self.u1;
self.u1 = u_now;
self.x1_hat = x1;
self.x2_hat = x2;
self.d_hat = d;
self.d_rate_hat = d_rate;
self.seen = uint32(1);
if (v > u_max) || (v < -u_max)
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
