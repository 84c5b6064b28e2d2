/*
 * Prescribed-time controller stage12: order n = 3, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 3 --mu "exp(a=1)" --name stage12 --clock samples --A="[[0,1,0],[0,-0.5,1500],[0,-15,-600]]" --B="[0,0,500]" --C="[[1,0,0],[0,0,1]]" --disturbance constant --observer-poles=-4,-5,-6,-7 --after-observer=-90+20i,-90-20i,-100,-120 --eps=0 --sample-time=1e-3 --delay=1
 * Version 0.1.0, design 69fef31f4d23.
 *
 * Plant: x' = A x + B (u + d), d constant and unknown of --A and --B above; u held from
 *       sample to sample, one sample late, y = C x.
 * Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
 *       sample period, as long as u is not clipped and nothing else acts on the plant.
 * Law: with M samples to go and z = S x, the differences of a flat output, u = sum of row_j
 *       z_j/((M-j+1)...(M-3)) less the drift of z; the rows are those of Theorem 1 for the
 *       mapping exp. Close to the end deadbeat takes over.
 *
 * Parameters:
 *   samples [samples]: samples N from the start to rest
 *   h = 1e-3 [s], fixed: sample period
 *   eps = 0 [s], fixed: time-to-go at which the gains are held
 *   u_max [unit of u]: bound of |u|
 *   a = 1 [1/s], fixed: rate of stretched time
 *   k_1 [1/s^4]: gains k_i of pi0 = -sum k_i xi_i
 *   k_2 [1/s^3]: gains k_i of pi0 = -sum k_i xi_i
 *   k_3 [1/s^2]: gains k_i of pi0 = -sum k_i xi_i
 *   k_4 [1/s]: gains k_i of pi0 = -sum k_i xi_i
 *   deadbeat [samples]: samples to go at which deadbeat takes over, 0 for a safe default
 *
 * k counts samples and may wrap; arm again within 2^32 - N samples.
 * From sample N on the last gains are held (status HOLD).
 * The estimates are exact from sample N/2 after the start on where the measurement is; from
 *       there on the observer has the poles after_observer.
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
#ifndef STAGE12_B471F9EE_H
#define STAGE12_B471F9EE_H

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
typedef struct stage12_params {
    uint32_t samples; /* samples N from the start to rest [samples], at least 8 */
    double u_max; /* bound of |u| [unit of u], > 0, infinity allowed */
    double k[4]; /* gains k_i of pi0 = -sum k_i xi_i [1/s^4], finite */
    double deadbeat; /* samples to go at which deadbeat takes over, 0 for a safe default [samples], finite */
} stage12_params;

/* Controller: set by init, changed by arm and by what takes it without const. */
typedef struct stage12 {
    uint32_t start; /* tick at which it was armed */
    uint32_t samples; /* samples from the start to rest */
    double u1; /* input of the last sample */
    double u2; /* input of 2 samples ago */
    uint32_t seen; /* 1 once y has been measured */
    double x1_hat; /* estimate of x1 */
    double x1_next; /* prediction of x1 without u */
    double x2_hat; /* estimate of x2 */
    double x2_next; /* prediction of x2 without u */
    double x3_hat; /* estimate of x3 */
    double x3_next; /* prediction of x3 without u */
    double d_hat; /* estimate of d */
    double d_next; /* prediction of d without u */
    double deadbeat; /* samples to go at which deadbeat takes over */
    double w1_1; /* weight of x1 in the law */
    double w1_2; /* weight of x2 in the law */
    double w1_3; /* weight of x3 in the law */
    double w2_2; /* weight of x2 in the law */
    double w2_3; /* weight of x3 in the law */
    double w3_2; /* weight of x2 in the law */
    double w3_3; /* weight of x3 in the law */
    double w4_2; /* weight of x2 in the law */
    double w4_3; /* weight of x3 in the law */
    double w4_4; /* weight of u1 in the law */
    double u_max; /* bound of |u| */
} stage12;

/*@ predicate stage12_set(stage12 *c) =
      \is_finite(c->deadbeat)
      && \is_finite(c->w1_1)
      && \is_finite(c->w1_2)
      && \is_finite(c->w1_3)
      && \is_finite(c->w2_2)
      && \is_finite(c->w2_3)
      && \is_finite(c->w3_2)
      && \is_finite(c->w3_3)
      && \is_finite(c->w4_2)
      && \is_finite(c->w4_3)
      && \is_finite(c->w4_4);
 */

/* Takes the parameters and arms at tick 0. PTC_OK, or PTC_E_PARAM with *self untouched. */
/*@ requires self == \null || \valid(self);
    requires params == \null || \valid_read(params);
    assigns *self;
    ensures \result == PTC_OK || \result == PTC_E_PARAM;
    ensures \result == PTC_OK ==> stage12_set(self);
 */
ptc_status stage12_init(stage12 *self, const stage12_params *params);

/*
 * Starts again: the deadline is N samples after tick `k`. Estimates and inputs under way are kept.
 * Estimates too large to compute with begin anew.
 */
/*@ requires self == \null || \valid(self);
    requires self == \null || stage12_set(self);
    assigns *self;
    ensures \result == PTC_OK || \result == PTC_E_INPUT;
    ensures \result >= 0 ==> stage12_set(self);
 */
ptc_status stage12_arm(stage12 *self, uint32_t k);

/*
 * u from tick `k`, which may wrap, and what is measured, y = C x. Call it once for each tick. On a
 * negative status u is 0 and nothing has changed. u must not overlap y.
 */
/*@ requires self == \null || \valid(self);
    requires y == \null || \valid_read(y + (0 .. 1));
    requires u == \null || \valid(u);
    requires self == \null || stage12_set(self);
    assigns *self, *u;
    ensures \result == PTC_SATURATED || \result == PTC_OK || \result == PTC_HOLD || \result == PTC_E_INPUT || \result == PTC_E_RANGE;
    ensures \result >= 0 ==> stage12_set(self);
 */
ptc_status stage12_step(stage12 *self, uint32_t k, const double y[2], double *u);

/* The estimate of the state at the last sample. */
/*@ requires self == \null || \valid_read(self);
    requires xhat == \null || \valid(xhat + (0 .. 2));
    requires self == \null || stage12_set(self);
    assigns xhat[0 .. 2];
    ensures \result == PTC_OK || \result == PTC_E_INPUT;
 */
ptc_status stage12_estimate(const stage12 *self, double xhat[3]);

/* The estimate of the constant that is added to u. */
/*@ requires self == \null || \valid_read(self);
    requires d == \null || \valid(d);
    requires self == \null || stage12_set(self);
    assigns *d;
    ensures \result == PTC_OK || \result == PTC_E_INPUT;
 */
ptc_status stage12_disturbance(const stage12 *self, double *d);

#ifdef __cplusplus
}
#endif

#endif
