/*
 * Prescribed-time controller ptc_tanh3_extern: order n = 3, mapping tanh.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 3 --mu tanh --name ptc_tanh3_extern --pi0 extern --after extern
 * Version 0.1.0, design 04514e738293.
 *
 * Plant: x1' = x2, ..., x3' = f + u. Time in s, x1 in any unit U, x2 in U/s, x3 in U/s^2, u
 *       in U/s^3.
 * Goal: x = 0 at the deadline t0 + tau from any state at t0, up to the error that the hold at
 *       eps, sampling, f and clipping leave. The checks below say what is known of this
 *       design.
 * f is not part of the law: cancel its known terms before the call.
 *
 * SAMPLE PERIOD NOT GIVEN: the gain held at eps limits the sample period for which the loop
 *       is stable. Simulate the sampled loop: ptc-codegen simulate --sample-time.
 *
 * Parameters:
 *   tau: prescribed settling time [s], from 1e-150 to 1e150
 *   t0: start time [s], finite
 *   eps: time-to-go at which the gains are held [s], >= 1e-150, < tau
 *   u_max: bound of |u| [unit of u], > 0, infinity allowed
 *   a: rate of stretched time [1/s], from 1e-150 to 1e150
 *
 * Time mapping, with time-to-go T = t0 + tau - t and elapsed time Dt = t - t0; t in mu(t) is
 *       the stretched time since t0:
 *   mu(t)     = tau*tanh(a*t)
 *   kappa(Dt) = -ln(E)/(2*a), E = T/(2*tau - T)
 *   in terms of T = time-to-go, E = exp(-2*a*t) = T/(2*tau - T), L = 1/(1 + E)
 * Derivatives r_k = mu^(k)(kappa(Dt)):
 *   r_k = 2*tau*(-2*a)^k Li_{-k}(-E)
 *   r_1 = 2*a*T*L
 *   r_2 = 4*a^2*T*E*L^2 - 4*a^2*T*L^2
 *   r_3 = -32*a^3*T*E*L^3 + 8*a^3*T*E^2*L^3 + 8*a^3*T*L^3
 * Matrix BB_n, entry (i,j) = B_{i-1,j-1}(r_1, ...), and its next row b_n; zeros are left out:
 *   B_{0,0} = 1
 *   B_{1,1} = 2*a*T*L
 *   B_{2,1} = 4*a^2*T*E*L^2 - 4*a^2*T*L^2
 *   B_{2,2} = 4*a^2*T^2*L^2
 *   B_{3,1} = -32*a^3*T*E*L^3 + 8*a^3*T*E^2*L^3 + 8*a^3*T*L^3
 *   B_{3,2} = 24*a^3*T^2*E*L^3 - 24*a^3*T^2*L^3
 *
 * Law, Theorem 1, with xi = BB_n x and t_kappa = kappa(Dt) + t0:
 *   u = kappa'^n (pi0(xi, t_kappa) - b_n^T x)
 *   pi0 = a user-defined function of xi and t_kappa
 *   xi_i = sum_j (i-1)!/(j-1)! r_1^(j-1) [z^(i-1)] p(z)^(j-1) x_j
 *   p(z) = z + sum_{l>=2} r_l/(r_1 l!) z^l, where [z^i] takes the coefficient of z^i
 *
 * From t0 + tau - eps on, T is held at eps in the law (status HOLD). From t0 + tau on, u is
 *       the result of the user-defined function after (status AFTER).
 * |u| <= u_max: u is clipped to it (status SATURATED). Prolonged saturation voids the
 *       deadline.
 * Guard full: t and x are finite, t >= t0 and no pointer is NULL, or the call is refused
 *       (status E_INPUT).
 * Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
 *       machine without fused multiply-add (gcc, clang: -ffp-contract=off) and with the same
 *       mathematical library.
 *
 * Checks of the design (details: ptc-codegen check):
 *   membership: sound: tanh is of class M for all its parameters.
 *   growth: not checked: the law is not a sum of gains, so its poles are not known.
 *   sampling: not checked: `sample_time` is not given.
 *   deadline: not checked: `error` is not given.
 *   loop: not checked: it needs a linear law.
 *   envelope: not checked: `x_max` is not given.
 *
 * Operations of one step, without input checks and clipping: 16 additions or comparisons, 24
 *       multiplications, 4 divisions, 2 function calls.
 */
#ifndef PTC_TANH3_EXTERN_21A64E8C_H
#define PTC_TANH3_EXTERN_21A64E8C_H

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
typedef struct ptc_tanh3_extern_params {
    double tau; /* prescribed settling time [s], from 1e-150 to 1e150 */
    double t0; /* start time [s], finite */
    double eps; /* time-to-go at which the gains are held [s], >= 1e-150, < tau */
    double u_max; /* bound of |u| [unit of u], > 0, infinity allowed */
    double a; /* rate of stretched time [1/s], from 1e-150 to 1e150 */
} ptc_tanh3_extern_params;

/* Controller: set by init, changed by arm and by what takes it without const. */
typedef struct ptc_tanh3_extern {
    double t0; /* start time */
    double tau; /* prescribed settling time */
    double deadline; /* t0 + tau, rounded */
    double correction; /* low part of t0 + tau (compensated sum) */
    double eps; /* time-to-go at which the gains are held */
    double hold_from; /* -eps: later than this the gains are held */
    double f16; /* derived from the parameters */
    double a; /* rate of stretched time */
    double f22; /* derived from the parameters */
    double f24; /* derived from the parameters */
    double f29; /* derived from the parameters */
    double u_max; /* bound of |u| */
} ptc_tanh3_extern;

/* User-defined law pi0(xi, t); t is the stretched time kappa + t0. */
typedef double (*ptc_tanh3_extern_pi0)(void *context, const double xi[3], double t);

/* User-defined law for t >= t0 + tau. */
typedef double (*ptc_tanh3_extern_after)(void *context, const double x[3], double t);

/*
 * Takes the parameters and arms at params.t0 (or the fixed t0). PTC_OK, or PTC_E_PARAM with *self
 * untouched.
 */
ptc_status ptc_tanh3_extern_init(ptc_tanh3_extern *self, const ptc_tanh3_extern_params *params);

/* Starts again at t0 [s]. PTC_OK, or PTC_E_PARAM with *self untouched. */
ptc_status ptc_tanh3_extern_arm(ptc_tanh3_extern *self, double t0);

/*
 * u at time t [s] and state x = (x1, x1', ...). context is passed on unchanged. On a negative
 * status u is 0 and nothing has changed. u must not overlap x.
 */
ptc_status ptc_tanh3_extern_step(
    const ptc_tanh3_extern *self,
    double t,
    const double x[3],
    ptc_tanh3_extern_pi0 pi0,
    ptc_tanh3_extern_after after,
    void *context,
    double *u);

#ifdef __cplusplus
}
#endif

#endif
