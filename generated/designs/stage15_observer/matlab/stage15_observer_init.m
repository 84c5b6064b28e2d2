function self = stage15_observer_init(params) %#codegen
%STAGE15_OBSERVER_INIT Takes the parameters and arms at tick 0.
%
%   self = stage15_observer_init(params) is the observer, for the functions that stand beside this
%   one. A parameter outside its domain, or coefficients that leave the range of numbers, raise an
%   error stage15_observer:param, which names what is wrong and what is legal.
%
%   params is a struct:
%     h: sample period [s], from 1e-18 to 1e18

% Prescribed-time observer stage15_observer: order n = 2, clock in samples.
%
% DO NOT EDIT. Made by:
%   ptc-codegen emit --lang matlab --n 2 --mu "exp(a=1.5)" --name stage15 --what observer --clock samples --measured=x1 --disturbance constant --observer-poles=-4,-5,-6 --observer-samples=9 --observer-eps=0.05 --precision f32 --f="-981/100" --g="1/2" --delay=1.5
% Version 0.1.0, design fa54d2fef2e7.
%
% Plant: x1' = x2, x2' = f + g (u + d), d constant and unknown; u held from sample to sample,
%       1.5 samples late.
% Goal: the estimates of the state and of d are as near as the hold at observer_eps leaves
%       them from sample 9 after the start on, from any state and at any sample period, as
%       long as the measurement is exact, u is what was applied and nothing else acts on the
%       plant.
% Observer: xhat(k) = p + L (y(k) - p1), p = Phi xhat(k - 1) + Gamma u with the chain
%       sampled, Phi and Gamma: the estimates of tick k hold y up to tick k. The gains follow
%       by duality from the rows that Theorem 1 gives for the mapping exp. Close to the end
%       deadbeat takes over.
%
% Parameters:
%   h [s]: sample period
%   a = 1.5 [1/s], fixed: rate of stretched time
%
% k counts samples and may wrap; arm again within 2^32 - 9 samples.
% u is the input of tick k - 1 as it was applied, after clipping: it acts from 1.5 samples
%       after tick k - 1 on for one sample, and the observer keeps those under way.
% From sample 9 on the status is HOLD; with noise or sensor_step given, or observer_eps, the
%       gains of the observer are then held below deadbeat.
% Guard full: what is measured and u are finite, or the call is refused (INPUT).
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

given.h = single(params.h);
if ~((single(1.000000045813705e-18) <= given.h) && (given.h <= single(9.999999843067494e17)))
    error('stage15_observer:param', 'params.h is %g; legal: from 1.000000045813705e-18 to 9.999999843067494e17', params.h);
end
phi1_2 = given.h;
phi1_3 = single(0.25) * (given.h * given.h);
gamma1 = single(0.1875) * (given.h * given.h);
late_gamma1 = single(0.0625) * (given.h * given.h);
phi2_3 = single(0.5) * given.h;
gamma2 = single(0.25) * given.h;
hold_o = single(0.05000000074505806) / given.h;
q2_1 = (-single(22.44444465637207)) * (single(1.0) / given.h);
q2_2 = single(9.88888931274414) * (single(1.0) / given.h);
q3_1 = single(3.555555582046509) * (single(1.0) / (given.h * given.h));
if ~(isfinite(phi1_3) ...
    && isfinite(gamma1) ...
    && isfinite(late_gamma1) ...
    && isfinite(phi2_3) ...
    && isfinite(gamma2) ...
    && isfinite(hold_o) ...
    && isfinite(q2_1) ...
    && isfinite(q2_2) ...
    && isfinite(q3_1) ...
    && (given.h * given.h >= single(1.0000000031710769e-30)) ...
    && (single(1.0) / (given.h * given.h) >= single(1.0000000031710769e-30)) ...
    && (hold_o >= single(3.0)))
    error('stage15_observer:param', 'the coefficients leave the range of numbers: take gains, rates and sample periods nearer to 1');
end
self.start = uint32(0);
self.u1 = single(0.0);
self.u2 = single(0.0);
self.seen = uint32(0);
self.x1_hat = single(0.0);
self.x2_hat = single(0.0);
self.d_hat = single(0.0);
self.phi1_2 = phi1_2;
self.phi1_3 = phi1_3;
self.gamma1 = gamma1;
self.late_gamma1 = late_gamma1;
self.phi2_3 = phi2_3;
self.gamma2 = gamma2;
self.hold_o = hold_o;
self.q2_1 = q2_1;
self.q2_2 = q2_2;
self.q3_1 = q3_1;
end
