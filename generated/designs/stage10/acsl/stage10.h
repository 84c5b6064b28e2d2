/*
 * Prescribed-time controller stage10: order n = 2, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 2 --mu "exp(a=1.3)" --name stage10 --clock samples --deadbeat=20 --precision f32 --eps=0
 * Version 0.1.0, design 53d11c790cfa.
 *
 * Plant: x1' = x2, x2' = u; u held from sample to sample.
 * Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
 *       sample period, as long as u is not clipped and nothing else acts on the plant.
 * Law: with M samples to go and z = S x, u h^2 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-1));
 *       the rows are those of Theorem 1 for the mapping exp. Close to the end, with 20
 *       samples to go deadbeat takes over.
 *
 * Parameters:
 *   samples [samples]: samples N from the start to rest
 *   h [s]: sample period
 *   eps = 0 [s], fixed: time-to-go at which the gains are held
 *   u_max [unit of u]: bound of |u|
 *   a = 1.3 [1/s], fixed: rate of stretched time
 *   k_1 [1/s^2]: gains k_i of pi0 = -sum k_i xi_i
 *   k_2 [1/s]: gains k_i of pi0 = -sum k_i xi_i
 *   deadbeat = 20 [samples], fixed: samples to go at which deadbeat takes over, 0 for a safe
 *       default
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
 *   envelope: not checked: it does not examine a clock in samples.
 */
#ifndef STAGE10_470DC963_H
#define STAGE10_470DC963_H

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
typedef struct stage10_params {
    uint32_t samples; /* samples N from the start to rest [samples], at least 2 */
    float h; /* sample period [s], from 1e-18 to 1e18 */
    float u_max; /* bound of |u| [unit of u], > 0, infinity allowed */
    float k[2]; /* gains k_i of pi0 = -sum k_i xi_i [1/s^2], finite */
} stage10_params;

/* Controller: set by init, changed by arm and by what takes it without const. */
typedef struct stage10 {
    uint32_t start; /* tick at which it was armed */
    uint32_t samples; /* samples from the start to rest */
    float w1_1; /* weight of x1 in the law */
    float w1_2; /* weight of x2 in the law */
    float w2_2; /* weight of x2 in the law */
    float b_1; /* weight of x1 in the law */
    float b_2; /* weight of x2 in the law */
    float u_max; /* bound of |u| */
} stage10;

/*@ predicate stage10_set(stage10 *c) =
      \is_finite(c->w1_1)
      && \is_finite(c->w1_2)
      && \is_finite(c->w2_2)
      && \is_finite(c->b_1)
      && \is_finite(c->b_2);
 */

/* Takes the parameters and arms at tick 0. PTC_OK, or PTC_E_PARAM with *self untouched. */
/*@ requires self == \null || \valid(self);
    requires params == \null || \valid_read(params);
    assigns *self;
    ensures \result == PTC_OK || \result == PTC_E_PARAM;
    ensures \result == PTC_OK ==> stage10_set(self);
 */
ptc_status stage10_init(stage10 *self, const stage10_params *params);

/* Starts again: the deadline is N samples after tick `k`. */
/*@ requires self == \null || \valid(self);
    requires self == \null || stage10_set(self);
    assigns *self;
    ensures \result == PTC_OK || \result == PTC_E_INPUT;
    ensures \result >= 0 ==> stage10_set(self);
 */
ptc_status stage10_arm(stage10 *self, uint32_t k);

/*
 * u from tick `k`, which may wrap, and the state x = (x1, x1', ...). On a negative status u is 0
 * and nothing has changed. u must not overlap x.
 */
/*@ requires self == \null || \valid_read(self);
    requires x == \null || \valid_read(x + (0 .. 1));
    requires u == \null || \valid(u);
    requires self == \null || stage10_set(self);
    assigns *u;
    ensures \result == PTC_SATURATED || \result == PTC_OK || \result == PTC_HOLD || \result == PTC_E_RANGE || \result == PTC_E_INPUT;
 */
ptc_status stage10_step(const stage10 *self, uint32_t k, const float x[2], float *u);

#ifdef __cplusplus
}
#endif

#endif
