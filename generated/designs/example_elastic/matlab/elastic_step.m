function [u, status, self] = elastic_step(self, k, y) %#codegen
%ELASTIC_STEP u from tick `k`, which may wrap, and what is measured, y = (x1, ...). Call it once for
%each tick.
%
%   [u, status, self] = elastic_step(self, k, y), with self from elastic_init. Keep self: it is what
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

phi1_2 = 0.0005; % 1/2000, prediction of x1 from x2
phi1_3 = 3.571428571428571e-8; % 1/28000000, prediction of x1 from d
gamma1 = 3.571428571428571e-8; % 1/28000000, prediction from u
phi2_3 = 0.00014285714285714287; % 1/7000, prediction of x2 from d
gamma2 = 0.00014285714285714287; % 1/7000, prediction from u
observer_samples = uint32(200); % samples of the round of the observer
q1_1 = 210.0; % weight in the observer's gain l1
q1_2 = -90.0; % weight in the observer's gain l1
q1_3 = 15.0; % weight in the observer's gain l1
q2_1 = -420000.0; % weight in the observer's gain l2
q2_2 = 120000.0; % weight in the observer's gain l2
q3_1 = 840000000.0; % weight in the observer's gain l3
e0_2 = 1166.6666666666667; % 3500/3, gain of the observer at its end
e0_3 = 2333333.3333333335; % 7000000/3, gain of the observer at its end
e1_2 = 1875.0; % gain of the observer at its end
e1_3 = -1750000.0; % gain of the observer at its end
e2_2 = 3000.0; % gain of the observer at its end
e2_3 = 14000000.0; % gain of the observer at its end
samples = uint32(1000); % samples from the start to rest
hold = 193.0; % samples to go at which the gains are held
w1_1 = -1260000000.0; % weight of x1 in the law
w1_2 = 315000.0; % weight of x2 in the law
w2_2 = -336000.0; % weight of x2 in the law
w3_3 = -10.5; % -21/2, weight of u1 in the law
u_max = 100.0; % bound of |u|
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
p1 = s2 + (gamma1 * self.u2);
s3 = self.x2_hat + (phi2_3 * self.d_hat);
p2 = s3 + (gamma2 * self.u2);
p3 = self.d_hat;

% Correct by what is measured.
if self.seen == uint32(0)
    base = y(1);
    miss = 0.0;
else
    base = p1;
    miss = y(1) - p1;
end
left_o = observer_samples - elapsed;
o0 = pick(left_o == uint32(0), 25.0, double(left_o));
if o0 > 9.0
    o0f2 = o0 * (o0 - 1.0);
    r0 = 1.0 / (o0f2 * (o0 - 2.0));
    l1 = (q1_1 + (q1_2 * o0) + (q1_3 * o0f2)) * r0;
    l2 = (q2_1 + (q2_2 * o0)) * r0;
    l3 = q3_1 * r0;
elseif left_o == uint32(9)
    l1 = 1.0;
    l2 = e0_2;
    l3 = e0_3;
elseif left_o == uint32(8)
    l1 = 1.0;
    l2 = e1_2;
    l3 = e1_3;
else
    l1 = 1.0;
    l2 = e2_2;
    l3 = e2_3;
end
x1 = base + (l1 * miss);
x2 = p2 + (l2 * miss);
d = p3 + (l3 * miss);
left = samples - elapsed;
m0 = pick(double(left) < hold, hold, double(left));

% The exact law in samples.
z1 = (w1_1 * x1) + (w1_2 * x2);
z2 = w2_2 * x2;
z3 = w3_3 * (self.u1 + d);
m0f2 = m0 * (m0 - 1.0);
s4 = (z1 + (z2 * m0) + (z3 * m0f2)) / (m0f2 * (m0 - 2.0));
v = (s4 + (self.u1 + d)) - d;
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
self.u2 = self.u1;
self.u1 = u_now;
self.x1_hat = x1;
self.x2_hat = x2;
self.d_hat = d;
self.seen = uint32(1);
if (v > u_max) || (v < -u_max)
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
