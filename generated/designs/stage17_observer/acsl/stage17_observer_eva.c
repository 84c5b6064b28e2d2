/*
 * Proof that stage17_observer.c has no error at run time, with the plug-in Eva of Frama-C. Here are stage17_observer.h,
 * stage17_observer.c and this file, all three written by ptc-codegen emit --acsl. DO NOT EDIT.
 *
 * Any inputs, with NaN, infinities and NULL:
 *   frama-c -eva -eva-slevel 1000 -eva-slevel-merge-after-loop @all -eva-split-return full -eva-subdivide-non-linear 20 -eva-domains equality -warn-special-float none stage17_observer_eva.c stage17_observer.c
 * Finite inputs, and no value on the way may overflow or be NaN:
 *   frama-c -cpp-extra-args=-DFINITE -eva -eva-slevel 1000 -eva-slevel-merge-after-loop @all -eva-split-return full -eva-subdivide-non-linear 20 -eva-domains equality -warn-special-float non-finite stage17_observer_eva.c stage17_observer.c
 *
 * It is proved where no line begins with [eva:alarm] and the summary has no property unknown. A call is
 * proved from whatever the calls before it may have left. In finite mode values are drawn from the ranges
 * below; give others with -cpp-extra-args="-DFINITE -D<macro>=<number>".
 */
#include "stage17_observer.h"

#include <math.h>
#include <stddef.h>

#include "__fc_builtin.h"

#ifndef STAGE17_OBSERVER_EVA_H_MIN
#define STAGE17_OBSERVER_EVA_H_MIN 0.01
#endif
#ifndef STAGE17_OBSERVER_EVA_H_MAX
#define STAGE17_OBSERVER_EVA_H_MAX 0.01
#endif
/* Bounds of what is measured, and of the fields that calls change. */
#ifndef STAGE17_OBSERVER_EVA_Y1_MAX
#define STAGE17_OBSERVER_EVA_Y1_MAX 10.0
#endif
#ifndef STAGE17_OBSERVER_EVA_Y2_MAX
#define STAGE17_OBSERVER_EVA_Y2_MAX 10.0
#endif
#ifndef STAGE17_OBSERVER_EVA_APPLIED_MAX
#define STAGE17_OBSERVER_EVA_APPLIED_MAX 10.0
#endif
#ifndef STAGE17_OBSERVER_EVA_X2_HAT_MAX
#define STAGE17_OBSERVER_EVA_X2_HAT_MAX 10.0
#endif
#ifndef STAGE17_OBSERVER_EVA_D_HAT_MAX
#define STAGE17_OBSERVER_EVA_D_HAT_MAX 10.0
#endif

/* Frama-C leaves the sign of a true isfinite open; the code only asks whether it is 0. */
/*@ ensures \result >= 0; */
extern int __finite(double d);
/*@ ensures \result >= 0; */
extern int __finitef(float f);

static volatile double stage17_observer_eva_source;

/* Any number, or in finite mode one of least to greatest. */
static double stage17_observer_eva_draw(double least, double greatest)
{
#ifdef FINITE
    return Frama_C_double_interval(least, greatest);
#else
    (void)least;
    (void)greatest;
    return stage17_observer_eva_source;
#endif
}

static uint32_t stage17_observer_eva_count(uint32_t least, uint32_t greatest)
{
    return (uint32_t)Frama_C_unsigned_int_interval(least, greatest);
}

/* Any tick. */
static uint32_t stage17_observer_eva_tick(void)
{
    return stage17_observer_eva_count(0U, 4294967295U);
}

/* Fields that nothing has set. */
static void stage17_observer_eva_blank(stage17_observer *self)
{
    self->start = 42U;
    self->seen = 42U;
    self->x2_hat = 42.0;
    self->d_hat = 42.0;
    self->phi1_2 = 42.0;
    self->q2_1 = 42.0;
    self->e1_2 = 42.0;
    self->e0_2 = 42.0;
}

static void stage17_observer_eva_untouched(const stage17_observer *self)
{
    (void)self;
    //@ assert untouched: self->start == 42;
    //@ assert untouched: self->seen == 42;
    //@ assert untouched: self->x2_hat == 42.0;
    //@ assert untouched: self->d_hat == 42.0;
    //@ assert untouched: self->phi1_2 == 42.0;
    //@ assert untouched: self->q2_1 == 42.0;
    //@ assert untouched: self->e1_2 == 42.0;
    //@ assert untouched: self->e0_2 == 42.0;
}

/* What calls may leave, and more. */
static void stage17_observer_eva_kept(stage17_observer *self)
{
    self->start = stage17_observer_eva_tick();
    self->seen = stage17_observer_eva_count(0U, 1U);
    self->x2_hat = stage17_observer_eva_draw(-STAGE17_OBSERVER_EVA_X2_HAT_MAX, STAGE17_OBSERVER_EVA_X2_HAT_MAX);
    self->d_hat = stage17_observer_eva_draw(-STAGE17_OBSERVER_EVA_D_HAT_MAX, STAGE17_OBSERVER_EVA_D_HAT_MAX);
}

/* A call at any tick, and the estimates behind it: a status. */
static void stage17_observer_eva_use(stage17_observer *self, double limit, int level)
{
    const uint32_t k = stage17_observer_eva_tick();
    double y[2];
    ptc_status status;
    const double u = stage17_observer_eva_draw(-STAGE17_OBSERVER_EVA_APPLIED_MAX, STAGE17_OBSERVER_EVA_APPLIED_MAX);
    double xhat[1];
    double d;

    (void)limit;
    (void)level;
    y[0] = stage17_observer_eva_draw(-STAGE17_OBSERVER_EVA_Y1_MAX, STAGE17_OBSERVER_EVA_Y1_MAX);
    y[1] = stage17_observer_eva_draw(-STAGE17_OBSERVER_EVA_Y2_MAX, STAGE17_OBSERVER_EVA_Y2_MAX);
    /* What the guard trusts. */
    const double y1 = y[0];
    if (isfinite(y1) == 0) {
        return;
    }
    y[0] = y1;
    const double y2 = y[1];
    if (isfinite(y2) == 0) {
        return;
    }
    y[1] = y2;
    if (isfinite(u) == 0) {
        return;
    }
    status = stage17_observer_update(self, k, y, u);
    //@ assert known: -3 <= status <= 3 && status != PTC_E_PARAM;
#ifdef FINITE
    //@ assert accepted: status >= 0;
#endif
    status = stage17_observer_estimate(self, xhat);
    //@ assert given: status == PTC_OK;
    status = stage17_observer_disturbance(self, &d);
    //@ assert given: status == PTC_OK;
    //@ assert initialized: \initialized(xhat + (0 .. 0));
    //@ assert initialized: \initialized(&d);
}

/* init and the first call, then arm and any call. */
static void stage17_observer_eva_live(double limit, int level)
{
    stage17_observer_params params;
    stage17_observer own;
    stage17_observer *const self = &own;
    ptc_status status;

    params.h = stage17_observer_eva_draw(STAGE17_OBSERVER_EVA_H_MIN, STAGE17_OBSERVER_EVA_H_MAX);
    stage17_observer_eva_blank(self);
    status = stage17_observer_init(self, &params);
    if (status == PTC_OK) {
        stage17_observer_eva_use(self, limit, level);
        status = stage17_observer_arm(self, stage17_observer_eva_tick());
        //@ assert armed: status == PTC_OK;
        stage17_observer_eva_kept(self);
        stage17_observer_eva_use(self, limit, level);
    } else {
        //@ assert refused: status == PTC_E_PARAM;
        stage17_observer_eva_untouched(self);
#ifdef FINITE
        //@ assert started: \false;
#endif
    }
}

#ifndef FINITE
/* NULL for every pointer that is checked, and no number for every input. */
static void stage17_observer_eva_null(void)
{
    stage17_observer_params params;
    stage17_observer own;
    stage17_observer *const self = &own;
    ptc_status status;

    params.h = stage17_observer_eva_draw(0.0, 0.0);
    stage17_observer_eva_blank(self);
    status = stage17_observer_init(NULL, &params);
    //@ assert no_self: status == PTC_E_PARAM;
    status = stage17_observer_init(self, NULL);
    //@ assert no_params: status == PTC_E_PARAM;
    stage17_observer_eva_untouched(self);
}
#endif

/* The whole proof of stage17_observer. */
void stage17_observer_eva(void)
{
#ifndef FINITE
    stage17_observer_eva_null();
#endif
    stage17_observer_eva_live(0.0, 1);
}

/* Left out where a program of several proofs has a main of its own. */
#ifndef PTC_EVA_PART
int main(void)
{
    stage17_observer_eva();
    return 0;
}
#endif
