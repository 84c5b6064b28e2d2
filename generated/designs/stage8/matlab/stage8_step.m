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
left = uint32(30) - elapsed;
m0 = pick(double(left) < 5.0, 5.0, double(left));

% The exact law in samples.
z1 = ((-20000000.0) * x1) + (10000.0 * x2);
z2 = (-8000.0) * x2;
v = ((z1 / (m0 + 3.0)) + z2) / (m0 + 2.0);
if isfinite(v)
    if elapsed < uint32(30)
        if 3.0 < v
            u = 3.0;
            status = int32(2);
        elseif v < -3.0
            u = -3.0;
            status = int32(2);
        elseif double(left) <= 5.0
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
