function [u, status] = stage8_step(self, k, x) %#codegen
%STAGE8_STEP u from tick `k`, which may wrap, and the state x = (x1, x1', ...).
%
%   [u, status] = stage8_step(self, k, x), with self from stage8_init.
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
hold = 5.0; % samples to go at which the gains are held
w1_1 = -20000000.0; % weight of x1 in the law
w1_2 = 10000.0; % weight of x2 in the law
w2_2 = -8000.0; % weight of x2 in the law
u_max = 3.0; % bound of |u|
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
x1 = x(1);
x2 = x(2);
left = samples - elapsed;
m0 = pick(double(left) < hold, hold, double(left));

% The exact law in samples.
z1 = (w1_1 * x1) + (w1_2 * x2);
z2 = w2_2 * x2;
m0f1 = m0 + 3.0;
v = (z1 + (z2 * m0f1)) / (m0f1 * (m0 + 2.0));
if isfinite(v)
    if elapsed < samples
        if v > u_max
            u = u_max;
            status = int32(2);
        elseif v < -u_max
            u = -u_max;
            status = int32(2);
        elseif double(left) <= hold
            u = v;
            status = int32(1);
        else
            u = v;
            status = int32(0);
        end
    else
        u = 0.0;
        status = int32(3);
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
