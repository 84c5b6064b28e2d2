/*
 * Prescribed-time controller duration_latched: order n = 2, mapping custom.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 2 --kappa="dt/(c*tau*(tau - dt)) + dt" --name duration_latched --in-flight --pi0="-6*xi1 - 5*xi2 + xi1_0/8" --param "c=[0.5,2]" --allow=growth
 * Version 0.1.0, design 618c09f23c7e.
 *
 * Plant: x1' = x2, x2' = f + u. Time in s, x1 in any unit U, x2 in U/s, u in U/s^2.
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
 *   c: parameter of kappa, from 0.5 to 2
 *
 * Time mapping, with time-to-go T = t0 + tau - t and elapsed time Dt = t - t0; t in mu(t) is
 *       the stretched time since t0:
 *   kappa(dt) = dt/(c*tau*(tau - dt)) + dt
 *   kappa = (tau + tau^2*c*T - tau*c*T^2 - T)/(tau*c*T)
 *   r_1 = T*(c*T/(1 + c*T^2))
 * r_k and BB_n are computed from the Taylor series of mu at each call.
 *
 * Law, Theorem 1, with xi = BB_n x and t_kappa = kappa(Dt) + t0:
 *   u = kappa'^n (pi0(xi, t_kappa) - b_n^T x)
 *   pi0 = -6*xi1 - 5*xi2 + xi1_0/8
 *   xi_i = sum_j (i-1)!/(j-1)! r_1^(j-1) [z^(i-1)] p(z)^(j-1) x_j
 *   p(z) = z + sum_{l>=2} r_l/(r_1 l!) z^l, where [z^i] takes the coefficient of z^i
 *
 * From t0 + tau - eps on, and after the deadline, T is held at eps in the law (status HOLD).
 * In flight: arm_for starts again at t0 for another tau, at any time, and computes what
 *       follows from tau. arm keeps the tau last used: at first that of the parameters.
 * |u| <= u_max: u is clipped to it (status SATURATED). Prolonged saturation voids the
 *       deadline.
 * Guard full: t and x are finite, t >= t0 and no pointer is NULL, or the call is refused
 *       (status E_INPUT).
 * Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
 *       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
 *
 * Checks of the design (details: ptc-codegen check):
 *   membership: sound: the mapping is of its class, proved.
 *   growth: not checked: the law is not a sum of gains, so its poles are not known.
 *   sampling: not checked: `sample_time` is not given.
 *   deadline: not checked: `error` is not given.
 *   loop: not checked: it needs a linear law.
 *   envelope: not checked: `x_max` is not given.
 *
 * Operations of one step, without input checks and clipping: 11 additions or comparisons, 15
 *       multiplications, 3 divisions.
 */
#ifndef DURATION_LATCHED_247EC932_H
#define DURATION_LATCHED_247EC932_H

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
typedef struct duration_latched_params {
    double tau; /* prescribed settling time [s], from 1e-150 to 1e150 */
    double t0; /* start time [s], finite */
    double eps; /* time-to-go at which the gains are held [s], >= 1e-150, < tau */
    double u_max; /* bound of |u| [unit of u], > 0, infinity allowed */
    double c; /* parameter of kappa, from 0.5 to 2 */
} duration_latched_params;

/* Controller: set by init, changed by arm and by what takes it without const. */
typedef struct duration_latched {
    double t0; /* start time */
    double tau; /* prescribed settling time */
    double deadline; /* t0 + tau, rounded */
    double correction; /* low part of t0 + tau (compensated sum) */
    double eps; /* time-to-go at which the gains are held */
    double hold_from; /* -eps: later than this the gains are held */
    double p_c; /* parameter of an expression of the design */
    double f44; /* derived at the start time */
    double u_max; /* bound of |u| */
} duration_latched;

/*
 * Takes the parameters and arms at params.t0 (or the fixed t0) for params.tau, latching the state
 * x0. PTC_OK, or PTC_E_PARAM with *self untouched.
 */
ptc_status duration_latched_init(
    duration_latched *self,
    const duration_latched_params *params,
    const double x0[2]);

/*
 * Starts again at t0 [s], with the tau last used, latching the state x0. PTC_OK, or PTC_E_PARAM
 * with *self untouched.
 */
ptc_status duration_latched_arm(duration_latched *self, double t0, const double x0[2]);

/*
 * Starts again at t0 [s] with another duration tau [s]: the deadline is t0 + tau, latching the
 * state x0. PTC_OK, or PTC_E_PARAM with *self untouched.
 */
ptc_status duration_latched_arm_for(
    duration_latched *self,
    double t0,
    double tau,
    const double x0[2]);

/*
 * u at time t [s] and state x = (x1, x1', ...). On a negative status u is 0 and nothing has
 * changed. u must not overlap x.
 */
ptc_status duration_latched_step(
    const duration_latched *self,
    double t,
    const double x[2],
    double *u);

#ifdef __cplusplus
}
#endif

#endif
