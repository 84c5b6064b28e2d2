function self = stage41_observer_init(~) %#codegen
%STAGE41_OBSERVER_INIT Takes the parameters and arms at tick 0.
%
%   self = stage41_observer_init(params) is the observer, for the functions that stand beside this
%   one. A parameter outside its domain, or coefficients that leave the range of numbers, raise an
%   error stage41_observer:param, which names what is wrong and what is legal.

% Prescribed-time observer stage41_observer: order n = 3, clock in samples.
%
% DO NOT EDIT. Made by:
%   ptc-codegen emit --lang matlab --n 3 --mu "exp(a=1)" --name stage41 --what observer --clock samples --A="[[0,1,0],[0,-0.5,15],[0,-15,-60]]" --B="[0,0,50]" --C="[[1,0,0],[0,0,1]]" --observer-poles=-4,-5,-6 --observer-samples=20 --innovation-max=1,0.75 --coast=1 --precision f32 --sample-time=0.01
% Version 0.1.0, design 5a4b5fc5ddd5.
%
% Plant: x' = A x + B u of --A and --B above; u held from sample to sample, y = C x.
% Goal: the estimates of the state are exact up to rounding from sample 20 after the start
%       on, from any state and at any sample period, as long as the measurement is exact, u
%       is what was applied and nothing else acts on the plant.
% Observer: xhat(k) = Phi xhat(k - 1) + Gamma u + G (y(k - 1) - C xhat(k - 1)) with the plant
%       sampled, Phi and Gamma: the estimates of tick k hold y up to tick k - 1. The gains
%       follow by duality from the rows that Theorem 1 gives for the mapping exp. Close to
%       the end deadbeat takes over.
%
% Parameters:
%   h = 0.01 [s], fixed: sample period
%   a = 1 [1/s], fixed: rate of stretched time
%
% k counts samples and may wrap; arm again within 2^32 - 20 samples.
% u is the input of tick k - 1 as it was applied, after clipping: it acted from tick k - 1 to
%       tick k.
% From sample 20 on the status is HOLD; with noise or sensor_step given, or observer_eps, the
%       gains of the observer are then held below deadbeat.
% Gate: a reading that is not finite or further than 1, 0.75 from its prediction is not
%       believed, and the estimates are predicted alone (status GATED) for at most 1 sample
%       in a row. Then the call is refused (E_INPUT) until a reading is believed or arm
%       starts the estimates anew. The first reading has no prediction.
% Guard full: what is measured passes this gate, u is finite, or the call is refused (INPUT).
% Precision f32 (IEEE 754 binary32). Results are bit for bit the same on every IEEE 754
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
self.seen = uint32(0);
self.x1_hat = single(0.0);
self.x1_next = single(0.0);
self.x2_hat = single(0.0);
self.x2_next = single(0.0);
self.x3_hat = single(0.0);
self.x3_next = single(0.0);
self.trust = uint32(1);
end
