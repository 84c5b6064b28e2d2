function self = stage43_init(~) %#codegen
%STAGE43_INIT Takes the parameters and arms at tick 0.
%
%   self = stage43_init(params) is the controller, for the functions that stand beside this one. A
%   parameter outside its domain, or coefficients that leave the range of numbers, raise an error
%   stage43:param, which names what is wrong and what is legal.

% Prescribed-time controller stage43: order n = 3, clock in samples.
%
% DO NOT EDIT. Made by:
%   ptc-codegen emit --lang matlab --n 3 --mu "exp(a=1)" --name stage43 --clock samples --delay-law=predict --measured=x1 --disturbance constant --observer-poles=-4,-5,-6,-7 --observer-samples=20 --tau=0.4 --eps=0 --u-max=6 --poles="least-energy(weight=1)" --reference="t^2/2" --sample-time=1e-2 --delay=2.75
% Version 0.1.0, design c760bae9e1f5.
%
% Plant: x1' = x2, ..., x3' = (u + d), d constant and unknown; u held from sample to sample,
%       2.75 samples late.
% Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
%       sample period, as long as u is not clipped and nothing else acts on the plant.
% Law of the state x predicted for the time from which u acts, by x and the inputs under way:
%       with M samples to go and z = S x, u h^3 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-2));
%       the rows are those of Theorem 1 for the mapping exp. The gains of 6 samples to go
%       stay: they are deadbeat.
% With the reference r, e_i = x_i - r^(i-1) is in place of x_i above, and u = w + rho/g,
%       where the inputs under way count less the rho of their own samples. At sample N e is
%       0 where r^(n) is constant over each sample; else an error of order h^(5-i) is left in
%       e_i.
% t counts from the tick at which it was armed, and rho is r^(n) in the middle of the time in
%       which u acts:
%   e_i = x_i - r^(i-1), with the reference r = t^2/2
%   r^(1) = t
%   r^(2) = 1
%
% Parameters:
%   samples = 40 [samples], fixed: samples N from the start to rest
%   h = 1e-2 [s], fixed: sample period
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
% |u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
%       lasts.
% Guard full: what is measured is finite, or the call is refused (INPUT).
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
self.u3 = 0.0;
self.u4 = 0.0;
self.seen = uint32(0);
self.x1_hat = 0.0;
self.x2_hat = 0.0;
self.x3_hat = 0.0;
self.d_hat = 0.0;
end
