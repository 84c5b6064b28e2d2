function self = stage19_init(params) %#codegen
%STAGE19_INIT Takes the parameters and arms at tick 0.
%
%   self = stage19_init(params) is the controller, for the functions that stand beside this one. A
%   parameter outside its domain, or coefficients that leave the range of numbers, raise an error
%   stage19:param, which names what is wrong and what is legal.
%
%   params is a struct:
%     samples: samples N from the start to rest [samples], at least 3
%     h: sample period [s], from 1e-18 to 1e18
%     k(1:3): gains k_i of pi0 = -sum k_i xi_i [1/s^3], finite
%     deadbeat: samples to go at which deadbeat takes over, 0 for a safe default [samples], finite

% Prescribed-time controller stage19: order n = 3, clock in samples.
%
% DO NOT EDIT. Made by:
%   ptc-codegen emit --lang matlab --n 3 --mu "exp(a=1)" --name stage19 --clock samples --precision f32 --guard none --eps=0 --u-max=inf --states="q, w, i" --input=V --output="q" --dynamics="w, i/(1 + q^2) - w/4, 50*(V - 2*i - w)" --after zero
% Version 0.1.0, design 837b86fb35a8.
%
% Plant: the input V: q' = w, w' = i/(1 + q^2) - w/4, i' = 50*(V - 2*i - w), output q; u held
%       from sample to sample.
% Goal: the output and its derivatives up to order 2, x, are 0 at sample N after the start,
%       from any state, as long as u is not clipped and the plant is the model. f and g are
%       known at the samples alone, which leaves an error of order h^(5-i) in x_i.
% Law: with M samples to go and z = S x, w h^3 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-2)),
%       and u = (w - f)/g; the rows are those of Theorem 1 for the mapping exp. Close to the
%       end deadbeat takes over.
%
% Parameters:
%   samples [samples]: samples N from the start to rest
%   h [s]: sample period
%   eps = 0 [s], fixed: time-to-go at which the gains are held
%   u_max = inf [unit of u], fixed: bound of |u|
%   a = 1 [1/s], fixed: rate of stretched time
%   k_1 [1/s^3]: gains k_i of pi0 = -sum k_i xi_i
%   k_2 [1/s^2]: gains k_i of pi0 = -sum k_i xi_i
%   k_3 [1/s]: gains k_i of pi0 = -sum k_i xi_i
%   deadbeat [samples]: samples to go at which deadbeat takes over, 0 for a safe default
%
% k counts samples and may wrap; arm again within 2^32 - N samples.
% From sample N on u = 0 (status AFTER).
% u is not clipped.
% Guard none: finite measurements are the responsibility of the caller.
% Precision f32 (IEEE 754 binary32). Results are bit for bit the same on every IEEE 754
%       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
%
% Checks of the design (details: ptc-codegen check):
%   membership: sound: exp is of class M for all its parameters.
%   growth: sound: at rest at sample N from any state, but for what f + g u does between
%       samples, whatever the poles, and |u| is bounded.
%   sampling: not checked: `loop` bounds what the period leaves of a model that is not linear.
%   deadline: not checked: `loop` bounds what the period leaves of a model that is not linear.
%   loop: not checked: `samples` is left to run time.
%   envelope: not checked: it does not examine a clock in samples.
%   zeros: sound: none: the relative degree is 3, the number of states.

given.samples = uint32(params.samples);
if given.samples ~= params.samples
    error('stage19:param', 'params.samples is %g; legal: 0..2^32 - 1', params.samples);
end
given.h = single(params.h);
given.k = single(params.k);
if numel(params.k) ~= 3
    error('stage19:param', 'params.k has %d numbers; legal: 3', numel(params.k));
end
given.deadbeat = single(params.deadbeat);
if ~(given.samples > uint32(2))
    error('stage19:param', 'params.samples is %g; legal: >= 3', params.samples);
end
if ~((single(1.000000045813705e-18) <= given.h) && (given.h <= single(9.999999843067494e17)))
    error('stage19:param', 'params.h is %g; legal: from 1.000000045813705e-18 to 9.999999843067494e17', params.h);
end
if ~isfinite(given.k(1))
    error('stage19:param', 'params.k(1) is %g; legal: finite', params.k(1));
end
if ~isfinite(given.k(2))
    error('stage19:param', 'params.k(2) is %g; legal: finite', params.k(2));
end
if ~isfinite(given.k(3))
    error('stage19:param', 'params.k(3) is %g; legal: finite', params.k(3));
end
if ~(isfinite(given.deadbeat) && (given.deadbeat >= single(0.0)))
    error('stage19:param', 'params.deadbeat is %g; legal: >= 0', params.deadbeat);
end
samples = given.samples;
s1 = (given.k(3) - single(4.0)) + single(3.0);
s2 = pick(s1 < single(6.0), single(6.0), s1);
deadbeat = pick(given.deadbeat > single(0.0), given.deadbeat, s2);
w1_1 = (-given.k(1)) * (single(1.0) / (given.h * given.h * given.h));
w1_2 = given.k(1) * (single(1.0) / (given.h * given.h));
w1_3 = single(0.3333333432674408) * (-given.k(1)) * (single(1.0) / given.h);
s3 = ((-single(1.0)) - given.k(2)) + given.k(3);
w2_2 = s3 * (single(1.0) / (given.h * given.h));
s4 = (-single(0.5)) * (((-single(1.0)) - given.k(2)) + given.k(3));
w2_3 = s4 * (single(1.0) / given.h);
w3_3 = (single(3.0) - given.k(3)) * (single(1.0) / given.h);
b_1 = -(single(1.0) / (given.h * given.h * given.h));
b_2 = (-single(2.0)) * (single(1.0) / (given.h * given.h));
b_3 = (-single(1.8333333730697632)) * (single(1.0) / given.h);
if ~(isfinite(deadbeat) ...
    && isfinite(w1_1) ...
    && isfinite(w1_2) ...
    && isfinite(w1_3) ...
    && isfinite(w2_2) ...
    && isfinite(w2_3) ...
    && isfinite(w3_3) ...
    && isfinite(b_1) ...
    && isfinite(b_2) ...
    && isfinite(b_3) ...
    && (given.h * given.h * given.h >= single(1.0000000031710769e-30)) ...
    && (single(1.0) / (given.h * given.h * given.h) >= single(1.0000000031710769e-30)))
    error('stage19:param', 'the coefficients leave the range of numbers: take gains, rates and sample periods nearer to 1');
end
self.start = uint32(0);
self.samples = samples;
self.deadbeat = deadbeat;
self.w1_1 = w1_1;
self.w1_2 = w1_2;
self.w1_3 = w1_3;
self.w2_2 = w2_2;
self.w2_3 = w2_3;
self.w3_3 = w3_3;
self.b_1 = b_1;
self.b_2 = b_2;
self.b_3 = b_3;
end

function r = pick(condition, yes, no)
if condition
    r = yes;
else
    r = no;
end
end
