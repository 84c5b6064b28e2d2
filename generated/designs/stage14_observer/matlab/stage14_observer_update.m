function [status, self] = stage14_observer_update(self, k, y, u) %#codegen
%STAGE14_OBSERVER_UPDATE The estimates of tick `k`, which may wrap, from what is measured, y = (x1,
%...) at that tick and u, the input of tick `k` - 1 as it was applied, 0 where there was none. Call
%it once for each tick, before the law, which takes its estimates. Status Hold from sample 12 on:
%the round is over.
%
%   [status, self] = stage14_observer_update(self, k, y, u), with self from stage14_observer_init.
%   Keep self: it is what the next call needs.
%
%   status (int32); on a negative one self is as it was:
%      0  tracking
%      1  hold: the round of the observer is over
%      4  gated: a reading was not believed, the estimates are predicted; wins over 1
%     -2  an argument is not finite, or a tick is not whole
%     -3  an estimate is not finite

observer_samples = uint32(12); % samples of the round of the observer
q1_1 = 104.0; % weight in the observer's gain l1
q1_2 = -53.0; % weight in the observer's gain l1
q1_3 = 11.0; % weight in the observer's gain l1
k = double(k);
if ~(isfinite(k) && (k == floor(k)))
    status = int32(-2);
    return;
end
k = uint32(mod(k, 4294967296));
y = double(y);
u = double(u);
if ~(isfinite(y(1)) && isfinite(u))
    status = int32(-2);
    return;
end
elapsed = uint32(mod(double(k) - double(self.start), 4294967296));

% Predict.
s1 = self.x1_hat + (self.phi1_2 * self.x2_hat);
p1 = s1 + (self.phi1_3 * self.x3_hat) + (self.gamma1 * u);
s2 = self.x2_hat + (self.phi1_2 * self.x3_hat);
p2 = s2 + (self.phi1_3 * u);
p3 = self.x3_hat + (self.phi1_2 * u);

% Correct by what is measured.
if self.seen == uint32(0)
    base = y(1);
    miss = 0.0;
else
    base = p1;
    miss = y(1) - p1;
end
left_o = observer_samples - elapsed;
o0 = double(left_o);
if o0 > 7.0
    o0f2 = o0 * (o0 - 1.0);
    r0 = 1.0 / (o0f2 * (o0 - 2.0));
    l1 = (q1_1 + (q1_2 * o0) + (q1_3 * o0f2)) * r0;
    l2 = (self.q2_1 + (self.q2_2 * o0)) * r0;
    l3 = self.q3_1 * r0;
elseif left_o == uint32(7)
    l1 = 1.0;
    l2 = self.e0_2;
    l3 = self.e0_3;
elseif left_o == uint32(6)
    l1 = 1.0;
    l2 = self.e1_2;
    l3 = self.e1_3;
else
    l1 = 1.0;
    l2 = self.e2_2;
    l3 = self.e2_3;
end
x1 = base + (l1 * miss);
x2 = p2 + (l2 * miss);
x3 = p3 + (l3 * miss);
if ~(isfinite(x1) && isfinite(x2) && isfinite(x3))
    status = int32(-3);
    return;
end
self.x1_hat = x1;
self.x2_hat = x2;
self.x3_hat = x3;
self.seen = uint32(1);
if left_o == uint32(0)
    status = int32(1);
else
    status = int32(0);
end
end
