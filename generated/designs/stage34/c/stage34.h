/*
 * Prescribed-time controller stage34: order n = 3, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 3 --axes 2 --mu exp --name stage34 --clock samples --guard none --eps=0 --g="3" --reference input
 * Version 0.1.0, design 0d8dd7fc9d15.
 *
 * Plant: x1' = x2, ..., x3' = g u; u held from sample to sample.
 * Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
 *       sample period, as long as u is not clipped and nothing else acts on the plant.
 * Law: with M samples to go and z = S x, u h^3 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-2));
 *       the rows are those of Theorem 1 for the mapping exp. Close to the end deadbeat takes
 *       over.
 * With a reference r of each axis, e_i = x_i - r^(i-1) is in place of x_i above, and u = w +
 *       rho/g of each axis. What r^(n) changes over a sample leaves an error of order
 *       h^(n+2-i) in e_i at sample N, h^3 for n = 1, and none where it is constant there.
 * Row i of r is of axis i, of order n: in its places 0..n-1 the reference and its derivatives
 *       at tick k, and in place n rho, r^(n) over the sample in which u acts: its mean,
 *       (r^(n-1)(t + h) - r^(n-1)(t))/h, or that in its middle.
 * Axes: 2, each a chain of its own with this deadline and mapping. step computes what depends
 *       on time once.
 *
 * Parameters:
 *   samples [samples]: samples N from the start to rest
 *   h [s]: sample period
 *   eps = 0 [s], fixed: time-to-go at which the gains are held
 *   u_max [unit of u]: bound of |u|
 *   a [1/s]: rate of stretched time
 *   k_1 [1/s^3]: gains k_i of pi0 = -sum k_i xi_i
 *   k_2 [1/s^2]: gains k_i of pi0 = -sum k_i xi_i
 *   k_3 [1/s]: gains k_i of pi0 = -sum k_i xi_i
 *   deadbeat [samples]: samples to go at which deadbeat takes over, 0 for a safe default
 *
 * k counts samples and may wrap; arm again within 2^32 - N samples.
 * From sample N on the last gains are held (status HOLD).
 * |u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
 *       lasts.
 * Guard none: finite measurements and references and valid pointers are the responsibility of
 *       the caller.
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
#ifndef STAGE34_597452A2_H
#define STAGE34_597452A2_H

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
typedef struct stage34_params {
    uint32_t samples; /* samples N from the start to rest [samples], at least 3 */
    double h; /* sample period [s], from 1e-150 to 1e150 */
    double u_max; /* bound of |u| [unit of u], > 0, infinity allowed */
    double a; /* rate of stretched time [1/s], from 1e-150 to 1e150 */
    double k[3]; /* gains k_i of pi0 = -sum k_i xi_i [1/s^3], finite */
    double deadbeat; /* samples to go at which deadbeat takes over, 0 for a safe default [samples], finite */
} stage34_params;

/* Controller: set by init, changed by arm and by what takes it without const. */
typedef struct stage34 {
    uint32_t start; /* tick at which it was armed */
    uint32_t samples; /* samples from the start to rest */
    double deadbeat_1; /* samples to go at which deadbeat takes over */
    double w1_1_1; /* weight of x1 in the law */
    double w1_2_1; /* weight of x2 in the law */
    double w1_3_1; /* weight of x3 in the law */
    double w2_2_1; /* weight of x2 in the law */
    double w2_3_1; /* weight of x3 in the law */
    double w3_3_1; /* weight of x3 in the law */
    double b_1_1; /* weight of x1 in the law */
    double b_2_1; /* weight of x2 in the law */
    double b_3_1; /* weight of x3 in the law */
    double u_max; /* bound of |u| */
} stage34;

/* Takes the parameters and arms at tick 0. PTC_OK, or PTC_E_PARAM with *self untouched. */
ptc_status stage34_init(stage34 *self, const stage34_params *params);

/* Starts again: the deadline is N samples after tick `k`. */
ptc_status stage34_arm(stage34 *self, uint32_t k);

/*
 * u of each axis from tick `k`, which may wrap, and the state x = (x1, x1', ...) and the reference
 * r of each. Where one of them is not finite, every u is 0; else the status is SATURATED where one
 * was clipped. u and axes must not overlap x or r.
 */
ptc_status stage34_step(
    const stage34 *self,
    uint32_t k,
    const double x[2][3],
    const double r[2][4],
    double u[2],
    ptc_status axes[2]);

#ifdef __cplusplus
}
#endif

#endif
