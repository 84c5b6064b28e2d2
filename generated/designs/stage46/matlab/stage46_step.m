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
s1 = self.x1_hat + (0.001 * self.x2_hat) + (5e-7 * self.d_hat);
p1 = s1 + (5e-7 * self.u2);
p2 = self.x2_hat + (0.001 * self.d_hat) + (0.001 * self.u2);
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
z1 = ((-6000000.0) * x1) - (3000.0 * x2);
z2 = ((-4000.0) * x2) - (4.0 * (self.u1 + d));
v = (((z1 / m0) + z2) / (m0 - 1.0)) - d;
if ~isfinite(v)
    status = int32(-3);
    return;
end
if 6.0 < v
    u_now = 6.0;
elseif v < -6.0
    u_now = -6.0;
else
    u_now = v;
end
self.u2 = self.u1;
self.u1 = u_now;
self.x1_hat = x1;
self.x2_hat = x2;
self.d_hat = d;
self.seen = uint32(1);
if (6.0 < v) || (v < -6.0)
    u = u_now;
    status = int32(2);
elseif elapsed < uint32(40)
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
