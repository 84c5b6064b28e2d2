/*
 * Prescribed-time controller table_too_soon: order n = 3, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 3 --axes 2 --mu "exp(a=1)" --name table_too_soon --clock samples --late=refuse --state-max=inf,0.5,4 --tau=1.5 --eps=0 --u-min=runtime --poles="[[-3,-4,-5],[-4,-5,-6]]" --sample-time=0.01
 * Version 0.1.0, design ed84b87c488b.
 *
 * Plant: x1' = x2, ..., x3' = u; u held from sample to sample.
 * Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
 *       sample period, as long as u is not clipped and nothing else acts on the plant.
 * Law: with M samples to go and z = S x, u h^3 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-2));
 *       the rows are those of Theorem 1 for the mapping exp. From 8 samples to go on these
 *       are M - 2 and the exponents 3, 4, 5, those of least energy. The gains of 3 samples to
 *       go stay: they are deadbeat.
 * Axes: 2, each a chain of its own with this deadline and mapping. step computes what depends
 *       on time once.
 *   axis 1: k = 60, 47, 12
 *   axis 2: k = 120, 74, 15
 *
 * Parameters:
 *   samples = 150 [samples], fixed: samples N from the start to rest
 *   h = 0.01 [s], fixed: sample period
 *   eps = 0 [s], fixed: time-to-go at which the gains are held
 *   u_max [unit of u]: upper limit of u
 *   u_min [unit of u]: lower limit of u
 *   a = 1 [1/s], fixed: rate of stretched time
 *
 * k counts samples and may wrap; arm again within 2^32 - N samples.
 * From sample N on the last gains are held (status HOLD).
 * In flight: arm_for sets another deadline at any tick; rest is exact from any state, so all
 *       else stays as it is.
 * Plan: on the way to rest u and the states are sums of falling powers of the samples to go,
 *       so their Bernstein coefficients, linear in z, bound them. If these are within the
 *       limits, u and |x2| <= 0.5 and |x3| <= 4 stay there at every sample to rest, where
 *       plant and state are as they are known.
 * Axes: all come to rest at the same sample, and each deadline is tested for every one of
 *       them.
 * late refuse: arm_for refuses a deadline without such a plan (status E_SOON).
 * u_min <= u <= u_max: u is clipped to these limits (status SATURATED). Clipping voids the
 *       deadline where it lasts.
 * Guard full: what is measured is finite and no pointer is NULL, or the call is refused
 *       (status E_INPUT).
 * Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
 *       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
 *
 * Checks of the design (details: ptc-codegen check):
 *   membership: sound: exp is of class M for all its parameters.
 *   growth: sound: at rest at sample 150 from any state, whatever the poles, and |u| is
 *       bounded.
 *   sampling: not checked: the law is exact in samples, at any period.
 *   deadline: not checked: the law is exact in samples, at any period.
 *   loop: not checked: `x0_max` is not given.
 *   envelope: not checked: it does not examine a clock in samples.
 */
#ifndef TABLE_TOO_SOON_74939701_H
#define TABLE_TOO_SOON_74939701_H

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
typedef struct table_too_soon_params {
    double u_max; /* upper limit of u [unit of u], > u_min, infinity allowed */
    double u_min; /* lower limit of u [unit of u], < u_max, -infinity allowed */
} table_too_soon_params;

/* Controller: set by init, changed by arm and by what takes it without const. */
typedef struct table_too_soon {
    uint32_t start; /* tick at which it was armed */
    uint32_t last; /* samples from the start to rest, as planned now */
    double u_max; /* upper limit of u */
    double u_min; /* lower limit of u */
} table_too_soon;

/* Takes the parameters and arms at tick 0. PTC_OK, or PTC_E_PARAM with *self untouched. */
ptc_status table_too_soon_init(table_too_soon *self, const table_too_soon_params *params);

/* Starts again: the deadline is N samples after tick `k`. */
ptc_status table_too_soon_arm(table_too_soon *self, uint32_t k);

/*
 * u of each axis from tick `k`, which may wrap, and the state x = (x1, x1', ...) of each. Where one
 * of them is not finite, every u is 0; else the status is SATURATED where one was clipped. u and
 * axes must not overlap x.
 */
ptc_status table_too_soon_step(
    const table_too_soon *self,
    uint32_t k,
    const double x[2][3],
    double u[2],
    ptc_status axes[2]);

/*
 * Another deadline, at any tick before the call of `step` at it: rest at tick `k` + `samples`, 3 to
 * 2147483648 samples. A deadline before which a limit could be exceeded is refused (E_SOON).
 * PTC_OK, or PTC_E_PARAM or PTC_E_INPUT or PTC_E_SOON with *self untouched.
 */
ptc_status table_too_soon_arm_for(
    table_too_soon *self,
    uint32_t k,
    uint32_t samples,
    const double x[2][3]);

/*
 * The fewest samples found, from the next call of `step` on, with which the law of each axis keeps
 * u and the states within their limits at every sample to rest, from the state x of each, all of
 * which come to rest at one sample, for sure. Give them to `arm_for`. On a negative status samples
 * is unchanged. samples must not overlap x.
 */
ptc_status table_too_soon_soonest(
    const table_too_soon *self,
    const double x[2][3],
    uint32_t *samples);

/* The tick at which the loop is to be at rest. */
ptc_status table_too_soon_deadline(const table_too_soon *self, uint32_t *k);

#ifdef __cplusplus
}
#endif

#endif
