function self = stage26_init(params) %#codegen
%STAGE26_INIT Takes the parameters and arms at tick 0.
%
%   self = stage26_init(params) is the controller, for the functions that stand beside this one. A
%   parameter outside its domain, or coefficients that leave the range of numbers, raise an error
%   stage26:param, which names what is wrong and what is legal.
%
%   params is a struct:
%     samples: samples N from the start to rest [samples], at least 2
%     h: sample period [s], from 1e-18 to 1e18
%     u_max: bound of |u| [unit of u], > 0, infinity allowed
%     a: rate of stretched time [1/s], from 1e-18 to 1e18
%     k(1:2): gains k_i of pi0 = -sum k_i xi_i [1/s^2], finite
%     deadbeat: samples to go at which deadbeat takes over, 0 for a safe default [samples], finite
%     m: parameter of an expression of the design [as in its expression], finite

% Prescribed-time controller stage26: outputs of order 2, 2, clock in samples.
%
% DO NOT EDIT. Made by:
%   ptc-codegen emit --lang matlab --mu exp --name stage26 --clock samples --precision f32 --guard none --eps=0 --states="q1, q2, w1, w2" --inputs=F1,F2 --inertia="[[m + q2^2, q2], [q2, 1]]" --bias="m*q2*w1*w2, w1^2/2 - q1"
% Version 0.1.0, design 7cc34530b578.
%
% Plant: the inputs F1, F2: q = (q1, q2), q' = (w1, w2), M q'' + bias = u, M = [[m + q2^2,
%       q2], [q2, 1]], bias = [m*q2*w1*w2, w1^2/2 - q1]; u held from sample to sample.
% Goal: every output with its derivatives is 0 at sample N after the start, from any state,
%       as long as no u is clipped and the plant is the model. The plant is known at the
%       samples alone, which leaves an error of order h^(n+2-i) in x_i of an output of order
%       n.
% Law of each output, of order n: with M - s samples to go and z = S x, v h^n = sum of row_j
%       z_j h^(j-1)/((M-j+1)...(M-n+1)); the rows are those of Theorem 1 for the mapping exp.
%       v_i is law_i in step. s = 0, 0. Output 1: Close to the end deadbeat takes over.
%       Output 2: Close to the end deadbeat takes over.
% Output 1, of order n = 2:
%   x_1 = q1
%   x_2 = w1
% Output 2, of order n = 2:
%   x_1 = q2
%   x_2 = w2
% u = M v + bias
% Outputs: 2, each with a law of its own, with this deadline and mapping; u_max is of the
%       input of this number.
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
%   m [as in its expression]: parameter of an expression of the design
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
%   growth: sound: at rest at sample N from any state, but for what f + g u does between
%       samples, whatever the poles, and |u| is bounded.
%   sampling: not checked: `loop` bounds what the period leaves of a plant with several
%       inputs.
%   deadline: not checked: `loop` bounds what the period leaves of a plant with several
%       inputs.
%   loop: not checked: `samples` is left to run time.
%   envelope: not checked: `x_max` is not given.
%   zeros: sound: none: the relative degrees are 2, 2, whose sum is the number of states.

given.samples = uint32(params.samples);
if given.samples ~= params.samples
    error('stage26:param', 'params.samples is %g; legal: 0..2^32 - 1', params.samples);
end
given.h = single(params.h);
given.u_max = single(params.u_max);
given.a = single(params.a);
given.k = single(params.k);
if numel(params.k) ~= 2
    error('stage26:param', 'params.k has %d numbers; legal: 2', numel(params.k));
end
given.deadbeat = single(params.deadbeat);
given.m = single(params.m);
if ~(given.samples > uint32(1))
    error('stage26:param', 'params.samples is %g; legal: >= 2', params.samples);
end
if ~((single(1.000000045813705e-18) <= given.h) && (given.h <= single(9.999999843067494e17)))
    error('stage26:param', 'params.h is %g; legal: from 1.000000045813705e-18 to 9.999999843067494e17', params.h);
end
if ~(given.u_max > single(0.0))
    error('stage26:param', 'params.u_max is %g; legal: > 0', params.u_max);
end
if ~((single(1.000000045813705e-18) <= given.a) && (given.a <= single(9.999999843067494e17)))
    error('stage26:param', 'params.a is %g; legal: from 1.000000045813705e-18 to 9.999999843067494e17', params.a);
end
if ~isfinite(given.k(1))
    error('stage26:param', 'params.k(1) is %g; legal: finite', params.k(1));
end
if ~isfinite(given.k(2))
    error('stage26:param', 'params.k(2) is %g; legal: finite', params.k(2));
end
if ~(isfinite(given.deadbeat) && (given.deadbeat >= single(0.0)))
    error('stage26:param', 'params.deadbeat is %g; legal: >= 0', params.deadbeat);
end
if ~isfinite(given.m)
    error('stage26:param', 'params.m is %g; legal: finite', params.m);
end
samples = given.samples;
s1 = ((given.k(2) / given.a) - single(1.0)) + single(2.0);
s2 = pick(s1 < single(4.0), single(4.0), s1);
deadbeat_1 = pick(given.deadbeat > single(0.0), given.deadbeat, s2);
s3 = -(given.k(1) / (given.a * given.a));
w1_1_1 = s3 * (single(1.0) / (given.h * given.h));
s4 = (-single(0.5)) * (-(given.k(1) / (given.a * given.a)));
w1_2_1 = s4 * (single(1.0) / given.h);
w2_2_1 = (single(1.0) - (given.k(2) / given.a)) * (single(1.0) / given.h);
b_1_1 = -(single(1.0) / (given.h * given.h));
b_2_1 = (-single(1.5)) * (single(1.0) / given.h);
p_m = given.m;
u_max = given.u_max;
if ~(isfinite(deadbeat_1) ...
    && isfinite(w1_1_1) ...
    && isfinite(w1_2_1) ...
    && isfinite(w2_2_1) ...
    && isfinite(b_1_1) ...
    && isfinite(b_2_1) ...
    && (given.h * given.h >= single(1.0000000031710769e-30)) ...
    && (single(1.0) / (given.h * given.h) >= single(1.0000000031710769e-30)))
    error('stage26:param', 'the coefficients leave the range of numbers: take gains, rates and sample periods nearer to 1');
end
self.start = uint32(0);
self.samples = samples;
self.deadbeat_1 = deadbeat_1;
self.w1_1_1 = w1_1_1;
self.w1_2_1 = w1_2_1;
self.w2_2_1 = w2_2_1;
self.b_1_1 = b_1_1;
self.b_2_1 = b_2_1;
self.p_m = p_m;
self.u_max = u_max;
end

function r = pick(condition, yes, no)
if condition
    r = yes;
else
    r = no;
end
end
