function [u, status] = stage13_step(self, k, y) %#codegen
%STAGE13_STEP u from tick `k`, which may wrap, and what is measured, y = C x.
%
%   [u, status] = stage13_step(self, k, y), with self from stage13_init.
%
%   status (int32); on a negative one what is given is 0, and self is as it was:
%      0  tracking
%      1  hold: time-to-go held at eps, the deadline is near or over, u is valid
%      2  saturated: u clipped to its limits; wins over 1 and 3
%      3  after: the deadline is over, u is 0 or that of the user-defined law
%      4  gated: a reading was not believed, u by prediction alone; wins over all above
%     -2  an argument is not finite, or time lies before the start, or a tick is not whole
%     -3  u not finite

c_1 = single(54.263023376464844); % weight of x1 in the law
c_2 = single(4.285571575164795); % weight of x2 in the law
b_1 = single(11626.224609375); % weight of x1 in the law
b_2 = single(1009.7781372070313); % weight of x2 in the law
u = single(0.0);
k = double(k);
if ~(isfinite(k) && (k == floor(k)))
    status = int32(-2);
    return;
end
k = uint32(mod(k, 4294967296));
y = single(y);
if ~(isfinite(y(1)) && isfinite(y(2)))
    status = int32(-2);
    return;
end
elapsed = uint32(mod(double(k) - double(self.start), 4294967296));
x1 = (single(0.9090909361839294) * y(1)) + (single(0.4545454680919647) * y(2));
x2 = (single(0.1818181872367859) * y(1)) - (single(0.9090909361839294) * y(2));
left = self.samples - elapsed;
m0 = single(left);
if m0 > self.deadbeat
    % The exact law in samples.
    z1 = (self.w1_1 * x1) + (self.w1_2 * x2);
    z2 = (self.w2_1 * x1) + (self.w2_2 * x2);
    s1 = (c_1 * x1) + (c_2 * x2);
    v = ((z1 + (z2 * m0)) / (m0 * (m0 - single(1.0)))) + s1;
else
    % Deadbeat.
    v = (b_1 * x1) + (b_2 * x2);
end
if isfinite(v)
    if elapsed < self.samples
        if v > self.u_max
            u = self.u_max;
            status = int32(2);
        elseif v < -self.u_max
            u = -self.u_max;
            status = int32(2);
        else
            u = v;
            status = int32(0);
        end
    else
        u = single(0.0);
        status = int32(3);
    end
else
    status = int32(-3);
end
end
