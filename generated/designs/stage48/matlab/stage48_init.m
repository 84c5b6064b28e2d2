function self = stage48_init(~) %#codegen
%STAGE48_INIT Takes the parameters and arms at tick 0.
%
%   self = stage48_init(params) is the controller, for the functions that stand beside this one. A
%   parameter outside its domain, or coefficients that leave the range of numbers, raise an error
%   stage48:param, which names what is wrong and what is legal.

% Prescribed-time controller stage48: order n = 3, clock in samples.
%
% DO NOT EDIT. Made by:
%   ptc-codegen emit --lang matlab --n 3 --mu "exp(a=1)" --name stage48 --clock samples --A="[[0,1,0],[0,-0.5,1500],[0,-15,-600]]" --B="[0,0,500]" --C="[[1,0,0]]" --delay-law=predict --disturbance constant --observer-poles=-4,-5,-6,-7 --observer-samples=50 --tau=0.1 --eps=0.006 --u-max=24 --poles=least-energy --sample-time=1e-3 --delay=1.5
% Version 0.1.0, design 62df3f06bf2c.
%
% Plant: x' = A x + B (u + d), d constant and unknown of --A and --B above; u held from
%       sample to sample, 1.5 samples late, y = C x.
% Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
%       sample period, as long as u is not clipped and nothing else acts on the plant.
% Law of the state x predicted for the time from which u acts, by x and the inputs under way:
%       u = -K_M x with M samples to go, of all inputs that end at rest those with the least
%       sum of u^2. The gains are a table of 1344 bytes: exact below 32 samples to go, and
%       before it those of a grid of 56 nodes, interpolated in a line. The gains of 8 samples
%       to go stay.
%
% Parameters:
%   samples = 100 [samples], fixed: samples N from the start to rest
%   h = 1e-3 [s], fixed: sample period
%   eps = 0.006 [s], fixed: time-to-go at which the gains are held
%   u_max = 24 [unit of u], fixed: bound of |u|
%   a = 1 [1/s], fixed: rate of stretched time
%
% k counts samples and may wrap; arm again within 2^32 - N samples.
% From sample N on the last gains are held (status HOLD).
% The estimates are exact from sample 50 after the start on where the measurement is; with
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
%   growth: sound: near rest at sample 100, not at rest: the gains are held from 6 samples to
%       go, and |u| is bounded.
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
self.x1_next = 0.0;
self.x2_hat = 0.0;
self.x2_next = 0.0;
self.x3_hat = 0.0;
self.x3_next = 0.0;
self.d_hat = 0.0;
self.d_next = 0.0;
end
