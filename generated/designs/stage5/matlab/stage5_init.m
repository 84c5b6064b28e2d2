function self = stage5_init(params) %#codegen
%STAGE5_INIT Takes the parameters and arms at tick 0.
%
%   self = stage5_init(params) is the controller, for the functions that stand beside this one. A
%   parameter outside its domain, or coefficients that leave the range of numbers, raise an error
%   stage5:param, which names what is wrong and what is legal.
%
%   params is a struct:
%     samples: samples N from the start to rest [samples], at least 6
%     h: sample period [s], from 1e-150 to 1e150
%     u_max: bound of |u| [unit of u], > 0, infinity allowed
%     a: rate of stretched time [1/s], from 1e-150 to 1e150
%     k(1:6): gains k_i of pi0 = -sum k_i xi_i [1/s^6], finite
%     deadbeat: samples to go at which deadbeat takes over, 0 for a safe default [samples], finite

% Prescribed-time controller stage5: order n = 4, clock in samples.
%
% DO NOT EDIT. Made by:
%   ptc-codegen emit --lang matlab --n 4 --mu exp --name stage5 --clock samples --guard none --eps=0.01 --delay=2
% Version 0.1.0, design af29f716abf2.
%
% Plant: x1' = x2, ..., x4' = u; u held from sample to sample, 2 samples late.
% Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
%       sample period, as long as u is not clipped and nothing else acts on the plant.
% Law: with M samples to go and z = S x, u h^6 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-5));
%       the rows are those of Theorem 1 for the mapping exp. Close to the end deadbeat takes
%       over.
%
% Parameters:
%   samples [samples]: samples N from the start to rest
%   h [s]: sample period
%   eps = 0.01 [s], fixed: time-to-go at which the gains are held
%   u_max [unit of u]: bound of |u|
%   a [1/s]: rate of stretched time
%   k_1 [1/s^6]: gains k_i of pi0 = -sum k_i xi_i
%   k_2 [1/s^5]: gains k_i of pi0 = -sum k_i xi_i
%   k_3 [1/s^4]: gains k_i of pi0 = -sum k_i xi_i
%   k_4 [1/s^3]: gains k_i of pi0 = -sum k_i xi_i
%   k_5 [1/s^2]: gains k_i of pi0 = -sum k_i xi_i
%   k_6 [1/s]: gains k_i of pi0 = -sum k_i xi_i
%   deadbeat [samples]: samples to go at which deadbeat takes over, 0 for a safe default
%
% k counts samples and may wrap; arm again within 2^32 - N samples.
% From sample N on the last gains are held (status HOLD).
% |u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
%       lasts.
% Guard none: finite measurements are the responsibility of the caller.
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
    error('stage5:param', 'params.samples is %g; legal: 0..2^32 - 1', params.samples);
end
given.h = double(params.h);
given.u_max = double(params.u_max);
given.a = double(params.a);
given.k = double(params.k);
if numel(params.k) ~= 6
    error('stage5:param', 'params.k has %d numbers; legal: 6', numel(params.k));
end
given.deadbeat = double(params.deadbeat);
if ~(given.samples > uint32(5))
    error('stage5:param', 'params.samples is %g; legal: >= 6', params.samples);
end
if ~((1e-150 <= given.h) && (given.h <= 1e150))
    error('stage5:param', 'params.h is %g; legal: from 1e-150 to 1e150', params.h);
end
if ~(given.u_max > 0.0)
    error('stage5:param', 'params.u_max is %g; legal: > 0', params.u_max);
end
if ~((1e-150 <= given.a) && (given.a <= 1e150))
    error('stage5:param', 'params.a is %g; legal: from 1e-150 to 1e150', params.a);
end
if ~isfinite(given.k(1))
    error('stage5:param', 'params.k(1) is %g; legal: finite', params.k(1));
end
if ~isfinite(given.k(2))
    error('stage5:param', 'params.k(2) is %g; legal: finite', params.k(2));
end
if ~isfinite(given.k(3))
    error('stage5:param', 'params.k(3) is %g; legal: finite', params.k(3));
end
if ~isfinite(given.k(4))
    error('stage5:param', 'params.k(4) is %g; legal: finite', params.k(4));
end
if ~isfinite(given.k(5))
    error('stage5:param', 'params.k(5) is %g; legal: finite', params.k(5));
end
if ~isfinite(given.k(6))
    error('stage5:param', 'params.k(6) is %g; legal: finite', params.k(6));
end
if ~(isfinite(given.deadbeat) && (given.deadbeat >= 0.0))
    error('stage5:param', 'params.deadbeat is %g; legal: >= 0', params.deadbeat);
end
samples = given.samples;
hold = 0.01 / given.h;
s1 = given.a * given.a * given.a * given.a * given.a;
s2 = 1.0 / (given.h * given.h * given.h * given.h);
w1_1 = (-(given.k(1) / (s1 * given.a))) * s2;
s3 = given.a * given.a * given.a * given.a * given.a;
s4 = (-1.5) * (-(given.k(1) / (s3 * given.a)));
w1_2 = s4 * (1.0 / (given.h * given.h * given.h));
s5 = given.a * given.a * given.a * given.a * given.a;
s6 = 0.9166666666666666 * (-(given.k(1) / (s5 * given.a)));
w1_3 = s6 * (1.0 / (given.h * given.h));
s7 = given.a * given.a * given.a * given.a * given.a;
w1_4 = (-0.25) * (-(given.k(1) / (s7 * given.a))) * (1.0 / given.h);
s8 = given.a * given.a * given.a * given.a * given.a;
s9 = given.a * given.a * given.a * given.a;
s10 = given.k(4) / (given.a * given.a * given.a);
s11 = ((1.0 - (given.k(2) / s8)) + (given.k(3) / s9)) - s10;
s12 = s11 + (given.k(5) / (given.a * given.a));
s13 = 1.0 / (given.h * given.h * given.h);
w2_2 = (s12 - (given.k(6) / given.a)) * s13;
s14 = given.a * given.a * given.a * given.a * given.a;
s15 = given.a * given.a * given.a * given.a;
s16 = given.k(4) / (given.a * given.a * given.a);
s17 = ((1.0 - (given.k(2) / s14)) + (given.k(3) / s15)) - s16;
s18 = s17 + (given.k(5) / (given.a * given.a));
s19 = -(s18 - (given.k(6) / given.a));
w2_3 = s19 * (1.0 / (given.h * given.h));
s20 = given.a * given.a * given.a * given.a * given.a;
s21 = given.a * given.a * given.a * given.a;
s22 = given.k(4) / (given.a * given.a * given.a);
s23 = ((1.0 - (given.k(2) / s20)) + (given.k(3) / s21)) - s22;
s24 = s23 + (given.k(5) / (given.a * given.a));
s25 = 0.3333333333333333 * (s24 - (given.k(6) / given.a));
w2_4 = s25 * (1.0 / given.h);
s26 = given.a * given.a * given.a * given.a;
s27 = 3.0 * (given.k(4) / (given.a * given.a * given.a));
s28 = 7.0 * (given.k(5) / (given.a * given.a));
s29 = (((-31.0) - (given.k(3) / s26)) + s27) - s28;
s30 = s29 + (15.0 * (given.k(6) / given.a));
w3_3 = s30 * (1.0 / (given.h * given.h));
s31 = given.a * given.a * given.a * given.a;
s32 = 3.0 * (given.k(4) / (given.a * given.a * given.a));
s33 = 7.0 * (given.k(5) / (given.a * given.a));
s34 = (((-31.0) - (given.k(3) / s31)) + s32) - s33;
s35 = (-0.5) * (s34 + (15.0 * (given.k(6) / given.a)));
w3_4 = s35 * (1.0 / given.h);
s36 = 90.0 - (given.k(4) / (given.a * given.a * given.a));
s37 = s36 + (6.0 * (given.k(5) / (given.a * given.a)));
w4_4 = (s37 - (25.0 * (given.k(6) / given.a))) * (1.0 / given.h);
s38 = (-65.0) - (given.k(5) / (given.a * given.a));
w5_6 = s38 + (10.0 * (given.k(6) / given.a));
w6_5 = 15.0 - (given.k(6) / given.a);
w6_6 = -(15.0 - (given.k(6) / given.a));
b_1 = -(1.0 / (given.h * given.h * given.h * given.h));
b_2 = (-4.5) * (1.0 / (given.h * given.h * given.h));
b_3 = (-9.916666666666666) * (1.0 / (given.h * given.h));
b_4 = (-14.25) * (1.0 / given.h);
u_max = given.u_max;
if ~(isfinite(hold) ...
    && isfinite(w1_1) ...
    && isfinite(w1_2) ...
    && isfinite(w1_3) ...
    && isfinite(w1_4) ...
    && isfinite(w2_2) ...
    && isfinite(w2_3) ...
    && isfinite(w2_4) ...
    && isfinite(w3_3) ...
    && isfinite(w3_4) ...
    && isfinite(w4_4) ...
    && isfinite(w5_6) ...
    && isfinite(w6_5) ...
    && isfinite(w6_6) ...
    && isfinite(b_1) ...
    && isfinite(b_2) ...
    && isfinite(b_3) ...
    && isfinite(b_4) ...
    && (given.h * given.h * given.h * given.h >= 1e-200) ...
    && (1.0 / (given.h * given.h * given.h * given.h) >= 1e-200))
    error('stage5:param', 'the coefficients leave the range of numbers: take gains, rates and sample periods nearer to 1');
end
self.start = uint32(0);
self.samples = samples;
self.u1 = 0.0;
self.u2 = 0.0;
self.hold = hold;
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
self.w5_6 = w5_6;
self.w6_5 = w6_5;
self.w6_6 = w6_6;
self.b_1 = b_1;
self.b_2 = b_2;
self.b_3 = b_3;
self.b_4 = b_4;
self.u_max = u_max;
end
