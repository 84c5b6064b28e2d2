function self = levitation_init(params) %#codegen
%LEVITATION_INIT Takes the parameters and arms at params.t0 (or the fixed t0).
%
%   self = levitation_init(params) is the controller, for the functions that stand beside this one.
%   A parameter outside its domain, or coefficients that leave the range of numbers, raise an error
%   levitation:param, which names what is wrong and what is legal.
%
%   params is a struct:
%     tau: prescribed settling time [s], from 1e-150 to 1e150
%     t0: start time [s], finite
%     u_max: bound of |u| [unit of u], > 0, infinity allowed
%     L: parameter of the model, finite
%     R: parameter of the model, finite
%     i0: parameter of the model, from 0.1 to 5
%     z0: parameter of the model, from 5e-3 to 2e-2

% Prescribed-time controller levitation: order n = 3, mapping exp.
%
% DO NOT EDIT. Made by:
%   ptc-codegen emit --lang matlab --n 3 --mu "exp(a=1)" --name levitation --eps=1e-3 --poles=-4,-5,-6 --states="z, v, i" --input=u --output="z" --dynamics="v, grav*(1 - ((1 + i/i0)/(1 + z/z0))^2), (u - R*i)/L" --param grav=9.81 --param "i0=[0.1,5]" --param "z0=[5e-3,2e-2]" --x-max=2e-3,1,0.05
% Version 0.1.0, design 44fd77ede031.
%
% Plant, with the input u: z' = v, v' = grav*(1 - ((1 + i/i0)/(1 + z/z0))^2), i' = (u -
%       R*i)/L, output z. Time in s.
% Goal: the output and its first 2 derivatives, x, are 0 at the deadline t0 + tau from any
%       state at t0, up to the error that the hold at eps, sampling, what differs from the
%       model and clipping leave. The checks below say what is known of this design.
% The law takes the plant to be the model. What differs from it is not part of the law.
%
% SAMPLE PERIOD NOT GIVEN: the held gains grow as eps falls, and the loop is stable only for
%       sample periods below a limit that depends on eps and the gains. ptc-codegen check
%       finds it once tau, eps, the gains and --sample-time are given.
%
% Parameters:
%   eps = 1e-3 [s], fixed: time-to-go at which the gains are held
%   a = 1 [1/s], fixed: rate of stretched time
%   k_1 = 120 [1/s^3], fixed: gain of xi_1
%   k_2 = 74 [1/s^2], fixed: gain of xi_2
%   k_3 = 15 [1/s], fixed: gain of xi_3
%   grav = 9.81, fixed: parameter of the model
%   tau: prescribed settling time [s], from 1e-150 to 1e150
%   t0: start time [s], finite
%   u_max: bound of |u| [unit of u], > 0, infinity allowed
%   L: parameter of the model, finite
%   R: parameter of the model, finite
%   i0: parameter of the model, from 0.1 to 5
%   z0: parameter of the model, from 5e-3 to 2e-2
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
%   u = (kappa'^n (pi0(xi, t_kappa) - b_n^T x) - f)/g
%   pi0 = -(k_1 xi_1 + ... + k_3 xi_3)
%   x_1 = z
%   x_2 = v
%   x_3 = grav*(1 - ((1 + i/i0)/(1 + z/z0))^2)
%   f = grav*-(2*((1 + i/i0)/(1 + z/z0))*((-R*i/L/i0*(1 + z/z0) - (1 + i/i0)*(v/z0))/(1 +
%       z/z0)^2))
%   g = -2*grav*z0^2*(i0 + i)/(L*i0^2*(z0 + z)^2)
%   u = (sum_j gain_j x_j - f)/g
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
%   envelope: not checked: `tau` is left to run time without bounds.
%   zeros: sound: none: the relative degree is 3, the number of states.
%
% Operations of one step, without input checks and clipping: 14 additions or comparisons, 15
%       multiplications, 6 divisions.

given.tau = double(params.tau);
given.t0 = double(params.t0);
given.u_max = double(params.u_max);
given.L = double(params.L);
given.R = double(params.R);
given.i0 = double(params.i0);
given.z0 = double(params.z0);
tau = given.tau;
t0 = given.t0;
u_max = given.u_max;
p_L = given.L;
p_R = given.R;
p_i0 = given.i0;
p_z0 = given.z0;
if ~(isfinite(tau) && (1e-150 <= tau) && (tau <= 1e150))
    error('levitation:param', 'params.tau is %g; legal: from 1e-150 to 1e150', params.tau);
end
if ~isfinite(t0)
    error('levitation:param', 'params.t0 is %g; legal: finite', params.t0);
end
if ~(u_max > 0.0)
    error('levitation:param', 'params.u_max is %g; legal: > 0', params.u_max);
end
if ~isfinite(p_L)
    error('levitation:param', 'params.L is %g; legal: finite', params.L);
end
if ~isfinite(p_R)
    error('levitation:param', 'params.R is %g; legal: finite', params.R);
end
if ~((0.1 <= p_i0) && (p_i0 <= 5.0))
    error('levitation:param', 'params.i0 is %g; legal: from 0.1 to 5', params.i0);
end
if ~((0.005 <= p_z0) && (p_z0 <= 0.02))
    error('levitation:param', 'params.z0 is %g; legal: from 0.005 to 0.02', params.z0);
end
if ~(tau > 0.001)
    error('levitation:param', 'params.tau is %g; legal: > 0.001', params.tau);
end
f42 = p_L * (p_i0 * p_i0);
f53 = -p_L;
size_f42 = pick(abs(p_L) <= 0.0, 1e-200, abs(f42));
size_f53 = pick(abs(p_L) <= 0.0, 1e-200, abs(f53));
size_p_R = pick(abs(p_R) <= 0.0, 1e-200, abs(p_R));
f49 = (-19.62) * (p_z0 * p_z0);
f56 = p_R * p_z0;
f61 = f53 * p_i0;
if ~((size_f42 >= 1e-200) ...
    && (size_f53 >= 1e-200) ...
    && (size_p_R >= 1e-200) ...
    && isfinite(f42) ...
    && isfinite(f49) ...
    && isfinite(f53) ...
    && isfinite(f56) ...
    && isfinite(f61))
    error('levitation:param', 'the coefficients leave the range of numbers: take gains, rates and sample periods nearer to 1');
end
self.tau = tau;
self.p_i0 = p_i0;
self.p_z0 = p_z0;
self.f42 = f42;
self.f49 = f49;
self.f53 = f53;
self.p_R = p_R;
self.f56 = f56;
self.f61 = f61;
self.u_max = u_max;
self.t0 = 0.0;
self.deadline = 0.0;
self.correction = 0.0;
self = levitation_arm(self, t0);
end

function r = pick(condition, yes, no)
if condition
    r = yes;
else
    r = no;
end
end
