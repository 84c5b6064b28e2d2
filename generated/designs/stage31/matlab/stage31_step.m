function [u, axes, status] = stage31_step(self, k, x, r) %#codegen
%STAGE31_STEP u = (q, p) from tick `k`, which may wrap, state x = (h, c, e) and the reference r of
%each output. Where one of them is not finite, as at a state at which the inputs do not decouple the
%outputs, every u is 0; else the status is SATURATED where one was clipped.
%
%   [u, axes, status] = stage31_step(self, k, x, r), with self from stage31_init.
%
%   status (int32); on a negative one what is given is 0, and self is as it was:
%      0  tracking
%      1  hold: time-to-go held at eps, the deadline is near or over, u is valid
%      2  saturated: u clipped to its limits; wins over 1 and 3
%      3  after: the deadline is over, u is 0 or that of the user-defined law
%      4  gated: a reading was not believed, u by prediction alone; wins over all above
%     -2  an argument is not finite, or time lies before the start, or a tick is not whole
%     -3  u not finite

end_samples_2 = 6.0; % samples to go at which the law of the end takes over
u = zeros(2, 1, 'double');
axes = repmat(int32(-2), 2, 1);
k = double(k);
if ~(isfinite(k) && (k == floor(k)))
    status = int32(-2);
    return;
end
k = uint32(mod(k, 4294967296));
x = double(x);
r = double(r);
if ~(isfinite(x(1)) ...
    && isfinite(x(2)) ...
    && isfinite(x(3)) ...
    && isfinite(r(1, 1)) ...
    && isfinite(r(1, 2)) ...
    && isfinite(r(2, 1)) ...
    && isfinite(r(2, 2)) ...
    && isfinite(r(2, 3)))
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

% The tracking error.
e1_1 = x1_1 - r(1, 1);
e1_2 = x1_2 - r(2, 1);
e2_2 = x2_2 - r(2, 2);
left = self.samples - elapsed;
s1 = double(left) - 1.0;
m0_1 = pick(s1 < 1.0, 1.0, s1);

% The exact law in samples.
z1_1 = self.w1_1_1 * e1_1;
law_1 = (z1_1 / (m0_1 + 3.0)) + r(1, 2);
m0_2 = double(left) - 2.0;
if m0_2 > end_samples_2
    % The exact law in samples.
    z1_2 = (self.w1_1_2 * e1_2) + (self.w1_2_2 * e2_2);
    z2_2 = self.w2_2_2 * e2_2;
    law_2 = ((z1_2 + (z2_2 * m0_2)) / (m0_2 * (m0_2 - 1.0))) + r(2, 3);
else
    % The law of least energy to the end.
    m1_2 = pick(m0_2 < 2.0, 2.0, m0_2);
    y1_2 = (self.end1_1_2 * e1_2) + (self.end1_2_2 * e2_2);
    y2_2 = self.end2_2_2 * e2_2;
    m1f_21 = m1_2 + 2.0;
    law_2 = ((y1_2 + (y2_2 * m1f_21)) / (m1f_21 * (m1_2 + 1.0))) + r(2, 3);
end

% The inputs that give all of them.
v3 = (-x1_1) * 0.1;
v4 = law_1 - v3;
v5 = pick((v2 < 0.0) || (v2 > 0.0), 1.0 / v2, double(NaN));
control1 = v2 * v4 * v5;
s2 = ((-v1) * v4) + (law_2 - (((((-x(2)) * v2) - x2_2) * v2) + (v1 * v3)));
control2 = s2 * v5;
if elapsed < self.samples
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
