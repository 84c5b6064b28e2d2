/*
 * Prescribed-time controller stage28: outputs of order 1, 1, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --mu "exp(a=1)" --name stage28 --clock samples --deadbeat=9 --eps=0 --gains="[[3],[4.5]]" --states="a, b" --inputs=A,B --outputs="a, b" --dynamics="A*(b - 1), A + B - k*a"
 * Version 0.1.0, design e8fd88f575ec.
 *
 * Plant: the inputs A, B: a' = A*(b - 1), b' = A + B - k*a, output 1 = a, output 2 = b; u
 *       held from sample to sample.
 * Goal: every output with its derivatives is 0 at sample N after the start, from any state,
 *       as long as no u is clipped and the plant is the model. The plant is known at the
 *       samples alone, which leaves an error of order h^(n+2-i) in x_i of an output of order
 *       n.
 * Law of each output, of order n: with M - s samples to go and z = S x, v h^n = sum of row_j
 *       z_j h^(j-1)/((M-j+1)...(M-n+1)); the rows are those of Theorem 1 for the mapping exp.
 *       v_i is law_i in step. s = 0, 0. Output 1: Close to the end, with 9 samples to go
 *       deadbeat takes over. Output 2: Close to the end, with 9 samples to go deadbeat takes
 *       over.
 * Output 1, of order n = 1:
 *   x_1 = a
 * Output 2, of order n = 1:
 *   x_1 = b
 *   f_2 = -k*a
 * u = adj(D) w/det(D) with w_i = v_i - f_i:
 *   det(D) = b - 1
 *   adj(D) = [[1, 0], [-1, b - 1]]
 * Outputs: 2, each with a law of its own, with this deadline and mapping; u_max is of the
 *       input of this number.
 *   output 1: k = 3
 *   output 2: k = 4.5
 *
 * Parameters:
 *   samples [samples]: samples N from the start to rest
 *   h [s]: sample period
 *   eps = 0 [s], fixed: time-to-go at which the gains are held
 *   u_max [unit of u]: bound of |u|
 *   a = 1 [1/s], fixed: rate of stretched time
 *   k [as in its expression]: parameter of an expression of the design
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
 *   growth: sound: at rest at sample N from any state, but for what f + g u does between
 *       samples, whatever the poles, and |u| is bounded.
 *   sampling: not checked: `loop` bounds what the period leaves of a plant with several
 *       inputs.
 *   deadline: not checked: `loop` bounds what the period leaves of a plant with several
 *       inputs.
 *   loop: not checked: `samples` is left to run time.
 *   envelope: not checked: `x_max` is not given.
 *   zeros: sound: none: the relative degrees are 1, 1, whose sum is the number of states.
 */
#ifndef STAGE28_49679DF8_H
#define STAGE28_49679DF8_H

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
typedef struct stage28_params {
    uint32_t samples; /* samples N from the start to rest [samples], at least 1 */
    double h; /* sample period [s], from 1e-150 to 1e150 */
    double u_max; /* bound of |u| [unit of u], > 0, infinity allowed */
    double k; /* parameter of an expression of the design [as in its expression], finite */
} stage28_params;

/* Controller: set by init, changed by arm and by what takes it without const. */
typedef struct stage28 {
    uint32_t start; /* tick at which it was armed */
    uint32_t samples; /* samples from the start to rest */
    double w1_1_1; /* weight of x1 in the law */
    double b_1_1; /* weight of x1 in the law */
    double w1_1_2; /* weight of x1 in the law */
    double p_k; /* parameter of an expression of the design */
    double c1; /* derived from the parameters */
    double u_max; /* bound of |u| */
} stage28;

/* Takes the parameters and arms at tick 0. PTC_OK, or PTC_E_PARAM with *self untouched. */
ptc_status stage28_init(stage28 *self, const stage28_params *params);

/* Starts again: the deadline is N samples after tick `k`. */
ptc_status stage28_arm(stage28 *self, uint32_t k);

/*
 * u = (A, B) from tick `k`, which may wrap, and state x = (a, b). Where one of them is not finite,
 * as at a state at which the inputs do not decouple the outputs, every u is 0; else the status is
 * SATURATED where one was clipped. u and axes must not overlap x.
 */
ptc_status stage28_step(
    const stage28 *self,
    uint32_t k,
    const double x[2],
    double u[2],
    ptc_status axes[2]);

#ifdef __cplusplus
}
#endif

#endif
