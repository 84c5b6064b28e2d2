function self = stage3_init(params) %#codegen
%STAGE3_INIT Takes the parameters and arms at tick 0.
%
%   self = stage3_init(params) is the controller, for the functions that stand beside this one. A
%   parameter outside its domain, or coefficients that leave the range of numbers, raise an error
%   stage3:param, which names what is wrong and what is legal.
%
%   params is a struct:
%     u_max: bound of |u| [unit of u], > 0, infinity allowed

% Prescribed-time controller stage3: order n = 2, clock in samples.
%
% DO NOT EDIT. Made by:
%   ptc-codegen emit --lang matlab --n 2 --mu "exp(a=1)" --name stage3 --clock samples --measured=x1 --disturbance constant --observer-poles=-4,-5,-6 --observer-samples=20 --tau=0.04 --eps=0 --poles=-4,-5,-6 --sample-time=1e-3 --delay=1
% Version 0.1.0, design f20e905317e3.
%
% Plant: x1' = x2, x2' = (u + d), d constant and unknown; u held from sample to sample, one
%       sample late.
% Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
%       sample period, as long as u is not clipped and nothing else acts on the plant.
% Law: with M - 3 samples to go and z = S x, u h^3 = sum of row_j z_j
%       h^(j-1)/((M-j+1)...(M-2)); the rows are those of Theorem 1 for the mapping exp. The
%       gains of 3 samples to go stay: they are deadbeat.
%
% Parameters:
%   samples = 40 [samples], fixed: samples N from the start to rest
%   h = 1e-3 [s], fixed: sample period
%   eps = 0 [s], fixed: time-to-go at which the gains are held
%   u_max [unit of u]: bound of |u|
%   a = 1 [1/s], fixed: rate of stretched time
%   k_1 = 120 [1/s^3], fixed: gains k_i of pi0 = -sum k_i xi_i
%   k_2 = 74 [1/s^2], fixed: gains k_i of pi0 = -sum k_i xi_i
%   k_3 = 15 [1/s], fixed: gains k_i of pi0 = -sum k_i xi_i
%
% k counts samples and may wrap; arm again within 2^32 - N samples.
% From sample N on the last gains are held (status HOLD).
% The estimates are exact from sample 20 after the start on where the measurement is; with
%       noise or sensor_step given, or observer_eps, the gains of the observer are then held
%       below deadbeat.
% |u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
%       lasts.
% Guard full: what is measured is finite, or the call is refused (INPUT).
% Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
%       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
%
% Checks of the design (details: ptc-codegen check):
%   membership: sound: exp is of class M for all its parameters.
%   growth: sound: at rest at sample 40 from any state, whatever the poles, and |u| is
%       bounded.
%   sampling: not checked: the law is exact in samples, at any period.
%   deadline: not checked: the law is exact in samples, at any period.
%   loop: not checked: `x0_max` is not given.
%   envelope: not checked: it does not examine a clock in samples.

given.u_max = double(params.u_max);
if ~(given.u_max > 0.0)
    error('stage3:param', 'params.u_max is %g; legal: > 0', params.u_max);
end
u_max = given.u_max;
self.start = uint32(0);
self.u1 = 0.0;
self.u2 = 0.0;
self.seen = uint32(0);
self.x1_hat = 0.0;
self.x2_hat = 0.0;
self.d_hat = 0.0;
self.u_max = u_max;
end
