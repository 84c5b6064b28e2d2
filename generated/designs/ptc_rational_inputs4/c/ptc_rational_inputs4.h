/*
 * Prescribed-time controller ptc_rational_inputs4: outputs of order 1, 1, 1, 1, mapping rational.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --mu rational --name ptc_rational_inputs4 --states="p, q, r, s" --inputs=a,b,c,d --outputs="p, q, r, s" --dynamics="sin(q)*b + 3*c + r*d, 2*a + p*b + m*d + p*r, r*a + (3 + q^2)*b + s*c, a - p*c + 4*d" --allow=zeros
 * Version 0.1.0, design d53160516d12.
 *
 * Plant, with the inputs a, b, c, d: p' = sin(q)*b + 3*c + r*d, q' = 2*a + p*b + m*d + p*r,
 *       r' = r*a + (3 + q^2)*b + s*c, s' = a - p*c + 4*d, output 1 = p, output 2 = q, output
 *       3 = r, output 4 = s. Time in s.
 * Goal: every output with its derivatives is 0 at the deadline t0 + tau from any state at t0,
 *       up to the error that the hold at eps, sampling, what differs from the model and
 *       clipping leave. The checks below say what is known of this design.
 * The law takes the plant to be the model. What differs from it is not part of the law.
 * Outputs: 4, each with a law of its own, with this deadline and mapping; u_max is of the
 *       input of this number.
 *
 * SAMPLE PERIOD NOT GIVEN: the gain held at eps limits the sample period for which the loop
 *       is stable. Run the emitted step with a model of the plant, sampled.
 *
 * Parameters:
 *   tau: prescribed settling time [s], from 1e-150 to 1e150
 *   t0: start time [s], finite
 *   eps: time-to-go at which the gains are held [s], >= 1e-150, < tau
 *   u_max: bound of |u| [unit of u], > 0, infinity allowed
 *   a: rate of stretched time [1/s], from 1e-150 to 1e150
 *   k: gains of pi0 = -k_1 xi_1, finite; k[0] is k_1 [1/s]
 *   m: parameter of the model, finite
 *
 * Time mapping, with time-to-go T = t0 + tau - t and elapsed time Dt = t - t0; t in mu(t) is
 *       the stretched time since t0:
 *   mu(t)     = tau*a*t/(1 + a*t)
 *   kappa(Dt) = Dt/(a*T)
 * Derivatives r_k = mu^(k)(kappa(Dt)):
 *   r_k = (-1)^(k-1) k! (a/tau)^k T^(k+1)
 *   r_1 = tau^-1*a*T^2
 * Matrix BB_n, entry (i,j) = B_{i-1,j-1}(r_1, ...), and its next row b_n; zeros are left out:
 *   B_{0,0} = 1
 *
 * Law of each output, Theorem 1, with xi = BB_n x and t_kappa = kappa(Dt) + t0:
 *   v_i = kappa'^n (pi0(xi, t_kappa) - b_n^T x) = sum_j gain_j x_j
 *   pi0 = -k_1 xi_1
 *   gain_j = inv_T_squared^(n+1-j) row_j
 *   K1, K2, ...: K_i = k_i/(tau^-1*a)^(n+1-i)
 *   row_1 = -K1
 *   inv_T_squared = 1/T^2
 * Output 1, of order n = 1:
 *   x_1 = p
 * Output 2, of order n = 1:
 *   x_1 = q
 *   f_2 = p*r
 * Output 3, of order n = 1:
 *   x_1 = r
 * Output 4, of order n = 1:
 *   x_1 = s
 * u of D u = w with w_i = v_i - f_i, by elimination with pivots:
 *   D = [[0, sin(q), 3, r], [2, p, 0, m], [r, 3 + q^2, s, 0], [1, 0, -p, 4]]
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
 *   membership: sound: rational is of class M for all its parameters.
 *   growth: not checked: the gains are left to run time: their poles must lie left of -n rho.
 *   sampling: not checked: `sample_time` is not given.
 *   deadline: not checked: `error` is not given.
 *   loop: not checked: it needs a value of `tau`.
 *   envelope: not checked: `x_max` is not given.
 *   zeros: sound: none: the relative degrees are 1, 1, 1, 1, whose sum is the number of
 *       states.
 *
 * Operations of one step, without input checks and clipping: 38 additions or comparisons, 33
 *       multiplications, 14 divisions, 1 function call.
 */
#ifndef PTC_RATIONAL_INPUTS4_AF236304_H
#define PTC_RATIONAL_INPUTS4_AF236304_H

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
typedef struct ptc_rational_inputs4_params {
    double tau; /* prescribed settling time [s], from 1e-150 to 1e150 */
    double t0; /* start time [s], finite */
    double eps; /* time-to-go at which the gains are held [s], >= 1e-150, < tau */
    double u_max; /* bound of |u| [unit of u], > 0, infinity allowed */
    double a; /* rate of stretched time [1/s], from 1e-150 to 1e150 */
    double k[1]; /* gains of pi0 = -k_1 xi_1, finite; k[0] is k_1 [1/s] */
    double m; /* parameter of the model, finite */
} ptc_rational_inputs4_params;

/* Controller: set by init, changed by arm and by what takes it without const. */
typedef struct ptc_rational_inputs4 {
    double tau; /* prescribed settling time */
    double c1_axis1; /* coefficient of x1, axis 1 */
    double t0; /* start time */
    double deadline; /* t0 + tau, rounded */
    double correction; /* low part of t0 + tau (compensated sum) */
    double eps; /* time-to-go at which the gains are held */
    double hold_from; /* -eps: later than this the gains are held */
    double p_m; /* parameter of an expression of the design */
    double u_max; /* bound of |u| */
} ptc_rational_inputs4;

/*
 * Takes the parameters and arms at params.t0 (or the fixed t0). PTC_OK, or PTC_E_PARAM with *self
 * untouched.
 */
ptc_status ptc_rational_inputs4_init(
    ptc_rational_inputs4 *self,
    const ptc_rational_inputs4_params *params);

/* Starts again at t0 [s]. PTC_OK, or PTC_E_PARAM with *self untouched. */
ptc_status ptc_rational_inputs4_arm(ptc_rational_inputs4 *self, double t0);

/*
 * u = (a, b, c, d) at time t [s] and state x = (p, q, r, s). Where one of them is not finite, as at
 * a state at which the inputs do not decouple the outputs, every u is 0; else the status is
 * SATURATED where one was clipped. u and axes must not overlap x.
 */
ptc_status ptc_rational_inputs4_step(
    const ptc_rational_inputs4 *self,
    double t,
    const double x[4],
    double u[4],
    ptc_status axes[4]);

#ifdef __cplusplus
}
#endif

#endif
