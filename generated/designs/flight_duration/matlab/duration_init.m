function self = duration_init(params) %#codegen
%DURATION_INIT Takes the parameters and arms at params.t0 (or the fixed t0) for params.tau.
%
%   self = duration_init(params) is the controller, for the functions that stand beside this one. A
%   parameter outside its domain, or coefficients that leave the range of numbers, raise an error
%   duration:param, which names what is wrong and what is legal.
%
%   params is a struct:
%     tau: prescribed settling time [s], from 1e-18 to 1e18
%     t0: start time [s], finite
%     eps: time-to-go at which the gains are held [s], >= 1e-18, < tau
%     a: rate of stretched time [1/s], from 1e-18 to 1e18

% Prescribed-time controller duration: order n = 3, mapping tan.
%
% DO NOT EDIT. Made by:
%   ptc-codegen emit --lang matlab --n 3 --mu tan --name duration --in-flight --precision f32 --u-max=100 --poles=-4,-5,-6
% Version 0.1.0, design 3d20bda1c4e1.
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
%   u_max = 100 [unit of u], fixed: bound of |u|
%   k_1 = 120 [1/s^3], fixed: gain of xi_1
%   k_2 = 74 [1/s^2], fixed: gain of xi_2
%   k_3 = 15 [1/s], fixed: gain of xi_3
%   tau: prescribed settling time [s], from 1e-18 to 1e18
%   t0: start time [s], finite
%   eps: time-to-go at which the gains are held [s], >= 1e-18, < tau
%   a: rate of stretched time [1/s], from 1e-18 to 1e18
%
% Time mapping, with time-to-go T = t0 + tau - t and elapsed time Dt = t - t0; t in mu(t) is
%       the stretched time since t0:
%   mu(t)     = (2*tau/pi)*atan(a*t)
%   kappa(Dt) = cot(th)/a, th = pi*T/(2*tau)
%   in terms of y = cot(th), V = 1/(1 + y^2)
% Derivatives r_k = mu^(k)(kappa(Dt)):
%   r_k = (-1)^(k-1) (k-1)! (2*tau/pi) a^k sin(k*th) sin(th)^k
%   r_1 = 2*pi^-1*tau*a*V
%   r_2 = -4*pi^-1*tau*a^2*y*V^2
%   r_3 = 12*pi^-1*tau*a^3*y^2*V^3 - 4*pi^-1*tau*a^3*V^3
% Matrix BB_n, entry (i,j) = B_{i-1,j-1}(r_1, ...), and its next row b_n; zeros are left out:
%   B_{0,0} = 1
%   B_{1,1} = 2*pi^-1*tau*a*V
%   B_{2,1} = -4*pi^-1*tau*a^2*y*V^2
%   B_{2,2} = 4*pi^-2*tau^2*a^2*V^2
%   B_{3,1} = 12*pi^-1*tau*a^3*y^2*V^3 - 4*pi^-1*tau*a^3*V^3
%   B_{3,2} = -24*pi^-2*tau^2*a^3*y*V^3
%
% Law, Theorem 1, with xi = BB_n x and t_kappa = kappa(Dt) + t0:
%   u = kappa'^n (pi0(xi, t_kappa) - b_n^T x)
%   pi0 = -(k_1 xi_1 + ... + k_3 xi_3)
%   u = sum_j gain_j x_j
%   gain_j = row_j
%   K1, K2, ...: K_i = k_i/a^(n+1-i)
%   row_1 = -K1*slope^3
%   row_2 = -4*pi^-2*tau^2*K2*cot_rate^4 + 4*pi^-1*tau*K3*cot_rate^3 + pi*tau^-1*K3*cot_rate
%       + 1/2*pi^2*tau^-2 - 1/4*pi^2*tau^-2*K2 - 2*K2*cot_rate^2 - 6*cot_rate^2
%   row_3 = -2*pi^-1*tau*K3*cot_rate^2 - 1/2*pi*tau^-1*K3 + 6*cot_rate
%   cot_rate = (pi/(2*tau))*y = (pi/(2*tau))*cot(th)
%   slope = (pi/(2*tau))*(1 + y^2) = kappa'/a
%
% From t0 + tau - eps on, and after the deadline, the gains of T = eps are held (status HOLD).
% In flight: arm_for starts again at t0 for another tau, at any time, and computes what
%       follows from tau. arm keeps the tau last used: at first that of the parameters.
% |u| <= u_max: u is clipped to it (status SATURATED). Prolonged saturation voids the
%       deadline.
% Guard full: t and x are finite and t >= t0, or the call is refused (INPUT).
% Precision f32 (IEEE 754 binary32). Results are bit for bit the same on every IEEE 754
%       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
%
% Checks of the design (details: ptc-codegen check):
%   membership: sound: tan is of class M for all its parameters.
%   growth: sound: x and u go to 0 at the deadline.
%   sampling: not checked: `sample_time` is not given.
%   deadline: not checked: `error` is not given.
%   loop: not checked: it needs a value of `tau`.
%   envelope: not checked: `x_max` is not given.
%
% Operations of one step, without input checks and clipping: 21 additions or comparisons, 28
%       multiplications, 1 division.

given.tau = single(params.tau);
given.t0 = single(params.t0);
given.eps = single(params.eps);
given.a = single(params.a);
tau = given.tau;
t0 = given.t0;
eps = given.eps;
a = given.a;
if ~(isfinite(tau) ...
    && (single(1.000000045813705e-18) <= tau) ...
    && (tau <= single(9.999999843067494e17)))
    error('duration:param', 'params.tau is %g; legal: from 1.000000045813705e-18 to 9.999999843067494e17', params.tau);
end
if ~isfinite(t0)
    error('duration:param', 'params.t0 is %g; legal: finite', params.t0);
end
if ~(eps >= single(1.000000045813705e-18))
    error('duration:param', 'params.eps is %g; legal: >= 1.000000045813705e-18', params.eps);
end
if ~(isfinite(a) && (single(1.000000045813705e-18) <= a) && (a <= single(9.999999843067494e17)))
    error('duration:param', 'params.a is %g; legal: from 1.000000045813705e-18 to 9.999999843067494e17', params.a);
end
if ~(eps < tau)
    error('duration:param', 'params.eps is %g; legal: < tau', params.eps);
end
v1 = a * a;
v2 = a * v1;
K1 = single(120.0) / v2;
K2 = single(74.0) / v1;
K3 = single(15.0) / a;
c1_3 = -K1;
hold_from = -eps;
c2_2 = (-(single(2.0) * K2)) - single(6.0);
f69 = (-(single(2.4674010276794434) * K2)) + single(4.934802055358887);
f73 = single(3.1415927410125732) * K3;
f81 = single(1.2732394933700562) * K3;
f85 = -(single(0.40528473258018494) * K2);
f99 = -(single(1.5707963705062866) * K3);
f103 = -(single(0.6366197466850281) * K3);
if ~((v2 >= single(1.0000000031710769e-30)) ...
    && (K1 >= single(1.0000000031710769e-30)) ...
    && isfinite(c1_3) ...
    && isfinite(hold_from) ...
    && isfinite(f69) ...
    && isfinite(f73) ...
    && isfinite(c2_2) ...
    && isfinite(f81) ...
    && isfinite(f85) ...
    && isfinite(f99) ...
    && isfinite(f103))
    error('duration:param', 'the coefficients leave the range of numbers: take gains, rates and sample periods nearer to 1');
end
self.c1_3 = c1_3;
self.eps = eps;
self.hold_from = hold_from;
self.f69 = f69;
self.f73 = f73;
self.c2_2 = c2_2;
self.f81 = f81;
self.f85 = f85;
self.f99 = f99;
self.f103 = f103;
self.tau = single(0.0);
self.angle_rate = single(0.0);
self.inv_angle_rate = single(0.0);
self.t0 = single(0.0);
self.deadline = single(0.0);
self.correction = single(0.0);
self.inv_tau = single(0.0);
self.c2_0 = single(0.0);
self.c2_1 = single(0.0);
self.c2_3 = single(0.0);
self.c2_4 = single(0.0);
self.c3_0 = single(0.0);
self.c3_2 = single(0.0);
self = duration_arm_for(self, t0, tau);
end
