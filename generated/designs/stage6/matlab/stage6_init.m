function self = stage6_init(params) %#codegen
%STAGE6_INIT Takes the parameters and arms at tick 0.
%
%   self = stage6_init(params) is the controller, for the functions that stand beside this one. A
%   parameter outside its domain, or coefficients that leave the range of numbers, raise an error
%   stage6:param, which names what is wrong and what is legal.
%
%   params is a struct:
%     samples: samples N from the start to rest [samples], at least 6
%     u_max: bound of |u| [unit of u], > 0, infinity allowed
%     k(1:3): gains k_i of pi0 = -sum k_i xi_i [1/s^3], finite
%     deadbeat: samples to go at which deadbeat takes over, 0 for a safe default [samples], finite

% Prescribed-time controller stage6: order n = 3, clock in samples.
%
% DO NOT EDIT. Made by:
%   ptc-codegen emit --lang matlab --n 3 --mu "exp(a=0.7)" --name stage6 --clock samples --measured=x1,x2 --observer-poles=-4,-5.3 --eps=0 --f="1/2" --g="2" --sample-time=2e-3
% Version 0.1.0, design 6c8ba09a0bea.
%
% Plant: x1' = x2, ..., x3' = f + g u; u held from sample to sample.
% Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
%       sample period, as long as u is not clipped and nothing else acts on the plant.
% Law: with M samples to go and z = S x, u h^3 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-2));
%       the rows are those of Theorem 1 for the mapping exp. Close to the end deadbeat takes
%       over.
%
% Parameters:
%   samples [samples]: samples N from the start to rest
%   h = 2e-3 [s], fixed: sample period
%   eps = 0 [s], fixed: time-to-go at which the gains are held
%   u_max [unit of u]: bound of |u|
%   a = 0.7 [1/s], fixed: rate of stretched time
%   k_1 [1/s^3]: gains k_i of pi0 = -sum k_i xi_i
%   k_2 [1/s^2]: gains k_i of pi0 = -sum k_i xi_i
%   k_3 [1/s]: gains k_i of pi0 = -sum k_i xi_i
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
%   growth: sound: at rest at sample N from any state, whatever the poles, and |u| is bounded.
%   sampling: not checked: the law is exact in samples, at any period.
%   deadline: not checked: the law is exact in samples, at any period.
%   loop: not checked: `samples` is left to run time.
%   envelope: not checked: it does not examine a clock in samples.

given.samples = uint32(params.samples);
if given.samples ~= params.samples
    error('stage6:param', 'params.samples is %g; legal: 0..2^32 - 1', params.samples);
end
given.u_max = double(params.u_max);
given.k = double(params.k);
if numel(params.k) ~= 3
    error('stage6:param', 'params.k has %d numbers; legal: 3', numel(params.k));
end
given.deadbeat = double(params.deadbeat);
if ~(given.samples > uint32(5))
    error('stage6:param', 'params.samples is %g; legal: >= 6', params.samples);
end
if ~(given.u_max > 0.0)
    error('stage6:param', 'params.u_max is %g; legal: > 0', params.u_max);
end
if ~isfinite(given.k(1))
    error('stage6:param', 'params.k(1) is %g; legal: finite', params.k(1));
end
if ~isfinite(given.k(2))
    error('stage6:param', 'params.k(2) is %g; legal: finite', params.k(2));
end
if ~isfinite(given.k(3))
    error('stage6:param', 'params.k(3) is %g; legal: finite', params.k(3));
end
if ~(isfinite(given.deadbeat) && (given.deadbeat >= 0.0))
    error('stage6:param', 'params.deadbeat is %g; legal: >= 0', params.deadbeat);
end
samples = given.samples;
s1 = ((given.k(3) / 0.7) - 4.0) + 3.0;
s2 = pick(s1 < 6.0, 6.0, s1);
deadbeat = pick(given.deadbeat > 0.0, given.deadbeat, s2);
w1_1 = 125000000.0 * (0.5 * (-(given.k(1) / 0.343)));
w1_2 = 250000.0 * ((-0.5) * (-(given.k(1) / 0.343)));
w1_3 = 500.0 * (0.16666666666666666 * (-(given.k(1) / 0.343)));
s3 = 0.5 * (((-1.0) - (given.k(2) / 0.49)) + (given.k(3) / 0.7));
w2_2 = 250000.0 * s3;
s4 = (-0.25) * (((-1.0) - (given.k(2) / 0.49)) + (given.k(3) / 0.7));
w2_3 = 500.0 * s4;
w3_3 = 500.0 * (0.5 * (3.0 - (given.k(3) / 0.7)));
u_max = given.u_max;
if ~(isfinite(deadbeat) ...
    && isfinite(w1_1) ...
    && isfinite(w1_2) ...
    && isfinite(w1_3) ...
    && isfinite(w2_2) ...
    && isfinite(w2_3) ...
    && isfinite(w3_3))
    error('stage6:param', 'the coefficients leave the range of numbers: take gains, rates and sample periods nearer to 1');
end
self.start = uint32(0);
self.samples = samples;
self.u1 = 0.0;
self.seen = uint32(0);
self.x2_hat = 0.0;
self.x3_hat = 0.0;
self.deadbeat = deadbeat;
self.w1_1 = w1_1;
self.w1_2 = w1_2;
self.w1_3 = w1_3;
self.w2_2 = w2_2;
self.w2_3 = w2_3;
self.w3_3 = w3_3;
self.u_max = u_max;
end

function r = pick(condition, yes, no)
if condition
    r = yes;
else
    r = no;
end
end
