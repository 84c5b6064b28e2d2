function [u, status, self] = motor_step(self, k, y) %#codegen
%MOTOR_STEP u from tick `k`, which may wrap, and what is measured, y = C x. Call it once for each
%tick.
%
%   [u, status, self] = motor_step(self, k, y), with self from motor_init. Keep self: it is what the
%   next call needs.
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
if ~isfinite(y(1))
    status = int32(-2);
    return;
end
elapsed = uint32(mod(double(k) - double(self.start), 4294967296));

% The estimates; at first what y shows.
if self.seen == uint32(0)
    x1 = y(1);
    x2 = 0.0;
    x3 = 0.0;
    d = 0.0;
else
    x1 = self.x1_next + (0.00010816330676811052 * self.u2);
    x2 = self.x2_next + (0.30941358230147875 * self.u2);
    x3 = self.x3_next + (0.37459048481653323 * self.u2);
    d = self.d_next;
end

% Prediction of the next sample.
miss1 = y(1) - x1;
off1 = miss1;
left_o = uint32(150) - elapsed;
o0 = pick(double(left_o) < 40.0, 40.0, double(left_o));
r0 = 1.0 / o0;
r1 = 1.0 / (o0 - 1.0);
r2 = 1.0 / (o0 - 2.0);
r3 = 1.0 / (o0 - 3.0);
s1 = (((((((-96.0) * r0) + 96.0) * r1) - 48.0) * r2) + 16.0) * r3;
l1 = s1 - 0.46857164949780494;
s2 = ((859382.9277311233 * r0) - 513847.60335174634) * r1;
s3 = (((s2 + 125558.23800330989) * r2) - 9808.939721535125) * r3;
l2 = s3 + 264.4187821124759;
s4 = (((-620544.0922410007) * r0) + 289368.54342637886) * r1;
s5 = (((s4 - 49493.69520132396) * r2) + 3680.3758886140504) * r3;
l3 = s5 - 98.64522377262374;
l4 = 42644.35104284018 * r0 * r1 * r2 * r3;
s6 = x1 + (0.000996505559752715 * x2) + (0.0006188271646029575 * x3);
x1_on = s6 + (0.00010816330676811052 * d) + (l1 * off1);
s7 = (0.9902193397510792 * x2) + (1.1234620408672982 * x3);
x2_on = s7 + (0.30941358230147875 * d) + (l2 * off1);
s8 = ((-0.011234620408672982) * x2) + (0.5412090107511158 * x3);
x3_on = s8 + (0.37459048481653323 * d) + (l3 * off1);
d_on = d + (l4 * off1);
left = uint32(400) - elapsed;
m0 = pick(double(left) < 20.0, 20.0, double(left));

% The exact law in samples.
s9 = ((-1492552.2864994062) * x1) + (1567.1688802442739 * x2);
z1 = s9 - (863.5135156573022 * x3);
z2 = ((-853.121915155696) * x2) + (704.6828966771754 * x3);
z3 = (0.10681268759856057 * x2) - (320.4380627956817 * x3);
s10 = (0.4798607068523099 * x2) + (19.61787944307025 * x3);
z4 = s10 - (16.0 * (self.u1 + d));
s11 = ((((z1 / (m0 + 3.0)) + z2) / (m0 + 2.0)) + z3) / (m0 + 1.0);
s12 = ((-0.014068298956658285) * x2) - (0.5288375642249519 * x3);
s13 = ((s11 + z4) / m0) + (s12 + (1.468571649497805 * (self.u1 + d)));
v = s13 - d;
if ~(isfinite(v) && isfinite(x1_on) && isfinite(x2_on) && isfinite(x3_on) && isfinite(d_on))
    status = int32(-3);
    return;
end
if 24.0 < v
    u_now = 24.0;
elseif v < -24.0
    u_now = -24.0;
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
if (24.0 < v) || (v < -24.0)
    u = u_now;
    status = int32(2);
elseif double(left) <= 20.0
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
