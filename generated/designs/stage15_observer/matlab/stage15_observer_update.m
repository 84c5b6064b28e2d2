function [status, self] = stage15_observer_update(self, k, y, u) %#codegen
%STAGE15_OBSERVER_UPDATE The estimates of tick `k`, which may wrap, from what is measured, y = (x1,
%...) at that tick and u, the input of tick `k` - 1 as it was applied, 0 where there was none. Call
%it once for each tick, before the law, which takes its estimates. Status Hold from sample 9 on: the
%round is over.
%
%   [status, self] = stage15_observer_update(self, k, y, u), with self from stage15_observer_init.
%   Keep self: it is what the next call needs.
%
%   status (int32); on a negative one self is as it was:
%      0  tracking
%      1  hold: the round of the observer is over
%      4  gated: a reading was not believed, the estimates are predicted; wins over 1
%     -2  an argument is not finite, or a tick is not whole
%     -3  an estimate is not finite

observer_samples = uint32(9); % samples of the round of the observer
q1_1 = single(35.55555725097656); % 320/9, weight in the observer's gain l1
q1_2 = -single(23.88888931274414); % -215/9, weight in the observer's gain l1
q1_3 = single(7.0); % weight in the observer's gain l1
k = double(k);
if ~(isfinite(k) && (k == floor(k)))
    status = int32(-2);
    return;
end
k = uint32(mod(k, 4294967296));
y = single(y);
u = single(u);
if ~(isfinite(y(1)) && isfinite(u))
    status = int32(-2);
    return;
end
elapsed = uint32(mod(double(k) - double(self.start), 4294967296));

% Predict.
s1 = self.x1_hat + (self.phi1_2 * self.x2_hat);
s2 = self.late_gamma1 * (self.u1 - single(19.6200008392334));
s3 = (self.gamma1 * (self.u2 - single(19.6200008392334))) + s2;
p1 = s1 + (self.phi1_3 * self.d_hat) + s3;
s4 = self.gamma2 * (self.u2 - single(19.6200008392334));
s5 = self.x2_hat + (self.phi2_3 * self.d_hat);
p2 = s5 + (s4 + (self.gamma2 * (self.u1 - single(19.6200008392334))));
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
o0 = pick(single(left_o) < self.hold_o, self.hold_o, single(left_o));
o0f2 = o0 * (o0 - single(1.0));
r0 = single(1.0) / (o0f2 * (o0 - single(2.0)));
l1 = (q1_1 + (q1_2 * o0) + (q1_3 * o0f2)) * r0;
l2 = (self.q2_1 + (self.q2_2 * o0)) * r0;
l3 = self.q3_1 * r0;
x1 = base + (l1 * miss);
x2 = p2 + (l2 * miss);
d = p3 + (l3 * miss);
if ~(isfinite(x1) && isfinite(x2) && isfinite(d))
    status = int32(-3);
    return;
end
self.u2 = self.u1;
self.u1 = u;
self.x1_hat = x1;
self.x2_hat = x2;
self.d_hat = d;
self.seen = uint32(1);
if left_o == uint32(0)
    status = int32(1);
else
    status = int32(0);
end
end

function r = pick(condition, yes, no)
if condition
    r = yes;
else
    r = no;
end
end
