function [u, status, self] = stage38_step(self, k, y) %#codegen
%STAGE38_STEP u from tick `k`, which may wrap, and what is measured, y = (x1, ...). Call it once for
%each tick.
%
%   [u, status, self] = stage38_step(self, k, y), with self from stage38_init. Keep self: it is what
%   the next call needs.
%
%   status (int32); on a negative one what is given is 0, and self is as it was:
%      0  tracking
%      1  hold: time-to-go held at eps, the deadline is near or over, u is valid
%      2  saturated: u clipped to its limits; wins over 1 and 3
%      3  after: the deadline is over, u is 0 or that of the user-defined law
%      4  gated: a reading was not believed, u by prediction alone; wins over all above
%     -2  an argument is not finite, or time lies before the start, or a tick is not whole
%     -3  u not finite

phi1_2 = single(0.009999999776482582); % 1/100, prediction of x1 from x2
phi1_3 = single(4.999999873689376e-5); % 1/20000, prediction of x1 from d
gamma1 = single(4.999999873689376e-5); % 1/20000, prediction from u
phi2_3 = single(0.009999999776482582); % 1/100, prediction of x2 from d
gamma2 = single(0.009999999776482582); % 1/100, prediction from u
observer_samples = uint32(20); % samples of the round of the observer
q1_1 = single(120.0); % weight in the observer's gain l1
q1_2 = -single(60.0); % weight in the observer's gain l1
q1_3 = single(12.0); % weight in the observer's gain l1
q2_1 = -single(10800.0); % weight in the observer's gain l2
q2_2 = single(3600.0); % weight in the observer's gain l2
q3_1 = single(240000.0); % weight in the observer's gain l3
e0_2 = single(42.85714340209961); % 300/7, gain of the observer at its end
e0_3 = single(1428.5714111328125); % 10000/7, gain of the observer at its end
e1_2 = single(85.71428680419922); % 600/7, gain of the observer at its end
e1_3 = -single(2857.142822265625); % -20000/7, gain of the observer at its end
e2_2 = single(150.0); % gain of the observer at its end
e2_3 = single(10000.0); % gain of the observer at its end
w1_1 = -single(1200000.0); % weight of x1 in the law
w1_2 = single(6000.0); % weight of x2 in the law
w2_2 = -single(6000.0); % weight of x2 in the law
w3_3 = -single(12.0); % weight of u1 in the law
samples = uint32(40); % samples from the start to rest
u = single(0.0);
k = double(k);
if ~(isfinite(k) && (k == floor(k)))
    status = int32(-2);
    return;
end
k = uint32(mod(k, 4294967296));
y = single(y);
if ~isfinite(y(1))
    status = int32(-2);
    return;
end
elapsed = uint32(mod(double(k) - double(self.start), 4294967296));

% Predict.
s1 = self.x1_hat + (phi1_2 * self.x2_hat);
s2 = s1 + (phi1_3 * self.d_hat);
p1 = s2 + (gamma1 * self.u2);
s3 = self.x2_hat + (phi2_3 * self.d_hat);
p2 = s3 + (gamma2 * self.u2);
p3 = self.d_hat;

% Correct by what is measured.
if self.seen == uint32(0)
    base = y(1);
    miss = single(0.0);
else
    base = p1;
    miss = y(1) - p1;
end
left_o = observer_samples - elapsed;
o0 = single(left_o);
if o0 > single(8.0)
    o0f2 = o0 * (o0 - single(1.0));
    r0 = single(1.0) / (o0f2 * (o0 - single(2.0)));
    l1 = (q1_1 + (q1_2 * o0) + (q1_3 * o0f2)) * r0;
    l2 = (q2_1 + (q2_2 * o0)) * r0;
    l3 = q3_1 * r0;
elseif left_o == uint32(8)
    l1 = single(1.0);
    l2 = e0_2;
    l3 = e0_3;
elseif left_o == uint32(7)
    l1 = single(1.0);
    l2 = e1_2;
    l3 = e1_3;
else
    l1 = single(1.0);
    l2 = e2_2;
    l3 = e2_3;
end
x1 = base + (l1 * miss);
x2 = p2 + (l2 * miss);
d = p3 + (l3 * miss);

% The exact law in samples.
m0 = pick(elapsed < uint32(37), single(uint32(mod(double(uint32(43)) - double(elapsed), 4294967296))), single(6.0));
z1 = (w1_1 * x1) + (w1_2 * x2);
z2 = w2_2 * x2;
z3 = w3_3 * (self.u1 + d);
m0f2 = m0 * (m0 - single(1.0));
s4 = (z1 + (z2 * m0) + (z3 * m0f2)) / (m0f2 * (m0 - single(2.0)));
v = (s4 + (self.u1 + d)) - d;
if ~isfinite(v)
    status = int32(-3);
    return;
end
if elapsed < samples
    if v > single(1.0)
        u_now = single(1.0);
    elseif v < single(0.0)
        u_now = single(0.0);
    else
        u_now = v;
    end
else
    u_now = single(0.0);
end
self.u2 = self.u1;
self.u1 = u_now;
self.x1_hat = x1;
self.x2_hat = x2;
self.d_hat = d;
self.seen = uint32(1);
if elapsed < samples
    if (v > single(1.0)) || (v < single(0.0))
        u = u_now;
        status = int32(2);
    else
        u = u_now;
        status = int32(0);
    end
else
    u = u_now;
    status = int32(3);
end
end

function r = pick(condition, yes, no)
if condition
    r = yes;
else
    r = no;
end
end
