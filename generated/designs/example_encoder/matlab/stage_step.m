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
s1 = self.x1_hat + (0.001 * self.x2_hat);
s2 = s1 + (3.3333333333333335e-7 * self.d_hat);
p1 = s2 + (3.3333333333333335e-7 * self.u2);
s3 = self.x2_hat + (0.0006666666666666666 * self.d_hat);
p2 = s3 + (0.0006666666666666666 * self.u2);
p3 = self.d_hat;

% Correct by what is measured.
if self.seen == uint32(0)
    base = y(1);
    miss = 0.0;
else
    base = p1;
    miss = y(1) - p1;
end
left_o = uint32(200) - elapsed;
o0 = pick(double(left_o) < 30.0, 30.0, double(left_o));
r0 = 1.0 / o0;
r1 = 1.0 / (o0 - 1.0);
r2 = 1.0 / (o0 - 2.0);
l1 = ((((120.0 * r0) - 60.0) * r1) + 12.0) * r2;
l2 = (((-108000.0) * r0) + 36000.0) * r1 * r2;
l3 = 36000000.0 * r0 * r1 * r2;
x1 = base + (l1 * miss);
x2 = p2 + (l2 * miss);
d = p3 + (l3 * miss);
left = uint32(800) - elapsed;
s4 = double(left) - 1.0;
m0 = pick(s4 < 20.0, 20.0, s4);
if 250.0 < m0
    % The exact law in samples.
    z1 = ((-9000000.0) * x1) - (4500.0 * x2);
    z2 = ((-6000.0) * x2) - (4.0 * (self.u1 + d));
    v = (((z1 / (m0 + 1.0)) + z2) / m0) - d;
else
    % The law of least energy to the end.
    m1 = pick(m0 < 2.0, 2.0, m0);
    y1 = ((-18000000.0) * x1) - (9000.0 * x2);
    y2 = ((-9000.0) * x2) - (6.0 * (self.u1 + d));
    v = (((y1 / (m1 + 2.0)) + y2) / (m1 + 1.0)) - d;
end
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
elseif double(left) - 1.0 <= 20.0
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
