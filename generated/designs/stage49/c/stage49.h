/*
 * Prescribed-time controller stage49: order n = 2, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 2 --mu "exp(a=1)" --name stage49 --clock samples --A="[[0,1],[-4,-0.2]]" --B="[0,1]" --delay-law=extend --poles-end="least-energy(weight=2)" --end-samples=50 --precision f32 --guard none --tau=1.7 --eps=0 --poles=least-energy --gain-bytes=300 --after zero --sample-time=0.01 --delay=2
 * Version 0.1.0, design 50fbb26d547a.
 *
 * Plant: x' = A x + B u of --A and --B above; u held from sample to sample, 2 samples late.
 * Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
 *       sample period, as long as u is not clipped and nothing else acts on the plant.
 * Law: u = -K_M x with M samples to go, of all inputs that end at rest those with the least
 *       sum of u^2. From 50 samples to go on it is that of u^2/(M ... (M+1)). The gains are a
 *       table of 224 bytes: exact below 8 samples to go, and before it those of a grid of 14
 *       nodes, interpolated in a line. The gains of 4 samples to go stay: they are deadbeat.
 *
 * Parameters:
 *   samples = 170 [samples], fixed: samples N from the start to rest
 *   h = 0.01 [s], fixed: sample period
 *   eps = 0 [s], fixed: time-to-go at which the gains are held
 *   u_max [unit of u]: bound of |u|
 *   a = 1 [1/s], fixed: rate of stretched time
 *
 * k counts samples and may wrap; arm again within 2^32 - N samples.
 * From sample N on u = 0 (status AFTER).
 * |u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
 *       lasts.
 * Guard none: finite measurements and valid pointers are the responsibility of the caller.
 * Precision f32 (IEEE 754 binary32). Results are bit for bit the same on every IEEE 754
 *       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
 *
 * Checks of the design (details: ptc-codegen check):
 *   membership: sound: exp is of class M for all its parameters.
 *   growth: sound: at rest at sample 170 from any state, and |u| is bounded.
 *   sampling: not checked: the law is exact in samples, at any period.
 *   deadline: not checked: the law is exact in samples, at any period.
 *   loop: not checked: `x0_max` is not given.
 *   envelope: not checked: it does not examine a clock in samples.
 */
#ifndef STAGE49_3AFBE7C1_H
#define STAGE49_3AFBE7C1_H

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
typedef struct stage49_params {
    float u_max; /* bound of |u| [unit of u], > 0, infinity allowed */
} stage49_params;

/* Controller: set by init, changed by arm and by what takes it without const. */
typedef struct stage49 {
    uint32_t start; /* tick at which it was armed */
    float u1; /* input of the last sample */
    float u2; /* input of 2 samples ago */
    float u_max; /* bound of |u| */
} stage49;

/* Takes the parameters and arms at tick 0. PTC_OK, or PTC_E_PARAM with *self untouched. */
ptc_status stage49_init(stage49 *self, const stage49_params *params);

/*
 * Starts again: the deadline is N samples after tick `k`. Estimates and inputs under way are kept.
 */
ptc_status stage49_arm(stage49 *self, uint32_t k);

/*
 * u from tick `k`, which may wrap, and the state x. Call it once for each tick. On a negative
 * status u is 0 and nothing has changed. u must not overlap x.
 */
ptc_status stage49_step(stage49 *self, uint32_t k, const float x[2], float *u);

#ifdef __cplusplus
}
#endif

#endif
