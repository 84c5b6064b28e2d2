/*
 * Proof that stage21.c has no error at run time, with the plug-in Eva of Frama-C. Here are stage21.h,
 * stage21.c and this file, all three written by ptc-codegen emit --acsl. DO NOT EDIT.
 *
 * Any inputs, with NaN, infinities and NULL:
 *   frama-c -eva -eva-slevel 1000 -eva-slevel-merge-after-loop @all -eva-split-return full -eva-subdivide-non-linear 20 -eva-domains equality -warn-special-float none stage21_eva.c stage21.c
 * Finite inputs, and no value on the way may overflow or be NaN:
 *   frama-c -cpp-extra-args=-DFINITE -eva -eva-slevel 1000 -eva-slevel-merge-after-loop @all -eva-split-return full -eva-subdivide-non-linear 20 -eva-domains equality -warn-special-float non-finite stage21_eva.c stage21.c
 *
 * It is proved where no line begins with [eva:alarm] and the summary has no property unknown. A call is
 * proved from whatever the calls before it may have left. In finite mode values are drawn from the ranges
 * below; give others with -cpp-extra-args="-DFINITE -D<macro>=<number>".
 */
#include "stage21.h"

#include <math.h>
#include <stddef.h>

#include "__fc_builtin.h"

#ifndef STAGE21_EVA_SAMPLES_MIN
#define STAGE21_EVA_SAMPLES_MIN 4U
#endif
#ifndef STAGE21_EVA_SAMPLES_MAX
#define STAGE21_EVA_SAMPLES_MAX 1000U
#endif
#ifndef STAGE21_EVA_H_MIN
#define STAGE21_EVA_H_MIN 0.01
#endif
#ifndef STAGE21_EVA_H_MAX
#define STAGE21_EVA_H_MAX 0.01
#endif
#ifndef STAGE21_EVA_U_MAX_MIN
#define STAGE21_EVA_U_MAX_MIN 10.0
#endif
#ifndef STAGE21_EVA_U_MAX_MAX
#define STAGE21_EVA_U_MAX_MAX 10.0
#endif
#ifndef STAGE21_EVA_K1_MIN
#define STAGE21_EVA_K1_MIN -100.0
#endif
#ifndef STAGE21_EVA_K1_MAX
#define STAGE21_EVA_K1_MAX 100.0
#endif
#ifndef STAGE21_EVA_K2_MIN
#define STAGE21_EVA_K2_MIN -100.0
#endif
#ifndef STAGE21_EVA_K2_MAX
#define STAGE21_EVA_K2_MAX 100.0
#endif
#ifndef STAGE21_EVA_K3_MIN
#define STAGE21_EVA_K3_MIN -100.0
#endif
#ifndef STAGE21_EVA_K3_MAX
#define STAGE21_EVA_K3_MAX 100.0
#endif
#ifndef STAGE21_EVA_K4_MIN
#define STAGE21_EVA_K4_MIN -100.0
#endif
#ifndef STAGE21_EVA_K4_MAX
#define STAGE21_EVA_K4_MAX 100.0
#endif
#ifndef STAGE21_EVA_DEADBEAT_MIN
#define STAGE21_EVA_DEADBEAT_MIN 0.0
#endif
#ifndef STAGE21_EVA_DEADBEAT_MAX
#define STAGE21_EVA_DEADBEAT_MAX 0.0
#endif
#ifndef STAGE21_EVA_SIZE_MIN
#define STAGE21_EVA_SIZE_MIN 1.0
#endif
#ifndef STAGE21_EVA_SIZE_MAX
#define STAGE21_EVA_SIZE_MAX 1.0
#endif
/* Upper bound of the ticks since the start: the precision represents each up to here exactly. */
#ifndef STAGE21_EVA_ELAPSED_MAX
#define STAGE21_EVA_ELAPSED_MAX 4294967295U
#endif
/* Bounds of what is measured, and of the fields that calls change. */
#ifndef STAGE21_EVA_Y1_MAX
#define STAGE21_EVA_Y1_MAX 10.0
#endif
#ifndef STAGE21_EVA_Y2_MAX
#define STAGE21_EVA_Y2_MAX 10.0
#endif
#ifndef STAGE21_EVA_Y3_MAX
#define STAGE21_EVA_Y3_MAX 10.0
#endif
#ifndef STAGE21_EVA_U1_MAX
#define STAGE21_EVA_U1_MAX 10.0
#endif

/* Frama-C leaves the sign of a true isfinite open; the code only asks whether it is 0. */
/*@ ensures \result >= 0; */
extern int __finite(double d);
/*@ ensures \result >= 0; */
extern int __finitef(float f);

static volatile double stage21_eva_source;

/* Any number, or in finite mode one of least to greatest. */
static double stage21_eva_draw(double least, double greatest)
{
#ifdef FINITE
    return Frama_C_double_interval(least, greatest);
#else
    (void)least;
    (void)greatest;
    return stage21_eva_source;
#endif
}

/* The same, but at the levels above 0 finite: Eva takes NaN to both sides of a comparison, so that it does
 * not see that one refuses it. */
static double stage21_eva_number(int level, double least, double greatest)
{
    const double v = stage21_eva_draw(least, greatest);

    return ((level > 0) && (isfinite(v) == 0)) ? greatest : v;
}

static uint32_t stage21_eva_count(uint32_t least, uint32_t greatest)
{
    return (uint32_t)Frama_C_unsigned_int_interval(least, greatest);
}

/* Any tick. */
static uint32_t stage21_eva_tick(void)
{
    return stage21_eva_count(0U, 4294967295U);
}

/* Fields that nothing has set. */
static void stage21_eva_blank(stage21 *self)
{
    self->start = 42U;
    self->samples = 42U;
    self->u1 = 42.0;
    self->h = 42.0;
    self->p_size = 42.0;
    self->c_r3 = 42.0;
    self->c_r5 = 42.0;
    self->c_r6 = 42.0;
    self->c_r12 = 42.0;
    self->deadbeat = 42.0;
    self->w1_1 = 42.0;
    self->w1_2 = 42.0;
    self->w1_3 = 42.0;
    self->w1_4 = 42.0;
    self->w2_2 = 42.0;
    self->w2_3 = 42.0;
    self->w2_4 = 42.0;
    self->w3_3 = 42.0;
    self->w3_4 = 42.0;
    self->w4_4 = 42.0;
    self->b_1 = 42.0;
    self->b_2 = 42.0;
    self->b_3 = 42.0;
    self->u_max = 42.0;
}

static void stage21_eva_untouched(const stage21 *self)
{
    (void)self;
    //@ assert untouched: self->start == 42;
    //@ assert untouched: self->samples == 42;
    //@ assert untouched: self->u1 == 42.0;
    //@ assert untouched: self->h == 42.0;
    //@ assert untouched: self->p_size == 42.0;
    //@ assert untouched: self->c_r3 == 42.0;
    //@ assert untouched: self->c_r5 == 42.0;
    //@ assert untouched: self->c_r6 == 42.0;
    //@ assert untouched: self->c_r12 == 42.0;
    //@ assert untouched: self->deadbeat == 42.0;
    //@ assert untouched: self->w1_1 == 42.0;
    //@ assert untouched: self->w1_2 == 42.0;
    //@ assert untouched: self->w1_3 == 42.0;
    //@ assert untouched: self->w1_4 == 42.0;
    //@ assert untouched: self->w2_2 == 42.0;
    //@ assert untouched: self->w2_3 == 42.0;
    //@ assert untouched: self->w2_4 == 42.0;
    //@ assert untouched: self->w3_3 == 42.0;
    //@ assert untouched: self->w3_4 == 42.0;
    //@ assert untouched: self->w4_4 == 42.0;
    //@ assert untouched: self->b_1 == 42.0;
    //@ assert untouched: self->b_2 == 42.0;
    //@ assert untouched: self->b_3 == 42.0;
    //@ assert untouched: self->u_max == 42.0;
}

/* What calls may leave, and more. */
static void stage21_eva_kept(stage21 *self)
{
    self->start = stage21_eva_tick();
    self->u1 = stage21_eva_draw(-STAGE21_EVA_U1_MAX, STAGE21_EVA_U1_MAX);
}

/* A call at any tick, and the estimates behind it: a status, with u = 0 where it is negative; at level 1 that
 * u is finite, at 2 its bound. */
static void stage21_eva_use(stage21 *self, double limit, int level)
{
#ifdef FINITE
    /* Only differences of ticks are used. */
    self->start = 0U;
    const uint32_t k = stage21_eva_count(0U, STAGE21_EVA_ELAPSED_MAX);
#else
    const uint32_t k = stage21_eva_tick();
#endif
    double x[3];
    ptc_status status;
    double u;

    (void)limit;
    (void)level;
    x[0] = stage21_eva_draw(-STAGE21_EVA_Y1_MAX, STAGE21_EVA_Y1_MAX);
    x[1] = stage21_eva_draw(-STAGE21_EVA_Y2_MAX, STAGE21_EVA_Y2_MAX);
    x[2] = stage21_eva_draw(-STAGE21_EVA_Y3_MAX, STAGE21_EVA_Y3_MAX);
    status = stage21_step(self, k, x, &u);
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
static void stage21_eva_live(double limit, int level)
{
    stage21_params params;
    stage21 own;
    stage21 *const self = &own;
    ptc_status status;

    params.u_max = limit;
    params.samples = stage21_eva_count(STAGE21_EVA_SAMPLES_MIN, STAGE21_EVA_SAMPLES_MAX);
    params.h = stage21_eva_draw(STAGE21_EVA_H_MIN, STAGE21_EVA_H_MAX);
    params.k[0] = stage21_eva_draw(STAGE21_EVA_K1_MIN, STAGE21_EVA_K1_MAX);
    params.k[1] = stage21_eva_draw(STAGE21_EVA_K2_MIN, STAGE21_EVA_K2_MAX);
    params.k[2] = stage21_eva_draw(STAGE21_EVA_K3_MIN, STAGE21_EVA_K3_MAX);
    params.k[3] = stage21_eva_draw(STAGE21_EVA_K4_MIN, STAGE21_EVA_K4_MAX);
    params.deadbeat = stage21_eva_draw(STAGE21_EVA_DEADBEAT_MIN, STAGE21_EVA_DEADBEAT_MAX);
    params.size = stage21_eva_draw(STAGE21_EVA_SIZE_MIN, STAGE21_EVA_SIZE_MAX);
    stage21_eva_blank(self);
    status = stage21_init(self, &params);
    if (status == PTC_OK) {
        stage21_eva_use(self, limit, level);
        status = stage21_arm(self, stage21_eva_tick());
        //@ assert armed: status == PTC_OK;
        stage21_eva_kept(self);
        stage21_eva_use(self, limit, level);
    } else {
        //@ assert refused: status == PTC_E_PARAM;
        stage21_eva_untouched(self);
#ifdef FINITE
        //@ assert started: \false;
#endif
    }
}

#ifndef FINITE
/* NULL for every pointer that is checked, and no number for every input. */
static void stage21_eva_null(void)
{
    stage21_params params;
    stage21 own;
    stage21 *const self = &own;
    ptc_status status;
    const uint32_t k = stage21_eva_tick();
    double x[3];
    double u;

    params.u_max = stage21_eva_draw(0.0, 0.0);
    params.samples = stage21_eva_tick();
    params.h = stage21_eva_draw(0.0, 0.0);
    params.k[0] = stage21_eva_draw(0.0, 0.0);
    params.k[1] = stage21_eva_draw(0.0, 0.0);
    params.k[2] = stage21_eva_draw(0.0, 0.0);
    params.k[3] = stage21_eva_draw(0.0, 0.0);
    params.deadbeat = stage21_eva_draw(0.0, 0.0);
    params.size = stage21_eva_draw(0.0, 0.0);
    stage21_eva_blank(self);
    status = stage21_init(NULL, &params);
    //@ assert no_self: status == PTC_E_PARAM;
    status = stage21_init(self, NULL);
    //@ assert no_params: status == PTC_E_PARAM;
    stage21_eva_untouched(self);
    x[0] = stage21_eva_draw(0.0, 0.0);
    x[1] = stage21_eva_draw(0.0, 0.0);
    x[2] = stage21_eva_draw(0.0, 0.0);
    status = stage21_arm(NULL, k);
    //@ assert missing: status == PTC_E_INPUT;
    status = stage21_step(NULL, k, x, &u);
    //@ assert missing: status == PTC_E_INPUT;
    //@ assert zero: u == 0.0;
    status = stage21_step(self, k, NULL, &u);
    //@ assert missing: status == PTC_E_INPUT;
    //@ assert zero: u == 0.0;
    status = stage21_step(self, k, x, NULL);
    //@ assert missing: status == PTC_E_INPUT;
    stage21_eva_untouched(self);
    x[0] = 0.0;
    x[1] = 0.0;
    x[2] = 0.0;
    x[0] = NAN;
    status = stage21_step(self, k, x, &u);
    //@ assert no_number: status == PTC_E_INPUT;
    x[0] = 0.0;
    x[1] = NAN;
    status = stage21_step(self, k, x, &u);
    //@ assert no_number: status == PTC_E_INPUT;
    x[1] = 0.0;
    x[2] = NAN;
    status = stage21_step(self, k, x, &u);
    //@ assert no_number: status == PTC_E_INPUT;
    x[2] = 0.0;
    stage21_eva_untouched(self);
}
#endif

/* The whole proof of stage21. */
void stage21_eva(void)
{
#ifndef FINITE
    stage21_eva_null();
    stage21_eva_live(stage21_eva_draw(0.0, 0.0), 0);
    stage21_eva_live(stage21_eva_number(1, 0.0, 1.0), 1);
#endif
    stage21_eva_live(STAGE21_EVA_U_MAX_MIN, 2);
    if (STAGE21_EVA_U_MAX_MAX > STAGE21_EVA_U_MAX_MIN) {
        stage21_eva_live(STAGE21_EVA_U_MAX_MAX, 2);
    }
}

/* Left out where a program of several proofs has a main of its own. */
#ifndef PTC_EVA_PART
int main(void)
{
    stage21_eva();
    return 0;
}
#endif
