function self = stage31_init(params) %#codegen
%STAGE31_INIT Takes the parameters and arms at tick 0.
%
%   self = stage31_init(params) is the controller, for the functions that stand beside this one. A
%   parameter outside its domain, or coefficients that leave the range of numbers, raise an error
%   stage31:param, which names what is wrong and what is legal.
%
%   params is a struct:
%     samples: samples N from the start to rest [samples], at least 2
%     h: sample period [s], from 1e-150 to 1e150

% Prescribed-time controller stage31: outputs of order 1, 2, clock in samples.
%
% DO NOT EDIT. Made by:
%   ptc-codegen emit --lang matlab --mu "exp(a=1)" --name stage31 --clock samples --eps=0 --limits=2,3 --poles="[[-4],[-3,-4.5]]" --states="h, c, e" --inputs=q,p --outputs="h, e" --dynamics="q - 1/10*h, p - c*(1 + h), (c - e)*(1 + h)" --reference input
% Version 0.1.0, design 2c157dacc07c.
%
% Plant: the inputs q, p: h' = q - 1/10*h, c' = p - c*(1 + h), e' = (c - e)*(1 + h), output 1
%       = h, output 2 = e; u held from sample to sample.
% Goal: every output with its derivatives is 0 at sample N after the start, from any state,
%       as long as no u is clipped and the plant is the model. The plant is known at the
%       samples alone, which leaves an error of order h^(n+2-i) in x_i of an output of order
%       n.
% Law of each output, of order n: with M - s samples to go and z = S x, v h^n = sum of row_j
%       z_j h^(j-1)/((M-j+1)...(M-n+1)); the rows are those of Theorem 1 for the mapping exp.
%       v_i is law_i in step. s = 2, -2. Output 1: The gains of 1 sample to go stay: they are
%       deadbeat. Rest is planned 1 sample early, and the last gains bring down what f and g
%       did between samples. Output 2: From 6 samples to go on these are M - 2 and the
%       exponents 3, 4, those of least energy. The gains of 2 samples to go stay: they are
%       deadbeat. Rest is planned 2 samples early, and the last gains bring down what f and g
%       did between samples.
% Output 1, of order n = 1:
%   x_1 = h
%   f_1 = -h/10
% Output 2, of order n = 2:
%   x_1 = e
%   x_2 = (c - e)*(1 + h)
%   f_2 = (-c*(1 + h) - (c - e)*(1 + h))*(1 + h) + (c - e)*(-h/10)
% u = adj(D) w/det(D) with w_i = v_i - f_i:
%   det(D) = 1 + h
%   adj(D) = [[1 + h, 0], [-(c - e), 1]]
% With a reference r of each output, e_i = x_i - r^(i-1) is in place of x_i above, and law_i
%       = v_i + rho of output i is in place of v_i. What r^(n) changes over a sample leaves
%       an error of order h^(n+2-i) in e_i at sample N, h^3 for n = 1, and none where it is
%       constant there.
% Row i of r is of output i, of order n: in its places 0..n-1 the reference and its
%       derivatives at tick k, and in place n rho, r^(n) over the sample in which u acts: its
%       mean, (r^(n-1)(t + h) - r^(n-1)(t))/h, or that in its middle.
% Outputs: 2, each with a law of its own, with this deadline and mapping; u_max is of the
%       input of this number.
%   output 1: k = 4; u_max = 2
%   output 2: k = 13.5, 7.5; u_max = 3
%
% Parameters:
%   samples [samples]: samples N from the start to rest
%   h [s]: sample period
%   eps = 0 [s], fixed: time-to-go at which the gains are held
%   a = 1 [1/s], fixed: rate of stretched time
%
% k counts samples and may wrap; arm again within 2^32 - N samples.
% From sample N on the last gains are held (status HOLD).
% |u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
%       lasts.
% Guard full: what is measured and the reference are finite, or the call is refused (INPUT).
% Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
%       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
%
% Checks of the design (details: ptc-codegen check):
%   membership: sound: exp is of class M for all its parameters.
%   growth: sound: at rest at sample N from any state, but for what f + g u and r do between
%       samples, whatever the poles, and |u| is bounded.
%   sampling: not checked: `loop` bounds what the period leaves of a plant with several
%       inputs.
%   deadline: not checked: `loop` bounds what the period leaves of a plant with several
%       inputs.
%   loop: not checked: `samples` is left to run time.
%   envelope: not checked: `x_max` is not given.
%   zeros: sound: none: the relative degrees are 1, 2, whose sum is the number of states.

given.samples = uint32(params.samples);
if given.samples ~= params.samples
    error('stage31:param', 'params.samples is %g; legal: 0..2^32 - 1', params.samples);
end
given.h = double(params.h);
if ~(given.samples > uint32(1))
    error('stage31:param', 'params.samples is %g; legal: >= 2', params.samples);
end
if ~((1e-150 <= given.h) && (given.h <= 1e150))
    error('stage31:param', 'params.h is %g; legal: from 1e-150 to 1e150', params.h);
end
samples = given.samples;
w1_1_1 = (-4.0) * (1.0 / given.h);
w1_1_2 = (-13.5) * (1.0 / (given.h * given.h));
w1_2_2 = 6.75 * (1.0 / given.h);
w2_2_2 = (-6.5) * (1.0 / given.h);
end1_1_2 = (-12.0) * (1.0 / (given.h * given.h));
end1_2_2 = 6.0 * (1.0 / given.h);
end2_2_2 = (-6.0) * (1.0 / given.h);
if ~(isfinite(w1_1_1) ...
    && isfinite(w1_1_2) ...
    && isfinite(w1_2_2) ...
    && isfinite(w2_2_2) ...
    && isfinite(end1_1_2) ...
    && isfinite(end1_2_2) ...
    && isfinite(end2_2_2) ...
    && (given.h * given.h >= 1e-200) ...
    && (1.0 / (given.h * given.h) >= 1e-200))
    error('stage31:param', 'the coefficients leave the range of numbers: take gains, rates and sample periods nearer to 1');
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
end
