function [u, status, self] = stage20_step(self, k, y, r) %#codegen
%STAGE20_STEP u from tick `k`, which may wrap, and what is measured, y = (x1, ...), and the
%reference. Call it once for each tick.
%
%   [u, status, self] = stage20_step(self, k, y, r), with self from stage20_init. Keep self: it is
%   what the next call needs.
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
c_3 = 2.0; % weight of u1 in the law
b_3 = -2.0; % weight of u1 in the law
b_4 = -0.65625; % -21/32, weight of u2 in the law
u = 0.0;
k = double(k);
if ~(isfinite(k) && (k == floor(k)))
    status = int32(-2);
    return;
end
k = uint32(mod(k, 4294967296));
y = double(y);
r = double(r);
if ~(isfinite(y(1)) && isfinite(r(1)) && isfinite(r(2)) && isfinite(r(3)))
    status = int32(-2);
    return;
end
elapsed = uint32(mod(double(k) - double(self.start), 4294967296));

% Predict.
s1 = self.x1_hat + (self.phi1_2 * self.x2_hat);
s2 = self.late_gamma1 * (self.u2 + 0.5);
s3 = (self.gamma1 * (self.u3 + 0.5)) + s2;
p1 = s1 + (self.phi1_3 * self.d_hat) + s3;
s4 = self.late_gamma2 * (self.u2 + 0.5);
s5 = self.x2_hat + (self.phi2_3 * self.d_hat);
p2 = s5 + ((self.gamma2 * (self.u3 + 0.5)) + s4);
p3 = self.d_hat;

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
if o0 > 8.0
    o0f2 = o0 * (o0 - 1.0);
    r0 = 1.0 / (o0f2 * (o0 - 2.0));
    l1 = (q1_1 + (q1_2 * o0) + (q1_3 * o0f2)) * r0;
    l2 = (self.q2_1 + (self.q2_2 * o0)) * r0;
    l3 = self.q3_1 * r0;
elseif left_o == uint32(8)
    l1 = 1.0;
    l2 = self.e0_2;
    l3 = self.e0_3;
elseif left_o == uint32(7)
    l1 = 1.0;
    l2 = self.e1_2;
    l3 = self.e1_3;
else
    l1 = 1.0;
    l2 = self.e2_2;
    l3 = self.e2_3;
end
x1 = base + (l1 * miss);
x2 = p2 + (l2 * miss);
d = p3 + (l3 * miss);

% The tracking error.
e1 = x1 - r(1);
e2 = x2 - r(2);
left = self.samples - elapsed;
m0 = double(left);
if m0 > self.deadbeat
    % The exact law in samples.
    s6 = self.w1_4 * ((self.u2 + (d + 0.5)) - (2.0 * self.rho2));
    z1 = (self.w1_1 * e1) + (self.w1_2 * e2) + s6;
    s7 = self.w2_4 * ((self.u2 + (d + 0.5)) - (2.0 * self.rho2));
    z2 = (self.w2_2 * e2) + s7;
    z3 = self.w3_4 * ((self.u2 + (d + 0.5)) - (2.0 * self.rho2));
    s8 = self.w4_3 * ((self.u1 + (d + 0.5)) - (2.0 * self.rho1));
    z4 = s8 + (self.w4_4 * ((self.u2 + (d + 0.5)) - (2.0 * self.rho2)));
    m0f2 = m0 * (m0 - 1.0);
    m0f3 = m0f2 * (m0 - 2.0);
    s9 = c_3 * ((self.u1 + (d + 0.5)) - (2.0 * self.rho1));
    s10 = (z1 + (z2 * m0) + (z3 * m0f2) + (z4 * m0f3)) / (m0f3 * (m0 - 3.0));
    s11 = (s10 + (s9 - ((self.u2 + (d + 0.5)) - (2.0 * self.rho2)))) - (d + 0.5);
    v = s11 + (2.0 * r(3));
else
    % Deadbeat.
    s12 = b_3 * ((self.u1 + (d + 0.5)) - (2.0 * self.rho1));
    s13 = b_4 * ((self.u2 + (d + 0.5)) - (2.0 * self.rho2));
    s14 = ((self.b_1 * e1) + (self.b_2 * e2) + s12 + s13) - (d + 0.5);
    v = s14 + (2.0 * r(3));
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
self.u3 = self.u2;
self.u2 = self.u1;
self.u1 = u_now;
self.rho2 = self.rho1;
self.rho1 = r(3);
self.x1_hat = x1;
self.x2_hat = x2;
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
