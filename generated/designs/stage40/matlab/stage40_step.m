function [u, status, self] = stage40_step(self, k, y, r) %#codegen
%STAGE40_STEP u from tick `k`, which may wrap, and what is measured, y = (x1, ...), and the
%reference. Call it once for each tick.
%
%   [u, status, self] = stage40_step(self, k, y, r), with self from stage40_init. Keep self: it is
%   what the next call needs.
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
phi1_3 = 5e-7; % 1/2000000, prediction of x1 from d
gamma1 = 5e-7; % 1/2000000, prediction from u
phi2_3 = 0.001; % 1/1000, prediction of x2 from d
gamma2 = 0.001; % 1/1000, prediction from u
observer_samples = uint32(20); % samples of the round of the observer
q1_1 = 120.0; % weight in the observer's gain l1
q1_2 = -60.0; % weight in the observer's gain l1
q1_3 = 12.0; % weight in the observer's gain l1
q2_1 = -108000.0; % weight in the observer's gain l2
q2_2 = 36000.0; % weight in the observer's gain l2
q3_1 = 24000000.0; % weight in the observer's gain l3
e0_2 = 428.57142857142856; % 3000/7, gain of the observer at its end
e0_3 = 142857.14285714287; % 1000000/7, gain of the observer at its end
e1_2 = 857.1428571428571; % 6000/7, gain of the observer at its end
e1_3 = -285714.28571428574; % -2000000/7, gain of the observer at its end
e2_2 = 1500.0; % gain of the observer at its end
e2_3 = 1000000.0; % gain of the observer at its end
w1_1 = -120000000.0; % weight of x1 in the law
w1_2 = 60000.0; % weight of x2 in the law
w2_2 = -60000.0; % weight of x2 in the law
w3_3 = -12.0; % weight of u1 in the law
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
r = double(r);
if ~(isfinite(r(1)) && isfinite(r(2)) && isfinite(r(3)))
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

% Correct by what is measured, where it is believed.
if self.seen == uint32(0)
    base = y(1);
    gap = 0.0;
else
    base = p1;
    gap = y(1) - p1;
end
if isfinite(y(1)) && (abs(y(1)) <= 1.5) && (abs(gap) <= 0.5)
    miss = gap;
    trust = uint32(3);
else
    miss = 0.0;
    trust = self.trust - uint32(1);
end
if ~(trust > uint32(0))
    status = int32(-2);
    return;
end
left_o = observer_samples - elapsed;
o0 = double(left_o);
if o0 > 8.0
    o0f2 = o0 * (o0 - 1.0);
    r0 = 1.0 / (o0f2 * (o0 - 2.0));
    l1 = (q1_1 + (q1_2 * o0) + (q1_3 * o0f2)) * r0;
    l2 = (q2_1 + (q2_2 * o0)) * r0;
    l3 = q3_1 * r0;
elseif left_o == uint32(8)
    l1 = 1.0;
    l2 = e0_2;
    l3 = e0_3;
elseif left_o == uint32(7)
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

% The tracking error.
e1 = x1 - r(1);
e2 = x2 - r(2);

% The exact law in samples.
m0 = pick(elapsed < uint32(37), double(uint32(mod(double(uint32(43)) - double(elapsed), 4294967296))), 6.0);
z1 = (w1_1 * e1) + (w1_2 * e2);
z2 = w2_2 * e2;
z3 = w3_3 * ((self.u1 + d) - self.rho1);
m0f2 = m0 * (m0 - 1.0);
s4 = (z1 + (z2 * m0) + (z3 * m0f2)) / (m0f2 * (m0 - 2.0));
v = ((s4 + ((self.u1 + d) - self.rho1)) - d) + r(3);
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
self.rho1 = r(3);
self.x1_hat = x1;
self.x2_hat = x2;
self.d_hat = d;
self.seen = uint32(1);
self.trust = trust;
if trust < uint32(3)
    u = u_now;
    status = int32(4);
elseif (v > u_max) || (v < -u_max)
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
