function [status, self] = drift_observer_update(self, k, y, u) %#codegen
%DRIFT_OBSERVER_UPDATE The estimates of tick `k`, which may wrap, from what is measured, y = (x1,
%...) at that tick and u, the input of tick `k` - 1 as it was applied, 0 where there was none. Call
%it once for each tick, before the law, which takes its estimates. Status Hold from sample 60 on:
%the round is over.
%
%   [status, self] = drift_observer_update(self, k, y, u), with self from drift_observer_init. Keep
%   self: it is what the next call needs.
%
%   status (int32); on a negative one self is as it was:
%      0  tracking
%      1  hold: the round of the observer is over
%      4  gated: a reading was not believed, the estimates are predicted; wins over 1
%     -2  an argument is not finite, or a tick is not whole
%     -3  an estimate is not finite

observer_samples = uint32(60); % samples of the round of the observer
q1_1 = -840.0; % weight in the observer's gain l1
q1_2 = 480.0; % weight in the observer's gain l1
q1_3 = -120.0; % weight in the observer's gain l1
q1_4 = 16.0; % weight in the observer's gain l1
k = double(k);
if ~(isfinite(k) && (k == floor(k)))
    status = int32(-2);
    return;
end
k = uint32(mod(k, 4294967296));
y = double(y);
u = double(u);
if ~(isfinite(y(1)) && isfinite(y(2)) && isfinite(u))
    status = int32(-2);
    return;
end
elapsed = uint32(mod(double(k) - double(self.start), 4294967296));

% Predict.
s1 = self.x2_hat + (self.phi1_2 * self.x3_hat);
s2 = s1 + (self.phi1_3 * self.d_hat);
p1 = s2 + (self.phi1_4 * self.d_rate_hat) + (self.phi1_3 * u);
s3 = self.x3_hat + (self.phi1_2 * self.d_hat);
p2 = s3 + (self.phi1_3 * self.d_rate_hat) + (self.phi1_2 * u);
p3 = self.d_hat + (self.phi1_2 * self.d_rate_hat);
p4 = self.d_rate_hat;

% Correct by what is measured.
if self.seen == uint32(0)
    base = y(2);
    miss = 0.0;
else
    base = p1;
    miss = y(2) - p1;
end
left_o = observer_samples - elapsed;
o0 = double(left_o);
if o0 > 10.0
    o0f2 = o0 * (o0 - 1.0);
    o0f3 = o0f2 * (o0 - 2.0);
    r0 = 1.0 / (o0f3 * (o0 - 3.0));
    s4 = q1_1 + (q1_2 * o0) + (q1_3 * o0f2);
    l1 = (s4 + (q1_4 * o0f3)) * r0;
    l2 = (self.q2_1 + (self.q2_2 * o0) + (self.q2_3 * o0f2)) * r0;
    l3 = (self.q3_1 + (self.q3_2 * o0)) * r0;
    l4 = self.q4_1 * r0;
elseif left_o == uint32(10)
    l1 = 1.0;
    l2 = self.e0_2;
    l3 = self.e0_3;
    l4 = self.e0_4;
elseif left_o == uint32(9)
    l1 = 1.0;
    l2 = self.e1_2;
    l3 = self.e1_3;
    l4 = self.e1_4;
elseif left_o == uint32(8)
    l1 = 1.0;
    l2 = self.e2_2;
    l3 = 0.0;
    l4 = self.e2_4;
else
    l1 = 1.0;
    l2 = self.e3_2;
    l3 = self.e3_3;
    l4 = self.e3_4;
end
x2 = base + (l1 * miss);
x3 = p2 + (l2 * miss);
d = p3 + (l3 * miss);
d_rate = p4 + (l4 * miss);
if ~(isfinite(x2) && isfinite(x3) && isfinite(d) && isfinite(d_rate))
    status = int32(-3);
    return;
end
self.x2_hat = x2;
self.x3_hat = x3;
self.d_hat = d;
self.d_rate_hat = d_rate;
self.seen = uint32(1);
if left_o == uint32(0)
    status = int32(1);
else
    status = int32(0);
end
end
