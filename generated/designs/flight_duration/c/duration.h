/*
 * Prescribed-time controller duration: order n = 3, mapping tan.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 3 --mu tan --name duration --in-flight --precision f32 --u-max=100 --poles=-4,-5,-6
 * Version 0.1.0, design 3d20bda1c4e1.
 *
 * Plant: x1' = x2, ..., x3' = f + u. Time in s, x1 in any unit U, x2 in U/s, x3 in U/s^2, u
 *       in U/s^3.
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
 *   u_max = 100 [unit of u], fixed: bound of |u|
 *   k_1 = 120 [1/s^3], fixed: gain of xi_1
 *   k_2 = 74 [1/s^2], fixed: gain of xi_2
 *   k_3 = 15 [1/s], fixed: gain of xi_3
 *   tau: prescribed settling time [s], from 1e-18 to 1e18
 *   t0: start time [s], finite
 *   eps: time-to-go at which the gains are held [s], >= 1e-18, < tau
 *   a: rate of stretched time [1/s], from 1e-18 to 1e18
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
 * Matrix BB_n, entry (i,j) = B_{i-1,j-1}(r_1, ...), and its next row b_n; zeros are left out:
 *   B_{0,0} = 1
 *   B_{1,1} = 2*pi^-1*tau*a*V
 *   B_{2,1} = -4*pi^-1*tau*a^2*y*V^2
 *   B_{2,2} = 4*pi^-2*tau^2*a^2*V^2
 *   B_{3,1} = 12*pi^-1*tau*a^3*y^2*V^3 - 4*pi^-1*tau*a^3*V^3
 *   B_{3,2} = -24*pi^-2*tau^2*a^3*y*V^3
 *
 * Law, Theorem 1, with xi = BB_n x and t_kappa = kappa(Dt) + t0:
 *   u = kappa'^n (pi0(xi, t_kappa) - b_n^T x)
 *   pi0 = -(k_1 xi_1 + ... + k_3 xi_3)
 *   u = sum_j gain_j x_j
 *   gain_j = row_j
 *   K1, K2, ...: K_i = k_i/a^(n+1-i)
 *   row_1 = -K1*slope^3
 *   row_2 = -4*pi^-2*tau^2*K2*cot_rate^4 + 4*pi^-1*tau*K3*cot_rate^3 + pi*tau^-1*K3*cot_rate
 *       + 1/2*pi^2*tau^-2 - 1/4*pi^2*tau^-2*K2 - 2*K2*cot_rate^2 - 6*cot_rate^2
 *   row_3 = -2*pi^-1*tau*K3*cot_rate^2 - 1/2*pi*tau^-1*K3 + 6*cot_rate
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
 * Precision f32 (IEEE 754 binary32). Results are bit for bit the same on every IEEE 754
 *       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
 *
 * Checks of the design (details: ptc-codegen check):
 *   membership: sound: tan is of class M for all its parameters.
 *   growth: sound: x and u go to 0 at the deadline.
 *   sampling: not checked: `sample_time` is not given.
 *   deadline: not checked: `error` is not given.
 *   loop: not checked: it needs a value of `tau`.
 *   envelope: not checked: `x_max` is not given.
 *
 * Operations of one step, without input checks and clipping: 21 additions or comparisons, 28
 *       multiplications, 1 division.
 */
#ifndef DURATION_E06CBC72_H
#define DURATION_E06CBC72_H

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
typedef struct duration_params {
    float tau; /* prescribed settling time [s], from 1e-18 to 1e18 */
    float t0; /* start time [s], finite */
    float eps; /* time-to-go at which the gains are held [s], >= 1e-18, < tau */
    float a; /* rate of stretched time [1/s], from 1e-18 to 1e18 */
} duration_params;

/* Controller: set by init, changed by arm and by what takes it without const. */
typedef struct duration {
    float c1_3; /* coefficient of slope^3 in the gain of x1 */
    float tau; /* prescribed settling time */
    float angle_rate; /* pi/(2*tau) */
    float inv_angle_rate; /* 2*tau/pi */
    float t0; /* start time */
    float deadline; /* t0 + tau, rounded */
    float correction; /* low part of t0 + tau (compensated sum) */
    float eps; /* time-to-go at which the gains are held */
    float hold_from; /* -eps: later than this the gains are held */
    float inv_tau; /* 1/tau */
    float f69; /* derived from the parameters */
    float c2_0; /* coefficient of cot_rate^0 in the gain of x2 */
    float f73; /* derived from the parameters */
    float c2_1; /* coefficient of cot_rate^1 in the gain of x2 */
    float c2_2; /* coefficient of cot_rate^2 in the gain of x2 */
    float f81; /* derived from the parameters */
    float c2_3; /* coefficient of cot_rate^3 in the gain of x2 */
    float f85; /* derived from the parameters */
    float c2_4; /* coefficient of cot_rate^4 in the gain of x2 */
    float f99; /* derived from the parameters */
    float c3_0; /* coefficient of cot_rate^0 in the gain of x3 */
    float f103; /* derived from the parameters */
    float c3_2; /* coefficient of cot_rate^2 in the gain of x3 */
} duration;

/* Feedback gains at one time. */
typedef struct duration_gains {
    float gain[3]; /* u = gain[0] x[0] + ... + gain[2] x[2] */
    ptc_status status; /* PTC_OK or PTC_HOLD */
} duration_gains;

/*
 * Takes the parameters and arms at params.t0 (or the fixed t0) for params.tau. PTC_OK, or
 * PTC_E_PARAM with *self untouched.
 */
ptc_status duration_init(duration *self, const duration_params *params);

/* Starts again at t0 [s], with the tau last used. PTC_OK, or PTC_E_PARAM with *self untouched. */
ptc_status duration_arm(duration *self, float t0);

/*
 * Starts again at t0 [s] with another duration tau [s]: the deadline is t0 + tau. PTC_OK, or
 * PTC_E_PARAM with *self untouched.
 */
ptc_status duration_arm_for(duration *self, float t0, float tau);

/*
 * u at time t [s] and state x = (x1, x1', ...). On a negative status u is 0 and nothing has
 * changed. u must not overlap x.
 */
ptc_status duration_step(const duration *self, float t, const float x[3], float *u);

/*
 * The gains at time t [s], for several axes that share one deadline: tick once, then axis for each.
 * The result of tick and axis may differ from that of step in the last bits. On a negative status
 * *gains is unchanged.
 */
ptc_status duration_tick(const duration *self, float t, duration_gains *gains);

/*
 * u of one axis from its state x = (x1, x1', ...) and the gains. On a negative status u is 0 and
 * nothing has changed. u must not overlap x.
 */
ptc_status duration_axis(const duration_gains *gains, const float x[3], float *u);

#ifdef __cplusplus
}
#endif

#endif
