/*
 * Prescribed-time controller stage31: outputs of order 1, 2, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --mu "exp(a=1)" --name stage31 --clock samples --eps=0 --limits=2,3 --poles="[[-4],[-3,-4.5]]" --states="h, c, e" --inputs=q,p --outputs="h, e" --dynamics="q - 1/10*h, p - c*(1 + h), (c - e)*(1 + h)" --reference input
 * Version 0.1.0, design 2c157dacc07c.
 *
 * Plant: the inputs q, p: h' = q - 1/10*h, c' = p - c*(1 + h), e' = (c - e)*(1 + h), output 1
 *       = h, output 2 = e; u held from sample to sample.
 * Goal: every output with its derivatives is 0 at sample N after the start, from any state,
 *       as long as no u is clipped and the plant is the model. The plant is known at the
 *       samples alone, which leaves an error of order h^(n+2-i) in x_i of an output of order
 *       n.
 * Law of each output, of order n: with M - s samples to go and z = S x, v h^n = sum of row_j
 *       z_j h^(j-1)/((M-j+1)...(M-n+1)); the rows are those of Theorem 1 for the mapping exp.
 *       v_i is law_i in step. s = 2, -2. Output 1: The gains of 1 sample to go stay: they are
 *       deadbeat. Rest is planned 1 sample early, and the last gains bring down what f and g
 *       did between samples. Output 2: From 6 samples to go on these are M - 2 and the
 *       exponents 3, 4, those of least energy. The gains of 2 samples to go stay: they are
 *       deadbeat. Rest is planned 2 samples early, and the last gains bring down what f and g
 *       did between samples.
 * Output 1, of order n = 1:
 *   x_1 = h
 *   f_1 = -h/10
 * Output 2, of order n = 2:
 *   x_1 = e
 *   x_2 = (c - e)*(1 + h)
 *   f_2 = (-c*(1 + h) - (c - e)*(1 + h))*(1 + h) + (c - e)*(-h/10)
 * u = adj(D) w/det(D) with w_i = v_i - f_i:
 *   det(D) = 1 + h
 *   adj(D) = [[1 + h, 0], [-(c - e), 1]]
 * With a reference r of each output, e_i = x_i - r^(i-1) is in place of x_i above, and law_i
 *       = v_i + rho of output i is in place of v_i. What r^(n) changes over a sample leaves
 *       an error of order h^(n+2-i) in e_i at sample N, h^3 for n = 1, and none where it is
 *       constant there.
 * Row i of r is of output i, of order n: in its places 0..n-1 the reference and its
 *       derivatives at tick k, and in place n rho, r^(n) over the sample in which u acts: its
 *       mean, (r^(n-1)(t + h) - r^(n-1)(t))/h, or that in its middle.
 * Outputs: 2, each with a law of its own, with this deadline and mapping; u_max is of the
 *       input of this number.
 *   output 1: k = 4; u_max = 2
 *   output 2: k = 13.5, 7.5; u_max = 3
 *
 * Parameters:
 *   samples [samples]: samples N from the start to rest
 *   h [s]: sample period
 *   eps = 0 [s], fixed: time-to-go at which the gains are held
 *   a = 1 [1/s], fixed: rate of stretched time
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
 *   growth: sound: at rest at sample N from any state, but for what f + g u and r do between
 *       samples, whatever the poles, and |u| is bounded.
 *   sampling: not checked: `loop` bounds what the period leaves of a plant with several
 *       inputs.
 *   deadline: not checked: `loop` bounds what the period leaves of a plant with several
 *       inputs.
 *   loop: not checked: `samples` is left to run time.
 *   envelope: not checked: `x_max` is not given.
 *   zeros: sound: none: the relative degrees are 1, 2, whose sum is the number of states.
 */
#ifndef STAGE31_62D4CBBE_H
#define STAGE31_62D4CBBE_H

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
typedef struct stage31_params {
    uint32_t samples; /* samples N from the start to rest [samples], at least 2 */
    double h; /* sample period [s], from 1e-150 to 1e150 */
} stage31_params;

/* Controller: set by init, changed by arm and by what takes it without const. */
typedef struct stage31 {
    uint32_t start; /* tick at which it was armed */
    uint32_t samples; /* samples from the start to rest */
    double w1_1_1; /* weight of x1 in the law */
    double w1_1_2; /* weight of x1 in the law */
    double w1_2_2; /* weight of x2 in the law */
    double w2_2_2; /* weight of x2 in the law */
    double end1_1_2; /* weight of x1 in the law */
    double end1_2_2; /* weight of x2 in the law */
    double end2_2_2; /* weight of x2 in the law */
} stage31;

/* Takes the parameters and arms at tick 0. PTC_OK, or PTC_E_PARAM with *self untouched. */
ptc_status stage31_init(stage31 *self, const stage31_params *params);

/* Starts again: the deadline is N samples after tick `k`. */
ptc_status stage31_arm(stage31 *self, uint32_t k);

/*
 * u = (q, p) from tick `k`, which may wrap, state x = (h, c, e) and the reference r of each output.
 * Where one of them is not finite, as at a state at which the inputs do not decouple the outputs,
 * every u is 0; else the status is SATURATED where one was clipped. u and axes must not overlap x
 * or r.
 */
ptc_status stage31_step(
    const stage31 *self,
    uint32_t k,
    const double x[3],
    const double r[2][3],
    double u[2],
    ptc_status axes[2]);

#ifdef __cplusplus
}
#endif

#endif
