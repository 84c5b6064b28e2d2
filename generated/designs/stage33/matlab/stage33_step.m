function [u, axes, status] = stage33_step(self, k, x) %#codegen
%STAGE33_STEP u of each axis from tick `k`, which may wrap, and the state x = (x1, x1', ...) of
%each. Where one of them is not finite, every u is 0; else the status is SATURATED where one was
%clipped.
%
%   [u, axes, status] = stage33_step(self, k, x), with self from stage33_init.
%
%   status (int32); on a negative one what is given is 0, and self is as it was:
%      0  tracking
%      1  hold: time-to-go held at eps, the deadline is near or over, u is valid
%      2  saturated: u clipped to its limits; wins over 1 and 3
%      3  after: the deadline is over, u is 0 or that of the user-defined law
%      4  gated: a reading was not believed, u by prediction alone; wins over all above
%     -2  an argument is not finite, or time lies before the start, or a tick is not whole
%     -3  u not finite

h = single(0.009999999776482582); % 1/100, sample period
w1_1_1 = -single(400000.0); % weight of x1 in the law
w1_2_1 = single(2000.0); % weight of x2 in the law
w2_2_1 = -single(1600.0); % weight of x2 in the law
w1_1_2 = -single(50000.0); % weight of x1 in the law
w1_2_2 = single(250.0); % weight of x2 in the law
w2_2_2 = -single(250.0); % weight of x2 in the law
end1_1_2 = -single(60000.0); % weight of x1 in the law
end1_2_2 = single(300.0); % weight of x2 in the law
end2_2_2 = -single(300.0); % weight of x2 in the law
w1_1_3 = single(450000.0); % weight of x1 in the law
w1_2_3 = -single(2250.0); % weight of x2 in the law
w2_2_3 = single(1250.0); % weight of x2 in the law
end1_1_3 = single(420000.0); % weight of x1 in the law
end1_2_3 = -single(2100.0); % weight of x2 in the law
end2_2_3 = single(1200.0); % weight of x2 in the law
u = zeros(3, 1, 'single');
axes = repmat(int32(-2), 3, 1);
k = double(k);
if ~(isfinite(k) && (k == floor(k)))
    status = int32(-2);
    return;
end
k = uint32(mod(k, 4294967296));
x = single(x);
if ~(isfinite(x(1, 1)) ...
    && isfinite(x(1, 2)) ...
    && isfinite(x(2, 1)) ...
    && isfinite(x(2, 2)) ...
    && isfinite(x(3, 1)) ...
    && isfinite(x(3, 2)))
    status = int32(-2);
    return;
end
elapsed = uint32(mod(double(k) - double(self.start), 4294967296));
x1_1 = x(1, 1);
x2_1 = x(1, 2);
x1_2 = x(2, 1);
x2_2 = x(2, 2);
x1_3 = x(3, 1);
x2_3 = x(3, 2);

% The tracking error.
t = single(elapsed) * h;
v_r1 = t * t;
v_r2 = single(2.0) + v_r1;
reference0_1 = single(1.0) / v_r2;
v_r3 = v_r2 * v_r2;
reference1_1 = ((-single(2.0)) * t) / v_r3;
v_r4 = t + single(0.004999999888241291);
v_r5 = v_r4 * v_r4;
v_r6 = single(2.0) + v_r5;
v_r7 = v_r6 * v_r6;
v_r8 = v_r6 * v_r7;
rho0_1 = (single(2.0) * ((single(4.0) * v_r5) - v_r6)) / v_r8;
v_r9 = single(3.0) + t;
reference0_2 = (self.p_size * t) / v_r9;
reference1_2 = (self.p_size * (v_r9 - t)) / (v_r9 * v_r9);
v_r11 = single(3.0) + v_r4;
rho0_2 = (self.c_r10 * (v_r4 - v_r11)) / (v_r11 * (v_r11 * v_r11));
reference0_3 = v_r1 / v_r2;
reference1_3 = (single(2.0) * t * (v_r2 - v_r1)) / v_r3;
rho0_3 = (single(2.0) * ((v_r7 + (single(4.0) * (v_r5 * v_r5))) - (single(5.0) * v_r6 * v_r5))) / v_r8;
e1_1 = x1_1 - reference0_1;
e2_1 = x2_1 - reference1_1;
e1_2 = x1_2 - reference0_2;
e2_2 = x2_2 - reference1_2;
e1_3 = x1_3 - reference0_3;
e2_3 = x2_3 - reference1_3;

% The exact law in samples.
m0_1 = pick(elapsed < uint32(28), single(uint32(mod(double(uint32(33)) - double(elapsed), 4294967296))), single(5.0));
z1_1 = (w1_1_1 * e1_1) + (w1_2_1 * e2_1);
z2_1 = w2_2_1 * e2_1;
law_1 = ((z1_1 + (z2_1 * m0_1)) / (m0_1 * (m0_1 - single(1.0)))) + (single(2.0) * rho0_1);
if elapsed < uint32(26)
    % The exact law in samples.
    m0_2 = single(uint32(mod(double(uint32(30)) - double(elapsed), 4294967296)));
    z1_2 = (w1_1_2 * e1_2) + (w1_2_2 * e2_2);
    z2_2 = w2_2_2 * e2_2;
    law_2 = ((z1_2 + (z2_2 * m0_2)) / (m0_2 * (m0_2 - single(1.0)))) + (single(0.5) * rho0_2);
else
    % The law of least energy to the end.
    m1_2 = pick(elapsed < uint32(28), single(uint32(mod(double(uint32(32)) - double(elapsed), 4294967296))), single(4.0));
    y1_2 = (end1_1_2 * e1_2) + (end1_2_2 * e2_2);
    y2_2 = end2_2_2 * e2_2;
    law_2 = ((y1_2 + (y2_2 * m1_2)) / (m1_2 * (m1_2 - single(1.0)))) + (single(0.5) * rho0_2);
end
if elapsed < uint32(21)
    % The exact law in samples.
    m0_3 = single(uint32(mod(double(uint32(30)) - double(elapsed), 4294967296)));
    z1_3 = (w1_1_3 * e1_3) + (w1_2_3 * e2_3);
    z2_3 = w2_2_3 * e2_3;
    law_3 = ((z1_3 + (z2_3 * m0_3)) / (m0_3 * (m0_3 - single(1.0)))) - rho0_3;
else
    % The law of least energy to the end.
    m1_3 = pick(elapsed < uint32(28), single(uint32(mod(double(uint32(35)) - double(elapsed), 4294967296))), single(7.0));
    y1_3 = (end1_1_3 * e1_3) + (end1_2_3 * e2_3);
    y2_3 = end2_2_3 * e2_3;
    law_3 = ((y1_3 + (y2_3 * m1_3)) / (m1_3 * (m1_3 - single(1.0)))) - rho0_3;
end
if elapsed < uint32(30)
    status = int32(0);
else
    status = int32(1);
end
if isfinite(law_1) && isfinite(law_2) && isfinite(law_3)
    u(1) = law_1;
    axes(1) = status;
    u(2) = law_2;
    axes(2) = status;
    u(3) = law_3;
    axes(3) = status;
    if law_1 > single(1.0)
        u(1) = single(1.0);
        axes(1) = int32(2);
        status = int32(2);
    elseif law_1 < -single(1.0)
        u(1) = -single(1.0);
        axes(1) = int32(2);
        status = int32(2);
    end
    if law_2 > single(2.0)
        u(2) = single(2.0);
        axes(2) = int32(2);
        status = int32(2);
    elseif law_2 < -single(2.0)
        u(2) = -single(2.0);
        axes(2) = int32(2);
        status = int32(2);
    end
    if law_3 > single(3.0)
        u(3) = single(3.0);
        axes(3) = int32(2);
        status = int32(2);
    elseif law_3 < -single(3.0)
        u(3) = -single(3.0);
        axes(3) = int32(2);
        status = int32(2);
    end
else
    u(1) = single(0.0);
    if isfinite(law_1)
        axes(1) = status;
    else
        axes(1) = int32(-3);
    end
    u(2) = single(0.0);
    if isfinite(law_2)
        axes(2) = status;
    else
        axes(2) = int32(-3);
    end
    u(3) = single(0.0);
    if isfinite(law_3)
        axes(3) = status;
    else
        axes(3) = int32(-3);
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
