function self = stage34_init(params) %#codegen
%STAGE34_INIT Takes the parameters and arms at tick 0.
%
%   self = stage34_init(params) is the controller, for the functions that stand beside this one. A
%   parameter outside its domain, or coefficients that leave the range of numbers, raise an error
%   stage34:param, which names what is wrong and what is legal.
%
%   params is a struct:
%     samples: samples N from the start to rest [samples], at least 3
%     h: sample period [s], from 1e-150 to 1e150
%     u_max: bound of |u| [unit of u], > 0, infinity allowed
%     a: rate of stretched time [1/s], from 1e-150 to 1e150
%     k(1:3): gains k_i of pi0 = -sum k_i xi_i [1/s^3], finite
%     deadbeat: samples to go at which deadbeat takes over, 0 for a safe default [samples], finite

% Prescribed-time controller stage34: order n = 3, clock in samples.
%
% DO NOT EDIT. Made by:
%   ptc-codegen emit --lang matlab --n 3 --axes 2 --mu exp --name stage34 --clock samples --guard none --eps=0 --g="3" --reference input
% Version 0.1.0, design 0d8dd7fc9d15.
%
% Plant: x1' = x2, ..., x3' = g u; u held from sample to sample.
% Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
%       sample period, as long as u is not clipped and nothing else acts on the plant.
% Law: with M samples to go and z = S x, u h^3 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-2));
%       the rows are those of Theorem 1 for the mapping exp. Close to the end deadbeat takes
%       over.
% With a reference r of each axis, e_i = x_i - r^(i-1) is in place of x_i above, and u = w +
%       rho/g of each axis. What r^(n) changes over a sample leaves an error of order
%       h^(n+2-i) in e_i at sample N, h^3 for n = 1, and none where it is constant there.
% Row i of r is of axis i, of order n: in its places 0..n-1 the reference and its derivatives
%       at tick k, and in place n rho, r^(n) over the sample in which u acts: its mean,
%       (r^(n-1)(t + h) - r^(n-1)(t))/h, or that in its middle.
% Axes: 2, each a chain of its own with this deadline and mapping. step computes what depends
%       on time once.
%
% Parameters:
%   samples [samples]: samples N from the start to rest
%   h [s]: sample period
%   eps = 0 [s], fixed: time-to-go at which the gains are held
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
% Guard none: finite measurements and references are the responsibility of the caller.
% Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
%       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
%
% Checks of the design (details: ptc-codegen check):
%   membership: sound: exp is of class M for all its parameters.
%   growth: sound: at rest at sample N from any state, but for what r does between samples,
%       whatever the poles, and |u| is bounded.
%   sampling: not checked: `loop` bounds what the period leaves of a reference that moves.
%   deadline: not checked: `loop` bounds what the period leaves of a reference that moves.
%   loop: not checked: `samples` is left to run time.
%   envelope: not checked: it does not examine a clock in samples.

given.samples = uint32(params.samples);
if given.samples ~= params.samples
    error('stage34:param', 'params.samples is %g; legal: 0..2^32 - 1', params.samples);
end
given.h = double(params.h);
given.u_max = double(params.u_max);
given.a = double(params.a);
given.k = double(params.k);
if numel(params.k) ~= 3
    error('stage34:param', 'params.k has %d numbers; legal: 3', numel(params.k));
end
given.deadbeat = double(params.deadbeat);
if ~(given.samples > uint32(2))
    error('stage34:param', 'params.samples is %g; legal: >= 3', params.samples);
end
if ~((1e-150 <= given.h) && (given.h <= 1e150))
    error('stage34:param', 'params.h is %g; legal: from 1e-150 to 1e150', params.h);
end
if ~(given.u_max > 0.0)
    error('stage34:param', 'params.u_max is %g; legal: > 0', params.u_max);
end
if ~((1e-150 <= given.a) && (given.a <= 1e150))
    error('stage34:param', 'params.a is %g; legal: from 1e-150 to 1e150', params.a);
end
if ~isfinite(given.k(1))
    error('stage34:param', 'params.k(1) is %g; legal: finite', params.k(1));
end
if ~isfinite(given.k(2))
    error('stage34:param', 'params.k(2) is %g; legal: finite', params.k(2));
end
if ~isfinite(given.k(3))
    error('stage34:param', 'params.k(3) is %g; legal: finite', params.k(3));
end
if ~(isfinite(given.deadbeat) && (given.deadbeat >= 0.0))
    error('stage34:param', 'params.deadbeat is %g; legal: >= 0', params.deadbeat);
end
samples = given.samples;
s1 = ((given.k(3) / given.a) - 4.0) + 3.0;
s2 = pick(s1 < 6.0, 6.0, s1);
deadbeat_1 = pick(given.deadbeat > 0.0, given.deadbeat, s2);
s3 = -(given.k(1) / (given.a * given.a * given.a));
s4 = 1.0 / (given.h * given.h * given.h);
w1_1_1 = 0.3333333333333333 * s3 * s4;
s5 = -(given.k(1) / (given.a * given.a * given.a));
w1_2_1 = (-0.3333333333333333) * s5 * (1.0 / (given.h * given.h));
s6 = -(given.k(1) / (given.a * given.a * given.a));
w1_3_1 = 0.1111111111111111 * s6 * (1.0 / given.h);
s7 = (-1.0) - (given.k(2) / (given.a * given.a));
s8 = 0.3333333333333333 * (s7 + (given.k(3) / given.a));
w2_2_1 = s8 * (1.0 / (given.h * given.h));
s9 = (-1.0) - (given.k(2) / (given.a * given.a));
s10 = (-0.16666666666666666) * (s9 + (given.k(3) / given.a));
w2_3_1 = s10 * (1.0 / given.h);
s11 = 0.3333333333333333 * (3.0 - (given.k(3) / given.a));
w3_3_1 = s11 * (1.0 / given.h);
s12 = 1.0 / (given.h * given.h * given.h);
b_1_1 = (-0.3333333333333333) * s12;
b_2_1 = (-0.6666666666666666) * (1.0 / (given.h * given.h));
b_3_1 = (-0.6111111111111112) * (1.0 / given.h);
u_max = given.u_max;
if ~(isfinite(deadbeat_1) ...
    && isfinite(w1_1_1) ...
    && isfinite(w1_2_1) ...
    && isfinite(w1_3_1) ...
    && isfinite(w2_2_1) ...
    && isfinite(w2_3_1) ...
    && isfinite(w3_3_1) ...
    && isfinite(b_1_1) ...
    && isfinite(b_2_1) ...
    && isfinite(b_3_1) ...
    && (given.h * given.h * given.h >= 1e-200) ...
    && (1.0 / (given.h * given.h * given.h) >= 1e-200))
    error('stage34:param', 'the coefficients leave the range of numbers: take gains, rates and sample periods nearer to 1');
end
self.start = uint32(0);
self.samples = samples;
self.deadbeat_1 = deadbeat_1;
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

function r = pick(condition, yes, no)
if condition
    r = yes;
else
    r = no;
end
end
