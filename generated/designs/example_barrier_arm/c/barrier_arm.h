/*
 * Prescribed-time controller barrier_arm: outputs of order 2, 2, mapping rational.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --mu "rational(a=1/20)" --name barrier_arm --tau=20 --eps=1 --limits=120,60 --pi0="inverse_inertia_1_1*(h*sin(q2)*(2*xi2_1*xi2_2 + xi2_2^2) - k*xi1_1/(1 - (xi1_1/b1)^2) - d*xi2_1) + inverse_inertia_1_2*(-h*sin(q2)*xi2_1^2 - k*xi1_2/(1 - (xi1_2/b2)^2) - d*xi2_2), inverse_inertia_1_2*(h*sin(q2)*(2*xi2_1*xi2_2 + xi2_2^2) - k*xi1_1/(1 - (xi1_1/b1)^2) - d*xi2_1) + inverse_inertia_2_2*(-h*sin(q2)*xi2_1^2 - k*xi1_2/(1 - (xi1_2/b2)^2) - d*xi2_2)" --states="q1, q2, w1, w2" --inputs=M1,M2 --inertia="[[(m1 + m2)*l1^2 + m2*l2^2 + 2*m2*l1*l2*cos(q2), m2*l2^2 + m2*l1*l2*cos(q2)], [m2*l2^2 + m2*l1*l2*cos(q2), m2*l2^2]]" --bias="-m2*l1*l2*sin(q2)*(2*w1*w2 + w2^2) + (m1 + m2)*grav*l1*cos(q1) + m2*grav*l2*cos(q1 + q2), m2*l1*l2*sin(q2)*w1^2 + m2*grav*l2*cos(q1 + q2)" --param b1=1.2 --param b2=0.8 --param d=4 --param grav=9.81 --param h=0.45 --param k=3 --param l1=0.6 --param l2=0.5 --param m1=2 --param m2=1.5
 * Version 0.1.0, design 13fc70a766af.
 *
 * Plant, with the inputs M1, M2: q = (q1, q2), q' = (w1, w2), M q'' + bias = u, M = [[(m1 +
 *       m2)*l1^2 + m2*l2^2 + 2*m2*l1*l2*cos(q2), m2*l2^2 + m2*l1*l2*cos(q2)], [m2*l2^2 +
 *       m2*l1*l2*cos(q2), m2*l2^2]], bias = [-m2*l1*l2*sin(q2)*(2*w1*w2 + w2^2) + (m1 +
 *       m2)*grav*l1*cos(q1) + m2*grav*l2*cos(q1 + q2), m2*l1*l2*sin(q2)*w1^2 +
 *       m2*grav*l2*cos(q1 + q2)]. Time in s.
 * Goal: every output with its derivatives is 0 at the deadline t0 + tau from any state at t0,
 *       up to the error that the hold at eps, sampling, what differs from the model and
 *       clipping leave. The checks below say what is known of this design.
 * The law takes the plant to be the model. What differs from it is not part of the law.
 * Outputs: 2, each with a law of its own, with this deadline and mapping; u_max is of the
 *       input of this number.
 *   output 1: u_max = 120
 *   output 2: u_max = 60
 *
 * SAMPLE PERIOD NOT GIVEN: the gain held at eps limits the sample period for which the loop
 *       is stable. Run the emitted step with a model of the plant, sampled.
 *
 * Parameters:
 *   tau = 20 [s], fixed: prescribed settling time
 *   eps = 1 [s], fixed: time-to-go at which the gains are held
 *   a = 1/20 [1/s], fixed: rate of stretched time
 *   b1 = 1.2, fixed: parameter of pi0
 *   b2 = 0.8, fixed: parameter of pi0
 *   d = 4, fixed: parameter of pi0
 *   grav = 9.81, fixed: parameter of the model
 *   h = 0.45, fixed: parameter of pi0
 *   k = 3, fixed: parameter of pi0
 *   l1 = 0.6, fixed: parameter of pi0 and the model
 *   l2 = 0.5, fixed: parameter of pi0 and the model
 *   m1 = 2, fixed: parameter of pi0 and the model
 *   m2 = 1.5, fixed: parameter of pi0 and the model
 *   t0: start time [s], finite
 *
 * Time mapping, with time-to-go T = t0 + tau - t and elapsed time Dt = t - t0; t in mu(t) is
 *       the stretched time since t0:
 *   mu(t)     = tau*a*t/(1 + a*t)
 *   kappa(Dt) = Dt/(a*T)
 * Derivatives r_k = mu^(k)(kappa(Dt)):
 *   r_k = (-1)^(k-1) k! (a/tau)^k T^(k+1)
 *   r_1 = tau^-1*a*T^2
 *   r_2 = -2*tau^-2*a^2*T^3
 * Matrix BB_n, entry (i,j) = B_{i-1,j-1}(r_1, ...), and its next row b_n; zeros are left out:
 *   B_{0,0} = 1
 *   B_{1,1} = tau^-1*a*T^2
 *   B_{2,1} = -2*tau^-2*a^2*T^3
 *
 * Law of each output, Theorem 1, with xi = BB_n x and t_kappa = kappa(Dt) + t0:
 *   v_i = kappa'^n (pi0(xi, t_kappa) - b_n^T x)
 *   pi0 of v_1 = inverse_inertia_1_1*(h*sin(q2)*(2*xi2_1*xi2_2 + xi2_2^2) - k*xi1_1/(1 -
 *       (xi1_1/b1)^2) - d*xi2_1) + inverse_inertia_1_2*(-h*sin(q2)*xi2_1^2 - k*xi1_2/(1 -
 *       (xi1_2/b2)^2) - d*xi2_2)
 *   pi0 of v_2 = inverse_inertia_1_2*(h*sin(q2)*(2*xi2_1*xi2_2 + xi2_2^2) - k*xi1_1/(1 -
 *       (xi1_1/b1)^2) - d*xi2_1) + inverse_inertia_2_2*(-h*sin(q2)*xi2_1^2 - k*xi1_2/(1 -
 *       (xi1_2/b2)^2) - d*xi2_2)
 *   xi_i = sum_j (i-1)!/(j-1)! r_1^(j-1) [z^(i-1)] p(z)^(j-1) x_j
 *   p(z) = z + sum_{l>=2} r_l/(r_1 l!) z^l, where [z^i] takes the coefficient of z^i
 * Output 1, of order n = 2:
 *   x_1 = q1
 *   x_2 = w1
 * Output 2, of order n = 2:
 *   x_1 = q2
 *   x_2 = w2
 * u = M v + bias
 *
 * From t0 + tau - eps on, and after the deadline, T is held at eps in the law (status HOLD).
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
 *   growth: not checked: the law is not a sum of gains, so its poles are not known.
 *   sampling: not checked: `sample_time` is not given.
 *   deadline: not checked: `error` is not given.
 *   loop: not checked: it needs a linear law.
 *   envelope: not checked: `x_max` is not given.
 *   zeros: sound: none: the relative degrees are 2, 2, whose sum is the number of states.
 *
 * Operations of one step, without input checks and clipping: 29 additions or comparisons, 52
 *       multiplications, 5 divisions, 4 function calls.
 */
#ifndef BARRIER_ARM_27239CA4_H
#define BARRIER_ARM_27239CA4_H

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
typedef struct barrier_arm_params {
    double t0; /* start time [s], finite */
} barrier_arm_params;

/* Controller: set by init, changed by arm and by what takes it without const. */
typedef struct barrier_arm {
    double t0; /* start time */
    double deadline; /* t0 + tau, rounded */
    double correction; /* low part of t0 + tau (compensated sum) */
} barrier_arm;

/*
 * Takes the parameters and arms at params.t0 (or the fixed t0). PTC_OK, or PTC_E_PARAM with *self
 * untouched.
 */
ptc_status barrier_arm_init(barrier_arm *self, const barrier_arm_params *params);

/* Starts again at t0 [s]. PTC_OK, or PTC_E_PARAM with *self untouched. */
ptc_status barrier_arm_arm(barrier_arm *self, double t0);

/*
 * u = (M1, M2) at time t [s] and state x = (q1, q2, w1, w2). Where one of them is not finite, as at
 * a state at which the inputs do not decouple the outputs, every u is 0; else the status is
 * SATURATED where one was clipped. u and axes must not overlap x.
 */
ptc_status barrier_arm_step(
    const barrier_arm *self,
    double t,
    const double x[4],
    double u[2],
    ptc_status axes[2]);

#ifdef __cplusplus
}
#endif

#endif
