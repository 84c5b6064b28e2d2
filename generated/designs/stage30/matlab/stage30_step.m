function [u, axes, status] = stage30_step(self, k, x) %#codegen
%STAGE30_STEP u of each axis from tick `k`, which may wrap, and the state x = (x1, x1', ...) of
%each. Where one of them is not finite, every u is 0; else the status is SATURATED where one was
%clipped.
%
%   [u, axes, status] = stage30_step(self, k, x), with self from stage30_init.
%
%   status (int32); on a negative one what is given is 0, and self is as it was:
%      0  tracking
%      1  hold: time-to-go held at eps, the deadline is near or over, u is valid
%      2  saturated: u clipped to its limits; wins over 1 and 3
%      3  after: the deadline is over, u is 0 or that of the user-defined law
%      4  gated: a reading was not believed, u by prediction alone; wins over all above
%     -2  an argument is not finite, or time lies before the start, or a tick is not whole
%     -3  u not finite

deadbeat_1 = single(2.5); % 5/2, samples to go at which deadbeat takes over
deadbeat_2 = single(2.5); % 5/2, samples to go at which deadbeat takes over
u = zeros(2, 1, 'single');
axes = repmat(int32(-2), 2, 1);
k = double(k);
if ~(isfinite(k) && (k == floor(k)))
    status = int32(-2);
    return;
end
k = uint32(mod(k, 4294967296));
x = single(x);
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
left = self.samples - elapsed;
m0_1 = pick(single(left) < self.hold, self.hold, single(left));
m0_2 = pick(single(left) < self.hold, self.hold, single(left));
if m0_1 > deadbeat_1
    % The exact law in samples.
    s1 = (self.w1_1_1 * x1_1) + (self.w1_2_1 * x2_1);
    z1_1 = s1 + (self.w1_3_1 * x3_1);
    z2_1 = (self.w2_2_1 * x2_1) + (self.w2_3_1 * x3_1);
    z3_1 = self.w3_3_1 * x3_1;
    law_1 = ((((z1_1 / m0_1) + z2_1) / (m0_1 - single(1.0))) + z3_1) / (m0_1 - single(2.0));
else
    % Deadbeat.
    s2 = (self.b_1_1 * x1_1) + (self.b_2_1 * x2_1);
    law_1 = s2 + (self.b_3_1 * x3_1);
end
if m0_2 > deadbeat_2
    % The exact law in samples.
    s3 = (self.w1_1_1 * x1_2) + (self.w1_2_1 * x2_2);
    z1_2 = s3 + (self.w1_3_1 * x3_2);
    z2_2 = (self.w2_2_1 * x2_2) + (self.w2_3_1 * x3_2);
    z3_2 = self.w3_3_1 * x3_2;
    law_2 = ((((z1_2 / m0_2) + z2_2) / (m0_2 - single(1.0))) + z3_2) / (m0_2 - single(2.0));
else
    % Deadbeat.
    s4 = (self.b_1_1 * x1_2) + (self.b_2_1 * x2_2);
    law_2 = s4 + (self.b_3_1 * x3_2);
end
if single(left) > self.hold
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
    elseif law_1 < -self.u_max
        u(1) = -self.u_max;
        axes(1) = int32(2);
        status = int32(2);
    end
    if law_2 > self.u_max
        u(2) = self.u_max;
        axes(2) = int32(2);
        status = int32(2);
    elseif law_2 < -self.u_max
        u(2) = -self.u_max;
        axes(2) = int32(2);
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
