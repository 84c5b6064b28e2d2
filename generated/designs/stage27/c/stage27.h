/*
 * Prescribed-time controller stage27: outputs of order 1, 2, 1, 2, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --mu "exp(a=0.8)" --name stage27 --clock samples --eps=0 --u-max=inf --poles="[[-4],[-3,-4],[-5],[-2.5,-6]]" --states="a, b, b1, c, d, d1" --inputs=A,B,C,D --outputs="a, b, c, d" --dynamics="A*(2 + b^2) + B - a*c, b1, B*(3 + a) + C*d - b*d1, C + D*a - c^2, d1, D*(2 - b) + A*c + a"
 * Version 0.1.0, design 7fcab43de361.
 *
 * Plant: the inputs A, B, C, D: a' = A*(2 + b^2) + B - a*c, b' = b1, b1' = B*(3 + a) + C*d -
 *       b*d1, c' = C + D*a - c^2, d' = d1, d1' = D*(2 - b) + A*c + a, output 1 = a, output 2
 *       = b, output 3 = c, output 4 = d; u held from sample to sample.
 * Goal: every output with its derivatives is 0 at sample N after the start, from any state,
 *       as long as no u is clipped and the plant is the model. The plant is known at the
 *       samples alone, which leaves an error of order h^(n+2-i) in x_i of an output of order
 *       n.
 * Law of each output, of order n: with M - s samples to go and z = S x, v h^n = sum of row_j
 *       z_j h^(j-1)/((M-j+1)...(M-n+1)); the rows are those of Theorem 1 for the mapping exp.
 *       v_i is law_i in step. s = 3, -2, -1, -2. Output 1: The gains of 1 sample to go stay:
 *       they are deadbeat. Rest is planned 1 sample early, and the last gains bring down what
 *       f and g did between samples. Output 2: From 6 samples to go on these are M - 3 and
 *       the exponents 4, 5, those of least energy. The gains of 2 samples to go stay: they
 *       are deadbeat. Rest is planned 2 samples early, and the last gains bring down what f
 *       and g did between samples. Output 3: From 7 samples to go on these are M - 6 and the
 *       exponents 7, those of least energy. The gains of 1 sample to go stay: they are
 *       deadbeat. Rest is planned 1 sample early, and the last gains bring down what f and g
 *       did between samples. Output 4: From 9 samples to go on these are M - 3 and the
 *       exponents 4, 5, those of least energy. The gains of 2 samples to go stay: they are
 *       deadbeat. Rest is planned 2 samples early, and the last gains bring down what f and g
 *       did between samples.
 * Output 1, of order n = 1:
 *   x_1 = a
 *   f_1 = -a*c
 * Output 2, of order n = 2:
 *   x_1 = b
 *   x_2 = b1
 *   f_2 = -b*d1
 * Output 3, of order n = 1:
 *   x_1 = c
 *   f_3 = -c^2
 * Output 4, of order n = 2:
 *   x_1 = d
 *   x_2 = d1
 *   f_4 = a
 * u of D u = w with w_i = v_i - f_i, by elimination with pivots:
 *   D = [[2 + b^2, 1, 0, 0], [0, 3 + a, d, 0], [0, 0, 1, a], [c, 0, 0, 2 - b]]
 * Outputs: 4, each with a law of its own, with this deadline and mapping; u_max is of the
 *       input of this number.
 *   output 1: k = 4
 *   output 2: k = 12, 7
 *   output 3: k = 5
 *   output 4: k = 15, 8.5
 *
 * Parameters:
 *   samples [samples]: samples N from the start to rest
 *   h [s]: sample period
 *   eps = 0 [s], fixed: time-to-go at which the gains are held
 *   u_max = inf [unit of u], fixed: bound of |u|
 *   a = 0.8 [1/s], fixed: rate of stretched time
 *
 * k counts samples and may wrap; arm again within 2^32 - N samples.
 * From sample N on the last gains are held (status HOLD).
 * u is not clipped.
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
 *   zeros: sound: none: the relative degrees are 1, 2, 1, 2, whose sum is the number of
 *       states.
 */
#ifndef STAGE27_84E1A271_H
#define STAGE27_84E1A271_H

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
typedef struct stage27_params {
    uint32_t samples; /* samples N from the start to rest [samples], at least 2 */
    double h; /* sample period [s], from 1e-150 to 1e150 */
} stage27_params;

/* Controller: set by init, changed by arm and by what takes it without const. */
typedef struct stage27 {
    uint32_t start; /* tick at which it was armed */
    uint32_t samples; /* samples from the start to rest */
    double w1_1_1; /* weight of x1 in the law */
    double w1_1_2; /* weight of x1 in the law */
    double w1_2_2; /* weight of x2 in the law */
    double w2_2_2; /* weight of x2 in the law */
    double end1_1_2; /* weight of x1 in the law */
    double end1_2_2; /* weight of x2 in the law */
    double end2_2_2; /* weight of x2 in the law */
    double w1_1_3; /* weight of x1 in the law */
    double end1_1_3; /* weight of x1 in the law */
    double w1_1_4; /* weight of x1 in the law */
    double w1_2_4; /* weight of x2 in the law */
    double w2_2_4; /* weight of x2 in the law */
} stage27;

/* Takes the parameters and arms at tick 0. PTC_OK, or PTC_E_PARAM with *self untouched. */
ptc_status stage27_init(stage27 *self, const stage27_params *params);

/* Starts again: the deadline is N samples after tick `k`. */
ptc_status stage27_arm(stage27 *self, uint32_t k);

/*
 * u = (A, B, C, D) from tick `k`, which may wrap, and state x = (a, b, b1, c, d, d1). Where one of
 * them is not finite, as at a state at which the inputs do not decouple the outputs, every u is 0;
 * else the status is SATURATED where one was clipped. u and axes must not overlap x.
 */
ptc_status stage27_step(
    const stage27 *self,
    uint32_t k,
    const double x[6],
    double u[4],
    ptc_status axes[4]);

#ifdef __cplusplus
}
#endif

#endif
