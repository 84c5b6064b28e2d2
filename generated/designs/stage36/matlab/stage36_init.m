function self = stage36_init(params) %#codegen
%STAGE36_INIT Takes the parameters and arms at tick 0.
%
%   self = stage36_init(params) is the controller, for the functions that stand beside this one. A
%   parameter outside its domain, or coefficients that leave the range of numbers, raise an error
%   stage36:param, which names what is wrong and what is legal.
%
%   params is a struct:
%     samples: samples N from the start to rest [samples], at least 2
%     u_max: bound of |u| [unit of u], > 0, infinity allowed
%     a: rate of stretched time [1/s], from 1e-18 to 1e18
%     k(1:2): gains k_i of pi0 = -sum k_i xi_i [1/s^2], finite
%     deadbeat: samples to go at which deadbeat takes over, 0 for a safe default [samples], finite

% Prescribed-time controller stage36: outputs of order 2, 2, clock in samples.
%
% DO NOT EDIT. Made by:
%   ptc-codegen emit --lang matlab --mu exp --name stage36 --clock samples --precision f32 --eps=0 --states="q1, q2, w1, w2" --inputs=F1,F2 --inertia="[[2, 1/2], [1/2, 1]]" --bias="3*q1 - c*q2 + w1/4, c*q2" --param c=2 --sample-time=0.02
% Version 0.1.0, design 9c23f2154001.
%
% Plant: the inputs F1, F2: q = (q1, q2), q' = (w1, w2), M q'' + bias = u, M = [[2, 1/2],
%       [1/2, 1]], bias = [3*q1 - c*q2 + w1/4, c*q2]; u held from sample to sample.
% Goal: x = 0 at sample N after the start, exact up to rounding, from any state, as long as
%       no u is clipped and nothing else acts on the plant.
% Law of each output, of order n, in its chain xi as it is sampled, which is the output with
%       its derivatives up to O(h), and which held inputs move exactly: with M - s samples to
%       go and z = S xi, v h^n = sum of row_j z_j h^(j-1)/((M-j+1)...(M-n+1)); the rows are
%       those of Theorem 1 for the mapping exp. xi_j of output i is xj_i in step, and v_i is
%       law_i. s = 0, 0. Output 1: Close to the end deadbeat takes over. Output 2: Close to
%       the end deadbeat takes over.
% Output 1, of order n = 2, to four digits:
%   xi_1 = q1 - 4.762e-6*w1 + 5.443e-11*w2
%   xi_2 = w1 - 5.715e-5*w2
%   f_1 = -1.712*q1 + 1.712*q2 - 0.1598*w1 + 0.01713*w2
% Output 2, of order n = 2, to four digits:
%   xi_1 = q2 + 2.381e-6*w1 - 2.722e-11*w2
%   xi_2 = -2.858e-5*w1 + w2
%   f_2 = 0.8558*q1 - 2.856*q2 + 0.07988*w1 - 0.02856*w2
% u = G^-1 w with w_i = v_i - f_i, to four digits:
%   G^-1 = [[2.003, 0.4999], [0.5, 1]]
% Outputs: 2, each with a law of its own, with this deadline and mapping; u_max is of the
%       input of this number.
%
% Parameters:
%   samples [samples]: samples N from the start to rest
%   h = 0.02 [s], fixed: sample period
%   eps = 0 [s], fixed: time-to-go at which the gains are held
%   u_max [unit of u]: bound of |u|
%   a [1/s]: rate of stretched time
%   k_1 [1/s^2]: gains k_i of pi0 = -sum k_i xi_i
%   k_2 [1/s]: gains k_i of pi0 = -sum k_i xi_i
%   deadbeat [samples]: samples to go at which deadbeat takes over, 0 for a safe default
%   c = 2 [as in its expression], fixed: parameter of an expression of the design
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
%   envelope: not checked: `x_max` is not given.
%   zeros: sound: none: the relative degrees are 2, 2, whose sum is the number of states.

given.samples = uint32(params.samples);
if given.samples ~= params.samples
    error('stage36:param', 'params.samples is %g; legal: 0..2^32 - 1', params.samples);
end
given.u_max = single(params.u_max);
given.a = single(params.a);
given.k = single(params.k);
if numel(params.k) ~= 2
    error('stage36:param', 'params.k has %d numbers; legal: 2', numel(params.k));
end
given.deadbeat = single(params.deadbeat);
if ~(given.samples > uint32(1))
    error('stage36:param', 'params.samples is %g; legal: >= 2', params.samples);
end
if ~(given.u_max > single(0.0))
    error('stage36:param', 'params.u_max is %g; legal: > 0', params.u_max);
end
if ~((single(1.000000045813705e-18) <= given.a) && (given.a <= single(9.999999843067494e17)))
    error('stage36:param', 'params.a is %g; legal: from 1.000000045813705e-18 to 9.999999843067494e17', params.a);
end
if ~isfinite(given.k(1))
    error('stage36:param', 'params.k(1) is %g; legal: finite', params.k(1));
end
if ~isfinite(given.k(2))
    error('stage36:param', 'params.k(2) is %g; legal: finite', params.k(2));
end
if ~(isfinite(given.deadbeat) && (given.deadbeat >= single(0.0)))
    error('stage36:param', 'params.deadbeat is %g; legal: >= 0', params.deadbeat);
end
samples = given.samples;
s1 = ((given.k(2) / given.a) - single(1.0)) + single(2.0);
s2 = pick(s1 < single(4.0), single(4.0), s1);
deadbeat_1 = pick(given.deadbeat > single(0.0), given.deadbeat, s2);
w1_1_1 = single(2500.0) * (-(given.k(1) / (given.a * given.a)));
w1_2_1 = single(50.0) * ((-single(0.5)) * (-(given.k(1) / (given.a * given.a))));
w2_2_1 = single(50.0) * (single(1.0) - (given.k(2) / given.a));
u_max = given.u_max;
if ~(isfinite(deadbeat_1) && isfinite(w1_1_1) && isfinite(w1_2_1) && isfinite(w2_2_1))
    error('stage36:param', 'the coefficients leave the range of numbers: take gains, rates and sample periods nearer to 1');
end
self.start = uint32(0);
self.samples = samples;
self.deadbeat_1 = deadbeat_1;
self.w1_1_1 = w1_1_1;
self.w1_2_1 = w1_2_1;
self.w2_2_1 = w2_2_1;
self.u_max = u_max;
end

function r = pick(condition, yes, no)
if condition
    r = yes;
else
    r = no;
end
end
