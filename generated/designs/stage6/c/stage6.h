/*
 * Prescribed-time controller stage6: order n = 3, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 3 --mu "exp(a=0.7)" --name stage6 --clock samples --measured=x1,x2 --observer-poles=-4,-5.3 --eps=0 --f="1/2" --g="2" --sample-time=2e-3
 * Version 0.1.0, design 6c8ba09a0bea.
 *
 * Plant: x1' = x2, ..., x3' = f + g u; u held from sample to sample.
 * Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
 *       sample period, as long as u is not clipped and nothing else acts on the plant.
 * Law: with M samples to go and z = S x, u h^3 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-2));
 *       the rows are those of Theorem 1 for the mapping exp. Close to the end deadbeat takes
 *       over.
 *
 * Parameters:
 *   samples [samples]: samples N from the start to rest
 *   h = 2e-3 [s], fixed: sample period
 *   eps = 0 [s], fixed: time-to-go at which the gains are held
 *   u_max [unit of u]: bound of |u|
 *   a = 0.7 [1/s], fixed: rate of stretched time
 *   k_1 [1/s^3]: gains k_i of pi0 = -sum k_i xi_i
 *   k_2 [1/s^2]: gains k_i of pi0 = -sum k_i xi_i
 *   k_3 [1/s]: gains k_i of pi0 = -sum k_i xi_i
 *   deadbeat [samples]: samples to go at which deadbeat takes over, 0 for a safe default
 *
 * k counts samples and may wrap; arm again within 2^32 - N samples.
 * From sample N on the last gains are held (status HOLD).
 * The estimates are exact from sample N/2 after the start on where the measurement is; with
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
 *   growth: sound: at rest at sample N from any state, whatever the poles, and |u| is bounded.
 *   sampling: not checked: the law is exact in samples, at any period.
 *   deadline: not checked: the law is exact in samples, at any period.
 *   loop: not checked: `samples` is left to run time.
 *   envelope: not checked: it does not examine a clock in samples.
 */
#ifndef STAGE6_65D10686_H
#define STAGE6_65D10686_H

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
typedef struct stage6_params {
    uint32_t samples; /* samples N from the start to rest [samples], at least 6 */
    double u_max; /* bound of |u| [unit of u], > 0, infinity allowed */
    double k[3]; /* gains k_i of pi0 = -sum k_i xi_i [1/s^3], finite */
    double deadbeat; /* samples to go at which deadbeat takes over, 0 for a safe default [samples], finite */
} stage6_params;

/* Controller: set by init, changed by arm and by what takes it without const. */
typedef struct stage6 {
    uint32_t start; /* tick at which it was armed */
    uint32_t samples; /* samples from the start to rest */
    double u1; /* input of the last sample */
    uint32_t seen; /* 1 once y has been measured */
    double x2_hat; /* estimate of x2 */
    double x3_hat; /* estimate of x3 */
    double deadbeat; /* samples to go at which deadbeat takes over */
    double w1_1; /* weight of x1 in the law */
    double w1_2; /* weight of x2 in the law */
    double w1_3; /* weight of x3 in the law */
    double w2_2; /* weight of x2 in the law */
    double w2_3; /* weight of x3 in the law */
    double w3_3; /* weight of x3 in the law */
    double u_max; /* bound of |u| */
} stage6;

/* Takes the parameters and arms at tick 0. PTC_OK, or PTC_E_PARAM with *self untouched. */
ptc_status stage6_init(stage6 *self, const stage6_params *params);

/*
 * Starts again: the deadline is N samples after tick `k`. Estimates and inputs under way are kept.
 * Estimates too large to compute with begin anew.
 */
ptc_status stage6_arm(stage6 *self, uint32_t k);

/*
 * u from tick `k`, which may wrap, and what is measured, y = (x1, ...). Call it once for each tick.
 * On a negative status u is 0 and nothing has changed. u must not overlap y.
 */
ptc_status stage6_step(stage6 *self, uint32_t k, const double y[2], double *u);

/* The estimates of x2, ... at the last sample. */
ptc_status stage6_estimate(const stage6 *self, double xhat[2]);

#ifdef __cplusplus
}
#endif

#endif
