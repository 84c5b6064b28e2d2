/*
 * Prescribed-time controller stage9: order n = 3, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 3 --mu "exp(a=1)" --name stage9 --clock samples --measured=x1 --observer-poles=-4,-5,-6 --observer-eps=0.05 --eps=0.02 --u-max=1e3 --delay=1
 * Version 0.1.0, design a9f2dd91a5f7.
 *
 * Plant: x1' = x2, ..., x3' = u; u held from sample to sample, one sample late.
 * Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
 *       sample period, as long as u is not clipped and nothing else acts on the plant.
 * Law: with M samples to go and z = S x, u h^4 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-3));
 *       the rows are those of Theorem 1 for the mapping exp. Close to the end deadbeat takes
 *       over.
 *
 * Parameters:
 *   samples [samples]: samples N from the start to rest
 *   h [s]: sample period
 *   eps = 0.02 [s], fixed: time-to-go at which the gains are held
 *   u_max = 1e3 [unit of u], fixed: bound of |u|
 *   a = 1 [1/s], fixed: rate of stretched time
 *   k_1 [1/s^4]: gains k_i of pi0 = -sum k_i xi_i
 *   k_2 [1/s^3]: gains k_i of pi0 = -sum k_i xi_i
 *   k_3 [1/s^2]: gains k_i of pi0 = -sum k_i xi_i
 *   k_4 [1/s]: gains k_i of pi0 = -sum k_i xi_i
 *   deadbeat [samples]: samples to go at which deadbeat takes over, 0 for a safe default
 *
 * k counts samples and may wrap; arm again within 2^32 - N samples.
 * From sample N on the last gains are held (status HOLD).
 * The estimates are exact from sample N/2 after the start on where the measurement is; with
 *       noise or sensor_step given, or observer_eps, the gains of the observer are then held
 *       below deadbeat.
 * |u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
 *       lasts.
 * Guard full: what is measured is finite and no pointer is NULL, or the call is refused
 *       (status E_INPUT).
 * Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
 *       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
 *
 * Checks of the design (details: ptc-codegen check):
 *   membership: sound: exp is of class M for all its parameters.
 *   growth: sound: at rest at sample N from any state, but for what the held observer leaves
 *       of its error, whatever the poles, and |u| is bounded.
 *   sampling: not checked: the law is exact in samples, at any period.
 *   deadline: not checked: the law is exact in samples, at any period.
 *   loop: not checked: `samples` is left to run time.
 *   envelope: not checked: it does not examine a clock in samples.
 */
#ifndef STAGE9_FAF795A8_H
#define STAGE9_FAF795A8_H

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
typedef struct stage9_params {
    uint32_t samples; /* samples N from the start to rest [samples], at least 8 */
    double h; /* sample period [s], from 1e-150 to 1e150 */
    double k[4]; /* gains k_i of pi0 = -sum k_i xi_i [1/s^4], finite */
    double deadbeat; /* samples to go at which deadbeat takes over, 0 for a safe default [samples], finite */
} stage9_params;

/* Controller: set by init, changed by arm and by what takes it without const. */
typedef struct stage9 {
    uint32_t start; /* tick at which it was armed */
    uint32_t samples; /* samples from the start to rest */
    double u1; /* input of the last sample */
    double u2; /* input of 2 samples ago */
    uint32_t seen; /* 1 once y has been measured */
    double x1_hat; /* estimate of x1 */
    double x2_hat; /* estimate of x2 */
    double x3_hat; /* estimate of x3 */
    double phi1_2; /* prediction of x1 from x2 */
    double phi1_3; /* prediction of x1 from x3 */
    double gamma1; /* prediction from u */
    double hold_o; /* samples to go at which the observer is held */
    double q2_1; /* weight in the observer's gain l2 */
    double q2_2; /* weight in the observer's gain l2 */
    double q3_1; /* weight in the observer's gain l3 */
    double hold; /* samples to go at which the gains are held */
    double w1_1; /* weight of x1 in the law */
    double w1_2; /* weight of x2 in the law */
    double w1_3; /* weight of x3 in the law */
    double w2_2; /* weight of x2 in the law */
    double w2_3; /* weight of x3 in the law */
    double w3_3; /* weight of x3 in the law */
    double w4_4; /* weight of u1 in the law */
    double b_1; /* weight of x1 in the law */
    double b_2; /* weight of x2 in the law */
    double b_3; /* weight of x3 in the law */
} stage9;

/*@ predicate stage9_set(stage9 *c) =
      \is_finite(c->phi1_3)
      && \is_finite(c->gamma1)
      && \is_finite(c->hold_o)
      && \is_finite(c->q2_1)
      && \is_finite(c->q2_2)
      && \is_finite(c->q3_1)
      && \is_finite(c->hold)
      && \is_finite(c->w1_1)
      && \is_finite(c->w1_2)
      && \is_finite(c->w1_3)
      && \is_finite(c->w2_2)
      && \is_finite(c->w2_3)
      && \is_finite(c->w3_3)
      && \is_finite(c->w4_4)
      && \is_finite(c->b_1)
      && \is_finite(c->b_2)
      && \is_finite(c->b_3);
 */

/* Takes the parameters and arms at tick 0. PTC_OK, or PTC_E_PARAM with *self untouched. */
/*@ requires self == \null || \valid(self);
    requires params == \null || \valid_read(params);
    assigns *self;
    ensures \result == PTC_OK || \result == PTC_E_PARAM;
    ensures \result == PTC_OK ==> stage9_set(self);
 */
ptc_status stage9_init(stage9 *self, const stage9_params *params);

/*
 * Starts again: the deadline is N samples after tick `k`. Estimates and inputs under way are kept.
 * Estimates too large to compute with begin anew.
 */
/*@ requires self == \null || \valid(self);
    requires self == \null || stage9_set(self);
    assigns *self;
    ensures \result == PTC_OK || \result == PTC_E_INPUT;
    ensures \result >= 0 ==> stage9_set(self);
 */
ptc_status stage9_arm(stage9 *self, uint32_t k);

/*
 * u from tick `k`, which may wrap, and what is measured, y = (x1, ...). Call it once for each tick.
 * On a negative status u is 0 and nothing has changed. u must not overlap y.
 */
/*@ requires self == \null || \valid(self);
    requires y == \null || \valid_read(y + (0 .. 0));
    requires u == \null || \valid(u);
    requires self == \null || stage9_set(self);
    assigns *self, *u;
    ensures \result == PTC_SATURATED || \result == PTC_HOLD || \result == PTC_OK || \result == PTC_E_INPUT || \result == PTC_E_RANGE;
    ensures \result >= 0 ==> stage9_set(self);
 */
ptc_status stage9_step(stage9 *self, uint32_t k, const double y[1], double *u);

/* The estimate of the state at the last sample. */
/*@ requires self == \null || \valid_read(self);
    requires xhat == \null || \valid(xhat + (0 .. 2));
    requires self == \null || stage9_set(self);
    assigns xhat[0 .. 2];
    ensures \result == PTC_OK || \result == PTC_E_INPUT;
 */
ptc_status stage9_estimate(const stage9 *self, double xhat[3]);

#ifdef __cplusplus
}
#endif

#endif
