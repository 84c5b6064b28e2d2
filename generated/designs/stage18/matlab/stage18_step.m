function [u, status] = stage18_step(self, k, x) %#codegen
%STAGE18_STEP u from tick `k`, which may wrap, and the state x of the model.
%
%   [u, status] = stage18_step(self, k, x), with self from stage18_init.
%
%   status (int32); on a negative one what is given is 0, and self is as it was:
%      0  tracking
%      1  hold: time-to-go held at eps, the deadline is near or over, u is valid
%      2  saturated: u clipped to its limits; wins over 1 and 3
%      3  after: the deadline is over, u is 0 or that of the user-defined law
%      4  gated: a reading was not believed, u by prediction alone; wins over all above
%     -2  an argument is not finite, or time lies before the start, or a tick is not whole
%     -3  u not finite

w1_1 = -120000.0; % weight of x1 in the law
w1_2 = 600.0; % weight of x2 in the law
w2_2 = -600.0; % weight of x2 in the law
samples = uint32(30); % samples from the start to rest
u = 0.0;
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

% The chain of the output.
v1 = x(1) * x(1);
v2 = x(1) * v1;
x1 = x(1) + (v2 * 0.16666666666666666);
v3 = 2.0 + v1;
x2 = x(2) * v3 * 0.5;

% The exact law in samples.
m0 = pick(elapsed < uint32(26), double(uint32(mod(double(uint32(30)) - double(elapsed), 4294967296))), 4.0);
z1 = (w1_1 * x1) + (w1_2 * x2);
z2 = w2_2 * x2;
w = (z1 + (z2 * m0)) / (m0 * (m0 - 1.0));
s1 = (-((self.p_k * v2) + (3.0 * x(2)))) * v3;
v = (w - ((s1 + (x(2) * (2.0 * x(1) * x(2)))) * 0.5)) * 2.0;
if isfinite(v)
    if v > self.u_max
        u = self.u_max;
        status = int32(2);
    elseif v < -self.u_max
        u = -self.u_max;
        status = int32(2);
    elseif elapsed < samples
        u = v;
        status = int32(0);
    else
        u = v;
        status = int32(1);
    end
else
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
