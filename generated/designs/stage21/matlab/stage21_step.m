function [u, status, self] = stage21_step(self, k, x) %#codegen
%STAGE21_STEP u from tick `k`, which may wrap, and the state x = (x1, x1', ...). Call it once for
%each tick.
%
%   [u, status, self] = stage21_step(self, k, x), with self from stage21_init. Keep self: it is what
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

b_4 = -0.5234375; % -67/128, weight of u1 in the law
u = 0.0;
k = double(k);
if ~(isfinite(k) && (k == floor(k)))
    status = int32(-2);
    return;
end
k = uint32(mod(k, 4294967296));
x = double(x);
if ~(isfinite(x(1)) && isfinite(x(2)) && isfinite(x(3)))
    status = int32(-2);
    return;
end
elapsed = uint32(mod(double(k) - double(self.start), 4294967296));
x1 = x(1);
x2 = x(2);
x3 = x(3);

% The tracking error.
t = double(elapsed) * self.h;
v_r1 = t * t;
v_r2 = 1.0 + v_r1;
reference0 = (self.p_size * v_r1) / v_r2;
v_r4 = v_r2 * v_r2;
reference1 = (self.c_r3 * t * (v_r2 - v_r1)) / v_r4;
s1 = ((v_r4 + (4.0 * v_r1 * v_r1)) - (4.0 * v_r2 * t * t)) - (v_r2 * v_r1);
reference2 = (self.c_r3 * s1) / (v_r2 * v_r4);
v_r7 = t + self.c_r6;
v_r8 = v_r7 * v_r7;
v_r9 = 1.0 + v_r8;
v_r10 = v_r9 * v_r9;
v_r11 = v_r10 * v_r7;
s2 = ((4.0 * v_r9 * v_r7 * v_r8) + (2.0 * v_r9 * v_r8 * v_r7)) - v_r11;
s3 = self.c_r5 * ((s2 - v_r11) - (4.0 * v_r8 * (v_r7 * v_r8)));
rho0 = s3 / (v_r10 * v_r10);
v_r13 = t + self.c_r12;
v_r14 = pick(v_r13 < 0.0, 0.0, v_r13);
v_r15 = v_r14 * v_r14;
v_r16 = 1.0 + v_r15;
v_r17 = v_r16 * v_r16;
v_r18 = v_r17 * v_r14;
s4 = (4.0 * v_r16 * v_r14 * v_r15) + (2.0 * v_r16 * v_r15 * v_r14);
s5 = ((s4 - v_r18) - v_r18) - (4.0 * v_r15 * (v_r14 * v_r15));
rho1 = (self.c_r5 * s5) / (v_r17 * v_r17);
e1 = x1 - reference0;
e2 = x2 - reference1;
e3 = x3 - reference2;
left = self.samples - elapsed;
m0 = double(left);
if m0 > self.deadbeat
    % The exact law in samples.
    s6 = (self.w1_1 * e1) + (self.w1_2 * e2) + (self.w1_3 * e3);
    z1 = s6 + (self.w1_4 * (self.u1 - (0.5 * rho1)));
    s7 = self.w2_4 * (self.u1 - (0.5 * rho1));
    z2 = (self.w2_2 * e2) + (self.w2_3 * e3) + s7;
    z3 = (self.w3_3 * e3) + (self.w3_4 * (self.u1 - (0.5 * rho1)));
    z4 = self.w4_4 * (self.u1 - (0.5 * rho1));
    m0f2 = m0 * (m0 - 1.0);
    m0f3 = m0f2 * (m0 - 2.0);
    s8 = (z1 + (z2 * m0) + (z3 * m0f2) + (z4 * m0f3)) / (m0f3 * (m0 - 3.0));
    v = s8 + (self.u1 - (0.5 * rho1)) + (0.5 * rho0);
else
    % Deadbeat.
    s9 = (self.b_1 * e1) + (self.b_2 * e2) + (self.b_3 * e3);
    v = s9 + (b_4 * (self.u1 - (0.5 * rho1))) + (0.5 * rho0);
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
