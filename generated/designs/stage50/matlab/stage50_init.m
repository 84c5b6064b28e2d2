function self = stage50_init(params) %#codegen
%STAGE50_INIT Takes the parameters and arms at tick 0.
%
%   self = stage50_init(params) is the controller, for the functions that stand beside this one. A
%   parameter outside its domain, or coefficients that leave the range of numbers, raise an error
%   stage50:param, which names what is wrong and what is legal.
%
%   params is a struct:
%     u_max: bound of |u| [unit of u], > 0, infinity allowed

% Prescribed-time controller stage50: order n = 2, clock in samples.
%
% DO NOT EDIT. Made by:
%   ptc-codegen emit --lang matlab --n 2 --mu "exp(a=1)" --name stage50 --clock samples --A="[[-1,1],[3,-2]]" --B="[1,2]" --output="[-2,1]" --tau=0.2 --eps=0 --poles="least-energy(weight=1)" --reference input --sample-time=0.01
% Version 0.1.0, design e09f892711c5.
%
% Plant: x' = A x + B u of --A and --B above; u held from sample to sample.
% Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
%       sample period, as long as u is not clipped and nothing else acts on the plant.
% Law: u = -K_M x with M samples to go, of all inputs that end at rest those with the least
%       sum of u^2/M. The gains are a table of 320 bytes: a row for each of them. The gains
%       of 2 samples to go stay: they are deadbeat.
% With the reference r with its derivatives r[0]..r[1] at tick k, x - x_r is in place of x
%       above, and u = w + u_r: with them the output y = -2*x1 + x2 is r, and stays so. At
%       sample N x = x_r where u_r is constant over each sample; else an error of order
%       h^(4-i) is left in y^(i-1).
% r[2] is r^(2) over the sample in which u acts: its mean, (r^(1)(t + h) - r^(1)(t))/h, or
%       that in its middle. u_r is the mean over that sample. To four digits, the last at one
%       time:
%   x_r1 = -1.333*r - 0.3333*r^(1)
%   x_r2 = -1.667*r - 0.6667*r^(1)
%   u_r = 0.3333*r - r^(1) - 0.3333*r^(2)
%
% Parameters:
%   samples = 20 [samples], fixed: samples N from the start to rest
%   h = 0.01 [s], fixed: sample period
%   eps = 0 [s], fixed: time-to-go at which the gains are held
%   u_max [unit of u]: bound of |u|
%   a = 1 [1/s], fixed: rate of stretched time
%
% k counts samples and may wrap; arm again within 2^32 - N samples.
% From sample N on the last gains are held (status HOLD).
% |u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
%       lasts.
% Guard full: what is measured and the reference are finite, or the call is refused (INPUT).
% Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
%       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
%
% Checks of the design (details: ptc-codegen check):
%   membership: sound: exp is of class M for all its parameters.
%   growth: sound: at rest at sample 20 from any state, but for what r does between samples,
%       and |u| is bounded.
%   sampling: not checked: `loop` bounds what the period leaves of a reference that moves.
%   deadline: not checked: `loop` bounds what the period leaves of a reference that moves.
%   loop: not checked: `x0_max` is not given.
%   envelope: not checked: it does not examine a clock in samples.

given.u_max = double(params.u_max);
if ~(given.u_max > 0.0)
    error('stage50:param', 'params.u_max is %g; legal: > 0', params.u_max);
end
u_max = given.u_max;
self.start = uint32(0);
self.u_max = u_max;
end
