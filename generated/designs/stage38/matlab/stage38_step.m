function [u, status, self] = stage38_step(self, k, y) %#codegen
%STAGE38_STEP u from tick `k`, which may wrap, and what is measured, y = (x1, ...). Call it once for
%each tick.
%
%   [u, status, self] = stage38_step(self, k, y), with self from stage38_init. Keep self: it is what
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

u = single(0.0);
k = double(k);
if ~(isfinite(k) && (k == floor(k)))
    status = int32(-2);
    return;
end
k = uint32(mod(k, 4294967296));
y = single(y);
if ~isfinite(y(1))
    status = int32(-2);
    return;
end
elapsed = uint32(mod(double(k) - double(self.start), 4294967296));

% Predict.
s1 = self.x1_hat + (single(0.009999999776482582) * self.x2_hat) + (single(4.999999873689376e-5) * self.d_hat);
p1 = s1 + (single(4.999999873689376e-5) * self.u2);
p2 = self.x2_hat + (single(0.009999999776482582) * self.d_hat) + (single(0.009999999776482582) * self.u2);
p3 = self.d_hat;

% Correct by what is measured.
if self.seen == uint32(0)
    base = y(1);
    miss = single(0.0);
else
    base = p1;
    miss = y(1) - p1;
end
left_o = uint32(20) - elapsed;
o0 = single(left_o);
if single(8.0) < o0
    r0 = single(1.0) / o0;
    r1 = single(1.0) / (o0 - single(1.0));
    r2 = single(1.0) / (o0 - single(2.0));
    l1 = ((((single(120.0) * r0) - single(60.0)) * r1) + single(12.0)) * r2;
    l2 = (((-single(10800.0)) * r0) + single(3600.0)) * r1 * r2;
    l3 = single(240000.0) * r0 * r1 * r2;
elseif left_o == uint32(8)
    l1 = single(1.0);
    l2 = single(42.85714340209961);
    l3 = single(1428.5714111328125);
elseif left_o == uint32(7)
    l1 = single(1.0);
    l2 = single(85.71428680419922);
    l3 = -single(2857.142822265625);
else
    l1 = single(1.0);
    l2 = single(150.0);
    l3 = single(10000.0);
end
x1 = base + (l1 * miss);
x2 = p2 + (l2 * miss);
d = p3 + (l3 * miss);

% The exact law in samples.
m0 = pick(elapsed < uint32(37), single(uint32(mod(double(uint32(43)) - double(elapsed), 4294967296))), single(6.0));
z1 = ((-single(1200000.0)) * x1) + (single(6000.0) * x2);
z2 = (-single(6000.0)) * x2;
z3 = (-single(12.0)) * (self.u1 + d);
s2 = ((((z1 / m0) + z2) / (m0 - single(1.0))) + z3) / (m0 - single(2.0));
v = (s2 + (self.u1 + d)) - d;
if ~isfinite(v)
    status = int32(-3);
    return;
end
if elapsed < uint32(40)
    if single(1.0) < v
        u_now = single(1.0);
    elseif v < single(0.0)
        u_now = single(0.0);
    else
        u_now = v;
    end
else
    u_now = single(0.0);
end
self.u2 = self.u1;
self.u1 = u_now;
self.x1_hat = x1;
self.x2_hat = x2;
self.d_hat = d;
self.seen = uint32(1);
if elapsed < uint32(40)
    if (single(1.0) < v) || (v < single(0.0))
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

function r = pick(condition, yes, no)
if condition
    r = yes;
else
    r = no;
end
end
