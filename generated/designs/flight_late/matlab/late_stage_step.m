function [u, status, self] = late_stage_step(self, k, y) %#codegen
%LATE_STAGE_STEP u from tick `k`, which may wrap, and what is measured, y = (x1, ...). Call it once
%for each tick.
%
%   [u, status, self] = late_stage_step(self, k, y), with self from late_stage_init. Keep self: it
%   is what the next call needs.
%
%   status (int32); on a negative one what is given is 0, and self is as it was:
%      0  tracking
%      1  hold: time-to-go held at eps, the deadline is near or over, u is valid
%      2  saturated: u clipped to its limits; wins over 1 and 3
%      3  after: the deadline is over, u is 0 or that of the user-defined law
%      4  gated: a reading was not believed, u by prediction alone; wins over all above
%     -2  an argument is not finite, or time lies before the start, or a tick is not whole
%     -3  u not finite
%      6  infeasible: nothing is known from here that keeps all limits or bounds, u is valid

phi1_2 = 0.001; % 1/1000, prediction of x1 from x2
phi1_3 = 3.3333333333333335e-7; % 1/3000000, prediction of x1 from d
gamma1 = 3.3333333333333335e-7; % 1/3000000, prediction from u
phi2_3 = 0.0006666666666666666; % 1/1500, prediction of x2 from d
gamma2 = 0.0006666666666666666; % 1/1500, prediction from u
hold_o = 30.0; % samples to go at which the observer is held
q1_1 = 120.0; % weight in the observer's gain l1
q1_2 = -60.0; % weight in the observer's gain l1
q1_3 = 12.0; % weight in the observer's gain l1
q2_1 = -108000.0; % weight in the observer's gain l2
q2_2 = 36000.0; % weight in the observer's gain l2
q3_1 = 36000000.0; % weight in the observer's gain l3
s1_1 = 1500000.0; % weight of x1 in the law
s1_2 = 750.0; % weight of x2 in the law
s2_2 = 1500.0; % weight of x2 in the law
u_max = 6.0; % bound of |u|
hold = 20.0; % samples to go at which the gains are held
end_samples = 50.0; % samples to go at which the law of the end takes over
w1_1 = -9000000.0; % weight of x1 in the law
w1_2 = -4500.0; % weight of x2 in the law
w2_2 = -6000.0; % weight of x2 in the law
w2_3 = -4.0; % weight of u1 in the law
end1_1 = -18000000.0; % weight of x1 in the law
end1_2 = -9000.0; % weight of x2 in the law
end2_2 = -9000.0; % weight of x2 in the law
end2_3 = -6.0; % weight of u1 in the law
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

% Predict.
s1 = self.x1_hat + (phi1_2 * self.x2_hat);
s2 = s1 + (phi1_3 * self.d_hat);
p1 = s2 + (gamma1 * self.u2);
s3 = self.x2_hat + (phi2_3 * self.d_hat);
p2 = s3 + (gamma2 * self.u2);
p3 = self.d_hat;

% Correct by what is measured.
if self.seen == uint32(0)
    base = y(1);
    miss = 0.0;
else
    base = p1;
    miss = y(1) - p1;
end
left_o = self.round - elapsed;
o0 = pick(double(left_o) < hold_o, hold_o, double(left_o));
o0f2 = o0 * (o0 - 1.0);
r0 = 1.0 / (o0f2 * (o0 - 2.0));
l1 = (q1_1 + (q1_2 * o0) + (q1_3 * o0f2)) * r0;
l2 = (q2_1 + (q2_2 * o0)) * r0;
l3 = q3_1 * r0;
x1 = base + (l1 * miss);
x2 = p2 + (l2 * miss);
d = p3 + (l3 * miss);

% The deadline that keeps the limits.
last_now = self.last;
late = uint32(0);
to_rest = self.last - elapsed;
ahead = to_rest - uint32(1);
flat1 = (s1_1 * x1) + (s1_2 * x2);
flat2 = (s2_2 * x2) + (self.u1 + d);
low = ahead - uint32(1);
top = uint32(1073741825);
kept = uint32(0);
tried = ahead;
part = 0.9999999999998739;
for attempt = 0:63
    least = ((-u_max) * part) + d;
    most = (u_max * part) + d;
    within = pick(-least < most, -least, most);
    fits = uint32(0);
    if tried > uint32(50)
        m = double(tried);
        power1 = m + 1.0;
        power2 = power1 * m;
        power3 = power2 * (m - 1.0);
        scaled2 = flat2 * power1;
        w1 = ((3.0 * flat1) + scaled2) / power2;
        w2 = (((-2.0) * flat1) - scaled2) / power3;
        length = m - 51.0;
        b0_c = (2.0 * w1) + (300.0 * w2);
        b1_c = 6.0 * w2 * length;
        b1 = b0_c + b1_c;
        end11 = (2.8506787330316743 * w1) + (117.44796380090497 * w2);
        end12 = (3.0475113122171944 * w1) + (145.85746606334843 * w2);
        end13 = (2.9906485671191554 * w1) + (175.02805429864253 * w2);
        end14 = (2.6800904977375564 * w1) + (204.95972850678734 * w2);
        end15 = (2.1158371040723982 * w1) + (235.6524886877828 * w2);
        end16 = (1.2978883861236803 * w1) + (267.10633484162895 * w2);
        end17 = (0.22624434389140272 * w1) + (299.3212669683258 * w2);
        if (least <= b0_c) ...
            && (b0_c <= most) ...
            && (least <= b1) ...
            && (b1 <= most) ...
            && (least <= end11) ...
            && (end11 <= most) ...
            && (least <= end12) ...
            && (end12 <= most) ...
            && (least <= end13) ...
            && (end13 <= most) ...
            && (least <= end14) ...
            && (end14 <= most) ...
            && (least <= end15) ...
            && (end15 <= most) ...
            && (least <= end16) ...
            && (end16 <= most) ...
            && (least <= end17) ...
            && (end17 <= most) ...
            && (abs((2.8054298642533926 * w1) + (111.58371040723979 * w2)) <= 0.9850746268656713 * within) ...
            && (abs((2.583924302196364 * w1) + (85.00144425360725 * w2)) <= 0.9850746268656713 * within) ...
            && (abs((1.9885945165034657 * w1) + (61.86959300518941 * w2)) <= 0.9850746268656713 * within) ...
            && (abs((2.9380703330283167 * w1) + (105.39729178384643 * w2)) <= 0.9850746268656713 * within) ...
            && (abs((2.395997187424203 * w1) + (77.20565274199532 * w2)) <= 0.9850746268656713 * within) ...
            && (abs((2.8712027904432142 * w1) + (99.5000219686458 * w2)) <= 0.9850746268656713 * within)
            fits = uint32(1);
        end
    elseif tried > uint32(20)
        m = double(tried);
        power1 = m + 2.0;
        power2 = power1 * (m + 1.0);
        power3 = power2 * m;
        power4 = power3 * (m - 1.0);
        scaled2 = flat2 * power1;
        w1 = ((4.0 * flat1) + scaled2) / power3;
        w2 = (((-3.0) * flat1) - scaled2) / power4;
        length = m - 21.0;
        b0_c = (126.0 * w1) + (5040.0 * w2);
        b1_c = ((6.0 * w1) + (492.0 * w2)) * length;
        b2_l = length * length;
        b2_c = 12.0 * w2 * b2_l;
        b1 = b0_c + (0.16666666666666666 * b1_c);
        s4 = b0_c + (0.3333333333333333 * b1_c);
        b2 = s4 + (0.06666666666666667 * b2_c);
        b3 = b0_c + (0.5 * b1_c) + (0.2 * b2_c);
        b4 = b0_c + (0.6666666666666666 * b1_c) + (0.4 * b2_c);
        s5 = b0_c + (0.8333333333333334 * b1_c);
        b5 = s5 + (0.6666666666666666 * b2_c);
        b6 = b0_c + b1_c + b2_c;
        if (least <= b0_c) ...
            && (b0_c <= most) ...
            && (least <= b1) ...
            && (b1 <= most) ...
            && (least <= b2) ...
            && (b2 <= most) ...
            && (least <= b3) ...
            && (b3 <= most) ...
            && (least <= b4) ...
            && (b4 <= most) ...
            && (least <= b5) ...
            && (b5 <= most) ...
            && (least <= b6) ...
            && (b6 <= most) ...
            && (abs((119.99999999999996 * w1) + (4559.999999999999 * w2)) <= 0.9850746268656713 * within) ...
            && (abs((92.75321716019634 * w1) + (2422.754466594877 * w2)) <= 0.9850746268656713 * within) ...
            && (abs((67.8353765546998 * w1) + (1509.7849977027897 * w2)) <= 0.9850746268656713 * within) ...
            && (abs((114.21150278293138 * w1) + (3629.3877551020414 * w2)) <= 0.9850746268656713 * within) ...
            && (abs((84.39364430426792 * w1) + (2085.179889377806 * w2)) <= 0.9850746268656713 * within) ...
            && (abs((108.11363033997543 * w1) + (3196.9332337421392 * w2)) <= 0.9850746268656713 * within)
            fits = uint32(1);
        end
    elseif (abs(((-0.025974025974025976) * flat1) - (0.2857142857142857 * flat2)) <= 0.9850746268656713 * within) ...
        && (abs(((-0.0012475444042476065) * flat1) - (0.08276232337733669 * flat2)) <= 0.9850746268656713 * within) ...
        && (abs((0.0035664936491730252 * flat1) - (0.02768331367963576 * flat2)) <= 0.9850746268656713 * within) ...
        && (abs(((-0.012577404043081223) * flat1) - (0.18287834614365228 * flat2)) <= 0.9850746268656713 * within) ...
        && (abs((0.000902126332826074 * flat1) - (0.060363489673773814 * flat2)) <= 0.9850746268656713 * within) ...
        && (abs(((-0.007827317130259085) * flat1) - (0.14320479414568998 * flat2)) <= 0.9850746268656713 * within)
        fits = uint32(1);
    end
    if fits == uint32(1)
        kept = tried;
        top = tried;
    elseif tried > uint32(20)
        low = tried;
    else
        low = uint32(20);
    end
    gap = top - low;
    if gap < uint32(2)
        break;
    end
    half = bitshift(gap, -1);
    if low < half
        tried = low + low;
    else
        tried = low + half;
    end
    part = 0.899999999999773;
end
if (ahead < kept) && (elapsed < uint32(2147483648))
    last_now = (elapsed + kept) + uint32(1);
end
if (kept == uint32(0)) && (ahead > uint32(0))
    late = uint32(2);
end
if last_now > self.last
    late = uint32(1);
end
left = last_now - elapsed;
s6 = double(left) - 1.0;
m0 = pick(s6 < hold, hold, s6);
if m0 > end_samples
    % The exact law in samples.
    z1 = (w1_1 * x1) + (w1_2 * x2);
    z2 = (w2_2 * x2) + (w2_3 * (self.u1 + d));
    m0f1 = m0 + 1.0;
    v = ((z1 + (z2 * m0f1)) / (m0f1 * m0)) - d;
else
    % The law of least energy to the end.
    m1 = pick(m0 < 2.0, 2.0, m0);
    y1 = (end1_1 * x1) + (end1_2 * x2);
    y2 = (end2_2 * x2) + (end2_3 * (self.u1 + d));
    m1f1 = m1 + 2.0;
    v = ((y1 + (y2 * m1f1)) / (m1f1 * (m1 + 1.0))) - d;
end
if ~isfinite(v)
    status = int32(-3);
    return;
end
if v > u_max
    u_now = u_max;
elseif v < -u_max
    u_now = -u_max;
else
    u_now = v;
end
self.u2 = self.u1;
self.u1 = u_now;
self.last = last_now;
self.x1_hat = x1;
self.x2_hat = x2;
self.d_hat = d;
self.seen = uint32(1);
if (v > u_max) || (v < -u_max)
    u = u_now;
    status = int32(2);
elseif double(left) - 1.0 <= hold
    u = u_now;
    status = int32(1);
elseif late == uint32(2)
    u = u_now;
    status = int32(6);
elseif late == uint32(1)
    u = u_now;
    status = int32(5);
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
