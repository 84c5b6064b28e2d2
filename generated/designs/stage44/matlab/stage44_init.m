function self = stage44_init(params) %#codegen
%STAGE44_INIT Takes the parameters and arms at tick 0.
%
%   self = stage44_init(params) is the controller, for the functions that stand beside this one. A
%   parameter outside its domain, or coefficients that leave the range of numbers, raise an error
%   stage44:param, which names what is wrong and what is legal.
%
%   params is a struct:
%     samples: samples N from the start to rest [samples], at least 10
%     u_max: bound of |u| [unit of u], > 0, infinity allowed

% Prescribed-time controller stage44: order n = 3, clock in samples.
%
% DO NOT EDIT. Made by:
%   ptc-codegen emit --lang matlab --n 3 --mu "exp(a=1)" --name stage44 --clock samples --A="[[0,1,0],[0,-0.5,15],[0,-15,-60]]" --B="[0,0,50]" --C="[[1,0,0]]" --delay-law=predict --observer-poles=-4,-5,-6 --eps=0.06 --poles=-3,-4,-5 --sample-time=0.01 --delay=1.5
% Version 0.1.0, design 985c02d3ad50.
%
% Plant: x' = A x + B u of --A and --B above; u held from sample to sample, 1.5 samples late,
%       y = C x.
% Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
%       sample period, as long as u is not clipped and nothing else acts on the plant.
% Law of the state x predicted for the time from which u acts, by x and the inputs under way:
%       with M samples to go and z = S x, the differences of a flat output, u = sum of row_j
%       z_j/((M-j+1)...(M-2)) less the drift of z; the rows are those of Theorem 1 for the
%       mapping exp. The gains of 8 samples to go stay.
%
% Parameters:
%   samples [samples]: samples N from the start to rest
%   h = 0.01 [s], fixed: sample period
%   eps = 0.06 [s], fixed: time-to-go at which the gains are held
%   u_max [unit of u]: bound of |u|
%   a = 1 [1/s], fixed: rate of stretched time
%   k_1 = 60 [1/s^3], fixed: gains k_i of pi0 = -sum k_i xi_i
%   k_2 = 47 [1/s^2], fixed: gains k_i of pi0 = -sum k_i xi_i
%   k_3 = 12 [1/s], fixed: gains k_i of pi0 = -sum k_i xi_i
%
% k counts samples and may wrap; arm again within 2^32 - N samples.
% From sample N on the last gains are held (status HOLD).
% The estimates are exact from sample N/2 after the start on where the measurement is; with
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
%   growth: sound: near rest at sample N, not at rest: the gains are held from 6 samples to
%       go, and |u| is bounded.
%   sampling: not checked: the law is exact in samples, at any period.
%   deadline: not checked: the law is exact in samples, at any period.
%   loop: not checked: `samples` is left to run time.
%   envelope: not checked: it does not examine a clock in samples.

given.samples = uint32(params.samples);
if given.samples ~= params.samples
    error('stage44:param', 'params.samples is %g; legal: 0..2^32 - 1', params.samples);
end
given.u_max = double(params.u_max);
if ~(given.samples > uint32(9))
    error('stage44:param', 'params.samples is %g; legal: >= 10', params.samples);
end
if ~(given.u_max > 0.0)
    error('stage44:param', 'params.u_max is %g; legal: > 0', params.u_max);
end
samples = given.samples;
u_max = given.u_max;
self.start = uint32(0);
self.samples = samples;
self.u1 = 0.0;
self.u2 = 0.0;
self.u3 = 0.0;
self.seen = uint32(0);
self.x1_hat = 0.0;
self.x1_next = 0.0;
self.x2_hat = 0.0;
self.x2_next = 0.0;
self.x3_hat = 0.0;
self.x3_next = 0.0;
self.u_max = u_max;
end
