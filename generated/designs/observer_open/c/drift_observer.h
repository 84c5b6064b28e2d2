/*
 * Prescribed-time observer drift_observer: order n = 3, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 3 --mu "exp(a=1)" --name drift --what observer --clock samples --measured=x1,x2 --disturbance ramp --observer-poles=-4,-5,-6,-7 --observer-samples=60
 * Version 0.1.0, design 3d13f742d37b.
 *
 * Plant: x1' = x2, ..., x3' = (u + d), d an unknown ramp; u held from sample to sample.
 * Goal: the estimates of the state and of d are exact up to rounding from sample 60 after the
 *       start on, from any state and at any sample period, as long as the measurement is
 *       exact, u is what was applied and nothing else acts on the plant.
 * Observer: xhat(k) = p + L (y(k) - p1), p = Phi xhat(k - 1) + Gamma u with the chain
 *       sampled, Phi and Gamma: the estimates of tick k hold y up to tick k. The gains follow
 *       by duality from the rows that Theorem 1 gives for the mapping exp. Close to the end
 *       deadbeat takes over.
 *
 * Parameters:
 *   h [s]: sample period
 *   a = 1 [1/s], fixed: rate of stretched time
 *
 * k counts samples and may wrap; arm again within 2^32 - 60 samples.
 * u is the input of tick k - 1 as it was applied, after clipping: it acted from tick k - 1 to
 *       tick k.
 * From sample 60 on the status is HOLD; with noise or sensor_step given, or observer_eps, the
 *       gains of the observer are then held below deadbeat.
 * Guard full: what is measured and u are finite and no pointer is NULL, or the call is
 *       refused (status E_INPUT).
 * Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
 *       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
 *
 * Checks of the design (details: ptc-codegen check):
 *   membership: sound: exp is of class M for all its parameters.
 *   growth: not checked: an observer alone has no law.
 *   sampling: not checked: an observer alone has no law.
 *   deadline: not checked: an observer alone has no law.
 *   loop: not checked: an observer alone has no law.
 *   envelope: not checked: an observer alone has no law.
 */
#ifndef DRIFT_OBSERVER_6247F297_H
#define DRIFT_OBSERVER_6247F297_H

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
typedef struct drift_observer_params {
    double h; /* sample period [s], from 1e-150 to 1e150 */
} drift_observer_params;

/* Observer: set by init, changed by arm and by what takes it without const. */
typedef struct drift_observer {
    uint32_t start; /* tick at which it was armed */
    uint32_t seen; /* 1 once y has been measured */
    double x2_hat; /* estimate of x2 */
    double x3_hat; /* estimate of x3 */
    double d_hat; /* estimate of d */
    double d_rate_hat; /* estimate of d_rate */
    double phi1_2; /* prediction of x2 from x3 */
    double phi1_3; /* prediction of x2 from d */
    double phi1_4; /* prediction of x2 from d_rate */
    double q2_1; /* weight in the observer's gain l2 */
    double q2_2; /* weight in the observer's gain l2 */
    double q2_3; /* weight in the observer's gain l2 */
    double q3_1; /* weight in the observer's gain l3 */
    double q3_2; /* weight in the observer's gain l3 */
    double q4_1; /* weight in the observer's gain l4 */
    double e3_2; /* gain of the observer at its end */
    double e3_3; /* gain of the observer at its end */
    double e3_4; /* gain of the observer at its end */
    double e2_2; /* gain of the observer at its end */
    double e2_4; /* gain of the observer at its end */
    double e1_2; /* gain of the observer at its end */
    double e1_3; /* gain of the observer at its end */
    double e1_4; /* gain of the observer at its end */
    double e0_2; /* gain of the observer at its end */
    double e0_3; /* gain of the observer at its end */
    double e0_4; /* gain of the observer at its end */
} drift_observer;

/* Takes the parameters and arms at tick 0. PTC_OK, or PTC_E_PARAM with *self untouched. */
ptc_status drift_observer_init(drift_observer *self, const drift_observer_params *params);

/*
 * Starts a round of 60 samples at tick `k`. The estimates are kept. Estimates too large to compute
 * with begin anew.
 */
ptc_status drift_observer_arm(drift_observer *self, uint32_t k);

/*
 * The estimates of tick `k`, which may wrap, from what is measured, y = (x1, ...) at that tick and
 * u, the input of tick `k` - 1 as it was applied, 0 where there was none. Call it once for each
 * tick, before the law, which takes its estimates. Status Hold from sample 60 on: the round is
 * over. On a negative status nothing has changed.
 */
ptc_status drift_observer_update(drift_observer *self, uint32_t k, const double y[2], double u);

/* The estimates of x2, ... at the last sample. */
ptc_status drift_observer_estimate(const drift_observer *self, double xhat[2]);

/* The estimate of the ramp that is added to u. */
ptc_status drift_observer_disturbance(const drift_observer *self, double *d);

#ifdef __cplusplus
}
#endif

#endif
