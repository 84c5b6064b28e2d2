/*
 * Proof that stage45.c has no error at run time, with the plug-in Eva of Frama-C. Here are stage45.h,
 * stage45.c and this file, all three written by ptc-codegen emit --acsl. DO NOT EDIT.
 *
 * Any inputs, with NaN, infinities and NULL:
 *   frama-c -eva -eva-slevel 1000 -eva-slevel-merge-after-loop @all -eva-split-return full -eva-subdivide-non-linear 20 -eva-domains equality -warn-special-float none stage45_eva.c stage45.c
 * Finite inputs, and no value on the way may overflow or be NaN:
 *   frama-c -cpp-extra-args=-DFINITE -eva -eva-slevel 1000 -eva-slevel-merge-after-loop @all -eva-split-return full -eva-subdivide-non-linear 20 -eva-domains equality -warn-special-float non-finite stage45_eva.c stage45.c
 *
 * It is proved where no line begins with [eva:alarm] and the summary has no property unknown. A call is
 * proved from whatever the calls before it may have left. In finite mode values are drawn from the ranges
 * below; give others with -cpp-extra-args="-DFINITE -D<macro>=<number>".
 */
#include "stage45.h"

#include <math.h>
#include <stddef.h>

#include "__fc_builtin.h"

#ifndef STAGE45_EVA_SAMPLES_MIN
#define STAGE45_EVA_SAMPLES_MIN 7U
#endif
#ifndef STAGE45_EVA_SAMPLES_MAX
#define STAGE45_EVA_SAMPLES_MAX 1000U
#endif
#ifndef STAGE45_EVA_H_MIN
#define STAGE45_EVA_H_MIN 0.01f
#endif
#ifndef STAGE45_EVA_H_MAX
#define STAGE45_EVA_H_MAX 0.01f
#endif
#ifndef STAGE45_EVA_U_MAX_MIN
#define STAGE45_EVA_U_MAX_MIN 10.0f
#endif
#ifndef STAGE45_EVA_U_MAX_MAX
#define STAGE45_EVA_U_MAX_MAX 10.0f
#endif
#ifndef STAGE45_EVA_A_MIN
#define STAGE45_EVA_A_MIN 1.0f
#endif
#ifndef STAGE45_EVA_A_MAX
#define STAGE45_EVA_A_MAX 1.0f
#endif
#ifndef STAGE45_EVA_K1_MIN
#define STAGE45_EVA_K1_MIN -100.0f
#endif
#ifndef STAGE45_EVA_K1_MAX
#define STAGE45_EVA_K1_MAX 100.0f
#endif
#ifndef STAGE45_EVA_K2_MIN
#define STAGE45_EVA_K2_MIN -100.0f
#endif
#ifndef STAGE45_EVA_K2_MAX
#define STAGE45_EVA_K2_MAX 100.0f
#endif
#ifndef STAGE45_EVA_DEADBEAT_MIN
#define STAGE45_EVA_DEADBEAT_MIN 0.0f
#endif
#ifndef STAGE45_EVA_DEADBEAT_MAX
#define STAGE45_EVA_DEADBEAT_MAX 0.0f
#endif
/* Bounds of what is measured, and of the fields that calls change. */
#ifndef STAGE45_EVA_Y1_MAX
#define STAGE45_EVA_Y1_MAX 10.0f
#endif
#ifndef STAGE45_EVA_Y2_MAX
#define STAGE45_EVA_Y2_MAX 10.0f
#endif
#ifndef STAGE45_EVA_U1_MAX
#define STAGE45_EVA_U1_MAX 10.0f
#endif
#ifndef STAGE45_EVA_U2_MAX
#define STAGE45_EVA_U2_MAX 10.0f
#endif
#ifndef STAGE45_EVA_U3_MAX
#define STAGE45_EVA_U3_MAX 10.0f
#endif
#ifndef STAGE45_EVA_U4_MAX
#define STAGE45_EVA_U4_MAX 10.0f
#endif
#ifndef STAGE45_EVA_U5_MAX
#define STAGE45_EVA_U5_MAX 10.0f
#endif

/* Frama-C leaves the sign of a true isfinite open; the code only asks whether it is 0. */
/*@ ensures \result >= 0; */
extern int __finite(double d);
/*@ ensures \result >= 0; */
extern int __finitef(float f);

static volatile float stage45_eva_source;

/* Any number, or in finite mode one of least to greatest. */
static float stage45_eva_draw(float least, float greatest)
{
#ifdef FINITE
    return Frama_C_float_interval(least, greatest);
#else
    (void)least;
    (void)greatest;
    return stage45_eva_source;
#endif
}

/* The same, but at the levels above 0 finite: Eva takes NaN to both sides of a comparison, so that it does
 * not see that one refuses it. */
static float stage45_eva_number(int level, float least, float greatest)
{
    const float v = stage45_eva_draw(least, greatest);

    return ((level > 0) && (isfinite(v) == 0)) ? greatest : v;
}

static uint32_t stage45_eva_count(uint32_t least, uint32_t greatest)
{
    return (uint32_t)Frama_C_unsigned_int_interval(least, greatest);
}

/* Any tick. */
static uint32_t stage45_eva_tick(void)
{
    return stage45_eva_count(0U, 4294967295U);
}

/* Fields that nothing has set. */
static void stage45_eva_blank(stage45 *self)
{
    self->start = 42U;
    self->samples = 42U;
    self->u1 = 42.0f;
    self->u2 = 42.0f;
    self->u3 = 42.0f;
    self->u4 = 42.0f;
    self->u5 = 42.0f;
    self->deadbeat = 42.0f;
    self->w1_1 = 42.0f;
    self->w1_2 = 42.0f;
    self->w1_4 = 42.0f;
    self->w1_5 = 42.0f;
    self->w1_6 = 42.0f;
    self->w1_7 = 42.0f;
    self->w2_2 = 42.0f;
    self->w2_3 = 42.0f;
    self->b_1 = 42.0f;
    self->b_2 = 42.0f;
    self->u_max = 42.0f;
}

static void stage45_eva_untouched(const stage45 *self)
{
    (void)self;
    //@ assert untouched: self->start == 42;
    //@ assert untouched: self->samples == 42;
    //@ assert untouched: self->u1 == 42.0;
    //@ assert untouched: self->u2 == 42.0;
    //@ assert untouched: self->u3 == 42.0;
    //@ assert untouched: self->u4 == 42.0;
    //@ assert untouched: self->u5 == 42.0;
    //@ assert untouched: self->deadbeat == 42.0;
    //@ assert untouched: self->w1_1 == 42.0;
    //@ assert untouched: self->w1_2 == 42.0;
    //@ assert untouched: self->w1_4 == 42.0;
    //@ assert untouched: self->w1_5 == 42.0;
    //@ assert untouched: self->w1_6 == 42.0;
    //@ assert untouched: self->w1_7 == 42.0;
    //@ assert untouched: self->w2_2 == 42.0;
    //@ assert untouched: self->w2_3 == 42.0;
    //@ assert untouched: self->b_1 == 42.0;
    //@ assert untouched: self->b_2 == 42.0;
    //@ assert untouched: self->u_max == 42.0;
}

/* What calls may leave, and more. */
static void stage45_eva_kept(stage45 *self)
{
    self->start = stage45_eva_tick();
    self->u1 = stage45_eva_draw(-STAGE45_EVA_U1_MAX, STAGE45_EVA_U1_MAX);
    self->u2 = stage45_eva_draw(-STAGE45_EVA_U2_MAX, STAGE45_EVA_U2_MAX);
    self->u3 = stage45_eva_draw(-STAGE45_EVA_U3_MAX, STAGE45_EVA_U3_MAX);
    self->u4 = stage45_eva_draw(-STAGE45_EVA_U4_MAX, STAGE45_EVA_U4_MAX);
    self->u5 = stage45_eva_draw(-STAGE45_EVA_U5_MAX, STAGE45_EVA_U5_MAX);
}

/* A call at any tick, and the estimates behind it: a status, with u = 0 where it is negative; at level 1 that
 * u is finite, at 2 its bound. */
static void stage45_eva_use(stage45 *self, float limit, int level)
{
    const uint32_t k = stage45_eva_tick();
    float x[2];
    ptc_status status;
    float u;

    (void)limit;
    (void)level;
    x[0] = stage45_eva_draw(-STAGE45_EVA_Y1_MAX, STAGE45_EVA_Y1_MAX);
    x[1] = stage45_eva_draw(-STAGE45_EVA_Y2_MAX, STAGE45_EVA_Y2_MAX);
    /* What the guard trusts. */
    const float y1 = x[0];
    if (isfinite(y1) == 0) {
        return;
    }
    x[0] = y1;
    const float y2 = x[1];
    if (isfinite(y2) == 0) {
        return;
    }
    x[1] = y2;
    status = stage45_step(self, k, x, &u);
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
}

/* init and the first call, then arm and any call. */
static void stage45_eva_live(float limit, int level)
{
    stage45_params params;
    stage45 own;
    stage45 *const self = &own;
    ptc_status status;

    params.u_max = limit;
    params.samples = stage45_eva_count(STAGE45_EVA_SAMPLES_MIN, STAGE45_EVA_SAMPLES_MAX);
    params.h = stage45_eva_draw(STAGE45_EVA_H_MIN, STAGE45_EVA_H_MAX);
    params.a = stage45_eva_draw(STAGE45_EVA_A_MIN, STAGE45_EVA_A_MAX);
    params.k[0] = stage45_eva_draw(STAGE45_EVA_K1_MIN, STAGE45_EVA_K1_MAX);
    params.k[1] = stage45_eva_draw(STAGE45_EVA_K2_MIN, STAGE45_EVA_K2_MAX);
    params.deadbeat = stage45_eva_draw(STAGE45_EVA_DEADBEAT_MIN, STAGE45_EVA_DEADBEAT_MAX);
    stage45_eva_blank(self);
    status = stage45_init(self, &params);
    if (status == PTC_OK) {
        stage45_eva_use(self, limit, level);
        status = stage45_arm(self, stage45_eva_tick());
        //@ assert armed: status == PTC_OK;
        stage45_eva_kept(self);
        stage45_eva_use(self, limit, level);
    } else {
        //@ assert refused: status == PTC_E_PARAM;
        stage45_eva_untouched(self);
#ifdef FINITE
        //@ assert started: \false;
#endif
    }
}

#ifndef FINITE
/* NULL for every pointer that is checked, and no number for every input. */
static void stage45_eva_null(void)
{
    stage45_params params;
    stage45 own;
    stage45 *const self = &own;
    ptc_status status;

    params.u_max = stage45_eva_draw(0.0f, 0.0f);
    params.samples = stage45_eva_tick();
    params.h = stage45_eva_draw(0.0f, 0.0f);
    params.a = stage45_eva_draw(0.0f, 0.0f);
    params.k[0] = stage45_eva_draw(0.0f, 0.0f);
    params.k[1] = stage45_eva_draw(0.0f, 0.0f);
    params.deadbeat = stage45_eva_draw(0.0f, 0.0f);
    stage45_eva_blank(self);
    status = stage45_init(NULL, &params);
    //@ assert no_self: status == PTC_E_PARAM;
    status = stage45_init(self, NULL);
    //@ assert no_params: status == PTC_E_PARAM;
    stage45_eva_untouched(self);
}
#endif

/* The whole proof of stage45. */
void stage45_eva(void)
{
#ifndef FINITE
    stage45_eva_null();
    stage45_eva_live(stage45_eva_draw(0.0f, 0.0f), 0);
    stage45_eva_live(stage45_eva_number(1, 0.0f, 1.0f), 1);
#endif
    stage45_eva_live(STAGE45_EVA_U_MAX_MIN, 2);
    if (STAGE45_EVA_U_MAX_MAX > STAGE45_EVA_U_MAX_MIN) {
        stage45_eva_live(STAGE45_EVA_U_MAX_MAX, 2);
    }
}

/* Left out where a program of several proofs has a main of its own. */
#ifndef PTC_EVA_PART
int main(void)
{
    stage45_eva();
    return 0;
}
#endif
