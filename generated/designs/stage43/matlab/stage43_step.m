function [u, status, self] = stage43_step(self, k, y) %#codegen
%STAGE43_STEP u from tick `k`, which may wrap, and what is measured, y = (x1, ...). Call it once for
%each tick.
%
%   [u, status, self] = stage43_step(self, k, y), with self from stage43_init. Keep self: it is what
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
s1 = self.x1_hat + (0.01 * self.x2_hat) + (5e-5 * self.x3_hat);
s2 = (1.640625e-7 * self.u4) + (2.604166666666667e-9 * self.u3);
p1 = s1 + (1.6666666666666668e-7 * self.d_hat) + s2;
s3 = self.x2_hat + (0.01 * self.x3_hat) + (5e-5 * self.d_hat);
p2 = s3 + ((4.6875e-5 * self.u4) + (3.125e-6 * self.u3));
s4 = (0.0075 * self.u4) + (0.0025 * self.u3);
p3 = self.x3_hat + (0.01 * self.d_hat) + s4;
p4 = self.d_hat;

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
if 10.0 < o0
    r0 = 1.0 / o0;
    r1 = 1.0 / (o0 - 1.0);
    r2 = 1.0 / (o0 - 2.0);
    r3 = 1.0 / (o0 - 3.0);
    l1 = (((((((-840.0) * r0) + 480.0) * r1) - 120.0) * r2) + 16.0) * r3;
    l2 = ((((90800.0 * r0) - 43200.0) * r1) + 7200.0) * r2 * r3;
    l3 = (((-3360000.0) * r0) + 960000.0) * r1 * r2 * r3;
    l4 = 24000000.0 * r0 * r1 * r2 * r3;
elseif left_o == uint32(10)
    l1 = 1.0;
    l2 = 47.77777777777778;
    l3 = 2666.6666666666665;
    l4 = -66666.66666666667;
elseif left_o == uint32(9)
    l1 = 1.0;
    l2 = 81.48148148148148;
    l3 = -2222.222222222222;
    l4 = 444444.44444444444;
elseif left_o == uint32(8)
    l1 = 1.0;
    l2 = 116.66666666666667;
    l3 = 0.0;
    l4 = -1000000.0;
else
    l1 = 1.0;
    l2 = 183.33333333333334;
    l3 = 20000.0;
    l4 = 1000000.0;
end
x1 = base + (l1 * miss);
x2 = p2 + (l2 * miss);
x3 = p3 + (l3 * miss);
d = p4 + (l4 * miss);

% The tracking error.
t = 0.01 * double(elapsed);
reference1 = t;
reference0 = reference1 * reference1 * 0.5;
e1 = x1 - reference0;
e2 = x2 - reference1;
e3 = x3 - 1.0;

% The exact law in samples.
m0 = pick(elapsed < uint32(34), double(uint32(mod(double(uint32(40)) - double(elapsed), 4294967296))), 6.0);
s5 = (((-120000000.0) * e1) - (2100000.0 * e2)) - (16375.0 * e3);
z1 = s5 - (72.1875 * (self.u3 + d));
s6 = (((-600000.0) * e2) - (13500.0 * e3)) - (60.0 * (self.u2 + d));
z2 = s6 - (84.375 * (self.u3 + d));
s7 = ((-1200.0) * e3) - (12.0 * (self.u1 + d));
z3 = (s7 - (12.0 * (self.u2 + d))) - (9.0 * (self.u3 + d));
v = (((((z1 / m0) + z2) / (m0 - 1.0)) + z3) / (m0 - 2.0)) - d;
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
self.u4 = self.u3;
self.u3 = self.u2;
self.u2 = self.u1;
self.u1 = u_now;
self.x1_hat = x1;
self.x2_hat = x2;
self.x3_hat = x3;
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
