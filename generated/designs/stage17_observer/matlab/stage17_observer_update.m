function [status, self] = stage17_observer_update(self, k, y, u) %#codegen
%STAGE17_OBSERVER_UPDATE The estimates of tick `k`, which may wrap, from what is measured, y = (x1,
%...) at that tick and u, the input of tick `k` - 1 as it was applied, 0 where there was none. Call
%it once for each tick, before the law, which takes its estimates. Status Hold from sample 8 on: the
%round is over.
%
%   [status, self] = stage17_observer_update(self, k, y, u), with self from stage17_observer_init.
%   Keep self: it is what the next call needs.
%
%   status (int32); on a negative one self is as it was:
%      0  tracking
%      1  hold: the round of the observer is over
%      4  gated: a reading was not believed, the estimates are predicted; wins over 1
%     -2  an argument is not finite, or a tick is not whole
%     -3  an estimate is not finite

observer_samples = uint32(8); % samples of the round of the observer
q1_1 = -20.0; % weight in the observer's gain l1
q1_2 = 8.0; % weight in the observer's gain l1
k = double(k);
if ~(isfinite(k) && (k == floor(k)))
    status = int32(-2);
    return;
end
k = uint32(mod(k, 4294967296));
y = double(y);
u = double(u);
elapsed = uint32(mod(double(k) - double(self.start), 4294967296));

% Predict.
s1 = self.x2_hat + (self.phi1_2 * self.d_hat);
p1 = s1 + (self.phi1_2 * u);
p2 = self.d_hat;

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
if o0 > 6.0
    r0 = 1.0 / (o0 * (o0 - 1.0));
    l1 = (q1_1 + (q1_2 * o0)) * r0;
    l2 = self.q2_1 * r0;
elseif left_o == uint32(6)
    l1 = 1.0;
    l2 = self.e0_2;
else
    l1 = 1.0;
    l2 = self.e1_2;
end
x2 = base + (l1 * miss);
d = p2 + (l2 * miss);
if ~(isfinite(x2) && isfinite(d))
    status = int32(-3);
    return;
end
self.x2_hat = x2;
self.d_hat = d;
self.seen = uint32(1);
if left_o == uint32(0)
    status = int32(1);
else
    status = int32(0);
end
end
