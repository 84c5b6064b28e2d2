function [u, axes, status] = stage34_step(self, k, x, r) %#codegen
%STAGE34_STEP u of each axis from tick `k`, which may wrap, and the state x = (x1, x1', ...) and the
%reference r of each. Where one of them is not finite, every u is 0; else the status is SATURATED
%where one was clipped.
%
%   [u, axes, status] = stage34_step(self, k, x, r), with self from stage34_init.
%
%   status (int32); on a negative one what is given is 0, and self is as it was:
%      0  tracking
%      1  hold: time-to-go held at eps, the deadline is near or over, u is valid
%      2  saturated: u clipped to its limits; wins over 1 and 3
%      3  after: the deadline is over, u is 0 or that of the user-defined law
%      4  gated: a reading was not believed, u by prediction alone; wins over all above
%     -2  an argument is not finite, or time lies before the start, or a tick is not whole
%     -3  u not finite

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
elapsed = uint32(mod(double(k) - double(self.start), 4294967296));
x1_1 = x(1, 1);
x2_1 = x(1, 2);
x3_1 = x(1, 3);
x1_2 = x(2, 1);
x2_2 = x(2, 2);
x3_2 = x(2, 3);

% The tracking error.
e1_1 = x1_1 - r(1, 1);
e2_1 = x2_1 - r(1, 2);
e3_1 = x3_1 - r(1, 3);
e1_2 = x1_2 - r(2, 1);
e2_2 = x2_2 - r(2, 2);
e3_2 = x3_2 - r(2, 3);
left = self.samples - elapsed;
m0_1 = double(left);
m0_2 = double(left);
if m0_1 > self.deadbeat_1
    % The exact law in samples.
    s1 = (self.w1_1_1 * e1_1) + (self.w1_2_1 * e2_1);
    z1_1 = s1 + (self.w1_3_1 * e3_1);
    z2_1 = (self.w2_2_1 * e2_1) + (self.w2_3_1 * e3_1);
    z3_1 = self.w3_3_1 * e3_1;
    m0f_12 = m0_1 * (m0_1 - 1.0);
    s2 = (z1_1 + (z2_1 * m0_1) + (z3_1 * m0f_12)) / (m0f_12 * (m0_1 - 2.0));
    law_1 = s2 + (0.3333333333333333 * r(1, 4));
else
    % Deadbeat.
    s3 = (self.b_1_1 * e1_1) + (self.b_2_1 * e2_1);
    law_1 = s3 + (self.b_3_1 * e3_1) + (0.3333333333333333 * r(1, 4));
end
if m0_2 > self.deadbeat_1
    % The exact law in samples.
    s4 = (self.w1_1_1 * e1_2) + (self.w1_2_1 * e2_2);
    z1_2 = s4 + (self.w1_3_1 * e3_2);
    z2_2 = (self.w2_2_1 * e2_2) + (self.w2_3_1 * e3_2);
    z3_2 = self.w3_3_1 * e3_2;
    m0f_22 = m0_2 * (m0_2 - 1.0);
    s5 = (z1_2 + (z2_2 * m0_2) + (z3_2 * m0f_22)) / (m0f_22 * (m0_2 - 2.0));
    law_2 = s5 + (0.3333333333333333 * r(2, 4));
else
    % Deadbeat.
    s6 = (self.b_1_1 * e1_2) + (self.b_2_1 * e2_2);
    law_2 = s6 + (self.b_3_1 * e3_2) + (0.3333333333333333 * r(2, 4));
end
if elapsed < self.samples
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
