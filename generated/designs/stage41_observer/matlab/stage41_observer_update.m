function [status, self] = stage41_observer_update(self, k, y, u) %#codegen
%STAGE41_OBSERVER_UPDATE The estimates of tick `k`, which may wrap, from what is measured, y = C x
%at that tick and u, the input of tick `k` - 1 as it was applied, 0 where there was none. y of tick
%`k` shows in the estimates from the next tick on. Call it once for each tick, before the law, which
%takes its estimates. Status Hold from sample 20 on: the round is over.
%
%   [status, self] = stage41_observer_update(self, k, y, u), with self from stage41_observer_init.
%   Keep self: it is what the next call needs.
%
%   status (int32); on a negative one self is as it was:
%      0  tracking
%      1  hold: the round of the observer is over
%      4  gated: a reading was not believed, the estimates are predicted; wins over 1
%     -2  an argument is not finite, or a tick is not whole
%     -3  an estimate is not finite

gamma1 = single(0.00010803832265082747); % prediction from u
gamma2 = single(0.03089279867708683); % prediction from u
gamma3 = single(0.3745921552181244); % prediction from u
observer_samples = uint32(20); % samples of the round of the observer
q1_1_1 = -single(8.0); % weight in the observer's gain l1_1
q1_1_2 = single(8.0); % weight in the observer's gain l1_1
q1_2_1 = single(1218.3760986328125); % weight in the observer's gain l1_2
q1_2_2 = -single(11.457021713256836); % weight in the observer's gain l1_2
q1_3_1 = single(90.17191314697266); % weight in the observer's gain l1_3
q1_3_2 = -single(90.17191314697266); % weight in the observer's gain l1_3
q2_2_1 = -single(0.37285107374191284); % weight in the observer's gain l2_2
q2_3_1 = single(6.0); % weight in the observer's gain l2_3
e0_1_1 = single(1.1216537952423096); % gain of the observer at its end
e0_1_2 = single(11.488577842712402); % gain of the observer at its end
e0_1_3 = -single(7.550089359283447); % gain of the observer at its end
e0_2_2 = single(0.05081171914935112); % gain of the observer at its end
e0_2_3 = single(0.5481857061386108); % gain of the observer at its end
e1_1_1 = single(1.9787967205047607); % gain of the observer at its end
e1_1_2 = single(96.46954345703125); % gain of the observer at its end
e1_1_3 = -single(17.21136474609375); % gain of the observer at its end
e1_2_2 = single(0.05081171914935112); % gain of the observer at its end
e1_2_3 = single(0.5481857061386108); % gain of the observer at its end
phi1_2 = single(0.009942672215402126); % prediction of x1 from x2
phi1_3 = single(0.0006178559851832688); % prediction of x1 from x3
phi2_2 = single(0.9857608079910278); % prediction of x2 from x2
phi2_3 = single(0.11206872016191483); % prediction of x2 from x3
phi3_2 = -single(0.11206872016191483); % prediction of x3 from x2
phi3_3 = single(0.541221559047699); % prediction of x3 from x3
k = double(k);
if ~(isfinite(k) && (k == floor(k)))
    status = int32(-2);
    return;
end
k = uint32(mod(k, 4294967296));
y = single(y);
u = single(u);
if ~isfinite(u)
    status = int32(-2);
    return;
end
elapsed = uint32(mod(double(k) - double(self.start), 4294967296));

% The estimates; at first what y shows.
if self.seen == uint32(0)
    x1 = y(1);
    x2 = single(0.0);
    x3 = y(2);
else
    x1 = self.x1_next + (gamma1 * u);
    x2 = self.x2_next + (gamma2 * u);
    x3 = self.x3_next + (gamma3 * u);
end

% Prediction of the next sample.
gap1 = y(1) - x1;
gap2 = y(2) - x3;
if isfinite(y(1)) && (abs(gap1) <= single(1.0)) && isfinite(y(2)) && (abs(gap2) <= single(0.75))
    miss1 = gap1;
    miss2 = gap2;
    trust = uint32(2);
else
    miss1 = single(0.0);
    miss2 = single(0.0);
    trust = self.trust - uint32(1);
end
if ~(trust > uint32(0))
    status = int32(-2);
    return;
end
off1 = miss1;
off2 = (single(11.271489143371582) * miss1) + miss2;
left_o = observer_samples - elapsed;
o0 = single(left_o);
if o0 > single(7.0)
    r0 = single(1.0) / (o0 * (o0 - single(1.0)));
    l1_1 = ((q1_1_1 + (q1_1_2 * o0)) * r0) - single(0.021203333511948586);
    l1_2 = ((q1_2_1 + (q1_2_2 * o0)) * r0) - single(1.2427890300750732);
    l1_3 = ((q1_3_1 + (q1_3_2 * o0)) * r0) + single(5.331612586975098);
    l2_1 = single(0.0);
    l2_2 = (q2_2_1 * r0) + single(0.1129535660147667);
    l2_3 = (q2_3_1 * r0) - single(0.4518142640590668);
elseif left_o == uint32(7)
    l1_1 = e0_1_1;
    l1_2 = e0_1_2;
    l1_3 = e0_1_3;
    l2_1 = single(0.0);
    l2_2 = e0_2_2;
    l2_3 = e0_2_3;
else
    l1_1 = e1_1_1;
    l1_2 = e1_1_2;
    l1_3 = e1_1_3;
    l2_1 = single(0.0);
    l2_2 = e1_2_2;
    l2_3 = e1_2_3;
end
s1 = x1 + (phi1_2 * x2) + (phi1_3 * x3);
x1_on = s1 + (l1_1 * off1) + (l2_1 * off2);
s2 = (phi2_2 * x2) + (phi2_3 * x3) + (l1_2 * off1);
x2_on = s2 + (l2_2 * off2);
s3 = (phi3_2 * x2) + (phi3_3 * x3) + (l1_3 * off1);
x3_on = s3 + (l2_3 * off2);
if ~(isfinite(x1) ...
    && isfinite(x1_on) ...
    && isfinite(x2) ...
    && isfinite(x2_on) ...
    && isfinite(x3) ...
    && isfinite(x3_on))
    status = int32(-3);
    return;
end
self.x1_hat = x1;
self.x1_next = x1_on;
self.x2_hat = x2;
self.x2_next = x2_on;
self.x3_hat = x3;
self.x3_next = x3_on;
self.seen = uint32(1);
self.trust = trust;
if trust < uint32(2)
    status = int32(4);
elseif left_o == uint32(0)
    status = int32(1);
else
    status = int32(0);
end
end
