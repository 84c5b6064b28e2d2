function self = stage20_init(params) %#codegen
%STAGE20_INIT Takes the parameters and arms at tick 0.
%
%   self = stage20_init(params) is the controller, for the functions that stand beside this one. A
%   parameter outside its domain, or coefficients that leave the range of numbers, raise an error
%   stage20:param, which names what is wrong and what is legal.
%
%   params is a struct:
%     samples: samples N from the start to rest [samples], at least 8
%     h: sample period [s], from 1e-150 to 1e150
%     u_max: bound of |u| [unit of u], > 0, infinity allowed
%     k(1:4): gains k_i of pi0 = -sum k_i xi_i [1/s^4], finite
%     deadbeat: samples to go at which deadbeat takes over, 0 for a safe default [samples], finite

% Prescribed-time controller stage20: order n = 2, clock in samples.
%
% DO NOT EDIT. Made by:
%   ptc-codegen emit --lang matlab --n 2 --mu "exp(a=1)" --name stage20 --clock samples --measured=x1 --disturbance constant --observer-poles=-4,-5,-6 --eps=0 --f="1/4" --g="1/2" --reference input --delay=1.25
% Version 0.1.0, design c90aea54cafb.
%
% Plant: x1' = x2, x2' = f + g (u + d), d constant and unknown; u held from sample to sample,
%       1.25 samples late.
% Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
%       sample period, as long as u is not clipped and nothing else acts on the plant.
% Law: with M samples to go and z = S x, u h^4 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-3));
%       the rows are those of Theorem 1 for the mapping exp. Close to the end deadbeat takes
%       over.
% With the reference r, e_i = x_i - r^(i-1) is in place of x_i above, and u = w + rho/g,
%       where the inputs under way count less the rho of their own samples. At sample N e is
%       0 where r^(n) is constant over each sample; else an error of order h^(4-i) is left in
%       e_i.
% e_i = x_i - r[i-1] with r[0]..r[1] the reference and its derivatives at tick k, and rho =
%       r[2], r^(n) over the sample in which u acts: its mean, (r^(n-1)(t + h) -
%       r^(n-1)(t))/h, or that in its middle.
%
% Parameters:
%   samples [samples]: samples N from the start to rest
%   h [s]: sample period
%   eps = 0 [s], fixed: time-to-go at which the gains are held
%   u_max [unit of u]: bound of |u|
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
% Guard full: what is measured and the reference are finite, or the call is refused (INPUT).
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
    error('stage20:param', 'params.samples is %g; legal: 0..2^32 - 1', params.samples);
end
given.h = double(params.h);
given.u_max = double(params.u_max);
given.k = double(params.k);
if numel(params.k) ~= 4
    error('stage20:param', 'params.k has %d numbers; legal: 4', numel(params.k));
end
given.deadbeat = double(params.deadbeat);
if ~(given.samples > uint32(7))
    error('stage20:param', 'params.samples is %g; legal: >= 8', params.samples);
end
if ~((1e-150 <= given.h) && (given.h <= 1e150))
    error('stage20:param', 'params.h is %g; legal: from 1e-150 to 1e150', params.h);
end
if ~(given.u_max > 0.0)
    error('stage20:param', 'params.u_max is %g; legal: > 0', params.u_max);
end
if ~isfinite(given.k(1))
    error('stage20:param', 'params.k(1) is %g; legal: finite', params.k(1));
end
if ~isfinite(given.k(2))
    error('stage20:param', 'params.k(2) is %g; legal: finite', params.k(2));
end
if ~isfinite(given.k(3))
    error('stage20:param', 'params.k(3) is %g; legal: finite', params.k(3));
end
if ~isfinite(given.k(4))
    error('stage20:param', 'params.k(4) is %g; legal: finite', params.k(4));
end
if ~(isfinite(given.deadbeat) && (given.deadbeat >= 0.0))
    error('stage20:param', 'params.deadbeat is %g; legal: >= 0', params.deadbeat);
end
samples = given.samples;
phi1_2 = given.h;
phi1_3 = 0.25 * (given.h * given.h);
gamma1 = 0.109375 * (given.h * given.h);
late_gamma1 = 0.140625 * (given.h * given.h);
phi2_3 = 0.5 * given.h;
gamma2 = 0.125 * given.h;
late_gamma2 = 0.375 * given.h;
q2_1 = (-108.0) * (1.0 / given.h);
q2_2 = 36.0 * (1.0 / given.h);
q3_1 = 48.0 * (1.0 / (given.h * given.h));
e2_2 = 1.5 * (1.0 / given.h);
e2_3 = 2.0 * (1.0 / (given.h * given.h));
e1_2 = 0.8571428571428571 * (1.0 / given.h);
e1_3 = (-0.5714285714285714) * (1.0 / (given.h * given.h));
e0_2 = 0.42857142857142855 * (1.0 / given.h);
e0_3 = 0.2857142857142857 * (1.0 / (given.h * given.h));
s1 = (given.k(4) - 9.0) + 4.0;
s2 = pick(s1 < 8.0, 8.0, s1);
deadbeat = pick(given.deadbeat > 0.0, given.deadbeat, s2);
w1_1 = 2.0 * (-given.k(1)) * (1.0 / (given.h * given.h));
w1_2 = (-2.5) * (-given.k(1)) * (1.0 / given.h);
w1_4 = 0.65625 * (-given.k(1));
s3 = 2.0 * (((1.0 - given.k(2)) + given.k(3)) - given.k(4));
w2_2 = s3 * (1.0 / given.h);
w2_4 = (-0.75) * (((1.0 - given.k(2)) + given.k(3)) - given.k(4));
w3_4 = ((-7.0) - given.k(3)) + (3.0 * given.k(4));
w4_3 = 6.0 - given.k(4);
w4_4 = -(6.0 - given.k(4));
b_1 = (-2.0) * (1.0 / (given.h * given.h));
b_2 = (-5.5) * (1.0 / given.h);
u_max = given.u_max;
if ~(isfinite(phi1_3) ...
    && isfinite(gamma1) ...
    && isfinite(late_gamma1) ...
    && isfinite(phi2_3) ...
    && isfinite(gamma2) ...
    && isfinite(late_gamma2) ...
    && isfinite(q2_1) ...
    && isfinite(q2_2) ...
    && isfinite(q3_1) ...
    && isfinite(e2_2) ...
    && isfinite(e2_3) ...
    && isfinite(e1_2) ...
    && isfinite(e1_3) ...
    && isfinite(e0_2) ...
    && isfinite(e0_3) ...
    && isfinite(deadbeat) ...
    && isfinite(w1_1) ...
    && isfinite(w1_2) ...
    && isfinite(w1_4) ...
    && isfinite(w2_2) ...
    && isfinite(w2_4) ...
    && isfinite(w3_4) ...
    && isfinite(w4_3) ...
    && isfinite(w4_4) ...
    && isfinite(b_1) ...
    && isfinite(b_2) ...
    && (given.h * given.h >= 1e-200) ...
    && (1.0 / (given.h * given.h) >= 1e-200))
    error('stage20:param', 'the coefficients leave the range of numbers: take gains, rates and sample periods nearer to 1');
end
self.start = uint32(0);
self.samples = samples;
self.u1 = 0.0;
self.u2 = 0.0;
self.u3 = 0.0;
self.seen = uint32(0);
self.x1_hat = 0.0;
self.x2_hat = 0.0;
self.d_hat = 0.0;
self.phi1_2 = phi1_2;
self.phi1_3 = phi1_3;
self.gamma1 = gamma1;
self.late_gamma1 = late_gamma1;
self.phi2_3 = phi2_3;
self.gamma2 = gamma2;
self.late_gamma2 = late_gamma2;
self.q2_1 = q2_1;
self.q2_2 = q2_2;
self.q3_1 = q3_1;
self.e2_2 = e2_2;
self.e2_3 = e2_3;
self.e1_2 = e1_2;
self.e1_3 = e1_3;
self.e0_2 = e0_2;
self.e0_3 = e0_3;
self.rho1 = 0.0;
self.rho2 = 0.0;
self.deadbeat = deadbeat;
self.w1_1 = w1_1;
self.w1_2 = w1_2;
self.w1_4 = w1_4;
self.w2_2 = w2_2;
self.w2_4 = w2_4;
self.w3_4 = w3_4;
self.w4_3 = w4_3;
self.w4_4 = w4_4;
self.b_1 = b_1;
self.b_2 = b_2;
self.u_max = u_max;
end

function r = pick(condition, yes, no)
if condition
    r = yes;
else
    r = no;
end
end
