function self = stage45_init(params) %#codegen
%STAGE45_INIT Takes the parameters and arms at tick 0.
%
%   self = stage45_init(params) is the controller, for the functions that stand beside this one. A
%   parameter outside its domain, or coefficients that leave the range of numbers, raise an error
%   stage45:param, which names what is wrong and what is legal.
%
%   params is a struct:
%     samples: samples N from the start to rest [samples], at least 7
%     h: sample period [s], from 1e-18 to 1e18
%     u_max: bound of |u| [unit of u], > 0, infinity allowed
%     a: rate of stretched time [1/s], from 1e-18 to 1e18
%     k(1:2): gains k_i of pi0 = -sum k_i xi_i [1/s^2], finite
%     deadbeat: samples to go at which deadbeat takes over, 0 for a safe default [samples], finite

% Prescribed-time controller stage45: order n = 2, clock in samples.
%
% DO NOT EDIT. Made by:
%   ptc-codegen emit --lang matlab --n 2 --mu exp --name stage45 --clock samples --delay-law=predict --precision f32 --guard none --eps=0 --delay=5
% Version 0.1.0, design 494dc2a017da.
%
% Plant: x1' = x2, x2' = u; u held from sample to sample, 5 samples late.
% Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
%       sample period, as long as u is not clipped and nothing else acts on the plant.
% Law of the state x predicted for the time from which u acts, by x and the inputs under way:
%       with M + 5 samples to go and z = S x, u h^2 = sum of row_j z_j
%       h^(j-1)/((M-j+1)...(M-1)); the rows are those of Theorem 1 for the mapping exp. Close
%       to the end deadbeat takes over.
%
% Parameters:
%   samples [samples]: samples N from the start to rest
%   h [s]: sample period
%   eps = 0 [s], fixed: time-to-go at which the gains are held
%   u_max [unit of u]: bound of |u|
%   a [1/s]: rate of stretched time
%   k_1 [1/s^2]: gains k_i of pi0 = -sum k_i xi_i
%   k_2 [1/s]: gains k_i of pi0 = -sum k_i xi_i
%   deadbeat [samples]: samples to go at which deadbeat takes over, 0 for a safe default
%
% k counts samples and may wrap; arm again within 2^32 - N samples.
% From sample N on the last gains are held (status HOLD).
% |u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
%       lasts.
% Guard none: finite measurements are the responsibility of the caller.
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
    error('stage45:param', 'params.samples is %g; legal: 0..2^32 - 1', params.samples);
end
given.h = single(params.h);
given.u_max = single(params.u_max);
given.a = single(params.a);
given.k = single(params.k);
if numel(params.k) ~= 2
    error('stage45:param', 'params.k has %d numbers; legal: 2', numel(params.k));
end
given.deadbeat = single(params.deadbeat);
if ~(given.samples > uint32(6))
    error('stage45:param', 'params.samples is %g; legal: >= 7', params.samples);
end
if ~((single(1.000000045813705e-18) <= given.h) && (given.h <= single(9.999999843067494e17)))
    error('stage45:param', 'params.h is %g; legal: from 1.000000045813705e-18 to 9.999999843067494e17', params.h);
end
if ~(given.u_max > single(0.0))
    error('stage45:param', 'params.u_max is %g; legal: > 0', params.u_max);
end
if ~((single(1.000000045813705e-18) <= given.a) && (given.a <= single(9.999999843067494e17)))
    error('stage45:param', 'params.a is %g; legal: from 1.000000045813705e-18 to 9.999999843067494e17', params.a);
end
if ~isfinite(given.k(1))
    error('stage45:param', 'params.k(1) is %g; legal: finite', params.k(1));
end
if ~isfinite(given.k(2))
    error('stage45:param', 'params.k(2) is %g; legal: finite', params.k(2));
end
if ~(isfinite(given.deadbeat) && (given.deadbeat >= single(0.0)))
    error('stage45:param', 'params.deadbeat is %g; legal: >= 0', params.deadbeat);
end
samples = given.samples;
s1 = ((given.k(2) / given.a) - single(1.0)) + single(2.0);
s2 = pick(s1 < single(4.0), single(4.0), s1);
deadbeat = pick(given.deadbeat > single(0.0), given.deadbeat, s2);
s3 = -(given.k(1) / (given.a * given.a));
w1_1 = s3 * (single(1.0) / (given.h * given.h));
s4 = single(4.5) * (-(given.k(1) / (given.a * given.a)));
w1_2 = s4 * (single(1.0) / given.h);
w1_4 = -(given.k(1) / (given.a * given.a));
w1_5 = single(2.0) * (-(given.k(1) / (given.a * given.a)));
w1_6 = single(3.0) * (-(given.k(1) / (given.a * given.a)));
w1_7 = single(4.0) * (-(given.k(1) / (given.a * given.a)));
w2_2 = (single(1.0) - (given.k(2) / given.a)) * (single(1.0) / given.h);
w2_3 = single(1.0) - (given.k(2) / given.a);
b_1 = -(single(1.0) / (given.h * given.h));
b_2 = (-single(6.5)) * (single(1.0) / given.h);
u_max = given.u_max;
if ~(isfinite(deadbeat) ...
    && isfinite(w1_1) ...
    && isfinite(w1_2) ...
    && isfinite(w1_4) ...
    && isfinite(w1_5) ...
    && isfinite(w1_6) ...
    && isfinite(w1_7) ...
    && isfinite(w2_2) ...
    && isfinite(w2_3) ...
    && isfinite(b_1) ...
    && isfinite(b_2) ...
    && (given.h * given.h >= single(1.0000000031710769e-30)) ...
    && (single(1.0) / (given.h * given.h) >= single(1.0000000031710769e-30)))
    error('stage45:param', 'the coefficients leave the range of numbers: take gains, rates and sample periods nearer to 1');
end
self.start = uint32(0);
self.samples = samples;
self.u1 = single(0.0);
self.u2 = single(0.0);
self.u3 = single(0.0);
self.u4 = single(0.0);
self.u5 = single(0.0);
self.deadbeat = deadbeat;
self.w1_1 = w1_1;
self.w1_2 = w1_2;
self.w1_4 = w1_4;
self.w1_5 = w1_5;
self.w1_6 = w1_6;
self.w1_7 = w1_7;
self.w2_2 = w2_2;
self.w2_3 = w2_3;
self.b_1 = b_1;
self.b_2 = b_2;
self.u_max = u_max;
end

function r = pick(condition, yes, no)
if condition
    r = yes;
else
    r = no;
end
end
