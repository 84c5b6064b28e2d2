/*
 * Prescribed-time controller stage2: order n = 3, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 3 --mu "exp(a=1)" --name stage2 --clock samples --guard none --tau=0.02 --eps=0 --u-max=inf --poles=-4,-5,-6 --sample-time=1e-3
 * Version 0.1.0, design 75680df23c07.
 *
 * Plant: x1' = x2, ..., x3' = u; u held from sample to sample.
 * Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
 *       sample period, as long as u is not clipped and nothing else acts on the plant.
 * Law: with M - 3 samples to go and z = S x, u h^3 = sum of row_j z_j
 *       h^(j-1)/((M-j+1)...(M-2)); the rows are those of Theorem 1 for the mapping exp. The
 *       gains of 3 samples to go stay: they are deadbeat.
 *
 * Parameters:
 *   samples = 20 [samples], fixed: samples N from the start to rest
 *   h = 1e-3 [s], fixed: sample period
 *   eps = 0 [s], fixed: time-to-go at which the gains are held
 *   u_max = inf [unit of u], fixed: bound of |u|
 *   a = 1 [1/s], fixed: rate of stretched time
 *   k_1 = 120 [1/s^3], fixed: gains k_i of pi0 = -sum k_i xi_i
 *   k_2 = 74 [1/s^2], fixed: gains k_i of pi0 = -sum k_i xi_i
 *   k_3 = 15 [1/s], fixed: gains k_i of pi0 = -sum k_i xi_i
 *
 * k counts samples and may wrap; arm again within 2^32 - N samples.
 * From sample N on the last gains are held (status HOLD).
 * u is not clipped.
 * Guard none: finite measurements and valid pointers are the responsibility of the caller.
 * Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
 *       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
 *
 * Checks of the design (details: ptc-codegen check):
 *   membership: sound: exp is of class M for all its parameters.
 *   growth: sound: at rest at sample 20 from any state, whatever the poles, and |u| is
 *       bounded.
 *   sampling: not checked: the law is exact in samples, at any period.
 *   deadline: not checked: the law is exact in samples, at any period.
 *   loop: not checked: `x0_max` is not given.
 *   envelope: not checked: it does not examine a clock in samples.
 */
#ifndef STAGE2_0B50634C_H
#define STAGE2_0B50634C_H

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
typedef struct stage2_params {
    char none; /* every parameter is fixed */
} stage2_params;

/* Controller: set by init, changed by arm and by what takes it without const. */
typedef struct stage2 {
    uint32_t start; /* tick at which it was armed */
} stage2;

/*@ predicate stage2_set(stage2 *c) =
      \true;
 */

/* Takes the parameters and arms at tick 0. PTC_OK, or PTC_E_PARAM with *self untouched. */
/*@ requires self == \null || \valid(self);
    assigns *self;
    ensures \result == PTC_OK || \result == PTC_E_PARAM;
    ensures \result == PTC_OK ==> stage2_set(self);
 */
ptc_status stage2_init(stage2 *self, const stage2_params *params);

/* Starts again: the deadline is N samples after tick `k`. */
/*@ requires \valid(self);
    requires stage2_set(self);
    assigns *self;
    ensures \result == PTC_OK;
    ensures \result >= 0 ==> stage2_set(self);
 */
ptc_status stage2_arm(stage2 *self, uint32_t k);

/*
 * u from tick `k`, which may wrap, and the state x = (x1, x1', ...). On a negative status u is 0
 * and nothing has changed. u must not overlap x.
 */
/*@ requires \valid_read(self);
    requires \valid_read(x + (0 .. 2));
    requires \valid(u);
    requires stage2_set(self);
    requires \is_finite(x[0]);
    requires \is_finite(x[1]);
    requires \is_finite(x[2]);
    assigns *u;
    ensures \result == PTC_OK || \result == PTC_HOLD || \result == PTC_E_RANGE;
 */
ptc_status stage2_step(const stage2 *self, uint32_t k, const double x[3], double *u);

#ifdef __cplusplus
}
#endif

#endif
