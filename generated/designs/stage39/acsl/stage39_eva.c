/*
 * Proof that stage39.c has no error at run time, with the plug-in Eva of Frama-C. Here are stage39.h,
 * stage39.c and this file, all three written by ptc-codegen emit --acsl. DO NOT EDIT.
 *
 * Any inputs, with NaN, infinities and NULL:
 *   frama-c -eva -eva-slevel 1000 -eva-slevel-merge-after-loop @all -eva-split-return full -eva-subdivide-non-linear 20 -eva-domains equality -warn-special-float none stage39_eva.c stage39.c
 * Finite inputs, and no value on the way may overflow or be NaN:
 *   frama-c -cpp-extra-args=-DFINITE -eva -eva-slevel 1000 -eva-slevel-merge-after-loop @all -eva-split-return full -eva-subdivide-non-linear 20 -eva-domains equality -warn-special-float non-finite stage39_eva.c stage39.c
 *
 * It is proved where no line begins with [eva:alarm] and the summary has no property unknown. A call is
 * proved from whatever the calls before it may have left. In finite mode values are drawn from the ranges
 * below; give others with -cpp-extra-args="-DFINITE -D<macro>=<number>".
 */
#include "stage39.h"

#include <math.h>
#include <stddef.h>

#include "__fc_builtin.h"

#ifndef STAGE39_EVA_SAMPLES_MIN
#define STAGE39_EVA_SAMPLES_MIN 1U
#endif
#ifndef STAGE39_EVA_SAMPLES_MAX
#define STAGE39_EVA_SAMPLES_MAX 1000U
#endif
#ifndef STAGE39_EVA_H_MIN
#define STAGE39_EVA_H_MIN 0.01
#endif
#ifndef STAGE39_EVA_H_MAX
#define STAGE39_EVA_H_MAX 0.01
#endif
#ifndef STAGE39_EVA_U_MAX_MIN
#define STAGE39_EVA_U_MAX_MIN 10.0
#endif
#ifndef STAGE39_EVA_U_MAX_MAX
#define STAGE39_EVA_U_MAX_MAX 10.0
#endif
#ifndef STAGE39_EVA_A_MIN
#define STAGE39_EVA_A_MIN 1.0
#endif
#ifndef STAGE39_EVA_A_MAX
#define STAGE39_EVA_A_MAX 1.0
#endif
#ifndef STAGE39_EVA_K1_MIN
#define STAGE39_EVA_K1_MIN -100.0
#endif
#ifndef STAGE39_EVA_K1_MAX
#define STAGE39_EVA_K1_MAX 100.0
#endif
#ifndef STAGE39_EVA_DEADBEAT_MIN
#define STAGE39_EVA_DEADBEAT_MIN 0.0
#endif
#ifndef STAGE39_EVA_DEADBEAT_MAX
#define STAGE39_EVA_DEADBEAT_MAX 0.0
#endif
/* Bounds of what is measured, and of the fields that calls change. */
#ifndef STAGE39_EVA_Y1_MAX
#define STAGE39_EVA_Y1_MAX 10.0
#endif

/* Frama-C leaves the sign of a true isfinite open; the code only asks whether it is 0. */
/*@ ensures \result >= 0; */
extern int __finite(double d);
/*@ ensures \result >= 0; */
extern int __finitef(float f);

static volatile double stage39_eva_source;

/* Any number, or in finite mode one of least to greatest. */
static double stage39_eva_draw(double least, double greatest)
{
#ifdef FINITE
    return Frama_C_double_interval(least, greatest);
#else
    (void)least;
    (void)greatest;
    return stage39_eva_source;
#endif
}

/* The same, but at the levels above 0 finite: Eva takes NaN to both sides of a comparison, so that it does
 * not see that one refuses it. */
static double stage39_eva_number(int level, double least, double greatest)
{
    const double v = stage39_eva_draw(least, greatest);

    return ((level > 0) && (isfinite(v) == 0)) ? greatest : v;
}

static uint32_t stage39_eva_count(uint32_t least, uint32_t greatest)
{
    return (uint32_t)Frama_C_unsigned_int_interval(least, greatest);
}

/* Any tick. */
static uint32_t stage39_eva_tick(void)
{
    return stage39_eva_count(0U, 4294967295U);
}

/* Fields that nothing has set. */
static void stage39_eva_blank(stage39 *self)
{
    self->start = 42U;
    self->samples = 42U;
    self->deadbeat = 42.0;
    self->w1_1 = 42.0;
    self->b_1 = 42.0;
    self->u_max = 42.0;
}

static void stage39_eva_untouched(const stage39 *self)
{
    (void)self;
    //@ assert untouched: self->start == 42;
    //@ assert untouched: self->samples == 42;
    //@ assert untouched: self->deadbeat == 42.0;
    //@ assert untouched: self->w1_1 == 42.0;
    //@ assert untouched: self->b_1 == 42.0;
    //@ assert untouched: self->u_max == 42.0;
}

/* What calls may leave, and more. */
static void stage39_eva_kept(stage39 *self)
{
    self->start = stage39_eva_tick();
}

/* A call at any tick, and the estimates behind it: a status, with u = 0 where it is negative; at level 1 that
 * u is finite, at 2 its bound. */
static void stage39_eva_use(stage39 *self, double limit, int level)
{
    const uint32_t k = stage39_eva_tick();
    double x[1];
    ptc_status status;
    double u;

    (void)limit;
    (void)level;
    x[0] = stage39_eva_draw(-STAGE39_EVA_Y1_MAX, STAGE39_EVA_Y1_MAX);
    /* What the guard trusts. */
    const double y1 = x[0];
    if (isfinite(y1) == 0) {
        return;
    }
    x[0] = y1;
    status = stage39_step(self, k, x, &u);
    //@ assert known: -3 <= status <= 3 && status != PTC_E_PARAM;
    //@ assert refused: status < 0 ==> u == 0.0;
    if (level > 0) {
        //@ assert finite: \is_finite(u);
    }
    if (level > 1) {
        //@ assert bounded: status >= 0 ==> 0.3333333333333333 <= u <= limit;
    }
#ifdef FINITE
    //@ assert accepted: status >= 0;
#endif
}

/* init and the first call, then arm and any call. */
static void stage39_eva_live(double limit, int level)
{
    stage39_params params;
    stage39 own;
    stage39 *const self = &own;
    ptc_status status;

    params.u_max = limit;
    params.samples = stage39_eva_count(STAGE39_EVA_SAMPLES_MIN, STAGE39_EVA_SAMPLES_MAX);
    params.h = stage39_eva_draw(STAGE39_EVA_H_MIN, STAGE39_EVA_H_MAX);
    params.a = stage39_eva_draw(STAGE39_EVA_A_MIN, STAGE39_EVA_A_MAX);
    params.k[0] = stage39_eva_draw(STAGE39_EVA_K1_MIN, STAGE39_EVA_K1_MAX);
    params.deadbeat = stage39_eva_draw(STAGE39_EVA_DEADBEAT_MIN, STAGE39_EVA_DEADBEAT_MAX);
    stage39_eva_blank(self);
    status = stage39_init(self, &params);
    if (status == PTC_OK) {
        stage39_eva_use(self, limit, level);
        status = stage39_arm(self, stage39_eva_tick());
        //@ assert armed: status == PTC_OK;
        stage39_eva_kept(self);
        stage39_eva_use(self, limit, level);
    } else {
        //@ assert refused: status == PTC_E_PARAM;
        stage39_eva_untouched(self);
#ifdef FINITE
        //@ assert started: \false;
#endif
    }
}

#ifndef FINITE
/* NULL for every pointer that is checked, and no number for every input. */
static void stage39_eva_null(void)
{
    stage39_params params;
    stage39 own;
    stage39 *const self = &own;
    ptc_status status;

    params.u_max = stage39_eva_draw(0.0, 0.0);
    params.samples = stage39_eva_tick();
    params.h = stage39_eva_draw(0.0, 0.0);
    params.a = stage39_eva_draw(0.0, 0.0);
    params.k[0] = stage39_eva_draw(0.0, 0.0);
    params.deadbeat = stage39_eva_draw(0.0, 0.0);
    stage39_eva_blank(self);
    status = stage39_init(NULL, &params);
    //@ assert no_self: status == PTC_E_PARAM;
    status = stage39_init(self, NULL);
    //@ assert no_params: status == PTC_E_PARAM;
    stage39_eva_untouched(self);
}
#endif

/* The whole proof of stage39. */
void stage39_eva(void)
{
#ifndef FINITE
    stage39_eva_null();
    stage39_eva_live(stage39_eva_draw(0.0, 0.0), 0);
    stage39_eva_live(stage39_eva_number(1, 0.0, 1.0), 1);
#endif
    stage39_eva_live(STAGE39_EVA_U_MAX_MIN, 2);
    if (STAGE39_EVA_U_MAX_MAX > STAGE39_EVA_U_MAX_MIN) {
        stage39_eva_live(STAGE39_EVA_U_MAX_MAX, 2);
    }
}

/* Left out where a program of several proofs has a main of its own. */
#ifndef PTC_EVA_PART
int main(void)
{
    stage39_eva();
    return 0;
}
#endif
