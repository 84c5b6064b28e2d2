function [u, status] = stage2_step(self, k, x) %#codegen
%STAGE2_STEP u from tick `k`, which may wrap, and the state x = (x1, x1', ...).
%
%   [u, status] = stage2_step(self, k, x), with self from stage2_init.
%
%   status (int32); on a negative one what is given is 0, and self is as it was:
%      0  tracking
%      1  hold: time-to-go held at eps, the deadline is near or over, u is valid
%      2  saturated: u clipped to its limits; wins over 1 and 3
%      3  after: the deadline is over, u is 0 or that of the user-defined law
%      4  gated: a reading was not believed, u by prediction alone; wins over all above
%     -2  an argument is not finite, or time lies before the start, or a tick is not whole
%     -3  u not finite

w1_1 = -120000000000.0; % weight of x1 in the law
w1_2 = 120000000.0; % weight of x2 in the law
w1_3 = -40000.0; % weight of x3 in the law
w2_2 = -60000000.0; % weight of x2 in the law
w2_3 = 30000.0; % weight of x3 in the law
w3_3 = -12000.0; % weight of x3 in the law
samples = uint32(20); % samples from the start to rest
u = 0.0;
k = double(k);
if ~(isfinite(k) && (k == floor(k)))
    status = int32(-2);
    return;
end
k = uint32(mod(k, 4294967296));
x = double(x);
elapsed = uint32(mod(double(k) - double(self.start), 4294967296));
x1 = x(1);
x2 = x(2);
x3 = x(3);

% The exact law in samples.
m0 = pick(elapsed < uint32(17), double(uint32(mod(double(uint32(23)) - double(elapsed), 4294967296))), 6.0);
z1 = (w1_1 * x1) + (w1_2 * x2) + (w1_3 * x3);
z2 = (w2_2 * x2) + (w2_3 * x3);
z3 = w3_3 * x3;
m0f2 = m0 * (m0 - 1.0);
v = (z1 + (z2 * m0) + (z3 * m0f2)) / (m0f2 * (m0 - 2.0));
if isfinite(v)
    if elapsed < samples
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
