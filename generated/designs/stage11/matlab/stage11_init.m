function self = stage11_init(params) %#codegen
%STAGE11_INIT Takes the parameters and arms at tick 0.
%
%   self = stage11_init(params) is the controller, for the functions that stand beside this one. A
%   parameter outside its domain, or coefficients that leave the range of numbers, raise an error
%   stage11:param, which names what is wrong and what is legal.
%
%   params is a struct:
%     samples: samples N from the start to rest [samples], at least 10
%     u_max: bound of |u| [unit of u], > 0, infinity allowed
%     k(1:4): gains k_i of pi0 = -sum k_i xi_i [1/s^4], finite
%     deadbeat: samples to go at which deadbeat takes over, 0 for a safe default [samples], finite

% Prescribed-time controller stage11: order n = 4, clock in samples.
%
% DO NOT EDIT. Made by:
%   ptc-codegen emit --lang matlab --n 4 --mu "exp(a=1)" --name stage11 --clock samples --measured=x1 --disturbance constant --observer-poles=-4,-5,-6,-7,-8 --precision f32 --eps=0 --sample-time=0.01
% Version 0.1.0, design a4fcc16c71ec.
%
% Plant: x1' = x2, ..., x4' = (u + d), d constant and unknown; u held from sample to sample.
% Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
%       sample period, as long as u is not clipped and nothing else acts on the plant.
% Law: with M samples to go and z = S x, u h^4 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-3));
%       the rows are those of Theorem 1 for the mapping exp. Close to the end deadbeat takes
%       over.
%
% Parameters:
%   samples [samples]: samples N from the start to rest
%   h = 0.01 [s], fixed: sample period
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
% The estimates are exact from sample N/2 after the start on where the measurement is; with
%       noise or sensor_step given, or observer_eps, the gains of the observer are then held
%       below deadbeat.
% |u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
%       lasts.
% Guard full: what is measured is finite, or the call is refused (INPUT).
% Precision f32 (IEEE 754 binary32). Results are bit for bit the same on every IEEE 754
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
    error('stage11:param', 'params.samples is %g; legal: 0..2^32 - 1', params.samples);
end
given.u_max = single(params.u_max);
given.k = single(params.k);
if numel(params.k) ~= 4
    error('stage11:param', 'params.k has %d numbers; legal: 4', numel(params.k));
end
given.deadbeat = single(params.deadbeat);
if ~(given.samples > uint32(9))
    error('stage11:param', 'params.samples is %g; legal: >= 10', params.samples);
end
if ~(given.u_max > single(0.0))
    error('stage11:param', 'params.u_max is %g; legal: > 0', params.u_max);
end
if ~isfinite(given.k(1))
    error('stage11:param', 'params.k(1) is %g; legal: finite', params.k(1));
end
if ~isfinite(given.k(2))
    error('stage11:param', 'params.k(2) is %g; legal: finite', params.k(2));
end
if ~isfinite(given.k(3))
    error('stage11:param', 'params.k(3) is %g; legal: finite', params.k(3));
end
if ~isfinite(given.k(4))
    error('stage11:param', 'params.k(4) is %g; legal: finite', params.k(4));
end
if ~(isfinite(given.deadbeat) && (given.deadbeat >= single(0.0)))
    error('stage11:param', 'params.deadbeat is %g; legal: >= 0', params.deadbeat);
end
samples = given.samples;
s1 = (given.k(4) - single(9.0)) + single(4.0);
s2 = pick(s1 < single(8.0), single(8.0), s1);
deadbeat = pick(given.deadbeat > single(0.0), given.deadbeat, s2);
w1_1 = single(100000000.0) * (-given.k(1));
w1_2 = single(1000000.0) * ((-single(1.5)) * (-given.k(1)));
w1_3 = single(10000.0) * (single(0.9166666865348816) * (-given.k(1)));
w1_4 = single(100.0) * ((-single(0.25)) * (-given.k(1)));
s3 = ((single(1.0) - given.k(2)) + given.k(3)) - given.k(4);
w2_2 = single(1000000.0) * s3;
s4 = -(((single(1.0) - given.k(2)) + given.k(3)) - given.k(4));
w2_3 = single(10000.0) * s4;
s5 = ((single(1.0) - given.k(2)) + given.k(3)) - given.k(4);
w2_4 = single(100.0) * (single(0.3333333432674408) * s5);
w3_3 = single(10000.0) * (((-single(7.0)) - given.k(3)) + (single(3.0) * given.k(4)));
w3_4 = single(100.0) * ((-single(0.5)) * (((-single(7.0)) - given.k(3)) + (single(3.0) * given.k(4))));
w4_4 = single(100.0) * (single(6.0) - given.k(4));
u_max = given.u_max;
if ~(isfinite(deadbeat) ...
    && isfinite(w1_1) ...
    && isfinite(w1_2) ...
    && isfinite(w1_3) ...
    && isfinite(w1_4) ...
    && isfinite(w2_2) ...
    && isfinite(w2_3) ...
    && isfinite(w2_4) ...
    && isfinite(w3_3) ...
    && isfinite(w3_4) ...
    && isfinite(w4_4))
    error('stage11:param', 'the coefficients leave the range of numbers: take gains, rates and sample periods nearer to 1');
end
self.start = uint32(0);
self.samples = samples;
self.u1 = single(0.0);
self.seen = uint32(0);
self.x1_hat = single(0.0);
self.x2_hat = single(0.0);
self.x3_hat = single(0.0);
self.x4_hat = single(0.0);
self.d_hat = single(0.0);
self.deadbeat = deadbeat;
self.w1_1 = w1_1;
self.w1_2 = w1_2;
self.w1_3 = w1_3;
self.w1_4 = w1_4;
self.w2_2 = w2_2;
self.w2_3 = w2_3;
self.w2_4 = w2_4;
self.w3_3 = w3_3;
self.w3_4 = w3_4;
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
