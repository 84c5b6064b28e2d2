/*
 * Prescribed-time filter ceiling_filter: order n = 3, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 3 --name ceiling --what filter --keep-below=1 --keep-tolerance=1e-3 --keep-poles=-3,-5,-8 --poles="least-energy(weight=1)" --precision f32 --tau=1 --f="1/2" --g="-2" --sample-time=0.01 --delay=1.5
 * Version 0.1.0, design deb0d31bb8ee.
 *
 * Plant: x1' = x2, ..., x3' = f + g u; u held from sample to sample, 1.5 samples late.
 * Goal: x1 <= 1, at and between all samples, under any controller, from every state from
 *       which that is possible and as long as nothing else acts on the plant.
 * Filter: with the control points z = S x of the trajectory, q_0 = z_i and q_j = (Delta +
 *       a_(i+j-1)) q_(j-1), with the rates a_i = (1 - exp(p_i h))/h of the poles -3, -5, -8
 *       1/s. In this cone all states are safe: x_i stays within its bound b as long as all
 *       q_j are within b a_i...a_(i+j-1), j < n+1-i; the last of them, in which u occurs, is
 *       the limit of u.
 * From any other state u is held to the law least-energy(weight=1) of the chain of each x_i
 *       less its bound too, so that x_i is within it at the latest N samples after the last
 *       safe one, as long as neither the limits of u nor those by other bounds are in the way.
 *
 * Parameters:
 *   samples = 100 [samples], fixed: samples N in which a state outside returns
 *   h = 0.01 [s], fixed: sample period
 *   u_max [unit of u]: bound of |u|
 *
 * k counts samples and may wrap; call step at least once within 2^32 - N samples.
 * u is u_nominal where no bound is near (status OK), and else the nearest that they allow
 *       (SATURATED).
 * INFEASIBLE: the state is not safe, or not all bounds can be kept: those of x1 go before
 *       those of x2 and so on, the limits of u before all.
 * |u| <= u_max: u is clipped to it (status SATURATED). This goes before all bounds.
 * Guard full: x and u_nominal are finite and no pointer is NULL, or the call is refused
 *       (status E_INPUT).
 * Precision f32 (IEEE 754 binary32). Results are bit for bit the same on every IEEE 754
 *       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
 *
 * Checks of the design (details: ptc-codegen check):
 *   membership: sound: exp is of class M for all its parameters.
 *   growth: not checked: a filter has no law.
 *   sampling: not checked: a filter has no law.
 *   deadline: not checked: a filter has no law.
 *   loop: not checked: `u_max` is left to run time.
 *   envelope: not checked: a filter has no law.
 */
#ifndef CEILING_FILTER_F6970FFC_H
#define CEILING_FILTER_F6970FFC_H

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
typedef struct ceiling_filter_params {
    float u_max; /* bound of |u| [unit of u], > 0, infinity allowed */
} ceiling_filter_params;

/* Filter: set by init, changed by arm and by what takes it without const. */
typedef struct ceiling_filter {
    uint32_t start; /* tick of the last safe sample, or of `arm` */
    float u1; /* input of the last sample */
    float u2; /* input of 2 samples ago */
    float u_max; /* bound of |u| */
} ceiling_filter;

/* Takes the parameters and arms at tick 0. PTC_OK, or PTC_E_PARAM with *self untouched. */
ptc_status ceiling_filter_init(ceiling_filter *self, const ceiling_filter_params *params);

/*
 * From tick `k` on a state outside has N samples to return. Estimates and inputs under way are
 * kept.
 */
ptc_status ceiling_filter_arm(ceiling_filter *self, uint32_t k);

/*
 * u_nominal as it is, or as near to it as the bounds allow, from tick `k`, which may wrap, and the
 * state x = (x1, x1', ...). Call it once for each tick. On a negative status u is 0 and nothing has
 * changed. u must not overlap x.
 */
ptc_status ceiling_filter_step(
    ceiling_filter *self,
    uint32_t k,
    const float x[3],
    float u_nominal,
    float *u);

#ifdef __cplusplus
}
#endif

#endif
