/*
 * Prescribed-time controller ptc_own_kappa2: order n = 2, mapping custom.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 2 --kappa="tau*dt/(tau - dt) + dt" --name ptc_own_kappa2
 *       --after zero
 * Version 0.1.0.
 *
 * It brings x1' = x2, ..., xn' = u to rest at the time t0 + tau (x in unit, unit/s, ...).
 *
 * Parameters:
 *   tau: prescribed settling time [s], finite, > 0
 *   t0: start time [s], finite
 *   eps: time-to-go at which the gains are held [s], > 0, < tau
 *   u_max: bound of |u| [unit of u], > 0, infinity allowed
 *   k: gains k_i of pi0 = -sum k_i xi_i [s^(i-1-n)], finite
 *
 * Time mapping (T = t0 + tau - t is the time-to-go, Dt = t - t0 the elapsed time):
 *   kappa(dt) = tau*dt/(tau - dt) + dt
 *   kappa = (tau^2 - T^2)/T
 *   r_1 = T*(T/(tau^2 + T^2))
 * r_k and BB_n come from its Taylor series at each tick.
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
 *   membership: sound: the mapping is of its class, proved.
 *   growth: not checked: the gains are left to run time: their poles must lie left of -n rho.
 *   sampling: not checked: `sample_time` is not given.
 *   deadline: not checked: `error` is not given.
 *   envelope: not checked: `x_max` is not given.
 *
 * Operations of one step: 10 + - or comparison, 11 *, 3 /, 0 sqrt, 0 calls.
 * Latencies added up: x86-64 about 126 cycles, Cortex-M4F about 63 cycles.
 */
#ifndef PTC_OWN_KAPPA2_H
#define PTC_OWN_KAPPA2_H

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
typedef struct ptc_own_kappa2_params {
    double tau; /* prescribed settling time [s], finite, > 0 */
    double t0; /* start time [s], finite */
    double eps; /* time-to-go at which the gains are held [s], > 0, < tau */
    double u_max; /* bound of |u| [unit of u], > 0, infinity allowed */
    double k[2]; /* gains k_i of pi0 = -sum k_i xi_i [s^(i-1-n)], finite */
} ptc_own_kappa2_params;

/* Controller: set by init and arm, read by step and tick. */
typedef struct ptc_own_kappa2 {
    double t0; /* start time */
    double tau; /* prescribed settling time */
    double deadline; /* t0 + tau, rounded */
    double correction; /* what the rounding of t0 + tau left out */
    double eps; /* time-to-go at which the gains are held */
    double hold_from; /* -eps: later than this the gains are held */
    double f15; /* known when the parameters are */
    double w1; /* weighted gain -0!*k1 */
    double w2; /* weighted gain -1!*k2 */
    double u_max; /* bound of |u| */
} ptc_own_kappa2;

/* Takes the parameters and arms at params->t0 (or the fixed t0).
 * PTC_OK, or PTC_E_PARAM with *self untouched. */
ptc_status ptc_own_kappa2_init(ptc_own_kappa2 *self, const ptc_own_kappa2_params *params);

/* Starts again at t0 [s]. PTC_OK, or PTC_E_PARAM with *self untouched. */
ptc_status ptc_own_kappa2_arm(ptc_own_kappa2 *self, double t0);

/* u at time t [s] and state x = (x1, x1', ...). */
ptc_status ptc_own_kappa2_step(const ptc_own_kappa2 *self, double t, const double x[2], double *u);

#ifdef __cplusplus
}
#endif

#endif
