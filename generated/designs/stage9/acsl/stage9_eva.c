/*
 * Proof that stage9.c has no error at run time, with the plug-in Eva of Frama-C. Here are stage9.h,
 * stage9.c and this file, all three written by ptc-codegen emit --acsl. DO NOT EDIT.
 *
 * Any inputs, with NaN, infinities and NULL:
 *   frama-c -eva -eva-slevel 1000 -eva-slevel-merge-after-loop @all -eva-split-return full -eva-subdivide-non-linear 20 -eva-domains equality -warn-special-float none stage9_eva.c stage9.c
 * Finite inputs, and no value on the way may overflow or be NaN:
 *   frama-c -cpp-extra-args=-DFINITE -eva -eva-slevel 1000 -eva-slevel-merge-after-loop @all -eva-split-return full -eva-subdivide-non-linear 20 -eva-domains equality -warn-special-float non-finite stage9_eva.c stage9.c
 *
 * It is proved where no line begins with [eva:alarm] and the summary has no property unknown. A call is
 * proved from whatever the calls before it may have left. In finite mode values are drawn from the ranges
 * below; give others with -cpp-extra-args="-DFINITE -D<macro>=<number>".
 */
#include "stage9.h"

#include <math.h>
#include <stddef.h>

#include "__fc_builtin.h"

#ifndef STAGE9_EVA_SAMPLES_MIN
#define STAGE9_EVA_SAMPLES_MIN 8U
#endif
#ifndef STAGE9_EVA_SAMPLES_MAX
#define STAGE9_EVA_SAMPLES_MAX 1000U
#endif
#ifndef STAGE9_EVA_H_MIN
#define STAGE9_EVA_H_MIN 0.01
#endif
#ifndef STAGE9_EVA_H_MAX
#define STAGE9_EVA_H_MAX 0.01
#endif
#ifndef STAGE9_EVA_K1_MIN
#define STAGE9_EVA_K1_MIN -100.0
#endif
#ifndef STAGE9_EVA_K1_MAX
#define STAGE9_EVA_K1_MAX 100.0
#endif
#ifndef STAGE9_EVA_K2_MIN
#define STAGE9_EVA_K2_MIN -100.0
#endif
#ifndef STAGE9_EVA_K2_MAX
#define STAGE9_EVA_K2_MAX 100.0
#endif
#ifndef STAGE9_EVA_K3_MIN
#define STAGE9_EVA_K3_MIN -100.0
#endif
#ifndef STAGE9_EVA_K3_MAX
#define STAGE9_EVA_K3_MAX 100.0
#endif
#ifndef STAGE9_EVA_K4_MIN
#define STAGE9_EVA_K4_MIN -100.0
#endif
#ifndef STAGE9_EVA_K4_MAX
#define STAGE9_EVA_K4_MAX 100.0
#endif
#ifndef STAGE9_EVA_DEADBEAT_MIN
#define STAGE9_EVA_DEADBEAT_MIN 0.0
#endif
#ifndef STAGE9_EVA_DEADBEAT_MAX
#define STAGE9_EVA_DEADBEAT_MAX 0.0
#endif
/* Bounds of what is measured, and of the fields that calls change. */
#ifndef STAGE9_EVA_Y1_MAX
#define STAGE9_EVA_Y1_MAX 10.0
#endif
#ifndef STAGE9_EVA_U1_MAX
#define STAGE9_EVA_U1_MAX 1000.0
#endif
#ifndef STAGE9_EVA_U2_MAX
#define STAGE9_EVA_U2_MAX 1000.0
#endif
#ifndef STAGE9_EVA_X1_HAT_MAX
#define STAGE9_EVA_X1_HAT_MAX 10.0
#endif
#ifndef STAGE9_EVA_X2_HAT_MAX
#define STAGE9_EVA_X2_HAT_MAX 10.0
#endif
#ifndef STAGE9_EVA_X3_HAT_MAX
#define STAGE9_EVA_X3_HAT_MAX 10.0
#endif

/* Frama-C leaves the sign of a true isfinite open; the code only asks whether it is 0. */
/*@ ensures \result >= 0; */
extern int __finite(double d);
/*@ ensures \result >= 0; */
extern int __finitef(float f);

static volatile double stage9_eva_source;

/* Any number, or in finite mode one of least to greatest. */
static double stage9_eva_draw(double least, double greatest)
{
#ifdef FINITE
    return Frama_C_double_interval(least, greatest);
#else
    (void)least;
    (void)greatest;
    return stage9_eva_source;
#endif
}

static uint32_t stage9_eva_count(uint32_t least, uint32_t greatest)
{
    return (uint32_t)Frama_C_unsigned_int_interval(least, greatest);
}

/* Any tick. */
static uint32_t stage9_eva_tick(void)
{
    return stage9_eva_count(0U, 4294967295U);
}

/* Fields that nothing has set. */
static void stage9_eva_blank(stage9 *self)
{
    self->start = 42U;
    self->samples = 42U;
    self->u1 = 42.0;
    self->u2 = 42.0;
    self->seen = 42U;
    self->x1_hat = 42.0;
    self->x2_hat = 42.0;
    self->x3_hat = 42.0;
    self->phi1_2 = 42.0;
    self->phi1_3 = 42.0;
    self->gamma1 = 42.0;
    self->hold_o = 42.0;
    self->q2_1 = 42.0;
    self->q2_2 = 42.0;
    self->q3_1 = 42.0;
    self->hold = 42.0;
    self->w1_1 = 42.0;
    self->w1_2 = 42.0;
    self->w1_3 = 42.0;
    self->w2_2 = 42.0;
    self->w2_3 = 42.0;
    self->w3_3 = 42.0;
    self->w4_4 = 42.0;
    self->b_1 = 42.0;
    self->b_2 = 42.0;
    self->b_3 = 42.0;
}

static void stage9_eva_untouched(const stage9 *self)
{
    (void)self;
    //@ assert untouched: self->start == 42;
    //@ assert untouched: self->samples == 42;
    //@ assert untouched: self->u1 == 42.0;
    //@ assert untouched: self->u2 == 42.0;
    //@ assert untouched: self->seen == 42;
    //@ assert untouched: self->x1_hat == 42.0;
    //@ assert untouched: self->x2_hat == 42.0;
    //@ assert untouched: self->x3_hat == 42.0;
    //@ assert untouched: self->phi1_2 == 42.0;
    //@ assert untouched: self->phi1_3 == 42.0;
    //@ assert untouched: self->gamma1 == 42.0;
    //@ assert untouched: self->hold_o == 42.0;
    //@ assert untouched: self->q2_1 == 42.0;
    //@ assert untouched: self->q2_2 == 42.0;
    //@ assert untouched: self->q3_1 == 42.0;
    //@ assert untouched: self->hold == 42.0;
    //@ assert untouched: self->w1_1 == 42.0;
    //@ assert untouched: self->w1_2 == 42.0;
    //@ assert untouched: self->w1_3 == 42.0;
    //@ assert untouched: self->w2_2 == 42.0;
    //@ assert untouched: self->w2_3 == 42.0;
    //@ assert untouched: self->w3_3 == 42.0;
    //@ assert untouched: self->w4_4 == 42.0;
    //@ assert untouched: self->b_1 == 42.0;
    //@ assert untouched: self->b_2 == 42.0;
    //@ assert untouched: self->b_3 == 42.0;
}

/* What calls may leave, and more. */
static void stage9_eva_kept(stage9 *self)
{
    self->start = stage9_eva_tick();
    self->u1 = stage9_eva_draw(-STAGE9_EVA_U1_MAX, STAGE9_EVA_U1_MAX);
    self->u2 = stage9_eva_draw(-STAGE9_EVA_U2_MAX, STAGE9_EVA_U2_MAX);
    self->seen = stage9_eva_count(0U, 1U);
    self->x1_hat = stage9_eva_draw(-STAGE9_EVA_X1_HAT_MAX, STAGE9_EVA_X1_HAT_MAX);
    self->x2_hat = stage9_eva_draw(-STAGE9_EVA_X2_HAT_MAX, STAGE9_EVA_X2_HAT_MAX);
    self->x3_hat = stage9_eva_draw(-STAGE9_EVA_X3_HAT_MAX, STAGE9_EVA_X3_HAT_MAX);
}

/* A call at any tick, and the estimates behind it: a status, with u = 0 where it is negative; at level 1 that
 * u is finite, at 2 its bound. */
static void stage9_eva_use(stage9 *self, double limit, int level)
{
    const uint32_t k = stage9_eva_tick();
    double y[1];
    ptc_status status;
    double u;
    double xhat[3];

    (void)limit;
    (void)level;
    y[0] = stage9_eva_draw(-STAGE9_EVA_Y1_MAX, STAGE9_EVA_Y1_MAX);
    status = stage9_step(self, k, y, &u);
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
    status = stage9_estimate(self, xhat);
    //@ assert given: status == PTC_OK;
    //@ assert initialized: \initialized(xhat + (0 .. 2));
}

/* init and the first call, then arm and any call. */
static void stage9_eva_live(double limit, int level)
{
    stage9_params params;
    stage9 own;
    stage9 *const self = &own;
    ptc_status status;

    params.samples = stage9_eva_count(STAGE9_EVA_SAMPLES_MIN, STAGE9_EVA_SAMPLES_MAX);
    params.h = stage9_eva_draw(STAGE9_EVA_H_MIN, STAGE9_EVA_H_MAX);
    params.k[0] = stage9_eva_draw(STAGE9_EVA_K1_MIN, STAGE9_EVA_K1_MAX);
    params.k[1] = stage9_eva_draw(STAGE9_EVA_K2_MIN, STAGE9_EVA_K2_MAX);
    params.k[2] = stage9_eva_draw(STAGE9_EVA_K3_MIN, STAGE9_EVA_K3_MAX);
    params.k[3] = stage9_eva_draw(STAGE9_EVA_K4_MIN, STAGE9_EVA_K4_MAX);
    params.deadbeat = stage9_eva_draw(STAGE9_EVA_DEADBEAT_MIN, STAGE9_EVA_DEADBEAT_MAX);
    stage9_eva_blank(self);
    status = stage9_init(self, &params);
    if (status == PTC_OK) {
        stage9_eva_use(self, limit, level);
        status = stage9_arm(self, stage9_eva_tick());
        //@ assert armed: status == PTC_OK;
        stage9_eva_kept(self);
        stage9_eva_use(self, limit, level);
    } else {
        //@ assert refused: status == PTC_E_PARAM;
        stage9_eva_untouched(self);
#ifdef FINITE
        //@ assert started: \false;
#endif
    }
}

#ifndef FINITE
/* NULL for every pointer that is checked, and no number for every input. */
static void stage9_eva_null(void)
{
    stage9_params params;
    stage9 own;
    stage9 *const self = &own;
    ptc_status status;
    const uint32_t k = stage9_eva_tick();
    double y[1];
    double u;
    double xhat[3];

    params.samples = stage9_eva_tick();
    params.h = stage9_eva_draw(0.0, 0.0);
    params.k[0] = stage9_eva_draw(0.0, 0.0);
    params.k[1] = stage9_eva_draw(0.0, 0.0);
    params.k[2] = stage9_eva_draw(0.0, 0.0);
    params.k[3] = stage9_eva_draw(0.0, 0.0);
    params.deadbeat = stage9_eva_draw(0.0, 0.0);
    stage9_eva_blank(self);
    status = stage9_init(NULL, &params);
    //@ assert no_self: status == PTC_E_PARAM;
    status = stage9_init(self, NULL);
    //@ assert no_params: status == PTC_E_PARAM;
    stage9_eva_untouched(self);
    y[0] = stage9_eva_draw(0.0, 0.0);
    status = stage9_arm(NULL, k);
    //@ assert missing: status == PTC_E_INPUT;
    status = stage9_step(NULL, k, y, &u);
    //@ assert missing: status == PTC_E_INPUT;
    //@ assert zero: u == 0.0;
    status = stage9_step(self, k, NULL, &u);
    //@ assert missing: status == PTC_E_INPUT;
    //@ assert zero: u == 0.0;
    status = stage9_step(self, k, y, NULL);
    //@ assert missing: status == PTC_E_INPUT;
    status = stage9_estimate(NULL, xhat);
    //@ assert missing: status == PTC_E_INPUT;
    status = stage9_estimate(self, NULL);
    //@ assert missing: status == PTC_E_INPUT;
    stage9_eva_untouched(self);
    y[0] = 0.0;
    y[0] = NAN;
    status = stage9_step(self, k, y, &u);
    //@ assert no_number: status == PTC_E_INPUT;
    y[0] = 0.0;
    stage9_eva_untouched(self);
}
#endif

/* The whole proof of stage9. */
void stage9_eva(void)
{
#ifndef FINITE
    stage9_eva_null();
#endif
    stage9_eva_live(1000.0, 2);
}

/* Left out where a program of several proofs has a main of its own. */
#ifndef PTC_EVA_PART
int main(void)
{
    stage9_eva();
    return 0;
}
#endif
