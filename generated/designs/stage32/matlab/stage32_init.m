function self = stage32_init(params) %#codegen
%STAGE32_INIT Takes the parameters and arms at tick 0.
%
%   self = stage32_init(params) is the controller, for the functions that stand beside this one. A
%   parameter outside its domain, or coefficients that leave the range of numbers, raise an error
%   stage32:param, which names what is wrong and what is legal.
%
%   params is a struct:
%     u_max: bound of |u| [unit of u], > 0, infinity allowed
%     a: rate of stretched time [1/s], from 1e-150 to 1e150
%     k(1:2): gains k_i of pi0 = -sum k_i xi_i [1/s^2], finite
%     deadbeat: samples to go at which deadbeat takes over, 0 for a safe default [samples], finite
%     m: parameter of an expression of the design [as in its expression], finite
%     size: parameter of an expression of the design [as in its expression], finite

% Prescribed-time controller stage32: outputs of order 2, 2, clock in samples.
%
% DO NOT EDIT. Made by:
%   ptc-codegen emit --lang matlab --mu exp --name stage32 --clock samples --tau=0.3 --eps=0.04 --states="q1, q2, w1, w2" --inputs=F1,F2 --inertia="[[m + q2^2, q2], [q2, 1]]" --bias="m*q2*w1*w2, w1^2/2 - q1" --reference="size*dt^2/(1 + t^2), 0" --sample-time=0.01
% Version 0.1.0, design 241446d65458.
%
% Plant: the inputs F1, F2: q = (q1, q2), q' = (w1, w2), M q'' + bias = u, M = [[m + q2^2,
%       q2], [q2, 1]], bias = [m*q2*w1*w2, w1^2/2 - q1]; u held from sample to sample.
% Goal: every output with its derivatives is 0 at sample N after the start, from any state,
%       as long as no u is clipped and the plant is the model. The plant is known at the
%       samples alone, which leaves an error of order h^(n+2-i) in x_i of an output of order
%       n.
% Law of each output, of order n: with M - s samples to go and z = S x, v h^n = sum of row_j
%       z_j h^(j-1)/((M-j+1)...(M-n+1)); the rows are those of Theorem 1 for the mapping exp.
%       v_i is law_i in step. s = 0, 0. Output 1: Close to the end deadbeat takes over.
%       Output 2: Close to the end deadbeat takes over.
% Output 1, of order n = 2:
%   x_1 = q1
%   x_2 = w1
% Output 2, of order n = 2:
%   x_1 = q2
%   x_2 = w2
% u = M v + bias
% With a reference r of each output, e_i = x_i - r^(i-1) is in place of x_i above, and law_i
%       = v_i + rho of output i is in place of v_i. What r^(n) changes over a sample leaves
%       an error of order h^(n+2-i) in e_i at sample N, h^3 for n = 1, and none where it is
%       constant there.
% t counts from the tick at which it was armed, and rho is r^(n) in the middle of the time in
%       which u acts:
%   of output 1: r = size*dt^2/(1 + t^2), r^(1) = 2*size*dt*(1 + t^2 - dt*t)/(1 + t^2)^2,
%       r^(2) = 2*size*((1 + t^2)^2 + 4*dt^2*t^2 - 4*(1 + t^2)*dt*t - (1 + t^2)*dt^2)/(1 +
%       t^2)^3
%   of output 2: r = 0, r^(1) = 0, r^(2) = 0
% Outputs: 2, each with a law of its own, with this deadline and mapping; u_max is of the
%       input of this number.
%
% Parameters:
%   samples = 30 [samples], fixed: samples N from the start to rest
%   h = 0.01 [s], fixed: sample period
%   eps = 0.04 [s], fixed: time-to-go at which the gains are held
%   u_max [unit of u]: bound of |u|
%   a [1/s]: rate of stretched time
%   k_1 [1/s^2]: gains k_i of pi0 = -sum k_i xi_i
%   k_2 [1/s]: gains k_i of pi0 = -sum k_i xi_i
%   deadbeat [samples]: samples to go at which deadbeat takes over, 0 for a safe default
%   m [as in its expression]: parameter of an expression of the design
%   size [as in its expression]: parameter of an expression of the design
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
%   growth: sound: output 1: near rest at sample 30, not at rest: the gains are held from 4
%       samples to go, and |u| is bounded; so does what f + g u and r do between samples.
%   sampling: not checked: `loop` bounds what the period leaves of a plant with several
%       inputs.
%   deadline: not checked: `loop` bounds what the period leaves of a plant with several
%       inputs.
%   loop: not checked: `a` is left to run time.
%   envelope: not checked: `x_max` is not given.
%   zeros: sound: none: the relative degrees are 2, 2, whose sum is the number of states.

given.u_max = double(params.u_max);
given.a = double(params.a);
given.k = double(params.k);
if numel(params.k) ~= 2
    error('stage32:param', 'params.k has %d numbers; legal: 2', numel(params.k));
end
given.deadbeat = double(params.deadbeat);
given.m = double(params.m);
given.size = double(params.size);
if ~(given.u_max > 0.0)
    error('stage32:param', 'params.u_max is %g; legal: > 0', params.u_max);
end
if ~((1e-150 <= given.a) && (given.a <= 1e150))
    error('stage32:param', 'params.a is %g; legal: from 1e-150 to 1e150', params.a);
end
if ~isfinite(given.k(1))
    error('stage32:param', 'params.k(1) is %g; legal: finite', params.k(1));
end
if ~isfinite(given.k(2))
    error('stage32:param', 'params.k(2) is %g; legal: finite', params.k(2));
end
if ~(isfinite(given.deadbeat) && (given.deadbeat >= 0.0))
    error('stage32:param', 'params.deadbeat is %g; legal: >= 0', params.deadbeat);
end
if ~isfinite(given.m)
    error('stage32:param', 'params.m is %g; legal: finite', params.m);
end
if ~isfinite(given.size)
    error('stage32:param', 'params.size is %g; legal: finite', params.size);
end
p_size = given.size;
c_r3 = 2.0 * p_size;
w1_1_1 = 10000.0 * (-(given.k(1) / (given.a * given.a)));
w1_2_1 = 100.0 * ((-0.5) * (-(given.k(1) / (given.a * given.a))));
w2_2_1 = 100.0 * (1.0 - (given.k(2) / given.a));
p_m = given.m;
u_max = given.u_max;
if ~(isfinite(c_r3) && isfinite(w1_1_1) && isfinite(w1_2_1) && isfinite(w2_2_1))
    error('stage32:param', 'the coefficients leave the range of numbers: take gains, rates and sample periods nearer to 1');
end
self.start = uint32(0);
self.p_size = p_size;
self.c_r3 = c_r3;
self.w1_1_1 = w1_1_1;
self.w1_2_1 = w1_2_1;
self.w2_2_1 = w2_2_1;
self.p_m = p_m;
self.u_max = u_max;
end
