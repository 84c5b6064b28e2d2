function [u, axes, status] = stage28_step(self, k, x) %#codegen
%STAGE28_STEP u = (A, B) from tick `k`, which may wrap, and state x = (a, b). Where one of them is
%not finite, as at a state at which the inputs do not decouple the outputs, every u is 0; else the
%status is SATURATED where one was clipped.
%
%   [u, axes, status] = stage28_step(self, k, x), with self from stage28_init.
%
%   status (int32); on a negative one what is given is 0, and self is as it was:
%      0  tracking
%      1  hold: time-to-go held at eps, the deadline is near or over, u is valid
%      2  saturated: u clipped to its limits; wins over 1 and 3
%      3  after: the deadline is over, u is 0 or that of the user-defined law
%      4  gated: a reading was not believed, u by prediction alone; wins over all above
%     -2  an argument is not finite, or time lies before the start, or a tick is not whole
%     -3  u not finite

deadbeat_1 = 9.0; % samples to go at which deadbeat takes over
deadbeat_2 = 9.0; % samples to go at which deadbeat takes over
u = zeros(2, 1, 'double');
axes = repmat(int32(-2), 2, 1);
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

% The chain of each output.
x1_1 = x(1);
x1_2 = x(2);
left = self.samples - elapsed;
m0_1 = double(left);
m0_2 = double(left);
if m0_1 > deadbeat_1
    % The exact law in samples.
    z1_1 = self.w1_1_1 * x1_1;
    law_1 = z1_1 / m0_1;
else
    % Deadbeat.
    law_1 = self.b_1_1 * x1_1;
end
if m0_2 > deadbeat_2
    % The exact law in samples.
    z1_2 = self.w1_1_2 * x1_2;
    law_2 = z1_2 / m0_2;
else
    % Deadbeat.
    law_2 = self.b_1_1 * x1_2;
end

% The inputs that give all of them.
v2 = x1_2 - 1.0;
v3 = pick((v2 < 0.0) || (v2 > 0.0), 1.0 / v2, double(NaN));
control1 = law_1 * v3;
control2 = ((-law_1) + (v2 * (law_2 - (self.c1 * x1_1)))) * v3;
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
    if control1 > self.u_max
        u(1) = self.u_max;
        axes(1) = int32(2);
        status = int32(2);
    elseif control1 < -self.u_max
        u(1) = -self.u_max;
        axes(1) = int32(2);
        status = int32(2);
    end
    if control2 > self.u_max
        u(2) = self.u_max;
        axes(2) = int32(2);
        status = int32(2);
    elseif control2 < -self.u_max
        u(2) = -self.u_max;
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
