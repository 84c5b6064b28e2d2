function self = ptc_rational_inputs4_init(params) %#codegen
%PTC_RATIONAL_INPUTS4_INIT Takes the parameters and arms at params.t0 (or the fixed t0).
%
%   self = ptc_rational_inputs4_init(params) is the controller, for the functions that stand beside
%   this one. A parameter outside its domain, or coefficients that leave the range of numbers, raise
%   an error ptc_rational_inputs4:param, which names what is wrong and what is legal.
%
%   params is a struct:
%     tau: prescribed settling time [s], from 1e-150 to 1e150
%     t0: start time [s], finite
%     eps: time-to-go at which the gains are held [s], >= 1e-150, < tau
%     u_max: bound of |u| [unit of u], > 0, infinity allowed
%     a: rate of stretched time [1/s], from 1e-150 to 1e150
%     k(1:1): gains of pi0 = -k_1 xi_1, finite; k(1) is k_1 [1/s]
%     m: parameter of the model, finite

% Prescribed-time controller ptc_rational_inputs4: outputs of order 1, 1, 1, 1, mapping rational.
%
% DO NOT EDIT. Made by:
%   ptc-codegen emit --lang matlab --mu rational --name ptc_rational_inputs4 --states="p, q, r, s" --inputs=a,b,c,d --outputs="p, q, r, s" --dynamics="sin(q)*b + 3*c + r*d, 2*a + p*b + m*d + p*r, r*a + (3 + q^2)*b + s*c, a - p*c + 4*d" --allow=zeros
% Version 0.1.0, design d53160516d12.
%
% Plant, with the inputs a, b, c, d: p' = sin(q)*b + 3*c + r*d, q' = 2*a + p*b + m*d + p*r,
%       r' = r*a + (3 + q^2)*b + s*c, s' = a - p*c + 4*d, output 1 = p, output 2 = q, output
%       3 = r, output 4 = s. Time in s.
% Goal: every output with its derivatives is 0 at the deadline t0 + tau from any state at t0,
%       up to the error that the hold at eps, sampling, what differs from the model and
%       clipping leave. The checks below say what is known of this design.
% The law takes the plant to be the model. What differs from it is not part of the law.
% Outputs: 4, each with a law of its own, with this deadline and mapping; u_max is of the
%       input of this number.
%
% SAMPLE PERIOD NOT GIVEN: the gain held at eps limits the sample period for which the loop
%       is stable. Run the emitted step with a model of the plant, sampled.
%
% Parameters:
%   tau: prescribed settling time [s], from 1e-150 to 1e150
%   t0: start time [s], finite
%   eps: time-to-go at which the gains are held [s], >= 1e-150, < tau
%   u_max: bound of |u| [unit of u], > 0, infinity allowed
%   a: rate of stretched time [1/s], from 1e-150 to 1e150
%   k: gains of pi0 = -k_1 xi_1, finite; k(1) is k_1 [1/s]
%   m: parameter of the model, finite
%
% Time mapping, with time-to-go T = t0 + tau - t and elapsed time Dt = t - t0; t in mu(t) is
%       the stretched time since t0:
%   mu(t)     = tau*a*t/(1 + a*t)
%   kappa(Dt) = Dt/(a*T)
% Derivatives r_k = mu^(k)(kappa(Dt)):
%   r_k = (-1)^(k-1) k! (a/tau)^k T^(k+1)
%   r_1 = tau^-1*a*T^2
% Matrix BB_n, entry (i,j) = B_{i-1,j-1}(r_1, ...), and its next row b_n; zeros are left out:
%   B_{0,0} = 1
%
% Law of each output, Theorem 1, with xi = BB_n x and t_kappa = kappa(Dt) + t0:
%   v_i = kappa'^n (pi0(xi, t_kappa) - b_n^T x) = sum_j gain_j x_j
%   pi0 = -k_1 xi_1
%   gain_j = inv_T_squared^(n+1-j) row_j
%   K1, K2, ...: K_i = k_i/(tau^-1*a)^(n+1-i)
%   row_1 = -K1
%   inv_T_squared = 1/T^2
% Output 1, of order n = 1:
%   x_1 = p
% Output 2, of order n = 1:
%   x_1 = q
%   f_2 = p*r
% Output 3, of order n = 1:
%   x_1 = r
% Output 4, of order n = 1:
%   x_1 = s
% u of D u = w with w_i = v_i - f_i, by elimination with pivots:
%   D = [[0, sin(q), 3, r], [2, p, 0, m], [r, 3 + q^2, s, 0], [1, 0, -p, 4]]
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
%   membership: sound: rational is of class M for all its parameters.
%   growth: not checked: the gains are left to run time: their poles must lie left of -n rho.
%   sampling: not checked: `sample_time` is not given.
%   deadline: not checked: `error` is not given.
%   loop: not checked: it needs a value of `tau`.
%   envelope: not checked: `x_max` is not given.
%   zeros: sound: none: the relative degrees are 1, 1, 1, 1, whose sum is the number of
%       states.
%
% Operations of one step, without input checks and clipping: 38 additions or comparisons, 33
%       multiplications, 14 divisions, 1 function call.

given.tau = double(params.tau);
given.t0 = double(params.t0);
given.eps = double(params.eps);
given.u_max = double(params.u_max);
given.a = double(params.a);
given.k = double(params.k);
if numel(params.k) ~= 1
    error('ptc_rational_inputs4:param', 'params.k has %d numbers; legal: 1', numel(params.k));
end
given.m = double(params.m);
tau = given.tau;
t0 = given.t0;
eps = given.eps;
u_max = given.u_max;
a = given.a;
k1 = given.k(1);
p_m = given.m;
if ~(isfinite(tau) && (1e-150 <= tau) && (tau <= 1e150))
    error('ptc_rational_inputs4:param', 'params.tau is %g; legal: from 1e-150 to 1e150', params.tau);
end
if ~isfinite(t0)
    error('ptc_rational_inputs4:param', 'params.t0 is %g; legal: finite', params.t0);
end
if ~(eps >= 1e-150)
    error('ptc_rational_inputs4:param', 'params.eps is %g; legal: >= 1e-150', params.eps);
end
if ~(u_max > 0.0)
    error('ptc_rational_inputs4:param', 'params.u_max is %g; legal: > 0', params.u_max);
end
if ~(isfinite(a) && (1e-150 <= a) && (a <= 1e150))
    error('ptc_rational_inputs4:param', 'params.a is %g; legal: from 1e-150 to 1e150', params.a);
end
if ~isfinite(k1)
    error('ptc_rational_inputs4:param', 'params.k(1) is %g; legal: finite', params.k(1));
end
if ~isfinite(p_m)
    error('ptc_rational_inputs4:param', 'params.m is %g; legal: finite', params.m);
end
if ~(eps < tau)
    error('ptc_rational_inputs4:param', 'params.eps is %g; legal: < tau', params.eps);
end
rate_axis1 = a / tau;
K1_axis1 = k1 / rate_axis1;
c1_axis1 = -K1_axis1;
hold_from = -eps;
size_K1_axis1 = pick(abs(k1) <= 0.0, 1e-200, abs(K1_axis1));
size_p_m = pick(abs(p_m) <= 0.0, 1e-200, abs(p_m));
if ~((size_K1_axis1 >= 1e-200) && (size_p_m >= 1e-200) && isfinite(c1_axis1) && isfinite(hold_from))
    error('ptc_rational_inputs4:param', 'the coefficients leave the range of numbers: take gains, rates and sample periods nearer to 1');
end
self.tau = tau;
self.c1_axis1 = c1_axis1;
self.eps = eps;
self.hold_from = hold_from;
self.p_m = p_m;
self.u_max = u_max;
self.t0 = 0.0;
self.deadline = 0.0;
self.correction = 0.0;
self = ptc_rational_inputs4_arm(self, t0);
end

function r = pick(condition, yes, no)
if condition
    r = yes;
else
    r = no;
end
end
