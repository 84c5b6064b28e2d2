/*
 * Prescribed-time controller gantry: order n = 2, mapping exp.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 2 --axes 3 --mu "exp(a=1)" --name gantry --tau=1.5 --t0=0 --eps=1.59e-2 --limits=900,400,150 --poles="[[-4,-5],[-4,-5],[-6,-7]]" --g="[1/m1, 1/m2, 1/m3]" --param m1=120 --param m2=45 --param m3=12 --sample-time=1e-3
 * Version 0.1.0, design 9ac95d6ea129.
 *
 * Plant: x1' = x2, x2' = f + g u. Time in s, x1 in any unit U, x2 in U/s, g u in U/s^2.
 * Goal: x = 0 at the deadline t0 + tau from any state at t0, up to the error that the hold at
 *       eps, sampling, f and clipping leave. The checks below say what is known of this
 *       design.
 * f is not part of the law: cancel its known terms before the call.
 * Axes: 3, each a chain of its own with this deadline and mapping. step computes what depends
 *       on time once.
 *   axis 1: k = 20, 9; u_max = 900; g = 1/m1
 *   axis 2: k = 20, 9; u_max = 400; g = 1/m2
 *   axis 3: k = 42, 13; u_max = 150; g = 1/m3
 *
 * Parameters:
 *   tau = 1.5 [s], fixed: prescribed settling time
 *   t0 = 0 [s], fixed: start time
 *   eps = 1.59e-2 [s], fixed: time-to-go at which the gains are held
 *   a = 1 [1/s], fixed: rate of stretched time
 *   m1 = 120, fixed: parameter of g
 *   m2 = 45, fixed: parameter of g
 *   m3 = 12, fixed: parameter of g
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
 *   u = kappa'^n (pi0(xi, t_kappa) - b_n^T x)/g
 *   pi0 = -(k_1 xi_1 + k_2 xi_2)
 *   u = (sum_j gain_j x_j)/g
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
 *       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
 *
 * Checks of the design (details: ptc-codegen check):
 *   membership: sound: exp is of class M for all its parameters.
 *   growth: sound: x and u go to 0 at the deadline.
 *   sampling: sound: axis 1: eps = 0.0159 s is 3.975 times the minimum for a period of 0.001
 *       s.
 *   deadline: not checked: `error` is not given.
 *   loop: not checked: `x0_max` is not given.
 *   envelope: not checked: `x_max` is not given.
 *
 * Operations of one step, without input checks and clipping: 6 additions or comparisons, 12
 *       multiplications, 4 divisions.
 */
#ifndef GANTRY_C42FD67D_H
#define GANTRY_C42FD67D_H

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
typedef struct gantry_params {
    char none; /* every parameter is fixed */
} gantry_params;

/* Controller: set by init, changed by arm and by what takes it without const. */
typedef struct gantry {
    double t0; /* start time */
    double deadline; /* t0 + tau, rounded */
    double correction; /* low part of t0 + tau (compensated sum) */
} gantry;

/* Feedback gains at one time. */
typedef struct gantry_gains {
    double gain[6]; /* u input_gain = gain[2*axis] x[0] + ... + gain[2*axis + 1] x[1] */
    double input_gain[3]; /* g */
    double u_max[3]; /* bound of |u| of each axis */
    ptc_status status; /* PTC_OK or PTC_HOLD */
} gantry_gains;

/*
 * Takes the parameters and arms at params.t0 (or the fixed t0). PTC_OK, or PTC_E_PARAM with *self
 * untouched.
 */
ptc_status gantry_init(gantry *self, const gantry_params *params);

/* Starts again at t0 [s]. PTC_OK, or PTC_E_PARAM with *self untouched. */
ptc_status gantry_arm(gantry *self, double t0);

/*
 * The gains at time t [s] for all axes, from which step computes u of each. On a negative status
 * *gains is unchanged.
 */
ptc_status gantry_tick(const gantry *self, double t, gantry_gains *gains);

/*
 * u of one axis from its state x = (x1, x1', ...) and the gains. On a negative status u is 0 and
 * nothing has changed. u must not overlap x.
 */
ptc_status gantry_axis(const gantry_gains *gains, uint32_t axis, const double x[2], double *u);

/*
 * u of 3 axes at time t [s], from the state x = (x1, x1', ...) of each. Its status is that of the
 * first axis that fails, and then every u is 0; else SATURATED where an axis is. u and axes must
 * not overlap x.
 */
ptc_status gantry_step(
    const gantry *self,
    double t,
    const double x[3][2],
    double u[3],
    ptc_status axes[3]);

#ifdef __cplusplus
}
#endif

#endif
