/*
 * Prescribed-time controller in_flight: order n = 2, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 2 --mu "exp(a=1)" --name in_flight --clock samples --A="[[0,1],[0,-5]]" --B="[0,40]" --C="[[1,0]]" --delay-law=predict --in-flight --disturbance constant --observer=stationary --disturbance-walk=2 --tau=0.3 --eps=0.01 --u-max=10 --poles=least-energy --sample-time=0.001 --delay=0.5 --sensor-step=1e-5
 * Version 0.1.0, design 06b0d7bcf2dc.
 *
 * Plant: x' = A x + B (u + d), d constant and unknown of --A and --B above; u held from
 *       sample to sample, 0.5 samples late, y = C x.
 * Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
 *       sample period, as long as u is not clipped and nothing else acts on the plant.
 * Law of the state x predicted for the time from which u acts, by x and the inputs under way:
 *       u = -K_M x with M samples to go, of all inputs that end at rest those with the least
 *       sum of u^2. The gains are a table of 2128 bytes: exact below 64 samples to go, and
 *       before it those of a grid of 133 nodes, interpolated in a line. The gains of 11
 *       samples to go stay.
 *
 * Parameters:
 *   samples = 300 [samples], fixed: samples N from the start to rest
 *   h = 0.001 [s], fixed: sample period
 *   eps = 0.01 [s], fixed: time-to-go at which the gains are held
 *   u_max = 10 [unit of u], fixed: bound of |u|
 *   a = 1 [1/s], fixed: rate of stretched time
 *
 * k counts samples and may wrap; arm again within 2^32 - N samples.
 * From sample N on the last gains are held (status HOLD).
 * The estimates approach the state from the first sample on: the observer has the gains of
 *       the stationary Kalman filter for the noise and disturbance_walk.
 * In flight: arm_for sets another deadline at any tick; rest is exact from any state, so all
 *       else stays as it is.
 * |u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
 *       lasts.
 * Guard full: what is measured is finite and no pointer is NULL, or the call is refused
 *       (status E_INPUT).
 * Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
 *       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
 *
 * Checks of the design (details: ptc-codegen check):
 *   membership: sound: exp is of class M for all its parameters.
 *   growth: sound: near rest at sample 300, not at rest: the gains are held from 10 samples
 *       to go, and |u| is bounded; so does what the stationary observer leaves of its error.
 *   sampling: not checked: the law is exact in samples, at any period.
 *   deadline: not checked: the law is exact in samples, at any period.
 *   loop: not checked: `x0_max` is not given.
 *   envelope: not checked: it does not examine a clock in samples.
 */
#ifndef IN_FLIGHT_7102032C_H
#define IN_FLIGHT_7102032C_H

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
typedef struct in_flight_params {
    char none; /* every parameter is fixed */
} in_flight_params;

/* Controller: set by init, changed by arm and by what takes it without const. */
typedef struct in_flight {
    uint32_t start; /* tick at which it was armed */
    uint32_t last; /* samples from the start to rest, as planned now */
    double u1; /* input of the last sample */
    double u2; /* input of 2 samples ago */
    uint32_t seen; /* 1 once y has been measured */
    double x1_hat; /* estimate of x1 */
    double x1_next; /* prediction of x1 without u */
    double x2_hat; /* estimate of x2 */
    double x2_next; /* prediction of x2 without u */
    double d_hat; /* estimate of d */
    double d_next; /* prediction of d without u */
} in_flight;

/* Takes the parameters and arms at tick 0. PTC_OK, or PTC_E_PARAM with *self untouched. */
ptc_status in_flight_init(in_flight *self, const in_flight_params *params);

/*
 * Starts again: the deadline is N samples after tick `k`. Estimates and inputs under way are kept.
 * Estimates too large to compute with begin anew.
 */
ptc_status in_flight_arm(in_flight *self, uint32_t k);

/*
 * u from tick `k`, which may wrap, and what is measured, y = C x. Call it once for each tick. On a
 * negative status u is 0 and nothing has changed. u must not overlap y.
 */
ptc_status in_flight_step(in_flight *self, uint32_t k, const double y[1], double *u);

/*
 * Another deadline, at any tick before the call of `step` at it: rest at tick `k` + `samples`, 3 to
 * 300 samples. Estimates and inputs under way are kept. PTC_OK, or PTC_E_PARAM with *self
 * untouched.
 */
ptc_status in_flight_arm_for(in_flight *self, uint32_t k, uint32_t samples);

/* The tick at which the loop is to be at rest. */
ptc_status in_flight_deadline(const in_flight *self, uint32_t *k);

/*
 * The estimates at the tick of the next call are known: it corrects them by what is measured then.
 * PTC_OK, or PTC_E_INPUT with *self untouched.
 */
ptc_status in_flight_assume(in_flight *self, const double xhat[2]);

/* The constant that is added to u is known. PTC_OK, or PTC_E_INPUT with *self untouched. */
ptc_status in_flight_assume_disturbance(in_flight *self, double d);

/*
 * The drive applied `u` in place of the u that the last call of `step` gave. PTC_OK, or PTC_E_INPUT
 * with *self untouched.
 */
ptc_status in_flight_applied(in_flight *self, double u);

/* The estimate of the state at the last sample. */
ptc_status in_flight_estimate(const in_flight *self, double xhat[2]);

/* The estimate of the constant that is added to u. */
ptc_status in_flight_disturbance(const in_flight *self, double *d);

#ifdef __cplusplus
}
#endif

#endif
