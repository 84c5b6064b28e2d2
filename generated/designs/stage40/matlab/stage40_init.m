function self = stage40_init(~) %#codegen
%STAGE40_INIT Takes the parameters and arms at tick 0.
%
%   self = stage40_init(params) is the controller, for the functions that stand beside this one. A
%   parameter outside its domain, or coefficients that leave the range of numbers, raise an error
%   stage40:param, which names what is wrong and what is legal.

% Prescribed-time controller stage40: order n = 2, clock in samples.
%
% DO NOT EDIT. Made by:
%   ptc-codegen emit --lang matlab --n 2 --mu "exp(a=1)" --name stage40 --clock samples --measured=x1 --disturbance constant --observer-poles=-4,-5,-6 --observer-samples=20 --innovation-max=0.5 --measurement-max=1.5 --coast=2 --tau=0.04 --eps=0 --u-max=6 --poles=-4,-5,-6 --reference input --sample-time=1e-3 --delay=1
% Version 0.1.0, design 1f938d622e88.
%
% Plant: x1' = x2, x2' = (u + d), d constant and unknown; u held from sample to sample, one
%       sample late.
% Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
%       sample period, as long as u is not clipped and nothing else acts on the plant.
% Law: with M - 3 samples to go and z = S x, u h^3 = sum of row_j z_j
%       h^(j-1)/((M-j+1)...(M-2)); the rows are those of Theorem 1 for the mapping exp. The
%       gains of 3 samples to go stay: they are deadbeat.
% With the reference r, e_i = x_i - r^(i-1) is in place of x_i above, and u = w + rho/g,
%       where the inputs under way count less the rho of their own samples. At sample N e is
%       0 where r^(n) is constant over each sample; else an error of order h^(4-i) is left in
%       e_i.
% e_i = x_i - r[i-1] with r[0]..r[1] the reference and its derivatives at tick k, and rho =
%       r[2], r^(n) over the sample in which u acts: its mean, (r^(n-1)(t + h) -
%       r^(n-1)(t))/h, or that in its middle.
%
% Parameters:
%   samples = 40 [samples], fixed: samples N from the start to rest
%   h = 1e-3 [s], fixed: sample period
%   eps = 0 [s], fixed: time-to-go at which the gains are held
%   u_max = 6 [unit of u], fixed: bound of |u|
%   a = 1 [1/s], fixed: rate of stretched time
%   k_1 = 120 [1/s^3], fixed: gains k_i of pi0 = -sum k_i xi_i
%   k_2 = 74 [1/s^2], fixed: gains k_i of pi0 = -sum k_i xi_i
%   k_3 = 15 [1/s], fixed: gains k_i of pi0 = -sum k_i xi_i
%
% k counts samples and may wrap; arm again within 2^32 - N samples.
% From sample N on the last gains are held (status HOLD).
% The estimates are exact from sample 20 after the start on where the measurement is; with
%       noise or sensor_step given, or observer_eps, the gains of the observer are then held
%       below deadbeat.
% Gate: a reading that is not finite or beyond +-1.5 or further than 0.5 from its prediction
%       is not believed, and the estimates are predicted alone (status GATED) for at most 2
%       samples in a row. Then the call is refused (E_INPUT) until a reading is believed or
%       arm starts the estimates anew. The first reading has no prediction.
% |u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
%       lasts.
% Guard full: what is measured passes this gate, the reference is finite, or the call is
%       refused (INPUT).
% Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
%       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
%
% Checks of the design (details: ptc-codegen check):
%   membership: sound: exp is of class M for all its parameters.
%   growth: sound: at rest at sample 40 from any state, but for what r does between samples,
%       whatever the poles, and |u| is bounded.
%   sampling: not checked: `loop` bounds what the period leaves of a reference that moves.
%   deadline: not checked: `loop` bounds what the period leaves of a reference that moves.
%   loop: not checked: `x0_max` is not given.
%   envelope: not checked: it does not examine a clock in samples.

self.start = uint32(0);
self.u1 = 0.0;
self.u2 = 0.0;
self.seen = uint32(0);
self.x1_hat = 0.0;
self.x2_hat = 0.0;
self.d_hat = 0.0;
self.trust = uint32(1);
self.rho1 = 0.0;
end
