function self = stage16_observer_init(~) %#codegen
%STAGE16_OBSERVER_INIT Takes the parameters and arms at tick 0.
%
%   self = stage16_observer_init(params) is the observer, for the functions that stand beside this
%   one. A parameter outside its domain, or coefficients that leave the range of numbers, raise an
%   error stage16_observer:param, which names what is wrong and what is legal.

% Prescribed-time observer stage16_observer: order n = 3, clock in samples.
%
% DO NOT EDIT. Made by:
%   ptc-codegen emit --lang matlab --n 3 --mu "exp(a=1)" --name stage16 --what observer --clock samples --A="[[0,1,0],[0,-0.5,1500],[0,-15,-600]]" --B="[0,0,500]" --C="[[1,0,0],[0,0,1]]" --disturbance constant --observer-poles=-4,-5,-6,-7 --observer-samples=20 --after-observer=-90+20i,-90-20i,-100,-120 --sample-time=1e-3 --delay=1
% Version 0.1.0, design 76c16d95e916.
%
% Plant: x' = A x + B (u + d), d constant and unknown of --A and --B above; u held from
%       sample to sample, one sample late, y = C x.
% Goal: the estimates of the state and of d are exact up to rounding from sample 20 after the
%       start on, from any state and at any sample period, as long as the measurement is
%       exact, u is what was applied and nothing else acts on the plant.
% Observer: xhat(k) = Phi xhat(k - 1) + Gamma u + G (y(k - 1) - C xhat(k - 1)) with the plant
%       sampled, Phi and Gamma: the estimates of tick k hold y up to tick k - 1. The gains
%       follow by duality from the rows that Theorem 1 gives for the mapping exp. Close to
%       the end deadbeat takes over.
%
% Parameters:
%   h = 1e-3 [s], fixed: sample period
%   a = 1 [1/s], fixed: rate of stretched time
%
% k counts samples and may wrap; arm again within 2^32 - 20 samples.
% u is the input of tick k - 1 as it was applied, after clipping: it acts from tick k to tick
%       k + 1, and the observer keeps it until then.
% From sample 20 on the status is HOLD; from there on the observer has the poles
%       after_observer.
% Guard full: what is measured and u are finite, or the call is refused (INPUT).
% Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
%       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
%
% Checks of the design (details: ptc-codegen check):
%   membership: sound: exp is of class M for all its parameters.
%   growth: not checked: an observer alone has no law.
%   sampling: not checked: an observer alone has no law.
%   deadline: not checked: an observer alone has no law.
%   loop: not checked: an observer alone has no law.
%   envelope: not checked: an observer alone has no law.

self.start = uint32(0);
self.u1 = 0.0;
self.seen = uint32(0);
self.x1_hat = 0.0;
self.x1_next = 0.0;
self.x2_hat = 0.0;
self.x2_next = 0.0;
self.x3_hat = 0.0;
self.x3_next = 0.0;
self.d_hat = 0.0;
self.d_next = 0.0;
end
