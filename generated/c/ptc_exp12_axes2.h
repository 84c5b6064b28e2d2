/*
 * Prescribed-time controller ptc_exp12_axes2: order n = 12, mapping exp.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 12 --axes 2 --mu exp --name ptc_exp12_axes2
 * Version 0.1.0, design 27250cbd8a20.
 *
 * Plant: x1' = x2, ..., x12' = f + u. Time in s, x1 in any unit U, x2 in U/s, ..., x12 in
 *       U/s^11, u in U/s^12.
 * Goal: x = 0 at the deadline t0 + tau from any state at t0, up to the error that the hold at
 *       eps, sampling, f and clipping leave. The checks below say what is known of this
 *       design.
 * f is not part of the law: cancel its known terms before the call.
 * Axes: 2, each a chain of its own with this deadline and mapping. step computes what depends
 *       on time once.
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
 *   k: gains of pi0 = -(k_1 xi_1 + ... + k_12 xi_12), finite; k[0] is k_1 [1/s^12], ...,
 *       k[11] is k_12 [1/s]
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
 *   r_4 = -a^4*T
 *   r_5 = a^5*T
 *   r_6 = -a^6*T
 * Matrix BB_n, entry (i,j) = B_{i-1,j-1}(r_1, ...), and its next row b_n; zeros are left out:
 *   B_{0,0} = 1
 *   B_{1,1} = a*T
 *   B_{2,1} = -a^2*T
 *   B_{2,2} = a^2*T^2
 *   B_{3,1} = a^3*T
 *   B_{3,2} = -3*a^3*T^2
 *   B_{3,3} = a^3*T^3
 *   B_{4,1} = -a^4*T
 *   B_{4,2} = 7*a^4*T^2
 *   B_{4,3} = -6*a^4*T^3
 *   B_{4,4} = a^4*T^4
 *   B_{5,1} = a^5*T
 *   B_{5,2} = -15*a^5*T^2
 *   B_{5,3} = 25*a^5*T^3
 *   B_{5,4} = -10*a^5*T^4
 *   B_{5,5} = a^5*T^5
 *   B_{6,1} = -a^6*T
 *   B_{6,2} = 31*a^6*T^2
 *   B_{6,3} = -90*a^6*T^3
 *   B_{6,4} = 65*a^6*T^4
 *   B_{6,5} = -15*a^6*T^5
 *   (to order 6; all of them: ptc-codegen show matrix --n 12 --mu exp)
 *
 * Law, Theorem 1, with xi = BB_n x and t_kappa = kappa(Dt) + t0:
 *   u = kappa'^n (pi0(xi, t_kappa) - b_n^T x)
 *   pi0 = -(k_1 xi_1 + ... + k_12 xi_12)
 *   u = sum_j gain_j x_j
 *   gain_j = inv_T^(n+1-j) row_j
 *   K1, K2, ...: K_i = k_i/a^(n+1-i)
 *   row_1 = -K1
 *   row_2 = 1 - K2 + K3 - K4 + K5 - K6 + K7 - K8 + K9 - K10 + K11 - K12
 *   row_3 = -2047 - K3 + 3*K4 - 7*K5 + 15*K6 - 31*K7 + 63*K8 - 127*K9 + 255*K10 - 511*K11 +
 *       1023*K12
 *   row_4 = 86526 - K4 + 6*K5 - 25*K6 + 90*K7 - 301*K8 + 966*K9 - 3025*K10 + 9330*K11 -
 *       28501*K12
 *   row_5 = -611501 - K5 + 10*K6 - 65*K7 + 350*K8 - 1701*K9 + 7770*K10 - 34105*K11 +
 *       145750*K12
 *   row_6 = 1379400 - K6 + 15*K7 - 140*K8 + 1050*K9 - 6951*K10 + 42525*K11 - 246730*K12
 *   inv_T = 1/T
 *   (the first 6; all of them: ptc-codegen show law --n 12 --mu exp)
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
 *   growth: not checked: the gains are left to run time: their poles must lie left of -n rho.
 *   sampling: not checked: `sample_time` is not given.
 *   deadline: not checked: `error` is not given.
 *   loop: not checked: it needs a value of `tau`.
 *   envelope: not checked: `x_max` is not given.
 *
 * Operations of one step, without input checks and clipping: 25 additions or comparisons, 52
 *       multiplications, 1 division.
 */
#ifndef PTC_EXP12_AXES2_E9137940_H
#define PTC_EXP12_AXES2_E9137940_H

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
typedef struct ptc_exp12_axes2_params {
    double tau; /* prescribed settling time [s], from 1e-150 to 1e150 */
    double t0; /* start time [s], finite */
    double eps; /* time-to-go at which the gains are held [s], >= 1e-150, < tau */
    double u_max; /* bound of |u| [unit of u], > 0, infinity allowed */
    double a; /* rate of stretched time [1/s], from 1e-150 to 1e150 */
    double k[12]; /* gains of pi0 = -(k_1 xi_1 + ... + k_12 xi_12), finite; k[0] is k_1 [1/s^12], ..., k[11] is k_12 [1/s] */
} ptc_exp12_axes2_params;

/* Controller: set by init, changed by arm and by what takes it without const. */
typedef struct ptc_exp12_axes2 {
    double c1; /* coefficient of x1 */
    double c2; /* coefficient of x2 */
    double c3; /* coefficient of x3 */
    double c4; /* coefficient of x4 */
    double c5; /* coefficient of x5 */
    double c6; /* coefficient of x6 */
    double c7; /* coefficient of x7 */
    double c8; /* coefficient of x8 */
    double c9; /* coefficient of x9 */
    double c10; /* coefficient of x10 */
    double c11; /* coefficient of x11 */
    double c12; /* coefficient of x12 */
    double t0; /* start time */
    double tau; /* prescribed settling time */
    double deadline; /* t0 + tau, rounded */
    double correction; /* low part of t0 + tau (compensated sum) */
    double eps; /* time-to-go at which the gains are held */
    double hold_from; /* -eps: later than this the gains are held */
    double u_max; /* bound of |u| */
} ptc_exp12_axes2;

/* Feedback gains at one time. */
typedef struct ptc_exp12_axes2_gains {
    double gain[12]; /* u = gain[0] x[0] + ... + gain[11] x[11] */
    double u_max; /* bound of |u| */
    ptc_status status; /* PTC_OK or PTC_HOLD */
} ptc_exp12_axes2_gains;

/*
 * Takes the parameters and arms at params.t0 (or the fixed t0). PTC_OK, or PTC_E_PARAM with *self
 * untouched.
 */
ptc_status ptc_exp12_axes2_init(ptc_exp12_axes2 *self, const ptc_exp12_axes2_params *params);

/* Starts again at t0 [s]. PTC_OK, or PTC_E_PARAM with *self untouched. */
ptc_status ptc_exp12_axes2_arm(ptc_exp12_axes2 *self, double t0);

/*
 * The gains at time t [s] for all axes, from which step computes u of each. On a negative status
 * *gains is unchanged.
 */
ptc_status ptc_exp12_axes2_tick(
    const ptc_exp12_axes2 *self,
    double t,
    ptc_exp12_axes2_gains *gains);

/*
 * u of one axis from its state x = (x1, x1', ...) and the gains. On a negative status u is 0 and
 * nothing has changed. u must not overlap x.
 */
ptc_status ptc_exp12_axes2_axis(const ptc_exp12_axes2_gains *gains, const double x[12], double *u);

/*
 * u of 2 axes at time t [s], from the state x = (x1, x1', ...) of each. Its status is that of the
 * first axis that fails, and then every u is 0; else SATURATED where an axis is. u and axes must
 * not overlap x.
 */
ptc_status ptc_exp12_axes2_step(
    const ptc_exp12_axes2 *self,
    double t,
    const double x[2][12],
    double u[2],
    ptc_status axes[2]);

#ifdef __cplusplus
}
#endif

#endif
