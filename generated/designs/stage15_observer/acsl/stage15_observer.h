/*
 * Prescribed-time observer stage15_observer: order n = 2, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 2 --mu "exp(a=1.5)" --name stage15 --what observer --clock samples --measured=x1 --disturbance constant --observer-poles=-4,-5,-6 --observer-samples=9 --observer-eps=0.05 --precision f32 --f="-981/100" --g="1/2" --delay=1.5
 * Version 0.1.0, design fa54d2fef2e7.
 *
 * Plant: x1' = x2, x2' = f + g (u + d), d constant and unknown; u held from sample to sample,
 *       1.5 samples late.
 * Goal: the estimates of the state and of d are as near as the hold at observer_eps leaves
 *       them from sample 9 after the start on, from any state and at any sample period, as
 *       long as the measurement is exact, u is what was applied and nothing else acts on the
 *       plant.
 * Observer: xhat(k) = p + L (y(k) - p1), p = Phi xhat(k - 1) + Gamma u with the chain
 *       sampled, Phi and Gamma: the estimates of tick k hold y up to tick k. The gains follow
 *       by duality from the rows that Theorem 1 gives for the mapping exp. Close to the end
 *       deadbeat takes over.
 *
 * Parameters:
 *   h [s]: sample period
 *   a = 1.5 [1/s], fixed: rate of stretched time
 *
 * k counts samples and may wrap; arm again within 2^32 - 9 samples.
 * u is the input of tick k - 1 as it was applied, after clipping: it acts from 1.5 samples
 *       after tick k - 1 on for one sample, and the observer keeps those under way.
 * From sample 9 on the status is HOLD; with noise or sensor_step given, or observer_eps, the
 *       gains of the observer are then held below deadbeat.
 * Guard full: what is measured and u are finite and no pointer is NULL, or the call is
 *       refused (status E_INPUT).
 * Precision f32 (IEEE 754 binary32). Results are bit for bit the same on every IEEE 754
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
#ifndef STAGE15_OBSERVER_8BB86B2F_H
#define STAGE15_OBSERVER_8BB86B2F_H

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
typedef struct stage15_observer_params {
    float h; /* sample period [s], from 1e-18 to 1e18 */
} stage15_observer_params;

/* Observer: set by init, changed by arm and by what takes it without const. */
typedef struct stage15_observer {
    uint32_t start; /* tick at which it was armed */
    float u1; /* input of 2 samples ago */
    float u2; /* input of 3 samples ago */
    uint32_t seen; /* 1 once y has been measured */
    float x1_hat; /* estimate of x1 */
    float x2_hat; /* estimate of x2 */
    float d_hat; /* estimate of d */
    float phi1_2; /* prediction of x1 from x2 */
    float phi1_3; /* prediction of x1 from d */
    float gamma1; /* prediction from u */
    float late_gamma1; /* prediction from u */
    float phi2_3; /* prediction of x2 from d */
    float gamma2; /* prediction from u */
    float hold_o; /* samples to go at which the observer is held */
    float q2_1; /* weight in the observer's gain l2 */
    float q2_2; /* weight in the observer's gain l2 */
    float q3_1; /* weight in the observer's gain l3 */
} stage15_observer;

/*@ predicate stage15_observer_set(stage15_observer *c) =
      \is_finite(c->phi1_3)
      && \is_finite(c->gamma1)
      && \is_finite(c->late_gamma1)
      && \is_finite(c->phi2_3)
      && \is_finite(c->gamma2)
      && \is_finite(c->hold_o)
      && \is_finite(c->q2_1)
      && \is_finite(c->q2_2)
      && \is_finite(c->q3_1);
 */

/* Takes the parameters and arms at tick 0. PTC_OK, or PTC_E_PARAM with *self untouched. */
/*@ requires self == \null || \valid(self);
    requires params == \null || \valid_read(params);
    assigns *self;
    ensures \result == PTC_OK || \result == PTC_E_PARAM;
    ensures \result == PTC_OK ==> stage15_observer_set(self);
 */
ptc_status stage15_observer_init(stage15_observer *self, const stage15_observer_params *params);

/*
 * Starts a round of 9 samples at tick `k`. Estimates and inputs under way are kept. Estimates too
 * large to compute with begin anew.
 */
/*@ requires self == \null || \valid(self);
    requires self == \null || stage15_observer_set(self);
    assigns *self;
    ensures \result == PTC_OK || \result == PTC_E_INPUT;
    ensures \result >= 0 ==> stage15_observer_set(self);
 */
ptc_status stage15_observer_arm(stage15_observer *self, uint32_t k);

/*
 * The estimates of tick `k`, which may wrap, from what is measured, y = (x1, ...) at that tick and
 * u, the input of tick `k` - 1 as it was applied, 0 where there was none. Call it once for each
 * tick, before the law, which takes its estimates. Status Hold from sample 9 on: the round is over.
 * On a negative status nothing has changed.
 */
/*@ requires self == \null || \valid(self);
    requires y == \null || \valid_read(y + (0 .. 0));
    requires self == \null || stage15_observer_set(self);
    assigns *self;
    ensures \result == PTC_HOLD || \result == PTC_OK || \result == PTC_E_INPUT || \result == PTC_E_RANGE;
    ensures \result >= 0 ==> stage15_observer_set(self);
 */
ptc_status stage15_observer_update(stage15_observer *self, uint32_t k, const float y[1], float u);

/* The estimate of the state at the last sample. */
/*@ requires self == \null || \valid_read(self);
    requires xhat == \null || \valid(xhat + (0 .. 1));
    requires self == \null || stage15_observer_set(self);
    assigns xhat[0 .. 1];
    ensures \result == PTC_OK || \result == PTC_E_INPUT;
 */
ptc_status stage15_observer_estimate(const stage15_observer *self, float xhat[2]);

/* The estimate of the constant that is added to u. */
/*@ requires self == \null || \valid_read(self);
    requires d == \null || \valid(d);
    requires self == \null || stage15_observer_set(self);
    assigns *d;
    ensures \result == PTC_OK || \result == PTC_E_INPUT;
 */
ptc_status stage15_observer_disturbance(const stage15_observer *self, float *d);

#ifdef __cplusplus
}
#endif

#endif
