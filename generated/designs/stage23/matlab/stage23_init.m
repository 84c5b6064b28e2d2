function self = stage23_init(params) %#codegen
%STAGE23_INIT Takes the parameters and arms at tick 0.
%
%   self = stage23_init(params) is the controller, for the functions that stand beside this one. A
%   parameter outside its domain, or coefficients that leave the range of numbers, raise an error
%   stage23:param, which names what is wrong and what is legal.
%
%   params is a struct:
%     u_max: bound of |u| [unit of u], > 0, infinity allowed

% Prescribed-time controller stage23: order n = 3, clock in samples.
%
% DO NOT EDIT. Made by:
%   ptc-codegen emit --lang matlab --n 3 --mu "exp(a=1)" --name stage23 --clock samples --A="[[0,1,0],[0,-1,10],[0,-2,-50]]" --B="[0,0,100]" --C="[[1,0,0]]" --output="[1,0,0]" --observer-poles=-4,-5,-6 --observer-samples=25 --tau=0.5 --eps=0 --poles=-4,-5,-6,-7 --reference input --sample-time=0.01 --delay=1
% Version 0.1.0, design da426a349de3.
%
% Plant: x' = A x + B u of --A and --B above; u held from sample to sample, one sample late,
%       y = C x.
% Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
%       sample period, as long as u is not clipped and nothing else acts on the plant.
% Law: with M - 3 samples to go and z = S x, the differences of a flat output, u = sum of
%       row_j z_j/((M-j+1)...(M-3)) less the drift of z; the rows are those of Theorem 1 for
%       the mapping exp. The gains of 4 samples to go stay: they are deadbeat.
% With the reference r with its derivatives r[0]..r[2] at tick k, x - x_r is in place of x
%       above, and u = w + u_r, where the inputs under way count less the u_r of their own
%       samples: with them the output y = x1 is r, and stays so. At sample N x = x_r where
%       u_r is constant over each sample; else an error of order h^(5-i) is left in y^(i-1).
% r[3] is r^(3) over the sample in which u acts: its mean, (r^(2)(t + h) - r^(2)(t))/h, or
%       that in its middle. u_r is the mean over that sample. To four digits, the last at one
%       time:
%   x_r1 = r
%   x_r2 = r^(1)
%   x_r3 = 0.1*r^(1) + 0.1*r^(2)
%   u_r = 0.07*r^(1) + 0.051*r^(2) + 0.001*r^(3)
%
% Parameters:
%   samples = 50 [samples], fixed: samples N from the start to rest
%   h = 0.01 [s], fixed: sample period
%   eps = 0 [s], fixed: time-to-go at which the gains are held
%   u_max [unit of u]: bound of |u|
%   a = 1 [1/s], fixed: rate of stretched time
%   k_1 = 840 [1/s^4], fixed: gains k_i of pi0 = -sum k_i xi_i
%   k_2 = 638 [1/s^3], fixed: gains k_i of pi0 = -sum k_i xi_i
%   k_3 = 179 [1/s^2], fixed: gains k_i of pi0 = -sum k_i xi_i
%   k_4 = 22 [1/s], fixed: gains k_i of pi0 = -sum k_i xi_i
%
% k counts samples and may wrap; arm again within 2^32 - N samples.
% From sample N on the last gains are held (status HOLD).
% The estimates are exact from sample 25 after the start on where the measurement is; with
%       noise or sensor_step given, or observer_eps, the gains of the observer are then held
%       below deadbeat.
% |u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
%       lasts.
% Guard full: what is measured and the reference are finite, or the call is refused (INPUT).
% Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
%       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
%
% Checks of the design (details: ptc-codegen check):
%   membership: sound: exp is of class M for all its parameters.
%   growth: sound: at rest at sample 50 from any state, but for what r does between samples,
%       whatever the poles, and |u| is bounded.
%   sampling: not checked: `loop` bounds what the period leaves of a reference that moves.
%   deadline: not checked: `loop` bounds what the period leaves of a reference that moves.
%   loop: not checked: `x0_max` is not given.
%   envelope: not checked: it does not examine a clock in samples.

given.u_max = double(params.u_max);
if ~(given.u_max > 0.0)
    error('stage23:param', 'params.u_max is %g; legal: > 0', params.u_max);
end
u_max = given.u_max;
self.start = uint32(0);
self.u1 = 0.0;
self.u2 = 0.0;
self.seen = uint32(0);
self.x1_hat = 0.0;
self.x1_next = 0.0;
self.x2_hat = 0.0;
self.x2_next = 0.0;
self.x3_hat = 0.0;
self.x3_next = 0.0;
self.u_r1 = 0.0;
self.u_max = u_max;
end
