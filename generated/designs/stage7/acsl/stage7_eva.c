/*
 * Proof that stage7.c has no error at run time, with the plug-in Eva of Frama-C. Here are stage7.h,
 * stage7.c and this file, all three written by ptc-codegen emit --acsl. DO NOT EDIT.
 *
 * Any inputs, with NaN, infinities and NULL:
 *   frama-c -eva -eva-slevel 1000 -eva-slevel-merge-after-loop @all -eva-split-return full -eva-subdivide-non-linear 20 -eva-domains equality -warn-special-float none stage7_eva.c stage7.c
 * Finite inputs, and no value on the way may overflow or be NaN:
 *   frama-c -cpp-extra-args=-DFINITE -eva -eva-slevel 1000 -eva-slevel-merge-after-loop @all -eva-split-return full -eva-subdivide-non-linear 20 -eva-domains equality -warn-special-float non-finite stage7_eva.c stage7.c
 *
 * It is proved where no line begins with [eva:alarm] and the summary has no property unknown. A call is
 * proved from whatever the calls before it may have left. In finite mode values are drawn from the ranges
 * below; give others with -cpp-extra-args="-DFINITE -D<macro>=<number>".
 */
#include "stage7.h"

#include <math.h>
#include <stddef.h>

#include "__fc_builtin.h"

#ifndef STAGE7_EVA_SAMPLES_MIN
#define STAGE7_EVA_SAMPLES_MIN 4U
#endif
#ifndef STAGE7_EVA_SAMPLES_MAX
#define STAGE7_EVA_SAMPLES_MAX 1000U
#endif
#ifndef STAGE7_EVA_H_MIN
#define STAGE7_EVA_H_MIN 0.01f
#endif
#ifndef STAGE7_EVA_H_MAX
#define STAGE7_EVA_H_MAX 0.01f
#endif
#ifndef STAGE7_EVA_U_MAX_MIN
#define STAGE7_EVA_U_MAX_MIN 10.0f
#endif
#ifndef STAGE7_EVA_U_MAX_MAX
#define STAGE7_EVA_U_MAX_MAX 10.0f
#endif
/* Bounds of what is measured, and of the fields that calls change. */
#ifndef STAGE7_EVA_Y1_MAX
#define STAGE7_EVA_Y1_MAX 10.0f
#endif
#ifndef STAGE7_EVA_U1_MAX
#define STAGE7_EVA_U1_MAX 10.0f
#endif
#ifndef STAGE7_EVA_X1_HAT_MAX
#define STAGE7_EVA_X1_HAT_MAX 10.0f
#endif
#ifndef STAGE7_EVA_D_HAT_MAX
#define STAGE7_EVA_D_HAT_MAX 10.0f
#endif

/* Frama-C leaves the sign of a true isfinite open; the code only asks whether it is 0. */
/*@ ensures \result >= 0; */
extern int __finite(double d);
/*@ ensures \result >= 0; */
extern int __finitef(float f);

static volatile float stage7_eva_source;

/* Any number, or in finite mode one of least to greatest. */
static float stage7_eva_draw(float least, float greatest)
{
#ifdef FINITE
    return Frama_C_float_interval(least, greatest);
#else
    (void)least;
    (void)greatest;
    return stage7_eva_source;
#endif
}

/* The same, but at the levels above 0 finite: Eva takes NaN to both sides of a comparison, so that it does
 * not see that one refuses it. */
static float stage7_eva_number(int level, float least, float greatest)
{
    const float v = stage7_eva_draw(least, greatest);

    return ((level > 0) && (isfinite(v) == 0)) ? greatest : v;
}

static uint32_t stage7_eva_count(uint32_t least, uint32_t greatest)
{
    return (uint32_t)Frama_C_unsigned_int_interval(least, greatest);
}

/* Any tick. */
static uint32_t stage7_eva_tick(void)
{
    return stage7_eva_count(0U, 4294967295U);
}

/* Fields that nothing has set. */
static void stage7_eva_blank(stage7 *self)
{
    self->start = 42U;
    self->samples = 42U;
    self->u1 = 42.0f;
    self->seen = 42U;
    self->x1_hat = 42.0f;
    self->d_hat = 42.0f;
    self->phi1_2 = 42.0f;
    self->q2_1 = 42.0f;
    self->e1_2 = 42.0f;
    self->e0_2 = 42.0f;
    self->w1_1 = 42.0f;
    self->u_max = 42.0f;
}

static void stage7_eva_untouched(const stage7 *self)
{
    (void)self;
    //@ assert untouched: self->start == 42;
    //@ assert untouched: self->samples == 42;
    //@ assert untouched: self->u1 == 42.0;
    //@ assert untouched: self->seen == 42;
    //@ assert untouched: self->x1_hat == 42.0;
    //@ assert untouched: self->d_hat == 42.0;
    //@ assert untouched: self->phi1_2 == 42.0;
    //@ assert untouched: self->q2_1 == 42.0;
    //@ assert untouched: self->e1_2 == 42.0;
    //@ assert untouched: self->e0_2 == 42.0;
    //@ assert untouched: self->w1_1 == 42.0;
    //@ assert untouched: self->u_max == 42.0;
}

/* What calls may leave, and more. */
static void stage7_eva_kept(stage7 *self)
{
    self->start = stage7_eva_tick();
    self->u1 = stage7_eva_draw(-STAGE7_EVA_U1_MAX, STAGE7_EVA_U1_MAX);
    self->seen = stage7_eva_count(0U, 1U);
    self->x1_hat = stage7_eva_draw(-STAGE7_EVA_X1_HAT_MAX, STAGE7_EVA_X1_HAT_MAX);
    self->d_hat = stage7_eva_draw(-STAGE7_EVA_D_HAT_MAX, STAGE7_EVA_D_HAT_MAX);
}

/* A call at any tick, and the estimates behind it: a status, with u = 0 where it is negative; at level 1 that
 * u is finite, at 2 its bound. */
static void stage7_eva_use(stage7 *self, float limit, int level)
{
    const uint32_t k = stage7_eva_tick();
    float y[1];
    ptc_status status;
    float u;
    float xhat[1];
    float d;

    (void)limit;
    (void)level;
    y[0] = stage7_eva_draw(-STAGE7_EVA_Y1_MAX, STAGE7_EVA_Y1_MAX);
    /* What the guard trusts. */
    const float y1 = y[0];
    if (isfinite(y1) == 0) {
        return;
    }
    y[0] = y1;
    status = stage7_step(self, k, y, &u);
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
    status = stage7_estimate(self, xhat);
    //@ assert given: status == PTC_OK;
    status = stage7_disturbance(self, &d);
    //@ assert given: status == PTC_OK;
    //@ assert initialized: \initialized(xhat + (0 .. 0));
    //@ assert initialized: \initialized(&d);
}

/* init and the first call, then arm and any call. */
static void stage7_eva_live(float limit, int level)
{
    stage7_params params;
    stage7 own;
    stage7 *const self = &own;
    ptc_status status;

    params.u_max = limit;
    params.samples = stage7_eva_count(STAGE7_EVA_SAMPLES_MIN, STAGE7_EVA_SAMPLES_MAX);
    params.h = stage7_eva_draw(STAGE7_EVA_H_MIN, STAGE7_EVA_H_MAX);
    stage7_eva_blank(self);
    status = stage7_init(self, &params);
    if (status == PTC_OK) {
        stage7_eva_use(self, limit, level);
        status = stage7_arm(self, stage7_eva_tick());
        //@ assert armed: status == PTC_OK;
        stage7_eva_kept(self);
        stage7_eva_use(self, limit, level);
    } else {
        //@ assert refused: status == PTC_E_PARAM;
        stage7_eva_untouched(self);
#ifdef FINITE
        //@ assert started: \false;
#endif
    }
}

#ifndef FINITE
/* NULL for every pointer that is checked, and no number for every input. */
static void stage7_eva_null(void)
{
    stage7_params params;
    stage7 own;
    stage7 *const self = &own;
    ptc_status status;

    params.u_max = stage7_eva_draw(0.0f, 0.0f);
    params.samples = stage7_eva_tick();
    params.h = stage7_eva_draw(0.0f, 0.0f);
    stage7_eva_blank(self);
    status = stage7_init(NULL, &params);
    //@ assert no_self: status == PTC_E_PARAM;
    status = stage7_init(self, NULL);
    //@ assert no_params: status == PTC_E_PARAM;
    stage7_eva_untouched(self);
}
#endif

/* The whole proof of stage7. */
void stage7_eva(void)
{
#ifndef FINITE
    stage7_eva_null();
    stage7_eva_live(stage7_eva_draw(0.0f, 0.0f), 0);
    stage7_eva_live(stage7_eva_number(1, 0.0f, 1.0f), 1);
#endif
    stage7_eva_live(STAGE7_EVA_U_MAX_MIN, 2);
    if (STAGE7_EVA_U_MAX_MAX > STAGE7_EVA_U_MAX_MIN) {
        stage7_eva_live(STAGE7_EVA_U_MAX_MAX, 2);
    }
}

/* Left out where a program of several proofs has a main of its own. */
#ifndef PTC_EVA_PART
int main(void)
{
    stage7_eva();
    return 0;
}
#endif
