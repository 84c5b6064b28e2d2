function [u, axes, status] = stage35_step(self, k, x) %#codegen
%STAGE35_STEP u = (F, V) from tick `k`, which may wrap, and state x = (s, v, i). Where one of them
%is not finite, as at a state at which the inputs do not decouple the outputs, every u is 0; else
%the status is SATURATED where one was clipped.
%
%   [u, axes, status] = stage35_step(self, k, x), with self from stage35_init.
%
%   status (int32); on a negative one what is given is 0, and self is as it was:
%      0  tracking
%      1  hold: time-to-go held at eps, the deadline is near or over, u is valid
%      2  saturated: u clipped to its limits; wins over 1 and 3
%      3  after: the deadline is over, u is 0 or that of the user-defined law
%      4  gated: a reading was not believed, u by prediction alone; wins over all above
%     -2  an argument is not finite, or time lies before the start, or a tick is not whole
%     -3  u not finite

w1_1_1 = -120000.0; % weight of x1 in the law
w1_2_1 = 600.0; % weight of x2 in the law
w2_2_1 = -600.0; % weight of x2 in the law
w1_1_2 = -400.0; % weight of x1 in the law
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

% The chain of each output as it is sampled.
x1_2 = x(3);
s1 = x(1) + ((-4.16676736285295e-6) * x(2));
x1_1 = s1 + (2.499973960459077e-5 * x1_2);
x2_1 = 1.0000166669696244 * x(2);

% The exact law in samples.
m0_1 = pick(elapsed < uint32(28), double(uint32(mod(double(uint32(32)) - double(elapsed), 4294967296))), 4.0);
z1_1 = (w1_1_1 * x1_1) + (w1_2_1 * x2_1);
z2_1 = w2_2_1 * x2_1;
law_1 = (z1_1 + (z2_1 * m0_1)) / (m0_1 * (m0_1 - 1.0));
m0_2 = pick(elapsed < uint32(29), double(uint32(mod(double(uint32(33)) - double(elapsed), 4294967296))), 4.0);
z1_2 = w1_1_2 * x1_2;
law_2 = z1_2 / m0_2;

% The inputs that give all of them.
s2 = ((-1.993127946172519) * x(1)) + ((-0.5087209499488312) * x(2));
v1 = law_1 - (s2 + (2.9333536080559304 * x1_2));
s3 = (0.12252888444119461 * x(1)) + (0.0006157089861155933 * x(2));
v2 = law_2 - (s3 + ((-3.921049966023507) * x1_2));
control1 = (1.002518807547881 * v1) + ((-0.015112747669367257) * v2);
control2 = ((-2.106833310985952e-6) * v1) + (1.0201333455511812 * v2);
if elapsed < uint32(30)
    status = int32(0);
else
    status = int32(1);
end
if isfinite(control1) && isfinite(control2)
    u(1) = control1;
    axes(1) = status;
    u(2) = control2;
    axes(2) = status;
    if control1 > 20.0
        u(1) = 20.0;
        axes(1) = int32(2);
        status = int32(2);
    elseif control1 < -20.0
        u(1) = -20.0;
        axes(1) = int32(2);
        status = int32(2);
    end
    if control2 > 30.0
        u(2) = 30.0;
        axes(2) = int32(2);
        status = int32(2);
    elseif control2 < -30.0
        u(2) = -30.0;
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
