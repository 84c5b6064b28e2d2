/*
 * Prescribed-time controller wound: order n = 2, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 2 --mu "exp(a=1)" --name wound --clock samples --A="[[0,1],[0,-5]]" --B="[0,40]" --C="[[1,0]]" --disturbance ramp --observer=stationary --disturbance-walk=5 --tau=0.3 --eps=0.01 --u-max=10 --poles=least-energy --sample-time=0.001 --sensor-step=1e-5
 * Version 0.1.0, design 6978bbac7216.
 *
 * Plant: x' = A x + B (u + d), d an unknown ramp of --A and --B above; u held from sample to
 *       sample, y = C x.
 * Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
 *       sample period, as long as u is not clipped and nothing else acts on the plant. What d
 *       does within a sample remains, of order h^(4-i) in x_i.
 * Law: u = -K_M x with M samples to go, of all inputs that end at rest those with the least
 *       sum of u^2. The gains are a table of 2128 bytes: exact below 64 samples to go, and
 *       before it those of a grid of 133 nodes, interpolated in a line. The gains of 10
 *       samples to go stay.
 *
 * Parameters:
 *   samples = 300 [samples], fixed: samples N from the start to rest
 *   h = 0.001 [s], fixed: sample period
 *   eps = 0.01 [s], fixed: time-to-go at which the gains are held
 *   u_max = 10 [unit of u], fixed: bound of |u|
 *   a = 1 [1/s], fixed: rate of stretched time
 *
 * k counts samples and may wrap; arm again within 2^32 - N samples.
 * From sample N on the last gains are held (status HOLD).
 * The estimates approach the state from the first sample on: the observer has the gains of
 *       the stationary Kalman filter for the noise and disturbance_walk.
 * |u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
 *       lasts.
 * Guard full: what is measured is finite and no pointer is NULL, or the call is refused
 *       (status E_INPUT).
 * Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
 *       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
 *
 * Checks of the design (details: ptc-codegen check):
 *   membership: sound: exp is of class M for all its parameters.
 *   growth: sound: near rest at sample 300, not at rest: the gains are held from 10 samples
 *       to go, and |u| is bounded; so does what the stationary observer leaves of its error.
 *   sampling: not checked: the law is exact in samples, at any period.
 *   deadline: not checked: the law is exact in samples, at any period.
 *   loop: not checked: `x0_max` is not given.
 *   envelope: not checked: it does not examine a clock in samples.
 */
#ifndef WOUND_A8311B97_H
#define WOUND_A8311B97_H

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
typedef struct wound_params {
    char none; /* every parameter is fixed */
} wound_params;

/* Controller: set by init, changed by arm and by what takes it without const. */
typedef struct wound {
    uint32_t start; /* tick at which it was armed */
    double u1; /* input of the last sample */
    uint32_t seen; /* 1 once y has been measured */
    double x1_hat; /* estimate of x1 */
    double x1_next; /* prediction of x1 without u */
    double x2_hat; /* estimate of x2 */
    double x2_next; /* prediction of x2 without u */
    double d_hat; /* estimate of d */
    double d_next; /* prediction of d without u */
    double d_rate_hat; /* estimate of d_rate */
    double d_rate_next; /* prediction of d_rate without u */
} wound;

/*@ predicate wound_set(wound *c) =
      \true;
 */

/* Takes the parameters and arms at tick 0. PTC_OK, or PTC_E_PARAM with *self untouched. */
/*@ requires self == \null || \valid(self);
    assigns *self;
    ensures \result == PTC_OK || \result == PTC_E_PARAM;
    ensures \result == PTC_OK ==> wound_set(self);
 */
ptc_status wound_init(wound *self, const wound_params *params);

/*
 * Starts again: the deadline is N samples after tick `k`. Estimates and inputs under way are kept.
 * Estimates too large to compute with begin anew.
 */
/*@ requires self == \null || \valid(self);
    requires self == \null || wound_set(self);
    assigns *self;
    ensures \result == PTC_OK || \result == PTC_E_INPUT;
    ensures \result >= 0 ==> wound_set(self);
 */
ptc_status wound_arm(wound *self, uint32_t k);

/*
 * u from tick `k`, which may wrap, and what is measured, y = C x. Call it once for each tick. On a
 * negative status u is 0 and nothing has changed. u must not overlap y.
 */
/*@ requires self == \null || \valid(self);
    requires y == \null || \valid_read(y + (0 .. 0));
    requires u == \null || \valid(u);
    requires self == \null || wound_set(self);
    assigns *self, *u;
    ensures \result == PTC_SATURATED || \result == PTC_HOLD || \result == PTC_OK || \result == PTC_E_INPUT || \result == PTC_E_RANGE;
    ensures \result >= 0 ==> wound_set(self);
 */
ptc_status wound_step(wound *self, uint32_t k, const double y[1], double *u);

/* The estimate of the state at the last sample. */
/*@ requires self == \null || \valid_read(self);
    requires xhat == \null || \valid(xhat + (0 .. 1));
    requires self == \null || wound_set(self);
    assigns xhat[0 .. 1];
    ensures \result == PTC_OK || \result == PTC_E_INPUT;
 */
ptc_status wound_estimate(const wound *self, double xhat[2]);

/* The estimate of the ramp that is added to u. */
/*@ requires self == \null || \valid_read(self);
    requires d == \null || \valid(d);
    requires self == \null || wound_set(self);
    assigns *d;
    ensures \result == PTC_OK || \result == PTC_E_INPUT;
 */
ptc_status wound_disturbance(const wound *self, double *d);

#ifdef __cplusplus
}
#endif

#endif
