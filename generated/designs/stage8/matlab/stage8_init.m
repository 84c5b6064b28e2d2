function self = stage8_init(~) %#codegen
%STAGE8_INIT Takes the parameters and arms at tick 0.
%
%   self = stage8_init(params) is the controller, for the functions that stand beside this one. A
%   parameter outside its domain, or coefficients that leave the range of numbers, raise an error
%   stage8:param, which names what is wrong and what is legal.

% Prescribed-time controller stage8: order n = 2, clock in samples.
%
% DO NOT EDIT. Made by:
%   ptc-codegen emit --lang matlab --n 2 --mu "exp(a=1)" --name stage8 --clock samples --tau=0.03 --eps=0.005 --u-max=3 --poles=-4,-5 --after zero --sample-time=1e-3
% Version 0.1.0, design 2d9dd723208a.
%
% Plant: x1' = x2, x2' = u; u held from sample to sample.
% Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
%       sample period, as long as u is not clipped and nothing else acts on the plant.
% Law: with M - 3 samples to go and z = S x, u h^2 = sum of row_j z_j
%       h^(j-1)/((M-j+1)...(M-1)); the rows are those of Theorem 1 for the mapping exp. The
%       gains of 5 samples to go stay.
%
% Parameters:
%   samples = 30 [samples], fixed: samples N from the start to rest
%   h = 1e-3 [s], fixed: sample period
%   eps = 0.005 [s], fixed: time-to-go at which the gains are held
%   u_max = 3 [unit of u], fixed: bound of |u|
%   a = 1 [1/s], fixed: rate of stretched time
%   k_1 = 20 [1/s^2], fixed: gains k_i of pi0 = -sum k_i xi_i
%   k_2 = 9 [1/s], fixed: gains k_i of pi0 = -sum k_i xi_i
%
% k counts samples and may wrap; arm again within 2^32 - N samples.
% From sample N on u = 0 (status AFTER).
% |u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
%       lasts.
% Guard full: what is measured is finite, or the call is refused (INPUT).
% Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
%       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
%
% Checks of the design (details: ptc-codegen check):
%   membership: sound: exp is of class M for all its parameters.
%   growth: sound: near rest at sample 30, not at rest: the gains are held from 5 samples to
%       go, and |u| is bounded.
%   sampling: not checked: the law is exact in samples, at any period.
%   deadline: not checked: the law is exact in samples, at any period.
%   loop: not checked: `x0_max` is not given.
%   envelope: not checked: it does not examine a clock in samples.

self.start = uint32(0);
end
