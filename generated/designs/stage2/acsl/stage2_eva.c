/*
 * Proof that stage2.c has no error at run time, with the plug-in Eva of Frama-C. Here are stage2.h,
 * stage2.c and this file, all three written by ptc-codegen emit --acsl. DO NOT EDIT.
 *
 * Any inputs, with NaN, infinities and NULL:
 *   frama-c -eva -eva-slevel 1000 -eva-slevel-merge-after-loop @all -eva-split-return full -eva-subdivide-non-linear 20 -eva-domains equality -warn-special-float none stage2_eva.c stage2.c
 * Finite inputs, and no value on the way may overflow or be NaN:
 *   frama-c -cpp-extra-args=-DFINITE -eva -eva-slevel 1000 -eva-slevel-merge-after-loop @all -eva-split-return full -eva-subdivide-non-linear 20 -eva-domains equality -warn-special-float non-finite stage2_eva.c stage2.c
 *
 * It is proved where no line begins with [eva:alarm] and the summary has no property unknown. A call is
 * proved from whatever the calls before it may have left. In finite mode values are drawn from the ranges
 * below; give others with -cpp-extra-args="-DFINITE -D<macro>=<number>".
 */
#include "stage2.h"

#include <math.h>
#include <stddef.h>

#include "__fc_builtin.h"

/* Bounds of what is measured, and of the fields that calls change. */
#ifndef STAGE2_EVA_Y1_MAX
#define STAGE2_EVA_Y1_MAX 10.0
#endif
#ifndef STAGE2_EVA_Y2_MAX
#define STAGE2_EVA_Y2_MAX 10.0
#endif
#ifndef STAGE2_EVA_Y3_MAX
#define STAGE2_EVA_Y3_MAX 10.0
#endif

/* Frama-C leaves the sign of a true isfinite open; the code only asks whether it is 0. */
/*@ ensures \result >= 0; */
extern int __finite(double d);
/*@ ensures \result >= 0; */
extern int __finitef(float f);

static volatile double stage2_eva_source;

/* Any number, or in finite mode one of least to greatest. */
static double stage2_eva_draw(double least, double greatest)
{
#ifdef FINITE
    return Frama_C_double_interval(least, greatest);
#else
    (void)least;
    (void)greatest;
    return stage2_eva_source;
#endif
}

static uint32_t stage2_eva_count(uint32_t least, uint32_t greatest)
{
    return (uint32_t)Frama_C_unsigned_int_interval(least, greatest);
}

/* Any tick. */
static uint32_t stage2_eva_tick(void)
{
    return stage2_eva_count(0U, 4294967295U);
}

/* Fields that nothing has set. */
static void stage2_eva_blank(stage2 *self)
{
    self->start = 42U;
}

static void stage2_eva_untouched(const stage2 *self)
{
    (void)self;
    //@ assert untouched: self->start == 42;
}

/* What calls may leave, and more. */
static void stage2_eva_kept(stage2 *self)
{
    self->start = stage2_eva_tick();
}

/* A call at any tick, and the estimates behind it: a status, with u = 0 where it is negative; at level 1 that
 * u is finite, at 2 its bound. */
static void stage2_eva_use(stage2 *self, double limit, int level)
{
    const uint32_t k = stage2_eva_tick();
    double x[3];
    ptc_status status;
    double u;

    (void)limit;
    (void)level;
    x[0] = stage2_eva_draw(-STAGE2_EVA_Y1_MAX, STAGE2_EVA_Y1_MAX);
    x[1] = stage2_eva_draw(-STAGE2_EVA_Y2_MAX, STAGE2_EVA_Y2_MAX);
    x[2] = stage2_eva_draw(-STAGE2_EVA_Y3_MAX, STAGE2_EVA_Y3_MAX);
    /* What the guard trusts. */
    const double y1 = x[0];
    if (isfinite(y1) == 0) {
        return;
    }
    x[0] = y1;
    const double y2 = x[1];
    if (isfinite(y2) == 0) {
        return;
    }
    x[1] = y2;
    const double y3 = x[2];
    if (isfinite(y3) == 0) {
        return;
    }
    x[2] = y3;
    status = stage2_step(self, k, x, &u);
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
static void stage2_eva_live(double limit, int level)
{
    stage2_params params;
    stage2 own;
    stage2 *const self = &own;
    ptc_status status;

    params.none = 0;
    stage2_eva_blank(self);
    status = stage2_init(self, &params);
    if (status == PTC_OK) {
        stage2_eva_use(self, limit, level);
        status = stage2_arm(self, stage2_eva_tick());
        //@ assert armed: status == PTC_OK;
        stage2_eva_kept(self);
        stage2_eva_use(self, limit, level);
    } else {
        //@ assert refused: status == PTC_E_PARAM;
        stage2_eva_untouched(self);
#ifdef FINITE
        //@ assert started: \false;
#endif
    }
}

#ifndef FINITE
/* NULL for every pointer that is checked, and no number for every input. */
static void stage2_eva_null(void)
{
    stage2_params params;
    stage2 own;
    stage2 *const self = &own;
    ptc_status status;

    params.none = 0;
    stage2_eva_blank(self);
    status = stage2_init(NULL, &params);
    //@ assert no_self: status == PTC_E_PARAM;
}
#endif

/* The whole proof of stage2. */
void stage2_eva(void)
{
#ifndef FINITE
    stage2_eva_null();
#endif
    stage2_eva_live(0.0, 1);
}

/* Left out where a program of several proofs has a main of its own. */
#ifndef PTC_EVA_PART
int main(void)
{
    stage2_eva();
    return 0;
}
#endif
