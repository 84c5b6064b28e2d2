function self = stage38_init(~) %#codegen
%STAGE38_INIT Takes the parameters and arms at tick 0.
%
%   self = stage38_init(params) is the controller, for the functions that stand beside this one. A
%   parameter outside its domain, or coefficients that leave the range of numbers, raise an error
%   stage38:param, which names what is wrong and what is legal.

% Prescribed-time controller stage38: order n = 2, clock in samples.
%
% DO NOT EDIT. Made by:
%   ptc-codegen emit --lang matlab --n 2 --mu "exp(a=1)" --name stage38 --clock samples --measured=x1 --disturbance constant --observer-poles=-4,-5,-6 --observer-samples=20 --precision f32 --tau=0.4 --eps=0 --u-max=1 --u-min=0 --poles=-4,-5,-6 --after zero --sample-time=1e-2 --delay=1
% Version 0.1.0, design 1fdc242cfcc9.
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
%   h = 1e-2 [s], fixed: sample period
%   eps = 0 [s], fixed: time-to-go at which the gains are held
%   u_max = 1 [unit of u], fixed: upper limit of u
%   u_min = 0 [unit of u], fixed: lower limit of u
%   a = 1 [1/s], fixed: rate of stretched time
%   k_1 = 120 [1/s^3], fixed: gains k_i of pi0 = -sum k_i xi_i
%   k_2 = 74 [1/s^2], fixed: gains k_i of pi0 = -sum k_i xi_i
%   k_3 = 15 [1/s], fixed: gains k_i of pi0 = -sum k_i xi_i
%
% k counts samples and may wrap; arm again within 2^32 - N samples.
% From sample N on u = 0 (status AFTER).
% The estimates are exact from sample 20 after the start on where the measurement is; with
%       noise or sensor_step given, or observer_eps, the gains of the observer are then held
%       below deadbeat.
% u_min <= u <= u_max: u is clipped to these limits (status SATURATED). Clipping voids the
%       deadline where it lasts.
% Guard full: what is measured is finite, or the call is refused (INPUT).
% Precision f32 (IEEE 754 binary32). Results are bit for bit the same on every IEEE 754
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

self.start = uint32(0);
self.u1 = single(0.0);
self.u2 = single(0.0);
self.seen = uint32(0);
self.x1_hat = single(0.0);
self.x2_hat = single(0.0);
self.d_hat = single(0.0);
end
