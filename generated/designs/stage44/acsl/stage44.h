/*
 * Prescribed-time controller stage44: order n = 3, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 3 --mu "exp(a=1)" --name stage44 --clock samples --A="[[0,1,0],[0,-0.5,15],[0,-15,-60]]" --B="[0,0,50]" --C="[[1,0,0]]" --delay-law=predict --observer-poles=-4,-5,-6 --eps=0.06 --poles=-3,-4,-5 --sample-time=0.01 --delay=1.5
 * Version 0.1.0, design 985c02d3ad50.
 *
 * Plant: x' = A x + B u of --A and --B above; u held from sample to sample, 1.5 samples late,
 *       y = C x.
 * Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
 *       sample period, as long as u is not clipped and nothing else acts on the plant.
 * Law of the state x predicted for the time from which u acts, by x and the inputs under way:
 *       with M samples to go and z = S x, the differences of a flat output, u = sum of row_j
 *       z_j/((M-j+1)...(M-2)) less the drift of z; the rows are those of Theorem 1 for the
 *       mapping exp. The gains of 8 samples to go stay.
 *
 * Parameters:
 *   samples [samples]: samples N from the start to rest
 *   h = 0.01 [s], fixed: sample period
 *   eps = 0.06 [s], fixed: time-to-go at which the gains are held
 *   u_max [unit of u]: bound of |u|
 *   a = 1 [1/s], fixed: rate of stretched time
 *   k_1 = 60 [1/s^3], fixed: gains k_i of pi0 = -sum k_i xi_i
 *   k_2 = 47 [1/s^2], fixed: gains k_i of pi0 = -sum k_i xi_i
 *   k_3 = 12 [1/s], fixed: gains k_i of pi0 = -sum k_i xi_i
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
 *   growth: sound: near rest at sample N, not at rest: the gains are held from 6 samples to
 *       go, and |u| is bounded.
 *   sampling: not checked: the law is exact in samples, at any period.
 *   deadline: not checked: the law is exact in samples, at any period.
 *   loop: not checked: `samples` is left to run time.
 *   envelope: not checked: it does not examine a clock in samples.
 */
#ifndef STAGE44_A561BBC0_H
#define STAGE44_A561BBC0_H

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
typedef struct stage44_params {
    uint32_t samples; /* samples N from the start to rest [samples], at least 10 */
    double u_max; /* bound of |u| [unit of u], > 0, infinity allowed */
} stage44_params;

/* Controller: set by init, changed by arm and by what takes it without const. */
typedef struct stage44 {
    uint32_t start; /* tick at which it was armed */
    uint32_t samples; /* samples from the start to rest */
    double u1; /* input of the last sample */
    double u2; /* input of 2 samples ago */
    double u3; /* input of 3 samples ago */
    uint32_t seen; /* 1 once y has been measured */
    double x1_hat; /* estimate of x1 */
    double x1_next; /* prediction of x1 without u */
    double x2_hat; /* estimate of x2 */
    double x2_next; /* prediction of x2 without u */
    double x3_hat; /* estimate of x3 */
    double x3_next; /* prediction of x3 without u */
    double u_max; /* bound of |u| */
} stage44;

/*@ predicate stage44_set(stage44 *c) =
      \true;
 */

/* Takes the parameters and arms at tick 0. PTC_OK, or PTC_E_PARAM with *self untouched. */
/*@ requires self == \null || \valid(self);
    requires params == \null || \valid_read(params);
    assigns *self;
    ensures \result == PTC_OK || \result == PTC_E_PARAM;
    ensures \result == PTC_OK ==> stage44_set(self);
 */
ptc_status stage44_init(stage44 *self, const stage44_params *params);

/*
 * Starts again: the deadline is N samples after tick `k`. Estimates and inputs under way are kept.
 * Estimates too large to compute with begin anew.
 */
/*@ requires self == \null || \valid(self);
    requires self == \null || stage44_set(self);
    assigns *self;
    ensures \result == PTC_OK || \result == PTC_E_INPUT;
    ensures \result >= 0 ==> stage44_set(self);
 */
ptc_status stage44_arm(stage44 *self, uint32_t k);

/*
 * u from tick `k`, which may wrap, and what is measured, y = C x. Call it once for each tick. On a
 * negative status u is 0 and nothing has changed. u must not overlap y.
 */
/*@ requires self == \null || \valid(self);
    requires y == \null || \valid_read(y + (0 .. 0));
    requires u == \null || \valid(u);
    requires self == \null || stage44_set(self);
    assigns *self, *u;
    ensures \result == PTC_SATURATED || \result == PTC_HOLD || \result == PTC_OK || \result == PTC_E_INPUT || \result == PTC_E_RANGE;
    ensures \result >= 0 ==> stage44_set(self);
 */
ptc_status stage44_step(stage44 *self, uint32_t k, const double y[1], double *u);

/* The estimate of the state at the last sample. */
/*@ requires self == \null || \valid_read(self);
    requires xhat == \null || \valid(xhat + (0 .. 2));
    requires self == \null || stage44_set(self);
    assigns xhat[0 .. 2];
    ensures \result == PTC_OK || \result == PTC_E_INPUT;
 */
ptc_status stage44_estimate(const stage44 *self, double xhat[3]);

#ifdef __cplusplus
}
#endif

#endif
