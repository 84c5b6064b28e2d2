function [u, status, self] = stage3_step(self, k, y) %#codegen
%STAGE3_STEP u from tick `k`, which may wrap, and what is measured, y = (x1, ...). Call it once for
%each tick.
%
%   [u, status, self] = stage3_step(self, k, y), with self from stage3_init. Keep self: it is what
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
left_o = uint32(20) - elapsed;
o0 = double(left_o);
if 8.0 < o0
    r0 = 1.0 / o0;
    r1 = 1.0 / (o0 - 1.0);
    r2 = 1.0 / (o0 - 2.0);
    l1 = ((((120.0 * r0) - 60.0) * r1) + 12.0) * r2;
    l2 = (((-108000.0) * r0) + 36000.0) * r1 * r2;
    l3 = 24000000.0 * r0 * r1 * r2;
elseif left_o == uint32(8)
    l1 = 1.0;
    l2 = 428.57142857142856;
    l3 = 142857.14285714287;
elseif left_o == uint32(7)
    l1 = 1.0;
    l2 = 857.1428571428571;
    l3 = -285714.28571428574;
else
    l1 = 1.0;
    l2 = 1500.0;
    l3 = 1000000.0;
end
x1 = base + (l1 * miss);
x2 = p2 + (l2 * miss);
d = p3 + (l3 * miss);

% The exact law in samples.
m0 = pick(elapsed < uint32(37), double(uint32(mod(double(uint32(43)) - double(elapsed), 4294967296))), 6.0);
z1 = ((-120000000.0) * x1) + (60000.0 * x2);
z2 = (-60000.0) * x2;
z3 = (-12.0) * (self.u1 + d);
s2 = ((((z1 / m0) + z2) / (m0 - 1.0)) + z3) / (m0 - 2.0);
v = (s2 + (self.u1 + d)) - d;
if ~isfinite(v)
    status = int32(-3);
    return;
end
if self.u_max < v
    u_now = self.u_max;
elseif v < -self.u_max
    u_now = -self.u_max;
else
    u_now = v;
end
self.u2 = self.u1;
self.u1 = u_now;
self.x1_hat = x1;
self.x2_hat = x2;
self.d_hat = d;
self.seen = uint32(1);
if (self.u_max < v) || (v < -self.u_max)
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
