function self = ptc_exp3_f32_init(params) %#codegen
%PTC_EXP3_F32_INIT  Takes the parameters and arms at params.t0 (or the fixed t0).
%
%   self = ptc_exp3_f32_init(params) is the controller, for the functions that stand
%   beside this one. A parameter outside its domain, or coefficients that overflow, raise an
%   error ptc_exp3_f32:param, which names what is wrong and what is legal.
%
%   params is a struct:
%     tau: prescribed settling time [s], finite, > 0
%     t0: start time [s], finite
%     eps: time-to-go at which the gains are held [s], > 0, < tau
%     u_max: bound of |u| [unit of u], > 0, infinity allowed
%     a: rate of stretched time [1/s], finite, > 0
%     k(1:3): gains k_i of pi0 = -sum k_i xi_i [s^(i-1-n)], finite

% Prescribed-time controller ptc_exp3_f32: order n = 3, mapping exp.
%
% DO NOT EDIT. Made by:
%   ptc-codegen emit --lang matlab --n 3 --mu exp --name ptc_exp3_f32 --precision f32
% Version 0.1.0.
%
% It brings x1' = x2, ..., xn' = u to rest at the time t0 + tau (x in unit, unit/s, ...).
%
% Parameters:
%   tau: prescribed settling time [s], finite, > 0
%   t0: start time [s], finite
%   eps: time-to-go at which the gains are held [s], > 0, < tau
%   u_max: bound of |u| [unit of u], > 0, infinity allowed
%   a: rate of stretched time [1/s], finite, > 0
%   k: gains k_i of pi0 = -sum k_i xi_i [s^(i-1-n)], finite
%
% Time mapping (T = t0 + tau - t is the time-to-go, Dt = t - t0 the elapsed time):
%   mu(t)     = tau*(1 - exp(-a*t))
%   kappa(Dt) = -ln(T/tau)/a
%   atoms: T = time-to-go
% Derivatives r_k = mu^(k)(kappa(Dt)):
%   r_k = (-1)^(k-1) a^k T
%   r_1 = a*T
%   r_2 = -a^2*T
%   r_3 = a^3*T
% Matrix BB_n, entry (i,j) = B_{i-1,j-1}(r_1, ...), and its next row b_n:
%   B_{0,0} = 1
%   B_{1,1} = a*T
%   B_{2,1} = -a^2*T
%   B_{2,2} = a^2*T^2
%   B_{3,1} = a^3*T
%   B_{3,2} = -3*a^3*T^2
%
% Law, Theorem 1: u = kappa'^n/g (pi0(BB_n x, t_kappa) - b_n^T x)
%   pi0 = -(k_1 xi_1 + ... + k_n xi_n)
%   g   = 1
%   u = (sum_j gain_j x_j)/g
%   gain_j = inv_T^(n+1-j) row_j
%   K_i = k_i/(a)^(n+1-i)
%   row_1 = -K1
%   row_2 = -1 - K2 + K3
%   row_3 = 3 - K3
%   inv_T = 1/T
%
% From t0 + tau - eps on, T is held at eps (status HOLD): the gains stay, u stays valid.
% |u| <= u_max always (status SATURATED where u was clipped).
% Guard full: every input and pointer is checked.
% Precision f32 (IEEE 754 binary32). Equal bits everywhere need no fused multiply-add
%       (-ffp-contract=off).
%
% Checks of the design (ptc-codegen check tells more):
%   membership: sound: exp is of class M for all its parameters.
%   growth: not checked: the gains are left to run time: their poles must lie left of -n rho.
%   sampling: not checked: `sample_time` is not given.
%   deadline: not checked: `error` is not given.
%   envelope: not checked: `x_max` is not given.
%
% Operations of one step: 5 + - or comparison, 6 *, 1 /, 0 sqrt, 0 calls.
% Latencies added up: x86-64 about 58 cycles, Cortex-M4F about 25 cycles.

tau = single(params.tau);
t0 = single(params.t0);
eps = single(params.eps);
u_max = single(params.u_max);
a = single(params.a);
k1 = single(params.k(1));
k2 = single(params.k(2));
k3 = single(params.k(3));

if ~(isfinite(tau) && (tau > single(0.0)))
    error('ptc_exp3_f32:param', 'params.tau is %g; legal: finite, > 0', tau);
end
if ~isfinite(t0)
    error('ptc_exp3_f32:param', 'params.t0 is %g; legal: finite', t0);
end
if ~(eps > single(0.0))
    error('ptc_exp3_f32:param', 'params.eps is %g; legal: > 0, < tau', eps);
end
if ~(u_max > single(0.0))
    error('ptc_exp3_f32:param', 'params.u_max is %g; legal: > 0, infinity allowed', u_max);
end
if ~(isfinite(a) && (a > single(0.0)))
    error('ptc_exp3_f32:param', 'params.a is %g; legal: finite, > 0', a);
end
if ~isfinite(k1)
    error('ptc_exp3_f32:param', 'params.k(1) is %g; legal: finite', k1);
end
if ~isfinite(k2)
    error('ptc_exp3_f32:param', 'params.k(2) is %g; legal: finite', k2);
end
if ~isfinite(k3)
    error('ptc_exp3_f32:param', 'params.k(3) is %g; legal: finite', k3);
end
if ~(eps < tau)
    error('ptc_exp3_f32:param', 'params.eps is %g; legal: > 0, < tau', eps);
end

v1 = a * a;
K1 = k1 / (a * v1);
K2 = k2 / v1;
K3 = k3 / a;
c1 = -K1;
c2 = ((-K2) + K3) - single(1.0);
c3 = (-K3) + single(3.0);
hold_from = -eps;
self.c1 = c1;
self.c2 = c2;
self.c3 = c3;
self.tau = tau;
self.eps = eps;
self.hold_from = hold_from;
self.u_max = u_max;
self.t0 = single(0.0);
self.deadline = single(0.0);
self.correction = single(0.0);

if ~(isfinite(self.c1) ...
        && isfinite(self.c2) ...
        && isfinite(self.c3) ...
        && isfinite(self.hold_from))
    error('ptc_exp3_f32:param', 'the coefficients overflow: take smaller gains, or rates nearer to 1');
end
self = ptc_exp3_f32_arm(self, t0);
end
