function self = shaken_init(~) %#codegen
%SHAKEN_INIT Takes the parameters and arms at tick 0.
%
%   self = shaken_init(params) is the controller, for the functions that stand beside this one. A
%   parameter outside its domain, or coefficients that leave the range of numbers, raise an error
%   shaken:param, which names what is wrong and what is legal.

% Prescribed-time controller shaken: order n = 2, clock in samples.
%
% DO NOT EDIT. Made by:
%   ptc-codegen emit --lang matlab --n 2 --mu "exp(a=1)" --name shaken --clock samples --delay-law=predict --measured=x1 --disturbance="sine(omega=60)" --observer-poles=-4,-5,-6,-7 --observer-samples=200 --observer-eps=0.03 --tau=0.6 --eps=0.01 --u-max=8 --poles="least-energy(weight=1)" --g="2" --sample-time=1e-3 --delay=1.75 --sensor-step=1e-6,0
% Version 0.1.0, design db5a18285eee.
%
% Plant: x1' = x2, x2' = g (u + d), d an unknown sine(omega=60); u held from sample to
%       sample, 1.75 samples late.
% Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
%       sample period, as long as u is not clipped and nothing else acts on the plant. What d
%       does within a sample remains, of order h^(4-i) in x_i.
% Law of the state x predicted for the time from which u acts, by x and the inputs under way:
%       with M samples to go and z = S x, u h^2 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-1));
%       the rows are those of Theorem 1 for the mapping exp. The gains of 12 samples to go
%       stay.
%
% Parameters:
%   samples = 600 [samples], fixed: samples N from the start to rest
%   h = 1e-3 [s], fixed: sample period
%   eps = 0.01 [s], fixed: time-to-go at which the gains are held
%   u_max = 8 [unit of u], fixed: bound of |u|
%   a = 1 [1/s], fixed: rate of stretched time
%   k_1 = 12 [1/s^2], fixed: gains k_i of pi0 = -sum k_i xi_i
%   k_2 = 7 [1/s], fixed: gains k_i of pi0 = -sum k_i xi_i
%
% k counts samples and may wrap; arm again within 2^32 - N samples.
% From sample N on the last gains are held (status HOLD).
% The estimates are exact from sample 200 after the start on where the measurement is; with
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
%   growth: sound: near rest at sample 600, not at rest: the gains are held from 10 samples
%       to go, and |u| is bounded; so does what the held observer leaves of its error.
%   sampling: not checked: the law is exact in samples, at any period.
%   deadline: not checked: the law is exact in samples, at any period.
%   loop: not checked: `x0_max` is not given.
%   envelope: not checked: it does not examine a clock in samples.

self.start = uint32(0);
self.u1 = 0.0;
self.u2 = 0.0;
self.u3 = 0.0;
self.seen = uint32(0);
self.x1_hat = 0.0;
self.x2_hat = 0.0;
self.d_hat = 0.0;
self.d_rate_hat = 0.0;
end
