function [u, status, self] = stage46_step(self, k, y) %#codegen
%STAGE46_STEP u from tick `k`, which may wrap, and what is measured, y = (x1, ...). Call it once for
%each tick.
%
%   [u, status, self] = stage46_step(self, k, y), with self from stage46_init. Keep self: it is what
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
phi1_3 = 5e-7; % 1/2000000, prediction of x1 from d
gamma1 = 5e-7; % 1/2000000, prediction from u
phi2_3 = 0.001; % 1/1000, prediction of x2 from d
gamma2 = 0.001; % 1/1000, prediction from u
w1_1 = -6000000.0; % weight of x1 in the law
w1_2 = -3000.0; % weight of x2 in the law
w2_2 = -4000.0; % weight of x2 in the law
w2_3 = -4.0; % weight of u1 in the law
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
l1 = 0.6159148679121326;
l2 = 289.1861751977763;
l3 = 67889.77526148109;
x1 = base + (l1 * miss);
x2 = p2 + (l2 * miss);
d = p3 + (l3 * miss);

% The exact law in samples.
m0 = pick(elapsed < uint32(37), double(uint32(mod(double(uint32(40)) - double(elapsed), 4294967296))), 3.0);
z1 = (w1_1 * x1) + (w1_2 * x2);
z2 = (w2_2 * x2) + (w2_3 * (self.u1 + d));
v = ((z1 + (z2 * m0)) / (m0 * (m0 - 1.0))) - d;
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
