/*
 * Proof that stage19.c has no error at run time, with the plug-in Eva of Frama-C. Here are stage19.h,
 * stage19.c and this file, all three written by ptc-codegen emit --acsl. DO NOT EDIT.
 *
 * Any inputs, with NaN, infinities and NULL:
 *   frama-c -eva -eva-slevel 1000 -eva-slevel-merge-after-loop @all -eva-split-return full -eva-subdivide-non-linear 20 -eva-domains equality -warn-special-float none stage19_eva.c stage19.c
 * Finite inputs, and no value on the way may overflow or be NaN:
 *   frama-c -cpp-extra-args=-DFINITE -eva -eva-slevel 1000 -eva-slevel-merge-after-loop @all -eva-split-return full -eva-subdivide-non-linear 20 -eva-domains equality -warn-special-float non-finite stage19_eva.c stage19.c
 *
 * It is proved where no line begins with [eva:alarm] and the summary has no property unknown. A call is
 * proved from whatever the calls before it may have left. In finite mode values are drawn from the ranges
 * below; give others with -cpp-extra-args="-DFINITE -D<macro>=<number>".
 */
#include "stage19.h"

#include <math.h>
#include <stddef.h>

#include "__fc_builtin.h"

#ifndef STAGE19_EVA_SAMPLES_MIN
#define STAGE19_EVA_SAMPLES_MIN 3U
#endif
#ifndef STAGE19_EVA_SAMPLES_MAX
#define STAGE19_EVA_SAMPLES_MAX 1000U
#endif
#ifndef STAGE19_EVA_H_MIN
#define STAGE19_EVA_H_MIN 0.01f
#endif
#ifndef STAGE19_EVA_H_MAX
#define STAGE19_EVA_H_MAX 0.01f
#endif
#ifndef STAGE19_EVA_K1_MIN
#define STAGE19_EVA_K1_MIN -100.0f
#endif
#ifndef STAGE19_EVA_K1_MAX
#define STAGE19_EVA_K1_MAX 100.0f
#endif
#ifndef STAGE19_EVA_K2_MIN
#define STAGE19_EVA_K2_MIN -100.0f
#endif
#ifndef STAGE19_EVA_K2_MAX
#define STAGE19_EVA_K2_MAX 100.0f
#endif
#ifndef STAGE19_EVA_K3_MIN
#define STAGE19_EVA_K3_MIN -100.0f
#endif
#ifndef STAGE19_EVA_K3_MAX
#define STAGE19_EVA_K3_MAX 100.0f
#endif
#ifndef STAGE19_EVA_DEADBEAT_MIN
#define STAGE19_EVA_DEADBEAT_MIN 0.0f
#endif
#ifndef STAGE19_EVA_DEADBEAT_MAX
#define STAGE19_EVA_DEADBEAT_MAX 0.0f
#endif
/* Bounds of what is measured, and of the fields that calls change. */
#ifndef STAGE19_EVA_Y1_MAX
#define STAGE19_EVA_Y1_MAX 10.0f
#endif
#ifndef STAGE19_EVA_Y2_MAX
#define STAGE19_EVA_Y2_MAX 10.0f
#endif
#ifndef STAGE19_EVA_Y3_MAX
#define STAGE19_EVA_Y3_MAX 10.0f
#endif

/* Frama-C leaves the sign of a true isfinite open; the code only asks whether it is 0. */
/*@ ensures \result >= 0; */
extern int __finite(double d);
/*@ ensures \result >= 0; */
extern int __finitef(float f);

static volatile float stage19_eva_source;

/* Any number, or in finite mode one of least to greatest. */
static float stage19_eva_draw(float least, float greatest)
{
#ifdef FINITE
    return Frama_C_float_interval(least, greatest);
#else
    (void)least;
    (void)greatest;
    return stage19_eva_source;
#endif
}

static uint32_t stage19_eva_count(uint32_t least, uint32_t greatest)
{
    return (uint32_t)Frama_C_unsigned_int_interval(least, greatest);
}

/* Any tick. */
static uint32_t stage19_eva_tick(void)
{
    return stage19_eva_count(0U, 4294967295U);
}

/* Fields that nothing has set. */
static void stage19_eva_blank(stage19 *self)
{
    self->start = 42U;
    self->samples = 42U;
    self->deadbeat = 42.0f;
    self->w1_1 = 42.0f;
    self->w1_2 = 42.0f;
    self->w1_3 = 42.0f;
    self->w2_2 = 42.0f;
    self->w2_3 = 42.0f;
    self->w3_3 = 42.0f;
    self->b_1 = 42.0f;
    self->b_2 = 42.0f;
    self->b_3 = 42.0f;
}

static void stage19_eva_untouched(const stage19 *self)
{
    (void)self;
    //@ assert untouched: self->start == 42;
    //@ assert untouched: self->samples == 42;
    //@ assert untouched: self->deadbeat == 42.0;
    //@ assert untouched: self->w1_1 == 42.0;
    //@ assert untouched: self->w1_2 == 42.0;
    //@ assert untouched: self->w1_3 == 42.0;
    //@ assert untouched: self->w2_2 == 42.0;
    //@ assert untouched: self->w2_3 == 42.0;
    //@ assert untouched: self->w3_3 == 42.0;
    //@ assert untouched: self->b_1 == 42.0;
    //@ assert untouched: self->b_2 == 42.0;
    //@ assert untouched: self->b_3 == 42.0;
}

/* What calls may leave, and more. */
static void stage19_eva_kept(stage19 *self)
{
    self->start = stage19_eva_tick();
}

/* A call at any tick, and the estimates behind it: a status, with u = 0 where it is negative; at level 1 that
 * u is finite, at 2 its bound. */
static void stage19_eva_use(stage19 *self, float limit, int level)
{
    const uint32_t k = stage19_eva_tick();
    float x[3];
    ptc_status status;
    float u;

    (void)limit;
    (void)level;
    x[0] = stage19_eva_draw(-STAGE19_EVA_Y1_MAX, STAGE19_EVA_Y1_MAX);
    x[1] = stage19_eva_draw(-STAGE19_EVA_Y2_MAX, STAGE19_EVA_Y2_MAX);
    x[2] = stage19_eva_draw(-STAGE19_EVA_Y3_MAX, STAGE19_EVA_Y3_MAX);
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
    const float y3 = x[2];
    if (isfinite(y3) == 0) {
        return;
    }
    x[2] = y3;
    status = stage19_step(self, k, x, &u);
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
static void stage19_eva_live(float limit, int level)
{
    stage19_params params;
    stage19 own;
    stage19 *const self = &own;
    ptc_status status;

    params.samples = stage19_eva_count(STAGE19_EVA_SAMPLES_MIN, STAGE19_EVA_SAMPLES_MAX);
    params.h = stage19_eva_draw(STAGE19_EVA_H_MIN, STAGE19_EVA_H_MAX);
    params.k[0] = stage19_eva_draw(STAGE19_EVA_K1_MIN, STAGE19_EVA_K1_MAX);
    params.k[1] = stage19_eva_draw(STAGE19_EVA_K2_MIN, STAGE19_EVA_K2_MAX);
    params.k[2] = stage19_eva_draw(STAGE19_EVA_K3_MIN, STAGE19_EVA_K3_MAX);
    params.deadbeat = stage19_eva_draw(STAGE19_EVA_DEADBEAT_MIN, STAGE19_EVA_DEADBEAT_MAX);
    stage19_eva_blank(self);
    status = stage19_init(self, &params);
    if (status == PTC_OK) {
        stage19_eva_use(self, limit, level);
        status = stage19_arm(self, stage19_eva_tick());
        //@ assert armed: status == PTC_OK;
        stage19_eva_kept(self);
        stage19_eva_use(self, limit, level);
    } else {
        //@ assert refused: status == PTC_E_PARAM;
        stage19_eva_untouched(self);
#ifdef FINITE
        //@ assert started: \false;
#endif
    }
}

#ifndef FINITE
/* NULL for every pointer that is checked, and no number for every input. */
static void stage19_eva_null(void)
{
    stage19_params params;
    stage19 own;
    stage19 *const self = &own;
    ptc_status status;

    params.samples = stage19_eva_tick();
    params.h = stage19_eva_draw(0.0f, 0.0f);
    params.k[0] = stage19_eva_draw(0.0f, 0.0f);
    params.k[1] = stage19_eva_draw(0.0f, 0.0f);
    params.k[2] = stage19_eva_draw(0.0f, 0.0f);
    params.deadbeat = stage19_eva_draw(0.0f, 0.0f);
    stage19_eva_blank(self);
    status = stage19_init(NULL, &params);
    //@ assert no_self: status == PTC_E_PARAM;
    status = stage19_init(self, NULL);
    //@ assert no_params: status == PTC_E_PARAM;
    stage19_eva_untouched(self);
}
#endif

/* The whole proof of stage19. */
void stage19_eva(void)
{
#ifndef FINITE
    stage19_eva_null();
#endif
    stage19_eva_live(0.0f, 1);
}

/* Left out where a program of several proofs has a main of its own. */
#ifndef PTC_EVA_PART
int main(void)
{
    stage19_eva();
    return 0;
}
#endif
