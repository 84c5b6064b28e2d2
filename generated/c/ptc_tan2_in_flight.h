/*
 * Prescribed-time controller ptc_tan2_in_flight: order n = 2, mapping tan.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 2 --mu tan --name ptc_tan2_in_flight --in-flight
 * Version 0.1.0, design 4686ad8cbd17.
 *
 * Plant: x1' = x2, x2' = f + u. Time in s, x1 in any unit U, x2 in U/s, u in U/s^2.
 * Goal: x = 0 at the deadline t0 + tau from any state at t0, up to the error that the hold at
 *       eps, sampling, f and clipping leave. The checks below say what is known of this
 *       design.
 * f is not part of the law: cancel its known terms before the call.
 *
 * SAMPLE PERIOD NOT GIVEN: the held gains grow as eps falls, and the loop is stable only for
 *       sample periods below a limit that depends on eps and the gains. ptc-codegen check
 *       finds it once tau, eps, the gains and --sample-time are given.
 *
 * Parameters:
 *   tau: prescribed settling time [s], from 1e-150 to 1e150
 *   t0: start time [s], finite
 *   eps: time-to-go at which the gains are held [s], >= 1e-150, < tau
 *   u_max: bound of |u| [unit of u], > 0, infinity allowed
 *   a: rate of stretched time [1/s], from 1e-150 to 1e150
 *   k: gains of pi0 = -(k_1 xi_1 + k_2 xi_2), finite; k[0] is k_1 [1/s^2], k[1] is k_2 [1/s]
 *
 * Time mapping, with time-to-go T = t0 + tau - t and elapsed time Dt = t - t0; t in mu(t) is
 *       the stretched time since t0:
 *   mu(t)     = (2*tau/pi)*atan(a*t)
 *   kappa(Dt) = cot(th)/a, th = pi*T/(2*tau)
 *   in terms of y = cot(th), V = 1/(1 + y^2)
 * Derivatives r_k = mu^(k)(kappa(Dt)):
 *   r_k = (-1)^(k-1) (k-1)! (2*tau/pi) a^k sin(k*th) sin(th)^k
 *   r_1 = 2*pi^-1*tau*a*V
 *   r_2 = -4*pi^-1*tau*a^2*y*V^2
 * Matrix BB_n, entry (i,j) = B_{i-1,j-1}(r_1, ...), and its next row b_n; zeros are left out:
 *   B_{0,0} = 1
 *   B_{1,1} = 2*pi^-1*tau*a*V
 *   B_{2,1} = -4*pi^-1*tau*a^2*y*V^2
 *
 * Law, Theorem 1, with xi = BB_n x and t_kappa = kappa(Dt) + t0:
 *   u = kappa'^n (pi0(xi, t_kappa) - b_n^T x)
 *   pi0 = -(k_1 xi_1 + k_2 xi_2)
 *   u = sum_j gain_j x_j
 *   gain_j = row_j
 *   K1, K2, ...: K_i = k_i/a^(n+1-i)
 *   row_1 = -K1*slope^2
 *   row_2 = -2*pi^-1*tau*K2*cot_rate^2 - 1/2*pi*tau^-1*K2 + 2*cot_rate
 *   cot_rate = (pi/(2*tau))*y = (pi/(2*tau))*cot(th)
 *   slope = (pi/(2*tau))*(1 + y^2) = kappa'/a
 *
 * From t0 + tau - eps on, and after the deadline, the gains of T = eps are held (status HOLD).
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
 *   membership: sound: tan is of class M for all its parameters.
 *   growth: not checked: the gains are left to run time: their poles must lie left of -n rho.
 *   sampling: not checked: `sample_time` is not given.
 *   deadline: not checked: `error` is not given.
 *   loop: not checked: it needs a value of `tau`.
 *   envelope: not checked: `x_max` is not given.
 *
 * Operations of one step, without input checks and clipping: 23 additions or comparisons, 29
 *       multiplications, 1 division.
 */
#ifndef PTC_TAN2_IN_FLIGHT_2F0071EC_H
#define PTC_TAN2_IN_FLIGHT_2F0071EC_H

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
typedef struct ptc_tan2_in_flight_params {
    double tau; /* prescribed settling time [s], from 1e-150 to 1e150 */
    double t0; /* start time [s], finite */
    double eps; /* time-to-go at which the gains are held [s], >= 1e-150, < tau */
    double u_max; /* bound of |u| [unit of u], > 0, infinity allowed */
    double a; /* rate of stretched time [1/s], from 1e-150 to 1e150 */
    double k[2]; /* gains of pi0 = -(k_1 xi_1 + k_2 xi_2), finite; k[0] is k_1 [1/s^2], k[1] is k_2 [1/s] */
} ptc_tan2_in_flight_params;

/* Controller: set by init, changed by arm and by what takes it without const. */
typedef struct ptc_tan2_in_flight {
    double k2; /* gains k_i of pi0 = -sum k_i xi_i */
    double c1_2; /* coefficient of slope^2 in the gain of x1 */
    double tau; /* prescribed settling time */
    double angle_rate; /* pi/(2*tau) */
    double inv_angle_rate; /* 2*tau/pi */
    double t0; /* start time */
    double deadline; /* t0 + tau, rounded */
    double correction; /* low part of t0 + tau (compensated sum) */
    double eps; /* time-to-go at which the gains are held */
    double hold_from; /* -eps: later than this the gains are held */
    double inv_tau; /* 1/tau */
    double f83; /* derived from the parameters */
    double c2_0; /* coefficient of cot_rate^0 in the gain of x2 */
    double f88; /* derived from the parameters */
    double c2_2; /* coefficient of cot_rate^2 in the gain of x2 */
    double u_max; /* bound of |u| */
} ptc_tan2_in_flight;

/* Feedback gains at one time. */
typedef struct ptc_tan2_in_flight_gains {
    double gain[2]; /* u = gain[0] x[0] + ... + gain[1] x[1] */
    double u_max; /* bound of |u| */
    ptc_status status; /* PTC_OK or PTC_HOLD */
} ptc_tan2_in_flight_gains;

/*
 * Takes the parameters and arms at params.t0 (or the fixed t0) for params.tau. PTC_OK, or
 * PTC_E_PARAM with *self untouched.
 */
ptc_status ptc_tan2_in_flight_init(
    ptc_tan2_in_flight *self,
    const ptc_tan2_in_flight_params *params);

/* Starts again at t0 [s], with the tau last used. PTC_OK, or PTC_E_PARAM with *self untouched. */
ptc_status ptc_tan2_in_flight_arm(ptc_tan2_in_flight *self, double t0);

/*
 * Starts again at t0 [s] with another duration tau [s]: the deadline is t0 + tau. PTC_OK, or
 * PTC_E_PARAM with *self untouched.
 */
ptc_status ptc_tan2_in_flight_arm_for(ptc_tan2_in_flight *self, double t0, double tau);

/*
 * u at time t [s] and state x = (x1, x1', ...). On a negative status u is 0 and nothing has
 * changed. u must not overlap x.
 */
ptc_status ptc_tan2_in_flight_step(
    const ptc_tan2_in_flight *self,
    double t,
    const double x[2],
    double *u);

/*
 * The gains at time t [s], for several axes that share one deadline: tick once, then axis for each.
 * The result of tick and axis may differ from that of step in the last bits. On a negative status
 * *gains is unchanged.
 */
ptc_status ptc_tan2_in_flight_tick(
    const ptc_tan2_in_flight *self,
    double t,
    ptc_tan2_in_flight_gains *gains);

/*
 * u of one axis from its state x = (x1, x1', ...) and the gains. On a negative status u is 0 and
 * nothing has changed. u must not overlap x.
 */
ptc_status ptc_tan2_in_flight_axis(
    const ptc_tan2_in_flight_gains *gains,
    const double x[2],
    double *u);

#ifdef __cplusplus
}
#endif

#endif
