function self = mix_init(params) %#codegen
%MIX_INIT Takes the parameters and arms at params.t0 (or the fixed t0).
%
%   self = mix_init(params) is the controller, for the functions that stand beside this one. A
%   parameter outside its domain, or coefficients that leave the range of numbers, raise an error
%   mix:param, which names what is wrong and what is legal.
%
%   params is a struct:
%     tau: prescribed settling time [s], from 1e-150 to 1e150
%     t0: start time [s], finite
%     eps: time-to-go at which the gains are held [s], >= 1e-150, < tau
%     u_max: bound of |u| [unit of u], > 0, infinity allowed

% Prescribed-time controller mix: outputs of order 2, 1, mapping exp.
%
% DO NOT EDIT. Made by:
%   ptc-codegen emit --lang matlab --mu "exp(a=1)" --name mix --poles="[[-4,-5],[-3]]" --states="p, v, h" --inputs=a,b --outputs="p, h" --dynamics="v, -v + (2 + sin(p))*a + h*b, v*h + h*a + (2 + h^2)*b"
% Version 0.1.0, design 096280cbf9e2.
%
% Plant, with the inputs a, b: p' = v, v' = -v + (2 + sin(p))*a + h*b, h' = v*h + h*a + (2 +
%       h^2)*b, output 1 = p, output 2 = h. Time in s.
% Goal: every output with its derivatives is 0 at the deadline t0 + tau from any state at t0,
%       up to the error that the hold at eps, sampling, what differs from the model and
%       clipping leave. The checks below say what is known of this design.
% The law takes the plant to be the model. What differs from it is not part of the law.
% Outputs: 2, each with a law of its own, with this deadline and mapping; u_max is of the
%       input of this number.
%   output 1: k = 20, 9
%   output 2: k = 3
%
% SAMPLE PERIOD NOT GIVEN: the gain held at eps limits the sample period for which the loop
%       is stable. Run the emitted step with a model of the plant, sampled.
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
%   r_2 = -a^2*T
% Matrix BB_n, entry (i,j) = B_{i-1,j-1}(r_1, ...), and its next row b_n; zeros are left out:
%   B_{0,0} = 1
%   B_{1,1} = a*T
%   B_{2,1} = -a^2*T
%
% Law of each output, Theorem 1, with xi = BB_n x and t_kappa = kappa(Dt) + t0:
%   v_i = kappa'^n (pi0(xi, t_kappa) - b_n^T x) = sum_j gain_j x_j
% Order n = 1:
%   pi0 = -k_1 xi_1
%   gain_j = inv_T^(n+1-j) row_j
%   K1, K2, ...: K_i = k_i/a^(n+1-i)
%   row_1 = -K1
%   inv_T = 1/T
% Order n = 2:
%   pi0 = -(k_1 xi_1 + k_2 xi_2)
%   gain_j = inv_T^(n+1-j) row_j
%   K1, K2, ...: K_i = k_i/a^(n+1-i)
%   row_1 = -K1
%   row_2 = 1 - K2
%   inv_T = 1/T
% Output 1, of order n = 2:
%   x_1 = p
%   x_2 = v
%   f_1 = -v
% Output 2, of order n = 1:
%   x_1 = h
%   f_2 = v*h
% u = adj(D) w/det(D) with w_i = v_i - f_i:
%   det(D) = (2 + sin(p))*(2 + h^2) - h*h
%   adj(D) = [[2 + h^2, -h], [-h, 2 + sin(p)]]
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
%   membership: sound: exp is of class M for all its parameters.
%   growth: sound: x and u go to 0 at the deadline.
%   sampling: not checked: `sample_time` is not given.
%   deadline: not checked: `error` is not given.
%   loop: not checked: it needs a value of `tau`.
%   envelope: not checked: `x_max` is not given.
%   zeros: sound: none: the relative degrees are 2, 1, whose sum is the number of states.
%
% Operations of one step, without input checks and clipping: 13 additions or comparisons, 15
%       multiplications, 2 divisions, 1 function call.

given.tau = double(params.tau);
given.t0 = double(params.t0);
given.eps = double(params.eps);
given.u_max = double(params.u_max);
tau = given.tau;
t0 = given.t0;
eps = given.eps;
u_max = given.u_max;
if ~(isfinite(tau) && (1e-150 <= tau) && (tau <= 1e150))
    error('mix:param', 'params.tau is %g; legal: from 1e-150 to 1e150', params.tau);
end
if ~isfinite(t0)
    error('mix:param', 'params.t0 is %g; legal: finite', params.t0);
end
if ~(eps >= 1e-150)
    error('mix:param', 'params.eps is %g; legal: >= 1e-150', params.eps);
end
if ~(u_max > 0.0)
    error('mix:param', 'params.u_max is %g; legal: > 0', params.u_max);
end
if ~(eps < tau)
    error('mix:param', 'params.eps is %g; legal: < tau', params.eps);
end
hold_from = -eps;
if ~isfinite(hold_from)
    error('mix:param', 'the coefficients leave the range of numbers: take gains, rates and sample periods nearer to 1');
end
self.tau = tau;
self.eps = eps;
self.hold_from = hold_from;
self.u_max = u_max;
self.t0 = 0.0;
self.deadline = 0.0;
self.correction = 0.0;
self = mix_arm(self, t0);
end
