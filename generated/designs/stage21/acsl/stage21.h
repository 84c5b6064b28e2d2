/*
 * Prescribed-time controller stage21: order n = 3, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 3 --mu "exp(a=1)" --name stage21 --clock samples --eps=0 --g="2" --reference="size*dt^2/(1 + t^2)" --delay=0.25
 * Version 0.1.0, design 0b4602f00880.
 *
 * Plant: x1' = x2, ..., x3' = g u; u held from sample to sample, 0.25 samples late.
 * Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
 *       sample period, as long as u is not clipped and nothing else acts on the plant.
 * Law: with M samples to go and z = S x, u h^4 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-3));
 *       the rows are those of Theorem 1 for the mapping exp. Close to the end deadbeat takes
 *       over.
 * With the reference r, e_i = x_i - r^(i-1) is in place of x_i above, and u = w + rho/g,
 *       where the inputs under way count less the rho of their own samples. At sample N e is
 *       0 where r^(n) is constant over each sample; else an error of order h^(5-i) is left in
 *       e_i.
 * t counts from the tick at which it was armed, and rho is r^(n) in the middle of the time in
 *       which u acts:
 *   e_i = x_i - r^(i-1), with the reference r = size*dt^2/(1 + t^2)
 *   r^(1) = 2*size*dt*(1 + t^2 - dt*t)/(1 + t^2)^2
 *   r^(2) = 2*size*((1 + t^2)^2 + 4*dt^2*t^2 - 4*(1 + t^2)*dt*t - (1 + t^2)*dt^2)/(1 + t^2)^3
 *   r^(3) = 12*size*(4*(1 + t^2)*dt*t^2 + 2*(1 + t^2)*dt^2*t - (1 + t^2)^2*dt - (1 + t^2)^2*t
 *       - 4*dt^2*t^3)/(1 + t^2)^4
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
 *   size [as in its expression]: parameter of an expression of the design
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
 *   growth: sound: at rest at sample N from any state, but for what r does between samples,
 *       whatever the poles, and |u| is bounded.
 *   sampling: not checked: `loop` bounds what the period leaves of a reference that moves.
 *   deadline: not checked: `loop` bounds what the period leaves of a reference that moves.
 *   loop: not checked: `samples` is left to run time.
 *   envelope: not checked: it does not examine a clock in samples.
 */
#ifndef STAGE21_79B8B772_H
#define STAGE21_79B8B772_H

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
typedef struct stage21_params {
    uint32_t samples; /* samples N from the start to rest [samples], at least 4 */
    double h; /* sample period [s], from 1e-150 to 1e150 */
    double u_max; /* bound of |u| [unit of u], > 0, infinity allowed */
    double k[4]; /* gains k_i of pi0 = -sum k_i xi_i [1/s^4], finite */
    double deadbeat; /* samples to go at which deadbeat takes over, 0 for a safe default [samples], finite */
    double size; /* parameter of an expression of the design [as in its expression], finite */
} stage21_params;

/* Controller: set by init, changed by arm and by what takes it without const. */
typedef struct stage21 {
    uint32_t start; /* tick at which it was armed */
    uint32_t samples; /* samples from the start to rest */
    double u1; /* input of the last sample */
    double h; /* sample period */
    double p_size; /* parameter of an expression of the design */
    double c_r3; /* derived from the parameters */
    double c_r5; /* derived from the parameters */
    double c_r6; /* derived from the parameters */
    double c_r12; /* derived from the parameters */
    double deadbeat; /* samples to go at which deadbeat takes over */
    double w1_1; /* weight of x1 in the law */
    double w1_2; /* weight of x2 in the law */
    double w1_3; /* weight of x3 in the law */
    double w1_4; /* weight of u1 in the law */
    double w2_2; /* weight of x2 in the law */
    double w2_3; /* weight of x3 in the law */
    double w2_4; /* weight of u1 in the law */
    double w3_3; /* weight of x3 in the law */
    double w3_4; /* weight of u1 in the law */
    double w4_4; /* weight of u1 in the law */
    double b_1; /* weight of x1 in the law */
    double b_2; /* weight of x2 in the law */
    double b_3; /* weight of x3 in the law */
    double u_max; /* bound of |u| */
} stage21;

/*@ predicate stage21_set(stage21 *c) =
      \is_finite(c->c_r3)
      && \is_finite(c->c_r5)
      && \is_finite(c->c_r6)
      && \is_finite(c->c_r12)
      && \is_finite(c->deadbeat)
      && \is_finite(c->w1_1)
      && \is_finite(c->w1_2)
      && \is_finite(c->w1_3)
      && \is_finite(c->w1_4)
      && \is_finite(c->w2_2)
      && \is_finite(c->w2_3)
      && \is_finite(c->w2_4)
      && \is_finite(c->w3_3)
      && \is_finite(c->w3_4)
      && \is_finite(c->w4_4)
      && \is_finite(c->b_1)
      && \is_finite(c->b_2)
      && \is_finite(c->b_3);
 */

/* Takes the parameters and arms at tick 0. PTC_OK, or PTC_E_PARAM with *self untouched. */
/*@ requires self == \null || \valid(self);
    requires params == \null || \valid_read(params);
    assigns *self;
    ensures \result == PTC_OK || \result == PTC_E_PARAM;
    ensures \result == PTC_OK ==> stage21_set(self);
 */
ptc_status stage21_init(stage21 *self, const stage21_params *params);

/*
 * Starts again: the deadline is N samples after tick `k`. The time of the reference counts from
 * there. Estimates and inputs under way are kept.
 */
/*@ requires self == \null || \valid(self);
    requires self == \null || stage21_set(self);
    assigns *self;
    ensures \result == PTC_OK || \result == PTC_E_INPUT;
    ensures \result >= 0 ==> stage21_set(self);
 */
ptc_status stage21_arm(stage21 *self, uint32_t k);

/*
 * u from tick `k`, which may wrap, and the state x = (x1, x1', ...). Call it once for each tick. On
 * a negative status u is 0 and nothing has changed. u must not overlap x.
 */
/*@ requires self == \null || \valid(self);
    requires x == \null || \valid_read(x + (0 .. 2));
    requires u == \null || \valid(u);
    requires self == \null || stage21_set(self);
    assigns *self, *u;
    ensures \result == PTC_SATURATED || \result == PTC_OK || \result == PTC_HOLD || \result == PTC_E_INPUT || \result == PTC_E_RANGE;
    ensures \result >= 0 ==> stage21_set(self);
 */
ptc_status stage21_step(stage21 *self, uint32_t k, const double x[3], double *u);

#ifdef __cplusplus
}
#endif

#endif
