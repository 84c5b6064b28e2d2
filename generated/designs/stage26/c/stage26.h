/*
 * Prescribed-time controller stage26: outputs of order 2, 2, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --mu exp --name stage26 --clock samples --precision f32 --guard none --eps=0 --states="q1, q2, w1, w2" --inputs=F1,F2 --inertia="[[m + q2^2, q2], [q2, 1]]" --bias="m*q2*w1*w2, w1^2/2 - q1"
 * Version 0.1.0, design 7cc34530b578.
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
 * Outputs: 2, each with a law of its own, with this deadline and mapping; u_max is of the
 *       input of this number.
 *
 * Parameters:
 *   samples [samples]: samples N from the start to rest
 *   h [s]: sample period
 *   eps = 0 [s], fixed: time-to-go at which the gains are held
 *   u_max [unit of u]: bound of |u|
 *   a [1/s]: rate of stretched time
 *   k_1 [1/s^2]: gains k_i of pi0 = -sum k_i xi_i
 *   k_2 [1/s]: gains k_i of pi0 = -sum k_i xi_i
 *   deadbeat [samples]: samples to go at which deadbeat takes over, 0 for a safe default
 *   m [as in its expression]: parameter of an expression of the design
 *
 * k counts samples and may wrap; arm again within 2^32 - N samples.
 * From sample N on the last gains are held (status HOLD).
 * |u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
 *       lasts.
 * Guard none: finite measurements and valid pointers are the responsibility of the caller.
 * Precision f32 (IEEE 754 binary32). Results are bit for bit the same on every IEEE 754
 *       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
 *
 * Checks of the design (details: ptc-codegen check):
 *   membership: sound: exp is of class M for all its parameters.
 *   growth: sound: at rest at sample N from any state, but for what f + g u does between
 *       samples, whatever the poles, and |u| is bounded.
 *   sampling: not checked: `loop` bounds what the period leaves of a plant with several
 *       inputs.
 *   deadline: not checked: `loop` bounds what the period leaves of a plant with several
 *       inputs.
 *   loop: not checked: `samples` is left to run time.
 *   envelope: not checked: `x_max` is not given.
 *   zeros: sound: none: the relative degrees are 2, 2, whose sum is the number of states.
 */
#ifndef STAGE26_BD777360_H
#define STAGE26_BD777360_H

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
typedef struct stage26_params {
    uint32_t samples; /* samples N from the start to rest [samples], at least 2 */
    float h; /* sample period [s], from 1e-18 to 1e18 */
    float u_max; /* bound of |u| [unit of u], > 0, infinity allowed */
    float a; /* rate of stretched time [1/s], from 1e-18 to 1e18 */
    float k[2]; /* gains k_i of pi0 = -sum k_i xi_i [1/s^2], finite */
    float deadbeat; /* samples to go at which deadbeat takes over, 0 for a safe default [samples], finite */
    float m; /* parameter of an expression of the design [as in its expression], finite */
} stage26_params;

/* Controller: set by init, changed by arm and by what takes it without const. */
typedef struct stage26 {
    uint32_t start; /* tick at which it was armed */
    uint32_t samples; /* samples from the start to rest */
    float deadbeat_1; /* samples to go at which deadbeat takes over */
    float w1_1_1; /* weight of x1 in the law */
    float w1_2_1; /* weight of x2 in the law */
    float w2_2_1; /* weight of x2 in the law */
    float b_1_1; /* weight of x1 in the law */
    float b_2_1; /* weight of x2 in the law */
    float p_m; /* parameter of an expression of the design */
    float u_max; /* bound of |u| */
} stage26;

/* Takes the parameters and arms at tick 0. PTC_OK, or PTC_E_PARAM with *self untouched. */
ptc_status stage26_init(stage26 *self, const stage26_params *params);

/* Starts again: the deadline is N samples after tick `k`. */
ptc_status stage26_arm(stage26 *self, uint32_t k);

/*
 * u = (F1, F2) from tick `k`, which may wrap, and state x = (q1, q2, w1, w2). Where one of them is
 * not finite, as at a state at which the inputs do not decouple the outputs, every u is 0; else the
 * status is SATURATED where one was clipped. u and axes must not overlap x.
 */
ptc_status stage26_step(
    const stage26 *self,
    uint32_t k,
    const float x[4],
    float u[2],
    ptc_status axes[2]);

#ifdef __cplusplus
}
#endif

#endif
