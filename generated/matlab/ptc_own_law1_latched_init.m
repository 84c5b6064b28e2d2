function self = ptc_own_law1_latched_init(params, x0) %#codegen
%PTC_OWN_LAW1_LATCHED_INIT  Takes the parameters and arms at params.t0 (or the fixed t0), latching the state x0.
%
%   self = ptc_own_law1_latched_init(params, x0) is the controller, for the functions that stand
%   beside this one. A parameter outside its domain, or coefficients that overflow, raise an
%   error ptc_own_law1_latched:param, which names what is wrong and what is legal.
%
%   params is a struct:
%     tau: prescribed settling time [s], finite, > 0
%     t0: start time [s], finite
%     eps: time-to-go at which the gains are held [s], > 0, < tau
%     u_max: bound of |u| [unit of u], > 0, infinity allowed

% Prescribed-time controller ptc_own_law1_latched: order n = 1, mapping exp.
%
% DO NOT EDIT. Made by:
%   ptc-codegen emit --lang matlab --n 1 --mu "exp(a=1)" --name ptc_own_law1_latched
%       --pi0="-2*xi1 - xi1*xi1_0"
% Version 0.1.0.
%
% It brings x1' = x2, ..., xn' = u to rest at the time t0 + tau (x in unit, unit/s, ...).
%
% Parameters:
%   tau: prescribed settling time [s], finite, > 0
%   t0: start time [s], finite
%   eps: time-to-go at which the gains are held [s], > 0, < tau
%   u_max: bound of |u| [unit of u], > 0, infinity allowed
%   a = 1, fixed: rate of stretched time [1/s], finite, > 0
%
% Time mapping (T = t0 + tau - t is the time-to-go, Dt = t - t0 the elapsed time):
%   mu(t)     = tau*(1 - exp(-a*t))
%   kappa(Dt) = -ln(T/tau)/a
%   atoms: T = time-to-go
% Derivatives r_k = mu^(k)(kappa(Dt)):
%   r_k = (-1)^(k-1) a^k T
%   r_1 = a*T
% Matrix BB_n, entry (i,j) = B_{i-1,j-1}(r_1, ...), and its next row b_n:
%   B_{0,0} = 1
%
% Law, Theorem 1: u = kappa'^n/g (pi0(BB_n x, t_kappa) - b_n^T x)
%   pi0 = -2*xi1 - xi1*xi1_0
%   g   = 1
%   xi_i = sum_j (i-1)!/(j-1)! r_1^(j-1) [z^(i-1)] p(z)^(j-1) x_j
%   p(z) = z + sum_{l>=2} r_l/(r_1 l!) z^l
%
% From t0 + tau - eps on, T is held at eps (status HOLD): the gains stay, u stays valid.
% |u| <= u_max always (status SATURATED where u was clipped).
% Guard full: every input and pointer is checked.
% Precision f64 (IEEE 754 binary64). Equal bits everywhere need no fused multiply-add
%       (-ffp-contract=off).
%
% Checks of the design (ptc-codegen check tells more):
%   membership: sound: exp is of class M for all its parameters.
%   growth: not checked: the law is no sum of gains, so its poles are not known.
%   sampling: not checked: `sample_time` is not given.
%   deadline: not checked: `error` is not given.
%   envelope: not checked: `x_max` is not given.
%
% Operations of one step: 5 + - or comparison, 3 *, 1 /, 0 sqrt, 0 calls.
% Latencies added up: x86-64 about 46 cycles, Cortex-M4F about 22 cycles.

tau = double(params.tau);
t0 = double(params.t0);
eps = double(params.eps);
u_max = double(params.u_max);

if ~(isfinite(tau) && (tau > 0.0))
    error('ptc_own_law1_latched:param', 'params.tau is %g; legal: finite, > 0', tau);
end
if ~isfinite(t0)
    error('ptc_own_law1_latched:param', 'params.t0 is %g; legal: finite', t0);
end
if ~(eps > 0.0)
    error('ptc_own_law1_latched:param', 'params.eps is %g; legal: > 0, < tau', eps);
end
if ~(u_max > 0.0)
    error('ptc_own_law1_latched:param', 'params.u_max is %g; legal: > 0, infinity allowed', u_max);
end
if ~(eps < tau)
    error('ptc_own_law1_latched:param', 'params.eps is %g; legal: > 0, < tau', eps);
end

hold_from = -eps;
self.tau = tau;
self.eps = eps;
self.hold_from = hold_from;
self.u_max = u_max;
self.t0 = 0.0;
self.deadline = 0.0;
self.correction = 0.0;
self.x1_0 = 0.0;

if ~(isfinite(self.hold_from))
    error('ptc_own_law1_latched:param', 'the coefficients overflow: take smaller gains, or rates nearer to 1');
end
self = ptc_own_law1_latched_arm(self, t0, x0);
end
