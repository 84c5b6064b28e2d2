/*
 * Prescribed-time controller stage36: outputs of order 2, 2, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --mu exp --name stage36 --clock samples --precision f32 --eps=0 --states="q1, q2, w1, w2" --inputs=F1,F2 --inertia="[[2, 1/2], [1/2, 1]]" --bias="3*q1 - c*q2 + w1/4, c*q2" --param c=2 --sample-time=0.02
 * Version 0.1.0, design 9c23f2154001.
 *
 * Plant: the inputs F1, F2: q = (q1, q2), q' = (w1, w2), M q'' + bias = u, M = [[2, 1/2],
 *       [1/2, 1]], bias = [3*q1 - c*q2 + w1/4, c*q2]; u held from sample to sample.
 * Goal: x = 0 at sample N after the start, exact up to rounding, from any state, as long as
 *       no u is clipped and nothing else acts on the plant.
 * Law of each output, of order n, in its chain xi as it is sampled, which is the output with
 *       its derivatives up to O(h), and which held inputs move exactly: with M - s samples to
 *       go and z = S xi, v h^n = sum of row_j z_j h^(j-1)/((M-j+1)...(M-n+1)); the rows are
 *       those of Theorem 1 for the mapping exp. xi_j of output i is xj_i in step, and v_i is
 *       law_i. s = 0, 0. Output 1: Close to the end deadbeat takes over. Output 2: Close to
 *       the end deadbeat takes over.
 * Output 1, of order n = 2, to four digits:
 *   xi_1 = q1 - 4.762e-6*w1 + 5.443e-11*w2
 *   xi_2 = w1 - 5.715e-5*w2
 *   f_1 = -1.712*q1 + 1.712*q2 - 0.1598*w1 + 0.01713*w2
 * Output 2, of order n = 2, to four digits:
 *   xi_1 = q2 + 2.381e-6*w1 - 2.722e-11*w2
 *   xi_2 = -2.858e-5*w1 + w2
 *   f_2 = 0.8558*q1 - 2.856*q2 + 0.07988*w1 - 0.02856*w2
 * u = G^-1 w with w_i = v_i - f_i, to four digits:
 *   G^-1 = [[2.003, 0.4999], [0.5, 1]]
 * Outputs: 2, each with a law of its own, with this deadline and mapping; u_max is of the
 *       input of this number.
 *
 * Parameters:
 *   samples [samples]: samples N from the start to rest
 *   h = 0.02 [s], fixed: sample period
 *   eps = 0 [s], fixed: time-to-go at which the gains are held
 *   u_max [unit of u]: bound of |u|
 *   a [1/s]: rate of stretched time
 *   k_1 [1/s^2]: gains k_i of pi0 = -sum k_i xi_i
 *   k_2 [1/s]: gains k_i of pi0 = -sum k_i xi_i
 *   deadbeat [samples]: samples to go at which deadbeat takes over, 0 for a safe default
 *   c = 2 [as in its expression], fixed: parameter of an expression of the design
 *
 * k counts samples and may wrap; arm again within 2^32 - N samples.
 * From sample N on the last gains are held (status HOLD).
 * |u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
 *       lasts.
 * Guard full: what is measured is finite and no pointer is NULL, or the call is refused
 *       (status E_INPUT).
 * Precision f32 (IEEE 754 binary32). Results are bit for bit the same on every IEEE 754
 *       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
 *
 * Checks of the design (details: ptc-codegen check):
 *   membership: sound: exp is of class M for all its parameters.
 *   growth: sound: at rest at sample N from any state, whatever the poles, and |u| is bounded.
 *   sampling: not checked: the law is exact in samples, at any period.
 *   deadline: not checked: the law is exact in samples, at any period.
 *   loop: not checked: `samples` is left to run time.
 *   envelope: not checked: `x_max` is not given.
 *   zeros: sound: none: the relative degrees are 2, 2, whose sum is the number of states.
 */
#ifndef STAGE36_BD6388A0_H
#define STAGE36_BD6388A0_H

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
typedef struct stage36_params {
    uint32_t samples; /* samples N from the start to rest [samples], at least 2 */
    float u_max; /* bound of |u| [unit of u], > 0, infinity allowed */
    float a; /* rate of stretched time [1/s], from 1e-18 to 1e18 */
    float k[2]; /* gains k_i of pi0 = -sum k_i xi_i [1/s^2], finite */
    float deadbeat; /* samples to go at which deadbeat takes over, 0 for a safe default [samples], finite */
} stage36_params;

/* Controller: set by init, changed by arm and by what takes it without const. */
typedef struct stage36 {
    uint32_t start; /* tick at which it was armed */
    uint32_t samples; /* samples from the start to rest */
    float deadbeat_1; /* samples to go at which deadbeat takes over */
    float w1_1_1; /* weight of x1 in the law */
    float w1_2_1; /* weight of x2 in the law */
    float w2_2_1; /* weight of x2 in the law */
    float u_max; /* bound of |u| */
} stage36;

/* Takes the parameters and arms at tick 0. PTC_OK, or PTC_E_PARAM with *self untouched. */
ptc_status stage36_init(stage36 *self, const stage36_params *params);

/* Starts again: the deadline is N samples after tick `k`. */
ptc_status stage36_arm(stage36 *self, uint32_t k);

/*
 * u = (F1, F2) from tick `k`, which may wrap, and state x = (q1, q2, w1, w2). Where one of them is
 * not finite, as at a state at which the inputs do not decouple the outputs, every u is 0; else the
 * status is SATURATED where one was clipped. u and axes must not overlap x.
 */
ptc_status stage36_step(
    const stage36 *self,
    uint32_t k,
    const float x[4],
    float u[2],
    ptc_status axes[2]);

#ifdef __cplusplus
}
#endif

#endif
