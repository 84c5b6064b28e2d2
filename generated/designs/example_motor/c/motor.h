/*
 * Prescribed-time controller motor: order n = 3, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 3 --mu "exp(a=1)" --name motor --clock samples --A="[[0,1,0],[0,-0.5,1500],[0,-15,-600]]" --B="[0,0,500]" --C="[[1,0,0]]" --delay-law=predict --disturbance constant --observer-poles=-4,-5,-6,-7 --observer-samples=150 --observer-eps=0.04 --tau=0.4 --eps=0.02 --u-max=24 --poles="least-energy(weight=2)" --sample-time=1e-3 --delay=1 --sensor-step=6e-6
 * Version 0.1.0, design 2a5220d7c7d8.
 *
 * Plant: x' = A x + B (u + d), d constant and unknown of --A and --B above; u held from
 *       sample to sample, one sample late, y = C x.
 * Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
 *       sample period, as long as u is not clipped and nothing else acts on the plant.
 * Law of the state x predicted for the time from which u acts, by x and the inputs under way:
 *       u = -K_M x with M samples to go, of all inputs that end at rest those with the least
 *       sum of u^2/(M ... (M+1)). The gains are a table of 2112 bytes: exact below 32 samples
 *       to go, and before it those of a grid of 88 nodes, interpolated in a line. The gains
 *       of 21 samples to go stay.
 *
 * Parameters:
 *   samples = 400 [samples], fixed: samples N from the start to rest
 *   h = 1e-3 [s], fixed: sample period
 *   eps = 0.02 [s], fixed: time-to-go at which the gains are held
 *   u_max = 24 [unit of u], fixed: bound of |u|
 *   a = 1 [1/s], fixed: rate of stretched time
 *
 * k counts samples and may wrap; arm again within 2^32 - N samples.
 * From sample N on the last gains are held (status HOLD).
 * The estimates are exact from sample 150 after the start on where the measurement is; with
 *       noise or sensor_step given, or observer_eps, the gains of the observer are then held
 *       below deadbeat.
 * |u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
 *       lasts.
 * Guard full: what is measured is finite and no pointer is NULL, or the call is refused
 *       (status E_INPUT).
 * Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
 *       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
 *
 * Checks of the design (details: ptc-codegen check):
 *   membership: sound: exp is of class M for all its parameters.
 *   growth: sound: near rest at sample 400, not at rest: the gains are held from 20 samples
 *       to go, and |u| is bounded; so does what the held observer leaves of its error.
 *   sampling: not checked: the law is exact in samples, at any period.
 *   deadline: not checked: the law is exact in samples, at any period.
 *   loop: not checked: `x0_max` is not given.
 *   envelope: not checked: it does not examine a clock in samples.
 */
#ifndef MOTOR_BB2002E4_H
#define MOTOR_BB2002E4_H

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
typedef struct motor_params {
    char none; /* every parameter is fixed */
} motor_params;

/* Controller: set by init, changed by arm and by what takes it without const. */
typedef struct motor {
    uint32_t start; /* tick at which it was armed */
    double u1; /* input of the last sample */
    double u2; /* input of 2 samples ago */
    uint32_t seen; /* 1 once y has been measured */
    double x1_hat; /* estimate of x1 */
    double x1_next; /* prediction of x1 without u */
    double x2_hat; /* estimate of x2 */
    double x2_next; /* prediction of x2 without u */
    double x3_hat; /* estimate of x3 */
    double x3_next; /* prediction of x3 without u */
    double d_hat; /* estimate of d */
    double d_next; /* prediction of d without u */
} motor;

/* Takes the parameters and arms at tick 0. PTC_OK, or PTC_E_PARAM with *self untouched. */
ptc_status motor_init(motor *self, const motor_params *params);

/*
 * Starts again: the deadline is N samples after tick `k`. Estimates and inputs under way are kept.
 * Estimates too large to compute with begin anew.
 */
ptc_status motor_arm(motor *self, uint32_t k);

/*
 * u from tick `k`, which may wrap, and what is measured, y = C x. Call it once for each tick. On a
 * negative status u is 0 and nothing has changed. u must not overlap y.
 */
ptc_status motor_step(motor *self, uint32_t k, const double y[1], double *u);

/* The estimate of the state at the last sample. */
ptc_status motor_estimate(const motor *self, double xhat[3]);

/* The estimate of the constant that is added to u. */
ptc_status motor_disturbance(const motor *self, double *d);

#ifdef __cplusplus
}
#endif

#endif
