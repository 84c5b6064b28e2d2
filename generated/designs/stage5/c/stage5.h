/*
 * Prescribed-time controller stage5: order n = 4, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 4 --mu exp --name stage5 --clock samples --guard none --eps=0.01 --delay=2
 * Version 0.1.0, design af29f716abf2.
 *
 * Plant: x1' = x2, ..., x4' = u; u held from sample to sample, 2 samples late.
 * Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
 *       sample period, as long as u is not clipped and nothing else acts on the plant.
 * Law: with M samples to go and z = S x, u h^6 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-5));
 *       the rows are those of Theorem 1 for the mapping exp. Close to the end deadbeat takes
 *       over.
 *
 * Parameters:
 *   samples [samples]: samples N from the start to rest
 *   h [s]: sample period
 *   eps = 0.01 [s], fixed: time-to-go at which the gains are held
 *   u_max [unit of u]: bound of |u|
 *   a [1/s]: rate of stretched time
 *   k_1 [1/s^6]: gains k_i of pi0 = -sum k_i xi_i
 *   k_2 [1/s^5]: gains k_i of pi0 = -sum k_i xi_i
 *   k_3 [1/s^4]: gains k_i of pi0 = -sum k_i xi_i
 *   k_4 [1/s^3]: gains k_i of pi0 = -sum k_i xi_i
 *   k_5 [1/s^2]: gains k_i of pi0 = -sum k_i xi_i
 *   k_6 [1/s]: gains k_i of pi0 = -sum k_i xi_i
 *   deadbeat [samples]: samples to go at which deadbeat takes over, 0 for a safe default
 *
 * k counts samples and may wrap; arm again within 2^32 - N samples.
 * From sample N on the last gains are held (status HOLD).
 * |u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
 *       lasts.
 * Guard none: finite measurements and valid pointers are the responsibility of the caller.
 * Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
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
#ifndef STAGE5_B0982A6C_H
#define STAGE5_B0982A6C_H

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
typedef struct stage5_params {
    uint32_t samples; /* samples N from the start to rest [samples], at least 6 */
    double h; /* sample period [s], from 1e-150 to 1e150 */
    double u_max; /* bound of |u| [unit of u], > 0, infinity allowed */
    double a; /* rate of stretched time [1/s], from 1e-150 to 1e150 */
    double k[6]; /* gains k_i of pi0 = -sum k_i xi_i [1/s^6], finite */
    double deadbeat; /* samples to go at which deadbeat takes over, 0 for a safe default [samples], finite */
} stage5_params;

/* Controller: set by init, changed by arm and by what takes it without const. */
typedef struct stage5 {
    uint32_t start; /* tick at which it was armed */
    uint32_t samples; /* samples from the start to rest */
    double u1; /* input of the last sample */
    double u2; /* input of 2 samples ago */
    double hold; /* samples to go at which the gains are held */
    double w1_1; /* weight of x1 in the law */
    double w1_2; /* weight of x2 in the law */
    double w1_3; /* weight of x3 in the law */
    double w1_4; /* weight of x4 in the law */
    double w2_2; /* weight of x2 in the law */
    double w2_3; /* weight of x3 in the law */
    double w2_4; /* weight of x4 in the law */
    double w3_3; /* weight of x3 in the law */
    double w3_4; /* weight of x4 in the law */
    double w4_4; /* weight of x4 in the law */
    double w5_6; /* weight of u2 in the law */
    double w6_5; /* weight of u1 in the law */
    double w6_6; /* weight of u2 in the law */
    double b_1; /* weight of x1 in the law */
    double b_2; /* weight of x2 in the law */
    double b_3; /* weight of x3 in the law */
    double b_4; /* weight of x4 in the law */
    double u_max; /* bound of |u| */
} stage5;

/* Takes the parameters and arms at tick 0. PTC_OK, or PTC_E_PARAM with *self untouched. */
ptc_status stage5_init(stage5 *self, const stage5_params *params);

/*
 * Starts again: the deadline is N samples after tick `k`. Estimates and inputs under way are kept.
 */
ptc_status stage5_arm(stage5 *self, uint32_t k);

/*
 * u from tick `k`, which may wrap, and the state x = (x1, x1', ...). Call it once for each tick. On
 * a negative status u is 0 and nothing has changed. u must not overlap x.
 */
ptc_status stage5_step(stage5 *self, uint32_t k, const double x[4], double *u);

#ifdef __cplusplus
}
#endif

#endif
