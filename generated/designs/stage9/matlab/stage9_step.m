function [u, status, self] = stage9_step(self, k, y) %#codegen
%STAGE9_STEP u from tick `k`, which may wrap, and what is measured, y = (x1, ...). Call it once for
%each tick.
%
%   [u, status, self] = stage9_step(self, k, y), with self from stage9_init. Keep self: it is what
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

q1_1 = 120.0; % weight in the observer's gain l1
q1_2 = -60.0; % weight in the observer's gain l1
q1_3 = 12.0; % weight in the observer's gain l1
deadbeat = 3.5; % 7/2, samples to go at which deadbeat takes over
b_4 = -3.0; % weight of u1 in the law
u_max = 1000.0; % bound of |u|
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
s1 = self.x1_hat + (self.phi1_2 * self.x2_hat);
p1 = s1 + (self.phi1_3 * self.x3_hat) + (self.gamma1 * self.u2);
s2 = self.x2_hat + (self.phi1_2 * self.x3_hat);
p2 = s2 + (self.phi1_3 * self.u2);
p3 = self.x3_hat + (self.phi1_2 * self.u2);

% Correct by what is measured.
if self.seen == uint32(0)
    base = y(1);
    miss = 0.0;
else
    base = p1;
    miss = y(1) - p1;
end
left_o = bitshift(self.samples, -1) - elapsed;
o0 = pick(double(left_o) < self.hold_o, self.hold_o, double(left_o));
o0f2 = o0 * (o0 - 1.0);
r0 = 1.0 / (o0f2 * (o0 - 2.0));
l1 = (q1_1 + (q1_2 * o0) + (q1_3 * o0f2)) * r0;
l2 = (self.q2_1 + (self.q2_2 * o0)) * r0;
l3 = self.q3_1 * r0;
x1 = base + (l1 * miss);
x2 = p2 + (l2 * miss);
x3 = p3 + (l3 * miss);
left = self.samples - elapsed;
m0 = pick(double(left) < self.hold, self.hold, double(left));
if m0 > deadbeat
    % The exact law in samples.
    z1 = (self.w1_1 * x1) + (self.w1_2 * x2) + (self.w1_3 * x3);
    z2 = (self.w2_2 * x2) + (self.w2_3 * x3);
    z3 = self.w3_3 * x3;
    z4 = self.w4_4 * self.u1;
    m0f2 = m0 * (m0 - 1.0);
    m0f3 = m0f2 * (m0 - 2.0);
    s3 = (z1 + (z2 * m0) + (z3 * m0f2) + (z4 * m0f3)) / (m0f3 * (m0 - 3.0));
    v = s3 + self.u1;
else
    % Deadbeat.
    s4 = (self.b_1 * x1) + (self.b_2 * x2) + (self.b_3 * x3);
    v = s4 + (b_4 * self.u1);
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
self.x3_hat = x3;
self.seen = uint32(1);
if (v > u_max) || (v < -u_max)
    u = u_now;
    status = int32(2);
elseif double(left) <= self.hold
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
