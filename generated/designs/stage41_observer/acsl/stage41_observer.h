/*
 * Prescribed-time observer stage41_observer: order n = 3, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 3 --mu "exp(a=1)" --name stage41 --what observer --clock samples --A="[[0,1,0],[0,-0.5,15],[0,-15,-60]]" --B="[0,0,50]" --C="[[1,0,0],[0,0,1]]" --observer-poles=-4,-5,-6 --observer-samples=20 --innovation-max=1,0.75 --coast=1 --precision f32 --sample-time=0.01
 * Version 0.1.0, design 5a4b5fc5ddd5.
 *
 * Plant: x' = A x + B u of --A and --B above; u held from sample to sample, y = C x.
 * Goal: the estimates of the state are exact up to rounding from sample 20 after the start
 *       on, from any state and at any sample period, as long as the measurement is exact, u
 *       is what was applied and nothing else acts on the plant.
 * Observer: xhat(k) = Phi xhat(k - 1) + Gamma u + G (y(k - 1) - C xhat(k - 1)) with the plant
 *       sampled, Phi and Gamma: the estimates of tick k hold y up to tick k - 1. The gains
 *       follow by duality from the rows that Theorem 1 gives for the mapping exp. Close to
 *       the end deadbeat takes over.
 *
 * Parameters:
 *   h = 0.01 [s], fixed: sample period
 *   a = 1 [1/s], fixed: rate of stretched time
 *
 * k counts samples and may wrap; arm again within 2^32 - 20 samples.
 * u is the input of tick k - 1 as it was applied, after clipping: it acted from tick k - 1 to
 *       tick k.
 * From sample 20 on the status is HOLD; with noise or sensor_step given, or observer_eps, the
 *       gains of the observer are then held below deadbeat.
 * Gate: a reading that is not finite or further than 1, 0.75 from its prediction is not
 *       believed, and the estimates are predicted alone (status GATED) for at most 1 sample
 *       in a row. Then the call is refused (E_INPUT) until a reading is believed or arm
 *       starts the estimates anew. The first reading has no prediction.
 * Guard full: what is measured passes this gate, u is finite and no pointer is NULL, or the
 *       call is refused (status E_INPUT).
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
#ifndef STAGE41_OBSERVER_CB448168_H
#define STAGE41_OBSERVER_CB448168_H

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
typedef struct stage41_observer_params {
    char none; /* every parameter is fixed */
} stage41_observer_params;

/* Observer: set by init, changed by arm and by what takes it without const. */
typedef struct stage41_observer {
    uint32_t start; /* tick at which it was armed */
    uint32_t seen; /* 1 once y has been measured */
    float x1_hat; /* estimate of x1 */
    float x1_next; /* prediction of x1 without u */
    float x2_hat; /* estimate of x2 */
    float x2_next; /* prediction of x2 without u */
    float x3_hat; /* estimate of x3 */
    float x3_next; /* prediction of x3 without u */
    uint32_t trust; /* samples for which the estimates may be used, the next one included */
} stage41_observer;

/*@ predicate stage41_observer_set(stage41_observer *c) =
      \true;
 */

/* Takes the parameters and arms at tick 0. PTC_OK, or PTC_E_PARAM with *self untouched. */
/*@ requires self == \null || \valid(self);
    assigns *self;
    ensures \result == PTC_OK || \result == PTC_E_PARAM;
    ensures \result == PTC_OK ==> stage41_observer_set(self);
 */
ptc_status stage41_observer_init(stage41_observer *self, const stage41_observer_params *params);

/*
 * Starts a round of 20 samples at tick `k`. The estimates are kept. Estimates that have had no
 * reading for all samples of `coast`, and those too large to compute with, begin anew.
 */
/*@ requires self == \null || \valid(self);
    requires self == \null || stage41_observer_set(self);
    assigns *self;
    ensures \result == PTC_OK || \result == PTC_E_INPUT;
    ensures \result >= 0 ==> stage41_observer_set(self);
 */
ptc_status stage41_observer_arm(stage41_observer *self, uint32_t k);

/*
 * The estimates of tick `k`, which may wrap, from what is measured, y = C x at that tick and u, the
 * input of tick `k` - 1 as it was applied, 0 where there was none. y of tick `k` shows in the
 * estimates from the next tick on. Call it once for each tick, before the law, which takes its
 * estimates. Status Hold from sample 20 on: the round is over. On a negative status nothing has
 * changed.
 */
/*@ requires self == \null || \valid(self);
    requires y == \null || \valid_read(y + (0 .. 1));
    requires self == \null || stage41_observer_set(self);
    assigns *self;
    ensures \result == PTC_GATED || \result == PTC_HOLD || \result == PTC_OK || \result == PTC_E_INPUT || \result == PTC_E_RANGE;
    ensures \result >= 0 ==> stage41_observer_set(self);
 */
ptc_status stage41_observer_update(stage41_observer *self, uint32_t k, const float y[2], float u);

/* The estimate of the state at the last sample. */
/*@ requires self == \null || \valid_read(self);
    requires xhat == \null || \valid(xhat + (0 .. 2));
    requires self == \null || stage41_observer_set(self);
    assigns xhat[0 .. 2];
    ensures \result == PTC_OK || \result == PTC_E_INPUT;
 */
ptc_status stage41_observer_estimate(const stage41_observer *self, float xhat[3]);

#ifdef __cplusplus
}
#endif

#endif
