function self = stop_filter_init(~) %#codegen
%STOP_FILTER_INIT Takes the parameters and arms at tick 0.
%
%   self = stop_filter_init(params) is the filter, for the functions that stand beside this one. A
%   parameter outside its domain, or coefficients that leave the range of numbers, raise an error
%   stop_filter:param, which names what is wrong and what is legal.

% Prescribed-time filter stop_filter: order n = 2, clock in samples.
%
% DO NOT EDIT. Made by:
%   ptc-codegen emit --lang matlab --n 2 --name stop --what filter --keep-below=0.5,0.8 --keep-above=-0.5,-0.8 --keep-poles=-10,-40 --tau=0.4 --u-max=10 --sample-time=1e-3
% Version 0.1.0, design 74c45379c0da.
%
% Plant: x1' = x2, x2' = u; u held from sample to sample.
% Goal: -0.5 <= x1 <= 0.5, -0.8 <= x2 <= 0.8, at and between all samples, under any
%       controller, from every state from which that is possible and as long as nothing else
%       acts on the plant.
% Filter: with the control points z = S x of the trajectory, q_0 = z_i and q_j = (Delta +
%       a_(i+j-1)) q_(j-1), with the rates a_i = (1 - exp(p_i h))/h of the poles -10, -40
%       1/s. In this cone all states are safe: x_i stays within its bound b as long as all
%       q_j are within b a_i...a_(i+j-1), j < n+1-i; the last of them, in which u occurs, is
%       the limit of u.
% From any other state u is held to the law least-energy of the chain of each x_i less its
%       bound too, so that x_i is within it at the latest N samples after the last safe one,
%       as long as neither the limits of u nor those by other bounds are in the way.
%
% Parameters:
%   samples = 400 [samples], fixed: samples N in which a state outside returns
%   h = 1e-3 [s], fixed: sample period
%   u_max = 10 [unit of u], fixed: bound of |u|
%
% k counts samples and may wrap; call step at least once within 2^32 - N samples.
% u is u_nominal where no bound is near (status OK), and else the nearest that they allow
%       (SATURATED).
% INFEASIBLE: the state is not safe, or not all bounds can be kept: those of x1 go before
%       those of x2 and so on, the limits of u before all.
% |u| <= u_max: u is clipped to it (status SATURATED). This goes before all bounds.
% Guard full: x and u_nominal are finite, or the call is refused (INPUT).
% Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
%       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
%
% Checks of the design (details: ptc-codegen check):
%   membership: sound: exp is of class M for all its parameters.
%   growth: not checked: a filter has no law.
%   sampling: not checked: a filter has no law.
%   deadline: not checked: a filter has no law.
%   loop: sound: from every safe state the bounds are kept at and between all samples, and no
%       limit is in the way.
%   envelope: not checked: a filter has no law.

self.start = uint32(0);
end
