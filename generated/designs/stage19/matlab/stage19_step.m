function [u, status] = stage19_step(self, k, x) %#codegen
%STAGE19_STEP u from tick `k`, which may wrap, and the state x of the model.
%
%   [u, status] = stage19_step(self, k, x), with self from stage19_init.
%
%   status (int32); on a negative one what is given is 0, and self is as it was:
%      0  tracking
%      1  hold: time-to-go held at eps, the deadline is near or over, u is valid
%      2  saturated: u clipped to its limits; wins over 1 and 3
%      3  after: the deadline is over, u is 0 or that of the user-defined law
%      4  gated: a reading was not believed, u by prediction alone; wins over all above
%     -2  an argument is not finite, or time lies before the start, or a tick is not whole
%     -3  u not finite

u = single(0.0);
k = double(k);
if ~(isfinite(k) && (k == floor(k)))
    status = int32(-2);
    return;
end
k = uint32(mod(k, 4294967296));
x = single(x);
elapsed = uint32(mod(double(k) - double(self.start), 4294967296));

% The chain of the output.
x1 = x(1);
x2 = x(2);
v1 = single(1.0) + (x1 * x1);
x3 = (x(3) / v1) - (x2 * single(0.25));
left = self.samples - elapsed;
m0 = single(left);
if m0 > self.deadbeat
    % The exact law in samples.
    z1 = (self.w1_1 * x1) + (self.w1_2 * x2) + (self.w1_3 * x3);
    z2 = (self.w2_2 * x2) + (self.w2_3 * x3);
    z3 = self.w3_3 * x3;
    w = ((((z1 / m0) + z2) / (m0 - single(1.0))) + z3) / (m0 - single(2.0));
else
    % Deadbeat.
    w = (self.b_1 * x1) + (self.b_2 * x2) + (self.b_3 * x3);
end
s1 = ((-single(50.0)) * (x2 + (single(2.0) * x(3))) * v1) - (x(3) * (single(2.0) * x1 * x2));
v = (w - ((s1 / (v1 * v1)) - (x3 * single(0.25)))) * v1 * single(0.019999999552965164);
if isfinite(v)
    if elapsed < self.samples
        u = v;
        status = int32(0);
    else
        u = single(0.0);
        status = int32(3);
    end
else
    status = int32(-3);
end
end
