/*
 * Prescribed-time controller track: order n = 2, mapping exp.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 2 --mu "exp(a=1)" --name track --tau=1 --t0=0 --eps=4.42e-2 --u-max=50 --poles=-4,-5 --g="2/3" --reference="1/10*sin(2*t + phase)" --param phase=0.3 --sample-time=1e-3 --error=1e-3,1e-2 --x0-max=0.5,0.5
 * Version 0.1.0, design fc9bf2044aac.
 *
 * Plant: x1' = x2, x2' = f + g u. Time in s, x1 in any unit U, x2 in U/s, g u in U/s^2.
 * Goal: x = (r, r', ...) of the reference r(t) at the deadline t0 + tau from any state at t0,
 *       up to the error that the hold at eps, sampling, f and clipping leave. The checks
 *       below say what is known of this design.
 * f is not part of the law: cancel its known terms before the call.
 *
 * Parameters:
 *   tau = 1 [s], fixed: prescribed settling time
 *   t0 = 0 [s], fixed: start time
 *   eps = 4.42e-2 [s], fixed: time-to-go at which the gains are held
 *   u_max = 50 [unit of u], fixed: bound of |u|
 *   a = 1 [1/s], fixed: rate of stretched time
 *   k_1 = 20 [1/s^2], fixed: gain of xi_1
 *   k_2 = 9 [1/s], fixed: gain of xi_2
 *   phase = 0.3, fixed: parameter of reference
 *
 * Time mapping, with time-to-go T = t0 + tau - t and elapsed time Dt = t - t0; t in mu(t) is
 *       the stretched time since t0:
 *   mu(t)     = tau*(1 - exp(-a*t))
 *   kappa(Dt) = -ln(T/tau)/a
 * Derivatives r_k = mu^(k)(kappa(Dt)):
 *   r_k = (-1)^(k-1) a^k T
 *   r_1 = a*T
 *   r_2 = -a^2*T
 * Matrix BB_n, entry (i,j) = B_{i-1,j-1}(r_1, ...), and its next row b_n; zeros are left out:
 *   B_{0,0} = 1
 *   B_{1,1} = a*T
 *   B_{2,1} = -a^2*T
 *
 * Law, Theorem 1, with xi = BB_n e and t_kappa = kappa(Dt) + t0:
 *   u = (kappa'^n (pi0(xi, t_kappa) - b_n^T e) + r^(2))/g
 *   pi0 = -(k_1 xi_1 + k_2 xi_2)
 *   e_i = x_i - r^(i-1), with the reference r = 1/10*sin(2*t + phase)
 *   r^(1) = cos(phase + 2*t)/5
 *   r^(2) = -2*sin(phase + 2*t)/5
 *   g = 2/3
 *   u = (sum_j gain_j e_j + r^(2))/g
 *   gain_j = inv_T^(n+1-j) row_j
 *   K1, K2, ...: K_i = k_i/a^(n+1-i)
 *   row_1 = -K1
 *   row_2 = 1 - K2
 *   inv_T = 1/T
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
 *   membership: sound: exp is of class M for all its parameters.
 *   growth: sound: x and u go to 0 at the deadline.
 *   sampling: undecided: r is known at the samples alone; with a constant r: eps = 0.0442 s
 *       is 11.05 times the minimum for a period of 0.001 s.
 *   deadline: sound: |x| <= 0.001 for every eps <= 0.04437 s.
 *   loop: not checked: the plant follows a reference that moves between the samples at which
 *       it is known, and what that leaves is not examined.
 *   envelope: not checked: `x_max` is not given.
 *
 * Operations of one step, without input checks and clipping: 8 additions or comparisons, 9
 *       multiplications, 1 division, 2 function calls.
 */
#ifndef TRACK_7958DFDD_H
#define TRACK_7958DFDD_H

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
typedef struct track_params {
    char none; /* every parameter is fixed */
} track_params;

/* Controller: set by init, changed by arm and by what takes it without const. */
typedef struct track {
    double t0; /* start time */
    double deadline; /* t0 + tau, rounded */
    double correction; /* low part of t0 + tau (compensated sum) */
} track;

/*
 * Takes the parameters and arms at params.t0 (or the fixed t0). PTC_OK, or PTC_E_PARAM with *self
 * untouched.
 */
ptc_status track_init(track *self, const track_params *params);

/* Starts again at t0 [s]. PTC_OK, or PTC_E_PARAM with *self untouched. */
ptc_status track_arm(track *self, double t0);

/*
 * u at time t [s] and state x = (x1, x1', ...). On a negative status u is 0 and nothing has
 * changed. u must not overlap x.
 */
ptc_status track_step(const track *self, double t, const double x[2], double *u);

#ifdef __cplusplus
}
#endif

#endif
