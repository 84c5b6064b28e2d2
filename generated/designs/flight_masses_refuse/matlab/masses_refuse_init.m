function self = masses_refuse_init(~) %#codegen
%MASSES_REFUSE_INIT Takes the parameters and arms at tick 0.
%
%   self = masses_refuse_init(params) is the controller, for the functions that stand beside this
%   one. A parameter outside its domain, or coefficients that leave the range of numbers, raise an
%   error masses_refuse:param, which names what is wrong and what is legal.

% Prescribed-time controller masses_refuse: order n = 2, clock in samples.
%
% DO NOT EDIT. Made by:
%   ptc-codegen emit --lang matlab --n 2 --mu "exp(a=1)" --name masses_refuse --clock samples --A="[[0,1],[-400,-2]]" --B="[0,40]" --C="[[1,0]]" --delay-law=predict --late=refuse --reserve=0.1 --disturbance constant --observer=stationary --disturbance-walk=0.5 --precision f32 --tau=0.2 --eps=0.04 --u-max=10 --poles="least-energy(weight=1)" --sample-time=0.01 --delay=1 --sensor-step=1e-5
% Version 0.1.0, design 4c1e1b44d4b2.
%
% Plant: x' = A x + B (u + d), d constant and unknown of --A and --B above; u held from
%       sample to sample, one sample late, y = C x.
% Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
%       sample period, as long as u is not clipped and nothing else acts on the plant.
% Law of the state x predicted for the time from which u acts, by x and the inputs under way:
%       u = -K_M x with M samples to go, of all inputs that end at rest those with the least
%       sum of u^2/M. The gains are a table of 576 bytes: exact below 64 samples to go, and
%       before it those of a grid of 72 nodes, interpolated in a line. The gains of 5 samples
%       to go stay.
%
% Parameters:
%   samples = 20 [samples], fixed: samples N from the start to rest
%   h = 0.01 [s], fixed: sample period
%   eps = 0.04 [s], fixed: time-to-go at which the gains are held
%   u_max = 10 [unit of u], fixed: bound of |u|
%   a = 1 [1/s], fixed: rate of stretched time
%
% k counts samples and may wrap; arm again within 2^32 - N samples.
% From sample N on the last gains are held (status HOLD).
% The estimates approach the state from the first sample on: the observer has the gains of
%       the stationary Kalman filter for the noise and disturbance_walk.
% In flight: arm_for sets another deadline at any tick; rest is exact from any state, so all
%       else stays as it is.
% Plan: with M samples to go a table holds u at some samples of the way to rest, as rows
%       times x; those at all others are combinations of these whose factors add up to at
%       most 1 in size, which was examined for each M up to 80. If the rows are within the
%       limits, the smaller one of u_min and u_max, u stay there at every sample to rest,
%       where plant and state are as they are known. A new plan leaves 5.6 % of the limits,
%       by which rows between the samples may grow on the way.
% late refuse: arm_for refuses a deadline without such a plan (status E_SOON).
% reserve: a new deadline leaves 0.1 of each limit free.
% |u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
%       lasts.
% Guard full: what is measured is finite, or the call is refused (INPUT).
% Precision f32 (IEEE 754 binary32). Results are bit for bit the same on every IEEE 754
%       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
%
% Checks of the design (details: ptc-codegen check):
%   membership: sound: exp is of class M for all its parameters.
%   growth: sound: near rest at sample 20, not at rest: the gains are held from 4 samples to
%       go, and |u| is bounded; so does what the stationary observer leaves of its error.
%   sampling: not checked: the law is exact in samples, at any period.
%   deadline: not checked: the law is exact in samples, at any period.
%   loop: not checked: `x0_max` is not given.
%   envelope: not checked: it does not examine a clock in samples.

self.start = uint32(0);
self.last = uint32(20);
self.u1 = single(0.0);
self.u2 = single(0.0);
self.seen = uint32(0);
self.x1_hat = single(0.0);
self.x1_next = single(0.0);
self.x2_hat = single(0.0);
self.x2_next = single(0.0);
self.d_hat = single(0.0);
self.d_next = single(0.0);
end
