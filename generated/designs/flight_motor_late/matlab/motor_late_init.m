function self = motor_late_init(~) %#codegen
%MOTOR_LATE_INIT Takes the parameters and arms at tick 0.
%
%   self = motor_late_init(params) is the controller, for the functions that stand beside this one.
%   A parameter outside its domain, or coefficients that leave the range of numbers, raise an error
%   motor_late:param, which names what is wrong and what is legal.

% Prescribed-time controller motor_late: order n = 2, clock in samples.
%
% DO NOT EDIT. Made by:
%   ptc-codegen emit --lang matlab --n 2 --mu "exp(a=1)" --name motor_late --clock samples --A="[[0,1],[0,-5]]" --B="[0,40]" --late=extend --state-max=inf,2 --tau=0.2 --eps=0 --u-max=10 --poles=least-energy --sample-time=0.01
% Version 0.1.0, design 39b55d4d4f0b.
%
% Plant: x' = A x + B u of --A and --B above; u held from sample to sample.
% Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
%       sample period, as long as u is not clipped and nothing else acts on the plant.
% Law: u = -K_M x with M samples to go, of all inputs that end at rest those with the least
%       sum of u^2. The gains are a table of 832 bytes: exact below 32 samples to go, and
%       before it those of a grid of 52 nodes, interpolated in a line. The gains of 2 samples
%       to go stay: they are deadbeat.
%
% Parameters:
%   samples = 20 [samples], fixed: samples N from the start to rest
%   h = 0.01 [s], fixed: sample period
%   eps = 0 [s], fixed: time-to-go at which the gains are held
%   u_max = 10 [unit of u], fixed: bound of |u|
%   a = 1 [1/s], fixed: rate of stretched time
%
% k counts samples and may wrap; arm again within 2^32 - N samples.
% From sample N on the last gains are held (status HOLD).
% In flight: arm_for sets another deadline at any tick; rest is exact from any state, so all
%       else stays as it is.
% Plan: with M samples to go a table holds u and |x2| <= 2 at some samples of the way to
%       rest, as rows times x; those at all others are combinations of these whose factors
%       add up to at most 1 in size, which was examined for each M up to 80. If the rows are
%       within the limits, the smaller one of u_min and u_max, u and |x2| <= 2 stay there at
%       every sample to rest, where plant and state are as they are known. A new plan leaves
%       9.5 % of the limits, by which rows between the samples may grow on the way.
% late extend: a step without such a plan raises N to the soonest that has one (status LATE;
%       deadline gives its tick). Where none is found (status INFEASIBLE), or 2^31 samples
%       after the start, N stays, and u is clipped; states may leave their bounds then.
% |u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
%       lasts.
% Guard full: what is measured is finite, or the call is refused (INPUT).
% Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
%       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
%
% Checks of the design (details: ptc-codegen check):
%   membership: sound: exp is of class M for all its parameters.
%   growth: sound: at rest at sample 20 from any state, and |u| is bounded.
%   sampling: not checked: the law is exact in samples, at any period.
%   deadline: not checked: the law is exact in samples, at any period.
%   loop: not checked: `x0_max` is not given.
%   envelope: not checked: it does not examine a clock in samples.

self.start = uint32(0);
self.last = uint32(20);
end
