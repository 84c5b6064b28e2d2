/*
 * Proof that stage8.c has no error at run time, with the plug-in Eva of Frama-C. Here are stage8.h,
 * stage8.c and this file, all three written by ptc-codegen emit --acsl. DO NOT EDIT.
 *
 * Any inputs, with NaN, infinities and NULL:
 *   frama-c -eva -eva-slevel 1000 -eva-slevel-merge-after-loop @all -eva-split-return full -eva-subdivide-non-linear 20 -eva-domains equality -warn-special-float none stage8_eva.c stage8.c
 * Finite inputs, and no value on the way may overflow or be NaN:
 *   frama-c -cpp-extra-args=-DFINITE -eva -eva-slevel 1000 -eva-slevel-merge-after-loop @all -eva-split-return full -eva-subdivide-non-linear 20 -eva-domains equality -warn-special-float non-finite stage8_eva.c stage8.c
 *
 * It is proved where no line begins with [eva:alarm] and the summary has no property unknown. A call is
 * proved from whatever the calls before it may have left. In finite mode values are drawn from the ranges
 * below; give others with -cpp-extra-args="-DFINITE -D<macro>=<number>".
 */
#include "stage8.h"

#include <math.h>
#include <stddef.h>

#include "__fc_builtin.h"

/* Bounds of what is measured, and of the fields that calls change. */
#ifndef STAGE8_EVA_Y1_MAX
#define STAGE8_EVA_Y1_MAX 10.0
#endif
#ifndef STAGE8_EVA_Y2_MAX
#define STAGE8_EVA_Y2_MAX 10.0
#endif

/* Frama-C leaves the sign of a true isfinite open; the code only asks whether it is 0. */
/*@ ensures \result >= 0; */
extern int __finite(double d);
/*@ ensures \result >= 0; */
extern int __finitef(float f);

static volatile double stage8_eva_source;

/* Any number, or in finite mode one of least to greatest. */
static double stage8_eva_draw(double least, double greatest)
{
#ifdef FINITE
    return Frama_C_double_interval(least, greatest);
#else
    (void)least;
    (void)greatest;
    return stage8_eva_source;
#endif
}

static uint32_t stage8_eva_count(uint32_t least, uint32_t greatest)
{
    return (uint32_t)Frama_C_unsigned_int_interval(least, greatest);
}

/* Any tick. */
static uint32_t stage8_eva_tick(void)
{
    return stage8_eva_count(0U, 4294967295U);
}

/* Fields that nothing has set. */
static void stage8_eva_blank(stage8 *self)
{
    self->start = 42U;
}

static void stage8_eva_untouched(const stage8 *self)
{
    (void)self;
    //@ assert untouched: self->start == 42;
}

/* What calls may leave, and more. */
static void stage8_eva_kept(stage8 *self)
{
    self->start = stage8_eva_tick();
}

/* A call at any tick, and the estimates behind it: a status, with u = 0 where it is negative; at level 1 that
 * u is finite, at 2 its bound. */
static void stage8_eva_use(stage8 *self, double limit, int level)
{
    const uint32_t k = stage8_eva_tick();
    double x[2];
    ptc_status status;
    double u;

    (void)limit;
    (void)level;
    x[0] = stage8_eva_draw(-STAGE8_EVA_Y1_MAX, STAGE8_EVA_Y1_MAX);
    x[1] = stage8_eva_draw(-STAGE8_EVA_Y2_MAX, STAGE8_EVA_Y2_MAX);
    status = stage8_step(self, k, x, &u);
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
static void stage8_eva_live(double limit, int level)
{
    stage8_params params;
    stage8 own;
    stage8 *const self = &own;
    ptc_status status;

    params.none = 0;
    stage8_eva_blank(self);
    status = stage8_init(self, &params);
    if (status == PTC_OK) {
        stage8_eva_use(self, limit, level);
        status = stage8_arm(self, stage8_eva_tick());
        //@ assert armed: status == PTC_OK;
        stage8_eva_kept(self);
        stage8_eva_use(self, limit, level);
    } else {
        //@ assert refused: status == PTC_E_PARAM;
        stage8_eva_untouched(self);
#ifdef FINITE
        //@ assert started: \false;
#endif
    }
}

#ifndef FINITE
/* NULL for every pointer that is checked, and no number for every input. */
static void stage8_eva_null(void)
{
    stage8_params params;
    stage8 own;
    stage8 *const self = &own;
    ptc_status status;
    const uint32_t k = stage8_eva_tick();
    double x[2];
    double u;

    params.none = 0;
    stage8_eva_blank(self);
    status = stage8_init(NULL, &params);
    //@ assert no_self: status == PTC_E_PARAM;
    x[0] = stage8_eva_draw(0.0, 0.0);
    x[1] = stage8_eva_draw(0.0, 0.0);
    status = stage8_arm(NULL, k);
    //@ assert missing: status == PTC_E_INPUT;
    status = stage8_step(NULL, k, x, &u);
    //@ assert missing: status == PTC_E_INPUT;
    //@ assert zero: u == 0.0;
    status = stage8_step(self, k, NULL, &u);
    //@ assert missing: status == PTC_E_INPUT;
    //@ assert zero: u == 0.0;
    status = stage8_step(self, k, x, NULL);
    //@ assert missing: status == PTC_E_INPUT;
    stage8_eva_untouched(self);
    x[0] = 0.0;
    x[1] = 0.0;
    x[0] = NAN;
    status = stage8_step(self, k, x, &u);
    //@ assert no_number: status == PTC_E_INPUT;
    x[0] = 0.0;
    x[1] = NAN;
    status = stage8_step(self, k, x, &u);
    //@ assert no_number: status == PTC_E_INPUT;
    x[1] = 0.0;
    stage8_eva_untouched(self);
}
#endif

/* The whole proof of stage8. */
void stage8_eva(void)
{
#ifndef FINITE
    stage8_eva_null();
#endif
    stage8_eva_live(3.0, 2);
}

/* Left out where a program of several proofs has a main of its own. */
#ifndef PTC_EVA_PART
int main(void)
{
    stage8_eva();
    return 0;
}
#endif
