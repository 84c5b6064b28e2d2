function [u, status] = stage24_step(self, k, x) %#codegen
%STAGE24_STEP u from tick `k`, which may wrap, and the state x.
%
%   [u, status] = stage24_step(self, k, x), with self from stage24_init.
%
%   status (int32); on a negative one what is given is 0, and self is as it was:
%      0  tracking
%      1  hold: time-to-go held at eps, the deadline is near or over, u is valid
%      2  saturated: u clipped to its limits; wins over 1 and 3
%      3  after: the deadline is over, u is 0 or that of the user-defined law
%      4  gated: a reading was not believed, u by prediction alone; wins over all above
%     -2  an argument is not finite, or time lies before the start, or a tick is not whole
%     -3  u not finite

h = single(0.009999999776482582); % 1/100, sample period
w1_1 = -single(137042.421875); % weight of x1 in the law
w1_2 = single(69031.28125); % weight of x2 in the law
w2_1 = single(1353.4107666015625); % weight of x1 in the law
w2_2 = -single(1082.7286376953125); % weight of x2 in the law
c_1 = -single(5.658291816711426); % weight of x1 in the law
c_2 = single(4.326633453369141); % weight of x2 in the law
b_1 = -single(6519.4267578125); % weight of x1 in the law
b_2 = single(3185.20849609375); % weight of x2 in the law
samples = uint32(30); % samples from the start to rest
u = single(0.0);
k = double(k);
if ~(isfinite(k) && (k == floor(k)))
    status = int32(-2);
    return;
end
k = uint32(mod(k, 4294967296));
x = single(x);
if ~(isfinite(x(1)) && isfinite(x(2)))
    status = int32(-2);
    return;
end
elapsed = uint32(mod(double(k) - double(self.start), 4294967296));
x1 = x(1);
x2 = x(2);

% The tracking error.
t = single(elapsed) * h;
v_r1 = t * t;
v_r2 = single(1.0) + v_r1;
v_r3 = (self.p_size * v_r1) / v_r2;
v_r5 = (self.c_r4 * t * (v_r2 - v_r1)) / (v_r2 * v_r2);
x_r1 = ((-single(1.3333333730697632)) * v_r3) + ((-single(0.3333333432674408)) * v_r5);
x_r2 = ((-single(1.6666666269302368)) * v_r3) + ((-single(0.6666666865348816)) * v_r5);
v_r6 = t + single(0.004999999888241291);
v_r7 = v_r6 * v_r6;
v_r8 = single(1.0) + v_r7;
v_r9 = v_r8 * v_r8;
s1 = (self.c_r4 * v_r6 * (v_r8 - v_r7)) / v_r9;
s2 = (v_r9 + (single(4.0) * v_r7 * v_r7)) - (single(4.0) * v_r8 * v_r6 * v_r6);
s3 = (-single(0.3333333432674408)) * ((self.c_r4 * (s2 - (v_r8 * v_r7))) / (v_r8 * v_r9));
u_r0 = ((single(0.3333333432674408) * ((self.p_size * v_r7) / v_r8)) - s1) + s3;
e1 = x1 - x_r1;
e2 = x2 - x_r2;
if elapsed < uint32(28)
    % The exact law in samples.
    m0 = single(uint32(mod(double(uint32(33)) - double(elapsed), 4294967296)));
    z1 = (w1_1 * e1) + (w1_2 * e2);
    z2 = (w2_1 * e1) + (w2_2 * e2);
    s4 = (c_1 * e1) + (c_2 * e2);
    v = ((z1 + (z2 * m0)) / (m0 * (m0 - single(1.0)))) + s4 + u_r0;
else
    % Deadbeat.
    v = (b_1 * e1) + (b_2 * e2) + u_r0;
end
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
