function self = stage7_init(params) %#codegen
%STAGE7_INIT Takes the parameters and arms at tick 0.
%
%   self = stage7_init(params) is the controller, for the functions that stand beside this one. A
%   parameter outside its domain, or coefficients that leave the range of numbers, raise an error
%   stage7:param, which names what is wrong and what is legal.
%
%   params is a struct:
%     samples: samples N from the start to rest [samples], at least 4
%     h: sample period [s], from 1e-18 to 1e18
%     u_max: bound of |u| [unit of u], > 0, infinity allowed

% Prescribed-time controller stage7: order n = 1, clock in samples.
%
% DO NOT EDIT. Made by:
%   ptc-codegen emit --lang matlab --n 1 --mu "exp(a=1)" --name stage7 --clock samples --disturbance constant --observer-poles=-4,-5 --precision f32 --guard none --eps=0 --gains=3
% Version 0.1.0, design 7a85fff93aef.
%
% Plant: x1' = (u + d), d constant and unknown; u held from sample to sample.
% Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
%       sample period, as long as u is not clipped and nothing else acts on the plant.
% Law: with M - 2 samples to go and z = S x, u h^1 = sum of row_j z_j
%       h^(j-1)/((M-j+1)...(M-0)); the rows are those of Theorem 1 for the mapping exp. The
%       gains of 1 sample to go stay: they are deadbeat.
%
% Parameters:
%   samples [samples]: samples N from the start to rest
%   h [s]: sample period
%   eps = 0 [s], fixed: time-to-go at which the gains are held
%   u_max [unit of u]: bound of |u|
%   a = 1 [1/s], fixed: rate of stretched time
%   k_1 = 3 [1/s], fixed: gains k_i of pi0 = -sum k_i xi_i
%
% k counts samples and may wrap; arm again within 2^32 - N samples.
% From sample N on the last gains are held (status HOLD).
% The estimates are exact from sample N/2 after the start on where the measurement is; with
%       noise or sensor_step given, or observer_eps, the gains of the observer are then held
%       below deadbeat.
% |u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
%       lasts.
% Guard none: finite measurements are the responsibility of the caller.
% Precision f32 (IEEE 754 binary32). Results are bit for bit the same on every IEEE 754
%       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
%
% Checks of the design (details: ptc-codegen check):
%   membership: sound: exp is of class M for all its parameters.
%   growth: sound: at rest at sample N from any state, whatever the poles, and |u| is bounded.
%   sampling: not checked: the law is exact in samples, at any period.
%   deadline: not checked: the law is exact in samples, at any period.
%   loop: not checked: `samples` is left to run time.
%   envelope: not checked: it does not examine a clock in samples.

given.samples = uint32(params.samples);
if given.samples ~= params.samples
    error('stage7:param', 'params.samples is %g; legal: 0..2^32 - 1', params.samples);
end
given.h = single(params.h);
given.u_max = single(params.u_max);
if ~(given.samples > uint32(3))
    error('stage7:param', 'params.samples is %g; legal: >= 4', params.samples);
end
if ~((single(1.000000045813705e-18) <= given.h) && (given.h <= single(9.999999843067494e17)))
    error('stage7:param', 'params.h is %g; legal: from 1.000000045813705e-18 to 9.999999843067494e17', params.h);
end
if ~(given.u_max > single(0.0))
    error('stage7:param', 'params.u_max is %g; legal: > 0', params.u_max);
end
samples = given.samples;
phi1_2 = given.h;
q2_1 = single(12.0) * (single(1.0) / given.h);
e1_2 = single(1.0) / given.h;
e0_2 = single(0.3333333432674408) * (single(1.0) / given.h);
w1_1 = (-single(3.0)) * (single(1.0) / given.h);
u_max = given.u_max;
if ~(isfinite(q2_1) && isfinite(e1_2) && isfinite(e0_2) && isfinite(w1_1))
    error('stage7:param', 'the coefficients leave the range of numbers: take gains, rates and sample periods nearer to 1');
end
if ~(given.h >= single(1.0000000031710769e-30))
    error('stage7:param', 'params.h is %g; legal: >= 1.0000000031710769e-30', params.h);
end
if ~(single(1.0) / given.h >= single(1.0000000031710769e-30))
    error('stage7:param', 'the coefficients leave the range of numbers: take gains, rates and sample periods nearer to 1');
end
self.start = uint32(0);
self.samples = samples;
self.u1 = single(0.0);
self.seen = uint32(0);
self.x1_hat = single(0.0);
self.d_hat = single(0.0);
self.phi1_2 = phi1_2;
self.q2_1 = q2_1;
self.e1_2 = e1_2;
self.e0_2 = e0_2;
self.w1_1 = w1_1;
self.u_max = u_max;
end
