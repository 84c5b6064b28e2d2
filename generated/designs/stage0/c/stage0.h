/*
 * Prescribed-time controller stage0: order n = 1, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 1 --mu exp --name stage0 --clock samples --eps=0
 * Version 0.1.0, design 14ec59d52490.
 *
 * Plant: x1' = u; u held from sample to sample.
 * Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
 *       sample period, as long as u is not clipped and nothing else acts on the plant.
 * Law: with M samples to go and z = S x, u h^1 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-0));
 *       the rows are those of Theorem 1 for the mapping exp. Close to the end deadbeat takes
 *       over.
 *
 * Parameters:
 *   samples [samples]: samples N from the start to rest
 *   h [s]: sample period
 *   eps = 0 [s], fixed: time-to-go at which the gains are held
 *   u_max [unit of u]: bound of |u|
 *   a [1/s]: rate of stretched time
 *   k_1 [1/s]: gains k_i of pi0 = -sum k_i xi_i
 *   deadbeat [samples]: samples to go at which deadbeat takes over, 0 for a safe default
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
 *   growth: sound: at rest at sample N from any state, whatever the poles, and |u| is bounded.
 *   sampling: not checked: the law is exact in samples, at any period.
 *   deadline: not checked: the law is exact in samples, at any period.
 *   loop: not checked: `samples` is left to run time.
 *   envelope: not checked: it does not examine a clock in samples.
 */
#ifndef STAGE0_CA36E2B0_H
#define STAGE0_CA36E2B0_H

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
typedef struct stage0_params {
    uint32_t samples; /* samples N from the start to rest [samples], at least 1 */
    double h; /* sample period [s], from 1e-150 to 1e150 */
    double u_max; /* bound of |u| [unit of u], > 0, infinity allowed */
    double a; /* rate of stretched time [1/s], from 1e-150 to 1e150 */
    double k[1]; /* gains k_i of pi0 = -sum k_i xi_i [1/s], finite */
    double deadbeat; /* samples to go at which deadbeat takes over, 0 for a safe default [samples], finite */
} stage0_params;

/* Controller: set by init, changed by arm and by what takes it without const. */
typedef struct stage0 {
    uint32_t start; /* tick at which it was armed */
    uint32_t samples; /* samples from the start to rest */
    double deadbeat; /* samples to go at which deadbeat takes over */
    double w1_1; /* weight of x1 in the law */
    double b_1; /* weight of x1 in the law */
    double u_max; /* bound of |u| */
} stage0;

/* Takes the parameters and arms at tick 0. PTC_OK, or PTC_E_PARAM with *self untouched. */
ptc_status stage0_init(stage0 *self, const stage0_params *params);

/* Starts again: the deadline is N samples after tick `k`. */
ptc_status stage0_arm(stage0 *self, uint32_t k);

/*
 * u from tick `k`, which may wrap, and the state x = (x1, x1', ...). On a negative status u is 0
 * and nothing has changed. u must not overlap x.
 */
ptc_status stage0_step(const stage0 *self, uint32_t k, const double x[1], double *u);

#ifdef __cplusplus
}
#endif

#endif
