function self = duration_latched_init(params, x0) %#codegen
%DURATION_LATCHED_INIT Takes the parameters and arms at params.t0 (or the fixed t0) for params.tau,
%latching the state x0.
%
%   self = duration_latched_init(params, x0) is the controller, for the functions that stand beside
%   this one. A parameter outside its domain, or coefficients that leave the range of numbers, raise
%   an error duration_latched:param, which names what is wrong and what is legal.
%
%   params is a struct:
%     tau: prescribed settling time [s], from 1e-150 to 1e150
%     t0: start time [s], finite
%     eps: time-to-go at which the gains are held [s], >= 1e-150, < tau
%     u_max: bound of |u| [unit of u], > 0, infinity allowed
%     c: parameter of kappa, from 0.5 to 2

% Prescribed-time controller duration_latched: order n = 2, mapping custom.
%
% DO NOT EDIT. Made by:
%   ptc-codegen emit --lang matlab --n 2 --kappa="dt/(c*tau*(tau - dt)) + dt" --name duration_latched --in-flight --pi0="-6*xi1 - 5*xi2 + xi1_0/8" --param "c=[0.5,2]" --allow=growth
% Version 0.1.0, design 618c09f23c7e.
%
% Plant: x1' = x2, x2' = f + u. Time in s, x1 in any unit U, x2 in U/s, u in U/s^2.
% Goal: x = 0 at the deadline t0 + tau from any state at t0, up to the error that the hold at
%       eps, sampling, f and clipping leave. The checks below say what is known of this
%       design.
% f is not part of the law: cancel its known terms before the call.
%
% SAMPLE PERIOD NOT GIVEN: the gain held at eps limits the sample period for which the loop
%       is stable. Simulate the sampled loop: ptc-codegen simulate --sample-time.
%
% Parameters:
%   tau: prescribed settling time [s], from 1e-150 to 1e150
%   t0: start time [s], finite
%   eps: time-to-go at which the gains are held [s], >= 1e-150, < tau
%   u_max: bound of |u| [unit of u], > 0, infinity allowed
%   c: parameter of kappa, from 0.5 to 2
%
% Time mapping, with time-to-go T = t0 + tau - t and elapsed time Dt = t - t0; t in mu(t) is
%       the stretched time since t0:
%   kappa(dt) = dt/(c*tau*(tau - dt)) + dt
%   kappa = (tau + tau^2*c*T - tau*c*T^2 - T)/(tau*c*T)
%   r_1 = T*(c*T/(1 + c*T^2))
% r_k and BB_n are computed from the Taylor series of mu at each call.
%
% Law, Theorem 1, with xi = BB_n x and t_kappa = kappa(Dt) + t0:
%   u = kappa'^n (pi0(xi, t_kappa) - b_n^T x)
%   pi0 = -6*xi1 - 5*xi2 + xi1_0/8
%   xi_i = sum_j (i-1)!/(j-1)! r_1^(j-1) [z^(i-1)] p(z)^(j-1) x_j
%   p(z) = z + sum_{l>=2} r_l/(r_1 l!) z^l, where [z^i] takes the coefficient of z^i
%
% From t0 + tau - eps on, and after the deadline, T is held at eps in the law (status HOLD).
% In flight: arm_for starts again at t0 for another tau, at any time, and computes what
%       follows from tau. arm keeps the tau last used: at first that of the parameters.
% |u| <= u_max: u is clipped to it (status SATURATED). Prolonged saturation voids the
%       deadline.
% Guard full: t and x are finite and t >= t0, or the call is refused (INPUT).
% Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
%       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
%
% Checks of the design (details: ptc-codegen check):
%   membership: sound: the mapping is of its class, proved.
%   growth: not checked: the law is not a sum of gains, so its poles are not known.
%   sampling: not checked: `sample_time` is not given.
%   deadline: not checked: `error` is not given.
%   loop: not checked: it needs a linear law.
%   envelope: not checked: `x_max` is not given.
%
% Operations of one step, without input checks and clipping: 11 additions or comparisons, 15
%       multiplications, 3 divisions.

given.tau = double(params.tau);
given.t0 = double(params.t0);
given.eps = double(params.eps);
given.u_max = double(params.u_max);
given.c = double(params.c);
tau = given.tau;
t0 = given.t0;
eps = given.eps;
u_max = given.u_max;
p_c = given.c;
if ~(isfinite(tau) && (1e-150 <= tau) && (tau <= 1e150))
    error('duration_latched:param', 'params.tau is %g; legal: from 1e-150 to 1e150', params.tau);
end
if ~isfinite(t0)
    error('duration_latched:param', 'params.t0 is %g; legal: finite', params.t0);
end
if ~(eps >= 1e-150)
    error('duration_latched:param', 'params.eps is %g; legal: >= 1e-150', params.eps);
end
if ~(u_max > 0.0)
    error('duration_latched:param', 'params.u_max is %g; legal: > 0', params.u_max);
end
if ~((0.5 <= p_c) && (p_c <= 2.0))
    error('duration_latched:param', 'params.c is %g; legal: from 0.5 to 2', params.c);
end
if ~(eps < tau)
    error('duration_latched:param', 'params.eps is %g; legal: < tau', params.eps);
end
hold_from = -eps;
if ~isfinite(hold_from)
    error('duration_latched:param', 'the coefficients leave the range of numbers: take gains, rates and sample periods nearer to 1');
end
self.eps = eps;
self.hold_from = hold_from;
self.p_c = p_c;
self.u_max = u_max;
self.t0 = 0.0;
self.tau = 0.0;
self.deadline = 0.0;
self.correction = 0.0;
self.f44 = 0.0;
self = duration_latched_arm_for(self, t0, tau, x0);
end
