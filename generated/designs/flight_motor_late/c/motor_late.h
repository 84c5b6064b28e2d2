/*
 * Prescribed-time controller motor_late: order n = 2, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 2 --mu "exp(a=1)" --name motor_late --clock samples --A="[[0,1],[0,-5]]" --B="[0,40]" --late=extend --state-max=inf,2 --tau=0.2 --eps=0 --u-max=10 --poles=least-energy --sample-time=0.01
 * Version 0.1.0, design 39b55d4d4f0b.
 *
 * Plant: x' = A x + B u of --A and --B above; u held from sample to sample.
 * Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
 *       sample period, as long as u is not clipped and nothing else acts on the plant.
 * Law: u = -K_M x with M samples to go, of all inputs that end at rest those with the least
 *       sum of u^2. The gains are a table of 832 bytes: exact below 32 samples to go, and
 *       before it those of a grid of 52 nodes, interpolated in a line. The gains of 2 samples
 *       to go stay: they are deadbeat.
 *
 * Parameters:
 *   samples = 20 [samples], fixed: samples N from the start to rest
 *   h = 0.01 [s], fixed: sample period
 *   eps = 0 [s], fixed: time-to-go at which the gains are held
 *   u_max = 10 [unit of u], fixed: bound of |u|
 *   a = 1 [1/s], fixed: rate of stretched time
 *
 * k counts samples and may wrap; arm again within 2^32 - N samples.
 * From sample N on the last gains are held (status HOLD).
 * In flight: arm_for sets another deadline at any tick; rest is exact from any state, so all
 *       else stays as it is.
 * Plan: with M samples to go a table holds u and |x2| <= 2 at some samples of the way to
 *       rest, as rows times x; those at all others are combinations of these whose factors
 *       add up to at most 1 in size, which was examined for each M up to 80. If the rows are
 *       within the limits, the smaller one of u_min and u_max, u and |x2| <= 2 stay there at
 *       every sample to rest, where plant and state are as they are known. A new plan leaves
 *       9.5 % of the limits, by which rows between the samples may grow on the way.
 * late extend: a step without such a plan raises N to the soonest that has one (status LATE;
 *       deadline gives its tick). Where none is found (status INFEASIBLE), or 2^31 samples
 *       after the start, N stays, and u is clipped; states may leave their bounds then.
 * |u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
 *       lasts.
 * Guard full: what is measured is finite and no pointer is NULL, or the call is refused
 *       (status E_INPUT).
 * Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
 *       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
 *
 * Checks of the design (details: ptc-codegen check):
 *   membership: sound: exp is of class M for all its parameters.
 *   growth: sound: at rest at sample 20 from any state, and |u| is bounded.
 *   sampling: not checked: the law is exact in samples, at any period.
 *   deadline: not checked: the law is exact in samples, at any period.
 *   loop: not checked: `x0_max` is not given.
 *   envelope: not checked: it does not examine a clock in samples.
 */
#ifndef MOTOR_LATE_8F77FED6_H
#define MOTOR_LATE_8F77FED6_H

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
typedef struct motor_late_params {
    char none; /* every parameter is fixed */
} motor_late_params;

/* Controller: set by init, changed by arm and by what takes it without const. */
typedef struct motor_late {
    uint32_t start; /* tick at which it was armed */
    uint32_t last; /* samples from the start to rest, as planned now */
} motor_late;

/* Takes the parameters and arms at tick 0. PTC_OK, or PTC_E_PARAM with *self untouched. */
ptc_status motor_late_init(motor_late *self, const motor_late_params *params);

/* Starts again: the deadline is N samples after tick `k`. */
ptc_status motor_late_arm(motor_late *self, uint32_t k);

/*
 * u from tick `k`, which may wrap, and the state x. Call it once for each tick. On a negative
 * status u is 0 and nothing has changed. u must not overlap x.
 */
ptc_status motor_late_step(motor_late *self, uint32_t k, const double x[2], double *u);

/*
 * Another deadline, at any tick before the call of `step` at it: rest at tick `k` + `samples`, 2 to
 * 80 samples. PTC_OK, or PTC_E_PARAM with *self untouched.
 */
ptc_status motor_late_arm_for(motor_late *self, uint32_t k, uint32_t samples);

/*
 * The fewest samples found, from the next call of `step` on, with which the law keeps u and the
 * states within their limits at every sample to rest, from the state x, for sure. Give them to
 * `arm_for`. On a negative status samples is unchanged. samples must not overlap x.
 */
ptc_status motor_late_soonest(const motor_late *self, const double x[2], uint32_t *samples);

/* The tick at which the loop is to be at rest. */
ptc_status motor_late_deadline(const motor_late *self, uint32_t *k);

#ifdef __cplusplus
}
#endif

#endif
