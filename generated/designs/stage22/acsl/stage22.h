/*
 * Prescribed-time controller stage22: order n = 2, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 2 --mu "exp(a=1)" --name stage22 --clock samples --tau=0.3 --eps=0 --poles=-3,-4 --states="q, w" --input=F --output="q + q^3/6" --dynamics="w, F/(2 + q^2) - k*q^3 - 3*w" --reference input --sample-time=0.01
 * Version 0.1.0, design 1531839ead9d.
 *
 * Plant: the input F: q' = w, w' = F/(2 + q^2) - k*q^3 - 3*w, output q + q^3/6; u held from
 *       sample to sample.
 * Goal: the output and its derivatives up to order 1, x, are 0 at sample N after the start,
 *       from any state, as long as u is not clipped and the plant is the model. f and g are
 *       known at the samples alone, which leaves an error of order h^(4-i) in x_i.
 * Law: with M samples to go and z = S x, w h^2 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-1)),
 *       and u = (w - f)/g; the rows are those of Theorem 1 for the mapping exp. The gains of
 *       2 samples to go stay: they are deadbeat. Rest is planned 2 samples early, and the
 *       last gains bring down what f and g did between samples.
 * With the reference r, e_i = x_i - r^(i-1) is in place of x_i above, and u = (w + rho -
 *       f)/g. At sample N e is 0 where r^(n) is constant over each sample; else an error of
 *       order h^(4-i) is left in e_i.
 * e_i = x_i - r[i-1] with r[0]..r[1] the reference and its derivatives at tick k, and rho =
 *       r[2], r^(n) over the sample in which u acts: its mean, (r^(n-1)(t + h) -
 *       r^(n-1)(t))/h, or that in its middle.
 *
 * Parameters:
 *   samples = 30 [samples], fixed: samples N from the start to rest
 *   h = 0.01 [s], fixed: sample period
 *   eps = 0 [s], fixed: time-to-go at which the gains are held
 *   u_max [unit of u]: bound of |u|
 *   a = 1 [1/s], fixed: rate of stretched time
 *   k_1 = 12 [1/s^2], fixed: gains k_i of pi0 = -sum k_i xi_i
 *   k_2 = 7 [1/s], fixed: gains k_i of pi0 = -sum k_i xi_i
 *   k [as in its expression]: parameter of an expression of the design
 *
 * k counts samples and may wrap; arm again within 2^32 - N samples.
 * From sample N on the last gains are held (status HOLD).
 * |u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
 *       lasts.
 * Guard full: what is measured and the reference are finite and no pointer is NULL, or the
 *       call is refused (status E_INPUT).
 * Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
 *       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
 *
 * Checks of the design (details: ptc-codegen check):
 *   membership: sound: exp is of class M for all its parameters.
 *   growth: sound: at rest at sample 30 from any state, but for what f + g u and r do between
 *       samples, whatever the poles, and |u| is bounded.
 *   sampling: not checked: `loop` bounds what the period leaves of a model that is not linear.
 *   deadline: not checked: `loop` bounds what the period leaves of a model that is not linear.
 *   loop: not checked: `k` is left to run time.
 *   envelope: not checked: it does not examine a clock in samples.
 *   zeros: sound: none: the relative degree is 2, the number of states.
 */
#ifndef STAGE22_3D570FE6_H
#define STAGE22_3D570FE6_H

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
typedef struct stage22_params {
    double u_max; /* bound of |u| [unit of u], > 0, infinity allowed */
    double k; /* parameter of an expression of the design [as in its expression], finite */
} stage22_params;

/* Controller: set by init, changed by arm and by what takes it without const. */
typedef struct stage22 {
    uint32_t start; /* tick at which it was armed */
    double p_k; /* parameter of an expression of the design */
    double u_max; /* bound of |u| */
} stage22;

/*@ predicate stage22_set(stage22 *c) =
      \true;
 */

/* Takes the parameters and arms at tick 0. PTC_OK, or PTC_E_PARAM with *self untouched. */
/*@ requires self == \null || \valid(self);
    requires params == \null || \valid_read(params);
    assigns *self;
    ensures \result == PTC_OK || \result == PTC_E_PARAM;
    ensures \result == PTC_OK ==> stage22_set(self);
 */
ptc_status stage22_init(stage22 *self, const stage22_params *params);

/* Starts again: the deadline is N samples after tick `k`. */
/*@ requires self == \null || \valid(self);
    requires self == \null || stage22_set(self);
    assigns *self;
    ensures \result == PTC_OK || \result == PTC_E_INPUT;
    ensures \result >= 0 ==> stage22_set(self);
 */
ptc_status stage22_arm(stage22 *self, uint32_t k);

/*
 * u from tick `k`, which may wrap, and the state x of the model, and the reference. On a negative
 * status u is 0 and nothing has changed. u must not overlap x or r.
 */
/*@ requires self == \null || \valid_read(self);
    requires x == \null || \valid_read(x + (0 .. 1));
    requires r == \null || \valid_read(r + (0 .. 2));
    requires u == \null || \valid(u);
    requires self == \null || stage22_set(self);
    assigns *u;
    ensures \result == PTC_SATURATED || \result == PTC_OK || \result == PTC_HOLD || \result == PTC_E_RANGE || \result == PTC_E_INPUT;
 */
ptc_status stage22_step(
    const stage22 *self,
    uint32_t k,
    const double x[2],
    const double r[3],
    double *u);

#ifdef __cplusplus
}
#endif

#endif
