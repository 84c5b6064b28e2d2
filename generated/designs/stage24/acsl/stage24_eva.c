/*
 * Proof that stage24.c has no error at run time, with the plug-in Eva of Frama-C. Here are stage24.h,
 * stage24.c and this file, all three written by ptc-codegen emit --acsl. DO NOT EDIT.
 *
 * Any inputs, with NaN, infinities and NULL:
 *   frama-c -eva -eva-slevel 1000 -eva-slevel-merge-after-loop @all -eva-split-return full -eva-subdivide-non-linear 20 -eva-domains equality -warn-special-float none stage24_eva.c stage24.c
 * Finite inputs, and no value on the way may overflow or be NaN:
 *   frama-c -cpp-extra-args=-DFINITE -eva -eva-slevel 1000 -eva-slevel-merge-after-loop @all -eva-split-return full -eva-subdivide-non-linear 20 -eva-domains equality -warn-special-float non-finite stage24_eva.c stage24.c
 *
 * It is proved where no line begins with [eva:alarm] and the summary has no property unknown. A call is
 * proved from whatever the calls before it may have left. In finite mode values are drawn from the ranges
 * below; give others with -cpp-extra-args="-DFINITE -D<macro>=<number>".
 */
#include "stage24.h"

#include <math.h>
#include <stddef.h>

#include "__fc_builtin.h"

#ifndef STAGE24_EVA_U_MAX_MIN
#define STAGE24_EVA_U_MAX_MIN 10.0f
#endif
#ifndef STAGE24_EVA_U_MAX_MAX
#define STAGE24_EVA_U_MAX_MAX 10.0f
#endif
#ifndef STAGE24_EVA_SIZE_MIN
#define STAGE24_EVA_SIZE_MIN 1.0f
#endif
#ifndef STAGE24_EVA_SIZE_MAX
#define STAGE24_EVA_SIZE_MAX 1.0f
#endif
/* Upper bound of the ticks since the start: the precision represents each up to here exactly. */
#ifndef STAGE24_EVA_ELAPSED_MAX
#define STAGE24_EVA_ELAPSED_MAX 16777216U
#endif
/* Bounds of what is measured, and of the fields that calls change. */
#ifndef STAGE24_EVA_Y1_MAX
#define STAGE24_EVA_Y1_MAX 10.0f
#endif
#ifndef STAGE24_EVA_Y2_MAX
#define STAGE24_EVA_Y2_MAX 10.0f
#endif

/* Frama-C leaves the sign of a true isfinite open; the code only asks whether it is 0. */
/*@ ensures \result >= 0; */
extern int __finite(double d);
/*@ ensures \result >= 0; */
extern int __finitef(float f);

static volatile float stage24_eva_source;

/* Any number, or in finite mode one of least to greatest. */
static float stage24_eva_draw(float least, float greatest)
{
#ifdef FINITE
    return Frama_C_float_interval(least, greatest);
#else
    (void)least;
    (void)greatest;
    return stage24_eva_source;
#endif
}

/* The same, but at the levels above 0 finite: Eva takes NaN to both sides of a comparison, so that it does
 * not see that one refuses it. */
static float stage24_eva_number(int level, float least, float greatest)
{
    const float v = stage24_eva_draw(least, greatest);

    return ((level > 0) && (isfinite(v) == 0)) ? greatest : v;
}

static uint32_t stage24_eva_count(uint32_t least, uint32_t greatest)
{
    return (uint32_t)Frama_C_unsigned_int_interval(least, greatest);
}

/* Any tick. */
static uint32_t stage24_eva_tick(void)
{
    return stage24_eva_count(0U, 4294967295U);
}

/* Fields that nothing has set. */
static void stage24_eva_blank(stage24 *self)
{
    self->start = 42U;
    self->p_size = 42.0f;
    self->c_r4 = 42.0f;
    self->u_max = 42.0f;
}

static void stage24_eva_untouched(const stage24 *self)
{
    (void)self;
    //@ assert untouched: self->start == 42;
    //@ assert untouched: self->p_size == 42.0;
    //@ assert untouched: self->c_r4 == 42.0;
    //@ assert untouched: self->u_max == 42.0;
}

/* What calls may leave, and more. */
static void stage24_eva_kept(stage24 *self)
{
    self->start = stage24_eva_tick();
}

/* A call at any tick, and the estimates behind it: a status, with u = 0 where it is negative; at level 1 that
 * u is finite, at 2 its bound. */
static void stage24_eva_use(stage24 *self, float limit, int level)
{
#ifdef FINITE
    /* Only differences of ticks are used. */
    self->start = 0U;
    const uint32_t k = stage24_eva_count(0U, STAGE24_EVA_ELAPSED_MAX);
#else
    const uint32_t k = stage24_eva_tick();
#endif
    float x[2];
    ptc_status status;
    float u;

    (void)limit;
    (void)level;
    x[0] = stage24_eva_draw(-STAGE24_EVA_Y1_MAX, STAGE24_EVA_Y1_MAX);
    x[1] = stage24_eva_draw(-STAGE24_EVA_Y2_MAX, STAGE24_EVA_Y2_MAX);
    status = stage24_step(self, k, x, &u);
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
static void stage24_eva_live(float limit, int level)
{
    stage24_params params;
    stage24 own;
    stage24 *const self = &own;
    ptc_status status;

    params.u_max = limit;
    params.size = stage24_eva_draw(STAGE24_EVA_SIZE_MIN, STAGE24_EVA_SIZE_MAX);
    stage24_eva_blank(self);
    status = stage24_init(self, &params);
    if (status == PTC_OK) {
        stage24_eva_use(self, limit, level);
        status = stage24_arm(self, stage24_eva_tick());
        //@ assert armed: status == PTC_OK;
        stage24_eva_kept(self);
        stage24_eva_use(self, limit, level);
    } else {
        //@ assert refused: status == PTC_E_PARAM;
        stage24_eva_untouched(self);
#ifdef FINITE
        //@ assert started: \false;
#endif
    }
}

#ifndef FINITE
/* NULL for every pointer that is checked, and no number for every input. */
static void stage24_eva_null(void)
{
    stage24_params params;
    stage24 own;
    stage24 *const self = &own;
    ptc_status status;
    const uint32_t k = stage24_eva_tick();
    float x[2];
    float u;

    params.u_max = stage24_eva_draw(0.0f, 0.0f);
    params.size = stage24_eva_draw(0.0f, 0.0f);
    stage24_eva_blank(self);
    status = stage24_init(NULL, &params);
    //@ assert no_self: status == PTC_E_PARAM;
    status = stage24_init(self, NULL);
    //@ assert no_params: status == PTC_E_PARAM;
    stage24_eva_untouched(self);
    x[0] = stage24_eva_draw(0.0f, 0.0f);
    x[1] = stage24_eva_draw(0.0f, 0.0f);
    status = stage24_arm(NULL, k);
    //@ assert missing: status == PTC_E_INPUT;
    status = stage24_step(NULL, k, x, &u);
    //@ assert missing: status == PTC_E_INPUT;
    //@ assert zero: u == 0.0;
    status = stage24_step(self, k, NULL, &u);
    //@ assert missing: status == PTC_E_INPUT;
    //@ assert zero: u == 0.0;
    status = stage24_step(self, k, x, NULL);
    //@ assert missing: status == PTC_E_INPUT;
    stage24_eva_untouched(self);
    x[0] = 0.0f;
    x[1] = 0.0f;
    x[0] = NAN;
    status = stage24_step(self, k, x, &u);
    //@ assert no_number: status == PTC_E_INPUT;
    x[0] = 0.0f;
    x[1] = NAN;
    status = stage24_step(self, k, x, &u);
    //@ assert no_number: status == PTC_E_INPUT;
    x[1] = 0.0f;
    stage24_eva_untouched(self);
}
#endif

/* The whole proof of stage24. */
void stage24_eva(void)
{
#ifndef FINITE
    stage24_eva_null();
    stage24_eva_live(stage24_eva_draw(0.0f, 0.0f), 0);
    stage24_eva_live(stage24_eva_number(1, 0.0f, 1.0f), 1);
#endif
    stage24_eva_live(STAGE24_EVA_U_MAX_MIN, 2);
    if (STAGE24_EVA_U_MAX_MAX > STAGE24_EVA_U_MAX_MIN) {
        stage24_eva_live(STAGE24_EVA_U_MAX_MAX, 2);
    }
}

/* Left out where a program of several proofs has a main of its own. */
#ifndef PTC_EVA_PART
int main(void)
{
    stage24_eva();
    return 0;
}
#endif
