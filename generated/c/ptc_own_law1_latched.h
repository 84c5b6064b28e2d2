/*
 * Prescribed-time controller ptc_own_law1_latched: order n = 1, mapping exp.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 1 --mu "exp(a=1)" --name ptc_own_law1_latched --pi0="-2*xi1
 *       - xi1*xi1_0"
 * Version 0.1.0.
 *
 * It brings x1' = x2, ..., xn' = u to rest at the time t0 + tau (x in unit, unit/s, ...).
 *
 * Parameters:
 *   tau: prescribed settling time [s], finite, > 0
 *   t0: start time [s], finite
 *   eps: time-to-go at which the gains are held [s], > 0, < tau
 *   u_max: bound of |u| [unit of u], > 0, infinity allowed
 *   a = 1, fixed: rate of stretched time [1/s], finite, > 0
 *
 * Time mapping (T = t0 + tau - t is the time-to-go, Dt = t - t0 the elapsed time):
 *   mu(t)     = tau*(1 - exp(-a*t))
 *   kappa(Dt) = -ln(T/tau)/a
 *   atoms: T = time-to-go
 * Derivatives r_k = mu^(k)(kappa(Dt)):
 *   r_k = (-1)^(k-1) a^k T
 *   r_1 = a*T
 * Matrix BB_n, entry (i,j) = B_{i-1,j-1}(r_1, ...), and its next row b_n:
 *   B_{0,0} = 1
 *
 * Law, Theorem 1: u = kappa'^n/g (pi0(BB_n x, t_kappa) - b_n^T x)
 *   pi0 = -2*xi1 - xi1*xi1_0
 *   g   = 1
 *   xi_i = sum_j (i-1)!/(j-1)! r_1^(j-1) [z^(i-1)] p(z)^(j-1) x_j
 *   p(z) = z + sum_{l>=2} r_l/(r_1 l!) z^l
 *
 * From t0 + tau - eps on, T is held at eps (status HOLD): the gains stay, u stays valid.
 * |u| <= u_max always (status SATURATED where u was clipped).
 * Guard full: every input and pointer is checked.
 * Precision f64 (IEEE 754 binary64). Equal bits everywhere need no fused multiply-add
 *       (-ffp-contract=off).
 *
 * Checks of the design (ptc-codegen check tells more):
 *   membership: sound: exp is of class M for all its parameters.
 *   growth: not checked: the law is no sum of gains, so its poles are not known.
 *   sampling: not checked: `sample_time` is not given.
 *   deadline: not checked: `error` is not given.
 *   envelope: not checked: `x_max` is not given.
 *
 * Operations of one step: 5 + - or comparison, 3 *, 1 /, 0 sqrt, 0 calls.
 * Latencies added up: x86-64 about 46 cycles, Cortex-M4F about 22 cycles.
 */
#ifndef PTC_OWN_LAW1_LATCHED_H
#define PTC_OWN_LAW1_LATCHED_H

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
typedef struct ptc_own_law1_latched_params {
    double tau; /* prescribed settling time [s], finite, > 0 */
    double t0; /* start time [s], finite */
    double eps; /* time-to-go at which the gains are held [s], > 0, < tau */
    double u_max; /* bound of |u| [unit of u], > 0, infinity allowed */
} ptc_own_law1_latched_params;

/* Controller: set by init and arm, read by step and tick. */
typedef struct ptc_own_law1_latched {
    double t0; /* start time */
    double tau; /* prescribed settling time */
    double deadline; /* t0 + tau, rounded */
    double correction; /* what the rounding of t0 + tau left out */
    double eps; /* time-to-go at which the gains are held */
    double hold_from; /* -eps: later than this the gains are held */
    double x1_0; /* state at the start */
    double u_max; /* bound of |u| */
} ptc_own_law1_latched;

/* Takes the parameters and arms at params->t0 (or the fixed t0), latching the state x0.
 * PTC_OK, or PTC_E_PARAM with *self untouched. */
ptc_status ptc_own_law1_latched_init(ptc_own_law1_latched *self, const ptc_own_law1_latched_params *params, const double x0[1]);

/* Starts again at t0 [s], latching the state x0. PTC_OK, or PTC_E_PARAM with *self untouched. */
ptc_status ptc_own_law1_latched_arm(ptc_own_law1_latched *self, double t0, const double x0[1]);

/* u at time t [s] and state x = (x1, x1', ...). */
ptc_status ptc_own_law1_latched_step(const ptc_own_law1_latched *self, double t, const double x[1], double *u);

#ifdef __cplusplus
}
#endif

#endif
