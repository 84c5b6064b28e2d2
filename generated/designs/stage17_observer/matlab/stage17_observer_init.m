function self = stage17_observer_init(params) %#codegen
%STAGE17_OBSERVER_INIT Takes the parameters and arms at tick 0.
%
%   self = stage17_observer_init(params) is the observer, for the functions that stand beside this
%   one. A parameter outside its domain, or coefficients that leave the range of numbers, raise an
%   error stage17_observer:param, which names what is wrong and what is legal.
%
%   params is a struct:
%     h: sample period [s], from 1e-150 to 1e150

% Prescribed-time observer stage17_observer: order n = 2, clock in samples.
%
% DO NOT EDIT. Made by:
%   ptc-codegen emit --lang matlab --n 2 --mu "exp(a=1)" --name stage17 --what observer --clock samples --disturbance constant --observer-poles=-4,-5 --observer-samples=8 --guard none
% Version 0.1.0, design da56a9ae4fbe.
%
% Plant: x1' = x2, x2' = (u + d), d constant and unknown; u held from sample to sample.
% Goal: the estimates of the state and of d are exact up to rounding from sample 8 after the
%       start on, from any state and at any sample period, as long as the measurement is
%       exact, u is what was applied and nothing else acts on the plant.
% Observer: xhat(k) = p + L (y(k) - p1), p = Phi xhat(k - 1) + Gamma u with the chain
%       sampled, Phi and Gamma: the estimates of tick k hold y up to tick k. The gains follow
%       by duality from the rows that Theorem 1 gives for the mapping exp. Close to the end
%       deadbeat takes over.
%
% Parameters:
%   h [s]: sample period
%   a = 1 [1/s], fixed: rate of stretched time
%
% k counts samples and may wrap; arm again within 2^32 - 8 samples.
% u is the input of tick k - 1 as it was applied, after clipping: it acted from tick k - 1 to
%       tick k.
% From sample 8 on the status is HOLD; with noise or sensor_step given, or observer_eps, the
%       gains of the observer are then held below deadbeat.
% Guard none: finite measurements and inputs are the responsibility of the caller.
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

given.h = double(params.h);
if ~((1e-150 <= given.h) && (given.h <= 1e150))
    error('stage17_observer:param', 'params.h is %g; legal: from 1e-150 to 1e150', params.h);
end
phi1_2 = given.h;
q2_1 = 12.0 * (1.0 / given.h);
e1_2 = 1.0 / given.h;
e0_2 = 0.3333333333333333 * (1.0 / given.h);
if ~(isfinite(q2_1) ...
    && isfinite(e1_2) ...
    && isfinite(e0_2) ...
    && (given.h * given.h >= 1e-200) ...
    && (1.0 / (given.h * given.h) >= 1e-200))
    error('stage17_observer:param', 'the coefficients leave the range of numbers: take gains, rates and sample periods nearer to 1');
end
self.start = uint32(0);
self.seen = uint32(0);
self.x2_hat = 0.0;
self.d_hat = 0.0;
self.phi1_2 = phi1_2;
self.q2_1 = q2_1;
self.e1_2 = e1_2;
self.e0_2 = e0_2;
end
