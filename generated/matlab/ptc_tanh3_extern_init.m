function self = ptc_tanh3_extern_init(params) %#codegen
%PTC_TANH3_EXTERN_INIT Takes the parameters and arms at params.t0 (or the fixed t0).
%
%   self = ptc_tanh3_extern_init(params) is the controller, for the functions that stand beside this
%   one. A parameter outside its domain, or coefficients that leave the range of numbers, raise an
%   error ptc_tanh3_extern:param, which names what is wrong and what is legal.
%
%   params is a struct:
%     tau: prescribed settling time [s], from 1e-150 to 1e150
%     t0: start time [s], finite
%     eps: time-to-go at which the gains are held [s], >= 1e-150, < tau
%     u_max: bound of |u| [unit of u], > 0, infinity allowed
%     a: rate of stretched time [1/s], from 1e-150 to 1e150

% Prescribed-time controller ptc_tanh3_extern: order n = 3, mapping tanh.
%
% DO NOT EDIT. Made by:
%   ptc-codegen emit --lang matlab --n 3 --mu tanh --name ptc_tanh3_extern --pi0 extern --after extern
% Version 0.1.0, design 04514e738293.
%
% Plant: x1' = x2, ..., x3' = f + u. Time in s, x1 in any unit U, x2 in U/s, x3 in U/s^2, u
%       in U/s^3.
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
%   a: rate of stretched time [1/s], from 1e-150 to 1e150
%
% Time mapping, with time-to-go T = t0 + tau - t and elapsed time Dt = t - t0; t in mu(t) is
%       the stretched time since t0:
%   mu(t)     = tau*tanh(a*t)
%   kappa(Dt) = -ln(E)/(2*a), E = T/(2*tau - T)
%   in terms of T = time-to-go, E = exp(-2*a*t) = T/(2*tau - T), L = 1/(1 + E)
% Derivatives r_k = mu^(k)(kappa(Dt)):
%   r_k = 2*tau*(-2*a)^k Li_{-k}(-E)
%   r_1 = 2*a*T*L
%   r_2 = 4*a^2*T*E*L^2 - 4*a^2*T*L^2
%   r_3 = -32*a^3*T*E*L^3 + 8*a^3*T*E^2*L^3 + 8*a^3*T*L^3
% Matrix BB_n, entry (i,j) = B_{i-1,j-1}(r_1, ...), and its next row b_n; zeros are left out:
%   B_{0,0} = 1
%   B_{1,1} = 2*a*T*L
%   B_{2,1} = 4*a^2*T*E*L^2 - 4*a^2*T*L^2
%   B_{2,2} = 4*a^2*T^2*L^2
%   B_{3,1} = -32*a^3*T*E*L^3 + 8*a^3*T*E^2*L^3 + 8*a^3*T*L^3
%   B_{3,2} = 24*a^3*T^2*E*L^3 - 24*a^3*T^2*L^3
%
% Law, Theorem 1, with xi = BB_n x and t_kappa = kappa(Dt) + t0:
%   u = kappa'^n (pi0(xi, t_kappa) - b_n^T x)
%   pi0 = a user-defined function of xi and t_kappa
%   xi_i = sum_j (i-1)!/(j-1)! r_1^(j-1) [z^(i-1)] p(z)^(j-1) x_j
%   p(z) = z + sum_{l>=2} r_l/(r_1 l!) z^l, where [z^i] takes the coefficient of z^i
%
% From t0 + tau - eps on, T is held at eps in the law (status HOLD). From t0 + tau on, u is
%       the result of the user-defined function after (status AFTER).
% |u| <= u_max: u is clipped to it (status SATURATED). Prolonged saturation voids the
%       deadline.
% Guard full: t and x are finite and t >= t0, or the call is refused (INPUT).
% Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
%       machine without fused multiply-add (gcc, clang: -ffp-contract=off) and with the same
%       mathematical library.
%
% Checks of the design (details: ptc-codegen check):
%   membership: sound: tanh is of class M for all its parameters.
%   growth: not checked: the law is not a sum of gains, so its poles are not known.
%   sampling: not checked: `sample_time` is not given.
%   deadline: not checked: `error` is not given.
%   loop: not checked: it needs a linear law.
%   envelope: not checked: `x_max` is not given.
%
% Operations of one step, without input checks and clipping: 16 additions or comparisons, 24
%       multiplications, 4 divisions, 2 function calls.

given.tau = double(params.tau);
given.t0 = double(params.t0);
given.eps = double(params.eps);
given.u_max = double(params.u_max);
given.a = double(params.a);
tau = given.tau;
t0 = given.t0;
eps = given.eps;
u_max = given.u_max;
a = given.a;
if ~(isfinite(tau) && (1e-150 <= tau) && (tau <= 1e150))
    error('ptc_tanh3_extern:param', 'params.tau is %g; legal: from 1e-150 to 1e150', params.tau);
end
if ~isfinite(t0)
    error('ptc_tanh3_extern:param', 'params.t0 is %g; legal: finite', params.t0);
end
if ~(eps >= 1e-150)
    error('ptc_tanh3_extern:param', 'params.eps is %g; legal: >= 1e-150', params.eps);
end
if ~(u_max > 0.0)
    error('ptc_tanh3_extern:param', 'params.u_max is %g; legal: > 0', params.u_max);
end
if ~(isfinite(a) && (1e-150 <= a) && (a <= 1e150))
    error('ptc_tanh3_extern:param', 'params.a is %g; legal: from 1e-150 to 1e150', params.a);
end
if ~(eps < tau)
    error('ptc_tanh3_extern:param', 'params.eps is %g; legal: < tau', params.eps);
end
hold_from = -eps;
f16 = 2.0 * tau;
f22 = 2.0 * a;
f24 = f16 * a;
f29 = 1.0 / tau;
if ~(isfinite(hold_from) && isfinite(f16) && isfinite(f22) && isfinite(f24) && isfinite(f29))
    error('ptc_tanh3_extern:param', 'the coefficients leave the range of numbers: take gains, rates and sample periods nearer to 1');
end
self.tau = tau;
self.eps = eps;
self.hold_from = hold_from;
self.f16 = f16;
self.a = a;
self.f22 = f22;
self.f24 = f24;
self.f29 = f29;
self.u_max = u_max;
self.t0 = 0.0;
self.deadline = 0.0;
self.correction = 0.0;
self = ptc_tanh3_extern_arm(self, t0);
end
