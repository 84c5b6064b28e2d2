function self = gantry_in_flight_init(~) %#codegen
%GANTRY_IN_FLIGHT_INIT Takes the parameters and arms at tick 0.
%
%   self = gantry_in_flight_init(params) is the controller, for the functions that stand beside this
%   one. A parameter outside its domain, or coefficients that leave the range of numbers, raise an
%   error gantry_in_flight:param, which names what is wrong and what is legal.

% Prescribed-time controller gantry_in_flight: order n = 2, clock in samples.
%
% DO NOT EDIT. Made by:
%   ptc-codegen emit --lang matlab --n 2 --axes 3 --mu "exp(a=1)" --name gantry_in_flight --clock samples --poles-end="least-energy(weight=1)" --end-samples=50 --late=extend --pace=soonest --state-max="[[inf,1.5],[inf,inf],[inf,0.4]]" --reserve=0.1 --tau=1.5 --eps=0.02 --limits="[[-900,900],[-400,400],[-150,60]]" --poles=least-energy --g="[1/120, 1/45, 1/12]" --sample-time=1e-3
% Version 0.1.0, design a53c299184a8.
%
% Plant: x1' = x2, x2' = g u; u held from sample to sample.
% Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
%       sample period, as long as u is not clipped and nothing else acts on the plant.
% Law: with M - 1 samples to go and z = S x, u h^2 = sum of row_j z_j
%       h^(j-1)/((M-j+1)...(M-1)); the rows are those of Theorem 1 for the mapping exp. From
%       50 samples to go on these are M - 2 and the exponents 3, 4, those of least energy.
%       The gains of 20 samples to go stay.
% Axes: 3, each a chain of its own with this deadline and mapping. step computes what depends
%       on time once.
%   axis 1: u_min = -900, u_max = 900; state_max = inf, 1.5; g = 1/120
%   axis 2: u_min = -400, u_max = 400; state_max = inf, inf; g = 1/45
%   axis 3: u_min = -150, u_max = 60; state_max = inf, 0.4; g = 1/12
%
% Parameters:
%   samples = 1500 [samples], fixed: samples N from the start to rest
%   h = 1e-3 [s], fixed: sample period
%   eps = 0.02 [s], fixed: time-to-go at which the gains are held
%   a = 1 [1/s], fixed: rate of stretched time
%   k_1 = 6 [1/s^2], fixed: gains k_i of pi0 = -sum k_i xi_i
%   k_2 = 5 [1/s], fixed: gains k_i of pi0 = -sum k_i xi_i
%
% k counts samples and may wrap; arm again within 2^32 - N samples.
% From sample N on the last gains are held (status HOLD).
% In flight: arm_for sets another deadline at any tick; rest is exact from any state, so all
%       else stays as it is.
% Plan: on the way to rest u and the states are sums of falling powers of the samples to go,
%       so their Bernstein coefficients, linear in z, bound them. If these are within the
%       limits, u and the states stay there at every sample to rest, where plant and state
%       are as they are known.
% Axes: all come to rest at the same sample, and each deadline is tested for every one of
%       them.
% late extend: a step without such a plan raises N to the soonest that has one (status LATE;
%       deadline gives its tick), and others lower N, by at most a sixteenth of the samples
%       to go. Where none is found (status INFEASIBLE), or 2^31 samples after the start, N
%       stays, and u is clipped; states may leave their bounds then.
% reserve: a new deadline leaves 0.1 of each limit free.
% u_min <= u <= u_max: u is clipped to these limits (status SATURATED). Clipping voids the
%       deadline where it lasts.
% Guard full: what is measured is finite, or the call is refused (INPUT).
% Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
%       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
%
% Checks of the design (details: ptc-codegen check):
%   membership: sound: exp is of class M for all its parameters.
%   growth: sound: near rest at sample 1500, not at rest: the gains are held from 20 samples
%       to go, and |u| is bounded.
%   sampling: not checked: the law is exact in samples, at any period.
%   deadline: not checked: the law is exact in samples, at any period.
%   loop: not checked: `x0_max` is not given.
%   envelope: not checked: it does not examine a clock in samples.

self.start = uint32(0);
self.last = uint32(1500);
end
