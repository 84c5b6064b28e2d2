/*
 * Prescribed-time controller stage13: order n = 2, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 2 --mu "exp(a=1)" --name stage13 --clock samples --A="[[0,1],[49,-0.1]]" --B="[0.1,-1.3]" --C="[[1,0.5],[0.2,-1]]" --precision f32 --eps=0 --after zero --sample-time=0.01
 * Version 0.1.0, design 66f29bb0af19.
 *
 * Plant: x' = A x + B u of --A and --B above; u held from sample to sample, y = C x.
 * Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
 *       sample period, as long as u is not clipped and nothing else acts on the plant.
 * Law: with M samples to go and z = S x, the differences of a flat output, u = sum of row_j
 *       z_j/((M-j+1)...(M-1)) less the drift of z; the rows are those of Theorem 1 for the
 *       mapping exp. Close to the end deadbeat takes over.
 *
 * Parameters:
 *   samples [samples]: samples N from the start to rest
 *   h = 0.01 [s], fixed: sample period
 *   eps = 0 [s], fixed: time-to-go at which the gains are held
 *   u_max [unit of u]: bound of |u|
 *   a = 1 [1/s], fixed: rate of stretched time
 *   k_1 [1/s^2]: gains k_i of pi0 = -sum k_i xi_i
 *   k_2 [1/s]: gains k_i of pi0 = -sum k_i xi_i
 *   deadbeat [samples]: samples to go at which deadbeat takes over, 0 for a safe default
 *
 * k counts samples and may wrap; arm again within 2^32 - N samples.
 * From sample N on u = 0 (status AFTER).
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
 *   envelope: not checked: it does not examine a clock in samples.
 */
#ifndef STAGE13_1BF3376C_H
#define STAGE13_1BF3376C_H

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
typedef struct stage13_params {
    uint32_t samples; /* samples N from the start to rest [samples], at least 2 */
    float u_max; /* bound of |u| [unit of u], > 0, infinity allowed */
    float k[2]; /* gains k_i of pi0 = -sum k_i xi_i [1/s^2], finite */
    float deadbeat; /* samples to go at which deadbeat takes over, 0 for a safe default [samples], finite */
} stage13_params;

/* Controller: set by init, changed by arm and by what takes it without const. */
typedef struct stage13 {
    uint32_t start; /* tick at which it was armed */
    uint32_t samples; /* samples from the start to rest */
    float deadbeat; /* samples to go at which deadbeat takes over */
    float w1_1; /* weight of x1 in the law */
    float w1_2; /* weight of x2 in the law */
    float w2_1; /* weight of x1 in the law */
    float w2_2; /* weight of x2 in the law */
    float u_max; /* bound of |u| */
} stage13;

/*@ predicate stage13_set(stage13 *c) =
      \is_finite(c->deadbeat)
      && \is_finite(c->w1_1)
      && \is_finite(c->w1_2)
      && \is_finite(c->w2_1)
      && \is_finite(c->w2_2);
 */

/* Takes the parameters and arms at tick 0. PTC_OK, or PTC_E_PARAM with *self untouched. */
/*@ requires self == \null || \valid(self);
    requires params == \null || \valid_read(params);
    assigns *self;
    ensures \result == PTC_OK || \result == PTC_E_PARAM;
    ensures \result == PTC_OK ==> stage13_set(self);
 */
ptc_status stage13_init(stage13 *self, const stage13_params *params);

/* Starts again: the deadline is N samples after tick `k`. */
/*@ requires self == \null || \valid(self);
    requires self == \null || stage13_set(self);
    assigns *self;
    ensures \result == PTC_OK || \result == PTC_E_INPUT;
    ensures \result >= 0 ==> stage13_set(self);
 */
ptc_status stage13_arm(stage13 *self, uint32_t k);

/*
 * u from tick `k`, which may wrap, and what is measured, y = C x. On a negative status u is 0 and
 * nothing has changed. u must not overlap y.
 */
/*@ requires self == \null || \valid_read(self);
    requires y == \null || \valid_read(y + (0 .. 1));
    requires u == \null || \valid(u);
    requires self == \null || stage13_set(self);
    assigns *u;
    ensures \result == PTC_SATURATED || \result == PTC_OK || \result == PTC_AFTER || \result == PTC_E_RANGE || \result == PTC_E_INPUT;
 */
ptc_status stage13_step(const stage13 *self, uint32_t k, const float y[2], float *u);

#ifdef __cplusplus
}
#endif

#endif
