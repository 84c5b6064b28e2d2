/*
 * Prescribed-time controller ptc_exp3_fixed: order n = 3, mapping exp.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 3 --mu "exp(a=1)" --name ptc_exp3_fixed --tau=2 --t0=0 --eps=1e-3 --u-max=50 --gains=120,74,15
 * Version 0.1.0, design 378d89b0aa5f.
 *
 * Plant: x1' = x2, ..., x3' = f + u. Time in s, x1 in any unit U, x2 in U/s, x3 in U/s^2, u
 *       in U/s^3.
 * Goal: x = 0 at the deadline t0 + tau from any state at t0, up to the error that the hold at
 *       eps, sampling, f and clipping leave. The checks below say what is known of this
 *       design.
 * f is not part of the law: cancel its known terms before the call.
 *
 * SAMPLE PERIOD NOT GIVEN: with the gains held at eps = 1e-3 s, the loop with f = 0 and a
 *       zero-order hold is stable only for sample periods below 1.7e-4 s.
 *
 * Parameters:
 *   tau = 2 [s], fixed: prescribed settling time
 *   t0 = 0 [s], fixed: start time
 *   eps = 1e-3 [s], fixed: time-to-go at which the gains are held
 *   u_max = 50 [unit of u], fixed: bound of |u|
 *   a = 1 [1/s], fixed: rate of stretched time
 *   k_1 = 120 [1/s^3], fixed: gain of xi_1
 *   k_2 = 74 [1/s^2], fixed: gain of xi_2
 *   k_3 = 15 [1/s], fixed: gain of xi_3
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
 *   u = kappa'^n (pi0(xi, t_kappa) - b_n^T x)
 *   pi0 = -(k_1 xi_1 + ... + k_3 xi_3)
 *   u = sum_j gain_j x_j
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
 *   loop: not checked: `sample_time` is not given.
 *   envelope: not checked: `x_max` is not given.
 *
 * Operations of one step, without input checks and clipping: 5 additions or comparisons, 6
 *       multiplications, 1 division.
 */
#ifndef PTC_EXP3_FIXED_14DAD7C9_H
#define PTC_EXP3_FIXED_14DAD7C9_H

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
typedef struct ptc_exp3_fixed_params {
    char none; /* every parameter is fixed */
} ptc_exp3_fixed_params;

/* Controller: set by init, changed by arm and by what takes it without const. */
typedef struct ptc_exp3_fixed {
    double t0; /* start time */
    double deadline; /* t0 + tau, rounded */
    double correction; /* low part of t0 + tau (compensated sum) */
} ptc_exp3_fixed;

/* Feedback gains at one time. */
typedef struct ptc_exp3_fixed_gains {
    double gain[3]; /* u = gain[0] x[0] + ... + gain[2] x[2] */
    ptc_status status; /* PTC_OK or PTC_HOLD */
} ptc_exp3_fixed_gains;

/*
 * Takes the parameters and arms at params.t0 (or the fixed t0). PTC_OK, or PTC_E_PARAM with *self
 * untouched.
 */
ptc_status ptc_exp3_fixed_init(ptc_exp3_fixed *self, const ptc_exp3_fixed_params *params);

/* Starts again at t0 [s]. PTC_OK, or PTC_E_PARAM with *self untouched. */
ptc_status ptc_exp3_fixed_arm(ptc_exp3_fixed *self, double t0);

/*
 * u at time t [s] and state x = (x1, x1', ...). On a negative status u is 0 and nothing has
 * changed. u must not overlap x.
 */
ptc_status ptc_exp3_fixed_step(const ptc_exp3_fixed *self, double t, const double x[3], double *u);

/*
 * The gains at time t [s], for several axes that share one deadline: tick once, then axis for each.
 * The result of tick and axis may differ from that of step in the last bits. On a negative status
 * *gains is unchanged.
 */
ptc_status ptc_exp3_fixed_tick(const ptc_exp3_fixed *self, double t, ptc_exp3_fixed_gains *gains);

/*
 * u of one axis from its state x = (x1, x1', ...) and the gains. On a negative status u is 0 and
 * nothing has changed. u must not overlap x.
 */
ptc_status ptc_exp3_fixed_axis(const ptc_exp3_fixed_gains *gains, const double x[3], double *u);

#ifdef __cplusplus
}
#endif

#endif
