function self = stage49_init(params) %#codegen
%STAGE49_INIT Takes the parameters and arms at tick 0.
%
%   self = stage49_init(params) is the controller, for the functions that stand beside this one. A
%   parameter outside its domain, or coefficients that leave the range of numbers, raise an error
%   stage49:param, which names what is wrong and what is legal.
%
%   params is a struct:
%     u_max: bound of |u| [unit of u], > 0, infinity allowed

% Prescribed-time controller stage49: order n = 2, clock in samples.
%
% DO NOT EDIT. Made by:
%   ptc-codegen emit --lang matlab --n 2 --mu "exp(a=1)" --name stage49 --clock samples --A="[[0,1],[-4,-0.2]]" --B="[0,1]" --delay-law=extend --poles-end="least-energy(weight=2)" --end-samples=50 --precision f32 --guard none --tau=1.7 --eps=0 --poles=least-energy --gain-bytes=300 --after zero --sample-time=0.01 --delay=2
% Version 0.1.0, design 50fbb26d547a.
%
% Plant: x' = A x + B u of --A and --B above; u held from sample to sample, 2 samples late.
% Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
%       sample period, as long as u is not clipped and nothing else acts on the plant.
% Law: u = -K_M x with M samples to go, of all inputs that end at rest those with the least
%       sum of u^2. From 50 samples to go on it is that of u^2/(M ... (M+1)). The gains are a
%       table of 224 bytes: exact below 8 samples to go, and before it those of a grid of 14
%       nodes, interpolated in a line. The gains of 4 samples to go stay: they are deadbeat.
%
% Parameters:
%   samples = 170 [samples], fixed: samples N from the start to rest
%   h = 0.01 [s], fixed: sample period
%   eps = 0 [s], fixed: time-to-go at which the gains are held
%   u_max [unit of u]: bound of |u|
%   a = 1 [1/s], fixed: rate of stretched time
%
% k counts samples and may wrap; arm again within 2^32 - N samples.
% From sample N on u = 0 (status AFTER).
% |u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
%       lasts.
% Guard none: finite measurements are the responsibility of the caller.
% Precision f32 (IEEE 754 binary32). Results are bit for bit the same on every IEEE 754
%       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
%
% Checks of the design (details: ptc-codegen check):
%   membership: sound: exp is of class M for all its parameters.
%   growth: sound: at rest at sample 170 from any state, and |u| is bounded.
%   sampling: not checked: the law is exact in samples, at any period.
%   deadline: not checked: the law is exact in samples, at any period.
%   loop: not checked: `x0_max` is not given.
%   envelope: not checked: it does not examine a clock in samples.

given.u_max = single(params.u_max);
if ~(given.u_max > single(0.0))
    error('stage49:param', 'params.u_max is %g; legal: > 0', params.u_max);
end
u_max = given.u_max;
self.start = uint32(0);
self.u1 = single(0.0);
self.u2 = single(0.0);
self.u_max = u_max;
end
