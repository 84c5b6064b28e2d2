/*
 * Prescribed-time controller stage38: order n = 2, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 2 --mu "exp(a=1)" --name stage38 --clock samples --measured=x1 --disturbance constant --observer-poles=-4,-5,-6 --observer-samples=20 --precision f32 --tau=0.4 --eps=0 --u-max=1 --u-min=0 --poles=-4,-5,-6 --after zero --sample-time=1e-2 --delay=1
 * Version 0.1.0, design 1fdc242cfcc9.
 *
 * Plant: x1' = x2, x2' = (u + d), d constant and unknown; u held from sample to sample, one
 *       sample late.
 * Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
 *       sample period, as long as u is not clipped and nothing else acts on the plant.
 * Law: with M - 3 samples to go and z = S x, u h^3 = sum of row_j z_j
 *       h^(j-1)/((M-j+1)...(M-2)); the rows are those of Theorem 1 for the mapping exp. The
 *       gains of 3 samples to go stay: they are deadbeat.
 *
 * Parameters:
 *   samples = 40 [samples], fixed: samples N from the start to rest
 *   h = 1e-2 [s], fixed: sample period
 *   eps = 0 [s], fixed: time-to-go at which the gains are held
 *   u_max = 1 [unit of u], fixed: upper limit of u
 *   u_min = 0 [unit of u], fixed: lower limit of u
 *   a = 1 [1/s], fixed: rate of stretched time
 *   k_1 = 120 [1/s^3], fixed: gains k_i of pi0 = -sum k_i xi_i
 *   k_2 = 74 [1/s^2], fixed: gains k_i of pi0 = -sum k_i xi_i
 *   k_3 = 15 [1/s], fixed: gains k_i of pi0 = -sum k_i xi_i
 *
 * k counts samples and may wrap; arm again within 2^32 - N samples.
 * From sample N on u = 0 (status AFTER).
 * The estimates are exact from sample 20 after the start on where the measurement is; with
 *       noise or sensor_step given, or observer_eps, the gains of the observer are then held
 *       below deadbeat.
 * u_min <= u <= u_max: u is clipped to these limits (status SATURATED). Clipping voids the
 *       deadline where it lasts.
 * Guard full: what is measured is finite and no pointer is NULL, or the call is refused
 *       (status E_INPUT).
 * Precision f32 (IEEE 754 binary32). Results are bit for bit the same on every IEEE 754
 *       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
 *
 * Checks of the design (details: ptc-codegen check):
 *   membership: sound: exp is of class M for all its parameters.
 *   growth: sound: at rest at sample 40 from any state, whatever the poles, and |u| is
 *       bounded.
 *   sampling: not checked: the law is exact in samples, at any period.
 *   deadline: not checked: the law is exact in samples, at any period.
 *   loop: not checked: `x0_max` is not given.
 *   envelope: not checked: it does not examine a clock in samples.
 */
#ifndef STAGE38_C48E8432_H
#define STAGE38_C48E8432_H

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
typedef struct stage38_params {
    char none; /* every parameter is fixed */
} stage38_params;

/* Controller: set by init, changed by arm and by what takes it without const. */
typedef struct stage38 {
    uint32_t start; /* tick at which it was armed */
    float u1; /* input of the last sample */
    float u2; /* input of 2 samples ago */
    uint32_t seen; /* 1 once y has been measured */
    float x1_hat; /* estimate of x1 */
    float x2_hat; /* estimate of x2 */
    float d_hat; /* estimate of d */
} stage38;

/*@ predicate stage38_set(stage38 *c) =
      \true;
 */

/* Takes the parameters and arms at tick 0. PTC_OK, or PTC_E_PARAM with *self untouched. */
/*@ requires self == \null || \valid(self);
    assigns *self;
    ensures \result == PTC_OK || \result == PTC_E_PARAM;
    ensures \result == PTC_OK ==> stage38_set(self);
 */
ptc_status stage38_init(stage38 *self, const stage38_params *params);

/*
 * Starts again: the deadline is N samples after tick `k`. Estimates and inputs under way are kept.
 * Estimates too large to compute with begin anew.
 */
/*@ requires self == \null || \valid(self);
    requires self == \null || stage38_set(self);
    assigns *self;
    ensures \result == PTC_OK || \result == PTC_E_INPUT;
    ensures \result >= 0 ==> stage38_set(self);
 */
ptc_status stage38_arm(stage38 *self, uint32_t k);

/*
 * u from tick `k`, which may wrap, and what is measured, y = (x1, ...). Call it once for each tick.
 * On a negative status u is 0 and nothing has changed. u must not overlap y.
 */
/*@ requires self == \null || \valid(self);
    requires y == \null || \valid_read(y + (0 .. 0));
    requires u == \null || \valid(u);
    requires self == \null || stage38_set(self);
    assigns *self, *u;
    ensures \result == PTC_SATURATED || \result == PTC_OK || \result == PTC_AFTER || \result == PTC_E_INPUT || \result == PTC_E_RANGE;
    ensures \result >= 0 ==> stage38_set(self);
 */
ptc_status stage38_step(stage38 *self, uint32_t k, const float y[1], float *u);

/* The estimate of the state at the last sample. */
/*@ requires self == \null || \valid_read(self);
    requires xhat == \null || \valid(xhat + (0 .. 1));
    requires self == \null || stage38_set(self);
    assigns xhat[0 .. 1];
    ensures \result == PTC_OK || \result == PTC_E_INPUT;
 */
ptc_status stage38_estimate(const stage38 *self, float xhat[2]);

/* The estimate of the constant that is added to u. */
/*@ requires self == \null || \valid_read(self);
    requires d == \null || \valid(d);
    requires self == \null || stage38_set(self);
    assigns *d;
    ensures \result == PTC_OK || \result == PTC_E_INPUT;
 */
ptc_status stage38_disturbance(const stage38 *self, float *d);

#ifdef __cplusplus
}
#endif

#endif
