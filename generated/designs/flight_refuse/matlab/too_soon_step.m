function [u, status] = too_soon_step(self, k, x) %#codegen
%TOO_SOON_STEP u from tick `k`, which may wrap, and the state x = (x1, x1', ...).
%
%   [u, status] = too_soon_step(self, k, x), with self from too_soon_init.
%
%   status (int32); on a negative one what is given is 0, and self is as it was:
%      0  tracking
%      1  hold: time-to-go held at eps, the deadline is near or over, u is valid
%      2  saturated: u clipped to its limits; wins over 1 and 3
%      3  after: the deadline is over, u is 0 or that of the user-defined law
%      4  gated: a reading was not believed, u by prediction alone; wins over all above
%     -2  an argument is not finite, or time lies before the start, or a tick is not whole
%     -3  u not finite
%      6  infeasible: nothing is known from here that keeps all limits or bounds, u is valid

w1_1 = -single(120000000.0); % weight of x1 in the law
w1_2 = single(1200000.0); % weight of x2 in the law
w1_3 = -single(4000.0); % weight of x3 in the law
w2_2 = -single(600000.0); % weight of x2 in the law
w2_3 = single(3000.0); % weight of x3 in the law
w3_3 = -single(1200.0); % weight of x3 in the law
u_max = single(20.0); % bound of |u|
u = single(0.0);
k = double(k);
if ~(isfinite(k) && (k == floor(k)))
    status = int32(-2);
    return;
end
k = uint32(mod(k, 4294967296));
x = single(x);
if ~(isfinite(x(1)) && isfinite(x(2)) && isfinite(x(3)))
    status = int32(-2);
    return;
end
elapsed = uint32(mod(double(k) - double(self.start), 4294967296));
x1 = x(1);
x2 = x(2);
x3 = x(3);
left = self.last - elapsed;
m0 = pick(single(left) < single(3.0), single(3.0), single(left));

% The exact law in samples.
z1 = (w1_1 * x1) + (w1_2 * x2) + (w1_3 * x3);
z2 = (w2_2 * x2) + (w2_3 * x3);
z3 = w3_3 * x3;
m0f1 = m0 + single(3.0);
m0f2 = m0f1 * (m0 + single(2.0));
v = (z1 + (z2 * m0f1) + (z3 * m0f2)) / (m0f2 * (m0 + single(1.0)));
if isfinite(v)
    if v > u_max
        u = u_max;
        status = int32(2);
    elseif v < -u_max
        u = -u_max;
        status = int32(2);
    elseif elapsed < self.last
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
