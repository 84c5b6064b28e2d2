/*
 * Prescribed-time controller drive: order n = 3, mapping exp.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 3 --mu "exp(a=1)" --name drive --tau=0.4 --u-max=24 --poles=-4,-5,-6 --states="q, w, i" --input=V --output="q" --dynamics="w, (k*i - b*w)/J, (V - R*i - k*w)/L" --param J=2e-5 --param L=2e-3 --param R=1.2 --param b=1e-5 --param k=0.03
 * Version 0.1.0, design c35b1c6c3590.
 *
 * Plant, with the input V: q' = w, w' = (k*i - b*w)/J, i' = (V - R*i - k*w)/L, output q. Time
 *       in s.
 * Goal: the output and its first 2 derivatives, x, are 0 at the deadline t0 + tau from any
 *       state at t0, up to the error that the hold at eps, sampling, what differs from the
 *       model and clipping leave. The checks below say what is known of this design.
 * The law takes the plant to be the model. What differs from it is not part of the law.
 *
 * SAMPLE PERIOD NOT GIVEN: the held gains grow as eps falls, and the loop is stable only for
 *       sample periods below a limit that depends on eps and the gains. ptc-codegen check
 *       finds it once tau, eps, the gains and --sample-time are given.
 *
 * Parameters:
 *   tau = 0.4 [s], fixed: prescribed settling time
 *   u_max = 24 [unit of u], fixed: bound of |u|
 *   a = 1 [1/s], fixed: rate of stretched time
 *   k_1 = 120 [1/s^3], fixed: gain of xi_1
 *   k_2 = 74 [1/s^2], fixed: gain of xi_2
 *   k_3 = 15 [1/s], fixed: gain of xi_3
 *   J = 2e-5, fixed: parameter of the model
 *   L = 2e-3, fixed: parameter of the model
 *   R = 1.2, fixed: parameter of the model
 *   b = 1e-5, fixed: parameter of the model
 *   k = 0.03, fixed: parameter of the model
 *   t0: start time [s], finite
 *   eps: time-to-go at which the gains are held [s], >= 1e-150, < tau
 *
 * Time mapping, with time-to-go T = t0 + tau - t and elapsed time Dt = t - t0; t in mu(t) is
 *       the stretched time since t0:
 *   mu(t)     = tau*(1 - exp(-a*t))
 *   kappa(Dt) = -ln(T/tau)/a
 * Derivatives r_k = mu^(k)(kappa(Dt)):
 *   r_k = (-1)^(k-1) a^k T
 *   r_1 = a*T
 *   r_2 = -a^2*T
 *   r_3 = a^3*T
 * Matrix BB_n, entry (i,j) = B_{i-1,j-1}(r_1, ...), and its next row b_n; zeros are left out:
 *   B_{0,0} = 1
 *   B_{1,1} = a*T
 *   B_{2,1} = -a^2*T
 *   B_{2,2} = a^2*T^2
 *   B_{3,1} = a^3*T
 *   B_{3,2} = -3*a^3*T^2
 *
 * Law, Theorem 1, with xi = BB_n x and t_kappa = kappa(Dt) + t0:
 *   u = (kappa'^n (pi0(xi, t_kappa) - b_n^T x) - f)/g
 *   pi0 = -(k_1 xi_1 + ... + k_3 xi_3)
 *   x_1 = q
 *   x_2 = w
 *   x_3 = (k*i - b*w)/J
 *   f = (k*(-(R*i + k*w)/L) - b*((k*i - b*w)/J))/J
 *   g = k/(J*L)
 *   u = (sum_j gain_j x_j - f)/g
 *   gain_j = inv_T^(n+1-j) row_j
 *   K1, K2, ...: K_i = k_i/a^(n+1-i)
 *   row_1 = -K1
 *   row_2 = -1 - K2 + K3
 *   row_3 = 3 - K3
 *   inv_T = 1/T
 *
 * From t0 + tau - eps on, and after the deadline, the gains of T = eps are held (status HOLD).
 * |u| <= u_max: u is clipped to it (status SATURATED). Prolonged saturation voids the
 *       deadline.
 * Guard full: t and x are finite, t >= t0 and no pointer is NULL, or the call is refused
 *       (status E_INPUT).
 * Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
 *       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
 *
 * Checks of the design (details: ptc-codegen check):
 *   membership: sound: exp is of class M for all its parameters.
 *   growth: sound: x and u go to 0 at the deadline.
 *   sampling: not checked: `sample_time` is not given.
 *   deadline: not checked: `error` is not given.
 *   loop: not checked: `sample_time` is not given.
 *   envelope: not checked: `x_max` is not given.
 *   zeros: sound: none: the relative degree is 3, the number of states.
 *
 * Operations of one step, without input checks and clipping: 8 additions or comparisons, 9
 *       multiplications, 1 division.
 */
#ifndef DRIVE_8928D796_H
#define DRIVE_8928D796_H

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
typedef struct drive_params {
    double t0; /* start time [s], finite */
    double eps; /* time-to-go at which the gains are held [s], >= 1e-150, < tau */
} drive_params;

/* Controller: set by init, changed by arm and by what takes it without const. */
typedef struct drive {
    double t0; /* start time */
    double deadline; /* t0 + tau, rounded */
    double correction; /* low part of t0 + tau (compensated sum) */
    double eps; /* time-to-go at which the gains are held */
    double hold_from; /* -eps: later than this the gains are held */
} drive;

/*
 * Takes the parameters and arms at params.t0 (or the fixed t0). PTC_OK, or PTC_E_PARAM with *self
 * untouched.
 */
ptc_status drive_init(drive *self, const drive_params *params);

/* Starts again at t0 [s]. PTC_OK, or PTC_E_PARAM with *self untouched. */
ptc_status drive_arm(drive *self, double t0);

/*
 * u at time t [s] and state x = (q, w, i). On a negative status u is 0 and nothing has changed. u
 * must not overlap x.
 */
ptc_status drive_step(const drive *self, double t, const double x[3], double *u);

#ifdef __cplusplus
}
#endif

#endif
