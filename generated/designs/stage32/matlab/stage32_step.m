function [u, axes, status] = stage32_step(self, k, x) %#codegen
%STAGE32_STEP u = (F1, F2) from tick `k`, which may wrap, and state x = (q1, q2, w1, w2). Where one
%of them is not finite, as at a state at which the inputs do not decouple the outputs, every u is 0;
%else the status is SATURATED where one was clipped.
%
%   [u, axes, status] = stage32_step(self, k, x), with self from stage32_init.
%
%   status (int32); on a negative one what is given is 0, and self is as it was:
%      0  tracking
%      1  hold: time-to-go held at eps, the deadline is near or over, u is valid
%      2  saturated: u clipped to its limits; wins over 1 and 3
%      3  after: the deadline is over, u is 0 or that of the user-defined law
%      4  gated: a reading was not believed, u by prediction alone; wins over all above
%     -2  an argument is not finite, or time lies before the start, or a tick is not whole
%     -3  u not finite

h = 0.01; % 1/100, sample period
samples = uint32(30); % samples from the start to rest
hold = 4.0; % samples to go at which the gains are held
u = zeros(2, 1, 'double');
axes = repmat(int32(-2), 2, 1);
k = double(k);
if ~(isfinite(k) && (k == floor(k)))
    status = int32(-2);
    return;
end
k = uint32(mod(k, 4294967296));
x = double(x);
if ~(isfinite(x(1)) && isfinite(x(2)) && isfinite(x(3)) && isfinite(x(4)))
    status = int32(-2);
    return;
end
elapsed = uint32(mod(double(k) - double(self.start), 4294967296));

% The chain of each output.
x1_1 = x(1);
x2_1 = x(3);
x1_2 = x(2);
x2_2 = x(4);

% The tracking error.
t = double(elapsed) * h;
v_r1 = t * t;
v_r2 = 1.0 + v_r1;
reference0_1 = (self.p_size * v_r1) / v_r2;
reference1_1 = (self.c_r3 * t * (v_r2 - v_r1)) / (v_r2 * v_r2);
v_r4 = t + 0.005;
v_r5 = v_r4 * v_r4;
v_r6 = 1.0 + v_r5;
v_r7 = v_r6 * v_r6;
s1 = (v_r7 + (4.0 * v_r5 * v_r5)) - (4.0 * v_r6 * v_r4 * v_r4);
rho0_1 = (self.c_r3 * (s1 - (v_r6 * v_r5))) / (v_r6 * v_r7);
e1_1 = x1_1 - reference0_1;
e2_1 = x2_1 - reference1_1;
e1_2 = x1_2;
e2_2 = x2_2;
left = samples - elapsed;
m0_1 = pick(double(left) < hold, hold, double(left));

% The exact law in samples.
z1_1 = (self.w1_1_1 * e1_1) + (self.w1_2_1 * e2_1);
z2_1 = self.w2_2_1 * e2_1;
law_1 = ((z1_1 + (z2_1 * m0_1)) / (m0_1 * (m0_1 - 1.0))) + rho0_1;
m0_2 = pick(double(left) < hold, hold, double(left));
z1_2 = (self.w1_1_1 * e1_2) + (self.w1_2_1 * e2_2);
z2_2 = self.w2_2_1 * e2_2;
law_2 = (z1_2 + (z2_2 * m0_2)) / (m0_2 * (m0_2 - 1.0));

% The inputs that give all of them.
s2 = ((self.p_m + (x1_2 * x1_2)) * law_1) + (x1_2 * law_2);
control1 = s2 + (self.p_m * x1_2 * x2_1 * x2_2);
control2 = (x1_2 * law_1) + law_2 + ((x2_1 * x2_1 * 0.5) - x1_1);
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
