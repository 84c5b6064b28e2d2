function [u, axes, status] = table_too_soon_step(self, k, x) %#codegen
%TABLE_TOO_SOON_STEP u of each axis from tick `k`, which may wrap, and the state x = (x1, x1', ...)
%of each. Where one of them is not finite, every u is 0; else the status is SATURATED where one was
%clipped.
%
%   [u, axes, status] = table_too_soon_step(self, k, x), with self from table_too_soon_init.
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

w1_1_1 = -60000000.0; % weight of x1 in the law
w1_2_1 = 600000.0; % weight of x2 in the law
w1_3_1 = -2000.0; % weight of x3 in the law
w2_2_1 = -360000.0; % weight of x2 in the law
w2_3_1 = 1800.0; % weight of x3 in the law
w3_3_1 = -900.0; % weight of x3 in the law
w1_1_2 = -120000000.0; % weight of x1 in the law
w1_2_2 = 1200000.0; % weight of x2 in the law
w1_3_2 = -4000.0; % weight of x3 in the law
w2_2_2 = -600000.0; % weight of x2 in the law
w2_3_2 = 3000.0; % weight of x3 in the law
w3_3_2 = -1200.0; % weight of x3 in the law
u = zeros(2, 1, 'double');
axes = repmat(int32(-2), 2, 1);
k = double(k);
if ~(isfinite(k) && (k == floor(k)))
    status = int32(-2);
    return;
end
k = uint32(mod(k, 4294967296));
x = double(x);
if ~(isfinite(x(1, 1)) ...
    && isfinite(x(1, 2)) ...
    && isfinite(x(1, 3)) ...
    && isfinite(x(2, 1)) ...
    && isfinite(x(2, 2)) ...
    && isfinite(x(2, 3)))
    status = int32(-2);
    return;
end
elapsed = uint32(mod(double(k) - double(self.start), 4294967296));
x1_1 = x(1, 1);
x2_1 = x(1, 2);
x3_1 = x(1, 3);
x1_2 = x(2, 1);
x2_2 = x(2, 2);
x3_2 = x(2, 3);
left = self.last - elapsed;
m0_1 = pick(double(left) < 3.0, 3.0, double(left));

% The exact law in samples.
s1 = (w1_1_1 * x1_1) + (w1_2_1 * x2_1);
z1_1 = s1 + (w1_3_1 * x3_1);
z2_1 = (w2_2_1 * x2_1) + (w2_3_1 * x3_1);
z3_1 = w3_3_1 * x3_1;
m0f_11 = m0_1 + 2.0;
m0f_12 = m0f_11 * (m0_1 + 1.0);
law_1 = (z1_1 + (z2_1 * m0f_11) + (z3_1 * m0f_12)) / (m0f_12 * m0_1);
m0_2 = pick(double(left) < 3.0, 3.0, double(left));
s2 = (w1_1_2 * x1_2) + (w1_2_2 * x2_2);
z1_2 = s2 + (w1_3_2 * x3_2);
z2_2 = (w2_2_2 * x2_2) + (w2_3_2 * x3_2);
z3_2 = w3_3_2 * x3_2;
m0f_21 = m0_2 + 3.0;
m0f_22 = m0f_21 * (m0_2 + 2.0);
s3 = z1_2 + (z2_2 * m0f_21) + (z3_2 * m0f_22);
law_2 = s3 / (m0f_22 * (m0_2 + 1.0));
if elapsed < self.last
    status = int32(0);
else
    status = int32(1);
end
if isfinite(law_1) && isfinite(law_2)
    u(1) = law_1;
    axes(1) = status;
    u(2) = law_2;
    axes(2) = status;
    if law_1 > self.u_max
        u(1) = self.u_max;
        axes(1) = int32(2);
        status = int32(2);
    elseif law_1 < self.u_min
        u(1) = self.u_min;
        axes(1) = int32(2);
        status = int32(2);
    end
    if law_2 > self.u_max
        u(2) = self.u_max;
        axes(2) = int32(2);
        status = int32(2);
    elseif law_2 < self.u_min
        u(2) = self.u_min;
        axes(2) = int32(2);
        status = int32(2);
    end
else
    u(1) = 0.0;
    if isfinite(law_1)
        axes(1) = status;
    else
        axes(1) = int32(-3);
    end
    u(2) = 0.0;
    if isfinite(law_2)
        axes(2) = status;
    else
        axes(2) = int32(-3);
    end
    status = int32(-3);
end
end

function r = pick(condition, yes, no)
if condition
    r = yes;
else
    r = no;
end
end
