/*
 * Prescribed-time controller shaken: order n = 2, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 2 --mu "exp(a=1)" --name shaken --clock samples --delay-law=predict --measured=x1 --disturbance="sine(omega=60)" --observer-poles=-4,-5,-6,-7 --observer-samples=200 --observer-eps=0.03 --tau=0.6 --eps=0.01 --u-max=8 --poles="least-energy(weight=1)" --g="2" --sample-time=1e-3 --delay=1.75 --sensor-step=1e-6,0
 * Version 0.1.0, design db5a18285eee.
 *
 * Plant: x1' = x2, x2' = g (u + d), d an unknown sine(omega=60); u held from sample to
 *       sample, 1.75 samples late.
 * Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
 *       sample period, as long as u is not clipped and nothing else acts on the plant. What d
 *       does within a sample remains, of order h^(4-i) in x_i.
 * Law of the state x predicted for the time from which u acts, by x and the inputs under way:
 *       with M samples to go and z = S x, u h^2 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-1));
 *       the rows are those of Theorem 1 for the mapping exp. The gains of 12 samples to go
 *       stay.
 *
 * Parameters:
 *   samples = 600 [samples], fixed: samples N from the start to rest
 *   h = 1e-3 [s], fixed: sample period
 *   eps = 0.01 [s], fixed: time-to-go at which the gains are held
 *   u_max = 8 [unit of u], fixed: bound of |u|
 *   a = 1 [1/s], fixed: rate of stretched time
 *   k_1 = 12 [1/s^2], fixed: gains k_i of pi0 = -sum k_i xi_i
 *   k_2 = 7 [1/s], fixed: gains k_i of pi0 = -sum k_i xi_i
 *
 * k counts samples and may wrap; arm again within 2^32 - N samples.
 * From sample N on the last gains are held (status HOLD).
 * The estimates are exact from sample 200 after the start on where the measurement is; with
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
 *   growth: sound: near rest at sample 600, not at rest: the gains are held from 10 samples
 *       to go, and |u| is bounded; so does what the held observer leaves of its error.
 *   sampling: not checked: the law is exact in samples, at any period.
 *   deadline: not checked: the law is exact in samples, at any period.
 *   loop: not checked: `x0_max` is not given.
 *   envelope: not checked: it does not examine a clock in samples.
 */
#ifndef SHAKEN_C55903C7_H
#define SHAKEN_C55903C7_H

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
typedef struct shaken_params {
    char none; /* every parameter is fixed */
} shaken_params;

/* Controller: set by init, changed by arm and by what takes it without const. */
typedef struct shaken {
    uint32_t start; /* tick at which it was armed */
    double u1; /* input of the last sample */
    double u2; /* input of 2 samples ago */
    double u3; /* input of 3 samples ago */
    uint32_t seen; /* 1 once y has been measured */
    double x1_hat; /* estimate of x1 */
    double x2_hat; /* estimate of x2 */
    double d_hat; /* estimate of d */
    double d_rate_hat; /* estimate of d_rate */
} shaken;

/*@ predicate shaken_set(shaken *c) =
      \true;
 */

/* Takes the parameters and arms at tick 0. PTC_OK, or PTC_E_PARAM with *self untouched. */
/*@ requires self == \null || \valid(self);
    assigns *self;
    ensures \result == PTC_OK || \result == PTC_E_PARAM;
    ensures \result == PTC_OK ==> shaken_set(self);
 */
ptc_status shaken_init(shaken *self, const shaken_params *params);

/*
 * Starts again: the deadline is N samples after tick `k`. Estimates and inputs under way are kept.
 * Estimates too large to compute with begin anew.
 */
/*@ requires self == \null || \valid(self);
    requires self == \null || shaken_set(self);
    assigns *self;
    ensures \result == PTC_OK || \result == PTC_E_INPUT;
    ensures \result >= 0 ==> shaken_set(self);
 */
ptc_status shaken_arm(shaken *self, uint32_t k);

/*
 * u from tick `k`, which may wrap, and what is measured, y = (x1, ...). Call it once for each tick.
 * On a negative status u is 0 and nothing has changed. u must not overlap y.
 */
/*@ requires self == \null || \valid(self);
    requires y == \null || \valid_read(y + (0 .. 0));
    requires u == \null || \valid(u);
    requires self == \null || shaken_set(self);
    assigns *self, *u;
    ensures \result == PTC_SATURATED || \result == PTC_HOLD || \result == PTC_OK || \result == PTC_E_INPUT || \result == PTC_E_RANGE;
    ensures \result >= 0 ==> shaken_set(self);
 */
ptc_status shaken_step(shaken *self, uint32_t k, const double y[1], double *u);

/* The estimate of the state at the last sample. */
/*@ requires self == \null || \valid_read(self);
    requires xhat == \null || \valid(xhat + (0 .. 1));
    requires self == \null || shaken_set(self);
    assigns xhat[0 .. 1];
    ensures \result == PTC_OK || \result == PTC_E_INPUT;
 */
ptc_status shaken_estimate(const shaken *self, double xhat[2]);

/* The estimate of the sine that is added to u. */
/*@ requires self == \null || \valid_read(self);
    requires d == \null || \valid(d);
    requires self == \null || shaken_set(self);
    assigns *d;
    ensures \result == PTC_OK || \result == PTC_E_INPUT;
 */
ptc_status shaken_disturbance(const shaken *self, double *d);

#ifdef __cplusplus
}
#endif

#endif
