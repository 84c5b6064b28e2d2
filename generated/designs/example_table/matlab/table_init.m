function self = table_init(params) %#codegen
%TABLE_INIT Takes the parameters and arms at params.t0 (or the fixed t0).
%
%   self = table_init(params) is the controller, for the functions that stand beside this one. A
%   parameter outside its domain, or coefficients that leave the range of numbers, raise an error
%   table:param, which names what is wrong and what is legal.
%
%   params is a struct:
%     t0: start time [s], finite

% Prescribed-time controller table: order n = 2, mapping exp.
%
% DO NOT EDIT. Made by:
%   ptc-codegen emit --lang matlab --n 2 --mu "exp(a=1)" --name table --tau=1 --eps=4.93e-2 --u-max=0.5 --poles=-4,-5 --g="50" --sample-time=5e-3 --error=1e-3,1e-2 --x0-max=1,0.5
% Version 0.1.0, design a83bf3b80b92.
%
% Plant: x1' = x2, x2' = f + g u. Time in s, x1 in any unit U, x2 in U/s, g u in U/s^2.
% Goal: x = 0 at the deadline t0 + tau from any state at t0, up to the error that the hold at
%       eps, sampling, f and clipping leave. The checks below say what is known of this
%       design.
% f is not part of the law: cancel its known terms before the call.
%
% Parameters:
%   tau = 1 [s], fixed: prescribed settling time
%   eps = 4.93e-2 [s], fixed: time-to-go at which the gains are held
%   u_max = 0.5 [unit of u], fixed: bound of |u|
%   a = 1 [1/s], fixed: rate of stretched time
%   k_1 = 20 [1/s^2], fixed: gain of xi_1
%   k_2 = 9 [1/s], fixed: gain of xi_2
%   t0: start time [s], finite
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
% Law, Theorem 1, with xi = BB_n x and t_kappa = kappa(Dt) + t0:
%   u = kappa'^n (pi0(xi, t_kappa) - b_n^T x)/g
%   pi0 = -(k_1 xi_1 + k_2 xi_2)
%   g = 50
%   u = (sum_j gain_j x_j)/g
%   gain_j = inv_T^(n+1-j) row_j
%   K1, K2, ...: K_i = k_i/a^(n+1-i)
%   row_1 = -K1
%   row_2 = 1 - K2
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
%   sampling: sound: eps = 0.0493 s is 2.465 times the minimum for a period of 0.005 s.
%   deadline: not checked: `loop` decides; without noise and for short periods eps = 0.0493 s
%       is too early to stop: |x| <= 0.001 from 0.03613 s on.
%   loop: sound: at the deadline |x| <= 4.179e-7, 4.094e-5.
%   envelope: not checked: `x_max` is not given.
%
% Operations of one step, without input checks and clipping: 4 additions or comparisons, 5
%       multiplications, 1 division.

given.t0 = double(params.t0);
t0 = given.t0;
if ~isfinite(t0)
    error('table:param', 'params.t0 is %g; legal: finite', params.t0);
end
self.t0 = 0.0;
self.deadline = 0.0;
self.correction = 0.0;
self = table_arm(self, t0);
end
