function self = stage10_init(params) %#codegen
%STAGE10_INIT Takes the parameters and arms at tick 0.
%
%   self = stage10_init(params) is the controller, for the functions that stand beside this one. A
%   parameter outside its domain, or coefficients that leave the range of numbers, raise an error
%   stage10:param, which names what is wrong and what is legal.
%
%   params is a struct:
%     samples: samples N from the start to rest [samples], at least 2
%     h: sample period [s], from 1e-18 to 1e18
%     u_max: bound of |u| [unit of u], > 0, infinity allowed
%     k(1:2): gains k_i of pi0 = -sum k_i xi_i [1/s^2], finite

% Prescribed-time controller stage10: order n = 2, clock in samples.
%
% DO NOT EDIT. Made by:
%   ptc-codegen emit --lang matlab --n 2 --mu "exp(a=1.3)" --name stage10 --clock samples --deadbeat=20 --precision f32 --eps=0
% Version 0.1.0, design 53d11c790cfa.
%
% Plant: x1' = x2, x2' = u; u held from sample to sample.
% Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
%       sample period, as long as u is not clipped and nothing else acts on the plant.
% Law: with M samples to go and z = S x, u h^2 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-1));
%       the rows are those of Theorem 1 for the mapping exp. Close to the end, with 20
%       samples to go deadbeat takes over.
%
% Parameters:
%   samples [samples]: samples N from the start to rest
%   h [s]: sample period
%   eps = 0 [s], fixed: time-to-go at which the gains are held
%   u_max [unit of u]: bound of |u|
%   a = 1.3 [1/s], fixed: rate of stretched time
%   k_1 [1/s^2]: gains k_i of pi0 = -sum k_i xi_i
%   k_2 [1/s]: gains k_i of pi0 = -sum k_i xi_i
%   deadbeat = 20 [samples], fixed: samples to go at which deadbeat takes over, 0 for a safe
%       default
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
%   envelope: not checked: it does not examine a clock in samples.

given.samples = uint32(params.samples);
if given.samples ~= params.samples
    error('stage10:param', 'params.samples is %g; legal: 0..2^32 - 1', params.samples);
end
given.h = single(params.h);
given.u_max = single(params.u_max);
given.k = single(params.k);
if numel(params.k) ~= 2
    error('stage10:param', 'params.k has %d numbers; legal: 2', numel(params.k));
end
if ~(given.samples > uint32(1))
    error('stage10:param', 'params.samples is %g; legal: >= 2', params.samples);
end
if ~((single(1.000000045813705e-18) <= given.h) && (given.h <= single(9.999999843067494e17)))
    error('stage10:param', 'params.h is %g; legal: from 1.000000045813705e-18 to 9.999999843067494e17', params.h);
end
if ~(given.u_max > single(0.0))
    error('stage10:param', 'params.u_max is %g; legal: > 0', params.u_max);
end
if ~isfinite(given.k(1))
    error('stage10:param', 'params.k(1) is %g; legal: finite', params.k(1));
end
if ~isfinite(given.k(2))
    error('stage10:param', 'params.k(2) is %g; legal: finite', params.k(2));
end
samples = given.samples;
w1_1 = (-(given.k(1) / single(1.690000057220459))) * (single(1.0) / (given.h * given.h));
w1_2 = (-single(0.5)) * (-(given.k(1) / single(1.690000057220459))) * (single(1.0) / given.h);
w2_2 = (single(1.0) - (given.k(2) / single(1.2999999523162842))) * (single(1.0) / given.h);
b_1 = -(single(1.0) / (given.h * given.h));
b_2 = (-single(1.5)) * (single(1.0) / given.h);
u_max = given.u_max;
if ~(isfinite(w1_1) ...
    && isfinite(w1_2) ...
    && isfinite(w2_2) ...
    && isfinite(b_1) ...
    && isfinite(b_2) ...
    && (given.h * given.h >= single(1.0000000031710769e-30)) ...
    && (single(1.0) / (given.h * given.h) >= single(1.0000000031710769e-30)))
    error('stage10:param', 'the coefficients leave the range of numbers: take gains, rates and sample periods nearer to 1');
end
self.start = uint32(0);
self.samples = samples;
self.w1_1 = w1_1;
self.w1_2 = w1_2;
self.w2_2 = w2_2;
self.b_1 = b_1;
self.b_2 = b_2;
self.u_max = u_max;
end
