function self = late_stage_init(~) %#codegen
%LATE_STAGE_INIT Takes the parameters and arms at tick 0.
%
%   self = late_stage_init(params) is the controller, for the functions that stand beside this one.
%   A parameter outside its domain, or coefficients that leave the range of numbers, raise an error
%   late_stage:param, which names what is wrong and what is legal.

% Prescribed-time controller late_stage: order n = 2, clock in samples.
%
% DO NOT EDIT. Made by:
%   ptc-codegen emit --lang matlab --n 2 --mu "exp(a=1)" --name late_stage --clock samples --delay-law=predict --poles-end="least-energy(weight=1)" --end-samples=50 --late=extend --reserve=0.1 --measured=x1 --disturbance constant --observer-poles=-4,-5,-6 --observer-samples=200 --observer-eps=0.03 --tau=0.8 --eps=0.02 --u-max=6 --poles=least-energy --g="2/3" --sample-time=1e-3 --delay=1 --sensor-step=1e-6,0
% Version 0.1.0, design ccd999de2243.
%
% Plant: x1' = x2, x2' = g (u + d), d constant and unknown; u held from sample to sample, one
%       sample late.
% Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
%       sample period, as long as u is not clipped and nothing else acts on the plant.
% Law of the state x predicted for the time from which u acts, by x and the inputs under way:
%       with M samples to go and z = S x, u h^2 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-1));
%       the rows are those of Theorem 1 for the mapping exp. From 50 samples to go on these
%       are M - 2 and the exponents 3, 4, those of least energy. The gains of 21 samples to
%       go stay.
%
% Parameters:
%   samples = 800 [samples], fixed: samples N from the start to rest
%   h = 1e-3 [s], fixed: sample period
%   eps = 0.02 [s], fixed: time-to-go at which the gains are held
%   u_max = 6 [unit of u], fixed: bound of |u|
%   a = 1 [1/s], fixed: rate of stretched time
%   k_1 = 6 [1/s^2], fixed: gains k_i of pi0 = -sum k_i xi_i
%   k_2 = 5 [1/s], fixed: gains k_i of pi0 = -sum k_i xi_i
%
% k counts samples and may wrap; arm again within 2^32 - N samples.
% From sample N on the last gains are held (status HOLD).
% The estimates are exact from sample 200 after the start on where the measurement is; with
%       noise or sensor_step given, or observer_eps, the gains of the observer are then held
%       below deadbeat.
% In flight: arm_for sets another deadline at any tick; rest is exact from any state, so all
%       else stays as it is.
% Plan: on the way to rest u and the states are sums of falling powers of the samples to go,
%       so their Bernstein coefficients, linear in z, bound them. If these are within the
%       limits, u stay there at every sample to rest, where plant and state are as they are
%       known.
% late extend: a step without such a plan raises N to the soonest that has one (status LATE;
%       deadline gives its tick). Where none is found (status INFEASIBLE), or 2^31 samples
%       after the start, N stays, and u is clipped; states may leave their bounds then.
% reserve: a new deadline leaves 0.1 of each limit free.
% |u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
%       lasts.
% Guard full: what is measured is finite, or the call is refused (INPUT).
% Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
%       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
%
% Checks of the design (details: ptc-codegen check):
%   membership: sound: exp is of class M for all its parameters.
%   growth: sound: near rest at sample 800, not at rest: the gains are held from 20 samples
%       to go, and |u| is bounded; so does what the held observer leaves of its error.
%   sampling: not checked: the law is exact in samples, at any period.
%   deadline: not checked: the law is exact in samples, at any period.
%   loop: not checked: `x0_max` is not given.
%   envelope: not checked: it does not examine a clock in samples.

self.start = uint32(0);
self.last = uint32(800);
self.u1 = 0.0;
self.u2 = 0.0;
self.round = uint32(200);
self.seen = uint32(0);
self.x1_hat = 0.0;
self.x2_hat = 0.0;
self.d_hat = 0.0;
end
