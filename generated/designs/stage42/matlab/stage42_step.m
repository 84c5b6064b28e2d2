function [u, status, self] = stage42_step(self, k, y) %#codegen
%STAGE42_STEP u from tick `k`, which may wrap, and what is measured, y = (x1, ...). Call it once for
%each tick.
%
%   [u, status, self] = stage42_step(self, k, y), with self from stage42_init. Keep self: it is what
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

q1_1 = -5.0; % weight in the observer's gain l1
q1_2 = 3.5; % 7/2, weight in the observer's gain l1
u = 0.0;
k = double(k);
if ~(isfinite(k) && (k == floor(k)))
    status = int32(-2);
    return;
end
k = uint32(mod(k, 4294967296));
y = double(y);
if ~(isfinite(y(1)) && (abs(y(1)) <= 1.5))
    status = int32(-2);
    return;
end
elapsed = uint32(mod(double(k) - double(self.start), 4294967296));

% Predict.
s1 = self.x1_hat + (self.phi1_2 * self.x2_hat);
p1 = s1 + (self.gamma1 * self.u1);
p2 = self.x2_hat + (self.phi1_2 * self.u1);

% Correct by what is measured.
if self.seen == uint32(0)
    base = y(1);
    miss = 0.0;
else
    base = p1;
    miss = y(1) - p1;
end
left_o = bitshift(self.samples, -1) - elapsed;
o0 = double(left_o);
if o0 > 4.0
    r0 = 1.0 / (o0 * (o0 - 1.0));
    l1 = (q1_1 + (q1_2 * o0)) * r0;
    l2 = self.q2_1 * r0;
elseif left_o == uint32(4)
    l1 = 1.0;
    l2 = self.e0_2;
else
    l1 = 1.0;
    l2 = self.e1_2;
end
x1 = base + (l1 * miss);
x2 = p2 + (l2 * miss);
left = self.samples - elapsed;
m0 = double(left);
if m0 > self.deadbeat
    % The exact law in samples.
    z1 = (self.w1_1 * x1) + (self.w1_2 * x2);
    z2 = self.w2_2 * x2;
    v = (z1 + (z2 * m0)) / (m0 * (m0 - 1.0));
else
    % Deadbeat.
    v = (self.b_1 * x1) + (self.b_2 * x2);
end
if ~isfinite(v)
    status = int32(-3);
    return;
end
if elapsed < self.samples
    if v > self.u_max
        u_now = self.u_max;
    elseif v < -self.u_max
        u_now = -self.u_max;
    else
        u_now = v;
    end
else
    u_now = 0.0;
end
self.u1 = u_now;
self.x1_hat = x1;
self.x2_hat = x2;
self.seen = uint32(1);
if elapsed < self.samples
    if (v > self.u_max) || (v < -self.u_max)
        u = u_now;
        status = int32(2);
    else
        u = u_now;
        status = int32(0);
    end
else
    u = u_now;
    status = int32(3);
end
end
