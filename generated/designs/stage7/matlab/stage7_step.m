function [u, status, self] = stage7_step(self, k, y) %#codegen
%STAGE7_STEP u from tick `k`, which may wrap, and what is measured, y = (x1, ...). Call it once for
%each tick.
%
%   [u, status, self] = stage7_step(self, k, y), with self from stage7_init. Keep self: it is what
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

q1_1 = -single(20.0); % weight in the observer's gain l1
q1_2 = single(8.0); % weight in the observer's gain l1
u = single(0.0);
k = double(k);
if ~(isfinite(k) && (k == floor(k)))
    status = int32(-2);
    return;
end
k = uint32(mod(k, 4294967296));
y = single(y);
elapsed = uint32(mod(double(k) - double(self.start), 4294967296));

% Predict.
s1 = self.x1_hat + (self.phi1_2 * self.d_hat);
p1 = s1 + (self.phi1_2 * self.u1);
p2 = self.d_hat;

% Correct by what is measured.
if self.seen == uint32(0)
    base = y(1);
    miss = single(0.0);
else
    base = p1;
    miss = y(1) - p1;
end
left_o = bitshift(self.samples, -1) - elapsed;
o0 = single(left_o);
if o0 > single(6.0)
    r0 = single(1.0) / (o0 * (o0 - single(1.0)));
    l1 = (q1_1 + (q1_2 * o0)) * r0;
    l2 = self.q2_1 * r0;
elseif left_o == uint32(6)
    l1 = single(1.0);
    l2 = self.e0_2;
else
    l1 = single(1.0);
    l2 = self.e1_2;
end
x1 = base + (l1 * miss);
d = p2 + (l2 * miss);
left = self.samples - elapsed;
m0 = pick(single(left) < single(1.0), single(1.0), single(left));

% The exact law in samples.
z1 = self.w1_1 * x1;
v = (z1 / (m0 + single(2.0))) - d;
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
self.x1_hat = x1;
self.d_hat = d;
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

function r = pick(condition, yes, no)
if condition
    r = yes;
else
    r = no;
end
end
