/*
 * Prescribed-time controller stage20: order n = 2, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 2 --mu "exp(a=1)" --name stage20 --clock samples --measured=x1 --disturbance constant --observer-poles=-4,-5,-6 --eps=0 --f="1/4" --g="1/2" --reference input --delay=1.25
 * Version 0.1.0, design c90aea54cafb.
 *
 * Plant: x1' = x2, x2' = f + g (u + d), d constant and unknown; u held from sample to sample,
 *       1.25 samples late.
 * Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
 *       sample period, as long as u is not clipped and nothing else acts on the plant.
 * Law: with M samples to go and z = S x, u h^4 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-3));
 *       the rows are those of Theorem 1 for the mapping exp. Close to the end deadbeat takes
 *       over.
 * With the reference r, e_i = x_i - r^(i-1) is in place of x_i above, and u = w + rho/g,
 *       where the inputs under way count less the rho of their own samples. At sample N e is
 *       0 where r^(n) is constant over each sample; else an error of order h^(4-i) is left in
 *       e_i.
 * e_i = x_i - r[i-1] with r[0]..r[1] the reference and its derivatives at tick k, and rho =
 *       r[2], r^(n) over the sample in which u acts: its mean, (r^(n-1)(t + h) -
 *       r^(n-1)(t))/h, or that in its middle.
 *
 * Parameters:
 *   samples [samples]: samples N from the start to rest
 *   h [s]: sample period
 *   eps = 0 [s], fixed: time-to-go at which the gains are held
 *   u_max [unit of u]: bound of |u|
 *   a = 1 [1/s], fixed: rate of stretched time
 *   k_1 [1/s^4]: gains k_i of pi0 = -sum k_i xi_i
 *   k_2 [1/s^3]: gains k_i of pi0 = -sum k_i xi_i
 *   k_3 [1/s^2]: gains k_i of pi0 = -sum k_i xi_i
 *   k_4 [1/s]: gains k_i of pi0 = -sum k_i xi_i
 *   deadbeat [samples]: samples to go at which deadbeat takes over, 0 for a safe default
 *
 * k counts samples and may wrap; arm again within 2^32 - N samples.
 * From sample N on the last gains are held (status HOLD).
 * The estimates are exact from sample N/2 after the start on where the measurement is; with
 *       noise or sensor_step given, or observer_eps, the gains of the observer are then held
 *       below deadbeat.
 * |u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
 *       lasts.
 * Guard full: what is measured and the reference are finite and no pointer is NULL, or the
 *       call is refused (status E_INPUT).
 * Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
 *       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
 *
 * Checks of the design (details: ptc-codegen check):
 *   membership: sound: exp is of class M for all its parameters.
 *   growth: sound: at rest at sample N from any state, but for what r does between samples,
 *       whatever the poles, and |u| is bounded.
 *   sampling: not checked: `loop` bounds what the period leaves of a reference that moves.
 *   deadline: not checked: `loop` bounds what the period leaves of a reference that moves.
 *   loop: not checked: `samples` is left to run time.
 *   envelope: not checked: it does not examine a clock in samples.
 */
#ifndef STAGE20_5CDF3A40_H
#define STAGE20_5CDF3A40_H

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
typedef struct stage20_params {
    uint32_t samples; /* samples N from the start to rest [samples], at least 8 */
    double h; /* sample period [s], from 1e-150 to 1e150 */
    double u_max; /* bound of |u| [unit of u], > 0, infinity allowed */
    double k[4]; /* gains k_i of pi0 = -sum k_i xi_i [1/s^4], finite */
    double deadbeat; /* samples to go at which deadbeat takes over, 0 for a safe default [samples], finite */
} stage20_params;

/* Controller: set by init, changed by arm and by what takes it without const. */
typedef struct stage20 {
    uint32_t start; /* tick at which it was armed */
    uint32_t samples; /* samples from the start to rest */
    double u1; /* input of the last sample */
    double u2; /* input of 2 samples ago */
    double u3; /* input of 3 samples ago */
    uint32_t seen; /* 1 once y has been measured */
    double x1_hat; /* estimate of x1 */
    double x2_hat; /* estimate of x2 */
    double d_hat; /* estimate of d */
    double phi1_2; /* prediction of x1 from x2 */
    double phi1_3; /* prediction of x1 from d */
    double gamma1; /* prediction from u */
    double late_gamma1; /* prediction from u */
    double phi2_3; /* prediction of x2 from d */
    double gamma2; /* prediction from u */
    double late_gamma2; /* prediction from u */
    double q2_1; /* weight in the observer's gain l2 */
    double q2_2; /* weight in the observer's gain l2 */
    double q3_1; /* weight in the observer's gain l3 */
    double e2_2; /* gain of the observer at its end */
    double e2_3; /* gain of the observer at its end */
    double e1_2; /* gain of the observer at its end */
    double e1_3; /* gain of the observer at its end */
    double e0_2; /* gain of the observer at its end */
    double e0_3; /* gain of the observer at its end */
    double rho1; /* last one of r, 1 samples ago */
    double rho2; /* last one of r, 2 samples ago */
    double deadbeat; /* samples to go at which deadbeat takes over */
    double w1_1; /* weight of x1 in the law */
    double w1_2; /* weight of x2 in the law */
    double w1_4; /* weight of u2 in the law */
    double w2_2; /* weight of x2 in the law */
    double w2_4; /* weight of u2 in the law */
    double w3_4; /* weight of u2 in the law */
    double w4_3; /* weight of u1 in the law */
    double w4_4; /* weight of u2 in the law */
    double b_1; /* weight of x1 in the law */
    double b_2; /* weight of x2 in the law */
    double u_max; /* bound of |u| */
} stage20;

/* Takes the parameters and arms at tick 0. PTC_OK, or PTC_E_PARAM with *self untouched. */
ptc_status stage20_init(stage20 *self, const stage20_params *params);

/*
 * Starts again: the deadline is N samples after tick `k`. Estimates and inputs under way are kept.
 * Estimates too large to compute with begin anew.
 */
ptc_status stage20_arm(stage20 *self, uint32_t k);

/*
 * u from tick `k`, which may wrap, and what is measured, y = (x1, ...), and the reference. Call it
 * once for each tick. On a negative status u is 0 and nothing has changed. u must not overlap y or
 * r.
 */
ptc_status stage20_step(stage20 *self, uint32_t k, const double y[1], const double r[3], double *u);

/* The estimate of the state at the last sample. */
ptc_status stage20_estimate(const stage20 *self, double xhat[2]);

/* The estimate of the constant that is added to u. */
ptc_status stage20_disturbance(const stage20 *self, double *d);

#ifdef __cplusplus
}
#endif

#endif
