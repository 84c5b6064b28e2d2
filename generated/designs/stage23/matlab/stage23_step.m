function [u, status, self] = stage23_step(self, k, y, r) %#codegen
%STAGE23_STEP u from tick `k`, which may wrap, and what is measured, y = C x, and the reference.
%Call it once for each tick.
%
%   [u, status, self] = stage23_step(self, k, y, r), with self from stage23_init. Keep self: it is
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

u = 0.0;
k = double(k);
if ~(isfinite(k) && (k == floor(k)))
    status = int32(-2);
    return;
end
k = uint32(mod(k, 4294967296));
y = double(y);
r = double(r);
if ~(isfinite(y(1)) && isfinite(r(1)) && isfinite(r(2)) && isfinite(r(3)) && isfinite(r(4)))
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
    x1 = self.x1_next + (0.00014736313620654503 * self.u2);
    x2 = self.x2_next + (0.04245805872561294 * self.u2);
    x3 = self.x3_next + (0.7866781644184895 * self.u2);
end

% Prediction of the next sample.
miss1 = y(1) - x1;
off1 = miss1;
left_o = uint32(25) - elapsed;
o0 = double(left_o);
if 8.0 < o0
    r0 = 1.0 / o0;
    r1 = 1.0 / (o0 - 1.0);
    r2 = 1.0 / (o0 - 2.0);
    l1 = (((((24.0 * r0) - 24.0) * r1) + 12.0) * r2) - 0.4049846310800092;
    s1 = (((-12098.699806867564) * r0) + 5834.153087954333) * r1;
    l2 = ((s1 - 616.5581920200482) * r2) + 20.107642470674392;
    s2 = ((90981.25917900148 * r0) - 29002.765439771665) * r1;
    l3 = ((s2 + 2998.7909601002407) * r2) - 97.7033199358119;
elseif left_o == uint32(8)
    l1 = 1.0950153689199909;
    l2 = 15.297392853547647;
    l3 = 98.32269091567703;
elseif left_o == uint32(7)
    l1 = 1.309301083205705;
    l2 = 6.605837883444068;
    l3 = -407.1438225313707;
else
    l1 = 2.5950153689199906;
    l2 = 180.07490250022406;
    l3 = 358.78371927742626;
end
s3 = x1 + (0.009947226521739929 * x2);
x1_on = s3 + (0.00042458058725612934 * x3) + (l1 * off1);
s4 = (0.9892036123037478 * x2) + (0.07824323585459282 * x3);
x2_on = s4 + (l2 * off1);
s5 = ((-0.015648647170918566) * x2) + (0.605811756616243 * x3);
x3_on = s5 + (l3 * off1);

% The tracking error.
u_r = (0.07 * r(2)) + (0.05205 * r(3)) + (0.0017731666666666666 * r(4));
e1 = x1 - r(1);
e2 = x2 - r(2);
e3 = x3 - ((0.1 * r(2)) + (0.1 * r(3)));
if elapsed < uint32(46)
    % The exact law in samples.
    m0 = double(uint32(mod(double(uint32(53)) - double(elapsed), 4294967296)));
    s6 = ((-1072951.6050632286) * e1) + (11224.193450693596 * e2);
    z1 = s6 - (404.795716419329 * e3);
    z2 = ((-6164.422229232715) * e2) + (332.70200299979865 * e3);
    z3 = (15.336789013047456 * e2) - (153.36789013047456 * e3);
    s7 = (0.29792241063993585 * e2) + (8.220775893600642 * e3);
    z4 = s7 - (16.0 * (self.u1 - self.u_r1));
    s8 = (((((z1 / m0) + z2) / (m0 - 1.0)) + z3) / (m0 - 2.0)) + z4;
    s9 = ((-0.00824128170492625) * e2) - (0.20107642470674394 * e3);
    s10 = s9 + (1.4049846310800091 * (self.u1 - self.u_r1));
    v = (s8 / (m0 - 3.0)) + s10 + u_r;
else
    % Deadbeat.
    s11 = ((-1277.3233393609864) * e1) - (37.174971411649004 * e2);
    s12 = 2.5950153689199906 * (self.u1 - self.u_r1);
    v = ((s11 - (3.523659928569286 * e3)) - s12) + u_r;
end
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
self.u2 = self.u1;
self.u1 = u_now;
self.u_r1 = u_r;
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
elseif elapsed < uint32(50)
    u = u_now;
    status = int32(0);
else
    u = u_now;
    status = int32(1);
end
end
