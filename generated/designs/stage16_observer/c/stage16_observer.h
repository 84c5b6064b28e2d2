/*
 * Prescribed-time observer stage16_observer: order n = 3, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 3 --mu "exp(a=1)" --name stage16 --what observer --clock samples --A="[[0,1,0],[0,-0.5,1500],[0,-15,-600]]" --B="[0,0,500]" --C="[[1,0,0],[0,0,1]]" --disturbance constant --observer-poles=-4,-5,-6,-7 --observer-samples=20 --after-observer=-90+20i,-90-20i,-100,-120 --sample-time=1e-3 --delay=1
 * Version 0.1.0, design 76c16d95e916.
 *
 * Plant: x' = A x + B (u + d), d constant and unknown of --A and --B above; u held from
 *       sample to sample, one sample late, y = C x.
 * Goal: the estimates of the state and of d are exact up to rounding from sample 20 after the
 *       start on, from any state and at any sample period, as long as the measurement is
 *       exact, u is what was applied and nothing else acts on the plant.
 * Observer: xhat(k) = Phi xhat(k - 1) + Gamma u + G (y(k - 1) - C xhat(k - 1)) with the plant
 *       sampled, Phi and Gamma: the estimates of tick k hold y up to tick k - 1. The gains
 *       follow by duality from the rows that Theorem 1 gives for the mapping exp. Close to
 *       the end deadbeat takes over.
 *
 * Parameters:
 *   h = 1e-3 [s], fixed: sample period
 *   a = 1 [1/s], fixed: rate of stretched time
 *
 * k counts samples and may wrap; arm again within 2^32 - 20 samples.
 * u is the input of tick k - 1 as it was applied, after clipping: it acts from tick k to tick
 *       k + 1, and the observer keeps it until then.
 * From sample 20 on the status is HOLD; from there on the observer has the poles
 *       after_observer.
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
#ifndef STAGE16_OBSERVER_8AD8D9B7_H
#define STAGE16_OBSERVER_8AD8D9B7_H

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
typedef struct stage16_observer_params {
    char none; /* every parameter is fixed */
} stage16_observer_params;

/* Observer: set by init, changed by arm and by what takes it without const. */
typedef struct stage16_observer {
    uint32_t start; /* tick at which it was armed */
    double u1; /* input of 2 samples ago */
    uint32_t seen; /* 1 once y has been measured */
    double x1_hat; /* estimate of x1 */
    double x1_next; /* prediction of x1 without u */
    double x2_hat; /* estimate of x2 */
    double x2_next; /* prediction of x2 without u */
    double x3_hat; /* estimate of x3 */
    double x3_next; /* prediction of x3 without u */
    double d_hat; /* estimate of d */
    double d_next; /* prediction of d without u */
} stage16_observer;

/* Takes the parameters and arms at tick 0. PTC_OK, or PTC_E_PARAM with *self untouched. */
ptc_status stage16_observer_init(stage16_observer *self, const stage16_observer_params *params);

/*
 * Starts a round of 20 samples at tick `k`. Estimates and inputs under way are kept. Estimates too
 * large to compute with begin anew.
 */
ptc_status stage16_observer_arm(stage16_observer *self, uint32_t k);

/*
 * The estimates of tick `k`, which may wrap, from what is measured, y = C x at that tick and u, the
 * input of tick `k` - 1 as it was applied, 0 where there was none. y of tick `k` shows in the
 * estimates from the next tick on. Call it once for each tick, before the law, which takes its
 * estimates. Status Hold from sample 20 on: the round is over. On a negative status nothing has
 * changed.
 */
ptc_status stage16_observer_update(stage16_observer *self, uint32_t k, const double y[2], double u);

/* The estimate of the state at the last sample. */
ptc_status stage16_observer_estimate(const stage16_observer *self, double xhat[3]);

/* The estimate of the constant that is added to u. */
ptc_status stage16_observer_disturbance(const stage16_observer *self, double *d);

#ifdef __cplusplus
}
#endif

#endif
