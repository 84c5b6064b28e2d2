/*
 * Prescribed-time controller ptc_tanh3_extern: order n = 3, mapping tanh.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 3 --mu tanh --name ptc_tanh3_extern --pi0 extern --after
 *       extern
 * Version 0.1.0.
 *
 * It brings x1' = x2, ..., xn' = u to rest at the time t0 + tau (x in unit, unit/s, ...).
 *
 * Parameters:
 *   tau: prescribed settling time [s], finite, > 0
 *   t0: start time [s], finite
 *   eps: time-to-go at which the gains are held [s], > 0, < tau
 *   u_max: bound of |u| [unit of u], > 0, infinity allowed
 *   a: rate of stretched time [1/s], finite, > 0
 *
 * Time mapping (T = t0 + tau - t is the time-to-go, Dt = t - t0 the elapsed time):
 *   mu(t)     = tau*tanh(a*t)
 *   kappa(Dt) = -ln(E)/(2*a), E = T/(2*tau - T)
 *   atoms: T = time-to-go, E = exp(-2*a*t) = T/(2*tau - T), g = 1/(1 + E)
 * Derivatives r_k = mu^(k)(kappa(Dt)):
 *   r_k = 2*tau*(-2*a)^k Li_{-k}(-E)
 *   r_1 = 2*a*T*g
 *   r_2 = 4*a^2*T*E*g^2 - 4*a^2*T*g^2
 *   r_3 = -32*a^3*T*E*g^3 + 8*a^3*T*E^2*g^3 + 8*a^3*T*g^3
 * Matrix BB_n, entry (i,j) = B_{i-1,j-1}(r_1, ...), and its next row b_n:
 *   B_{0,0} = 1
 *   B_{1,1} = 2*a*T*g
 *   B_{2,1} = 4*a^2*T*E*g^2 - 4*a^2*T*g^2
 *   B_{2,2} = 4*a^2*T^2*g^2
 *   B_{3,1} = -32*a^3*T*E*g^3 + 8*a^3*T*E^2*g^3 + 8*a^3*T*g^3
 *   B_{3,2} = 24*a^3*T^2*E*g^3 - 24*a^3*T^2*g^3
 *
 * Law, Theorem 1: u = kappa'^n/g (pi0(BB_n x, t_kappa) - b_n^T x)
 *   pi0 = a function of yours, called with xi and t_kappa
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
 *   membership: sound: tanh is of class M for all its parameters.
 *   growth: not checked: the law is no sum of gains, so its poles are not known.
 *   sampling: not checked: `sample_time` is not given.
 *   deadline: not checked: `error` is not given.
 *   envelope: not checked: `x_max` is not given.
 *
 * Operations of one step: 16 + - or comparison, 24 *, 4 /, 0 sqrt, 2 calls.
 * Latencies added up: x86-64 about 336 cycles, Cortex-M4F about 396 cycles.
 */
#ifndef PTC_TANH3_EXTERN_H
#define PTC_TANH3_EXTERN_H

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
typedef struct ptc_tanh3_extern_params {
    double tau; /* prescribed settling time [s], finite, > 0 */
    double t0; /* start time [s], finite */
    double eps; /* time-to-go at which the gains are held [s], > 0, < tau */
    double u_max; /* bound of |u| [unit of u], > 0, infinity allowed */
    double a; /* rate of stretched time [1/s], finite, > 0 */
} ptc_tanh3_extern_params;

/* Controller: set by init and arm, read by step and tick. */
typedef struct ptc_tanh3_extern {
    double t0; /* start time */
    double tau; /* prescribed settling time */
    double deadline; /* t0 + tau, rounded */
    double correction; /* what the rounding of t0 + tau left out */
    double eps; /* time-to-go at which the gains are held */
    double hold_from; /* -eps: later than this the gains are held */
    double f16; /* known when the parameters are */
    double a; /* rate of stretched time */
    double f22; /* known when the parameters are */
    double f24; /* known when the parameters are */
    double f29; /* known when the parameters are */
    double u_max; /* bound of |u| */
} ptc_tanh3_extern;

/* The law pi0(xi, t) of yours; t is the stretched time kappa + t0. */
typedef double (*ptc_tanh3_extern_pi0)(void *context, const double xi[3], double t);

/* The law of yours for t >= t0 + tau. */
typedef double (*ptc_tanh3_extern_after)(void *context, const double x[3], double t);

/* Takes the parameters and arms at params->t0 (or the fixed t0).
 * PTC_OK, or PTC_E_PARAM with *self untouched. */
ptc_status ptc_tanh3_extern_init(ptc_tanh3_extern *self, const ptc_tanh3_extern_params *params);

/* Starts again at t0 [s]. PTC_OK, or PTC_E_PARAM with *self untouched. */
ptc_status ptc_tanh3_extern_arm(ptc_tanh3_extern *self, double t0);

/* u at time t [s] and state x = (x1, x1', ...). context is handed on as it is. */
ptc_status ptc_tanh3_extern_step(const ptc_tanh3_extern *self, double t, const double x[3], ptc_tanh3_extern_pi0 pi0, ptc_tanh3_extern_after after, void *context, double *u);

#ifdef __cplusplus
}
#endif

#endif
