/*
 * Prescribed-time controller stage19: order n = 3, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 3 --mu "exp(a=1)" --name stage19 --clock samples --precision f32 --guard none --eps=0 --u-max=inf --states="q, w, i" --input=V --output="q" --dynamics="w, i/(1 + q^2) - w/4, 50*(V - 2*i - w)" --after zero
 * Version 0.1.0, design 837b86fb35a8.
 *
 * Plant: the input V: q' = w, w' = i/(1 + q^2) - w/4, i' = 50*(V - 2*i - w), output q; u held
 *       from sample to sample.
 * Goal: the output and its derivatives up to order 2, x, are 0 at sample N after the start,
 *       from any state, as long as u is not clipped and the plant is the model. f and g are
 *       known at the samples alone, which leaves an error of order h^(5-i) in x_i.
 * Law: with M samples to go and z = S x, w h^3 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-2)),
 *       and u = (w - f)/g; the rows are those of Theorem 1 for the mapping exp. Close to the
 *       end deadbeat takes over.
 *
 * Parameters:
 *   samples [samples]: samples N from the start to rest
 *   h [s]: sample period
 *   eps = 0 [s], fixed: time-to-go at which the gains are held
 *   u_max = inf [unit of u], fixed: bound of |u|
 *   a = 1 [1/s], fixed: rate of stretched time
 *   k_1 [1/s^3]: gains k_i of pi0 = -sum k_i xi_i
 *   k_2 [1/s^2]: gains k_i of pi0 = -sum k_i xi_i
 *   k_3 [1/s]: gains k_i of pi0 = -sum k_i xi_i
 *   deadbeat [samples]: samples to go at which deadbeat takes over, 0 for a safe default
 *
 * k counts samples and may wrap; arm again within 2^32 - N samples.
 * From sample N on u = 0 (status AFTER).
 * u is not clipped.
 * Guard none: finite measurements and valid pointers are the responsibility of the caller.
 * Precision f32 (IEEE 754 binary32). Results are bit for bit the same on every IEEE 754
 *       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
 *
 * Checks of the design (details: ptc-codegen check):
 *   membership: sound: exp is of class M for all its parameters.
 *   growth: sound: at rest at sample N from any state, but for what f + g u does between
 *       samples, whatever the poles, and |u| is bounded.
 *   sampling: not checked: `loop` bounds what the period leaves of a model that is not linear.
 *   deadline: not checked: `loop` bounds what the period leaves of a model that is not linear.
 *   loop: not checked: `samples` is left to run time.
 *   envelope: not checked: it does not examine a clock in samples.
 *   zeros: sound: none: the relative degree is 3, the number of states.
 */
#ifndef STAGE19_6D2155A1_H
#define STAGE19_6D2155A1_H

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
typedef struct stage19_params {
    uint32_t samples; /* samples N from the start to rest [samples], at least 3 */
    float h; /* sample period [s], from 1e-18 to 1e18 */
    float k[3]; /* gains k_i of pi0 = -sum k_i xi_i [1/s^3], finite */
    float deadbeat; /* samples to go at which deadbeat takes over, 0 for a safe default [samples], finite */
} stage19_params;

/* Controller: set by init, changed by arm and by what takes it without const. */
typedef struct stage19 {
    uint32_t start; /* tick at which it was armed */
    uint32_t samples; /* samples from the start to rest */
    float deadbeat; /* samples to go at which deadbeat takes over */
    float w1_1; /* weight of x1 in the law */
    float w1_2; /* weight of x2 in the law */
    float w1_3; /* weight of x3 in the law */
    float w2_2; /* weight of x2 in the law */
    float w2_3; /* weight of x3 in the law */
    float w3_3; /* weight of x3 in the law */
    float b_1; /* weight of x1 in the law */
    float b_2; /* weight of x2 in the law */
    float b_3; /* weight of x3 in the law */
} stage19;

/* Takes the parameters and arms at tick 0. PTC_OK, or PTC_E_PARAM with *self untouched. */
ptc_status stage19_init(stage19 *self, const stage19_params *params);

/* Starts again: the deadline is N samples after tick `k`. */
ptc_status stage19_arm(stage19 *self, uint32_t k);

/*
 * u from tick `k`, which may wrap, and the state x of the model. On a negative status u is 0 and
 * nothing has changed. u must not overlap x.
 */
ptc_status stage19_step(const stage19 *self, uint32_t k, const float x[3], float *u);

#ifdef __cplusplus
}
#endif

#endif
