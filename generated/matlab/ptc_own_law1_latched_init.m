function self = ptc_own_law1_latched_init(params, x0) %#codegen
%PTC_OWN_LAW1_LATCHED_INIT Takes the parameters and arms at params.t0 (or the fixed t0), latching
%the state x0.
%
%   self = ptc_own_law1_latched_init(params, x0) is the controller, for the functions that stand
%   beside this one. A parameter outside its domain, or coefficients that leave the range of
%   numbers, raise an error ptc_own_law1_latched:param, which names what is wrong and what is legal.
%
%   params is a struct:
%     tau: prescribed settling time [s], from 1e-150 to 1e150
%     t0: start time [s], finite
%     eps: time-to-go at which the gains are held [s], >= 1e-150, < tau
%     u_max: bound of |u| [unit of u], > 0, infinity allowed

% Prescribed-time controller ptc_own_law1_latched: order n = 1, mapping exp.
%
% DO NOT EDIT. Made by:
%   ptc-codegen emit --lang matlab --n 1 --mu "exp(a=1)" --name ptc_own_law1_latched --pi0="-2*xi1 - xi1*xi1_0"
% Version 0.1.0, design fef8ca24aec8.
%
% Plant: x1' = f + u. Time in s, x1 in any unit U, u in U/s.
% Goal: x = 0 at the deadline t0 + tau from any state at t0, up to the error that the hold at
%       eps, sampling, f and clipping leave. The checks below say what is known of this
%       design.
% f is not part of the law: cancel its known terms before the call.
%
% SAMPLE PERIOD NOT GIVEN: the gain held at eps limits the sample period for which the loop
%       is stable. Simulate the sampled loop: ptc-codegen simulate --sample-time.
%
% Parameters:
%   a = 1 [1/s], fixed: rate of stretched time
%   tau: prescribed settling time [s], from 1e-150 to 1e150
%   t0: start time [s], finite
%   eps: time-to-go at which the gains are held [s], >= 1e-150, < tau
%   u_max: bound of |u| [unit of u], > 0, infinity allowed
%
% Time mapping, with time-to-go T = t0 + tau - t and elapsed time Dt = t - t0; t in mu(t) is
%       the stretched time since t0:
%   mu(t)     = tau*(1 - exp(-a*t))
%   kappa(Dt) = -ln(T/tau)/a
% Derivatives r_k = mu^(k)(kappa(Dt)):
%   r_k = (-1)^(k-1) a^k T
%   r_1 = a*T
% Matrix BB_n, entry (i,j) = B_{i-1,j-1}(r_1, ...), and its next row b_n; zeros are left out:
%   B_{0,0} = 1
%
% Law, Theorem 1, with xi = BB_n x and t_kappa = kappa(Dt) + t0:
%   u = kappa'^n (pi0(xi, t_kappa) - b_n^T x)
%   pi0 = -2*xi1 - xi1*xi1_0
%   xi_i = sum_j (i-1)!/(j-1)! r_1^(j-1) [z^(i-1)] p(z)^(j-1) x_j
%   p(z) = z + sum_{l>=2} r_l/(r_1 l!) z^l, where [z^i] takes the coefficient of z^i
%
% From t0 + tau - eps on, and after the deadline, T is held at eps in the law (status HOLD).
% |u| <= u_max: u is clipped to it (status SATURATED). Prolonged saturation voids the
%       deadline.
% Guard full: t and x are finite and t >= t0, or the call is refused (INPUT).
% Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
%       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
%
% Checks of the design (details: ptc-codegen check):
%   membership: sound: exp is of class M for all its parameters.
%   growth: not checked: the law is not a sum of gains, so its poles are not known.
%   sampling: not checked: `sample_time` is not given.
%   deadline: not checked: `error` is not given.
%   loop: not checked: it needs a linear law.
%   envelope: not checked: `x_max` is not given.
%
% Operations of one step, without input checks and clipping: 5 additions or comparisons, 3
%       multiplications, 1 division.

given.tau = double(params.tau);
given.t0 = double(params.t0);
given.eps = double(params.eps);
given.u_max = double(params.u_max);
tau = given.tau;
t0 = given.t0;
eps = given.eps;
u_max = given.u_max;
if ~(isfinite(tau) && (1e-150 <= tau) && (tau <= 1e150))
    error('ptc_own_law1_latched:param', 'params.tau is %g; legal: from 1e-150 to 1e150', params.tau);
end
if ~isfinite(t0)
    error('ptc_own_law1_latched:param', 'params.t0 is %g; legal: finite', params.t0);
end
if ~(eps >= 1e-150)
    error('ptc_own_law1_latched:param', 'params.eps is %g; legal: >= 1e-150', params.eps);
end
if ~(u_max > 0.0)
    error('ptc_own_law1_latched:param', 'params.u_max is %g; legal: > 0', params.u_max);
end
if ~(eps < tau)
    error('ptc_own_law1_latched:param', 'params.eps is %g; legal: < tau', params.eps);
end
hold_from = -eps;
if ~isfinite(hold_from)
    error('ptc_own_law1_latched:param', 'the coefficients leave the range of numbers: take gains, rates and sample periods nearer to 1');
end
self.tau = tau;
self.eps = eps;
self.hold_from = hold_from;
self.u_max = u_max;
self.t0 = 0.0;
self.deadline = 0.0;
self.correction = 0.0;
self.x1_0 = 0.0;
self = ptc_own_law1_latched_arm(self, t0, x0);
end
