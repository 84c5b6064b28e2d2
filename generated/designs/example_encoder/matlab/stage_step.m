function [u, status, self] = stage_step(self, k, y) %#codegen
%STAGE_STEP u from tick `k`, which may wrap, and what is measured, y = (x1, ...). Call it once for
%each tick.
%
%   [u, status, self] = stage_step(self, k, y), with self from stage_init. Keep self: it is what the
%   next call needs.
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
phi1_3 = 3.3333333333333335e-7; % 1/3000000, prediction of x1 from d
gamma1 = 3.3333333333333335e-7; % 1/3000000, prediction from u
phi2_3 = 0.0006666666666666666; % 1/1500, prediction of x2 from d
gamma2 = 0.0006666666666666666; % 1/1500, prediction from u
observer_samples = uint32(200); % samples of the round of the observer
hold_o = 30.0; % samples to go at which the observer is held
q1_1 = 120.0; % weight in the observer's gain l1
q1_2 = -60.0; % weight in the observer's gain l1
q1_3 = 12.0; % weight in the observer's gain l1
q2_1 = -108000.0; % weight in the observer's gain l2
q2_2 = 36000.0; % weight in the observer's gain l2
q3_1 = 36000000.0; % weight in the observer's gain l3
samples = uint32(800); % samples from the start to rest
hold = 20.0; % samples to go at which the gains are held
end_samples = 250.0; % samples to go at which the law of the end takes over
w1_1 = -9000000.0; % weight of x1 in the law
w1_2 = -4500.0; % weight of x2 in the law
w2_2 = -6000.0; % weight of x2 in the law
w2_3 = -4.0; % weight of u1 in the law
end1_1 = -18000000.0; % weight of x1 in the law
end1_2 = -9000.0; % weight of x2 in the law
end2_2 = -9000.0; % weight of x2 in the law
end2_3 = -6.0; % weight of u1 in the law
u_max = 6.0; % bound of |u|
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
o0 = pick(double(left_o) < hold_o, hold_o, double(left_o));
o0f2 = o0 * (o0 - 1.0);
r0 = 1.0 / (o0f2 * (o0 - 2.0));
l1 = (q1_1 + (q1_2 * o0) + (q1_3 * o0f2)) * r0;
l2 = (q2_1 + (q2_2 * o0)) * r0;
l3 = q3_1 * r0;
x1 = base + (l1 * miss);
x2 = p2 + (l2 * miss);
d = p3 + (l3 * miss);
left = samples - elapsed;
s4 = double(left) - 1.0;
m0 = pick(s4 < hold, hold, s4);
if m0 > end_samples
    % The exact law in samples.
    z1 = (w1_1 * x1) + (w1_2 * x2);
    z2 = (w2_2 * x2) + (w2_3 * (self.u1 + d));
    m0f1 = m0 + 1.0;
    v = ((z1 + (z2 * m0f1)) / (m0f1 * m0)) - d;
else
    % The law of least energy to the end.
    m1 = pick(m0 < 2.0, 2.0, m0);
    y1 = (end1_1 * x1) + (end1_2 * x2);
    y2 = (end2_2 * x2) + (end2_3 * (self.u1 + d));
    m1f1 = m1 + 2.0;
    v = ((y1 + (y2 * m1f1)) / (m1f1 * (m1 + 1.0))) - d;
end
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
elseif double(left) - 1.0 <= hold
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
