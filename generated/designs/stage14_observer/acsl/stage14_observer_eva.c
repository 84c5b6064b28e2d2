/*
 * Proof that stage14_observer.c has no error at run time, with the plug-in Eva of Frama-C. Here are stage14_observer.h,
 * stage14_observer.c and this file, all three written by ptc-codegen emit --acsl. DO NOT EDIT.
 *
 * Any inputs, with NaN, infinities and NULL:
 *   frama-c -eva -eva-slevel 1000 -eva-slevel-merge-after-loop @all -eva-split-return full -eva-subdivide-non-linear 20 -eva-domains equality -warn-special-float none stage14_observer_eva.c stage14_observer.c
 * Finite inputs, and no value on the way may overflow or be NaN:
 *   frama-c -cpp-extra-args=-DFINITE -eva -eva-slevel 1000 -eva-slevel-merge-after-loop @all -eva-split-return full -eva-subdivide-non-linear 20 -eva-domains equality -warn-special-float non-finite stage14_observer_eva.c stage14_observer.c
 *
 * It is proved where no line begins with [eva:alarm] and the summary has no property unknown. A call is
 * proved from whatever the calls before it may have left. In finite mode values are drawn from the ranges
 * below; give others with -cpp-extra-args="-DFINITE -D<macro>=<number>".
 */
#include "stage14_observer.h"

#include <math.h>
#include <stddef.h>

#include "__fc_builtin.h"

#ifndef STAGE14_OBSERVER_EVA_H_MIN
#define STAGE14_OBSERVER_EVA_H_MIN 0.01
#endif
#ifndef STAGE14_OBSERVER_EVA_H_MAX
#define STAGE14_OBSERVER_EVA_H_MAX 0.01
#endif
/* Bounds of what is measured, and of the fields that calls change. */
#ifndef STAGE14_OBSERVER_EVA_Y1_MAX
#define STAGE14_OBSERVER_EVA_Y1_MAX 10.0
#endif
#ifndef STAGE14_OBSERVER_EVA_APPLIED_MAX
#define STAGE14_OBSERVER_EVA_APPLIED_MAX 10.0
#endif
#ifndef STAGE14_OBSERVER_EVA_X1_HAT_MAX
#define STAGE14_OBSERVER_EVA_X1_HAT_MAX 10.0
#endif
#ifndef STAGE14_OBSERVER_EVA_X2_HAT_MAX
#define STAGE14_OBSERVER_EVA_X2_HAT_MAX 10.0
#endif
#ifndef STAGE14_OBSERVER_EVA_X3_HAT_MAX
#define STAGE14_OBSERVER_EVA_X3_HAT_MAX 10.0
#endif

/* Frama-C leaves the sign of a true isfinite open; the code only asks whether it is 0. */
/*@ ensures \result >= 0; */
extern int __finite(double d);
/*@ ensures \result >= 0; */
extern int __finitef(float f);

static volatile double stage14_observer_eva_source;

/* Any number, or in finite mode one of least to greatest. */
static double stage14_observer_eva_draw(double least, double greatest)
{
#ifdef FINITE
    return Frama_C_double_interval(least, greatest);
#else
    (void)least;
    (void)greatest;
    return stage14_observer_eva_source;
#endif
}

static uint32_t stage14_observer_eva_count(uint32_t least, uint32_t greatest)
{
    return (uint32_t)Frama_C_unsigned_int_interval(least, greatest);
}

/* Any tick. */
static uint32_t stage14_observer_eva_tick(void)
{
    return stage14_observer_eva_count(0U, 4294967295U);
}

/* Fields that nothing has set. */
static void stage14_observer_eva_blank(stage14_observer *self)
{
    self->start = 42U;
    self->seen = 42U;
    self->x1_hat = 42.0;
    self->x2_hat = 42.0;
    self->x3_hat = 42.0;
    self->phi1_2 = 42.0;
    self->phi1_3 = 42.0;
    self->gamma1 = 42.0;
    self->q2_1 = 42.0;
    self->q2_2 = 42.0;
    self->q3_1 = 42.0;
    self->e2_2 = 42.0;
    self->e2_3 = 42.0;
    self->e1_2 = 42.0;
    self->e1_3 = 42.0;
    self->e0_2 = 42.0;
    self->e0_3 = 42.0;
}

static void stage14_observer_eva_untouched(const stage14_observer *self)
{
    (void)self;
    //@ assert untouched: self->start == 42;
    //@ assert untouched: self->seen == 42;
    //@ assert untouched: self->x1_hat == 42.0;
    //@ assert untouched: self->x2_hat == 42.0;
    //@ assert untouched: self->x3_hat == 42.0;
    //@ assert untouched: self->phi1_2 == 42.0;
    //@ assert untouched: self->phi1_3 == 42.0;
    //@ assert untouched: self->gamma1 == 42.0;
    //@ assert untouched: self->q2_1 == 42.0;
    //@ assert untouched: self->q2_2 == 42.0;
    //@ assert untouched: self->q3_1 == 42.0;
    //@ assert untouched: self->e2_2 == 42.0;
    //@ assert untouched: self->e2_3 == 42.0;
    //@ assert untouched: self->e1_2 == 42.0;
    //@ assert untouched: self->e1_3 == 42.0;
    //@ assert untouched: self->e0_2 == 42.0;
    //@ assert untouched: self->e0_3 == 42.0;
}

/* What calls may leave, and more. */
static void stage14_observer_eva_kept(stage14_observer *self)
{
    self->start = stage14_observer_eva_tick();
    self->seen = stage14_observer_eva_count(0U, 1U);
    self->x1_hat = stage14_observer_eva_draw(-STAGE14_OBSERVER_EVA_X1_HAT_MAX, STAGE14_OBSERVER_EVA_X1_HAT_MAX);
    self->x2_hat = stage14_observer_eva_draw(-STAGE14_OBSERVER_EVA_X2_HAT_MAX, STAGE14_OBSERVER_EVA_X2_HAT_MAX);
    self->x3_hat = stage14_observer_eva_draw(-STAGE14_OBSERVER_EVA_X3_HAT_MAX, STAGE14_OBSERVER_EVA_X3_HAT_MAX);
}

/* A call at any tick, and the estimates behind it: a status. */
static void stage14_observer_eva_use(stage14_observer *self, double limit, int level)
{
    const uint32_t k = stage14_observer_eva_tick();
    double y[1];
    ptc_status status;
    const double u = stage14_observer_eva_draw(-STAGE14_OBSERVER_EVA_APPLIED_MAX, STAGE14_OBSERVER_EVA_APPLIED_MAX);
    double xhat[3];

    (void)limit;
    (void)level;
    y[0] = stage14_observer_eva_draw(-STAGE14_OBSERVER_EVA_Y1_MAX, STAGE14_OBSERVER_EVA_Y1_MAX);
    status = stage14_observer_update(self, k, y, u);
    //@ assert known: -3 <= status <= 3 && status != PTC_E_PARAM;
#ifdef FINITE
    //@ assert accepted: status >= 0;
#endif
    status = stage14_observer_estimate(self, xhat);
    //@ assert given: status == PTC_OK;
    //@ assert initialized: \initialized(xhat + (0 .. 2));
}

/* init and the first call, then arm and any call. */
static void stage14_observer_eva_live(double limit, int level)
{
    stage14_observer_params params;
    stage14_observer own;
    stage14_observer *const self = &own;
    ptc_status status;

    params.h = stage14_observer_eva_draw(STAGE14_OBSERVER_EVA_H_MIN, STAGE14_OBSERVER_EVA_H_MAX);
    stage14_observer_eva_blank(self);
    status = stage14_observer_init(self, &params);
    if (status == PTC_OK) {
        stage14_observer_eva_use(self, limit, level);
        status = stage14_observer_arm(self, stage14_observer_eva_tick());
        //@ assert armed: status == PTC_OK;
        stage14_observer_eva_kept(self);
        stage14_observer_eva_use(self, limit, level);
    } else {
        //@ assert refused: status == PTC_E_PARAM;
        stage14_observer_eva_untouched(self);
#ifdef FINITE
        //@ assert started: \false;
#endif
    }
}

#ifndef FINITE
/* NULL for every pointer that is checked, and no number for every input. */
static void stage14_observer_eva_null(void)
{
    stage14_observer_params params;
    stage14_observer own;
    stage14_observer *const self = &own;
    ptc_status status;
    const uint32_t k = stage14_observer_eva_tick();
    double y[1];
    double u = 0.0;
    double xhat[3];

    params.h = stage14_observer_eva_draw(0.0, 0.0);
    stage14_observer_eva_blank(self);
    status = stage14_observer_init(NULL, &params);
    //@ assert no_self: status == PTC_E_PARAM;
    status = stage14_observer_init(self, NULL);
    //@ assert no_params: status == PTC_E_PARAM;
    stage14_observer_eva_untouched(self);
    y[0] = stage14_observer_eva_draw(0.0, 0.0);
    status = stage14_observer_arm(NULL, k);
    //@ assert missing: status == PTC_E_INPUT;
    status = stage14_observer_update(NULL, k, y, u);
    //@ assert missing: status == PTC_E_INPUT;
    status = stage14_observer_update(self, k, NULL, u);
    //@ assert missing: status == PTC_E_INPUT;
    status = stage14_observer_estimate(NULL, xhat);
    //@ assert missing: status == PTC_E_INPUT;
    status = stage14_observer_estimate(self, NULL);
    //@ assert missing: status == PTC_E_INPUT;
    stage14_observer_eva_untouched(self);
    y[0] = 0.0;
    y[0] = NAN;
    status = stage14_observer_update(self, k, y, u);
    //@ assert no_number: status == PTC_E_INPUT;
    y[0] = 0.0;
    u = INFINITY;
    status = stage14_observer_update(self, k, y, u);
    //@ assert no_number: status == PTC_E_INPUT;
    stage14_observer_eva_untouched(self);
}
#endif

/* The whole proof of stage14_observer. */
void stage14_observer_eva(void)
{
#ifndef FINITE
    stage14_observer_eva_null();
#endif
    stage14_observer_eva_live(0.0, 1);
}

/* Left out where a program of several proofs has a main of its own. */
#ifndef PTC_EVA_PART
int main(void)
{
    stage14_observer_eva();
    return 0;
}
#endif
