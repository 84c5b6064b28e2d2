/*
 * Prescribed-time controller elastic: order n = 2, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 2 --mu "exp(a=1)" --name elastic --clock samples --measured=x1 --disturbance constant --observer-poles=-5,-6,-7 --observer-samples=200 --tau=0.5 --eps=0.0965 --u-max=100 --poles=-4,-4.5,-5 --g="2/7" --sample-time=5e-4 --delay=1 --error=1e-3,0.1 --sensor-step=7.7e-6 --x0-max=0.3,1e-6
 * Version 0.1.0, design b13fcc225118.
 *
 * Plant: x1' = x2, x2' = g (u + d), d constant and unknown; u held from sample to sample, one
 *       sample late.
 * Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
 *       sample period, as long as u is not clipped and nothing else acts on the plant.
 * Law: with M samples to go and z = S x, u h^3 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-2));
 *       the rows are those of Theorem 1 for the mapping exp. The gains of 193 samples to go
 *       stay.
 *
 * Parameters:
 *   samples = 1000 [samples], fixed: samples N from the start to rest
 *   h = 5e-4 [s], fixed: sample period
 *   eps = 0.0965 [s], fixed: time-to-go at which the gains are held
 *   u_max = 100 [unit of u], fixed: bound of |u|
 *   a = 1 [1/s], fixed: rate of stretched time
 *   k_1 = 90 [1/s^3], fixed: gains k_i of pi0 = -sum k_i xi_i
 *   k_2 = 60.5 [1/s^2], fixed: gains k_i of pi0 = -sum k_i xi_i
 *   k_3 = 13.5 [1/s], fixed: gains k_i of pi0 = -sum k_i xi_i
 *
 * k counts samples and may wrap; arm again within 2^32 - N samples.
 * From sample N on the last gains are held (status HOLD).
 * The estimates are exact from sample 200 after the start on where the measurement is; with
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
 *   growth: sound: near rest at sample 1000, not at rest: the gains are held from 193 samples
 *       to go, and |u| is bounded.
 *   sampling: not checked: the law is exact in samples, at any period.
 *   deadline: not checked: the law is exact in samples, at any period.
 *   loop: undecided: f = -5*x2/(7/2) is not a sum of bounded symbols; with f = 0, the g of
 *       the law and a rigid plant, at the deadline |x| <= 1.015e-4, 0.002024.
 *   envelope: not checked: it does not examine a clock in samples.
 */
#ifndef ELASTIC_8FE121A7_H
#define ELASTIC_8FE121A7_H

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
typedef struct elastic_params {
    char none; /* every parameter is fixed */
} elastic_params;

/* Controller: set by init, changed by arm and by what takes it without const. */
typedef struct elastic {
    uint32_t start; /* tick at which it was armed */
    double u1; /* input of the last sample */
    double u2; /* input of 2 samples ago */
    uint32_t seen; /* 1 once y has been measured */
    double x1_hat; /* estimate of x1 */
    double x2_hat; /* estimate of x2 */
    double d_hat; /* estimate of d */
} elastic;

/* Takes the parameters and arms at tick 0. PTC_OK, or PTC_E_PARAM with *self untouched. */
ptc_status elastic_init(elastic *self, const elastic_params *params);

/*
 * Starts again: the deadline is N samples after tick `k`. Estimates and inputs under way are kept.
 * Estimates too large to compute with begin anew.
 */
ptc_status elastic_arm(elastic *self, uint32_t k);

/*
 * u from tick `k`, which may wrap, and what is measured, y = (x1, ...). Call it once for each tick.
 * On a negative status u is 0 and nothing has changed. u must not overlap y.
 */
ptc_status elastic_step(elastic *self, uint32_t k, const double y[1], double *u);

/* The estimate of the state at the last sample. */
ptc_status elastic_estimate(const elastic *self, double xhat[2]);

/* The estimate of the constant that is added to u. */
ptc_status elastic_disturbance(const elastic *self, double *d);

#ifdef __cplusplus
}
#endif

#endif
