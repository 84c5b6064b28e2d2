function self = drift_observer_init(params) %#codegen
%DRIFT_OBSERVER_INIT Takes the parameters and arms at tick 0.
%
%   self = drift_observer_init(params) is the observer, for the functions that stand beside this
%   one. A parameter outside its domain, or coefficients that leave the range of numbers, raise an
%   error drift_observer:param, which names what is wrong and what is legal.
%
%   params is a struct:
%     h: sample period [s], from 1e-150 to 1e150

% Prescribed-time observer drift_observer: order n = 3, clock in samples.
%
% DO NOT EDIT. Made by:
%   ptc-codegen emit --lang matlab --n 3 --mu "exp(a=1)" --name drift --what observer --clock samples --measured=x1,x2 --disturbance ramp --observer-poles=-4,-5,-6,-7 --observer-samples=60
% Version 0.1.0, design 3d13f742d37b.
%
% Plant: x1' = x2, ..., x3' = (u + d), d an unknown ramp; u held from sample to sample.
% Goal: the estimates of the state and of d are exact up to rounding from sample 60 after the
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
% k counts samples and may wrap; arm again within 2^32 - 60 samples.
% u is the input of tick k - 1 as it was applied, after clipping: it acted from tick k - 1 to
%       tick k.
% From sample 60 on the status is HOLD; with noise or sensor_step given, or observer_eps, the
%       gains of the observer are then held below deadbeat.
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

given.h = double(params.h);
if ~((1e-150 <= given.h) && (given.h <= 1e150))
    error('drift_observer:param', 'params.h is %g; legal: from 1e-150 to 1e150', params.h);
end
phi1_2 = given.h;
phi1_3 = 0.5 * (given.h * given.h);
phi1_4 = 0.16666666666666666 * (given.h * given.h * given.h);
q2_1 = 908.0 * (1.0 / given.h);
q2_2 = (-432.0) * (1.0 / given.h);
q2_3 = 72.0 * (1.0 / given.h);
q3_1 = (-336.0) * (1.0 / (given.h * given.h));
q3_2 = 96.0 * (1.0 / (given.h * given.h));
q4_1 = 24.0 * (1.0 / (given.h * given.h * given.h));
e3_2 = 1.8333333333333333 * (1.0 / given.h);
e3_3 = 2.0 * (1.0 / (given.h * given.h));
e3_4 = 1.0 / (given.h * given.h * given.h);
e2_2 = 1.1666666666666667 * (1.0 / given.h);
e2_4 = -(1.0 / (given.h * given.h * given.h));
e1_2 = 0.8148148148148148 * (1.0 / given.h);
e1_3 = (-0.2222222222222222) * (1.0 / (given.h * given.h));
s1 = 1.0 / (given.h * given.h * given.h);
e1_4 = 0.4444444444444444 * s1;
e0_2 = 0.4777777777777778 * (1.0 / given.h);
e0_3 = 0.26666666666666666 * (1.0 / (given.h * given.h));
s2 = 1.0 / (given.h * given.h * given.h);
e0_4 = (-0.06666666666666667) * s2;
if ~(isfinite(phi1_3) ...
    && isfinite(phi1_4) ...
    && isfinite(q2_1) ...
    && isfinite(q2_2) ...
    && isfinite(q2_3) ...
    && isfinite(q3_1) ...
    && isfinite(q3_2) ...
    && isfinite(q4_1) ...
    && isfinite(e3_2) ...
    && isfinite(e3_3) ...
    && isfinite(e3_4) ...
    && isfinite(e2_2) ...
    && isfinite(e2_4) ...
    && isfinite(e1_2) ...
    && isfinite(e1_3) ...
    && isfinite(e1_4) ...
    && isfinite(e0_2) ...
    && isfinite(e0_3) ...
    && isfinite(e0_4) ...
    && (given.h * given.h * given.h >= 1e-200) ...
    && (1.0 / (given.h * given.h * given.h) >= 1e-200))
    error('drift_observer:param', 'the coefficients leave the range of numbers: take gains, rates and sample periods nearer to 1');
end
self.start = uint32(0);
self.seen = uint32(0);
self.x2_hat = 0.0;
self.x3_hat = 0.0;
self.d_hat = 0.0;
self.d_rate_hat = 0.0;
self.phi1_2 = phi1_2;
self.phi1_3 = phi1_3;
self.phi1_4 = phi1_4;
self.q2_1 = q2_1;
self.q2_2 = q2_2;
self.q2_3 = q2_3;
self.q3_1 = q3_1;
self.q3_2 = q3_2;
self.q4_1 = q4_1;
self.e3_2 = e3_2;
self.e3_3 = e3_3;
self.e3_4 = e3_4;
self.e2_2 = e2_2;
self.e2_4 = e2_4;
self.e1_2 = e1_2;
self.e1_3 = e1_3;
self.e1_4 = e1_4;
self.e0_2 = e0_2;
self.e0_3 = e0_3;
self.e0_4 = e0_4;
end
