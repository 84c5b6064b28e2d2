function self = stage30_init(params) %#codegen
%STAGE30_INIT Takes the parameters and arms at tick 0.
%
%   self = stage30_init(params) is the controller, for the functions that stand beside this one. A
%   parameter outside its domain, or coefficients that leave the range of numbers, raise an error
%   stage30:param, which names what is wrong and what is legal.
%
%   params is a struct:
%     samples: samples N from the start to rest [samples], at least 3
%     h: sample period [s], from 1e-18 to 1e18
%     u_max: bound of |u| [unit of u], > 0, infinity allowed
%     a: rate of stretched time [1/s], from 1e-18 to 1e18
%     k(1:3): gains k_i of pi0 = -sum k_i xi_i [1/s^3], finite
%     deadbeat: samples to go at which deadbeat takes over, 0 for a safe default [samples], finite

% Prescribed-time controller stage30: order n = 3, clock in samples.
%
% DO NOT EDIT. Made by:
%   ptc-codegen emit --lang matlab --n 3 --axes 2 --mu exp --name stage30 --clock samples --precision f32 --eps=0.02 --g="3"
% Version 0.1.0, design 466927f5ebf7.
%
% Plant: x1' = x2, ..., x3' = g u; u held from sample to sample.
% Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
%       sample period, as long as u is not clipped and nothing else acts on the plant.
% Law: with M samples to go and z = S x, u h^3 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-2));
%       the rows are those of Theorem 1 for the mapping exp. Close to the end deadbeat takes
%       over.
% Axes: 2, each a chain of its own with this deadline and mapping. step computes what depends
%       on time once.
%
% Parameters:
%   samples [samples]: samples N from the start to rest
%   h [s]: sample period
%   eps = 0.02 [s], fixed: time-to-go at which the gains are held
%   u_max [unit of u]: bound of |u|
%   a [1/s]: rate of stretched time
%   k_1 [1/s^3]: gains k_i of pi0 = -sum k_i xi_i
%   k_2 [1/s^2]: gains k_i of pi0 = -sum k_i xi_i
%   k_3 [1/s]: gains k_i of pi0 = -sum k_i xi_i
%   deadbeat [samples]: samples to go at which deadbeat takes over, 0 for a safe default
%
% k counts samples and may wrap; arm again within 2^32 - N samples.
% From sample N on the last gains are held (status HOLD).
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
    error('stage30:param', 'params.samples is %g; legal: 0..2^32 - 1', params.samples);
end
given.h = single(params.h);
given.u_max = single(params.u_max);
given.a = single(params.a);
given.k = single(params.k);
if numel(params.k) ~= 3
    error('stage30:param', 'params.k has %d numbers; legal: 3', numel(params.k));
end
given.deadbeat = single(params.deadbeat);
if ~(given.samples > uint32(2))
    error('stage30:param', 'params.samples is %g; legal: >= 3', params.samples);
end
if ~((single(1.000000045813705e-18) <= given.h) && (given.h <= single(9.999999843067494e17)))
    error('stage30:param', 'params.h is %g; legal: from 1.000000045813705e-18 to 9.999999843067494e17', params.h);
end
if ~(given.u_max > single(0.0))
    error('stage30:param', 'params.u_max is %g; legal: > 0', params.u_max);
end
if ~((single(1.000000045813705e-18) <= given.a) && (given.a <= single(9.999999843067494e17)))
    error('stage30:param', 'params.a is %g; legal: from 1.000000045813705e-18 to 9.999999843067494e17', params.a);
end
if ~isfinite(given.k(1))
    error('stage30:param', 'params.k(1) is %g; legal: finite', params.k(1));
end
if ~isfinite(given.k(2))
    error('stage30:param', 'params.k(2) is %g; legal: finite', params.k(2));
end
if ~isfinite(given.k(3))
    error('stage30:param', 'params.k(3) is %g; legal: finite', params.k(3));
end
if ~(isfinite(given.deadbeat) && (given.deadbeat >= single(0.0)))
    error('stage30:param', 'params.deadbeat is %g; legal: >= 0', params.deadbeat);
end
samples = given.samples;
hold = single(0.019999999552965164) / given.h;
s1 = -(given.k(1) / (given.a * given.a * given.a));
w1_1_1 = single(0.3333333432674408) * s1 * (single(1.0) / (given.h * given.h * given.h));
s2 = -(given.k(1) / (given.a * given.a * given.a));
w1_2_1 = (-single(0.3333333432674408)) * s2 * (single(1.0) / (given.h * given.h));
s3 = -(given.k(1) / (given.a * given.a * given.a));
w1_3_1 = single(0.1111111119389534) * s3 * (single(1.0) / given.h);
s4 = (-single(1.0)) - (given.k(2) / (given.a * given.a));
s5 = single(0.3333333432674408) * (s4 + (given.k(3) / given.a));
w2_2_1 = s5 * (single(1.0) / (given.h * given.h));
s6 = (-single(1.0)) - (given.k(2) / (given.a * given.a));
s7 = (-single(0.1666666716337204)) * (s6 + (given.k(3) / given.a));
w2_3_1 = s7 * (single(1.0) / given.h);
s8 = single(0.3333333432674408) * (single(3.0) - (given.k(3) / given.a));
w3_3_1 = s8 * (single(1.0) / given.h);
b_1_1 = (-single(0.3333333432674408)) * (single(1.0) / (given.h * given.h * given.h));
b_2_1 = (-single(0.6666666865348816)) * (single(1.0) / (given.h * given.h));
b_3_1 = (-single(0.6111111044883728)) * (single(1.0) / given.h);
u_max = given.u_max;
if ~(isfinite(hold) ...
    && isfinite(w1_1_1) ...
    && isfinite(w1_2_1) ...
    && isfinite(w1_3_1) ...
    && isfinite(w2_2_1) ...
    && isfinite(w2_3_1) ...
    && isfinite(w3_3_1) ...
    && isfinite(b_1_1) ...
    && isfinite(b_2_1) ...
    && isfinite(b_3_1) ...
    && (given.h * given.h * given.h >= single(1.0000000031710769e-30)) ...
    && (single(1.0) / (given.h * given.h * given.h) >= single(1.0000000031710769e-30)))
    error('stage30:param', 'the coefficients leave the range of numbers: take gains, rates and sample periods nearer to 1');
end
self.start = uint32(0);
self.samples = samples;
self.hold = hold;
self.w1_1_1 = w1_1_1;
self.w1_2_1 = w1_2_1;
self.w1_3_1 = w1_3_1;
self.w2_2_1 = w2_2_1;
self.w2_3_1 = w2_3_1;
self.w3_3_1 = w3_3_1;
self.b_1_1 = b_1_1;
self.b_2_1 = b_2_1;
self.b_3_1 = b_3_1;
self.u_max = u_max;
end
