/*
 * Prescribed-time controller pendulum: order n = 2, mapping exp.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 2 --mu "exp(a=1)" --name pendulum --tau=0.8 --eps=6.00e-3 --u-max=25 --poles=-3,-4 --states="q, w" --input=M --output="q" --dynamics="w, (M - drag*w)/(m*l^2) - grav/l*sin(q)" --param drag=0.02 --param grav=9.81 --param l=0.5 --param m=1 --sample-time=1e-3 --noise=1e-4,1e-3
 * Version 0.1.0, design d3c8a839e63d.
 *
 * Plant, with the input M: q' = w, w' = (M - drag*w)/(m*l^2) - grav/l*sin(q), output q. Time
 *       in s.
 * Goal: the output and its rate, x, are 0 at the deadline t0 + tau from any state at t0, up
 *       to the error that the hold at eps, sampling, what differs from the model and clipping
 *       leave. The checks below say what is known of this design.
 * The law takes the plant to be the model. What differs from it is not part of the law.
 *
 * Parameters:
 *   tau = 0.8 [s], fixed: prescribed settling time
 *   eps = 6.00e-3 [s], fixed: time-to-go at which the gains are held
 *   u_max = 25 [unit of u], fixed: bound of |u|
 *   a = 1 [1/s], fixed: rate of stretched time
 *   k_1 = 12 [1/s^2], fixed: gain of xi_1
 *   k_2 = 7 [1/s], fixed: gain of xi_2
 *   drag = 0.02, fixed: parameter of the model
 *   grav = 9.81, fixed: parameter of the model
 *   l = 0.5, fixed: parameter of the model
 *   m = 1, fixed: parameter of the model
 *   t0: start time [s], finite
 *
 * Time mapping, with time-to-go T = t0 + tau - t and elapsed time Dt = t - t0; t in mu(t) is
 *       the stretched time since t0:
 *   mu(t)     = tau*(1 - exp(-a*t))
 *   kappa(Dt) = -ln(T/tau)/a
 * Derivatives r_k = mu^(k)(kappa(Dt)):
 *   r_k = (-1)^(k-1) a^k T
 *   r_1 = a*T
 *   r_2 = -a^2*T
 * Matrix BB_n, entry (i,j) = B_{i-1,j-1}(r_1, ...), and its next row b_n; zeros are left out:
 *   B_{0,0} = 1
 *   B_{1,1} = a*T
 *   B_{2,1} = -a^2*T
 *
 * Law, Theorem 1, with xi = BB_n x and t_kappa = kappa(Dt) + t0:
 *   u = (kappa'^n (pi0(xi, t_kappa) - b_n^T x) - f)/g
 *   pi0 = -(k_1 xi_1 + k_2 xi_2)
 *   x_1 = q
 *   x_2 = w
 *   f = -(drag*w)/(m*l^2) - grav/l*sin(q)
 *   g = 1/(l^2*m)
 *   u = (sum_j gain_j x_j - f)/g
 *   gain_j = inv_T^(n+1-j) row_j
 *   K1, K2, ...: K_i = k_i/a^(n+1-i)
 *   row_1 = -K1
 *   row_2 = 1 - K2
 *   inv_T = 1/T
 *
 * From t0 + tau - eps on, and after the deadline, the gains of T = eps are held (status HOLD).
 * |u| <= u_max: u is clipped to it (status SATURATED). Prolonged saturation voids the
 *       deadline.
 * Guard full: t and x are finite, t >= t0 and no pointer is NULL, or the call is refused
 *       (status E_INPUT).
 * Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
 *       machine without fused multiply-add (gcc, clang: -ffp-contract=off) and with the same
 *       mathematical library.
 *
 * Checks of the design (details: ptc-codegen check):
 *   membership: sound: exp is of class M for all its parameters.
 *   growth: sound: x and u go to 0 at the deadline.
 *   sampling: undecided: f is cancelled at the samples alone; with f = 0: eps = 0.006 s is 2
 *       times the minimum for a period of 0.001 s.
 *   deadline: not checked: `error` is not given.
 *   loop: not checked: `x0_max` is not given.
 *   envelope: not checked: `x_max` is not given.
 *   zeros: sound: none: the relative degree is 2, the number of states.
 *
 * Operations of one step, without input checks and clipping: 6 additions or comparisons, 6
 *       multiplications, 1 division, 1 function call.
 */
#ifndef PENDULUM_E5E92FEF_H
#define PENDULUM_E5E92FEF_H

#ifdef __cplusplus
extern "C" {
#endif

#ifndef PTC_STATUS_DEFINED
#define PTC_STATUS_DEFINED
/* Outcome of a call; a negative one leaves *u = 0. */
typedef enum ptc_status {
    PTC_OK = 0, /* tracking */
    PTC_HOLD = 1, /* time-to-go held at eps: the deadline is near or over, u is valid */
    PTC_SATURATED = 2, /* u clipped to its limits; wins over PTC_HOLD and PTC_AFTER */
    PTC_AFTER = 3, /* the deadline is over: u is 0 or that of the user-defined law */
    PTC_GATED = 4, /* a reading was not believed: u by prediction alone; wins over all above */
    PTC_LATE = 5, /* the deadline was put off, as a limit would have been exceeded: u is valid */
    PTC_INFEASIBLE = 6, /* nothing is known from here that keeps all limits or bounds: u is valid */
    PTC_E_PARAM = -1, /* a parameter outside its domain, or coefficients outside the range */
    PTC_E_INPUT = -2, /* x or t not finite, t before t0, or a NULL pointer */
    PTC_E_RANGE = -3, /* u not finite */
    PTC_E_SOON = -4 /* a deadline too soon for the limits, or none that keeps them */
} ptc_status;
#endif

/* Run-time parameters. */
typedef struct pendulum_params {
    double t0; /* start time [s], finite */
} pendulum_params;

/* Controller: set by init, changed by arm and by what takes it without const. */
typedef struct pendulum {
    double t0; /* start time */
    double deadline; /* t0 + tau, rounded */
    double correction; /* low part of t0 + tau (compensated sum) */
} pendulum;

/*
 * Takes the parameters and arms at params.t0 (or the fixed t0). PTC_OK, or PTC_E_PARAM with *self
 * untouched.
 */
ptc_status pendulum_init(pendulum *self, const pendulum_params *params);

/* Starts again at t0 [s]. PTC_OK, or PTC_E_PARAM with *self untouched. */
ptc_status pendulum_arm(pendulum *self, double t0);

/*
 * u at time t [s] and state x = (q, w). On a negative status u is 0 and nothing has changed. u must
 * not overlap x.
 */
ptc_status pendulum_step(const pendulum *self, double t, const double x[2], double *u);

#ifdef __cplusplus
}
#endif

#endif
