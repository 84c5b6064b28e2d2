function [u, status, self] = stage6_step(self, k, y) %#codegen
%STAGE6_STEP u from tick `k`, which may wrap, and what is measured, y = (x1, ...). Call it once for
%each tick.
%
%   [u, status, self] = stage6_step(self, k, y), with self from stage6_init. Keep self: it is what
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
if ~(isfinite(y(1)) && isfinite(y(2)))
    status = int32(-2);
    return;
end
elapsed = uint32(mod(double(k) - double(self.start), 4294967296));

% Predict.
s1 = self.x2_hat + (0.002 * self.x3_hat);
p1 = s1 + (4e-6 * (self.u1 + 0.25));
p2 = self.x3_hat + (0.004 * (self.u1 + 0.25));

% Correct by what is measured.
if self.seen == uint32(0)
    base = y(2);
    miss = 0.0;
else
    base = p1;
    miss = y(2) - p1;
end
left_o = bitshift(self.samples, -1) - elapsed;
o0 = double(left_o);
if 9.0 < o0
    r0 = 1.0 / o0;
    r1 = 1.0 / (o0 - 1.0);
    l1 = (((-43.265306122448976) * r0) + 12.285714285714286) * r1;
    l2 = 15489.795918367347 * r0 * r1;
elseif left_o == uint32(9)
    l1 = 1.0;
    l2 = 182.53968253968253;
else
    l1 = 1.0;
    l2 = 500.0;
end
x1 = y(1);
x2 = base + (l1 * miss);
x3 = p2 + (l2 * miss);
left = self.samples - elapsed;
m0 = double(left);
if self.deadbeat < m0
    % The exact law in samples.
    z1 = (self.w1_1 * x1) + (self.w1_2 * x2) + (self.w1_3 * x3);
    z2 = (self.w2_2 * x2) + (self.w2_3 * x3);
    z3 = self.w3_3 * x3;
    v = (((((z1 / m0) + z2) / (m0 - 1.0)) + z3) / (m0 - 2.0)) - 0.25;
else
    % Deadbeat.
    s2 = (((-62500000.0) * x1) - (250000.0 * x2)) - (458.3333333333333 * x3);
    v = s2 - 0.25;
end
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
self.u1 = u_now;
self.x2_hat = x2;
self.x3_hat = x3;
self.seen = uint32(1);
if (self.u_max < v) || (v < -self.u_max)
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
