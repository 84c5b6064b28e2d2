function self = ceiling_filter_init(params) %#codegen
%CEILING_FILTER_INIT Takes the parameters and arms at tick 0.
%
%   self = ceiling_filter_init(params) is the filter, for the functions that stand beside this one.
%   A parameter outside its domain, or coefficients that leave the range of numbers, raise an error
%   ceiling_filter:param, which names what is wrong and what is legal.
%
%   params is a struct:
%     u_max: bound of |u| [unit of u], > 0, infinity allowed

% Prescribed-time filter ceiling_filter: order n = 3, clock in samples.
%
% DO NOT EDIT. Made by:
%   ptc-codegen emit --lang matlab --n 3 --name ceiling --what filter --keep-below=1 --keep-tolerance=1e-3 --keep-poles=-3,-5,-8 --poles="least-energy(weight=1)" --precision f32 --tau=1 --f="1/2" --g="-2" --sample-time=0.01 --delay=1.5
% Version 0.1.0, design deb0d31bb8ee.
%
% Plant: x1' = x2, ..., x3' = f + g u; u held from sample to sample, 1.5 samples late.
% Goal: x1 <= 1, at and between all samples, under any controller, from every state from
%       which that is possible and as long as nothing else acts on the plant.
% Filter: with the control points z = S x of the trajectory, q_0 = z_i and q_j = (Delta +
%       a_(i+j-1)) q_(j-1), with the rates a_i = (1 - exp(p_i h))/h of the poles -3, -5, -8
%       1/s. In this cone all states are safe: x_i stays within its bound b as long as all
%       q_j are within b a_i...a_(i+j-1), j < n+1-i; the last of them, in which u occurs, is
%       the limit of u.
% From any other state u is held to the law least-energy(weight=1) of the chain of each x_i
%       less its bound too, so that x_i is within it at the latest N samples after the last
%       safe one, as long as neither the limits of u nor those by other bounds are in the way.
%
% Parameters:
%   samples = 100 [samples], fixed: samples N in which a state outside returns
%   h = 0.01 [s], fixed: sample period
%   u_max [unit of u]: bound of |u|
%
% k counts samples and may wrap; call step at least once within 2^32 - N samples.
% u is u_nominal where no bound is near (status OK), and else the nearest that they allow
%       (SATURATED).
% INFEASIBLE: the state is not safe, or not all bounds can be kept: those of x1 go before
%       those of x2 and so on, the limits of u before all.
% |u| <= u_max: u is clipped to it (status SATURATED). This goes before all bounds.
% Guard full: x and u_nominal are finite, or the call is refused (INPUT).
% Precision f32 (IEEE 754 binary32). Results are bit for bit the same on every IEEE 754
%       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
%
% Checks of the design (details: ptc-codegen check):
%   membership: sound: exp is of class M for all its parameters.
%   growth: not checked: a filter has no law.
%   sampling: not checked: a filter has no law.
%   deadline: not checked: a filter has no law.
%   loop: not checked: `u_max` is left to run time.
%   envelope: not checked: a filter has no law.

given.u_max = single(params.u_max);
if ~(given.u_max > single(0.0))
    error('ceiling_filter:param', 'params.u_max is %g; legal: > 0', params.u_max);
end
u_max = given.u_max;
self.start = uint32(0);
self.u1 = single(0.0);
self.u2 = single(0.0);
self.u_max = u_max;
end
