function self = a_name_that_fills_half_of_a_line_alone_4_init(params) %#codegen
%A_NAME_THAT_FILLS_HALF_OF_A_LINE_ALONE_4_INIT Takes the parameters and arms at tick 0.
%
%   self = a_name_that_fills_half_of_a_line_alone_4_init(params) is the controller, for the
%   functions that stand beside this one. A parameter outside its domain, or coefficients that leave
%   the range of numbers, raise an error a_name_that_fills_half_of_a_line_alone_4:param, which names
%   what is wrong and what is legal.
%
%   params is a struct:
%     samples: samples N from the start to rest [samples], at least 6
%     h: sample period [s], from 1e-18 to 1e18
%     u_max: bound of |u| [unit of u], > 0, infinity allowed
%     k(1:2): gains k_i of pi0 = -sum k_i xi_i [1/s^2], finite
%     deadbeat: samples to go at which deadbeat takes over, 0 for a safe default [samples], finite

% Prescribed-time controller a_name_that_fills_half_of_a_line_alone_4: order n = 2, clock in samples.
%
% DO NOT EDIT. Made by:
%   ptc-codegen emit --lang matlab --n 2 --mu "exp(a=2)" --name a_name_that_fills_half_of_a_line_alone_4 --clock samples --measured=x1 --disturbance constant --observer-poles=-4,-5,-6 --precision f32 --eps=0 --after zero
% Version 0.1.0, design 077043d15f79.
%
% Plant: x1' = x2, x2' = (u + d), d constant and unknown; u held from sample to sample.
% Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
%       sample period, as long as u is not clipped and nothing else acts on the plant.
% Law: with M samples to go and z = S x, u h^2 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-1));
%       the rows are those of Theorem 1 for the mapping exp. Close to the end deadbeat takes
%       over.
%
% Parameters:
%   samples [samples]: samples N from the start to rest
%   h [s]: sample period
%   eps = 0 [s], fixed: time-to-go at which the gains are held
%   u_max [unit of u]: bound of |u|
%   a = 2 [1/s], fixed: rate of stretched time
%   k_1 [1/s^2]: gains k_i of pi0 = -sum k_i xi_i
%   k_2 [1/s]: gains k_i of pi0 = -sum k_i xi_i
%   deadbeat [samples]: samples to go at which deadbeat takes over, 0 for a safe default
%
% k counts samples and may wrap; arm again within 2^32 - N samples.
% From sample N on u = 0 (status AFTER).
% The estimates are exact from sample N/2 after the start on where the measurement is; with
%       noise or sensor_step given, or observer_eps, the gains of the observer are then held
%       below deadbeat.
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
    error('a_name_that_fills_half_of_a_line_alone_4:param', 'params.samples is %g; legal: 0..2^32 - 1', params.samples);
end
given.h = single(params.h);
given.u_max = single(params.u_max);
given.k = single(params.k);
if numel(params.k) ~= 2
    error('a_name_that_fills_half_of_a_line_alone_4:param', 'params.k has %d numbers; legal: 2', numel(params.k));
end
given.deadbeat = single(params.deadbeat);
if ~(given.samples > uint32(5))
    error('a_name_that_fills_half_of_a_line_alone_4:param', 'params.samples is %g; legal: >= 6', params.samples);
end
if ~((single(1.000000045813705e-18) <= given.h) && (given.h <= single(9.999999843067494e17)))
    error('a_name_that_fills_half_of_a_line_alone_4:param', 'params.h is %g; legal: from 1.000000045813705e-18 to 9.999999843067494e17', params.h);
end
if ~(given.u_max > single(0.0))
    error('a_name_that_fills_half_of_a_line_alone_4:param', 'params.u_max is %g; legal: > 0', params.u_max);
end
if ~isfinite(given.k(1))
    error('a_name_that_fills_half_of_a_line_alone_4:param', 'params.k(1) is %g; legal: finite', params.k(1));
end
if ~isfinite(given.k(2))
    error('a_name_that_fills_half_of_a_line_alone_4:param', 'params.k(2) is %g; legal: finite', params.k(2));
end
if ~(isfinite(given.deadbeat) && (given.deadbeat >= single(0.0)))
    error('a_name_that_fills_half_of_a_line_alone_4:param', 'params.deadbeat is %g; legal: >= 0', params.deadbeat);
end
samples = given.samples;
phi1_2 = given.h;
phi1_3 = single(0.5) * (given.h * given.h);
q2_1 = (-single(6.0)) * (single(1.0) / given.h);
q2_2 = single(3.0) * (single(1.0) / given.h);
e2_2 = single(1.5) * (single(1.0) / given.h);
e2_3 = single(1.0) / (given.h * given.h);
e1_2 = single(0.44999998807907104) * (single(1.0) / given.h);
e1_3 = (-single(1.100000023841858)) * (single(1.0) / (given.h * given.h));
e0_2 = (-single(0.42500001192092896)) * (single(1.0) / given.h);
e0_3 = single(0.3499999940395355) * (single(1.0) / (given.h * given.h));
s1 = ((given.k(2) / single(2.0)) - single(1.0)) + single(2.0);
s2 = pick(s1 < single(4.0), single(4.0), s1);
deadbeat = pick(given.deadbeat > single(0.0), given.deadbeat, s2);
w1_1 = (-(given.k(1) / single(4.0))) * (single(1.0) / (given.h * given.h));
w1_2 = (-single(0.5)) * (-(given.k(1) / single(4.0))) * (single(1.0) / given.h);
w2_2 = (single(1.0) - (given.k(2) / single(2.0))) * (single(1.0) / given.h);
b_1 = -(single(1.0) / (given.h * given.h));
b_2 = (-single(1.5)) * (single(1.0) / given.h);
u_max = given.u_max;
if ~(isfinite(phi1_3) ...
    && isfinite(q2_1) ...
    && isfinite(q2_2) ...
    && isfinite(e2_2) ...
    && isfinite(e2_3) ...
    && isfinite(e1_2) ...
    && isfinite(e1_3) ...
    && isfinite(e0_2) ...
    && isfinite(e0_3) ...
    && isfinite(deadbeat) ...
    && isfinite(w1_1) ...
    && isfinite(w1_2) ...
    && isfinite(w2_2) ...
    && isfinite(b_1) ...
    && isfinite(b_2) ...
    && (given.h * given.h >= single(1.0000000031710769e-30)) ...
    && (single(1.0) / (given.h * given.h) >= single(1.0000000031710769e-30)))
    error('a_name_that_fills_half_of_a_line_alone_4:param', 'the coefficients leave the range of numbers: take gains, rates and sample periods nearer to 1');
end
self.start = uint32(0);
self.samples = samples;
self.u1 = single(0.0);
self.seen = uint32(0);
self.x1_hat = single(0.0);
self.x2_hat = single(0.0);
self.d_hat = single(0.0);
self.phi1_2 = phi1_2;
self.phi1_3 = phi1_3;
self.q2_1 = q2_1;
self.q2_2 = q2_2;
self.e2_2 = e2_2;
self.e2_3 = e2_3;
self.e1_2 = e1_2;
self.e1_3 = e1_3;
self.e0_2 = e0_2;
self.e0_3 = e0_3;
self.deadbeat = deadbeat;
self.w1_1 = w1_1;
self.w1_2 = w1_2;
self.w2_2 = w2_2;
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
