function [u, status, self] = stage5_step(self, k, x) %#codegen
%STAGE5_STEP u from tick `k`, which may wrap, and the state x = (x1, x1', ...). Call it once for
%each tick.
%
%   [u, status, self] = stage5_step(self, k, x), with self from stage5_init. Keep self: it is what
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

deadbeat = 5.5; % 11/2, samples to go at which deadbeat takes over
c_5 = 2.0; % weight of u1 in the law
b_5 = -4.0; % weight of u1 in the law
b_6 = -10.0; % weight of u2 in the law
u = 0.0;
k = double(k);
if ~(isfinite(k) && (k == floor(k)))
    status = int32(-2);
    return;
end
k = uint32(mod(k, 4294967296));
x = double(x);
elapsed = uint32(mod(double(k) - double(self.start), 4294967296));
x1 = x(1);
x2 = x(2);
x3 = x(3);
x4 = x(4);
left = self.samples - elapsed;
m0 = pick(double(left) < self.hold, self.hold, double(left));
if m0 > deadbeat
    % The exact law in samples.
    s1 = (self.w1_1 * x1) + (self.w1_2 * x2) + (self.w1_3 * x3);
    z1 = s1 + (self.w1_4 * x4);
    z2 = (self.w2_2 * x2) + (self.w2_3 * x3) + (self.w2_4 * x4);
    z3 = (self.w3_3 * x3) + (self.w3_4 * x4);
    z4 = self.w4_4 * x4;
    z5 = self.w5_6 * self.u2;
    z6 = (self.w6_5 * self.u1) + (self.w6_6 * self.u2);
    m0f2 = m0 * (m0 - 1.0);
    m0f3 = m0f2 * (m0 - 2.0);
    m0f4 = m0f3 * (m0 - 3.0);
    m0f5 = m0f4 * (m0 - 4.0);
    s2 = z1 + (z2 * m0) + (z3 * m0f2) + (z4 * m0f3) + (z5 * m0f4);
    s3 = (s2 + (z6 * m0f5)) / (m0f5 * (m0 - 5.0));
    v = s3 + ((c_5 * self.u1) - self.u2);
else
    % Deadbeat.
    s4 = (self.b_1 * x1) + (self.b_2 * x2) + (self.b_3 * x3);
    s5 = s4 + (self.b_4 * x4) + (b_5 * self.u1);
    v = s5 + (b_6 * self.u2);
end
if ~isfinite(v)
    status = int32(-3);
    return;
end
if v > self.u_max
    u_now = self.u_max;
elseif v < -self.u_max
    u_now = -self.u_max;
else
    u_now = v;
end
self.u2 = self.u1;
self.u1 = u_now;
if (v > self.u_max) || (v < -self.u_max)
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
