function [u, axes, status] = stage25_step(self, k, x) %#codegen
%STAGE25_STEP u = (q, p) from tick `k`, which may wrap, and state x = (h, c, e). Where one of them
%is not finite, as at a state at which the inputs do not decouple the outputs, every u is 0; else
%the status is SATURATED where one was clipped.
%
%   [u, axes, status] = stage25_step(self, k, x), with self from stage25_init.
%
%   status (int32); on a negative one what is given is 0, and self is as it was:
%      0  tracking
%      1  hold: time-to-go held at eps, the deadline is near or over, u is valid
%      2  saturated: u clipped to its limits; wins over 1 and 3
%      3  after: the deadline is over, u is 0 or that of the user-defined law
%      4  gated: a reading was not believed, u by prediction alone; wins over all above
%     -2  an argument is not finite, or time lies before the start, or a tick is not whole
%     -3  u not finite

samples = uint32(30); % samples from the start to rest
hold = 4.0; % samples to go at which the gains are held
w1_1_1 = -400.0; % weight of x1 in the law
end_samples_2 = 6.0; % samples to go at which the law of the end takes over
w1_1_2 = -135000.0; % weight of x1 in the law
w1_2_2 = 675.0; % weight of x2 in the law
w2_2_2 = -650.0; % weight of x2 in the law
end1_1_2 = -120000.0; % weight of x1 in the law
end1_2_2 = 600.0; % weight of x2 in the law
end2_2_2 = -600.0; % weight of x2 in the law
u = zeros(2, 1, 'double');
axes = repmat(int32(-2), 2, 1);
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

% The chain of each output.
x1_1 = x(1);
x1_2 = x(3);
v1 = x(2) - x1_2;
v2 = 1.0 + x1_1;
x2_2 = v1 * v2;
left = samples - elapsed;
s1 = double(left) - 1.0;
m0_1 = pick(s1 < hold, hold, s1);

% The exact law in samples.
z1_1 = w1_1_1 * x1_1;
law_1 = z1_1 / (m0_1 + 3.0);
s2 = double(left) - 2.0;
m0_2 = pick(s2 < hold, hold, s2);
if m0_2 > end_samples_2
    % The exact law in samples.
    z1_2 = (w1_1_2 * x1_2) + (w1_2_2 * x2_2);
    z2_2 = w2_2_2 * x2_2;
    law_2 = (z1_2 + (z2_2 * m0_2)) / (m0_2 * (m0_2 - 1.0));
else
    % The law of least energy to the end.
    m1_2 = pick(m0_2 < 2.0, 2.0, m0_2);
    y1_2 = (end1_1_2 * x1_2) + (end1_2_2 * x2_2);
    y2_2 = end2_2_2 * x2_2;
    m1f_21 = m1_2 + 2.0;
    law_2 = (y1_2 + (y2_2 * m1f_21)) / (m1f_21 * (m1_2 + 1.0));
end

% The inputs that give all of them.
v3 = (-x1_1) * 0.1;
v4 = law_1 - v3;
v5 = pick((v2 < 0.0) || (v2 > 0.0), 1.0 / v2, double(NaN));
control1 = v2 * v4 * v5;
s3 = ((-v1) * v4) + (law_2 - (((((-x(2)) * v2) - x2_2) * v2) + (v1 * v3)));
control2 = s3 * v5;
if double(left) > hold
    status = int32(0);
else
    status = int32(1);
end
if isfinite(control1) && isfinite(control2)
    u(1) = control1;
    axes(1) = status;
    u(2) = control2;
    axes(2) = status;
    if control1 > 2.0
        u(1) = 2.0;
        axes(1) = int32(2);
        status = int32(2);
    elseif control1 < -2.0
        u(1) = -2.0;
        axes(1) = int32(2);
        status = int32(2);
    end
    if control2 > 3.0
        u(2) = 3.0;
        axes(2) = int32(2);
        status = int32(2);
    elseif control2 < -3.0
        u(2) = -3.0;
        axes(2) = int32(2);
        status = int32(2);
    end
else
    u(1) = 0.0;
    if isfinite(control1)
        axes(1) = status;
    else
        axes(1) = int32(-3);
    end
    u(2) = 0.0;
    if isfinite(control2)
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
