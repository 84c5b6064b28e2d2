function self = stage46_init(~) %#codegen
%STAGE46_INIT Takes the parameters and arms at tick 0.
%
%   self = stage46_init(params) is the controller, for the functions that stand beside this one. A
%   parameter outside its domain, or coefficients that leave the range of numbers, raise an error
%   stage46:param, which names what is wrong and what is legal.

% Prescribed-time controller stage46: order n = 2, clock in samples.
%
% DO NOT EDIT. Made by:
%   ptc-codegen emit --lang matlab --n 2 --mu "exp(a=1)" --name stage46 --clock samples --delay-law=predict --measured=x1 --disturbance constant --observer=stationary --disturbance-walk=1 --tau=0.04 --eps=0 --u-max=6 --poles=least-energy --sample-time=1e-3 --delay=1 --sensor-step=1e-6,0
% Version 0.1.0, design 86690ba9feac.
%
% Plant: x1' = x2, x2' = (u + d), d constant and unknown; u held from sample to sample, one
%       sample late.
% Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
%       sample period, as long as u is not clipped and nothing else acts on the plant.
% Law of the state x predicted for the time from which u acts, by x and the inputs under way:
%       with M samples to go and z = S x, u h^2 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-1));
%       the rows are those of Theorem 1 for the mapping exp. The gains of 3 samples to go
%       stay: they are deadbeat.
%
% Parameters:
%   samples = 40 [samples], fixed: samples N from the start to rest
%   h = 1e-3 [s], fixed: sample period
%   eps = 0 [s], fixed: time-to-go at which the gains are held
%   u_max = 6 [unit of u], fixed: bound of |u|
%   a = 1 [1/s], fixed: rate of stretched time
%   k_1 = 6 [1/s^2], fixed: gains k_i of pi0 = -sum k_i xi_i
%   k_2 = 5 [1/s], fixed: gains k_i of pi0 = -sum k_i xi_i
%
% k counts samples and may wrap; arm again within 2^32 - N samples.
% From sample N on the last gains are held (status HOLD).
% The estimates approach the state from the first sample on: the observer has the gains of
%       the stationary Kalman filter for the noise and disturbance_walk.
% |u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
%       lasts.
% Guard full: what is measured is finite, or the call is refused (INPUT).
% Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
%       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
%
% Checks of the design (details: ptc-codegen check):
%   membership: sound: exp is of class M for all its parameters.
%   growth: sound: at rest at sample 40 from any state, but for what the stationary observer
%       leaves of its error, whatever the poles, and |u| is bounded.
%   sampling: not checked: the law is exact in samples, at any period.
%   deadline: not checked: the law is exact in samples, at any period.
%   loop: not checked: `x0_max` is not given.
%   envelope: not checked: it does not examine a clock in samples.

self.start = uint32(0);
self.u1 = 0.0;
self.u2 = 0.0;
self.seen = uint32(0);
self.x1_hat = 0.0;
self.x2_hat = 0.0;
self.d_hat = 0.0;
end
