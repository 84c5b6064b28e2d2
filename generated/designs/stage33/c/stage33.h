/*
 * Prescribed-time controller stage33: order n = 2, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 2 --axes 3 --mu "exp(a=1)" --name stage33 --clock samples --precision f32 --tau=0.3 --eps=0 --limits=1,2,3 --poles="[[-4,-5],[-3+i,-3-i],[-6,-7.5]]" --g="[1/2, 2, -1]" --reference="1/(2 + t^2), size*dt/(3 + dt), t^2/(2 + t^2)" --sample-time=0.01
 * Version 0.1.0, design 600667a7090c.
 *
 * Plant: x1' = x2, x2' = g u; u held from sample to sample.
 * Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
 *       sample period, as long as u is not clipped and nothing else acts on the plant.
 * Law: with M samples to go and z = S x, u h^2 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-1));
 *       the rows are those of Theorem 1 for the mapping exp. From 9 samples to go on these
 *       are M - 2 and the exponents 3, 4, those of least energy. The gains of 2 samples to go
 *       stay: they are deadbeat.
 * With a reference r of each axis, e_i = x_i - r^(i-1) is in place of x_i above, and u = w +
 *       rho/g of each axis. What r^(n) changes over a sample leaves an error of order
 *       h^(n+2-i) in e_i at sample N, h^3 for n = 1, and none where it is constant there.
 * t counts from the tick at which it was armed, and rho is r^(n) in the middle of the time in
 *       which u acts:
 *   of axis 1: r = 1/(2 + t^2), r^(1) = -2*t/(2 + t^2)^2, r^(2) = 2*(4*t^2 - (2 + t^2))/(2 +
 *       t^2)^3
 *   of axis 2: r = size*dt/(3 + dt), r^(1) = size*(3 + dt - dt)/(3 + dt)^2, r^(2) =
 *       2*size*(dt - (3 + dt))/(3 + dt)^3
 *   of axis 3: r = t^2/(2 + t^2), r^(1) = 2*t*(2 + t^2 - t^2)/(2 + t^2)^2, r^(2) = 2*((2 +
 *       t^2)^2 + 4*t^4 - 5*(2 + t^2)*t^2)/(2 + t^2)^3
 * Axes: 3, each a chain of its own with this deadline and mapping. step computes what depends
 *       on time once.
 *   axis 1: k = 20, 9; u_max = 1; g = 1/2
 *   axis 2: k = 10, 6; u_max = 2; g = 2
 *   axis 3: k = 45, 13.5; u_max = 3; g = -1
 *
 * Parameters:
 *   samples = 30 [samples], fixed: samples N from the start to rest
 *   h = 0.01 [s], fixed: sample period
 *   eps = 0 [s], fixed: time-to-go at which the gains are held
 *   a = 1 [1/s], fixed: rate of stretched time
 *   size [as in its expression]: parameter of an expression of the design
 *
 * k counts samples and may wrap; arm again within 2^32 - N samples.
 * From sample N on the last gains are held (status HOLD).
 * |u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
 *       lasts.
 * Guard full: what is measured is finite and no pointer is NULL, or the call is refused
 *       (status E_INPUT).
 * Precision f32 (IEEE 754 binary32). Results are bit for bit the same on every IEEE 754
 *       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
 *
 * Checks of the design (details: ptc-codegen check):
 *   membership: sound: exp is of class M for all its parameters.
 *   growth: sound: at rest at sample 30 from any state, but for what r does between samples,
 *       whatever the poles, and |u| is bounded.
 *   sampling: not checked: `loop` bounds what the period leaves of a reference that moves.
 *   deadline: not checked: `loop` bounds what the period leaves of a reference that moves.
 *   loop: not checked: axis 1: `x0_max` is not given.
 *   envelope: not checked: it does not examine a clock in samples.
 */
#ifndef STAGE33_BD8BFFA6_H
#define STAGE33_BD8BFFA6_H

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
typedef struct stage33_params {
    float size; /* parameter of an expression of the design [as in its expression], finite */
} stage33_params;

/* Controller: set by init, changed by arm and by what takes it without const. */
typedef struct stage33 {
    uint32_t start; /* tick at which it was armed */
    float p_size; /* parameter of an expression of the design */
    float c_r10; /* derived from the parameters */
} stage33;

/* Takes the parameters and arms at tick 0. PTC_OK, or PTC_E_PARAM with *self untouched. */
ptc_status stage33_init(stage33 *self, const stage33_params *params);

/*
 * Starts again: the deadline is N samples after tick `k`. The time of the reference counts from
 * there.
 */
ptc_status stage33_arm(stage33 *self, uint32_t k);

/*
 * u of each axis from tick `k`, which may wrap, and the state x = (x1, x1', ...) of each. Where one
 * of them is not finite, every u is 0; else the status is SATURATED where one was clipped. u and
 * axes must not overlap x.
 */
ptc_status stage33_step(
    const stage33 *self,
    uint32_t k,
    const float x[3][2],
    float u[3],
    ptc_status axes[3]);

#ifdef __cplusplus
}
#endif

#endif
