function [status, self] = stage16_observer_update(self, k, y, u) %#codegen
%STAGE16_OBSERVER_UPDATE The estimates of tick `k`, which may wrap, from what is measured, y = C x
%at that tick and u, the input of tick `k` - 1 as it was applied, 0 where there was none. y of tick
%`k` shows in the estimates from the next tick on. Call it once for each tick, before the law, which
%takes its estimates. Status Hold from sample 20 on: the round is over.
%
%   [status, self] = stage16_observer_update(self, k, y, u), with self from stage16_observer_init.
%   Keep self: it is what the next call needs.
%
%   status (int32); on a negative one self is as it was:
%      0  tracking
%      1  hold: the round of the observer is over
%      4  gated: a reading was not believed, the estimates are predicted; wins over 1
%     -2  an argument is not finite, or a tick is not whole
%     -3  an estimate is not finite

gamma1 = 0.00010816330676811052; % prediction from u
gamma2 = 0.30941358230147875; % prediction from u
gamma3 = 0.37459048481653323; % prediction from u
observer_samples = uint32(20); % samples of the round of the observer
q1_1_1 = -8.0; % weight in the observer's gain l1_1
q1_1_2 = 8.0; % weight in the observer's gain l1_1
q1_2_1 = 12007.013438558752; % weight in the observer's gain l1_2
q1_2_2 = -4.007472019404232; % weight in the observer's gain l1_2
q1_4_1 = 359.9910335767149; % weight in the observer's gain l1_4
q2_2_1 = -18.578489051610646; % weight in the observer's gain l2_2
q2_2_2 = 9.913794744612098; % weight in the observer's gain l2_2
q2_3_1 = -12.0; % weight in the observer's gain l2_3
q2_3_2 = 12.0; % weight in the observer's gain l2_3
q2_4_1 = 79.8275894892242; % weight in the observer's gain l2_4
e0_1_1 = 0.9995008164815138; % gain of the observer at its end
e0_1_2 = -0.4960345371406728; % gain of the observer at its end
e0_1_3 = 0.005627803367048088; % gain of the observer at its end
e0_2_1 = 0.0014420897963740578; % gain of the observer at its end
e0_2_2 = 2.2101945239792857; % gain of the observer at its end
e0_2_3 = 1.0319275340206813; % gain of the observer at its end
e0_2_4 = 1.3304598248204031; % gain of the observer at its end
e1_1_1 = 1.9995008164815138; % gain of the observer at its end
e1_1_2 = 999.2535286720462; % gain of the observer at its end
e1_1_3 = 0.005627803367048088; % gain of the observer at its end
e1_1_4 = 29.999252798059576; % gain of the observer at its end
e1_2_1 = 0.0014420897963740578; % gain of the observer at its end
e1_2_2 = 2.4788577332214805; % gain of the observer at its end
e1_2_3 = 1.5319275340206813; % gain of the observer at its end
e1_2_4 = 2.6609196496408063; % gain of the observer at its end
phi1_2 = 0.000996505559752715; % prediction of x1 from x2
phi1_3 = 0.0006188271646029575; % prediction of x1 from x3
phi1_4 = 0.00010816330676811052; % prediction of x1 from d
phi2_2 = 0.9902193397510792; % prediction of x2 from x2
phi2_3 = 1.1234620408672982; % prediction of x2 from x3
phi2_4 = 0.30941358230147875; % prediction of x2 from d
phi3_2 = -0.011234620408672982; % prediction of x3 from x2
phi3_3 = 0.5412090107511158; % prediction of x3 from x3
phi3_4 = 0.37459048481653323; % prediction of x3 from d
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

% The estimates; at first what y shows.
if self.seen == uint32(0)
    x1 = y(1);
    x2 = 0.0;
    x3 = y(2);
    d = 0.0;
else
    x1 = self.x1_next + (gamma1 * self.u1);
    x2 = self.x2_next + (gamma2 * self.u1);
    x3 = self.x3_next + (gamma3 * self.u1);
    d = self.d_next;
end

% Prediction of the next sample.
miss1 = y(1) - x1;
miss2 = y(2) - x3;
off1 = miss1;
off2 = miss2;
left_o = observer_samples - elapsed;
o0 = double(left_o);
if left_o == uint32(0)
    l1_1 = 0.17200400622757925;
    l1_2 = 7.693835124666324;
    l1_3 = 0.005627803367048088;
    l1_4 = 0.23319622641969587;
    l2_1 = 0.0014420897963740578;
    l2_2 = 1.2843129003368876;
    l2_3 = -0.2598303207324358;
    l2_4 = 0.028634005234458536;
elseif o0 > 8.0
    r0 = 1.0 / (o0 * (o0 - 1.0));
    s1 = (q1_1_1 + (q1_1_2 * o0)) * r0;
    l1_1 = s1 - 0.0004991835184862197;
    s2 = (q1_2_1 + (q1_2_2 * o0)) * r0;
    l1_2 = s2 + 0.004899465284856127;
    l1_3 = 0.005627803367048088;
    l1_4 = q1_4_1 * r0;
    l2_1 = 0.0014420897963740578;
    s3 = (q2_2_1 + (q2_2_2 * o0)) * r0;
    l2_2 = s3 + 1.1153817526860825;
    s4 = (q2_3_1 + (q2_3_2 * o0)) * r0;
    l2_3 = s4 - 0.46807246597931873;
    l2_4 = q2_4_1 * r0;
elseif left_o == uint32(8)
    l1_1 = e0_1_1;
    l1_2 = e0_1_2;
    l1_3 = e0_1_3;
    l1_4 = 0.0;
    l2_1 = e0_2_1;
    l2_2 = e0_2_2;
    l2_3 = e0_2_3;
    l2_4 = e0_2_4;
else
    l1_1 = e1_1_1;
    l1_2 = e1_1_2;
    l1_3 = e1_1_3;
    l1_4 = e1_1_4;
    l2_1 = e1_2_1;
    l2_2 = e1_2_2;
    l2_3 = e1_2_3;
    l2_4 = e1_2_4;
end
s5 = x1 + (phi1_2 * x2) + (phi1_3 * x3);
x1_on = s5 + (phi1_4 * d) + (l1_1 * off1) + (l2_1 * off2);
s6 = (phi2_2 * x2) + (phi2_3 * x3);
x2_on = s6 + (phi2_4 * d) + (l1_2 * off1) + (l2_2 * off2);
s7 = (phi3_2 * x2) + (phi3_3 * x3);
x3_on = s7 + (phi3_4 * d) + (l1_3 * off1) + (l2_3 * off2);
d_on = d + (l1_4 * off1) + (l2_4 * off2);
if ~(isfinite(x1) ...
    && isfinite(x1_on) ...
    && isfinite(x2) ...
    && isfinite(x2_on) ...
    && isfinite(x3) ...
    && isfinite(x3_on) ...
    && isfinite(d) ...
    && isfinite(d_on))
    status = int32(-3);
    return;
end
self.u1 = u;
self.x1_hat = x1;
self.x1_next = x1_on;
self.x2_hat = x2;
self.x2_next = x2_on;
self.x3_hat = x3;
self.x3_next = x3_on;
self.d_hat = d;
self.d_next = d_on;
self.seen = uint32(1);
if left_o == uint32(0)
    status = int32(1);
else
    status = int32(0);
end
end
