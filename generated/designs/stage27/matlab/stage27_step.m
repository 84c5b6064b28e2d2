function [u, axes, status] = stage27_step(self, k, x) %#codegen
%STAGE27_STEP u = (A, B, C, D) from tick `k`, which may wrap, and state x = (a, b, b1, c, d, d1).
%Where one of them is not finite, as at a state at which the inputs do not decouple the outputs,
%every u is 0; else the status is SATURATED where one was clipped.
%
%   [u, axes, status] = stage27_step(self, k, x), with self from stage27_init.
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
end_samples_3 = 7.0; % samples to go at which the law of the end takes over
end_samples_4 = 9.0; % samples to go at which the law of the end takes over
u = zeros(4, 1, 'double');
axes = repmat(int32(-2), 4, 1);
k = double(k);
if ~(isfinite(k) && (k == floor(k)))
    status = int32(-2);
    return;
end
k = uint32(mod(k, 4294967296));
x = double(x);
if ~(isfinite(x(1)) ...
    && isfinite(x(2)) ...
    && isfinite(x(3)) ...
    && isfinite(x(4)) ...
    && isfinite(x(5)) ...
    && isfinite(x(6)))
    status = int32(-2);
    return;
end
elapsed = uint32(mod(double(k) - double(self.start), 4294967296));

% The chain of each output.
x1_1 = x(1);
x1_2 = x(2);
x2_2 = x(3);
x1_3 = x(4);
x1_4 = x(5);
x2_4 = x(6);
left = self.samples - elapsed;
s1 = double(left) - 1.0;
m0_1 = pick(s1 < 1.0, 1.0, s1);

% The exact law in samples.
z1_1 = self.w1_1_1 * x1_1;
law_1 = z1_1 / (m0_1 + 4.0);
m0_2 = double(left) - 2.0;
m0_3 = double(left) - 1.0;
m0_4 = double(left) - 2.0;
if m0_2 > end_samples_2
    % The exact law in samples.
    z1_2 = (self.w1_1_2 * x1_2) + (self.w1_2_2 * x2_2);
    z2_2 = self.w2_2_2 * x2_2;
    law_2 = (z1_2 + (z2_2 * m0_2)) / (m0_2 * (m0_2 - 1.0));
else
    % The law of least energy to the end.
    m1_2 = pick(m0_2 < 2.0, 2.0, m0_2);
    y1_2 = (self.end1_1_2 * x1_2) + (self.end1_2_2 * x2_2);
    y2_2 = self.end2_2_2 * x2_2;
    m1f_21 = m1_2 + 3.0;
    law_2 = (y1_2 + (y2_2 * m1f_21)) / (m1f_21 * (m1_2 + 2.0));
end
if m0_3 > end_samples_3
    % The exact law in samples.
    z1_3 = self.w1_1_3 * x1_3;
    law_3 = z1_3 / m0_3;
else
    % The law of least energy to the end.
    m1_3 = pick(m0_3 < 1.0, 1.0, m0_3);
    y1_3 = self.end1_1_3 * x1_3;
    law_3 = y1_3 / (m1_3 + 6.0);
end
if m0_4 > end_samples_4
    % The exact law in samples.
    z1_4 = (self.w1_1_4 * x1_4) + (self.w1_2_4 * x2_4);
    z2_4 = self.w2_2_4 * x2_4;
    law_4 = (z1_4 + (z2_4 * m0_4)) / (m0_4 * (m0_4 - 1.0));
else
    % The law of least energy to the end.
    m1_4 = pick(m0_4 < 2.0, 2.0, m0_4);
    y1_4 = (self.end1_1_2 * x1_4) + (self.end1_2_2 * x2_4);
    y2_4 = self.end2_2_2 * x2_4;
    m1f_41 = m1_4 + 3.0;
    law_4 = (y1_4 + (y2_4 * m1f_41)) / (m1f_41 * (m1_4 + 2.0));
end

% The inputs that give all of them.
v1 = eliminate([law_1 - ((-x1_1) * x1_3), law_2 - ((-x1_2) * x2_4), law_3 - (-(x1_3 * x1_3)), law_4 - x1_1], [2.0 + (x1_2 * x1_2), 1.0, 0.0, 0.0, 0.0, 3.0 + x1_1, x1_4, 0.0, 0.0, 0.0, 1.0, x1_1, x1_3, 0.0, 0.0, 2.0 - x1_2]);
control1 = v1(1);
control2 = v1(2);
control3 = v1(3);
control4 = v1(4);
if elapsed < self.samples
    status = int32(0);
else
    status = int32(1);
end
if isfinite(control1) && isfinite(control2) && isfinite(control3) && isfinite(control4)
    u(1) = control1;
    axes(1) = status;
    u(2) = control2;
    axes(2) = status;
    u(3) = control3;
    axes(3) = status;
    u(4) = control4;
    axes(4) = status;
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
    u(3) = 0.0;
    if isfinite(control3)
        axes(3) = status;
    else
        axes(3) = int32(-3);
    end
    u(4) = 0.0;
    if isfinite(control4)
        axes(4) = status;
    else
        axes(4) = int32(-3);
    end
    status = int32(-3);
end
end

% Solves a x = b, with a row by row, by elimination with the largest pivot of each column: b becomes
% x, NaN where a is singular.
function b = eliminate(b, a)
    for k = 0:3
        most = k;
        largest = abs(a((4 * k) + k + 1));
        for i = (k + 1):3
            size = abs(a((4 * i) + k + 1));
            if largest < size
                largest = size;
                most = i;
            end
        end
        for i = (k + 1):3
            if most == i
                kept = b(k + 1);
                b(k + 1) = b(i + 1);
                b(i + 1) = kept;
                for j = k:3
                    entry = a((4 * k) + j + 1);
                    a((4 * k) + j + 1) = a((4 * i) + j + 1);
                    a((4 * i) + j + 1) = entry;
                end
            end
        end
        a((4 * k) + k + 1) = pick((a((4 * k) + k + 1) < 0.0) || (a((4 * k) + k + 1) > 0.0), a((4 * k) + k + 1), double(NaN));
        for i = (k + 1):3
            factor = a((4 * i) + k + 1) / a((4 * k) + k + 1);
            for j = (k + 1):3
                a((4 * i) + j + 1) = a((4 * i) + j + 1) - (factor * a((4 * k) + j + 1));
            end
            b(i + 1) = b(i + 1) - (factor * b(k + 1));
        end
    end
    for k = 3:-1:0
        for j = (k + 1):3
            b(k + 1) = b(k + 1) - (a((4 * k) + j + 1) * b(j + 1));
        end
        b(k + 1) = b(k + 1) / a((4 * k) + k + 1);
    end
end

function r = pick(condition, yes, no)
if condition
    r = yes;
else
    r = no;
end
end
