/*
 * Prescribed-time controller masses_refuse: order n = 2, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 2 --mu "exp(a=1)" --name masses_refuse --clock samples --A="[[0,1],[-400,-2]]" --B="[0,40]" --C="[[1,0]]" --delay-law=predict --late=refuse --reserve=0.1 --disturbance constant --observer=stationary --disturbance-walk=0.5 --precision f32 --tau=0.2 --eps=0.04 --u-max=10 --poles="least-energy(weight=1)" --sample-time=0.01 --delay=1 --sensor-step=1e-5
 * Version 0.1.0, design 4c1e1b44d4b2.
 *
 * Plant: x' = A x + B (u + d), d constant and unknown of --A and --B above; u held from
 *       sample to sample, one sample late, y = C x.
 * Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
 *       sample period, as long as u is not clipped and nothing else acts on the plant.
 * Law of the state x predicted for the time from which u acts, by x and the inputs under way:
 *       u = -K_M x with M samples to go, of all inputs that end at rest those with the least
 *       sum of u^2/M. The gains are a table of 576 bytes: exact below 64 samples to go, and
 *       before it those of a grid of 72 nodes, interpolated in a line. The gains of 5 samples
 *       to go stay.
 *
 * Parameters:
 *   samples = 20 [samples], fixed: samples N from the start to rest
 *   h = 0.01 [s], fixed: sample period
 *   eps = 0.04 [s], fixed: time-to-go at which the gains are held
 *   u_max = 10 [unit of u], fixed: bound of |u|
 *   a = 1 [1/s], fixed: rate of stretched time
 *
 * k counts samples and may wrap; arm again within 2^32 - N samples.
 * From sample N on the last gains are held (status HOLD).
 * The estimates approach the state from the first sample on: the observer has the gains of
 *       the stationary Kalman filter for the noise and disturbance_walk.
 * In flight: arm_for sets another deadline at any tick; rest is exact from any state, so all
 *       else stays as it is.
 * Plan: with M samples to go a table holds u at some samples of the way to rest, as rows
 *       times x; those at all others are combinations of these whose factors add up to at
 *       most 1 in size, which was examined for each M up to 80. If the rows are within the
 *       limits, the smaller one of u_min and u_max, u stay there at every sample to rest,
 *       where plant and state are as they are known. A new plan leaves 5.6 % of the limits,
 *       by which rows between the samples may grow on the way.
 * late refuse: arm_for refuses a deadline without such a plan (status E_SOON).
 * reserve: a new deadline leaves 0.1 of each limit free.
 * |u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
 *       lasts.
 * Guard full: what is measured is finite and no pointer is NULL, or the call is refused
 *       (status E_INPUT).
 * Precision f32 (IEEE 754 binary32). Results are bit for bit the same on every IEEE 754
 *       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
 *
 * Checks of the design (details: ptc-codegen check):
 *   membership: sound: exp is of class M for all its parameters.
 *   growth: sound: near rest at sample 20, not at rest: the gains are held from 4 samples to
 *       go, and |u| is bounded; so does what the stationary observer leaves of its error.
 *   sampling: not checked: the law is exact in samples, at any period.
 *   deadline: not checked: the law is exact in samples, at any period.
 *   loop: not checked: `x0_max` is not given.
 *   envelope: not checked: it does not examine a clock in samples.
 */
#ifndef MASSES_REFUSE_95EDB2CE_H
#define MASSES_REFUSE_95EDB2CE_H

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
typedef struct masses_refuse_params {
    char none; /* every parameter is fixed */
} masses_refuse_params;

/* Controller: set by init, changed by arm and by what takes it without const. */
typedef struct masses_refuse {
    uint32_t start; /* tick at which it was armed */
    uint32_t last; /* samples from the start to rest, as planned now */
    float u1; /* input of the last sample */
    float u2; /* input of 2 samples ago */
    uint32_t seen; /* 1 once y has been measured */
    float x1_hat; /* estimate of x1 */
    float x1_next; /* prediction of x1 without u */
    float x2_hat; /* estimate of x2 */
    float x2_next; /* prediction of x2 without u */
    float d_hat; /* estimate of d */
    float d_next; /* prediction of d without u */
} masses_refuse;

/* Takes the parameters and arms at tick 0. PTC_OK, or PTC_E_PARAM with *self untouched. */
ptc_status masses_refuse_init(masses_refuse *self, const masses_refuse_params *params);

/*
 * Starts again: the deadline is N samples after tick `k`. Estimates and inputs under way are kept.
 * Estimates too large to compute with begin anew.
 */
ptc_status masses_refuse_arm(masses_refuse *self, uint32_t k);

/*
 * u from tick `k`, which may wrap, and what is measured, y = C x. Call it once for each tick. On a
 * negative status u is 0 and nothing has changed. u must not overlap y.
 */
ptc_status masses_refuse_step(masses_refuse *self, uint32_t k, const float y[1], float *u);

/*
 * Another deadline, at any tick before the call of `step` at it: rest at tick `k` + `samples`, 3 to
 * 80 samples. Estimates and inputs under way are kept. A deadline before which a limit could be
 * exceeded is refused (E_SOON). PTC_OK, or PTC_E_PARAM or PTC_E_INPUT or PTC_E_SOON with *self
 * untouched.
 */
ptc_status masses_refuse_arm_for(masses_refuse *self, uint32_t k, uint32_t samples);

/*
 * The fewest samples found, from the next call of `step` on, with which the law keeps u and the
 * states within their limits at every sample to rest, from the estimates as they are predicted for
 * the next tick, for sure. Give them to `arm_for`. On a negative status samples is unchanged.
 */
ptc_status masses_refuse_soonest(const masses_refuse *self, uint32_t *samples);

/* The tick at which the loop is to be at rest. */
ptc_status masses_refuse_deadline(const masses_refuse *self, uint32_t *k);

/*
 * The estimates at the tick of the next call are known: it corrects them by what is measured then.
 * PTC_OK, or PTC_E_INPUT with *self untouched.
 */
ptc_status masses_refuse_assume(masses_refuse *self, const float xhat[2]);

/* The constant that is added to u is known. PTC_OK, or PTC_E_INPUT with *self untouched. */
ptc_status masses_refuse_assume_disturbance(masses_refuse *self, float d);

/*
 * The drive applied `u` in place of the u that the last call of `step` gave. PTC_OK, or PTC_E_INPUT
 * with *self untouched.
 */
ptc_status masses_refuse_applied(masses_refuse *self, float u);

/* The estimate of the state at the last sample. */
ptc_status masses_refuse_estimate(const masses_refuse *self, float xhat[2]);

/* The estimate of the constant that is added to u. */
ptc_status masses_refuse_disturbance(const masses_refuse *self, float *d);

#ifdef __cplusplus
}
#endif

#endif
