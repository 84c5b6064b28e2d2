function self = stage28_init(params) %#codegen
%STAGE28_INIT Takes the parameters and arms at tick 0.
%
%   self = stage28_init(params) is the controller, for the functions that stand beside this one. A
%   parameter outside its domain, or coefficients that leave the range of numbers, raise an error
%   stage28:param, which names what is wrong and what is legal.
%
%   params is a struct:
%     samples: samples N from the start to rest [samples], at least 1
%     h: sample period [s], from 1e-150 to 1e150
%     u_max: bound of |u| [unit of u], > 0, infinity allowed
%     k: parameter of an expression of the design [as in its expression], finite

% Prescribed-time controller stage28: outputs of order 1, 1, clock in samples.
%
% DO NOT EDIT. Made by:
%   ptc-codegen emit --lang matlab --mu "exp(a=1)" --name stage28 --clock samples --deadbeat=9 --eps=0 --gains="[[3],[4.5]]" --states="a, b" --inputs=A,B --outputs="a, b" --dynamics="A*(b - 1), A + B - k*a"
% Version 0.1.0, design e8fd88f575ec.
%
% Plant: the inputs A, B: a' = A*(b - 1), b' = A + B - k*a, output 1 = a, output 2 = b; u
%       held from sample to sample.
% Goal: every output with its derivatives is 0 at sample N after the start, from any state,
%       as long as no u is clipped and the plant is the model. The plant is known at the
%       samples alone, which leaves an error of order h^(n+2-i) in x_i of an output of order
%       n.
% Law of each output, of order n: with M - s samples to go and z = S x, v h^n = sum of row_j
%       z_j h^(j-1)/((M-j+1)...(M-n+1)); the rows are those of Theorem 1 for the mapping exp.
%       v_i is law_i in step. s = 0, 0. Output 1: Close to the end, with 9 samples to go
%       deadbeat takes over. Output 2: Close to the end, with 9 samples to go deadbeat takes
%       over.
% Output 1, of order n = 1:
%   x_1 = a
% Output 2, of order n = 1:
%   x_1 = b
%   f_2 = -k*a
% u = adj(D) w/det(D) with w_i = v_i - f_i:
%   det(D) = b - 1
%   adj(D) = [[1, 0], [-1, b - 1]]
% Outputs: 2, each with a law of its own, with this deadline and mapping; u_max is of the
%       input of this number.
%   output 1: k = 3
%   output 2: k = 4.5
%
% Parameters:
%   samples [samples]: samples N from the start to rest
%   h [s]: sample period
%   eps = 0 [s], fixed: time-to-go at which the gains are held
%   u_max [unit of u]: bound of |u|
%   a = 1 [1/s], fixed: rate of stretched time
%   k [as in its expression]: parameter of an expression of the design
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
%   growth: sound: at rest at sample N from any state, but for what f + g u does between
%       samples, whatever the poles, and |u| is bounded.
%   sampling: not checked: `loop` bounds what the period leaves of a plant with several
%       inputs.
%   deadline: not checked: `loop` bounds what the period leaves of a plant with several
%       inputs.
%   loop: not checked: `samples` is left to run time.
%   envelope: not checked: `x_max` is not given.
%   zeros: sound: none: the relative degrees are 1, 1, whose sum is the number of states.

given.samples = uint32(params.samples);
if given.samples ~= params.samples
    error('stage28:param', 'params.samples is %g; legal: 0..2^32 - 1', params.samples);
end
given.h = double(params.h);
given.u_max = double(params.u_max);
given.k = double(params.k);
if ~(given.samples > uint32(0))
    error('stage28:param', 'params.samples is %g; legal: >= 1', params.samples);
end
if ~((1e-150 <= given.h) && (given.h <= 1e150))
    error('stage28:param', 'params.h is %g; legal: from 1e-150 to 1e150', params.h);
end
if ~(given.u_max > 0.0)
    error('stage28:param', 'params.u_max is %g; legal: > 0', params.u_max);
end
if ~isfinite(given.k)
    error('stage28:param', 'params.k is %g; legal: finite', params.k);
end
samples = given.samples;
w1_1_1 = (-3.0) * (1.0 / given.h);
b_1_1 = -(1.0 / given.h);
w1_1_2 = (-4.5) * (1.0 / given.h);
p_k = given.k;
c1 = -p_k;
u_max = given.u_max;
if ~(isfinite(w1_1_1) && isfinite(b_1_1) && isfinite(w1_1_2) && isfinite(c1))
    error('stage28:param', 'the coefficients leave the range of numbers: take gains, rates and sample periods nearer to 1');
end
if ~(given.h >= 1e-200)
    error('stage28:param', 'params.h is %g; legal: >= 1e-200', params.h);
end
if ~(1.0 / given.h >= 1e-200)
    error('stage28:param', 'the coefficients leave the range of numbers: take gains, rates and sample periods nearer to 1');
end
self.start = uint32(0);
self.samples = samples;
self.w1_1_1 = w1_1_1;
self.b_1_1 = b_1_1;
self.w1_1_2 = w1_1_2;
self.p_k = p_k;
self.c1 = c1;
self.u_max = u_max;
end
