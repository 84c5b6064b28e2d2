function self = stage21_init(params) %#codegen
%STAGE21_INIT Takes the parameters and arms at tick 0.
%
%   self = stage21_init(params) is the controller, for the functions that stand beside this one. A
%   parameter outside its domain, or coefficients that leave the range of numbers, raise an error
%   stage21:param, which names what is wrong and what is legal.
%
%   params is a struct:
%     samples: samples N from the start to rest [samples], at least 4
%     h: sample period [s], from 1e-150 to 1e150
%     u_max: bound of |u| [unit of u], > 0, infinity allowed
%     k(1:4): gains k_i of pi0 = -sum k_i xi_i [1/s^4], finite
%     deadbeat: samples to go at which deadbeat takes over, 0 for a safe default [samples], finite
%     size: parameter of an expression of the design [as in its expression], finite

% Prescribed-time controller stage21: order n = 3, clock in samples.
%
% DO NOT EDIT. Made by:
%   ptc-codegen emit --lang matlab --n 3 --mu "exp(a=1)" --name stage21 --clock samples --eps=0 --g="2" --reference="size*dt^2/(1 + t^2)" --delay=0.25
% Version 0.1.0, design 0b4602f00880.
%
% Plant: x1' = x2, ..., x3' = g u; u held from sample to sample, 0.25 samples late.
% Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
%       sample period, as long as u is not clipped and nothing else acts on the plant.
% Law: with M samples to go and z = S x, u h^4 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-3));
%       the rows are those of Theorem 1 for the mapping exp. Close to the end deadbeat takes
%       over.
% With the reference r, e_i = x_i - r^(i-1) is in place of x_i above, and u = w + rho/g,
%       where the inputs under way count less the rho of their own samples. At sample N e is
%       0 where r^(n) is constant over each sample; else an error of order h^(5-i) is left in
%       e_i.
% t counts from the tick at which it was armed, and rho is r^(n) in the middle of the time in
%       which u acts:
%   e_i = x_i - r^(i-1), with the reference r = size*dt^2/(1 + t^2)
%   r^(1) = 2*size*dt*(1 + t^2 - dt*t)/(1 + t^2)^2
%   r^(2) = 2*size*((1 + t^2)^2 + 4*dt^2*t^2 - 4*(1 + t^2)*dt*t - (1 + t^2)*dt^2)/(1 + t^2)^3
%   r^(3) = 12*size*(4*(1 + t^2)*dt*t^2 + 2*(1 + t^2)*dt^2*t - (1 + t^2)^2*dt - (1 + t^2)^2*t
%       - 4*dt^2*t^3)/(1 + t^2)^4
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
%   growth: sound: at rest at sample N from any state, but for what r does between samples,
%       whatever the poles, and |u| is bounded.
%   sampling: not checked: `loop` bounds what the period leaves of a reference that moves.
%   deadline: not checked: `loop` bounds what the period leaves of a reference that moves.
%   loop: not checked: `samples` is left to run time.
%   envelope: not checked: it does not examine a clock in samples.

given.samples = uint32(params.samples);
if given.samples ~= params.samples
    error('stage21:param', 'params.samples is %g; legal: 0..2^32 - 1', params.samples);
end
given.h = double(params.h);
given.u_max = double(params.u_max);
given.k = double(params.k);
if numel(params.k) ~= 4
    error('stage21:param', 'params.k has %d numbers; legal: 4', numel(params.k));
end
given.deadbeat = double(params.deadbeat);
given.size = double(params.size);
if ~(given.samples > uint32(3))
    error('stage21:param', 'params.samples is %g; legal: >= 4', params.samples);
end
if ~((1e-150 <= given.h) && (given.h <= 1e150))
    error('stage21:param', 'params.h is %g; legal: from 1e-150 to 1e150', params.h);
end
if ~(given.u_max > 0.0)
    error('stage21:param', 'params.u_max is %g; legal: > 0', params.u_max);
end
if ~isfinite(given.k(1))
    error('stage21:param', 'params.k(1) is %g; legal: finite', params.k(1));
end
if ~isfinite(given.k(2))
    error('stage21:param', 'params.k(2) is %g; legal: finite', params.k(2));
end
if ~isfinite(given.k(3))
    error('stage21:param', 'params.k(3) is %g; legal: finite', params.k(3));
end
if ~isfinite(given.k(4))
    error('stage21:param', 'params.k(4) is %g; legal: finite', params.k(4));
end
if ~(isfinite(given.deadbeat) && (given.deadbeat >= 0.0))
    error('stage21:param', 'params.deadbeat is %g; legal: >= 0', params.deadbeat);
end
if ~isfinite(given.size)
    error('stage21:param', 'params.size is %g; legal: finite', params.size);
end
samples = given.samples;
h = given.h;
p_size = given.size;
c_r3 = 2.0 * p_size;
c_r5 = 12.0 * p_size;
c_r6 = 0.75 * h;
c_r12 = (-0.25) * h;
s1 = (given.k(4) - 9.0) + 4.0;
s2 = pick(s1 < 8.0, 8.0, s1);
deadbeat = pick(given.deadbeat > 0.0, given.deadbeat, s2);
s3 = 1.0 / (given.h * given.h * given.h);
w1_1 = 0.5 * (-given.k(1)) * s3;
w1_2 = (-0.875) * (-given.k(1)) * (1.0 / (given.h * given.h));
w1_3 = 0.6822916666666666 * (-given.k(1)) * (1.0 / given.h);
w1_4 = (-0.6015625) * (-given.k(1));
s4 = 0.5 * (((1.0 - given.k(2)) + given.k(3)) - given.k(4));
w2_2 = s4 * (1.0 / (given.h * given.h));
s5 = (-0.625) * (((1.0 - given.k(2)) + given.k(3)) - given.k(4));
w2_3 = s5 * (1.0 / given.h);
w2_4 = 0.65625 * (((1.0 - given.k(2)) + given.k(3)) - given.k(4));
s6 = 0.5 * (((-7.0) - given.k(3)) + (3.0 * given.k(4)));
w3_3 = s6 * (1.0 / given.h);
w3_4 = (-0.75) * (((-7.0) - given.k(3)) + (3.0 * given.k(4)));
w4_4 = 6.0 - given.k(4);
b_1 = (-0.5) * (1.0 / (given.h * given.h * given.h));
b_2 = (-1.125) * (1.0 / (given.h * given.h));
b_3 = (-1.1822916666666667) * (1.0 / given.h);
u_max = given.u_max;
if ~(isfinite(c_r3) ...
    && isfinite(c_r5) ...
    && isfinite(c_r6) ...
    && isfinite(c_r12) ...
    && isfinite(deadbeat) ...
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
    && isfinite(b_1) ...
    && isfinite(b_2) ...
    && isfinite(b_3) ...
    && (given.h * given.h * given.h >= 1e-200) ...
    && (1.0 / (given.h * given.h * given.h) >= 1e-200))
    error('stage21:param', 'the coefficients leave the range of numbers: take gains, rates and sample periods nearer to 1');
end
self.start = uint32(0);
self.samples = samples;
self.u1 = 0.0;
self.h = h;
self.p_size = p_size;
self.c_r3 = c_r3;
self.c_r5 = c_r5;
self.c_r6 = c_r6;
self.c_r12 = c_r12;
self.deadbeat = deadbeat;
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
self.b_1 = b_1;
self.b_2 = b_2;
self.b_3 = b_3;
self.u_max = u_max;
end

function r = pick(condition, yes, no)
if condition
    r = yes;
else
    r = no;
end
end
