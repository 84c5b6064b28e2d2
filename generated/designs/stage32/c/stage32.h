/*
 * Prescribed-time controller stage32: outputs of order 2, 2, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --mu exp --name stage32 --clock samples --tau=0.3 --eps=0.04 --states="q1, q2, w1, w2" --inputs=F1,F2 --inertia="[[m + q2^2, q2], [q2, 1]]" --bias="m*q2*w1*w2, w1^2/2 - q1" --reference="size*dt^2/(1 + t^2), 0" --sample-time=0.01
 * Version 0.1.0, design 241446d65458.
 *
 * Plant: the inputs F1, F2: q = (q1, q2), q' = (w1, w2), M q'' + bias = u, M = [[m + q2^2,
 *       q2], [q2, 1]], bias = [m*q2*w1*w2, w1^2/2 - q1]; u held from sample to sample.
 * Goal: every output with its derivatives is 0 at sample N after the start, from any state,
 *       as long as no u is clipped and the plant is the model. The plant is known at the
 *       samples alone, which leaves an error of order h^(n+2-i) in x_i of an output of order
 *       n.
 * Law of each output, of order n: with M - s samples to go and z = S x, v h^n = sum of row_j
 *       z_j h^(j-1)/((M-j+1)...(M-n+1)); the rows are those of Theorem 1 for the mapping exp.
 *       v_i is law_i in step. s = 0, 0. Output 1: Close to the end deadbeat takes over.
 *       Output 2: Close to the end deadbeat takes over.
 * Output 1, of order n = 2:
 *   x_1 = q1
 *   x_2 = w1
 * Output 2, of order n = 2:
 *   x_1 = q2
 *   x_2 = w2
 * u = M v + bias
 * With a reference r of each output, e_i = x_i - r^(i-1) is in place of x_i above, and law_i
 *       = v_i + rho of output i is in place of v_i. What r^(n) changes over a sample leaves
 *       an error of order h^(n+2-i) in e_i at sample N, h^3 for n = 1, and none where it is
 *       constant there.
 * t counts from the tick at which it was armed, and rho is r^(n) in the middle of the time in
 *       which u acts:
 *   of output 1: r = size*dt^2/(1 + t^2), r^(1) = 2*size*dt*(1 + t^2 - dt*t)/(1 + t^2)^2,
 *       r^(2) = 2*size*((1 + t^2)^2 + 4*dt^2*t^2 - 4*(1 + t^2)*dt*t - (1 + t^2)*dt^2)/(1 +
 *       t^2)^3
 *   of output 2: r = 0, r^(1) = 0, r^(2) = 0
 * Outputs: 2, each with a law of its own, with this deadline and mapping; u_max is of the
 *       input of this number.
 *
 * Parameters:
 *   samples = 30 [samples], fixed: samples N from the start to rest
 *   h = 0.01 [s], fixed: sample period
 *   eps = 0.04 [s], fixed: time-to-go at which the gains are held
 *   u_max [unit of u]: bound of |u|
 *   a [1/s]: rate of stretched time
 *   k_1 [1/s^2]: gains k_i of pi0 = -sum k_i xi_i
 *   k_2 [1/s]: gains k_i of pi0 = -sum k_i xi_i
 *   deadbeat [samples]: samples to go at which deadbeat takes over, 0 for a safe default
 *   m [as in its expression]: parameter of an expression of the design
 *   size [as in its expression]: parameter of an expression of the design
 *
 * k counts samples and may wrap; arm again within 2^32 - N samples.
 * From sample N on the last gains are held (status HOLD).
 * |u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
 *       lasts.
 * Guard full: what is measured is finite and no pointer is NULL, or the call is refused
 *       (status E_INPUT).
 * Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
 *       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
 *
 * Checks of the design (details: ptc-codegen check):
 *   membership: sound: exp is of class M for all its parameters.
 *   growth: sound: output 1: near rest at sample 30, not at rest: the gains are held from 4
 *       samples to go, and |u| is bounded; so does what f + g u and r do between samples.
 *   sampling: not checked: `loop` bounds what the period leaves of a plant with several
 *       inputs.
 *   deadline: not checked: `loop` bounds what the period leaves of a plant with several
 *       inputs.
 *   loop: not checked: `a` is left to run time.
 *   envelope: not checked: `x_max` is not given.
 *   zeros: sound: none: the relative degrees are 2, 2, whose sum is the number of states.
 */
#ifndef STAGE32_1793ABAC_H
#define STAGE32_1793ABAC_H

#include <stdint.h>

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
typedef struct stage32_params {
    double u_max; /* bound of |u| [unit of u], > 0, infinity allowed */
    double a; /* rate of stretched time [1/s], from 1e-150 to 1e150 */
    double k[2]; /* gains k_i of pi0 = -sum k_i xi_i [1/s^2], finite */
    double deadbeat; /* samples to go at which deadbeat takes over, 0 for a safe default [samples], finite */
    double m; /* parameter of an expression of the design [as in its expression], finite */
    double size; /* parameter of an expression of the design [as in its expression], finite */
} stage32_params;

/* Controller: set by init, changed by arm and by what takes it without const. */
typedef struct stage32 {
    uint32_t start; /* tick at which it was armed */
    double p_size; /* parameter of an expression of the design */
    double c_r3; /* derived from the parameters */
    double w1_1_1; /* weight of x1 in the law */
    double w1_2_1; /* weight of x2 in the law */
    double w2_2_1; /* weight of x2 in the law */
    double p_m; /* parameter of an expression of the design */
    double u_max; /* bound of |u| */
} stage32;

/* Takes the parameters and arms at tick 0. PTC_OK, or PTC_E_PARAM with *self untouched. */
ptc_status stage32_init(stage32 *self, const stage32_params *params);

/*
 * Starts again: the deadline is N samples after tick `k`. The time of the reference counts from
 * there.
 */
ptc_status stage32_arm(stage32 *self, uint32_t k);

/*
 * u = (F1, F2) from tick `k`, which may wrap, and state x = (q1, q2, w1, w2). Where one of them is
 * not finite, as at a state at which the inputs do not decouple the outputs, every u is 0; else the
 * status is SATURATED where one was clipped. u and axes must not overlap x.
 */
ptc_status stage32_step(
    const stage32 *self,
    uint32_t k,
    const double x[4],
    double u[2],
    ptc_status axes[2]);

#ifdef __cplusplus
}
#endif

#endif
