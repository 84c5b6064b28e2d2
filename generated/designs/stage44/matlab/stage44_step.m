function [u, status, self] = stage44_step(self, k, y) %#codegen
%STAGE44_STEP u from tick `k`, which may wrap, and what is measured, y = C x. Call it once for each
%tick.
%
%   [u, status, self] = stage44_step(self, k, y), with self from stage44_init. Keep self: it is what
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
else
    s1 = 1.4506885866158227e-5 * self.u2;
    x1 = self.x1_next + ((9.353143640028875e-5 * self.u3) + s1);
    s2 = 0.008492640667447336 * self.u2;
    x2 = self.x2_next + ((0.02240015856569381 * self.u3) + s2);
    s3 = 0.15880933131841984 * self.u3;
    x3 = self.x3_next + (s3 + (0.21578282027048595 * self.u2));
end

% Prediction of the next sample.
miss1 = y(1) - x1;
off1 = miss1;
left_o = bitshift(self.samples, -1) - elapsed;
o0 = double(left_o);
if 8.0 < o0
    r0 = 1.0 / o0;
    r1 = 1.0 / (o0 - 1.0);
    r2 = 1.0 / (o0 - 2.0);
    l1 = (((((24.0 * r0) - 24.0) * r1) + 12.0) * r2) - 0.47301759733204196;
    s4 = (((-12889.952685745366) * r0) + 6304.212917508586) * r1;
    l2 = ((s4 - 742.8703573620571) * r2) + 26.72716299730578;
    s5 = ((72521.99132748511 * r0) - 24808.851670034343) * r1;
    l3 = ((s5 + 2767.4814294482285) * r2) - 98.86735283457841;
elseif left_o == uint32(8)
    l1 = 1.026982402667958;
    l2 = 9.393065010983802;
    l3 = 72.1724949708503;
elseif left_o == uint32(7)
    l1 = 1.2412681169536723;
    l2 = -0.9955098611216602;
    l3 = -271.5264302640074;
else
    l1 = 2.526982402667958;
    l2 = 168.91277532831796;
    l3 = 171.81438886235838;
end
s6 = x1 + (0.009942671770940647 * x2) + (0.000617855984662823 * x3);
x1_on = s6 + (l1 * off1);
s7 = (0.9857608243445873 * x2) + (0.11206871748434033 * x3);
x2_on = s7 + (l2 * off1);
s8 = ((-0.11206871748434033) * x2) + (0.5412215783233707 * x3);
x3_on = s8 + (l3 * off1);
left = self.samples - elapsed;
s9 = double(left) - 2.0;
m0 = pick(s9 < 6.0, 6.0, s9);

% The exact law in samples.
s10 = ((-106850.90292251826) * x1) - (482.3692808208648 * x2);
s11 = 1.2197801784387233e-74 * self.u1;
s12 = (s10 + (4.807633485406011 * x3)) - s11;
z1 = s12 + (4.609258112111791 * self.u2);
s13 = ((-633.6322203514217) * x2) - (73.36956899710586 * x3);
s14 = s13 - (1.2733281521282373e-76 * self.u1);
z2 = s14 - (14.786896717013052 * self.u2);
s15 = (4.311208496599377 * x2) - (9.337493806987991 * x3);
z3 = (s15 - (9.0 * self.u1)) - (2.7645844206856207 * self.u2);
s16 = (0.10945032226632541 * x2) + (0.5296658086896372 * x3);
s17 = s16 + (0.47301759733204196 * self.u1);
s18 = ((((z1 / (m0 + 2.0)) + z2) / (m0 + 1.0)) + z3) / m0;
v = s18 + (s17 + (0.15314166966017376 * self.u2));
if ~(isfinite(v) && isfinite(x1_on) && isfinite(x2_on) && isfinite(x3_on))
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
self.u3 = self.u2;
self.u2 = self.u1;
self.u1 = u_now;
self.x1_hat = x1;
self.x1_next = x1_on;
self.x2_hat = x2;
self.x2_next = x2_on;
self.x3_hat = x3;
self.x3_next = x3_on;
self.seen = uint32(1);
if (self.u_max < v) || (v < -self.u_max)
    u = u_now;
    status = int32(2);
elseif double(left) - 2.0 <= 6.0
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
