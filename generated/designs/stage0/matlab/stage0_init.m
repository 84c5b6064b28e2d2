function self = stage0_init(params) %#codegen
%STAGE0_INIT Takes the parameters and arms at tick 0.
%
%   self = stage0_init(params) is the controller, for the functions that stand beside this one. A
%   parameter outside its domain, or coefficients that leave the range of numbers, raise an error
%   stage0:param, which names what is wrong and what is legal.
%
%   params is a struct:
%     samples: samples N from the start to rest [samples], at least 1
%     h: sample period [s], from 1e-150 to 1e150
%     u_max: bound of |u| [unit of u], > 0, infinity allowed
%     a: rate of stretched time [1/s], from 1e-150 to 1e150
%     k(1:1): gains k_i of pi0 = -sum k_i xi_i [1/s], finite
%     deadbeat: samples to go at which deadbeat takes over, 0 for a safe default [samples], finite

% Prescribed-time controller stage0: order n = 1, clock in samples.
%
% DO NOT EDIT. Made by:
%   ptc-codegen emit --lang matlab --n 1 --mu exp --name stage0 --clock samples --eps=0
% Version 0.1.0, design 14ec59d52490.
%
% Plant: x1' = u; u held from sample to sample.
% Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
%       sample period, as long as u is not clipped and nothing else acts on the plant.
% Law: with M samples to go and z = S x, u h^1 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-0));
%       the rows are those of Theorem 1 for the mapping exp. Close to the end deadbeat takes
%       over.
%
% Parameters:
%   samples [samples]: samples N from the start to rest
%   h [s]: sample period
%   eps = 0 [s], fixed: time-to-go at which the gains are held
%   u_max [unit of u]: bound of |u|
%   a [1/s]: rate of stretched time
%   k_1 [1/s]: gains k_i of pi0 = -sum k_i xi_i
%   deadbeat [samples]: samples to go at which deadbeat takes over, 0 for a safe default
%
% k counts samples and may wrap; arm again within 2^32 - N samples.
% From sample N on the last gains are held (status HOLD).
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
    error('stage0:param', 'params.samples is %g; legal: 0..2^32 - 1', params.samples);
end
given.h = double(params.h);
given.u_max = double(params.u_max);
given.a = double(params.a);
given.k = double(params.k);
if numel(params.k) ~= 1
    error('stage0:param', 'params.k has %d numbers; legal: 1', numel(params.k));
end
given.deadbeat = double(params.deadbeat);
if ~(given.samples > uint32(0))
    error('stage0:param', 'params.samples is %g; legal: >= 1', params.samples);
end
if ~((1e-150 <= given.h) && (given.h <= 1e150))
    error('stage0:param', 'params.h is %g; legal: from 1e-150 to 1e150', params.h);
end
if ~(given.u_max > 0.0)
    error('stage0:param', 'params.u_max is %g; legal: > 0', params.u_max);
end
if ~((1e-150 <= given.a) && (given.a <= 1e150))
    error('stage0:param', 'params.a is %g; legal: from 1e-150 to 1e150', params.a);
end
if ~isfinite(given.k(1))
    error('stage0:param', 'params.k(1) is %g; legal: finite', params.k(1));
end
if ~(isfinite(given.deadbeat) && (given.deadbeat >= 0.0))
    error('stage0:param', 'params.deadbeat is %g; legal: >= 0', params.deadbeat);
end
samples = given.samples;
s1 = (given.k(1) / given.a) + 1.0;
s2 = pick(s1 < 2.0, 2.0, s1);
deadbeat = pick(given.deadbeat > 0.0, given.deadbeat, s2);
w1_1 = (-(given.k(1) / given.a)) * (1.0 / given.h);
b_1 = -(1.0 / given.h);
u_max = given.u_max;
if ~(isfinite(deadbeat) && isfinite(w1_1) && isfinite(b_1))
    error('stage0:param', 'the coefficients leave the range of numbers: take gains, rates and sample periods nearer to 1');
end
if ~(given.h >= 1e-200)
    error('stage0:param', 'params.h is %g; legal: >= 1e-200', params.h);
end
if ~(1.0 / given.h >= 1e-200)
    error('stage0:param', 'the coefficients leave the range of numbers: take gains, rates and sample periods nearer to 1');
end
self.start = uint32(0);
self.samples = samples;
self.deadbeat = deadbeat;
self.w1_1 = w1_1;
self.b_1 = b_1;
self.u_max = u_max;
end

function r = pick(condition, yes, no)
if condition
    r = yes;
else
    r = no;
end
end
