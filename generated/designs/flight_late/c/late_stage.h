/*
 * Prescribed-time controller late_stage: order n = 2, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 2 --mu "exp(a=1)" --name late_stage --clock samples --delay-law=predict --poles-end="least-energy(weight=1)" --end-samples=50 --late=extend --reserve=0.1 --measured=x1 --disturbance constant --observer-poles=-4,-5,-6 --observer-samples=200 --observer-eps=0.03 --tau=0.8 --eps=0.02 --u-max=6 --poles=least-energy --g="2/3" --sample-time=1e-3 --delay=1 --sensor-step=1e-6,0
 * Version 0.1.0, design ccd999de2243.
 *
 * Plant: x1' = x2, x2' = g (u + d), d constant and unknown; u held from sample to sample, one
 *       sample late.
 * Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
 *       sample period, as long as u is not clipped and nothing else acts on the plant.
 * Law of the state x predicted for the time from which u acts, by x and the inputs under way:
 *       with M samples to go and z = S x, u h^2 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-1));
 *       the rows are those of Theorem 1 for the mapping exp. From 50 samples to go on these
 *       are M - 2 and the exponents 3, 4, those of least energy. The gains of 21 samples to
 *       go stay.
 *
 * Parameters:
 *   samples = 800 [samples], fixed: samples N from the start to rest
 *   h = 1e-3 [s], fixed: sample period
 *   eps = 0.02 [s], fixed: time-to-go at which the gains are held
 *   u_max = 6 [unit of u], fixed: bound of |u|
 *   a = 1 [1/s], fixed: rate of stretched time
 *   k_1 = 6 [1/s^2], fixed: gains k_i of pi0 = -sum k_i xi_i
 *   k_2 = 5 [1/s], fixed: gains k_i of pi0 = -sum k_i xi_i
 *
 * k counts samples and may wrap; arm again within 2^32 - N samples.
 * From sample N on the last gains are held (status HOLD).
 * The estimates are exact from sample 200 after the start on where the measurement is; with
 *       noise or sensor_step given, or observer_eps, the gains of the observer are then held
 *       below deadbeat.
 * In flight: arm_for sets another deadline at any tick; rest is exact from any state, so all
 *       else stays as it is.
 * Plan: on the way to rest u and the states are sums of falling powers of the samples to go,
 *       so their Bernstein coefficients, linear in z, bound them. If these are within the
 *       limits, u stay there at every sample to rest, where plant and state are as they are
 *       known.
 * late extend: a step without such a plan raises N to the soonest that has one (status LATE;
 *       deadline gives its tick). Where none is found (status INFEASIBLE), or 2^31 samples
 *       after the start, N stays, and u is clipped; states may leave their bounds then.
 * reserve: a new deadline leaves 0.1 of each limit free.
 * |u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
 *       lasts.
 * Guard full: what is measured is finite and no pointer is NULL, or the call is refused
 *       (status E_INPUT).
 * Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
 *       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
 *
 * Checks of the design (details: ptc-codegen check):
 *   membership: sound: exp is of class M for all its parameters.
 *   growth: sound: near rest at sample 800, not at rest: the gains are held from 20 samples
 *       to go, and |u| is bounded; so does what the held observer leaves of its error.
 *   sampling: not checked: the law is exact in samples, at any period.
 *   deadline: not checked: the law is exact in samples, at any period.
 *   loop: not checked: `x0_max` is not given.
 *   envelope: not checked: it does not examine a clock in samples.
 */
#ifndef LATE_STAGE_AD9DB1E6_H
#define LATE_STAGE_AD9DB1E6_H

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
typedef struct late_stage_params {
    char none; /* every parameter is fixed */
} late_stage_params;

/* Controller: set by init, changed by arm and by what takes it without const. */
typedef struct late_stage {
    uint32_t start; /* tick at which it was armed */
    uint32_t last; /* samples from the start to rest, as planned now */
    double u1; /* input of the last sample */
    double u2; /* input of 2 samples ago */
    uint32_t round; /* samples of the observer's round left at the start */
    uint32_t seen; /* 1 once y has been measured */
    double x1_hat; /* estimate of x1 */
    double x2_hat; /* estimate of x2 */
    double d_hat; /* estimate of d */
} late_stage;

/* Takes the parameters and arms at tick 0. PTC_OK, or PTC_E_PARAM with *self untouched. */
ptc_status late_stage_init(late_stage *self, const late_stage_params *params);

/*
 * Starts again: the deadline is N samples after tick `k`. Estimates and inputs under way are kept.
 * Estimates too large to compute with begin anew.
 */
ptc_status late_stage_arm(late_stage *self, uint32_t k);

/*
 * u from tick `k`, which may wrap, and what is measured, y = (x1, ...). Call it once for each tick.
 * On a negative status u is 0 and nothing has changed. u must not overlap y.
 */
ptc_status late_stage_step(late_stage *self, uint32_t k, const double y[1], double *u);

/*
 * Another deadline, at any tick before the call of `step` at it: rest at tick `k` + `samples`, 3 to
 * 2147483648 samples. Estimates and inputs under way are kept. PTC_OK, or PTC_E_PARAM with *self
 * untouched.
 */
ptc_status late_stage_arm_for(late_stage *self, uint32_t k, uint32_t samples);

/*
 * The fewest samples found, from the next call of `step` on, with which the law keeps u and the
 * states within their limits at every sample to rest, from the estimates as they are predicted for
 * the next tick, for sure. Give them to `arm_for`. On a negative status samples is unchanged.
 */
ptc_status late_stage_soonest(const late_stage *self, uint32_t *samples);

/* The tick at which the loop is to be at rest. */
ptc_status late_stage_deadline(const late_stage *self, uint32_t *k);

/*
 * The target moves by `dx`: from now on y is measured from the new one, and so are the estimates.
 * PTC_OK, or PTC_E_INPUT with *self untouched.
 */
ptc_status late_stage_move(late_stage *self, double dx);

/*
 * The estimates at the tick of the next call are known: it corrects them by what is measured then.
 * PTC_OK, or PTC_E_INPUT with *self untouched.
 */
ptc_status late_stage_assume(late_stage *self, const double xhat[2]);

/* The constant that is added to u is known. PTC_OK, or PTC_E_INPUT with *self untouched. */
ptc_status late_stage_assume_disturbance(late_stage *self, double d);

/*
 * The drive applied `u` in place of the u that the last call of `step` gave. PTC_OK, or PTC_E_INPUT
 * with *self untouched.
 */
ptc_status late_stage_applied(late_stage *self, double u);

/* The estimate of the state at the last sample. */
ptc_status late_stage_estimate(const late_stage *self, double xhat[2]);

/* The estimate of the constant that is added to u. */
ptc_status late_stage_disturbance(const late_stage *self, double *d);

#ifdef __cplusplus
}
#endif

#endif
