function self = stage27_init(params) %#codegen
%STAGE27_INIT Takes the parameters and arms at tick 0.
%
%   self = stage27_init(params) is the controller, for the functions that stand beside this one. A
%   parameter outside its domain, or coefficients that leave the range of numbers, raise an error
%   stage27:param, which names what is wrong and what is legal.
%
%   params is a struct:
%     samples: samples N from the start to rest [samples], at least 2
%     h: sample period [s], from 1e-150 to 1e150

% Prescribed-time controller stage27: outputs of order 1, 2, 1, 2, clock in samples.
%
% DO NOT EDIT. Made by:
%   ptc-codegen emit --lang matlab --mu "exp(a=0.8)" --name stage27 --clock samples --eps=0 --u-max=inf --poles="[[-4],[-3,-4],[-5],[-2.5,-6]]" --states="a, b, b1, c, d, d1" --inputs=A,B,C,D --outputs="a, b, c, d" --dynamics="A*(2 + b^2) + B - a*c, b1, B*(3 + a) + C*d - b*d1, C + D*a - c^2, d1, D*(2 - b) + A*c + a"
% Version 0.1.0, design 7fcab43de361.
%
% Plant: the inputs A, B, C, D: a' = A*(2 + b^2) + B - a*c, b' = b1, b1' = B*(3 + a) + C*d -
%       b*d1, c' = C + D*a - c^2, d' = d1, d1' = D*(2 - b) + A*c + a, output 1 = a, output 2
%       = b, output 3 = c, output 4 = d; u held from sample to sample.
% Goal: every output with its derivatives is 0 at sample N after the start, from any state,
%       as long as no u is clipped and the plant is the model. The plant is known at the
%       samples alone, which leaves an error of order h^(n+2-i) in x_i of an output of order
%       n.
% Law of each output, of order n: with M - s samples to go and z = S x, v h^n = sum of row_j
%       z_j h^(j-1)/((M-j+1)...(M-n+1)); the rows are those of Theorem 1 for the mapping exp.
%       v_i is law_i in step. s = 3, -2, -1, -2. Output 1: The gains of 1 sample to go stay:
%       they are deadbeat. Rest is planned 1 sample early, and the last gains bring down what
%       f and g did between samples. Output 2: From 6 samples to go on these are M - 3 and
%       the exponents 4, 5, those of least energy. The gains of 2 samples to go stay: they
%       are deadbeat. Rest is planned 2 samples early, and the last gains bring down what f
%       and g did between samples. Output 3: From 7 samples to go on these are M - 6 and the
%       exponents 7, those of least energy. The gains of 1 sample to go stay: they are
%       deadbeat. Rest is planned 1 sample early, and the last gains bring down what f and g
%       did between samples. Output 4: From 9 samples to go on these are M - 3 and the
%       exponents 4, 5, those of least energy. The gains of 2 samples to go stay: they are
%       deadbeat. Rest is planned 2 samples early, and the last gains bring down what f and g
%       did between samples.
% Output 1, of order n = 1:
%   x_1 = a
%   f_1 = -a*c
% Output 2, of order n = 2:
%   x_1 = b
%   x_2 = b1
%   f_2 = -b*d1
% Output 3, of order n = 1:
%   x_1 = c
%   f_3 = -c^2
% Output 4, of order n = 2:
%   x_1 = d
%   x_2 = d1
%   f_4 = a
% u of D u = w with w_i = v_i - f_i, by elimination with pivots:
%   D = [[2 + b^2, 1, 0, 0], [0, 3 + a, d, 0], [0, 0, 1, a], [c, 0, 0, 2 - b]]
% Outputs: 4, each with a law of its own, with this deadline and mapping; u_max is of the
%       input of this number.
%   output 1: k = 4
%   output 2: k = 12, 7
%   output 3: k = 5
%   output 4: k = 15, 8.5
%
% Parameters:
%   samples [samples]: samples N from the start to rest
%   h [s]: sample period
%   eps = 0 [s], fixed: time-to-go at which the gains are held
%   u_max = inf [unit of u], fixed: bound of |u|
%   a = 0.8 [1/s], fixed: rate of stretched time
%
% k counts samples and may wrap; arm again within 2^32 - N samples.
% From sample N on the last gains are held (status HOLD).
% u is not clipped.
% Guard full: what is measured is finite, or the call is refused (INPUT).
% Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
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
%   zeros: sound: none: the relative degrees are 1, 2, 1, 2, whose sum is the number of
%       states.

given.samples = uint32(params.samples);
if given.samples ~= params.samples
    error('stage27:param', 'params.samples is %g; legal: 0..2^32 - 1', params.samples);
end
given.h = double(params.h);
if ~(given.samples > uint32(1))
    error('stage27:param', 'params.samples is %g; legal: >= 2', params.samples);
end
if ~((1e-150 <= given.h) && (given.h <= 1e150))
    error('stage27:param', 'params.h is %g; legal: from 1e-150 to 1e150', params.h);
end
samples = given.samples;
w1_1_1 = (-5.0) * (1.0 / given.h);
w1_1_2 = (-18.75) * (1.0 / (given.h * given.h));
w1_2_2 = 9.375 * (1.0 / given.h);
w2_2_2 = (-7.75) * (1.0 / given.h);
end1_1_2 = (-20.0) * (1.0 / (given.h * given.h));
end1_2_2 = 10.0 * (1.0 / given.h);
end2_2_2 = (-8.0) * (1.0 / given.h);
w1_1_3 = (-6.25) * (1.0 / given.h);
end1_1_3 = (-7.0) * (1.0 / given.h);
w1_1_4 = (-23.4375) * (1.0 / (given.h * given.h));
w1_2_4 = 11.71875 * (1.0 / given.h);
w2_2_4 = (-9.625) * (1.0 / given.h);
if ~(isfinite(w1_1_1) ...
    && isfinite(w1_1_2) ...
    && isfinite(w1_2_2) ...
    && isfinite(w2_2_2) ...
    && isfinite(end1_1_2) ...
    && isfinite(end1_2_2) ...
    && isfinite(end2_2_2) ...
    && isfinite(w1_1_3) ...
    && isfinite(end1_1_3) ...
    && isfinite(w1_1_4) ...
    && isfinite(w1_2_4) ...
    && isfinite(w2_2_4) ...
    && (given.h * given.h >= 1e-200) ...
    && (1.0 / (given.h * given.h) >= 1e-200))
    error('stage27:param', 'the coefficients leave the range of numbers: take gains, rates and sample periods nearer to 1');
end
self.start = uint32(0);
self.samples = samples;
self.w1_1_1 = w1_1_1;
self.w1_1_2 = w1_1_2;
self.w1_2_2 = w1_2_2;
self.w2_2_2 = w2_2_2;
self.end1_1_2 = end1_1_2;
self.end1_2_2 = end1_2_2;
self.end2_2_2 = end2_2_2;
self.w1_1_3 = w1_1_3;
self.end1_1_3 = end1_1_3;
self.w1_1_4 = w1_1_4;
self.w1_2_4 = w1_2_4;
self.w2_2_4 = w2_2_4;
end
