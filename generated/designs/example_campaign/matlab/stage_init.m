function self = stage_init(params) %#codegen
%STAGE_INIT Takes the parameters and arms at params.t0 (or the fixed t0).
%
%   self = stage_init(params) is the controller, for the functions that stand beside this one. A
%   parameter outside its domain, or coefficients that leave the range of numbers, raise an error
%   stage:param, which names what is wrong and what is legal.
%
%   params is a struct:
%     tau: prescribed settling time [s], from 1e-150 to 1e150
%     t0: start time [s], finite
%     eps: time-to-go at which the gains are held [s], >= 1e-150, < tau
%     u_max: bound of |u| [unit of u], > 0, infinity allowed

% Prescribed-time controller stage: order n = 3, mapping exp.
%
% DO NOT EDIT. Made by:
%   ptc-codegen emit --lang matlab --n 3 --mu "exp(a=1)" --name stage --poles=-4,-5,-6
% Version 0.1.0, design ea927afcd2d5.
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
%   a = 1 [1/s], fixed: rate of stretched time
%   k_1 = 120 [1/s^3], fixed: gain of xi_1
%   k_2 = 74 [1/s^2], fixed: gain of xi_2
%   k_3 = 15 [1/s], fixed: gain of xi_3
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
% Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
%       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
%
% Checks of the design (details: ptc-codegen check):
%   membership: sound: exp is of class M for all its parameters.
%   growth: sound: x and u go to 0 at the deadline.
%   sampling: not checked: `sample_time` is not given.
%   deadline: not checked: `error` is not given.
%   loop: not checked: it needs a value of `tau`.
%   envelope: not checked: `x_max` is not given.
%
% Operations of one step, without input checks and clipping: 5 additions or comparisons, 6
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
    error('stage:param', 'params.tau is %g; legal: from 1e-150 to 1e150', params.tau);
end
if ~isfinite(t0)
    error('stage:param', 'params.t0 is %g; legal: finite', params.t0);
end
if ~(eps >= 1e-150)
    error('stage:param', 'params.eps is %g; legal: >= 1e-150', params.eps);
end
if ~(u_max > 0.0)
    error('stage:param', 'params.u_max is %g; legal: > 0', params.u_max);
end
if ~(eps < tau)
    error('stage:param', 'params.eps is %g; legal: < tau', params.eps);
end
hold_from = -eps;
if ~isfinite(hold_from)
    error('stage:param', 'the coefficients leave the range of numbers: take gains, rates and sample periods nearer to 1');
end
self.tau = tau;
self.eps = eps;
self.hold_from = hold_from;
self.u_max = u_max;
self.t0 = 0.0;
self.deadline = 0.0;
self.correction = 0.0;
self = stage_arm(self, t0);
end
