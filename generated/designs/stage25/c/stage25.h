/*
 * Prescribed-time controller stage25: outputs of order 1, 2, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --mu "exp(a=1)" --name stage25 --clock samples --tau=0.3 --eps=0.04 --limits=2,3 --poles="[[-4],[-3,-4.5]]" --states="h, c, e" --inputs=q,p --outputs="h, e" --dynamics="q - 1/10*h, p - c*(1 + h), (c - e)*(1 + h)" --sample-time=0.01
 * Version 0.1.0, design 602ddeccb2d0.
 *
 * Plant: the inputs q, p: h' = q - 1/10*h, c' = p - c*(1 + h), e' = (c - e)*(1 + h), output 1
 *       = h, output 2 = e; u held from sample to sample.
 * Goal: every output with its derivatives is 0 at sample N after the start, from any state,
 *       as long as no u is clipped and the plant is the model. The plant is known at the
 *       samples alone, which leaves an error of order h^(n+2-i) in x_i of an output of order
 *       n.
 * Law of each output, of order n: with M - s samples to go and z = S x, v h^n = sum of row_j
 *       z_j h^(j-1)/((M-j+1)...(M-n+1)); the rows are those of Theorem 1 for the mapping exp.
 *       v_i is law_i in step. s = 2, -2. Output 1: The gains of 4 samples to go stay. Rest is
 *       planned 1 sample early, and the last gains bring down what f and g did between
 *       samples. Output 2: From 6 samples to go on these are M - 2 and the exponents 3, 4,
 *       those of least energy. The gains of 4 samples to go stay. Rest is planned 2 samples
 *       early, and the last gains bring down what f and g did between samples.
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
 * Outputs: 2, each with a law of its own, with this deadline and mapping; u_max is of the
 *       input of this number.
 *   output 1: k = 4; u_max = 2
 *   output 2: k = 13.5, 7.5; u_max = 3
 *
 * Parameters:
 *   samples = 30 [samples], fixed: samples N from the start to rest
 *   h = 0.01 [s], fixed: sample period
 *   eps = 0.04 [s], fixed: time-to-go at which the gains are held
 *   a = 1 [1/s], fixed: rate of stretched time
 *
 * k counts samples and may wrap; arm again within 2^32 - N samples.
 * From sample N on the last gains are held (status HOLD).
 * |u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
 *       lasts.
 * Guard full: what is measured is finite and no pointer is NULL, or the call is refused
 *       (status E_INPUT).
 * Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
 *       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
 *
 * Checks of the design (details: ptc-codegen check):
 *   membership: sound: exp is of class M for all its parameters.
 *   growth: sound: near rest at sample 30, not at rest: the gains are held from 4 samples to
 *       go, and |u| is bounded; so does what f + g u does between samples.
 *   sampling: not checked: `loop` bounds what the period leaves of a plant with several
 *       inputs.
 *   deadline: not checked: `loop` bounds what the period leaves of a plant with several
 *       inputs.
 *   loop: not checked: `x0_max` is not given.
 *   envelope: not checked: `x_max` is not given.
 *   zeros: sound: none: the relative degrees are 1, 2, whose sum is the number of states.
 */
#ifndef STAGE25_81D5B723_H
#define STAGE25_81D5B723_H

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
typedef struct stage25_params {
    char none; /* every parameter is fixed */
} stage25_params;

/* Controller: set by init, changed by arm and by what takes it without const. */
typedef struct stage25 {
    uint32_t start; /* tick at which it was armed */
} stage25;

/* Takes the parameters and arms at tick 0. PTC_OK, or PTC_E_PARAM with *self untouched. */
ptc_status stage25_init(stage25 *self, const stage25_params *params);

/* Starts again: the deadline is N samples after tick `k`. */
ptc_status stage25_arm(stage25 *self, uint32_t k);

/*
 * u = (q, p) from tick `k`, which may wrap, and state x = (h, c, e). Where one of them is not
 * finite, as at a state at which the inputs do not decouple the outputs, every u is 0; else the
 * status is SATURATED where one was clipped. u and axes must not overlap x.
 */
ptc_status stage25_step(
    const stage25 *self,
    uint32_t k,
    const double x[3],
    double u[2],
    ptc_status axes[2]);

#ifdef __cplusplus
}
#endif

#endif
