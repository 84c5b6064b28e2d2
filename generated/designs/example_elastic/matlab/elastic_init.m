function self = elastic_init(~) %#codegen
%ELASTIC_INIT Takes the parameters and arms at tick 0.
%
%   self = elastic_init(params) is the controller, for the functions that stand beside this one. A
%   parameter outside its domain, or coefficients that leave the range of numbers, raise an error
%   elastic:param, which names what is wrong and what is legal.

% Prescribed-time controller elastic: order n = 2, clock in samples.
%
% DO NOT EDIT. Made by:
%   ptc-codegen emit --lang matlab --n 2 --mu "exp(a=1)" --name elastic --clock samples --measured=x1 --disturbance constant --observer-poles=-5,-6,-7 --observer-samples=200 --tau=0.5 --eps=0.0965 --u-max=100 --poles=-4,-4.5,-5 --g="2/7" --sample-time=5e-4 --delay=1 --error=1e-3,0.1 --sensor-step=7.7e-6 --x0-max=0.3,1e-6
% Version 0.1.0, design b13fcc225118.
%
% Plant: x1' = x2, x2' = g (u + d), d constant and unknown; u held from sample to sample, one
%       sample late.
% Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
%       sample period, as long as u is not clipped and nothing else acts on the plant.
% Law: with M samples to go and z = S x, u h^3 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-2));
%       the rows are those of Theorem 1 for the mapping exp. The gains of 193 samples to go
%       stay.
%
% Parameters:
%   samples = 1000 [samples], fixed: samples N from the start to rest
%   h = 5e-4 [s], fixed: sample period
%   eps = 0.0965 [s], fixed: time-to-go at which the gains are held
%   u_max = 100 [unit of u], fixed: bound of |u|
%   a = 1 [1/s], fixed: rate of stretched time
%   k_1 = 90 [1/s^3], fixed: gains k_i of pi0 = -sum k_i xi_i
%   k_2 = 60.5 [1/s^2], fixed: gains k_i of pi0 = -sum k_i xi_i
%   k_3 = 13.5 [1/s], fixed: gains k_i of pi0 = -sum k_i xi_i
%
% k counts samples and may wrap; arm again within 2^32 - N samples.
% From sample N on the last gains are held (status HOLD).
% The estimates are exact from sample 200 after the start on where the measurement is; with
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
%   growth: sound: near rest at sample 1000, not at rest: the gains are held from 193 samples
%       to go, and |u| is bounded.
%   sampling: not checked: the law is exact in samples, at any period.
%   deadline: not checked: the law is exact in samples, at any period.
%   loop: undecided: f = -5*x2/(7/2) is not a sum of bounded symbols; with f = 0, the g of
%       the law and a rigid plant, at the deadline |x| <= 1.015e-4, 0.002024.
%   envelope: not checked: it does not examine a clock in samples.

self.start = uint32(0);
self.u1 = 0.0;
self.u2 = 0.0;
self.seen = uint32(0);
self.x1_hat = 0.0;
self.x2_hat = 0.0;
self.d_hat = 0.0;
end
