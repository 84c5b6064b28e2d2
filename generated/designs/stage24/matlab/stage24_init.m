function self = stage24_init(params) %#codegen
%STAGE24_INIT Takes the parameters and arms at tick 0.
%
%   self = stage24_init(params) is the controller, for the functions that stand beside this one. A
%   parameter outside its domain, or coefficients that leave the range of numbers, raise an error
%   stage24:param, which names what is wrong and what is legal.
%
%   params is a struct:
%     u_max: bound of |u| [unit of u], > 0, infinity allowed
%     size: parameter of an expression of the design [as in its expression], finite

% Prescribed-time controller stage24: order n = 2, clock in samples.
%
% DO NOT EDIT. Made by:
%   ptc-codegen emit --lang matlab --n 2 --mu "exp(a=1)" --name stage24 --clock samples --A="[[-1,1],[3,-2]]" --B="[1,2]" --output="[-2,1]" --precision f32 --tau=0.3 --eps=0 --poles=-4,-5 --reference="size*dt^2/(1 + t^2)" --sample-time=0.01
% Version 0.1.0, design 50bc8ccf34e5.
%
% Plant: x' = A x + B u of --A and --B above; u held from sample to sample.
% Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
%       sample period, as long as u is not clipped and nothing else acts on the plant.
% Law: with M - 3 samples to go and z = S x, the differences of a flat output, u = sum of
%       row_j z_j/((M-j+1)...(M-1)) less the drift of z; the rows are those of Theorem 1 for
%       the mapping exp. The gains of 2 samples to go stay: they are deadbeat.
% With the reference r = size*dt^2/(1 + t^2), x - x_r is in place of x above, and u = w +
%       u_r: with them the output y = -2*x1 + x2 is r, and stays so. At sample N x = x_r
%       where u_r is constant over each sample; else an error of order h^(4-i) is left in
%       y^(i-1).
% t counts from the tick at which it was armed, and u_r is that in the middle of the time in
%       which u acts. To four digits:
%   r^(1) = 2*size*dt*(1 + t^2 - dt*t)/(1 + t^2)^2
%   r^(2) = 2*size*((1 + t^2)^2 + 4*dt^2*t^2 - 4*(1 + t^2)*dt*t - (1 + t^2)*dt^2)/(1 + t^2)^3
%   x_r1 = -1.333*r - 0.3333*r^(1)
%   x_r2 = -1.667*r - 0.6667*r^(1)
%   u_r = 0.3333*r - r^(1) - 0.3333*r^(2)
%
% Parameters:
%   samples = 30 [samples], fixed: samples N from the start to rest
%   h = 0.01 [s], fixed: sample period
%   eps = 0 [s], fixed: time-to-go at which the gains are held
%   u_max [unit of u]: bound of |u|
%   a = 1 [1/s], fixed: rate of stretched time
%   k_1 = 20 [1/s^2], fixed: gains k_i of pi0 = -sum k_i xi_i
%   k_2 = 9 [1/s], fixed: gains k_i of pi0 = -sum k_i xi_i
%   size [as in its expression]: parameter of an expression of the design
%
% k counts samples and may wrap; arm again within 2^32 - N samples.
% From sample N on the last gains are held (status HOLD).
% |u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
%       lasts.
% Guard full: what is measured is finite, or the call is refused (INPUT).
% Precision f32 (IEEE 754 binary32). Results are bit for bit the same on every IEEE 754
%       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
%
% Checks of the design (details: ptc-codegen check):
%   membership: sound: exp is of class M for all its parameters.
%   growth: sound: at rest at sample 30 from any state, but for what r does between samples,
%       whatever the poles, and |u| is bounded.
%   sampling: not checked: `loop` bounds what the period leaves of a reference that moves.
%   deadline: not checked: `loop` bounds what the period leaves of a reference that moves.
%   loop: not checked: `size` is left to run time.
%   envelope: not checked: it does not examine a clock in samples.

given.u_max = single(params.u_max);
given.size = single(params.size);
if ~(given.u_max > single(0.0))
    error('stage24:param', 'params.u_max is %g; legal: > 0', params.u_max);
end
if ~isfinite(given.size)
    error('stage24:param', 'params.size is %g; legal: finite', params.size);
end
p_size = given.size;
c_r4 = single(2.0) * p_size;
u_max = given.u_max;
if ~isfinite(c_r4)
    error('stage24:param', 'the coefficients leave the range of numbers: take gains, rates and sample periods nearer to 1');
end
self.start = uint32(0);
self.p_size = p_size;
self.c_r4 = c_r4;
self.u_max = u_max;
end
