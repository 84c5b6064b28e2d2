function self = wound_init(~) %#codegen
%WOUND_INIT Takes the parameters and arms at tick 0.
%
%   self = wound_init(params) is the controller, for the functions that stand beside this one. A
%   parameter outside its domain, or coefficients that leave the range of numbers, raise an error
%   wound:param, which names what is wrong and what is legal.

% Prescribed-time controller wound: order n = 2, clock in samples.
%
% DO NOT EDIT. Made by:
%   ptc-codegen emit --lang matlab --n 2 --mu "exp(a=1)" --name wound --clock samples --A="[[0,1],[0,-5]]" --B="[0,40]" --C="[[1,0]]" --disturbance ramp --observer=stationary --disturbance-walk=5 --tau=0.3 --eps=0.01 --u-max=10 --poles=least-energy --sample-time=0.001 --sensor-step=1e-5
% Version 0.1.0, design 6978bbac7216.
%
% Plant: x' = A x + B (u + d), d an unknown ramp of --A and --B above; u held from sample to
%       sample, y = C x.
% Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
%       sample period, as long as u is not clipped and nothing else acts on the plant. What d
%       does within a sample remains, of order h^(4-i) in x_i.
% Law: u = -K_M x with M samples to go, of all inputs that end at rest those with the least
%       sum of u^2. The gains are a table of 2128 bytes: exact below 64 samples to go, and
%       before it those of a grid of 133 nodes, interpolated in a line. The gains of 10
%       samples to go stay.
%
% Parameters:
%   samples = 300 [samples], fixed: samples N from the start to rest
%   h = 0.001 [s], fixed: sample period
%   eps = 0.01 [s], fixed: time-to-go at which the gains are held
%   u_max = 10 [unit of u], fixed: bound of |u|
%   a = 1 [1/s], fixed: rate of stretched time
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
%   growth: sound: near rest at sample 300, not at rest: the gains are held from 10 samples
%       to go, and |u| is bounded; so does what the stationary observer leaves of its error.
%   sampling: not checked: the law is exact in samples, at any period.
%   deadline: not checked: the law is exact in samples, at any period.
%   loop: not checked: `x0_max` is not given.
%   envelope: not checked: it does not examine a clock in samples.

self.start = uint32(0);
self.u1 = 0.0;
self.seen = uint32(0);
self.x1_hat = 0.0;
self.x1_next = 0.0;
self.x2_hat = 0.0;
self.x2_next = 0.0;
self.d_hat = 0.0;
self.d_next = 0.0;
self.d_rate_hat = 0.0;
self.d_rate_next = 0.0;
end
