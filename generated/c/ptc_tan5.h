/*
 * Prescribed-time controller ptc_tan5: order n = 5, mapping tan.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 5 --mu tan
 * Version 0.1.0, design b3d0266958f3.
 *
 * Plant: x1' = x2, ..., x5' = f + u. Time in s, x1 in any unit U, x2 in U/s, ..., x5 in
 *       U/s^4, u in U/s^5.
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
 *   k: gains of pi0 = -(k_1 xi_1 + ... + k_5 xi_5), finite; k[0] is k_1 [1/s^5], ..., k[4] is
 *       k_5 [1/s]
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
 *   r_3 = 12*pi^-1*tau*a^3*y^2*V^3 - 4*pi^-1*tau*a^3*V^3
 *   r_4 = 48*pi^-1*tau*a^4*y*V^4 - 48*pi^-1*tau*a^4*y^3*V^4
 *   r_5 = -480*pi^-1*tau*a^5*y^2*V^5 + 240*pi^-1*tau*a^5*y^4*V^5 + 48*pi^-1*tau*a^5*V^5
 * Matrix BB_n, entry (i,j) = B_{i-1,j-1}(r_1, ...), and its next row b_n; zeros are left out:
 *   B_{0,0} = 1
 *   B_{1,1} = 2*pi^-1*tau*a*V
 *   B_{2,1} = -4*pi^-1*tau*a^2*y*V^2
 *   B_{2,2} = 4*pi^-2*tau^2*a^2*V^2
 *   B_{3,1} = 12*pi^-1*tau*a^3*y^2*V^3 - 4*pi^-1*tau*a^3*V^3
 *   B_{3,2} = -24*pi^-2*tau^2*a^3*y*V^3
 *   B_{3,3} = 8*pi^-3*tau^3*a^3*V^3
 *   B_{4,1} = 48*pi^-1*tau*a^4*y*V^4 - 48*pi^-1*tau*a^4*y^3*V^4
 *   B_{4,2} = 144*pi^-2*tau^2*a^4*y^2*V^4 - 32*pi^-2*tau^2*a^4*V^4
 *   B_{4,3} = -96*pi^-3*tau^3*a^4*y*V^4
 *   B_{4,4} = 16*pi^-4*tau^4*a^4*V^4
 *   B_{5,1} = -480*pi^-1*tau*a^5*y^2*V^5 + 240*pi^-1*tau*a^5*y^4*V^5 + 48*pi^-1*tau*a^5*V^5
 *   B_{5,2} = 640*pi^-2*tau^2*a^5*y*V^5 - 960*pi^-2*tau^2*a^5*y^3*V^5
 *   B_{5,3} = 960*pi^-3*tau^3*a^5*y^2*V^5 - 160*pi^-3*tau^3*a^5*V^5
 *   B_{5,4} = -320*pi^-4*tau^4*a^5*y*V^5
 *
 * Law, Theorem 1, with xi = BB_n x and t_kappa = kappa(Dt) + t0:
 *   u = kappa'^n (pi0(xi, t_kappa) - b_n^T x)
 *   pi0 = -(k_1 xi_1 + ... + k_5 xi_5)
 *   u = sum_j gain_j x_j
 *   gain_j = row_j
 *   K1, K2, ...: K_i = k_i/a^(n+1-i)
 *   row_1 = -K1*slope^5
 *   row_2 = -16*pi^-4*tau^4*K2*cot_rate^8 + 16*pi^-3*tau^3*K3*cot_rate^7 -
 *       16*pi^-2*tau^2*K2*cot_rate^6 - 24*pi^-2*tau^2*K4*cot_rate^6 +
 *       12*pi^-1*tau*K3*cot_rate^5 + 48*pi^-1*tau*K5*cot_rate^5 + 3*pi*tau^-1*K3*cot_rate^3 -
 *       pi^2*tau^-2*K2*cot_rate^2 - 1/2*pi^2*tau^-2*K4*cot_rate^2 + 60*pi^2*tau^-2*cot_rate^2
 *       + 1/4*pi^3*tau^-3*K3*cot_rate - 3*pi^3*tau^-3*K5*cot_rate - 3/2*pi^4*tau^-4 -
 *       1/16*pi^4*tau^-4*K2 + 1/8*pi^4*tau^-4*K4 - 6*K2*cot_rate^4 - 10*K4*cot_rate^4 -
 *       120*cot_rate^4
 *   row_3 = -8*pi^-3*tau^3*K3*cot_rate^6 + 24*pi^-2*tau^2*K4*cot_rate^5 -
 *       6*pi^-1*tau*K3*cot_rate^4 - 72*pi^-1*tau*K5*cot_rate^4 - 3/2*pi*tau^-1*K3*cot_rate^2
 *       - 14*pi*tau^-1*K5*cot_rate^2 + 3/2*pi^2*tau^-2*K4*cot_rate - 40*pi^2*tau^-2*cot_rate
 *       - 1/8*pi^3*tau^-3*K3 + pi^3*tau^-3*K5 + 12*K4*cot_rate^3 + 240*cot_rate^3
 *   row_4 = -4*pi^-2*tau^2*K4*cot_rate^4 + 24*pi^-1*tau*K5*cot_rate^3 +
 *       6*pi*tau^-1*K5*cot_rate + 5*pi^2*tau^-2 - 1/4*pi^2*tau^-2*K4 - 2*K4*cot_rate^2 -
 *       120*cot_rate^2
 *   row_5 = -2*pi^-1*tau*K5*cot_rate^2 - 1/2*pi*tau^-1*K5 + 20*cot_rate
 *   cot_rate = (pi/(2*tau))*y = (pi/(2*tau))*cot(th)
 *   slope = (pi/(2*tau))*(1 + y^2) = kappa'/a
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
 *   membership: sound: tan is of class M for all its parameters.
 *   growth: not checked: the gains are left to run time: their poles must lie left of -n rho.
 *   sampling: not checked: `sample_time` is not given.
 *   deadline: not checked: `error` is not given.
 *   loop: not checked: it needs a value of `tau`.
 *   envelope: not checked: `x_max` is not given.
 *
 * Operations of one step, without input checks and clipping: 44 additions or comparisons, 52
 *       multiplications, 1 division.
 */
#ifndef PTC_TAN5_0E2656AA_H
#define PTC_TAN5_0E2656AA_H

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
typedef struct ptc_tan5_params {
    double tau; /* prescribed settling time [s], from 1e-150 to 1e150 */
    double t0; /* start time [s], finite */
    double eps; /* time-to-go at which the gains are held [s], >= 1e-150, < tau */
    double u_max; /* bound of |u| [unit of u], > 0, infinity allowed */
    double a; /* rate of stretched time [1/s], from 1e-150 to 1e150 */
    double k[5]; /* gains of pi0 = -(k_1 xi_1 + ... + k_5 xi_5), finite; k[0] is k_1 [1/s^5], ..., k[4] is k_5 [1/s] */
} ptc_tan5_params;

/* Controller: set by init, changed by arm and by what takes it without const. */
typedef struct ptc_tan5 {
    double c1_5; /* coefficient of slope^5 in the gain of x1 */
    double tau; /* prescribed settling time */
    double angle_rate; /* pi/(2*tau) */
    double inv_angle_rate; /* 2*tau/pi */
    double t0; /* start time */
    double deadline; /* t0 + tau, rounded */
    double correction; /* low part of t0 + tau (compensated sum) */
    double eps; /* time-to-go at which the gains are held */
    double hold_from; /* -eps: later than this the gains are held */
    double inv_tau; /* 1/tau */
    double c2_0; /* coefficient of cot_rate^0 in the gain of x2 */
    double c2_1; /* coefficient of cot_rate^1 in the gain of x2 */
    double c2_2; /* coefficient of cot_rate^2 in the gain of x2 */
    double c2_3; /* coefficient of cot_rate^3 in the gain of x2 */
    double c2_4; /* coefficient of cot_rate^4 in the gain of x2 */
    double c2_5; /* coefficient of cot_rate^5 in the gain of x2 */
    double c2_6; /* coefficient of cot_rate^6 in the gain of x2 */
    double c2_7; /* coefficient of cot_rate^7 in the gain of x2 */
    double c2_8; /* coefficient of cot_rate^8 in the gain of x2 */
    double c3_0; /* coefficient of cot_rate^0 in the gain of x3 */
    double c3_1; /* coefficient of cot_rate^1 in the gain of x3 */
    double c3_2; /* coefficient of cot_rate^2 in the gain of x3 */
    double c3_3; /* coefficient of cot_rate^3 in the gain of x3 */
    double c3_4; /* coefficient of cot_rate^4 in the gain of x3 */
    double c3_5; /* coefficient of cot_rate^5 in the gain of x3 */
    double c3_6; /* coefficient of cot_rate^6 in the gain of x3 */
    double c4_0; /* coefficient of cot_rate^0 in the gain of x4 */
    double c4_1; /* coefficient of cot_rate^1 in the gain of x4 */
    double c4_2; /* coefficient of cot_rate^2 in the gain of x4 */
    double c4_3; /* coefficient of cot_rate^3 in the gain of x4 */
    double c4_4; /* coefficient of cot_rate^4 in the gain of x4 */
    double c5_0; /* coefficient of cot_rate^0 in the gain of x5 */
    double c5_2; /* coefficient of cot_rate^2 in the gain of x5 */
    double u_max; /* bound of |u| */
} ptc_tan5;

/* Feedback gains at one time. */
typedef struct ptc_tan5_gains {
    double gain[5]; /* u = gain[0] x[0] + ... + gain[4] x[4] */
    double u_max; /* bound of |u| */
    ptc_status status; /* PTC_OK or PTC_HOLD */
} ptc_tan5_gains;

/*
 * Takes the parameters and arms at params.t0 (or the fixed t0). PTC_OK, or PTC_E_PARAM with *self
 * untouched.
 */
ptc_status ptc_tan5_init(ptc_tan5 *self, const ptc_tan5_params *params);

/* Starts again at t0 [s]. PTC_OK, or PTC_E_PARAM with *self untouched. */
ptc_status ptc_tan5_arm(ptc_tan5 *self, double t0);

/*
 * u at time t [s] and state x = (x1, x1', ...). On a negative status u is 0 and nothing has
 * changed. u must not overlap x.
 */
ptc_status ptc_tan5_step(const ptc_tan5 *self, double t, const double x[5], double *u);

/*
 * The gains at time t [s], for several axes that share one deadline: tick once, then axis for each.
 * The result of tick and axis may differ from that of step in the last bits. On a negative status
 * *gains is unchanged.
 */
ptc_status ptc_tan5_tick(const ptc_tan5 *self, double t, ptc_tan5_gains *gains);

/*
 * u of one axis from its state x = (x1, x1', ...) and the gains. On a negative status u is 0 and
 * nothing has changed. u must not overlap x.
 */
ptc_status ptc_tan5_axis(const ptc_tan5_gains *gains, const double x[5], double *u);

#ifdef __cplusplus
}
#endif

#endif
