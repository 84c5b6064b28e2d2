function self = stage12_init(params) %#codegen
%STAGE12_INIT Takes the parameters and arms at tick 0.
%
%   self = stage12_init(params) is the controller, for the functions that stand beside this one. A
%   parameter outside its domain, or coefficients that leave the range of numbers, raise an error
%   stage12:param, which names what is wrong and what is legal.
%
%   params is a struct:
%     samples: samples N from the start to rest [samples], at least 8
%     u_max: bound of |u| [unit of u], > 0, infinity allowed
%     k(1:4): gains k_i of pi0 = -sum k_i xi_i [1/s^4], finite
%     deadbeat: samples to go at which deadbeat takes over, 0 for a safe default [samples], finite

% Prescribed-time controller stage12: order n = 3, clock in samples.
%
% DO NOT EDIT. Made by:
%   ptc-codegen emit --lang matlab --n 3 --mu "exp(a=1)" --name stage12 --clock samples --A="[[0,1,0],[0,-0.5,1500],[0,-15,-600]]" --B="[0,0,500]" --C="[[1,0,0],[0,0,1]]" --disturbance constant --observer-poles=-4,-5,-6,-7 --after-observer=-90+20i,-90-20i,-100,-120 --eps=0 --sample-time=1e-3 --delay=1
% Version 0.1.0, design 69fef31f4d23.
%
% Plant: x' = A x + B (u + d), d constant and unknown of --A and --B above; u held from
%       sample to sample, one sample late, y = C x.
% Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
%       sample period, as long as u is not clipped and nothing else acts on the plant.
% Law: with M samples to go and z = S x, the differences of a flat output, u = sum of row_j
%       z_j/((M-j+1)...(M-3)) less the drift of z; the rows are those of Theorem 1 for the
%       mapping exp. Close to the end deadbeat takes over.
%
% Parameters:
%   samples [samples]: samples N from the start to rest
%   h = 1e-3 [s], fixed: sample period
%   eps = 0 [s], fixed: time-to-go at which the gains are held
%   u_max [unit of u]: bound of |u|
%   a = 1 [1/s], fixed: rate of stretched time
%   k_1 [1/s^4]: gains k_i of pi0 = -sum k_i xi_i
%   k_2 [1/s^3]: gains k_i of pi0 = -sum k_i xi_i
%   k_3 [1/s^2]: gains k_i of pi0 = -sum k_i xi_i
%   k_4 [1/s]: gains k_i of pi0 = -sum k_i xi_i
%   deadbeat [samples]: samples to go at which deadbeat takes over, 0 for a safe default
%
% k counts samples and may wrap; arm again within 2^32 - N samples.
% From sample N on the last gains are held (status HOLD).
% The estimates are exact from sample N/2 after the start on where the measurement is; from
%       there on the observer has the poles after_observer.
% |u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
%       lasts.
% Guard full: what is measured is finite, or the call is refused (INPUT).
% Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
%       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
%
% Checks of the design (details: ptc-codegen check):
%   membership: sound: exp is of class M for all its parameters.
%   growth: sound: at rest at sample N from any state, whatever the poles, and |u| is bounded.
%   sampling: not checked: the law is exact in samples, at any period.
%   deadline: not checked: the law is exact in samples, at any period.
%   loop: not checked: `samples` is left to run time.
%   envelope: not checked: it does not examine a clock in samples.

given.samples = uint32(params.samples);
if given.samples ~= params.samples
    error('stage12:param', 'params.samples is %g; legal: 0..2^32 - 1', params.samples);
end
given.u_max = double(params.u_max);
given.k = double(params.k);
if numel(params.k) ~= 4
    error('stage12:param', 'params.k has %d numbers; legal: 4', numel(params.k));
end
given.deadbeat = double(params.deadbeat);
if ~(given.samples > uint32(7))
    error('stage12:param', 'params.samples is %g; legal: >= 8', params.samples);
end
if ~(given.u_max > 0.0)
    error('stage12:param', 'params.u_max is %g; legal: > 0', params.u_max);
end
if ~isfinite(given.k(1))
    error('stage12:param', 'params.k(1) is %g; legal: finite', params.k(1));
end
if ~isfinite(given.k(2))
    error('stage12:param', 'params.k(2) is %g; legal: finite', params.k(2));
end
if ~isfinite(given.k(3))
    error('stage12:param', 'params.k(3) is %g; legal: finite', params.k(3));
end
if ~isfinite(given.k(4))
    error('stage12:param', 'params.k(4) is %g; legal: finite', params.k(4));
end
if ~(isfinite(given.deadbeat) && (given.deadbeat >= 0.0))
    error('stage12:param', 'params.deadbeat is %g; legal: >= 0', params.deadbeat);
end
samples = given.samples;
s1 = (given.k(4) - 9.0) + 4.0;
s2 = pick(s1 < 8.0, 8.0, s1);
deadbeat = pick(given.deadbeat > 0.0, given.deadbeat, s2);
w1_1 = 1776.8479601183408 * (-given.k(1));
w1_2 = (-1.8656772383860403) * (-given.k(1));
w1_3 = 1.0279922805444073 * (-given.k(1));
s3 = ((1.0 - given.k(2)) + given.k(3)) - given.k(4);
w2_2 = 1.7773373232410332 * s3;
s4 = ((1.0 - given.k(2)) + given.k(3)) - given.k(4);
w2_3 = (-1.4680893680774487) * s4;
s5 = ((-7.0) - given.k(3)) + (3.0 * given.k(4));
w3_2 = (-0.0008901057299880047) * s5;
s6 = ((-7.0) - given.k(3)) + (3.0 * given.k(4));
w3_3 = 2.670317189964014 * s6;
w4_2 = (-0.02999129417826937) * (6.0 - given.k(4));
w4_3 = (-1.2261174651918907) * (6.0 - given.k(4));
w4_4 = 6.0 - given.k(4);
u_max = given.u_max;
if ~(isfinite(deadbeat) ...
    && isfinite(w1_1) ...
    && isfinite(w1_2) ...
    && isfinite(w1_3) ...
    && isfinite(w2_2) ...
    && isfinite(w2_3) ...
    && isfinite(w3_2) ...
    && isfinite(w3_3) ...
    && isfinite(w4_2) ...
    && isfinite(w4_3) ...
    && isfinite(w4_4))
    error('stage12:param', 'the coefficients leave the range of numbers: take gains, rates and sample periods nearer to 1');
end
self.start = uint32(0);
self.samples = samples;
self.u1 = 0.0;
self.u2 = 0.0;
self.seen = uint32(0);
self.x1_hat = 0.0;
self.x1_next = 0.0;
self.x2_hat = 0.0;
self.x2_next = 0.0;
self.x3_hat = 0.0;
self.x3_next = 0.0;
self.d_hat = 0.0;
self.d_next = 0.0;
self.deadbeat = deadbeat;
self.w1_1 = w1_1;
self.w1_2 = w1_2;
self.w1_3 = w1_3;
self.w2_2 = w2_2;
self.w2_3 = w2_3;
self.w3_2 = w3_2;
self.w3_3 = w3_3;
self.w4_2 = w4_2;
self.w4_3 = w4_3;
self.w4_4 = w4_4;
self.u_max = u_max;
end

function r = pick(condition, yes, no)
if condition
    r = yes;
else
    r = no;
end
end
