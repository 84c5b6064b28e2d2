/*
 * Prescribed-time controller paced: order n = 2, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 2 --mu "exp(a=1)" --name paced --clock samples --late=extend --pace=soonest --tau=1 --eps=0 --u-min=-1 --poles=-4,-5,-6 --after zero --sample-time=0.01 --delay=1
 * Version 0.1.0, design d3e4f699dd7c.
 *
 * Plant: x1' = x2, x2' = u; u held from sample to sample, one sample late.
 * Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
 *       sample period, as long as u is not clipped and nothing else acts on the plant.
 * Law: with M - 3 samples to go and z = S x, u h^3 = sum of row_j z_j
 *       h^(j-1)/((M-j+1)...(M-2)); the rows are those of Theorem 1 for the mapping exp. The
 *       gains of 3 samples to go stay: they are deadbeat.
 *
 * Parameters:
 *   samples = 100 [samples], fixed: samples N from the start to rest
 *   h = 0.01 [s], fixed: sample period
 *   eps = 0 [s], fixed: time-to-go at which the gains are held
 *   u_max [unit of u]: upper limit of u
 *   u_min = -1 [unit of u], fixed: lower limit of u
 *   a = 1 [1/s], fixed: rate of stretched time
 *   k_1 = 120 [1/s^3], fixed: gains k_i of pi0 = -sum k_i xi_i
 *   k_2 = 74 [1/s^2], fixed: gains k_i of pi0 = -sum k_i xi_i
 *   k_3 = 15 [1/s], fixed: gains k_i of pi0 = -sum k_i xi_i
 *
 * k counts samples and may wrap; arm again within 2^32 - N samples.
 * From sample N on u = 0 (status AFTER).
 * In flight: arm_for sets another deadline at any tick; rest is exact from any state, so all
 *       else stays as it is.
 * Plan: on the way to rest u and the states are sums of falling powers of the samples to go,
 *       so their Bernstein coefficients, linear in z, bound them. If these are within the
 *       limits, u stay there at every sample to rest, where plant and state are as they are
 *       known.
 * late extend: a step without such a plan raises N to the soonest that has one (status LATE;
 *       deadline gives its tick), and others lower N, by at most a sixteenth of the samples
 *       to go. Where none is found (status INFEASIBLE), or 2^31 samples after the start, N
 *       stays, and u is clipped; states may leave their bounds then.
 * u_min <= u <= u_max: u is clipped to these limits (status SATURATED). Clipping voids the
 *       deadline where it lasts.
 * Guard full: what is measured is finite and no pointer is NULL, or the call is refused
 *       (status E_INPUT).
 * Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
 *       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
 *
 * Checks of the design (details: ptc-codegen check):
 *   membership: sound: exp is of class M for all its parameters.
 *   growth: sound: at rest at sample 100 from any state, whatever the poles, and |u| is
 *       bounded.
 *   sampling: not checked: the law is exact in samples, at any period.
 *   deadline: not checked: the law is exact in samples, at any period.
 *   loop: not checked: `x0_max` is not given.
 *   envelope: not checked: it does not examine a clock in samples.
 */
#ifndef PACED_B3B3A719_H
#define PACED_B3B3A719_H

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
typedef struct paced_params {
    double u_max; /* upper limit of u [unit of u], > u_min, infinity allowed */
} paced_params;

/* Controller: set by init, changed by arm and by what takes it without const. */
typedef struct paced {
    uint32_t start; /* tick at which it was armed */
    uint32_t last; /* samples from the start to rest, as planned now */
    double u1; /* input of the last sample */
    double u_max; /* upper limit of u */
} paced;

/* Takes the parameters and arms at tick 0. PTC_OK, or PTC_E_PARAM with *self untouched. */
ptc_status paced_init(paced *self, const paced_params *params);

/*
 * Starts again: the deadline is N samples after tick `k`. Estimates and inputs under way are kept.
 */
ptc_status paced_arm(paced *self, uint32_t k);

/*
 * u from tick `k`, which may wrap, and the state x = (x1, x1', ...). Call it once for each tick. On
 * a negative status u is 0 and nothing has changed. u must not overlap x.
 */
ptc_status paced_step(paced *self, uint32_t k, const double x[2], double *u);

/*
 * Another deadline, at any tick before the call of `step` at it: rest at tick `k` + `samples`, 3 to
 * 2147483648 samples. Estimates and inputs under way are kept. PTC_OK, or PTC_E_PARAM with *self
 * untouched.
 */
ptc_status paced_arm_for(paced *self, uint32_t k, uint32_t samples);

/*
 * The fewest samples found, from the next call of `step` on, with which the law keeps u and the
 * states within their limits at every sample to rest, from the state x, for sure. Give them to
 * `arm_for`. On a negative status samples is unchanged. samples must not overlap x.
 */
ptc_status paced_soonest(const paced *self, const double x[2], uint32_t *samples);

/* The tick at which the loop is to be at rest. */
ptc_status paced_deadline(const paced *self, uint32_t *k);

/*
 * The drive applied `u` in place of the u that the last call of `step` gave. PTC_OK, or PTC_E_INPUT
 * with *self untouched.
 */
ptc_status paced_applied(paced *self, double u);

#ifdef __cplusplus
}
#endif

#endif
