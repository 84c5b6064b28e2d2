/*
 * Proof that a_name_that_fills_half_of_a_line_alone_4.c has no error at run time, with the plug-in Eva of Frama-C. Here are a_name_that_fills_half_of_a_line_alone_4.h,
 * a_name_that_fills_half_of_a_line_alone_4.c and this file, all three written by ptc-codegen emit --acsl. DO NOT EDIT.
 *
 * Any inputs, with NaN, infinities and NULL:
 *   frama-c -eva -eva-slevel 1000 -eva-slevel-merge-after-loop @all -eva-split-return full -eva-subdivide-non-linear 20 -eva-domains equality -warn-special-float none a_name_that_fills_half_of_a_line_alone_4_eva.c a_name_that_fills_half_of_a_line_alone_4.c
 * Finite inputs, and no value on the way may overflow or be NaN:
 *   frama-c -cpp-extra-args=-DFINITE -eva -eva-slevel 1000 -eva-slevel-merge-after-loop @all -eva-split-return full -eva-subdivide-non-linear 20 -eva-domains equality -warn-special-float non-finite a_name_that_fills_half_of_a_line_alone_4_eva.c a_name_that_fills_half_of_a_line_alone_4.c
 *
 * It is proved where no line begins with [eva:alarm] and the summary has no property unknown. A call is
 * proved from whatever the calls before it may have left. In finite mode values are drawn from the ranges
 * below; give others with -cpp-extra-args="-DFINITE -D<macro>=<number>".
 */
#include "a_name_that_fills_half_of_a_line_alone_4.h"

#include <math.h>
#include <stddef.h>

#include "__fc_builtin.h"

#ifndef A_NAME_THAT_FILLS_HALF_OF_A_LINE_ALONE_4_EVA_SAMPLES_MIN
#define A_NAME_THAT_FILLS_HALF_OF_A_LINE_ALONE_4_EVA_SAMPLES_MIN 6U
#endif
#ifndef A_NAME_THAT_FILLS_HALF_OF_A_LINE_ALONE_4_EVA_SAMPLES_MAX
#define A_NAME_THAT_FILLS_HALF_OF_A_LINE_ALONE_4_EVA_SAMPLES_MAX 1000U
#endif
#ifndef A_NAME_THAT_FILLS_HALF_OF_A_LINE_ALONE_4_EVA_H_MIN
#define A_NAME_THAT_FILLS_HALF_OF_A_LINE_ALONE_4_EVA_H_MIN 0.01f
#endif
#ifndef A_NAME_THAT_FILLS_HALF_OF_A_LINE_ALONE_4_EVA_H_MAX
#define A_NAME_THAT_FILLS_HALF_OF_A_LINE_ALONE_4_EVA_H_MAX 0.01f
#endif
#ifndef A_NAME_THAT_FILLS_HALF_OF_A_LINE_ALONE_4_EVA_U_MAX_MIN
#define A_NAME_THAT_FILLS_HALF_OF_A_LINE_ALONE_4_EVA_U_MAX_MIN 10.0f
#endif
#ifndef A_NAME_THAT_FILLS_HALF_OF_A_LINE_ALONE_4_EVA_U_MAX_MAX
#define A_NAME_THAT_FILLS_HALF_OF_A_LINE_ALONE_4_EVA_U_MAX_MAX 10.0f
#endif
#ifndef A_NAME_THAT_FILLS_HALF_OF_A_LINE_ALONE_4_EVA_K1_MIN
#define A_NAME_THAT_FILLS_HALF_OF_A_LINE_ALONE_4_EVA_K1_MIN -100.0f
#endif
#ifndef A_NAME_THAT_FILLS_HALF_OF_A_LINE_ALONE_4_EVA_K1_MAX
#define A_NAME_THAT_FILLS_HALF_OF_A_LINE_ALONE_4_EVA_K1_MAX 100.0f
#endif
#ifndef A_NAME_THAT_FILLS_HALF_OF_A_LINE_ALONE_4_EVA_K2_MIN
#define A_NAME_THAT_FILLS_HALF_OF_A_LINE_ALONE_4_EVA_K2_MIN -100.0f
#endif
#ifndef A_NAME_THAT_FILLS_HALF_OF_A_LINE_ALONE_4_EVA_K2_MAX
#define A_NAME_THAT_FILLS_HALF_OF_A_LINE_ALONE_4_EVA_K2_MAX 100.0f
#endif
#ifndef A_NAME_THAT_FILLS_HALF_OF_A_LINE_ALONE_4_EVA_DEADBEAT_MIN
#define A_NAME_THAT_FILLS_HALF_OF_A_LINE_ALONE_4_EVA_DEADBEAT_MIN 0.0f
#endif
#ifndef A_NAME_THAT_FILLS_HALF_OF_A_LINE_ALONE_4_EVA_DEADBEAT_MAX
#define A_NAME_THAT_FILLS_HALF_OF_A_LINE_ALONE_4_EVA_DEADBEAT_MAX 0.0f
#endif
/* Bounds of what is measured, and of the fields that calls change. */
#ifndef A_NAME_THAT_FILLS_HALF_OF_A_LINE_ALONE_4_EVA_Y1_MAX
#define A_NAME_THAT_FILLS_HALF_OF_A_LINE_ALONE_4_EVA_Y1_MAX 10.0f
#endif
#ifndef A_NAME_THAT_FILLS_HALF_OF_A_LINE_ALONE_4_EVA_U1_MAX
#define A_NAME_THAT_FILLS_HALF_OF_A_LINE_ALONE_4_EVA_U1_MAX 10.0f
#endif
#ifndef A_NAME_THAT_FILLS_HALF_OF_A_LINE_ALONE_4_EVA_X1_HAT_MAX
#define A_NAME_THAT_FILLS_HALF_OF_A_LINE_ALONE_4_EVA_X1_HAT_MAX 10.0f
#endif
#ifndef A_NAME_THAT_FILLS_HALF_OF_A_LINE_ALONE_4_EVA_X2_HAT_MAX
#define A_NAME_THAT_FILLS_HALF_OF_A_LINE_ALONE_4_EVA_X2_HAT_MAX 10.0f
#endif
#ifndef A_NAME_THAT_FILLS_HALF_OF_A_LINE_ALONE_4_EVA_D_HAT_MAX
#define A_NAME_THAT_FILLS_HALF_OF_A_LINE_ALONE_4_EVA_D_HAT_MAX 10.0f
#endif

/* Frama-C leaves the sign of a true isfinite open; the code only asks whether it is 0. */
/*@ ensures \result >= 0; */
extern int __finite(double d);
/*@ ensures \result >= 0; */
extern int __finitef(float f);

static volatile float a_name_that_fills_half_of_a_line_alone_4_eva_source;

/* Any number, or in finite mode one of least to greatest. */
static float a_name_that_fills_half_of_a_line_alone_4_eva_draw(float least, float greatest)
{
#ifdef FINITE
    return Frama_C_float_interval(least, greatest);
#else
    (void)least;
    (void)greatest;
    return a_name_that_fills_half_of_a_line_alone_4_eva_source;
#endif
}

/* The same, but at the levels above 0 finite: Eva takes NaN to both sides of a comparison, so that it does
 * not see that one refuses it. */
static float a_name_that_fills_half_of_a_line_alone_4_eva_number(int level, float least, float greatest)
{
    const float v = a_name_that_fills_half_of_a_line_alone_4_eva_draw(least, greatest);

    return ((level > 0) && (isfinite(v) == 0)) ? greatest : v;
}

static uint32_t a_name_that_fills_half_of_a_line_alone_4_eva_count(uint32_t least, uint32_t greatest)
{
    return (uint32_t)Frama_C_unsigned_int_interval(least, greatest);
}

/* Any tick. */
static uint32_t a_name_that_fills_half_of_a_line_alone_4_eva_tick(void)
{
    return a_name_that_fills_half_of_a_line_alone_4_eva_count(0U, 4294967295U);
}

/* Fields that nothing has set. */
static void a_name_that_fills_half_of_a_line_alone_4_eva_blank(a_name_that_fills_half_of_a_line_alone_4 *self)
{
    self->start = 42U;
    self->samples = 42U;
    self->u1 = 42.0f;
    self->seen = 42U;
    self->x1_hat = 42.0f;
    self->x2_hat = 42.0f;
    self->d_hat = 42.0f;
    self->phi1_2 = 42.0f;
    self->phi1_3 = 42.0f;
    self->q2_1 = 42.0f;
    self->q2_2 = 42.0f;
    self->e2_2 = 42.0f;
    self->e2_3 = 42.0f;
    self->e1_2 = 42.0f;
    self->e1_3 = 42.0f;
    self->e0_2 = 42.0f;
    self->e0_3 = 42.0f;
    self->deadbeat = 42.0f;
    self->w1_1 = 42.0f;
    self->w1_2 = 42.0f;
    self->w2_2 = 42.0f;
    self->b_1 = 42.0f;
    self->b_2 = 42.0f;
    self->u_max = 42.0f;
}

static void a_name_that_fills_half_of_a_line_alone_4_eva_untouched(const a_name_that_fills_half_of_a_line_alone_4 *self)
{
    (void)self;
    //@ assert untouched: self->start == 42;
    //@ assert untouched: self->samples == 42;
    //@ assert untouched: self->u1 == 42.0;
    //@ assert untouched: self->seen == 42;
    //@ assert untouched: self->x1_hat == 42.0;
    //@ assert untouched: self->x2_hat == 42.0;
    //@ assert untouched: self->d_hat == 42.0;
    //@ assert untouched: self->phi1_2 == 42.0;
    //@ assert untouched: self->phi1_3 == 42.0;
    //@ assert untouched: self->q2_1 == 42.0;
    //@ assert untouched: self->q2_2 == 42.0;
    //@ assert untouched: self->e2_2 == 42.0;
    //@ assert untouched: self->e2_3 == 42.0;
    //@ assert untouched: self->e1_2 == 42.0;
    //@ assert untouched: self->e1_3 == 42.0;
    //@ assert untouched: self->e0_2 == 42.0;
    //@ assert untouched: self->e0_3 == 42.0;
    //@ assert untouched: self->deadbeat == 42.0;
    //@ assert untouched: self->w1_1 == 42.0;
    //@ assert untouched: self->w1_2 == 42.0;
    //@ assert untouched: self->w2_2 == 42.0;
    //@ assert untouched: self->b_1 == 42.0;
    //@ assert untouched: self->b_2 == 42.0;
    //@ assert untouched: self->u_max == 42.0;
}

/* What calls may leave, and more. */
static void a_name_that_fills_half_of_a_line_alone_4_eva_kept(a_name_that_fills_half_of_a_line_alone_4 *self)
{
    self->start = a_name_that_fills_half_of_a_line_alone_4_eva_tick();
    self->u1 = a_name_that_fills_half_of_a_line_alone_4_eva_draw(-A_NAME_THAT_FILLS_HALF_OF_A_LINE_ALONE_4_EVA_U1_MAX, A_NAME_THAT_FILLS_HALF_OF_A_LINE_ALONE_4_EVA_U1_MAX);
    self->seen = a_name_that_fills_half_of_a_line_alone_4_eva_count(0U, 1U);
    self->x1_hat = a_name_that_fills_half_of_a_line_alone_4_eva_draw(-A_NAME_THAT_FILLS_HALF_OF_A_LINE_ALONE_4_EVA_X1_HAT_MAX, A_NAME_THAT_FILLS_HALF_OF_A_LINE_ALONE_4_EVA_X1_HAT_MAX);
    self->x2_hat = a_name_that_fills_half_of_a_line_alone_4_eva_draw(-A_NAME_THAT_FILLS_HALF_OF_A_LINE_ALONE_4_EVA_X2_HAT_MAX, A_NAME_THAT_FILLS_HALF_OF_A_LINE_ALONE_4_EVA_X2_HAT_MAX);
    self->d_hat = a_name_that_fills_half_of_a_line_alone_4_eva_draw(-A_NAME_THAT_FILLS_HALF_OF_A_LINE_ALONE_4_EVA_D_HAT_MAX, A_NAME_THAT_FILLS_HALF_OF_A_LINE_ALONE_4_EVA_D_HAT_MAX);
}

/* A call at any tick, and the estimates behind it: a status, with u = 0 where it is negative; at level 1 that
 * u is finite, at 2 its bound. */
static void a_name_that_fills_half_of_a_line_alone_4_eva_use(a_name_that_fills_half_of_a_line_alone_4 *self, float limit, int level)
{
    const uint32_t k = a_name_that_fills_half_of_a_line_alone_4_eva_tick();
    float y[1];
    ptc_status status;
    float u;
    float xhat[2];
    float d;

    (void)limit;
    (void)level;
    y[0] = a_name_that_fills_half_of_a_line_alone_4_eva_draw(-A_NAME_THAT_FILLS_HALF_OF_A_LINE_ALONE_4_EVA_Y1_MAX, A_NAME_THAT_FILLS_HALF_OF_A_LINE_ALONE_4_EVA_Y1_MAX);
    status = a_name_that_fills_half_of_a_line_alone_4_step(self, k, y, &u);
    //@ assert known: -3 <= status <= 3 && status != PTC_E_PARAM;
    //@ assert refused: status < 0 ==> u == 0.0;
    if (level > 0) {
        //@ assert finite: \is_finite(u);
    }
    if (level > 1) {
        //@ assert bounded: status >= 0 ==> -limit <= u <= limit;
    }
#ifdef FINITE
    //@ assert accepted: status >= 0;
#endif
    status = a_name_that_fills_half_of_a_line_alone_4_estimate(self, xhat);
    //@ assert given: status == PTC_OK;
    status = a_name_that_fills_half_of_a_line_alone_4_disturbance(self, &d);
    //@ assert given: status == PTC_OK;
    //@ assert initialized: \initialized(xhat + (0 .. 1));
    //@ assert initialized: \initialized(&d);
}

/* init and the first call, then arm and any call. */
static void a_name_that_fills_half_of_a_line_alone_4_eva_live(float limit, int level)
{
    a_name_that_fills_half_of_a_line_alone_4_params params;
    a_name_that_fills_half_of_a_line_alone_4 own;
    a_name_that_fills_half_of_a_line_alone_4 *const self = &own;
    ptc_status status;

    params.u_max = limit;
    params.samples = a_name_that_fills_half_of_a_line_alone_4_eva_count(A_NAME_THAT_FILLS_HALF_OF_A_LINE_ALONE_4_EVA_SAMPLES_MIN, A_NAME_THAT_FILLS_HALF_OF_A_LINE_ALONE_4_EVA_SAMPLES_MAX);
    params.h = a_name_that_fills_half_of_a_line_alone_4_eva_draw(A_NAME_THAT_FILLS_HALF_OF_A_LINE_ALONE_4_EVA_H_MIN, A_NAME_THAT_FILLS_HALF_OF_A_LINE_ALONE_4_EVA_H_MAX);
    params.k[0] = a_name_that_fills_half_of_a_line_alone_4_eva_draw(A_NAME_THAT_FILLS_HALF_OF_A_LINE_ALONE_4_EVA_K1_MIN, A_NAME_THAT_FILLS_HALF_OF_A_LINE_ALONE_4_EVA_K1_MAX);
    params.k[1] = a_name_that_fills_half_of_a_line_alone_4_eva_draw(A_NAME_THAT_FILLS_HALF_OF_A_LINE_ALONE_4_EVA_K2_MIN, A_NAME_THAT_FILLS_HALF_OF_A_LINE_ALONE_4_EVA_K2_MAX);
    params.deadbeat = a_name_that_fills_half_of_a_line_alone_4_eva_draw(A_NAME_THAT_FILLS_HALF_OF_A_LINE_ALONE_4_EVA_DEADBEAT_MIN, A_NAME_THAT_FILLS_HALF_OF_A_LINE_ALONE_4_EVA_DEADBEAT_MAX);
    a_name_that_fills_half_of_a_line_alone_4_eva_blank(self);
    status = a_name_that_fills_half_of_a_line_alone_4_init(self, &params);
    if (status == PTC_OK) {
        a_name_that_fills_half_of_a_line_alone_4_eva_use(self, limit, level);
        status = a_name_that_fills_half_of_a_line_alone_4_arm(self, a_name_that_fills_half_of_a_line_alone_4_eva_tick());
        //@ assert armed: status == PTC_OK;
        a_name_that_fills_half_of_a_line_alone_4_eva_kept(self);
        a_name_that_fills_half_of_a_line_alone_4_eva_use(self, limit, level);
    } else {
        //@ assert refused: status == PTC_E_PARAM;
        a_name_that_fills_half_of_a_line_alone_4_eva_untouched(self);
#ifdef FINITE
        //@ assert started: \false;
#endif
    }
}

#ifndef FINITE
/* NULL for every pointer that is checked, and no number for every input. */
static void a_name_that_fills_half_of_a_line_alone_4_eva_null(void)
{
    a_name_that_fills_half_of_a_line_alone_4_params params;
    a_name_that_fills_half_of_a_line_alone_4 own;
    a_name_that_fills_half_of_a_line_alone_4 *const self = &own;
    ptc_status status;
    const uint32_t k = a_name_that_fills_half_of_a_line_alone_4_eva_tick();
    float y[1];
    float u;
    float xhat[2];
    float d;

    params.u_max = a_name_that_fills_half_of_a_line_alone_4_eva_draw(0.0f, 0.0f);
    params.samples = a_name_that_fills_half_of_a_line_alone_4_eva_tick();
    params.h = a_name_that_fills_half_of_a_line_alone_4_eva_draw(0.0f, 0.0f);
    params.k[0] = a_name_that_fills_half_of_a_line_alone_4_eva_draw(0.0f, 0.0f);
    params.k[1] = a_name_that_fills_half_of_a_line_alone_4_eva_draw(0.0f, 0.0f);
    params.deadbeat = a_name_that_fills_half_of_a_line_alone_4_eva_draw(0.0f, 0.0f);
    a_name_that_fills_half_of_a_line_alone_4_eva_blank(self);
    status = a_name_that_fills_half_of_a_line_alone_4_init(NULL, &params);
    //@ assert no_self: status == PTC_E_PARAM;
    status = a_name_that_fills_half_of_a_line_alone_4_init(self, NULL);
    //@ assert no_params: status == PTC_E_PARAM;
    a_name_that_fills_half_of_a_line_alone_4_eva_untouched(self);
    y[0] = a_name_that_fills_half_of_a_line_alone_4_eva_draw(0.0f, 0.0f);
    status = a_name_that_fills_half_of_a_line_alone_4_arm(NULL, k);
    //@ assert missing: status == PTC_E_INPUT;
    status = a_name_that_fills_half_of_a_line_alone_4_step(NULL, k, y, &u);
    //@ assert missing: status == PTC_E_INPUT;
    //@ assert zero: u == 0.0;
    status = a_name_that_fills_half_of_a_line_alone_4_step(self, k, NULL, &u);
    //@ assert missing: status == PTC_E_INPUT;
    //@ assert zero: u == 0.0;
    status = a_name_that_fills_half_of_a_line_alone_4_step(self, k, y, NULL);
    //@ assert missing: status == PTC_E_INPUT;
    status = a_name_that_fills_half_of_a_line_alone_4_estimate(NULL, xhat);
    //@ assert missing: status == PTC_E_INPUT;
    status = a_name_that_fills_half_of_a_line_alone_4_estimate(self, NULL);
    //@ assert missing: status == PTC_E_INPUT;
    status = a_name_that_fills_half_of_a_line_alone_4_disturbance(NULL, &d);
    //@ assert missing: status == PTC_E_INPUT;
    status = a_name_that_fills_half_of_a_line_alone_4_disturbance(self, NULL);
    //@ assert missing: status == PTC_E_INPUT;
    a_name_that_fills_half_of_a_line_alone_4_eva_untouched(self);
    y[0] = 0.0f;
    y[0] = NAN;
    status = a_name_that_fills_half_of_a_line_alone_4_step(self, k, y, &u);
    //@ assert no_number: status == PTC_E_INPUT;
    y[0] = 0.0f;
    a_name_that_fills_half_of_a_line_alone_4_eva_untouched(self);
}
#endif

/* The whole proof of a_name_that_fills_half_of_a_line_alone_4. */
void a_name_that_fills_half_of_a_line_alone_4_eva(void)
{
#ifndef FINITE
    a_name_that_fills_half_of_a_line_alone_4_eva_null();
    a_name_that_fills_half_of_a_line_alone_4_eva_live(a_name_that_fills_half_of_a_line_alone_4_eva_draw(0.0f, 0.0f), 0);
    a_name_that_fills_half_of_a_line_alone_4_eva_live(a_name_that_fills_half_of_a_line_alone_4_eva_number(1, 0.0f, 1.0f), 1);
#endif
    a_name_that_fills_half_of_a_line_alone_4_eva_live(A_NAME_THAT_FILLS_HALF_OF_A_LINE_ALONE_4_EVA_U_MAX_MIN, 2);
    if (A_NAME_THAT_FILLS_HALF_OF_A_LINE_ALONE_4_EVA_U_MAX_MAX > A_NAME_THAT_FILLS_HALF_OF_A_LINE_ALONE_4_EVA_U_MAX_MIN) {
        a_name_that_fills_half_of_a_line_alone_4_eva_live(A_NAME_THAT_FILLS_HALF_OF_A_LINE_ALONE_4_EVA_U_MAX_MAX, 2);
    }
}

/* Left out where a program of several proofs has a main of its own. */
#ifndef PTC_EVA_PART
int main(void)
{
    a_name_that_fills_half_of_a_line_alone_4_eva();
    return 0;
}
#endif
