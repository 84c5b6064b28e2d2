/*
 * Proof that stage37.c has no error at run time, with the plug-in Eva of Frama-C. Here are stage37.h,
 * stage37.c and this file, all three written by ptc-codegen emit --acsl. DO NOT EDIT.
 *
 * Any inputs, with NaN, infinities and NULL:
 *   frama-c -eva -eva-slevel 1000 -eva-slevel-merge-after-loop @all -eva-split-return full -eva-subdivide-non-linear 20 -eva-domains equality -warn-special-float none stage37_eva.c stage37.c
 * Finite inputs, and no value on the way may overflow or be NaN:
 *   frama-c -cpp-extra-args=-DFINITE -eva -eva-slevel 1000 -eva-slevel-merge-after-loop @all -eva-split-return full -eva-subdivide-non-linear 20 -eva-domains equality -warn-special-float non-finite stage37_eva.c stage37.c
 *
 * It is proved where no line begins with [eva:alarm] and the summary has no property unknown. A call is
 * proved from whatever the calls before it may have left. In finite mode values are drawn from the ranges
 * below; give others with -cpp-extra-args="-DFINITE -D<macro>=<number>".
 */
#include "stage37.h"

#include <math.h>
#include <stddef.h>

#include "__fc_builtin.h"

#ifndef STAGE37_EVA_SAMPLES_MIN
#define STAGE37_EVA_SAMPLES_MIN 2U
#endif
#ifndef STAGE37_EVA_SAMPLES_MAX
#define STAGE37_EVA_SAMPLES_MAX 1000U
#endif
#ifndef STAGE37_EVA_H_MIN
#define STAGE37_EVA_H_MIN 0.01
#endif
#ifndef STAGE37_EVA_H_MAX
#define STAGE37_EVA_H_MAX 0.01
#endif
#ifndef STAGE37_EVA_U_MAX_MIN
#define STAGE37_EVA_U_MAX_MIN 10.0
#endif
#ifndef STAGE37_EVA_U_MAX_MAX
#define STAGE37_EVA_U_MAX_MAX 10.0
#endif
#ifndef STAGE37_EVA_U_MIN_MIN
#define STAGE37_EVA_U_MIN_MIN -10.0
#endif
#ifndef STAGE37_EVA_U_MIN_MAX
#define STAGE37_EVA_U_MIN_MAX -10.0
#endif
#ifndef STAGE37_EVA_A_MIN
#define STAGE37_EVA_A_MIN 1.0
#endif
#ifndef STAGE37_EVA_A_MAX
#define STAGE37_EVA_A_MAX 1.0
#endif
#ifndef STAGE37_EVA_K1_MIN
#define STAGE37_EVA_K1_MIN -100.0
#endif
#ifndef STAGE37_EVA_K1_MAX
#define STAGE37_EVA_K1_MAX 100.0
#endif
#ifndef STAGE37_EVA_K2_MIN
#define STAGE37_EVA_K2_MIN -100.0
#endif
#ifndef STAGE37_EVA_K2_MAX
#define STAGE37_EVA_K2_MAX 100.0
#endif
#ifndef STAGE37_EVA_DEADBEAT_MIN
#define STAGE37_EVA_DEADBEAT_MIN 0.0
#endif
#ifndef STAGE37_EVA_DEADBEAT_MAX
#define STAGE37_EVA_DEADBEAT_MAX 0.0
#endif
/* Bounds of what is measured, and of the fields that calls change. */
#ifndef STAGE37_EVA_Y1_MAX
#define STAGE37_EVA_Y1_MAX 10.0
#endif
#ifndef STAGE37_EVA_Y2_MAX
#define STAGE37_EVA_Y2_MAX 10.0
#endif

/* Frama-C leaves the sign of a true isfinite open; the code only asks whether it is 0. */
/*@ ensures \result >= 0; */
extern int __finite(double d);
/*@ ensures \result >= 0; */
extern int __finitef(float f);

static volatile double stage37_eva_source;

/* Any number, or in finite mode one of least to greatest. */
static double stage37_eva_draw(double least, double greatest)
{
#ifdef FINITE
    return Frama_C_double_interval(least, greatest);
#else
    (void)least;
    (void)greatest;
    return stage37_eva_source;
#endif
}

/* The same, but at the levels above 0 finite: Eva takes NaN to both sides of a comparison, so that it does
 * not see that one refuses it. */
static double stage37_eva_number(int level, double least, double greatest)
{
    const double v = stage37_eva_draw(least, greatest);

    return ((level > 0) && (isfinite(v) == 0)) ? greatest : v;
}

/* The same, but at level 2 one of least to greatest: of any number the bound of u would say nothing. */
static double stage37_eva_limit(int level, double least, double greatest)
{
    return (level > 1) ? Frama_C_double_interval(least, greatest)
                       : stage37_eva_number(level, least, greatest);
}

static uint32_t stage37_eva_count(uint32_t least, uint32_t greatest)
{
    return (uint32_t)Frama_C_unsigned_int_interval(least, greatest);
}

/* Any tick. */
static uint32_t stage37_eva_tick(void)
{
    return stage37_eva_count(0U, 4294967295U);
}

/* Fields that nothing has set. */
static void stage37_eva_blank(stage37 *self)
{
    self->start = 42U;
    self->samples = 42U;
    self->deadbeat = 42.0;
    self->w1_1 = 42.0;
    self->w1_2 = 42.0;
    self->w2_2 = 42.0;
    self->b_1 = 42.0;
    self->b_2 = 42.0;
    self->u_max = 42.0;
    self->u_min = 42.0;
}

static void stage37_eva_untouched(const stage37 *self)
{
    (void)self;
    //@ assert untouched: self->start == 42;
    //@ assert untouched: self->samples == 42;
    //@ assert untouched: self->deadbeat == 42.0;
    //@ assert untouched: self->w1_1 == 42.0;
    //@ assert untouched: self->w1_2 == 42.0;
    //@ assert untouched: self->w2_2 == 42.0;
    //@ assert untouched: self->b_1 == 42.0;
    //@ assert untouched: self->b_2 == 42.0;
    //@ assert untouched: self->u_max == 42.0;
    //@ assert untouched: self->u_min == 42.0;
}

/* What calls may leave, and more. */
static void stage37_eva_kept(stage37 *self)
{
    self->start = stage37_eva_tick();
}

/* A call at any tick, and the estimates behind it: a status, with u = 0 where it is negative; at level 1 that
 * u is finite, at 2 its bound. */
static void stage37_eva_use(stage37 *self, double limit, int level)
{
    const uint32_t k = stage37_eva_tick();
    double x[2];
    ptc_status status;
    double u;

    (void)limit;
    (void)level;
    x[0] = stage37_eva_draw(-STAGE37_EVA_Y1_MAX, STAGE37_EVA_Y1_MAX);
    x[1] = stage37_eva_draw(-STAGE37_EVA_Y2_MAX, STAGE37_EVA_Y2_MAX);
    status = stage37_step(self, k, x, &u);
    //@ assert known: -3 <= status <= 3 && status != PTC_E_PARAM;
    //@ assert refused: status < 0 ==> u == 0.0;
    if (level > 0) {
        //@ assert finite: \is_finite(u);
    }
    if (level > 1) {
        //@ assert bounded: status >= 0 ==> STAGE37_EVA_U_MIN_MIN <= u <= limit;
    }
#ifdef FINITE
    //@ assert accepted: status >= 0;
#endif
}

/* init and the first call, then arm and any call. */
static void stage37_eva_live(double limit, int level)
{
    stage37_params params;
    stage37 own;
    stage37 *const self = &own;
    ptc_status status;

    params.u_max = limit;
    params.samples = stage37_eva_count(STAGE37_EVA_SAMPLES_MIN, STAGE37_EVA_SAMPLES_MAX);
    params.h = stage37_eva_draw(STAGE37_EVA_H_MIN, STAGE37_EVA_H_MAX);
    params.u_min = stage37_eva_limit(level, STAGE37_EVA_U_MIN_MIN, STAGE37_EVA_U_MIN_MAX);
    params.a = stage37_eva_draw(STAGE37_EVA_A_MIN, STAGE37_EVA_A_MAX);
    params.k[0] = stage37_eva_draw(STAGE37_EVA_K1_MIN, STAGE37_EVA_K1_MAX);
    params.k[1] = stage37_eva_draw(STAGE37_EVA_K2_MIN, STAGE37_EVA_K2_MAX);
    params.deadbeat = stage37_eva_draw(STAGE37_EVA_DEADBEAT_MIN, STAGE37_EVA_DEADBEAT_MAX);
    stage37_eva_blank(self);
    status = stage37_init(self, &params);
    if (status == PTC_OK) {
        stage37_eva_use(self, limit, level);
        status = stage37_arm(self, stage37_eva_tick());
        //@ assert armed: status == PTC_OK;
        stage37_eva_kept(self);
        stage37_eva_use(self, limit, level);
    } else {
        //@ assert refused: status == PTC_E_PARAM;
        stage37_eva_untouched(self);
#ifdef FINITE
        //@ assert started: \false;
#endif
    }
}

#ifndef FINITE
/* NULL for every pointer that is checked, and no number for every input. */
static void stage37_eva_null(void)
{
    stage37_params params;
    stage37 own;
    stage37 *const self = &own;
    ptc_status status;
    const uint32_t k = stage37_eva_tick();
    double x[2];
    double u;

    params.u_max = stage37_eva_draw(0.0, 0.0);
    params.samples = stage37_eva_tick();
    params.h = stage37_eva_draw(0.0, 0.0);
    params.u_min = stage37_eva_draw(0.0, 0.0);
    params.a = stage37_eva_draw(0.0, 0.0);
    params.k[0] = stage37_eva_draw(0.0, 0.0);
    params.k[1] = stage37_eva_draw(0.0, 0.0);
    params.deadbeat = stage37_eva_draw(0.0, 0.0);
    stage37_eva_blank(self);
    status = stage37_init(NULL, &params);
    //@ assert no_self: status == PTC_E_PARAM;
    status = stage37_init(self, NULL);
    //@ assert no_params: status == PTC_E_PARAM;
    stage37_eva_untouched(self);
    x[0] = stage37_eva_draw(0.0, 0.0);
    x[1] = stage37_eva_draw(0.0, 0.0);
    status = stage37_arm(NULL, k);
    //@ assert missing: status == PTC_E_INPUT;
    status = stage37_step(NULL, k, x, &u);
    //@ assert missing: status == PTC_E_INPUT;
    //@ assert zero: u == 0.0;
    status = stage37_step(self, k, NULL, &u);
    //@ assert missing: status == PTC_E_INPUT;
    //@ assert zero: u == 0.0;
    status = stage37_step(self, k, x, NULL);
    //@ assert missing: status == PTC_E_INPUT;
    stage37_eva_untouched(self);
    x[0] = 0.0;
    x[1] = 0.0;
    x[0] = NAN;
    status = stage37_step(self, k, x, &u);
    //@ assert no_number: status == PTC_E_INPUT;
    x[0] = 0.0;
    x[1] = NAN;
    status = stage37_step(self, k, x, &u);
    //@ assert no_number: status == PTC_E_INPUT;
    x[1] = 0.0;
    stage37_eva_untouched(self);
}
#endif

/* The whole proof of stage37. */
void stage37_eva(void)
{
#ifndef FINITE
    stage37_eva_null();
    stage37_eva_live(stage37_eva_draw(0.0, 0.0), 0);
    stage37_eva_live(stage37_eva_number(1, 0.0, 1.0), 1);
#endif
    stage37_eva_live(STAGE37_EVA_U_MAX_MIN, 2);
    if (STAGE37_EVA_U_MAX_MAX > STAGE37_EVA_U_MAX_MIN) {
        stage37_eva_live(STAGE37_EVA_U_MAX_MAX, 2);
    }
}

/* Left out where a program of several proofs has a main of its own. */
#ifndef PTC_EVA_PART
int main(void)
{
    stage37_eva();
    return 0;
}
#endif
