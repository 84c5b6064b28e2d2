function [u, status, self] = stage45_step(self, k, x) %#codegen
%STAGE45_STEP u from tick `k`, which may wrap, and the state x = (x1, x1', ...). Call it once for
%each tick.
%
%   [u, status, self] = stage45_step(self, k, x), with self from stage45_init. Keep self: it is what
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

b_3 = -single(2.0); % weight of u1 in the law
b_4 = -single(3.0); % weight of u2 in the law
b_5 = -single(4.0); % weight of u3 in the law
b_6 = -single(5.0); % weight of u4 in the law
b_7 = -single(6.0); % weight of u5 in the law
u = single(0.0);
k = double(k);
if ~(isfinite(k) && (k == floor(k)))
    status = int32(-2);
    return;
end
k = uint32(mod(k, 4294967296));
x = single(x);
elapsed = uint32(mod(double(k) - double(self.start), 4294967296));
x1 = x(1);
x2 = x(2);
left = self.samples - elapsed;
m0 = single(left) - single(5.0);
if m0 > self.deadbeat
    % The exact law in samples.
    s1 = (self.w1_1 * x1) + (self.w1_2 * x2) + (self.w1_4 * self.u2);
    s2 = s1 + (self.w1_5 * self.u3) + (self.w1_6 * self.u4);
    z1 = s2 + (self.w1_7 * self.u5);
    s3 = (self.w2_2 * x2) + (self.w2_3 * self.u1);
    s4 = s3 + (self.w2_3 * self.u2) + (self.w2_3 * self.u3);
    z2 = s4 + (self.w2_3 * self.u4) + (self.w2_3 * self.u5);
    v = (z1 + (z2 * m0)) / (m0 * (m0 - single(1.0)));
else
    % Deadbeat.
    s5 = (self.b_1 * x1) + (self.b_2 * x2) + (b_3 * self.u1);
    s6 = s5 + (b_4 * self.u2) + (b_5 * self.u3);
    v = s6 + (b_6 * self.u4) + (b_7 * self.u5);
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
self.u5 = self.u4;
self.u4 = self.u3;
self.u3 = self.u2;
self.u2 = self.u1;
self.u1 = u_now;
if (v > self.u_max) || (v < -self.u_max)
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
