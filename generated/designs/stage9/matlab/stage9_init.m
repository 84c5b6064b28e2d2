function self = stage9_init(params) %#codegen
%STAGE9_INIT Takes the parameters and arms at tick 0.
%
%   self = stage9_init(params) is the controller, for the functions that stand beside this one. A
%   parameter outside its domain, or coefficients that leave the range of numbers, raise an error
%   stage9:param, which names what is wrong and what is legal.
%
%   params is a struct:
%     samples: samples N from the start to rest [samples], at least 8
%     h: sample period [s], from 1e-150 to 1e150
%     k(1:4): gains k_i of pi0 = -sum k_i xi_i [1/s^4], finite
%     deadbeat: samples to go at which deadbeat takes over, 0 for a safe default [samples], finite

% Prescribed-time controller stage9: order n = 3, clock in samples.
%
% DO NOT EDIT. Made by:
%   ptc-codegen emit --lang matlab --n 3 --mu "exp(a=1)" --name stage9 --clock samples --measured=x1 --observer-poles=-4,-5,-6 --observer-eps=0.05 --eps=0.02 --u-max=1e3 --delay=1
% Version 0.1.0, design a9f2dd91a5f7.
%
% Plant: x1' = x2, ..., x3' = u; u held from sample to sample, one sample late.
% Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
%       sample period, as long as u is not clipped and nothing else acts on the plant.
% Law: with M samples to go and z = S x, u h^4 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-3));
%       the rows are those of Theorem 1 for the mapping exp. Close to the end deadbeat takes
%       over.
%
% Parameters:
%   samples [samples]: samples N from the start to rest
%   h [s]: sample period
%   eps = 0.02 [s], fixed: time-to-go at which the gains are held
%   u_max = 1e3 [unit of u], fixed: bound of |u|
%   a = 1 [1/s], fixed: rate of stretched time
%   k_1 [1/s^4]: gains k_i of pi0 = -sum k_i xi_i
%   k_2 [1/s^3]: gains k_i of pi0 = -sum k_i xi_i
%   k_3 [1/s^2]: gains k_i of pi0 = -sum k_i xi_i
%   k_4 [1/s]: gains k_i of pi0 = -sum k_i xi_i
%   deadbeat [samples]: samples to go at which deadbeat takes over, 0 for a safe default
%
% k counts samples and may wrap; arm again within 2^32 - N samples.
% From sample N on the last gains are held (status HOLD).
% The estimates are exact from sample N/2 after the start on where the measurement is; with
%       noise or sensor_step given, or observer_eps, the gains of the observer are then held
%       below deadbeat.
% |u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
%       lasts.
% Guard full: what is measured is finite, or the call is refused (INPUT).
% Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
%       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
%
% Checks of the design (details: ptc-codegen check):
%   membership: sound: exp is of class M for all its parameters.
%   growth: sound: at rest at sample N from any state, but for what the held observer leaves
%       of its error, whatever the poles, and |u| is bounded.
%   sampling: not checked: the law is exact in samples, at any period.
%   deadline: not checked: the law is exact in samples, at any period.
%   loop: not checked: `samples` is left to run time.
%   envelope: not checked: it does not examine a clock in samples.

given.samples = uint32(params.samples);
if given.samples ~= params.samples
    error('stage9:param', 'params.samples is %g; legal: 0..2^32 - 1', params.samples);
end
given.h = double(params.h);
given.k = double(params.k);
if numel(params.k) ~= 4
    error('stage9:param', 'params.k has %d numbers; legal: 4', numel(params.k));
end
given.deadbeat = double(params.deadbeat);
if ~(given.samples > uint32(7))
    error('stage9:param', 'params.samples is %g; legal: >= 8', params.samples);
end
if ~((1e-150 <= given.h) && (given.h <= 1e150))
    error('stage9:param', 'params.h is %g; legal: from 1e-150 to 1e150', params.h);
end
if ~isfinite(given.k(1))
    error('stage9:param', 'params.k(1) is %g; legal: finite', params.k(1));
end
if ~isfinite(given.k(2))
    error('stage9:param', 'params.k(2) is %g; legal: finite', params.k(2));
end
if ~isfinite(given.k(3))
    error('stage9:param', 'params.k(3) is %g; legal: finite', params.k(3));
end
if ~isfinite(given.k(4))
    error('stage9:param', 'params.k(4) is %g; legal: finite', params.k(4));
end
if ~(isfinite(given.deadbeat) && (given.deadbeat >= 0.0))
    error('stage9:param', 'params.deadbeat is %g; legal: >= 0', params.deadbeat);
end
samples = given.samples;
phi1_2 = given.h;
phi1_3 = 0.5 * (given.h * given.h);
gamma1 = 0.16666666666666666 * (given.h * given.h * given.h);
hold_o = 0.05 / given.h;
q2_1 = (-108.0) * (1.0 / given.h);
q2_2 = 36.0 * (1.0 / given.h);
q3_1 = 24.0 * (1.0 / (given.h * given.h));
hold = 0.02 / given.h;
w1_1 = (-given.k(1)) * (1.0 / (given.h * given.h * given.h));
w1_2 = given.k(1) * (1.0 / (given.h * given.h));
w1_3 = 0.3333333333333333 * (-given.k(1)) * (1.0 / given.h);
s1 = ((1.0 - given.k(2)) + given.k(3)) - given.k(4);
w2_2 = s1 * (1.0 / (given.h * given.h));
s2 = (-0.5) * (((1.0 - given.k(2)) + given.k(3)) - given.k(4));
w2_3 = s2 * (1.0 / given.h);
w3_3 = (((-7.0) - given.k(3)) + (3.0 * given.k(4))) * (1.0 / given.h);
w4_4 = 6.0 - given.k(4);
b_1 = -(1.0 / (given.h * given.h * given.h));
b_2 = (-3.0) * (1.0 / (given.h * given.h));
b_3 = (-4.333333333333333) * (1.0 / given.h);
if ~(isfinite(phi1_3) ...
    && isfinite(gamma1) ...
    && isfinite(hold_o) ...
    && isfinite(q2_1) ...
    && isfinite(q2_2) ...
    && isfinite(q3_1) ...
    && isfinite(hold) ...
    && isfinite(w1_1) ...
    && isfinite(w1_2) ...
    && isfinite(w1_3) ...
    && isfinite(w2_2) ...
    && isfinite(w2_3) ...
    && isfinite(w3_3) ...
    && isfinite(w4_4) ...
    && isfinite(b_1) ...
    && isfinite(b_2) ...
    && isfinite(b_3) ...
    && (given.h * given.h * given.h >= 1e-200) ...
    && (1.0 / (given.h * given.h * given.h) >= 1e-200) ...
    && (hold_o >= 3.0))
    error('stage9:param', 'the coefficients leave the range of numbers: take gains, rates and sample periods nearer to 1');
end
self.start = uint32(0);
self.samples = samples;
self.u1 = 0.0;
self.u2 = 0.0;
self.seen = uint32(0);
self.x1_hat = 0.0;
self.x2_hat = 0.0;
self.x3_hat = 0.0;
self.phi1_2 = phi1_2;
self.phi1_3 = phi1_3;
self.gamma1 = gamma1;
self.hold_o = hold_o;
self.q2_1 = q2_1;
self.q2_2 = q2_2;
self.q3_1 = q3_1;
self.hold = hold;
self.w1_1 = w1_1;
self.w1_2 = w1_2;
self.w1_3 = w1_3;
self.w2_2 = w2_2;
self.w2_3 = w2_3;
self.w3_3 = w3_3;
self.w4_4 = w4_4;
self.b_1 = b_1;
self.b_2 = b_2;
self.b_3 = b_3;
end
