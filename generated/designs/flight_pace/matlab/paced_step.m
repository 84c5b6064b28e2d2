function [u, status, self] = paced_step(self, k, x) %#codegen
%PACED_STEP u from tick `k`, which may wrap, and the state x = (x1, x1', ...). Call it once for each
%tick.
%
%   [u, status, self] = paced_step(self, k, x), with self from paced_init. Keep self: it is what the
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
%      6  infeasible: nothing is known from here that keeps all limits or bounds, u is valid

s1_1 = 10000.0; % weight of x1 in the law
s1_2 = -50.0; % weight of x2 in the law
s2_2 = 100.0; % weight of x2 in the law
w1_1 = -1200000.0; % weight of x1 in the law
w1_2 = 6000.0; % weight of x2 in the law
w2_2 = -6000.0; % weight of x2 in the law
w3_3 = -12.0; % weight of u1 in the law
u = 0.0;
k = double(k);
if ~(isfinite(k) && (k == floor(k)))
    status = int32(-2);
    return;
end
k = uint32(mod(k, 4294967296));
x = double(x);
if ~(isfinite(x(1)) && isfinite(x(2)))
    status = int32(-2);
    return;
end
elapsed = uint32(mod(double(k) - double(self.start), 4294967296));
x1 = x(1);
x2 = x(2);

% The deadline that keeps the limits.
last_now = self.last;
late = uint32(0);
if elapsed < self.last
    to_rest = self.last - elapsed;
    ahead = to_rest;
    flat1 = (s1_1 * x1) + (s1_2 * x2);
    flat2 = s2_2 * x2;
    flat3 = self.u1;
    below = (ahead - uint32(1)) - bitshift(ahead, -4);
    if ahead > uint32(3)
        if below < uint32(3)
            below = uint32(3);
        end
    else
        below = ahead - uint32(1);
    end
    low = below;
    top = uint32(1073741825);
    kept = uint32(0);
    tried = ahead;
    part = 0.9999999999968848;
    for attempt = 0:63
        least = -part;
        most = self.u_max * part;
        fits = uint32(0);
        if tried > uint32(3)
            m = double(tried);
            power1 = m + 3.0;
            power2 = power1 * (m + 2.0);
            power3 = power2 * (m + 1.0);
            power4 = power3 * m;
            power5 = power4 * (m - 1.0);
            power6 = power5 * (m - 2.0);
            scaled2 = flat2 * power1;
            scaled3 = flat3 * power2;
            w1 = ((15.0 * flat1) + (5.0 * scaled2) + (0.5 * scaled3)) / power4;
            w2 = ((((-24.0) * flat1) - (9.0 * scaled2)) - scaled3) / power5;
            w3 = ((10.0 * flat1) + (4.0 * scaled2) + (0.5 * scaled3)) / power6;
            length = m - 4.0;
            b0_c = (144.0 * w1) + (480.0 * w2) + (720.0 * w3);
            b1_c = ((84.0 * w1) + (520.0 * w2) + (1500.0 * w3)) * length;
            b2_l = length * length;
            b2_c = ((12.0 * w1) + (180.0 * w2) + (1050.0 * w3)) * b2_l;
            b3_l = b2_l * length;
            b3_c = ((20.0 * w2) + (300.0 * w3)) * b3_l;
            b4_l = b3_l * length;
            b4_c = 30.0 * w3 * b4_l;
            b1 = b0_c + (0.125 * b1_c);
            b2 = b0_c + (0.25 * b1_c) + (0.03571428571428571 * b2_c);
            s1 = b0_c + (0.375 * b1_c) + (0.10714285714285714 * b2_c);
            b3 = s1 + (0.017857142857142856 * b3_c);
            s2 = b0_c + (0.5 * b1_c) + (0.21428571428571427 * b2_c);
            s3 = s2 + (0.07142857142857142 * b3_c);
            b4 = s3 + (0.014285714285714285 * b4_c);
            s4 = b0_c + (0.625 * b1_c) + (0.35714285714285715 * b2_c);
            s5 = s4 + (0.17857142857142858 * b3_c);
            b5 = s5 + (0.07142857142857142 * b4_c);
            s6 = b0_c + (0.75 * b1_c) + (0.5357142857142857 * b2_c);
            s7 = s6 + (0.35714285714285715 * b3_c);
            b6 = s7 + (0.21428571428571427 * b4_c);
            s8 = b0_c + (0.875 * b1_c) + (0.75 * b2_c) + (0.625 * b3_c);
            b7 = s8 + (0.5 * b4_c);
            b8 = b0_c + b1_c + b2_c + b3_c + b4_c;
            end29 = (72.0 * w1) + (120.0 * w2);
            end30 = 24.0 * w1;
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
                && (least <= b7) ...
                && (b7 <= most) ...
                && (least <= b8) ...
                && (b8 <= most) ...
                && (least <= end29) ...
                && (end29 <= most) ...
                && (least <= end30) ...
                && (end30 <= most)
                fits = uint32(1);
            end
        else
            end0 = ((-flat1) - (3.0 * flat2)) - (2.0 * flat3);
            end1 = flat1 + (2.0 * flat2) + flat3;
            if (least <= end0) && (end0 <= most) && (least <= end1) && (end1 <= most)
                fits = uint32(1);
            end
        end
        if fits == uint32(1)
            kept = tried;
            top = tried;
        elseif tried > uint32(3)
            low = tried;
        else
            low = uint32(3);
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
        part = 0.9999999999937695;
    end
    if (kept > uint32(0)) && (elapsed < uint32(2147483648))
        last_now = elapsed + kept;
    end
    if (kept == uint32(0)) && (ahead > uint32(0))
        late = uint32(2);
    end
end
if last_now > self.last
    late = uint32(1);
end
left = last_now - elapsed;
m0 = pick(double(left) < 3.0, 3.0, double(left));

% The exact law in samples.
z1 = (w1_1 * x1) + (w1_2 * x2);
z2 = w2_2 * x2;
z3 = w3_3 * self.u1;
m0f1 = m0 + 3.0;
m0f2 = m0f1 * (m0 + 2.0);
v = ((z1 + (z2 * m0f1) + (z3 * m0f2)) / (m0f2 * (m0 + 1.0))) + self.u1;
if ~isfinite(v)
    status = int32(-3);
    return;
end
if elapsed < last_now
    if v > self.u_max
        u_now = self.u_max;
    elseif v < -1.0
        u_now = -1.0;
    else
        u_now = v;
    end
else
    u_now = 0.0;
end
self.u1 = u_now;
self.last = last_now;
if elapsed < last_now
    if (v > self.u_max) || (v < -1.0)
        u = u_now;
        status = int32(2);
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
