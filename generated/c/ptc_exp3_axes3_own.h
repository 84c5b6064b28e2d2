/*
 * Prescribed-time controller ptc_exp3_axes3_own: order n = 3, mapping exp.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 3 --axes 3 --mu "exp(a=1)" --name ptc_exp3_axes3_own --limits=40,40,15 --poles="[[-4,-5,-6],[-4,-5,-6],[-6,-7,-8]]" --g="[1/m, 1/m, 2]"
 * Version 0.1.0, design 9566731ebf83.
 *
 * Plant: x1' = x2, ..., x3' = f + g u. Time in s, x1 in any unit U, x2 in U/s, x3 in U/s^2, g
 *       u in U/s^3.
 * Goal: x = 0 at the deadline t0 + tau from any state at t0, up to the error that the hold at
 *       eps, sampling, f and clipping leave. The checks below say what is known of this
 *       design.
 * f is not part of the law: cancel its known terms before the call.
 * Axes: 3, each a chain of its own with this deadline and mapping. step computes what depends
 *       on time once.
 *   axis 1: k = 120, 74, 15; u_max = 40; g = 1/m
 *   axis 2: k = 120, 74, 15; u_max = 40; g = 1/m
 *   axis 3: k = 336, 146, 21; u_max = 15; g = 2
 *
 * SAMPLE PERIOD NOT GIVEN: the held gains grow as eps falls, and the loop is stable only for
 *       sample periods below a limit that depends on eps and the gains. ptc-codegen check
 *       finds it once tau, eps, the gains and --sample-time are given.
 *
 * Parameters:
 *   a = 1 [1/s], fixed: rate of stretched time
 *   tau: prescribed settling time [s], from 1e-150 to 1e150
 *   t0: start time [s], finite
 *   eps: time-to-go at which the gains are held [s], >= 1e-150, < tau
 *   m: parameter of g, finite
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
 *   u = kappa'^n (pi0(xi, t_kappa) - b_n^T x)/g
 *   pi0 = -(k_1 xi_1 + ... + k_3 xi_3)
 *   u = (sum_j gain_j x_j)/g
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
 *   loop: not checked: it needs a value of `tau`.
 *   envelope: not checked: `x_max` is not given.
 *
 * Operations of one step, without input checks and clipping: 9 additions or comparisons, 20
 *       multiplications, 4 divisions.
 */
#ifndef PTC_EXP3_AXES3_OWN_A4F5F4B7_H
#define PTC_EXP3_AXES3_OWN_A4F5F4B7_H

#include <stdint.h>

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
typedef struct ptc_exp3_axes3_own_params {
    double tau; /* prescribed settling time [s], from 1e-150 to 1e150 */
    double t0; /* start time [s], finite */
    double eps; /* time-to-go at which the gains are held [s], >= 1e-150, < tau */
    double m; /* parameter of g, finite */
} ptc_exp3_axes3_own_params;

/* Controller: set by init, changed by arm and by what takes it without const. */
typedef struct ptc_exp3_axes3_own {
    double t0; /* start time */
    double tau; /* prescribed settling time */
    double deadline; /* t0 + tau, rounded */
    double correction; /* low part of t0 + tau (compensated sum) */
    double eps; /* time-to-go at which the gains are held */
    double hold_from; /* -eps: later than this the gains are held */
    double input_gain; /* g(x, t) */
} ptc_exp3_axes3_own;

/* Feedback gains at one time. */
typedef struct ptc_exp3_axes3_own_gains {
    double gain[9]; /* u input_gain = gain[3*axis] x[0] + ... + gain[3*axis + 2] x[2] */
    double input_gain[3]; /* g */
    double u_max[3]; /* bound of |u| of each axis */
    ptc_status status; /* PTC_OK or PTC_HOLD */
} ptc_exp3_axes3_own_gains;

/*
 * Takes the parameters and arms at params.t0 (or the fixed t0). PTC_OK, or PTC_E_PARAM with *self
 * untouched.
 */
ptc_status ptc_exp3_axes3_own_init(
    ptc_exp3_axes3_own *self,
    const ptc_exp3_axes3_own_params *params);

/* Starts again at t0 [s]. PTC_OK, or PTC_E_PARAM with *self untouched. */
ptc_status ptc_exp3_axes3_own_arm(ptc_exp3_axes3_own *self, double t0);

/*
 * The gains at time t [s] for all axes, from which step computes u of each. On a negative status
 * *gains is unchanged.
 */
ptc_status ptc_exp3_axes3_own_tick(
    const ptc_exp3_axes3_own *self,
    double t,
    ptc_exp3_axes3_own_gains *gains);

/*
 * u of one axis from its state x = (x1, x1', ...) and the gains. On a negative status u is 0 and
 * nothing has changed. u must not overlap x.
 */
ptc_status ptc_exp3_axes3_own_axis(
    const ptc_exp3_axes3_own_gains *gains,
    uint32_t axis,
    const double x[3],
    double *u);

/*
 * u of 3 axes at time t [s], from the state x = (x1, x1', ...) of each. Its status is that of the
 * first axis that fails, and then every u is 0; else SATURATED where an axis is. u and axes must
 * not overlap x.
 */
ptc_status ptc_exp3_axes3_own_step(
    const ptc_exp3_axes3_own *self,
    double t,
    const double x[3][3],
    double u[3],
    ptc_status axes[3]);

#ifdef __cplusplus
}
#endif

#endif
