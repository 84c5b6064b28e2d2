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

phi1_2 = 0.002; % 1/500, prediction of x2 from x3
gamma1 = 4e-6; % 1/250000, prediction from u
gamma2 = 0.004; % 1/250, prediction from u
q1_1 = -43.265306122448976; % -2120/49, weight in the observer's gain l1
q1_2 = 12.285714285714286; % 86/7, weight in the observer's gain l1
q2_1 = 15489.795918367347; % 759000/49, weight in the observer's gain l2
e0_2 = 182.53968253968253; % 11500/63, gain of the observer at its end
e1_2 = 500.0; % gain of the observer at its end
b_1 = -62500000.0; % weight of x1 in the law
b_2 = -250000.0; % weight of x2 in the law
b_3 = -458.3333333333333; % -1375/3, weight of x3 in the law
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
s1 = self.x2_hat + (phi1_2 * self.x3_hat);
p1 = s1 + (gamma1 * (self.u1 + 0.25));
p2 = self.x3_hat + (gamma2 * (self.u1 + 0.25));

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
if o0 > 9.0
    r0 = 1.0 / (o0 * (o0 - 1.0));
    l1 = (q1_1 + (q1_2 * o0)) * r0;
    l2 = q2_1 * r0;
elseif left_o == uint32(9)
    l1 = 1.0;
    l2 = e0_2;
else
    l1 = 1.0;
    l2 = e1_2;
end
x1 = y(1);
x2 = base + (l1 * miss);
x3 = p2 + (l2 * miss);
left = self.samples - elapsed;
m0 = double(left);
if m0 > self.deadbeat
    % The exact law in samples.
    z1 = (self.w1_1 * x1) + (self.w1_2 * x2) + (self.w1_3 * x3);
    z2 = (self.w2_2 * x2) + (self.w2_3 * x3);
    z3 = self.w3_3 * x3;
    m0f2 = m0 * (m0 - 1.0);
    v = ((z1 + (z2 * m0) + (z3 * m0f2)) / (m0f2 * (m0 - 2.0))) - 0.25;
else
    % Deadbeat.
    s2 = (b_1 * x1) + (b_2 * x2) + (b_3 * x3);
    v = s2 - 0.25;
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
self.u1 = u_now;
self.x2_hat = x2;
self.x3_hat = x3;
self.seen = uint32(1);
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
