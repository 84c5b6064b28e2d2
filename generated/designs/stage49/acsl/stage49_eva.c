/*
 * Proof that stage49.c has no error at run time, with the plug-in Eva of Frama-C. Here are stage49.h,
 * stage49.c and this file, all three written by ptc-codegen emit --acsl. DO NOT EDIT.
 *
 * Any inputs, with NaN, infinities and NULL:
 *   frama-c -eva -eva-slevel 1000 -eva-slevel-merge-after-loop @all -eva-split-return full -eva-subdivide-non-linear 20 -eva-domains equality -warn-special-float none stage49_eva.c stage49.c
 * Finite inputs, and no value on the way may overflow or be NaN:
 *   frama-c -cpp-extra-args=-DFINITE -eva -eva-slevel 1000 -eva-slevel-merge-after-loop @all -eva-split-return full -eva-subdivide-non-linear 20 -eva-domains equality -warn-special-float non-finite stage49_eva.c stage49.c
 *
 * It is proved where no line begins with [eva:alarm] and the summary has no property unknown. A call is
 * proved from whatever the calls before it may have left. In finite mode values are drawn from the ranges
 * below; give others with -cpp-extra-args="-DFINITE -D<macro>=<number>".
 */
#include "stage49.h"

#include <math.h>
#include <stddef.h>

#include "__fc_builtin.h"

#ifndef STAGE49_EVA_U_MAX_MIN
#define STAGE49_EVA_U_MAX_MIN 10.0f
#endif
#ifndef STAGE49_EVA_U_MAX_MAX
#define STAGE49_EVA_U_MAX_MAX 10.0f
#endif
/* Bounds of what is measured, and of the fields that calls change. */
#ifndef STAGE49_EVA_Y1_MAX
#define STAGE49_EVA_Y1_MAX 10.0f
#endif
#ifndef STAGE49_EVA_Y2_MAX
#define STAGE49_EVA_Y2_MAX 10.0f
#endif
#ifndef STAGE49_EVA_U1_MAX
#define STAGE49_EVA_U1_MAX 10.0f
#endif
#ifndef STAGE49_EVA_U2_MAX
#define STAGE49_EVA_U2_MAX 10.0f
#endif

/* Frama-C leaves the sign of a true isfinite open; the code only asks whether it is 0. */
/*@ ensures \result >= 0; */
extern int __finite(double d);
/*@ ensures \result >= 0; */
extern int __finitef(float f);

static volatile float stage49_eva_source;

/* Any number, or in finite mode one of least to greatest. */
static float stage49_eva_draw(float least, float greatest)
{
#ifdef FINITE
    return Frama_C_float_interval(least, greatest);
#else
    (void)least;
    (void)greatest;
    return stage49_eva_source;
#endif
}

/* The same, but at the levels above 0 finite: Eva takes NaN to both sides of a comparison, so that it does
 * not see that one refuses it. */
static float stage49_eva_number(int level, float least, float greatest)
{
    const float v = stage49_eva_draw(least, greatest);

    return ((level > 0) && (isfinite(v) == 0)) ? greatest : v;
}

static uint32_t stage49_eva_count(uint32_t least, uint32_t greatest)
{
    return (uint32_t)Frama_C_unsigned_int_interval(least, greatest);
}

/* Any tick. */
static uint32_t stage49_eva_tick(void)
{
    return stage49_eva_count(0U, 4294967295U);
}

/* Fields that nothing has set. */
static void stage49_eva_blank(stage49 *self)
{
    self->start = 42U;
    self->u1 = 42.0f;
    self->u2 = 42.0f;
    self->u_max = 42.0f;
}

static void stage49_eva_untouched(const stage49 *self)
{
    (void)self;
    //@ assert untouched: self->start == 42;
    //@ assert untouched: self->u1 == 42.0;
    //@ assert untouched: self->u2 == 42.0;
    //@ assert untouched: self->u_max == 42.0;
}

/* What calls may leave, and more. */
static void stage49_eva_kept(stage49 *self)
{
    self->start = stage49_eva_tick();
    self->u1 = stage49_eva_draw(-STAGE49_EVA_U1_MAX, STAGE49_EVA_U1_MAX);
    self->u2 = stage49_eva_draw(-STAGE49_EVA_U2_MAX, STAGE49_EVA_U2_MAX);
}

/* A call at any tick, and the estimates behind it: a status, with u = 0 where it is negative; at level 1 that
 * u is finite, at 2 its bound. */
static void stage49_eva_use(stage49 *self, float limit, int level)
{
    const uint32_t k = stage49_eva_tick();
    float x[2];
    ptc_status status;
    float u;

    (void)limit;
    (void)level;
    x[0] = stage49_eva_draw(-STAGE49_EVA_Y1_MAX, STAGE49_EVA_Y1_MAX);
    x[1] = stage49_eva_draw(-STAGE49_EVA_Y2_MAX, STAGE49_EVA_Y2_MAX);
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
    status = stage49_step(self, k, x, &u);
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
static void stage49_eva_live(float limit, int level)
{
    stage49_params params;
    stage49 own;
    stage49 *const self = &own;
    ptc_status status;

    params.u_max = limit;
    stage49_eva_blank(self);
    status = stage49_init(self, &params);
    if (status == PTC_OK) {
        stage49_eva_use(self, limit, level);
        status = stage49_arm(self, stage49_eva_tick());
        //@ assert armed: status == PTC_OK;
        stage49_eva_kept(self);
        stage49_eva_use(self, limit, level);
    } else {
        //@ assert refused: status == PTC_E_PARAM;
        stage49_eva_untouched(self);
#ifdef FINITE
        //@ assert started: \false;
#endif
    }
}

#ifndef FINITE
/* NULL for every pointer that is checked, and no number for every input. */
static void stage49_eva_null(void)
{
    stage49_params params;
    stage49 own;
    stage49 *const self = &own;
    ptc_status status;

    params.u_max = stage49_eva_draw(0.0f, 0.0f);
    stage49_eva_blank(self);
    status = stage49_init(NULL, &params);
    //@ assert no_self: status == PTC_E_PARAM;
    status = stage49_init(self, NULL);
    //@ assert no_params: status == PTC_E_PARAM;
    stage49_eva_untouched(self);
}
#endif

/* The whole proof of stage49. */
void stage49_eva(void)
{
#ifndef FINITE
    stage49_eva_null();
    stage49_eva_live(stage49_eva_draw(0.0f, 0.0f), 0);
    stage49_eva_live(stage49_eva_number(1, 0.0f, 1.0f), 1);
#endif
    stage49_eva_live(STAGE49_EVA_U_MAX_MIN, 2);
    if (STAGE49_EVA_U_MAX_MAX > STAGE49_EVA_U_MAX_MIN) {
        stage49_eva_live(STAGE49_EVA_U_MAX_MAX, 2);
    }
}

/* Left out where a program of several proofs has a main of its own. */
#ifndef PTC_EVA_PART
int main(void)
{
    stage49_eva();
    return 0;
}
#endif
