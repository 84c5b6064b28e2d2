function self = motor_init(~) %#codegen
%MOTOR_INIT Takes the parameters and arms at tick 0.
%
%   self = motor_init(params) is the controller, for the functions that stand beside this one. A
%   parameter outside its domain, or coefficients that leave the range of numbers, raise an error
%   motor:param, which names what is wrong and what is legal.

% Prescribed-time controller motor: order n = 3, clock in samples.
%
% DO NOT EDIT. Made by:
%   ptc-codegen emit --lang matlab --n 3 --mu "exp(a=1)" --name motor --clock samples --A="[[0,1,0],[0,-0.5,1500],[0,-15,-600]]" --B="[0,0,500]" --C="[[1,0,0]]" --delay-law=predict --disturbance constant --observer-poles=-4,-5,-6,-7 --observer-samples=150 --observer-eps=0.04 --tau=0.4 --eps=0.02 --u-max=24 --poles="least-energy(weight=2)" --sample-time=1e-3 --delay=1 --sensor-step=6e-6
% Version 0.1.0, design 2a5220d7c7d8.
%
% Plant: x' = A x + B (u + d), d constant and unknown of --A and --B above; u held from
%       sample to sample, one sample late, y = C x.
% Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
%       sample period, as long as u is not clipped and nothing else acts on the plant.
% Law of the state x predicted for the time from which u acts, by x and the inputs under way:
%       u = -K_M x with M samples to go, of all inputs that end at rest those with the least
%       sum of u^2/(M ... (M+1)). The gains are a table of 2112 bytes: exact below 32 samples
%       to go, and before it those of a grid of 88 nodes, interpolated in a line. The gains
%       of 21 samples to go stay.
%
% Parameters:
%   samples = 400 [samples], fixed: samples N from the start to rest
%   h = 1e-3 [s], fixed: sample period
%   eps = 0.02 [s], fixed: time-to-go at which the gains are held
%   u_max = 24 [unit of u], fixed: bound of |u|
%   a = 1 [1/s], fixed: rate of stretched time
%
% k counts samples and may wrap; arm again within 2^32 - N samples.
% From sample N on the last gains are held (status HOLD).
% The estimates are exact from sample 150 after the start on where the measurement is; with
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
%   growth: sound: near rest at sample 400, not at rest: the gains are held from 20 samples
%       to go, and |u| is bounded; so does what the held observer leaves of its error.
%   sampling: not checked: the law is exact in samples, at any period.
%   deadline: not checked: the law is exact in samples, at any period.
%   loop: not checked: `x0_max` is not given.
%   envelope: not checked: it does not examine a clock in samples.

self.start = uint32(0);
self.u1 = 0.0;
self.u2 = 0.0;
self.seen = uint32(0);
self.x1_hat = 0.0;
self.x1_next = 0.0;
self.x2_hat = 0.0;
self.x2_next = 0.0;
self.x3_hat = 0.0;
self.x3_next = 0.0;
self.d_hat = 0.0;
self.d_next = 0.0;
end
