/*
 * Prescribed-time controller stage35: outputs of order 2, 1, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --mu "exp(a=1)" --name stage35 --clock samples --tau=0.3 --eps=0 --limits=20,30 --poles="[[-3,-4],[-4]]" --states="s, v, i" --inputs=F,V --outputs="s, i" --dynamics="v, 3*i - 2*s - v/2 + F, V - 4*i + s/8" --sample-time=0.01
 * Version 0.1.0, design 28ee8693b5c2.
 *
 * Plant: the inputs F, V: s' = v, v' = 3*i - 2*s - v/2 + F, i' = V - 4*i + s/8, output 1 = s,
 *       output 2 = i; u held from sample to sample.
 * Goal: x = 0 at sample N after the start, exact up to rounding, from any state, as long as
 *       no u is clipped and nothing else acts on the plant.
 * Law of each output, of order n, in its chain xi as it is sampled, which is the output with
 *       its derivatives up to O(h), and which held inputs move exactly: with M - s samples to
 *       go and z = S xi, v h^n = sum of row_j z_j h^(j-1)/((M-j+1)...(M-n+1)); the rows are
 *       those of Theorem 1 for the mapping exp. xi_j of output i is xj_i in step, and v_i is
 *       law_i. s = 2, 3. Output 1: The gains of 2 samples to go stay: they are deadbeat.
 *       Output 2: The gains of 1 sample to go stay: they are deadbeat.
 * Output 1, of order n = 2, to four digits:
 *   xi_1 = s - 4.167e-6*v + 2.5e-5*i
 *   xi_2 = v
 *   f_1 = -1.993*s - 0.5087*v + 2.933*i
 * Output 2, of order n = 1, to four digits:
 *   xi_1 = i
 *   f_2 = 0.1225*s + 6.157e-4*v - 3.921*i
 * u = G^-1 w with w_i = v_i - f_i, to four digits:
 *   G^-1 = [[1.003, -0.01511], [-2.107e-6, 1.02]]
 * Outputs: 2, each with a law of its own, with this deadline and mapping; u_max is of the
 *       input of this number.
 *   output 1: k = 12, 7; u_max = 20
 *   output 2: k = 4; u_max = 30
 *
 * Parameters:
 *   samples = 30 [samples], fixed: samples N from the start to rest
 *   h = 0.01 [s], fixed: sample period
 *   eps = 0 [s], fixed: time-to-go at which the gains are held
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
 *   growth: sound: at rest at sample 30 from any state, whatever the poles, and |u| is
 *       bounded.
 *   sampling: not checked: the law is exact in samples, at any period.
 *   deadline: not checked: the law is exact in samples, at any period.
 *   loop: not checked: `x0_max` is not given.
 *   envelope: not checked: `x_max` is not given.
 *   zeros: sound: none: the relative degrees are 2, 1, whose sum is the number of states.
 */
#ifndef STAGE35_863D49AA_H
#define STAGE35_863D49AA_H

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
typedef struct stage35_params {
    char none; /* every parameter is fixed */
} stage35_params;

/* Controller: set by init, changed by arm and by what takes it without const. */
typedef struct stage35 {
    uint32_t start; /* tick at which it was armed */
} stage35;

/* Takes the parameters and arms at tick 0. PTC_OK, or PTC_E_PARAM with *self untouched. */
ptc_status stage35_init(stage35 *self, const stage35_params *params);

/* Starts again: the deadline is N samples after tick `k`. */
ptc_status stage35_arm(stage35 *self, uint32_t k);

/*
 * u = (F, V) from tick `k`, which may wrap, and state x = (s, v, i). Where one of them is not
 * finite, as at a state at which the inputs do not decouple the outputs, every u is 0; else the
 * status is SATURATED where one was clipped. u and axes must not overlap x.
 */
ptc_status stage35_step(
    const stage35 *self,
    uint32_t k,
    const double x[3],
    double u[2],
    ptc_status axes[2]);

#ifdef __cplusplus
}
#endif

#endif
