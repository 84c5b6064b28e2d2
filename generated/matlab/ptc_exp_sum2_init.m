function self = ptc_exp_sum2_init(params) %#codegen
%PTC_EXP_SUM2_INIT Takes the parameters and arms at params.t0 (or the fixed t0).
%
%   self = ptc_exp_sum2_init(params) is the controller, for the functions that stand beside this
%   one. A parameter outside its domain, or coefficients that leave the range of numbers, raise an
%   error ptc_exp_sum2:param, which names what is wrong and what is legal.
%
%   params is a struct:
%     tau: prescribed settling time [s], from 1e-150 to 1e150
%     t0: start time [s], finite
%     eps: time-to-go at which the gains are held [s], >= 1e-150, < tau
%     u_max: bound of |u| [unit of u], > 0, infinity allowed
%     rates(1:2): rates a_i of stretched time, from 1e-150 to 1e150; rates(1) is a_1 [1/s], rates(2) is a_2 [1/s]
%     k(1:2): gains of pi0 = -(k_1 xi_1 + k_2 xi_2), finite; k(1) is k_1 [1/s^2], k(2) is k_2 [1/s]

% Prescribed-time controller ptc_exp_sum2: order n = 2, mapping exp_sum.
%
% DO NOT EDIT. Made by:
%   ptc-codegen emit --lang matlab --n 2 --mu "exp_sum(2)"
% Version 0.1.0, design b16d2a0d4a86.
%
% Plant: x1' = x2, x2' = f + u. Time in s, x1 in any unit U, x2 in U/s, u in U/s^2.
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
%   tau: prescribed settling time [s], from 1e-150 to 1e150
%   t0: start time [s], finite
%   eps: time-to-go at which the gains are held [s], >= 1e-150, < tau
%   u_max: bound of |u| [unit of u], > 0, infinity allowed
%   rates: rates a_i of stretched time, from 1e-150 to 1e150; rates(1) is a_1 [1/s], rates(2)
%       is a_2 [1/s]
%   k: gains of pi0 = -(k_1 xi_1 + k_2 xi_2), finite; k(1) is k_1 [1/s^2], k(2) is k_2 [1/s]
%
% Time mapping, with time-to-go T = t0 + tau - t and elapsed time Dt = t - t0; t in mu(t) is
%       the stretched time since t0:
%   mu(t)     = tau*mean_i(1 - exp(-a_i*t))
%   kappa(Dt) = the root t of mean_i(exp(-a_i*t)) = T/tau, by a bracketed iteration
%   in terms of e_i = exp(-a_i*t)
% Derivatives r_k = mu^(k)(kappa(Dt)):
%   r_k = (-1)^(k-1) tau mean_i(a_i^k e_i)
%   r_1 = 1/2*tau*a1*e1 + 1/2*tau*a2*e2
%   r_2 = -1/2*tau*a1^2*e1 - 1/2*tau*a2^2*e2
% Matrix BB_n, entry (i,j) = B_{i-1,j-1}(r_1, ...), and its next row b_n; zeros are left out:
%   B_{0,0} = 1
%   B_{1,1} = r1
%   B_{2,1} = r2
%
% Law, Theorem 1, with xi = BB_n x and t_kappa = kappa(Dt) + t0:
%   u = kappa'^n (pi0(xi, t_kappa) - b_n^T x)
%   pi0 = -(k_1 xi_1 + k_2 xi_2)
%   u = sum_j gain_j x_j
%   gain_j = r_1^-(n+1-j) row_j
%   row_j = -1/(j-1)! sum_{i=j..n+1} k_i (i-1)! [z^(i-1)] p(z)^(j-1), with k_(n+1) = 1
%   p(z) = z + sum_{l>=2} r_l/(r_1 l!) z^l, where [z^i] takes the coefficient of z^i
%
% From t0 + tau - eps on, and after the deadline, the gains of T = eps are held (status HOLD).
% |u| <= u_max: u is clipped to it (status SATURATED). Prolonged saturation voids the
%       deadline.
% Guard full: t and x are finite and t >= t0, or the call is refused (INPUT).
% Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
%       machine without fused multiply-add (gcc, clang: -ffp-contract=off) and with the same
%       mathematical library.
%
% Checks of the design (details: ptc-codegen check):
%   membership: sound: exp_sum is of class M for all its parameters.
%   growth: not checked: the gains are left to run time: their poles must lie left of -n rho.
%   sampling: not checked: `sample_time` is not given.
%   deadline: not checked: `error` is not given.
%   loop: not checked: it needs a value of `tau`.
%   envelope: not checked: `x_max` is not given.
%
% Operations of one step, without input checks and clipping: 34 additions or comparisons, 50
%       multiplications, 5 divisions, 5 function calls. One round of the iteration is
%       counted; it takes at most 12.

given.tau = double(params.tau);
given.t0 = double(params.t0);
given.eps = double(params.eps);
given.u_max = double(params.u_max);
given.rates = double(params.rates);
if numel(params.rates) ~= 2
    error('ptc_exp_sum2:param', 'params.rates has %d numbers; legal: 2', numel(params.rates));
end
given.k = double(params.k);
if numel(params.k) ~= 2
    error('ptc_exp_sum2:param', 'params.k has %d numbers; legal: 2', numel(params.k));
end
tau = given.tau;
t0 = given.t0;
eps = given.eps;
u_max = given.u_max;
a1 = given.rates(1);
a2 = given.rates(2);
k1 = given.k(1);
k2 = given.k(2);
if ~(isfinite(tau) && (1e-150 <= tau) && (tau <= 1e150))
    error('ptc_exp_sum2:param', 'params.tau is %g; legal: from 1e-150 to 1e150', params.tau);
end
if ~isfinite(t0)
    error('ptc_exp_sum2:param', 'params.t0 is %g; legal: finite', params.t0);
end
if ~(eps >= 1e-150)
    error('ptc_exp_sum2:param', 'params.eps is %g; legal: >= 1e-150', params.eps);
end
if ~(u_max > 0.0)
    error('ptc_exp_sum2:param', 'params.u_max is %g; legal: > 0', params.u_max);
end
if ~(isfinite(a1) && (1e-150 <= a1) && (a1 <= 1e150))
    error('ptc_exp_sum2:param', 'params.rates(1) is %g; legal: from 1e-150 to 1e150', params.rates(1));
end
if ~(isfinite(a2) && (1e-150 <= a2) && (a2 <= 1e150))
    error('ptc_exp_sum2:param', 'params.rates(2) is %g; legal: from 1e-150 to 1e150', params.rates(2));
end
if ~isfinite(k1)
    error('ptc_exp_sum2:param', 'params.k(1) is %g; legal: finite', params.k(1));
end
if ~isfinite(k2)
    error('ptc_exp_sum2:param', 'params.k(2) is %g; legal: finite', params.k(2));
end
if ~(eps < tau)
    error('ptc_exp_sum2:param', 'params.eps is %g; legal: < tau', params.eps);
end
hold_from = -eps;
target_rate = 2.0 / tau;
v1 = 1.0 / a1;
v2 = 1.0 / a2;
slowest = pick(v1 < v2, v2, v1);
mean_period = 2.0 / (a1 + a2);
s1 = pick(a1 < a2, a2, a1);
tolerance = 0.03 / s1;
b1_1 = 0.5 * a1 * tau;
b1_2 = 0.5 * a2 * tau;
b2_1 = (-0.25) * (a1 * a1) * tau;
b2_2 = (-0.25) * (a2 * a2) * tau;
w1 = -k1;
w2 = -k2;
size_w1 = pick(abs(k1) <= 0.0, 1e-200, abs(w1));
size_w2 = pick(abs(k2) <= 0.0, 1e-200, abs(w2));
if ~((b2_1 <= -1e-200) ...
    && (b2_2 <= -1e-200) ...
    && (size_w1 >= 1e-200) ...
    && (size_w2 >= 1e-200) ...
    && isfinite(hold_from) ...
    && isfinite(target_rate) ...
    && isfinite(slowest) ...
    && isfinite(mean_period) ...
    && isfinite(tolerance) ...
    && isfinite(b1_1) ...
    && isfinite(b1_2) ...
    && isfinite(b2_1) ...
    && isfinite(b2_2) ...
    && isfinite(w1) ...
    && isfinite(w2))
    error('ptc_exp_sum2:param', 'the coefficients leave the range of numbers: take gains, rates and sample periods nearer to 1');
end
self.a1 = a1;
self.a2 = a2;
self.tau = tau;
self.eps = eps;
self.hold_from = hold_from;
self.target_rate = target_rate;
self.slowest = slowest;
self.mean_period = mean_period;
self.tolerance = tolerance;
self.b1_1 = b1_1;
self.b1_2 = b1_2;
self.b2_1 = b2_1;
self.b2_2 = b2_2;
self.w1 = w1;
self.w2 = w2;
self.u_max = u_max;
self.t0 = 0.0;
self.deadline = 0.0;
self.correction = 0.0;
self = ptc_exp_sum2_arm(self, t0);
end

function r = pick(condition, yes, no)
if condition
    r = yes;
else
    r = no;
end
end
