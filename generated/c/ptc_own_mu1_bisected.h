/*
 * Prescribed-time controller ptc_own_mu1_bisected: order n = 1, mapping custom.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 1 --mu="tau*(1 - (2/(1 + t + sqrt(1 + t^2)))^(1/10))" --name ptc_own_mu1_bisected
 * Version 0.1.0, design da1c67f5e703.
 *
 * Plant: x1' = f + u. Time in s, x1 in any unit U, u in U/s.
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
 *   k: gains of pi0 = -k_1 xi_1, finite; k[0] is k_1 [1/s]
 *
 * Time mapping, with time-to-go T = t0 + tau - t and elapsed time Dt = t - t0; t in mu(t) is
 *       the stretched time since t0:
 *   mu(t)  = tau*(1 - (2/(1 + t + sqrt(1 + t^2)))^(1/10))
 *   tau - mu(t) = tau*(2/(1 + t + sqrt(1 + t^2)))^(1/10)
 *   kappa = the root t of tau - mu(t) = T, by a bounded iteration
 * r_k and BB_n are computed from the Taylor series of mu at each call.
 *
 * Law, Theorem 1, with xi = BB_n x and t_kappa = kappa(Dt) + t0:
 *   u = kappa'^n (pi0(xi, t_kappa) - b_n^T x)
 *   pi0 = -k_1 xi_1
 *   u = sum_j gain_j x_j
 *   gain_j = r_1^-(n+1-j) row_j
 *   row_j = -1/(j-1)! sum_{i=j..n+1} k_i (i-1)! [z^(i-1)] p(z)^(j-1), with k_(n+1) = 1
 *   p(z) = z + sum_{l>=2} r_l/(r_1 l!) z^l, where [z^i] takes the coefficient of z^i
 *
 * From t0 + tau - eps on, and after the deadline, the gains of T = eps are held (status HOLD).
 * |u| <= u_max: u is clipped to it (status SATURATED). Prolonged saturation voids the
 *       deadline.
 * Guard full: t and x are finite, t >= t0 and no pointer is NULL, or the call is refused
 *       (status E_INPUT).
 * Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
 *       machine without fused multiply-add (gcc, clang: -ffp-contract=off) and with the same
 *       mathematical library.
 *
 * Checks of the design (details: ptc-codegen check):
 *   membership: sound: the mapping is of its class, proved.
 *   growth: not checked: the gains are left to run time: their poles must lie left of -n rho.
 *   sampling: not checked: `sample_time` is not given.
 *   deadline: not checked: `error` is not given.
 *   loop: not checked: it needs a value of `tau`.
 *   envelope: not checked: `x_max` is not given.
 *
 * Operations of one step, without input checks and clipping: 19 additions or comparisons, 23
 *       multiplications, 7 divisions, 2 square roots, 2 function calls. One round of the
 *       iteration is counted; it takes at most 100.
 */
#ifndef PTC_OWN_MU1_BISECTED_B0AFC417_H
#define PTC_OWN_MU1_BISECTED_B0AFC417_H

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
typedef struct ptc_own_mu1_bisected_params {
    double tau; /* prescribed settling time [s], from 1e-150 to 1e150 */
    double t0; /* start time [s], finite */
    double eps; /* time-to-go at which the gains are held [s], >= 1e-150, < tau */
    double u_max; /* bound of |u| [unit of u], > 0, infinity allowed */
    double k[1]; /* gains of pi0 = -k_1 xi_1, finite; k[0] is k_1 [1/s] */
} ptc_own_mu1_bisected_params;

/* Controller: set by init, changed by arm and by what takes it without const. */
typedef struct ptc_own_mu1_bisected {
    double t0; /* start time */
    double tau; /* prescribed settling time */
    double deadline; /* t0 + tau, rounded */
    double correction; /* low part of t0 + tau (compensated sum) */
    double eps; /* time-to-go at which the gains are held */
    double hold_from; /* -eps: later than this the gains are held */
    double w1; /* weighted gain -0!*k1 */
    double u_max; /* bound of |u| */
} ptc_own_mu1_bisected;

/* Feedback gains at one time. */
typedef struct ptc_own_mu1_bisected_gains {
    double gain[1]; /* u = gain[0] x[0] + ... + gain[0] x[0] */
    double u_max; /* bound of |u| */
    ptc_status status; /* PTC_OK or PTC_HOLD */
} ptc_own_mu1_bisected_gains;

/*
 * Takes the parameters and arms at params.t0 (or the fixed t0). PTC_OK, or PTC_E_PARAM with *self
 * untouched.
 */
ptc_status ptc_own_mu1_bisected_init(
    ptc_own_mu1_bisected *self,
    const ptc_own_mu1_bisected_params *params);

/* Starts again at t0 [s]. PTC_OK, or PTC_E_PARAM with *self untouched. */
ptc_status ptc_own_mu1_bisected_arm(ptc_own_mu1_bisected *self, double t0);

/*
 * u at time t [s] and state x = (x1, x1', ...). On a negative status u is 0 and nothing has
 * changed. u must not overlap x.
 */
ptc_status ptc_own_mu1_bisected_step(
    const ptc_own_mu1_bisected *self,
    double t,
    const double x[1],
    double *u);

/*
 * The gains at time t [s], for several axes that share one deadline: tick once, then axis for each.
 * The result of tick and axis may differ from that of step in the last bits. On a negative status
 * *gains is unchanged.
 */
ptc_status ptc_own_mu1_bisected_tick(
    const ptc_own_mu1_bisected *self,
    double t,
    ptc_own_mu1_bisected_gains *gains);

/*
 * u of one axis from its state x = (x1, x1', ...) and the gains. On a negative status u is 0 and
 * nothing has changed. u must not overlap x.
 */
ptc_status ptc_own_mu1_bisected_axis(
    const ptc_own_mu1_bisected_gains *gains,
    const double x[1],
    double *u);

#ifdef __cplusplus
}
#endif

#endif
