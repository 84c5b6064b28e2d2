function self = ptc_exp3_f32_init(params) %#codegen
%PTC_EXP3_F32_INIT Takes the parameters and arms at params.t0 (or the fixed t0).
%
%   self = ptc_exp3_f32_init(params) is the controller, for the functions that stand beside this
%   one. A parameter outside its domain, or coefficients that leave the range of numbers, raise an
%   error ptc_exp3_f32:param, which names what is wrong and what is legal.
%
%   params is a struct:
%     tau: prescribed settling time [s], from 1e-18 to 1e18
%     t0: start time [s], finite
%     eps: time-to-go at which the gains are held [s], >= 1e-18, < tau
%     u_max: bound of |u| [unit of u], > 0, infinity allowed
%     a: rate of stretched time [1/s], from 1e-18 to 1e18
%     k(1:3): gains of pi0 = -(k_1 xi_1 + ... + k_3 xi_3), finite; k(1) is k_1 [1/s^3], k(2) is k_2 [1/s^2], k(3) is k_3 [1/s]

% Prescribed-time controller ptc_exp3_f32: order n = 3, mapping exp.
%
% DO NOT EDIT. Made by:
%   ptc-codegen emit --lang matlab --n 3 --mu exp --name ptc_exp3_f32 --precision f32
% Version 0.1.0, design 0d95d06872ef.
%
% Plant: x1' = x2, ..., x3' = f + u. Time in s, x1 in any unit U, x2 in U/s, x3 in U/s^2, u
%       in U/s^3.
% Goal: x = 0 at the deadline t0 + tau from any state at t0, up to the error that the hold at
%       eps, sampling, f and clipping leave. The checks below say what is known of this
%       design.
% f is not part of the law: cancel its known terms before the call.
%
% SAMPLE PERIOD NOT GIVEN: the held gains grow as eps falls, and the loop is stable only for
%       sample periods below a limit that depends on eps and the gains. ptc-codegen check
%       finds it once tau, eps, the gains and --sample-time are given.
%
% Parameters:
%   tau: prescribed settling time [s], from 1e-18 to 1e18
%   t0: start time [s], finite
%   eps: time-to-go at which the gains are held [s], >= 1e-18, < tau
%   u_max: bound of |u| [unit of u], > 0, infinity allowed
%   a: rate of stretched time [1/s], from 1e-18 to 1e18
%   k: gains of pi0 = -(k_1 xi_1 + ... + k_3 xi_3), finite; k(1) is k_1 [1/s^3], k(2) is k_2
%       [1/s^2], k(3) is k_3 [1/s]
%
% Time mapping, with time-to-go T = t0 + tau - t and elapsed time Dt = t - t0; t in mu(t) is
%       the stretched time since t0:
%   mu(t)     = tau*(1 - exp(-a*t))
%   kappa(Dt) = -ln(T/tau)/a
% Derivatives r_k = mu^(k)(kappa(Dt)):
%   r_k = (-1)^(k-1) a^k T
%   r_1 = a*T
%   r_2 = -a^2*T
%   r_3 = a^3*T
% Matrix BB_n, entry (i,j) = B_{i-1,j-1}(r_1, ...), and its next row b_n; zeros are left out:
%   B_{0,0} = 1
%   B_{1,1} = a*T
%   B_{2,1} = -a^2*T
%   B_{2,2} = a^2*T^2
%   B_{3,1} = a^3*T
%   B_{3,2} = -3*a^3*T^2
%
% Law, Theorem 1, with xi = BB_n x and t_kappa = kappa(Dt) + t0:
%   u = kappa'^n (pi0(xi, t_kappa) - b_n^T x)
%   pi0 = -(k_1 xi_1 + ... + k_3 xi_3)
%   u = sum_j gain_j x_j
%   gain_j = inv_T^(n+1-j) row_j
%   K1, K2, ...: K_i = k_i/a^(n+1-i)
%   row_1 = -K1
%   row_2 = -1 - K2 + K3
%   row_3 = 3 - K3
%   inv_T = 1/T
%
% From t0 + tau - eps on, and after the deadline, the gains of T = eps are held (status HOLD).
% |u| <= u_max: u is clipped to it (status SATURATED). Prolonged saturation voids the
%       deadline.
% Guard full: t and x are finite and t >= t0, or the call is refused (INPUT).
% Precision f32 (IEEE 754 binary32). Results are bit for bit the same on every IEEE 754
%       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
%
% Checks of the design (details: ptc-codegen check):
%   membership: sound: exp is of class M for all its parameters.
%   growth: not checked: the gains are left to run time: their poles must lie left of -n rho.
%   sampling: not checked: `sample_time` is not given.
%   deadline: not checked: `error` is not given.
%   loop: not checked: it needs a value of `tau`.
%   envelope: not checked: `x_max` is not given.
%
% Operations of one step, without input checks and clipping: 5 additions or comparisons, 6
%       multiplications, 1 division.

given.tau = single(params.tau);
given.t0 = single(params.t0);
given.eps = single(params.eps);
given.u_max = single(params.u_max);
given.a = single(params.a);
given.k = single(params.k);
if numel(params.k) ~= 3
    error('ptc_exp3_f32:param', 'params.k has %d numbers; legal: 3', numel(params.k));
end
tau = given.tau;
t0 = given.t0;
eps = given.eps;
u_max = given.u_max;
a = given.a;
k1 = given.k(1);
k2 = given.k(2);
k3 = given.k(3);
if ~(isfinite(tau) ...
    && (single(1.000000045813705e-18) <= tau) ...
    && (tau <= single(9.999999843067494e17)))
    error('ptc_exp3_f32:param', 'params.tau is %g; legal: from 1.000000045813705e-18 to 9.999999843067494e17', params.tau);
end
if ~isfinite(t0)
    error('ptc_exp3_f32:param', 'params.t0 is %g; legal: finite', params.t0);
end
if ~(eps >= single(1.000000045813705e-18))
    error('ptc_exp3_f32:param', 'params.eps is %g; legal: >= 1.000000045813705e-18', params.eps);
end
if ~(u_max > single(0.0))
    error('ptc_exp3_f32:param', 'params.u_max is %g; legal: > 0', params.u_max);
end
if ~(isfinite(a) && (single(1.000000045813705e-18) <= a) && (a <= single(9.999999843067494e17)))
    error('ptc_exp3_f32:param', 'params.a is %g; legal: from 1.000000045813705e-18 to 9.999999843067494e17', params.a);
end
if ~isfinite(k1)
    error('ptc_exp3_f32:param', 'params.k(1) is %g; legal: finite', params.k(1));
end
if ~isfinite(k2)
    error('ptc_exp3_f32:param', 'params.k(2) is %g; legal: finite', params.k(2));
end
if ~isfinite(k3)
    error('ptc_exp3_f32:param', 'params.k(3) is %g; legal: finite', params.k(3));
end
if ~(eps < tau)
    error('ptc_exp3_f32:param', 'params.eps is %g; legal: < tau', params.eps);
end
v1 = a * a;
v2 = a * v1;
K1 = k1 / v2;
K2 = k2 / v1;
K3 = k3 / a;
c1 = -K1;
c2 = ((-K2) + K3) - single(1.0);
c3 = (-K3) + single(3.0);
hold_from = -eps;
size_K1 = pick(abs(k1) <= single(0.0), single(1.0000000031710769e-30), abs(K1));
size_K2 = pick(abs(k2) <= single(0.0), single(1.0000000031710769e-30), abs(K2));
size_K3 = pick(abs(k3) <= single(0.0), single(1.0000000031710769e-30), abs(K3));
if ~((v2 >= single(1.0000000031710769e-30)) ...
    && (size_K1 >= single(1.0000000031710769e-30)) ...
    && (size_K2 >= single(1.0000000031710769e-30)) ...
    && (size_K3 >= single(1.0000000031710769e-30)) ...
    && isfinite(c1) ...
    && isfinite(c2) ...
    && isfinite(c3) ...
    && isfinite(hold_from))
    error('ptc_exp3_f32:param', 'the coefficients leave the range of numbers: take gains, rates and sample periods nearer to 1');
end
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
self = ptc_exp3_f32_arm(self, t0);
end

function r = pick(condition, yes, no)
if condition
    r = yes;
else
    r = no;
end
end
