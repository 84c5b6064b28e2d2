function [u, status] = stage39_step(self, k, x) %#codegen
%STAGE39_STEP u from tick `k`, which may wrap, and the state x = (x1, x1', ...).
%
%   [u, status] = stage39_step(self, k, x), with self from stage39_init.
%
%   status (int32); on a negative one what is given is 0, and self is as it was:
%      0  tracking
%      1  hold: time-to-go held at eps, the deadline is near or over, u is valid
%      2  saturated: u clipped to its limits; wins over 1 and 3
%      3  after: the deadline is over, u is 0 or that of the user-defined law
%      4  gated: a reading was not believed, u by prediction alone; wins over all above
%     -2  an argument is not finite, or time lies before the start, or a tick is not whole
%     -3  u not finite

u_min = 0.3333333333333333; % 1/3, lower limit of u
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
left = self.samples - elapsed;
m0 = double(left);
if m0 > self.deadbeat
    % The exact law in samples.
    z1 = self.w1_1 * x1;
    v = z1 / m0;
else
    % Deadbeat.
    v = self.b_1 * x1;
end
if isfinite(v)
    if v > self.u_max
        u = self.u_max;
        status = int32(2);
    elseif v < u_min
        u = u_min;
        status = int32(2);
    elseif elapsed < self.samples
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
