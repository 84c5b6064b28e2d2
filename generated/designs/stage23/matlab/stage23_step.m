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

gamma1 = 0.00014736313620654503; % prediction from u
gamma2 = 0.04245805872561294; % prediction from u
gamma3 = 0.7866781644184895; % prediction from u
observer_samples = uint32(25); % samples of the round of the observer
q1_1 = 24.0; % weight in the observer's gain l1
q1_2 = -24.0; % weight in the observer's gain l1
q1_3 = 12.0; % weight in the observer's gain l1
q2_1 = -12098.699806867564; % weight in the observer's gain l2
q2_2 = 5834.153087954333; % weight in the observer's gain l2
q2_3 = -616.5581920200482; % weight in the observer's gain l2
q3_1 = 90981.25917900148; % weight in the observer's gain l3
q3_2 = -29002.765439771665; % weight in the observer's gain l3
q3_3 = 2998.7909601002407; % weight in the observer's gain l3
e0_1 = 1.0950153689199909; % gain of the observer at its end
e0_2 = 15.297392853547647; % gain of the observer at its end
e0_3 = 98.32269091567703; % gain of the observer at its end
e1_1 = 1.309301083205705; % gain of the observer at its end
e1_2 = 6.605837883444068; % gain of the observer at its end
e1_3 = -407.1438225313707; % gain of the observer at its end
e2_1 = 2.5950153689199906; % gain of the observer at its end
e2_2 = 180.07490250022406; % gain of the observer at its end
e2_3 = 358.78371927742626; % gain of the observer at its end
phi1_2 = 0.009947226521739929; % prediction of x1 from x2
phi1_3 = 0.00042458058725612934; % prediction of x1 from x3
phi2_2 = 0.9892036123037478; % prediction of x2 from x2
phi2_3 = 0.07824323585459282; % prediction of x2 from x3
phi3_2 = -0.015648647170918566; % prediction of x3 from x2
phi3_3 = 0.605811756616243; % prediction of x3 from x3
w1_1 = -1072951.6050632286; % weight of x1 in the law
w1_2 = 11224.193450693596; % weight of x2 in the law
w1_3 = -404.795716419329; % weight of x3 in the law
w2_2 = -6164.422229232715; % weight of x2 in the law
w2_3 = 332.70200299979865; % weight of x3 in the law
w3_2 = 15.336789013047456; % weight of x2 in the law
w3_3 = -153.36789013047456; % weight of x3 in the law
w4_4 = -16.0; % weight of u1 in the law
w4_2 = 0.29792241063993585; % weight of x2 in the law
w4_3 = 8.220775893600642; % weight of x3 in the law
c_4 = 1.4049846310800091; % weight of u1 in the law
c_2 = -0.00824128170492625; % weight of x2 in the law
c_3 = -0.20107642470674394; % weight of x3 in the law
b_1 = -1277.3233393609864; % weight of x1 in the law
b_2 = -37.174971411649004; % weight of x2 in the law
b_3 = -3.523659928569286; % weight of x3 in the law
b_4 = -2.5950153689199906; % weight of u1 in the law
samples = uint32(50); % samples from the start to rest
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
    x1 = self.x1_next + (gamma1 * self.u2);
    x2 = self.x2_next + (gamma2 * self.u2);
    x3 = self.x3_next + (gamma3 * self.u2);
end

% Prediction of the next sample.
miss1 = y(1) - x1;
off1 = miss1;
left_o = observer_samples - elapsed;
o0 = double(left_o);
if o0 > 8.0
    o0f2 = o0 * (o0 - 1.0);
    r0 = 1.0 / (o0f2 * (o0 - 2.0));
    s1 = (q1_1 + (q1_2 * o0) + (q1_3 * o0f2)) * r0;
    l1 = s1 - 0.4049846310800092;
    s2 = (q2_1 + (q2_2 * o0) + (q2_3 * o0f2)) * r0;
    l2 = s2 + 20.107642470674392;
    s3 = (q3_1 + (q3_2 * o0) + (q3_3 * o0f2)) * r0;
    l3 = s3 - 97.7033199358119;
elseif left_o == uint32(8)
    l1 = e0_1;
    l2 = e0_2;
    l3 = e0_3;
elseif left_o == uint32(7)
    l1 = e1_1;
    l2 = e1_2;
    l3 = e1_3;
else
    l1 = e2_1;
    l2 = e2_2;
    l3 = e2_3;
end
x1_on = x1 + (phi1_2 * x2) + (phi1_3 * x3) + (l1 * off1);
x2_on = (phi2_2 * x2) + (phi2_3 * x3) + (l2 * off1);
x3_on = (phi3_2 * x2) + (phi3_3 * x3) + (l3 * off1);

% The tracking error.
u_r = (0.07 * r(2)) + (0.05205 * r(3)) + (0.0017731666666666666 * r(4));
e1 = x1 - r(1);
e2 = x2 - r(2);
e3 = x3 - ((0.1 * r(2)) + (0.1 * r(3)));
if elapsed < uint32(46)
    % The exact law in samples.
    m0 = double(uint32(mod(double(uint32(53)) - double(elapsed), 4294967296)));
    z1 = (w1_1 * e1) + (w1_2 * e2) + (w1_3 * e3);
    z2 = (w2_2 * e2) + (w2_3 * e3);
    z3 = (w3_2 * e2) + (w3_3 * e3);
    s4 = w4_4 * (self.u1 - self.u_r1);
    z4 = (w4_2 * e2) + (w4_3 * e3) + s4;
    m0f2 = m0 * (m0 - 1.0);
    m0f3 = m0f2 * (m0 - 2.0);
    s5 = c_4 * (self.u1 - self.u_r1);
    s6 = (z1 + (z2 * m0) + (z3 * m0f2) + (z4 * m0f3)) / (m0f3 * (m0 - 3.0));
    v = s6 + ((c_2 * e2) + (c_3 * e3) + s5) + u_r;
else
    % Deadbeat.
    s7 = (b_1 * e1) + (b_2 * e2) + (b_3 * e3);
    v = s7 + (b_4 * (self.u1 - self.u_r1)) + u_r;
end
if ~(isfinite(v) && isfinite(x1_on) && isfinite(x2_on) && isfinite(x3_on))
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
if (v > self.u_max) || (v < -self.u_max)
    u = u_now;
    status = int32(2);
elseif elapsed < samples
    u = u_now;
    status = int32(0);
else
    u = u_now;
    status = int32(1);
end
end
