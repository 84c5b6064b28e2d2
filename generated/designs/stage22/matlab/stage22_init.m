function self = stage22_init(params) %#codegen
%STAGE22_INIT Takes the parameters and arms at tick 0.
%
%   self = stage22_init(params) is the controller, for the functions that stand beside this one. A
%   parameter outside its domain, or coefficients that leave the range of numbers, raise an error
%   stage22:param, which names what is wrong and what is legal.
%
%   params is a struct:
%     u_max: bound of |u| [unit of u], > 0, infinity allowed
%     k: parameter of an expression of the design [as in its expression], finite

% Prescribed-time controller stage22: order n = 2, clock in samples.
%
% DO NOT EDIT. Made by:
%   ptc-codegen emit --lang matlab --n 2 --mu "exp(a=1)" --name stage22 --clock samples --tau=0.3 --eps=0 --poles=-3,-4 --states="q, w" --input=F --output="q + q^3/6" --dynamics="w, F/(2 + q^2) - k*q^3 - 3*w" --reference input --sample-time=0.01
% Version 0.1.0, design 1531839ead9d.
%
% Plant: the input F: q' = w, w' = F/(2 + q^2) - k*q^3 - 3*w, output q + q^3/6; u held from
%       sample to sample.
% Goal: the output and its derivatives up to order 1, x, are 0 at sample N after the start,
%       from any state, as long as u is not clipped and the plant is the model. f and g are
%       known at the samples alone, which leaves an error of order h^(4-i) in x_i.
% Law: with M samples to go and z = S x, w h^2 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-1)),
%       and u = (w - f)/g; the rows are those of Theorem 1 for the mapping exp. The gains of
%       2 samples to go stay: they are deadbeat. Rest is planned 2 samples early, and the
%       last gains bring down what f and g did between samples.
% With the reference r, e_i = x_i - r^(i-1) is in place of x_i above, and u = (w + rho -
%       f)/g. At sample N e is 0 where r^(n) is constant over each sample; else an error of
%       order h^(4-i) is left in e_i.
% e_i = x_i - r[i-1] with r[0]..r[1] the reference and its derivatives at tick k, and rho =
%       r[2], r^(n) over the sample in which u acts: its mean, (r^(n-1)(t + h) -
%       r^(n-1)(t))/h, or that in its middle.
%
% Parameters:
%   samples = 30 [samples], fixed: samples N from the start to rest
%   h = 0.01 [s], fixed: sample period
%   eps = 0 [s], fixed: time-to-go at which the gains are held
%   u_max [unit of u]: bound of |u|
%   a = 1 [1/s], fixed: rate of stretched time
%   k_1 = 12 [1/s^2], fixed: gains k_i of pi0 = -sum k_i xi_i
%   k_2 = 7 [1/s], fixed: gains k_i of pi0 = -sum k_i xi_i
%   k [as in its expression]: parameter of an expression of the design
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
%   growth: sound: at rest at sample 30 from any state, but for what f + g u and r do between
%       samples, whatever the poles, and |u| is bounded.
%   sampling: not checked: `loop` bounds what the period leaves of a model that is not linear.
%   deadline: not checked: `loop` bounds what the period leaves of a model that is not linear.
%   loop: not checked: `k` is left to run time.
%   envelope: not checked: it does not examine a clock in samples.
%   zeros: sound: none: the relative degree is 2, the number of states.

given.u_max = double(params.u_max);
given.k = double(params.k);
if ~(given.u_max > 0.0)
    error('stage22:param', 'params.u_max is %g; legal: > 0', params.u_max);
end
if ~isfinite(given.k)
    error('stage22:param', 'params.k is %g; legal: finite', params.k);
end
p_k = given.k;
u_max = given.u_max;
self.start = uint32(0);
self.p_k = p_k;
self.u_max = u_max;
end
