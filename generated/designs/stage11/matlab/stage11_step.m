function [u, status, self] = stage11_step(self, k, y) %#codegen
%STAGE11_STEP u from tick `k`, which may wrap, and what is measured, y = (x1, ...). Call it once for
%each tick.
%
%   [u, status, self] = stage11_step(self, k, y), with self from stage11_init. Keep self: it is what
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
s1 = self.x1_hat + (single(0.009999999776482582) * self.x2_hat) + (single(4.999999873689376e-5) * self.x3_hat);
s2 = s1 + (single(1.6666666624587378e-7) * self.x4_hat);
p1 = s2 + (single(4.1666667338624563e-10) * self.d_hat) + (single(4.1666667338624563e-10) * self.u1);
s3 = self.x2_hat + (single(0.009999999776482582) * self.x3_hat) + (single(4.999999873689376e-5) * self.x4_hat);
p2 = s3 + (single(1.6666666624587378e-7) * self.d_hat) + (single(1.6666666624587378e-7) * self.u1);
s4 = self.x3_hat + (single(0.009999999776482582) * self.x4_hat) + (single(4.999999873689376e-5) * self.d_hat);
p3 = s4 + (single(4.999999873689376e-5) * self.u1);
p4 = self.x4_hat + (single(0.009999999776482582) * self.d_hat) + (single(0.009999999776482582) * self.u1);
p5 = self.d_hat;

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
if single(12.0) < o0
    r0 = single(1.0) / o0;
    r1 = single(1.0) / (o0 - single(1.0));
    r2 = single(1.0) / (o0 - single(2.0));
    r3 = single(1.0) / (o0 - single(3.0));
    r4 = single(1.0) / (o0 - single(4.0));
    s5 = ((((((single(6720.0) * r0) - single(4200.0)) * r1) + single(1200.0)) * r2) - single(200.0)) * r3;
    l1 = (s5 + single(20.0)) * r4;
    s6 = (((((-single(808000.0)) * r0) + single(454000.0)) * r1) - single(108000.0)) * r2;
    l2 = (s6 + single(12000.0)) * r3 * r4;
    s7 = ((((single(38400000.0) * r0) - single(16800000.0)) * r1) + single(2400000.0)) * r2 * r3;
    l3 = s7 * r4;
    l4 = (((-single(480000000.0)) * r0) + single(120000000.0)) * r1 * r2 * r3 * r4;
    l5 = single(0.0);
elseif left_o == uint32(12)
    l1 = single(1.0);
    l2 = single(50.75757598876953);
    l3 = single(3678.451171875);
    l4 = -single(166666.671875);
    l5 = single(7070707.0);
elseif left_o == uint32(11)
    l1 = single(1.0);
    l2 = single(79.29293060302734);
    l3 = -single(1414.141357421875);
    l4 = single(696969.6875);
    l5 = -single(48484848.0);
elseif left_o == uint32(10)
    l1 = single(1.0);
    l2 = single(105.55555725097656);
    l3 = -single(1111.111083984375);
    l4 = -single(333333.34375);
    l5 = single(133333336.0);
elseif left_o == uint32(9)
    l1 = single(1.0);
    l2 = single(138.88888549804688);
    l3 = single(3703.70361328125);
    l4 = -single(1666666.625);
    l5 = -single(177777776.0);
else
    l1 = single(1.0);
    l2 = single(208.3333282470703);
    l3 = single(29166.666015625);
    l4 = single(2500000.0);
    l5 = single(100000000.0);
end
x1 = base + (l1 * miss);
x2 = p2 + (l2 * miss);
x3 = p3 + (l3 * miss);
x4 = p4 + (l4 * miss);
d = p5 + (l5 * miss);
left = self.samples - elapsed;
m0 = single(left);
if self.deadbeat < m0
    % The exact law in samples.
    s8 = (self.w1_1 * x1) + (self.w1_2 * x2) + (self.w1_3 * x3);
    z1 = s8 + (self.w1_4 * x4);
    z2 = (self.w2_2 * x2) + (self.w2_3 * x3) + (self.w2_4 * x4);
    z3 = (self.w3_3 * x3) + (self.w3_4 * x4);
    z4 = self.w4_4 * x4;
    s9 = (((((z1 / m0) + z2) / (m0 - single(1.0))) + z3) / (m0 - single(2.0))) + z4;
    v = (s9 / (m0 - single(3.0))) - d;
else
    % Deadbeat.
    s10 = (((-single(100000000.0)) * x1) - (single(2500000.0) * x2)) - (single(29166.666015625) * x3);
    v = (s10 - (single(208.3333282470703) * x4)) - d;
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
self.x1_hat = x1;
self.x2_hat = x2;
self.x3_hat = x3;
self.x4_hat = x4;
self.d_hat = d;
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
