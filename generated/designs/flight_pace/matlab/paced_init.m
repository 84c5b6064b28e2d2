function self = paced_init(params) %#codegen
%PACED_INIT Takes the parameters and arms at tick 0.
%
%   self = paced_init(params) is the controller, for the functions that stand beside this one. A
%   parameter outside its domain, or coefficients that leave the range of numbers, raise an error
%   paced:param, which names what is wrong and what is legal.
%
%   params is a struct:
%     u_max: upper limit of u [unit of u], > u_min, infinity allowed

% Prescribed-time controller paced: order n = 2, clock in samples.
%
% DO NOT EDIT. Made by:
%   ptc-codegen emit --lang matlab --n 2 --mu "exp(a=1)" --name paced --clock samples --late=extend --pace=soonest --tau=1 --eps=0 --u-min=-1 --poles=-4,-5,-6 --after zero --sample-time=0.01 --delay=1
% Version 0.1.0, design d3e4f699dd7c.
%
% Plant: x1' = x2, x2' = u; u held from sample to sample, one sample late.
% Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
%       sample period, as long as u is not clipped and nothing else acts on the plant.
% Law: with M - 3 samples to go and z = S x, u h^3 = sum of row_j z_j
%       h^(j-1)/((M-j+1)...(M-2)); the rows are those of Theorem 1 for the mapping exp. The
%       gains of 3 samples to go stay: they are deadbeat.
%
% Parameters:
%   samples = 100 [samples], fixed: samples N from the start to rest
%   h = 0.01 [s], fixed: sample period
%   eps = 0 [s], fixed: time-to-go at which the gains are held
%   u_max [unit of u]: upper limit of u
%   u_min = -1 [unit of u], fixed: lower limit of u
%   a = 1 [1/s], fixed: rate of stretched time
%   k_1 = 120 [1/s^3], fixed: gains k_i of pi0 = -sum k_i xi_i
%   k_2 = 74 [1/s^2], fixed: gains k_i of pi0 = -sum k_i xi_i
%   k_3 = 15 [1/s], fixed: gains k_i of pi0 = -sum k_i xi_i
%
% k counts samples and may wrap; arm again within 2^32 - N samples.
% From sample N on u = 0 (status AFTER).
% In flight: arm_for sets another deadline at any tick; rest is exact from any state, so all
%       else stays as it is.
% Plan: on the way to rest u and the states are sums of falling powers of the samples to go,
%       so their Bernstein coefficients, linear in z, bound them. If these are within the
%       limits, u stay there at every sample to rest, where plant and state are as they are
%       known.
% late extend: a step without such a plan raises N to the soonest that has one (status LATE;
%       deadline gives its tick), and others lower N, by at most a sixteenth of the samples
%       to go. Where none is found (status INFEASIBLE), or 2^31 samples after the start, N
%       stays, and u is clipped; states may leave their bounds then.
% u_min <= u <= u_max: u is clipped to these limits (status SATURATED). Clipping voids the
%       deadline where it lasts.
% Guard full: what is measured is finite, or the call is refused (INPUT).
% Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
%       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
%
% Checks of the design (details: ptc-codegen check):
%   membership: sound: exp is of class M for all its parameters.
%   growth: sound: at rest at sample 100 from any state, whatever the poles, and |u| is
%       bounded.
%   sampling: not checked: the law is exact in samples, at any period.
%   deadline: not checked: the law is exact in samples, at any period.
%   loop: not checked: `x0_max` is not given.
%   envelope: not checked: it does not examine a clock in samples.

given.u_max = double(params.u_max);
if ~((given.u_max > -1.0) && (given.u_max >= 0.0))
    error('paced:param', 'params.u_max is %g; legal: > -1, >= 0', params.u_max);
end
u_max = given.u_max;
self.start = uint32(0);
self.last = uint32(100);
self.u1 = 0.0;
self.u_max = u_max;
end
