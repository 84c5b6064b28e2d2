function [u, status, self] = stage12_step(self, k, y) %#codegen
%STAGE12_STEP u from tick `k`, which may wrap, and what is measured, y = C x. Call it once for each
%tick.
%
%   [u, status, self] = stage12_step(self, k, y), with self from stage12_init. Keep self: it is what
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
if ~(isfinite(y(1)) && isfinite(y(2)))
    status = int32(-2);
    return;
end
elapsed = uint32(mod(double(k) - double(self.start), 4294967296));

% The estimates; at first what y shows.
if self.seen == uint32(0)
    x1 = y(1);
    x2 = 0.0;
    x3 = y(2);
    d = 0.0;
else
    x1 = self.x1_next + (0.00010816330676811052 * self.u2);
    x2 = self.x2_next + (0.30941358230147875 * self.u2);
    x3 = self.x3_next + (0.37459048481653323 * self.u2);
    d = self.d_next;
end

% Prediction of the next sample.
miss1 = y(1) - x1;
miss2 = y(2) - x3;
off1 = miss1;
off2 = miss2;
left_o = bitshift(self.samples, -1) - elapsed;
o0 = double(left_o);
if left_o == uint32(0)
    l1_1 = 0.17200400622757925;
    l1_2 = 7.693835124666324;
    l1_3 = 0.005627803367048088;
    l1_4 = 0.23319622641969587;
    l2_1 = 0.0014420897963740578;
    l2_2 = 1.2843129003368876;
    l2_3 = -0.2598303207324358;
    l2_4 = 0.028634005234458536;
elseif 8.0 < o0
    r0 = 1.0 / o0;
    r1 = 1.0 / (o0 - 1.0);
    l1_1 = ((((-8.0) * r0) + 8.0) * r1) - 0.0004991835184862197;
    s1 = ((12007.013438558752 * r0) - 4.007472019404232) * r1;
    l1_2 = s1 + 0.004899465284856127;
    l1_3 = 0.005627803367048088;
    l1_4 = 359.9910335767149 * r0 * r1;
    l2_1 = 0.0014420897963740578;
    s2 = (((-18.578489051610646) * r0) + 9.913794744612098) * r1;
    l2_2 = s2 + 1.1153817526860825;
    l2_3 = ((((-12.0) * r0) + 12.0) * r1) - 0.46807246597931873;
    l2_4 = 79.8275894892242 * r0 * r1;
elseif left_o == uint32(8)
    l1_1 = 0.9995008164815138;
    l1_2 = -0.4960345371406728;
    l1_3 = 0.005627803367048088;
    l1_4 = 0.0;
    l2_1 = 0.0014420897963740578;
    l2_2 = 2.2101945239792857;
    l2_3 = 1.0319275340206813;
    l2_4 = 1.3304598248204031;
else
    l1_1 = 1.9995008164815138;
    l1_2 = 999.2535286720462;
    l1_3 = 0.005627803367048088;
    l1_4 = 29.999252798059576;
    l2_1 = 0.0014420897963740578;
    l2_2 = 2.4788577332214805;
    l2_3 = 1.5319275340206813;
    l2_4 = 2.6609196496408063;
end
s3 = x1 + (0.000996505559752715 * x2) + (0.0006188271646029575 * x3);
x1_on = s3 + (0.00010816330676811052 * d) + (l1_1 * off1) + (l2_1 * off2);
s4 = (0.9902193397510792 * x2) + (1.1234620408672982 * x3);
x2_on = s4 + (0.30941358230147875 * d) + (l1_2 * off1) + (l2_2 * off2);
s5 = ((-0.011234620408672982) * x2) + (0.5412090107511158 * x3);
x3_on = s5 + (0.37459048481653323 * d) + (l1_3 * off1) + (l2_3 * off2);
d_on = d + (l1_4 * off1) + (l2_4 * off2);
left = self.samples - elapsed;
m0 = double(left);
if self.deadbeat < m0
    % The exact law in samples.
    z1 = (self.w1_1 * x1) + (self.w1_2 * x2) + (self.w1_3 * x3);
    z2 = (self.w2_2 * x2) + (self.w2_3 * x3);
    z3 = (self.w3_2 * x2) + (self.w3_3 * x3);
    s6 = (self.w4_2 * x2) + (self.w4_3 * x3);
    z4 = s6 + (self.w4_4 * (self.u1 + d));
    s7 = (((((z1 / m0) + z2) / (m0 - 1.0)) + z3) / (m0 - 2.0)) + z4;
    s8 = ((-0.014068298956658285) * x2) - (0.5288375642249519 * x3);
    s9 = (s7 / (m0 - 3.0)) + (s8 + (1.468571649497805 * (self.u1 + d)));
    v = s9 - d;
else
    % Deadbeat.
    s10 = ((-1776.8479601183408) * x1) - (5.132434542441746 * x2);
    s11 = 2.5314283505021953 * (self.u1 + d);
    v = ((s10 - (6.801905651476086 * x3)) - s11) - d;
end
if ~(isfinite(v) && isfinite(x1_on) && isfinite(x2_on) && isfinite(x3_on) && isfinite(d_on))
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
self.u2 = self.u1;
self.u1 = u_now;
self.x1_hat = x1;
self.x1_next = x1_on;
self.x2_hat = x2;
self.x2_next = x2_on;
self.x3_hat = x3;
self.x3_next = x3_on;
self.d_hat = d;
self.d_next = d_on;
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
