/*
 * Prescribed-time controller ptc_exp_sum1: order n = 1, mapping exp_sum.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 1 --mu "exp_sum(2)"
 * Version 0.1.0.
 *
 * It brings x1' = x2, ..., xn' = u to rest at the time t0 + tau (x in unit, unit/s, ...).
 *
 * Parameters:
 *   tau: prescribed settling time [s], finite, > 0
 *   t0: start time [s], finite
 *   eps: time-to-go at which the gains are held [s], > 0, < tau
 *   u_max: bound of |u| [unit of u], > 0, infinity allowed
 *   rates: rates a_i of stretched time [1/s], finite, > 0
 *   k: gains k_i of pi0 = -sum k_i xi_i [s^(i-1-n)], finite
 *
 * Time mapping (T = t0 + tau - t is the time-to-go, Dt = t - t0 the elapsed time):
 *   mu(t)     = tau*mean_i(1 - exp(-a_i*t))
 *   kappa(Dt) = the root t of mean_i(exp(-a_i*t)) = T/tau, by a bracketed iteration
 *   atoms: e_i = exp(-a_i*t)
 * Derivatives r_k = mu^(k)(kappa(Dt)):
 *   r_k = (-1)^(k-1) tau mean_i(a_i^k e_i)
 *   r_1 = 1/2*tau*a1*e1 + 1/2*tau*a2*e2
 * Matrix BB_n, entry (i,j) = B_{i-1,j-1}(r_1, ...), and its next row b_n:
 *   B_{0,0} = 1
 *
 * Law, Theorem 1: u = kappa'^n/g (pi0(BB_n x, t_kappa) - b_n^T x)
 *   pi0 = -(k_1 xi_1 + ... + k_n xi_n)
 *   g   = 1
 *   u = (sum_j gain_j x_j)/g
 *   gain_j = r_1^-(n+1-j) row_j, k_(n+1) = 1
 *   row_j = -1/(j-1)! sum_{i=j..n+1} k_i (i-1)! [z^(i-1)] p(z)^(j-1)
 *   p(z) = z + sum_{l>=2} r_l/(r_1 l!) z^l
 *
 * From t0 + tau - eps on, T is held at eps (status HOLD): the gains stay, u stays valid.
 * |u| <= u_max always (status SATURATED where u was clipped).
 * Guard full: every input and pointer is checked.
 * Precision f64 (IEEE 754 binary64). Equal bits everywhere need no fused multiply-add
 *       (-ffp-contract=off).
 *
 * Checks of the design (ptc-codegen check tells more):
 *   membership: sound: exp_sum is of class M for all its parameters.
 *   growth: not checked: the gains are left to run time: their poles must lie left of -n rho.
 *   sampling: not checked: `sample_time` is not given.
 *   deadline: not checked: `error` is not given.
 *   envelope: not checked: `x_max` is not given.
 *
 * Operations of one step: 31 + - or comparison, 44 *, 5 /, 0 sqrt, 5 calls, one round of the
 *       iteration.
 * Latencies added up: x86-64 about 670 cycles, Cortex-M4F about 895 cycles.
 */
#ifndef PTC_EXP_SUM1_H
#define PTC_EXP_SUM1_H

#ifdef __cplusplus
extern "C" {
#endif

#ifndef PTC_STATUS_DEFINED
#define PTC_STATUS_DEFINED
/* Outcome of a call; a negative one leaves *u = 0. */
typedef enum ptc_status {
    PTC_OK = 0,        /* tracking */
    PTC_HOLD = 1,      /* time-to-go held at eps: the deadline is near or over, u is valid */
    PTC_SATURATED = 2, /* u clipped to u_max; wins over PTC_HOLD and PTC_AFTER */
    PTC_AFTER = 3,     /* the deadline is over, and what was chosen for then gives u */
    PTC_E_PARAM = -1,  /* a parameter outside its domain, or coefficients that overflow */
    PTC_E_INPUT = -2,  /* x or t not finite, t before t0, or a NULL pointer */
    PTC_E_RANGE = -3   /* u not finite */
} ptc_status;
#endif

/* Run-time parameters. */
typedef struct ptc_exp_sum1_params {
    double tau; /* prescribed settling time [s], finite, > 0 */
    double t0; /* start time [s], finite */
    double eps; /* time-to-go at which the gains are held [s], > 0, < tau */
    double u_max; /* bound of |u| [unit of u], > 0, infinity allowed */
    double rates[2]; /* rates a_i of stretched time [1/s], finite, > 0 */
    double k[1]; /* gains k_i of pi0 = -sum k_i xi_i [s^(i-1-n)], finite */
} ptc_exp_sum1_params;

/* Controller: set by init and arm, read by step and tick. */
typedef struct ptc_exp_sum1 {
    double a1; /* rates a_i of stretched time */
    double a2; /* rates a_i of stretched time */
    double t0; /* start time */
    double tau; /* prescribed settling time */
    double deadline; /* t0 + tau, rounded */
    double correction; /* what the rounding of t0 + tau left out */
    double eps; /* time-to-go at which the gains are held */
    double hold_from; /* -eps: later than this the gains are held */
    double target_rate; /* N/tau, N the number of rates */
    double slowest; /* 1/min a_i */
    double mean_period; /* 1/mean a_i */
    double tolerance; /* size of the last step of the iteration */
    double b1_1; /* weight of exp(-a1*y) in r1/1! */
    double b1_2; /* weight of exp(-a2*y) in r1/1! */
    double w1; /* weighted gain -0!*k1 */
    double u_max; /* bound of |u| */
} ptc_exp_sum1;

/* Feedback gains at one time: u = gain[0]*x[0] + ... + gain[0]*x[0]. */
typedef struct ptc_exp_sum1_gains {
    double gain[1];
    double u_max; /* bound of |u| */
    ptc_status status; /* PTC_OK or PTC_HOLD */
} ptc_exp_sum1_gains;

/* Takes the parameters and arms at params->t0 (or the fixed t0).
 * PTC_OK, or PTC_E_PARAM with *self untouched. */
ptc_status ptc_exp_sum1_init(ptc_exp_sum1 *self, const ptc_exp_sum1_params *params);

/* Starts again at t0 [s]. PTC_OK, or PTC_E_PARAM with *self untouched. */
ptc_status ptc_exp_sum1_arm(ptc_exp_sum1 *self, double t0);

/* u at time t [s] and state x = (x1, x1', ...). */
ptc_status ptc_exp_sum1_step(const ptc_exp_sum1 *self, double t, const double x[1], double *u);

/* The gains at time t, for several axes that share one deadline: tick once, then axis for each.
 * On a negative status *gains is left alone. tick and axis round otherwise than step does. */
ptc_status ptc_exp_sum1_tick(const ptc_exp_sum1 *self, double t, ptc_exp_sum1_gains *gains);

/* u of one axis from the gains that tick left. */
ptc_status ptc_exp_sum1_axis(const ptc_exp_sum1_gains *gains, const double x[1], double *u);

#ifdef __cplusplus
}
#endif

#endif
