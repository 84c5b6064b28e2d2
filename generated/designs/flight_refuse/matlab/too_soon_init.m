function self = too_soon_init(~) %#codegen
%TOO_SOON_INIT Takes the parameters and arms at tick 0.
%
%   self = too_soon_init(params) is the controller, for the functions that stand beside this one. A
%   parameter outside its domain, or coefficients that leave the range of numbers, raise an error
%   too_soon:param, which names what is wrong and what is legal.

% Prescribed-time controller too_soon: order n = 3, clock in samples.
%
% DO NOT EDIT. Made by:
%   ptc-codegen emit --lang matlab --n 3 --mu "exp(a=1)" --name too_soon --clock samples --late=refuse --state-max=inf,0.5,4 --precision f32 --tau=1.5 --eps=0 --u-max=20 --poles="least-energy(weight=1)" --sample-time=0.01
% Version 0.1.0, design 9b0d3c826af2.
%
% Plant: x1' = x2, ..., x3' = u; u held from sample to sample.
% Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
%       sample period, as long as u is not clipped and nothing else acts on the plant.
% Law: with M - 3 samples to go and z = S x, u h^3 = sum of row_j z_j
%       h^(j-1)/((M-j+1)...(M-2)); the rows are those of Theorem 1 for the mapping exp. The
%       gains of 3 samples to go stay: they are deadbeat.
%
% Parameters:
%   samples = 150 [samples], fixed: samples N from the start to rest
%   h = 0.01 [s], fixed: sample period
%   eps = 0 [s], fixed: time-to-go at which the gains are held
%   u_max = 20 [unit of u], fixed: bound of |u|
%   a = 1 [1/s], fixed: rate of stretched time
%   k_1 = 120 [1/s^3], fixed: gains k_i of pi0 = -sum k_i xi_i
%   k_2 = 74 [1/s^2], fixed: gains k_i of pi0 = -sum k_i xi_i
%   k_3 = 15 [1/s], fixed: gains k_i of pi0 = -sum k_i xi_i
%
% k counts samples and may wrap; arm again within 2^32 - N samples.
% From sample N on the last gains are held (status HOLD).
% In flight: arm_for sets another deadline at any tick; rest is exact from any state, so all
%       else stays as it is.
% Plan: on the way to rest u and the states are sums of falling powers of the samples to go,
%       so their Bernstein coefficients, linear in z, bound them. If these are within the
%       limits, u and |x2| <= 0.5 and |x3| <= 4 stay there at every sample to rest, where
%       plant and state are as they are known.
% late refuse: arm_for refuses a deadline without such a plan (status E_SOON).
% |u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
%       lasts.
% Guard full: what is measured is finite, or the call is refused (INPUT).
% Precision f32 (IEEE 754 binary32). Results are bit for bit the same on every IEEE 754
%       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
%
% Checks of the design (details: ptc-codegen check):
%   membership: sound: exp is of class M for all its parameters.
%   growth: sound: at rest at sample 150 from any state, whatever the poles, and |u| is
%       bounded.
%   sampling: not checked: the law is exact in samples, at any period.
%   deadline: not checked: the law is exact in samples, at any period.
%   loop: not checked: `x0_max` is not given.
%   envelope: not checked: it does not examine a clock in samples.

self.start = uint32(0);
self.last = uint32(150);
end
