/*
 * Proof that stage16_observer.c has no error at run time, with the plug-in Eva of Frama-C. Here are stage16_observer.h,
 * stage16_observer.c and this file, all three written by ptc-codegen emit --acsl. DO NOT EDIT.
 *
 * Any inputs, with NaN, infinities and NULL:
 *   frama-c -eva -eva-slevel 1000 -eva-slevel-merge-after-loop @all -eva-split-return full -eva-subdivide-non-linear 20 -eva-domains equality -warn-special-float none stage16_observer_eva.c stage16_observer.c
 * Finite inputs, and no value on the way may overflow or be NaN:
 *   frama-c -cpp-extra-args=-DFINITE -eva -eva-slevel 1000 -eva-slevel-merge-after-loop @all -eva-split-return full -eva-subdivide-non-linear 20 -eva-domains equality -warn-special-float non-finite stage16_observer_eva.c stage16_observer.c
 *
 * It is proved where no line begins with [eva:alarm] and the summary has no property unknown. A call is
 * proved from whatever the calls before it may have left. In finite mode values are drawn from the ranges
 * below; give others with -cpp-extra-args="-DFINITE -D<macro>=<number>".
 */
#include "stage16_observer.h"

#include <math.h>
#include <stddef.h>

#include "__fc_builtin.h"

/* Bounds of what is measured, and of the fields that calls change. */
#ifndef STAGE16_OBSERVER_EVA_Y1_MAX
#define STAGE16_OBSERVER_EVA_Y1_MAX 10.0
#endif
#ifndef STAGE16_OBSERVER_EVA_Y2_MAX
#define STAGE16_OBSERVER_EVA_Y2_MAX 10.0
#endif
#ifndef STAGE16_OBSERVER_EVA_APPLIED_MAX
#define STAGE16_OBSERVER_EVA_APPLIED_MAX 10.0
#endif
#ifndef STAGE16_OBSERVER_EVA_U1_MAX
#define STAGE16_OBSERVER_EVA_U1_MAX 10.0
#endif
#ifndef STAGE16_OBSERVER_EVA_X1_HAT_MAX
#define STAGE16_OBSERVER_EVA_X1_HAT_MAX 10.0
#endif
#ifndef STAGE16_OBSERVER_EVA_X1_NEXT_MAX
#define STAGE16_OBSERVER_EVA_X1_NEXT_MAX 10.0
#endif
#ifndef STAGE16_OBSERVER_EVA_X2_HAT_MAX
#define STAGE16_OBSERVER_EVA_X2_HAT_MAX 10.0
#endif
#ifndef STAGE16_OBSERVER_EVA_X2_NEXT_MAX
#define STAGE16_OBSERVER_EVA_X2_NEXT_MAX 10.0
#endif
#ifndef STAGE16_OBSERVER_EVA_X3_HAT_MAX
#define STAGE16_OBSERVER_EVA_X3_HAT_MAX 10.0
#endif
#ifndef STAGE16_OBSERVER_EVA_X3_NEXT_MAX
#define STAGE16_OBSERVER_EVA_X3_NEXT_MAX 10.0
#endif
#ifndef STAGE16_OBSERVER_EVA_D_HAT_MAX
#define STAGE16_OBSERVER_EVA_D_HAT_MAX 10.0
#endif
#ifndef STAGE16_OBSERVER_EVA_D_NEXT_MAX
#define STAGE16_OBSERVER_EVA_D_NEXT_MAX 10.0
#endif

/* Frama-C leaves the sign of a true isfinite open; the code only asks whether it is 0. */
/*@ ensures \result >= 0; */
extern int __finite(double d);
/*@ ensures \result >= 0; */
extern int __finitef(float f);

static volatile double stage16_observer_eva_source;

/* Any number, or in finite mode one of least to greatest. */
static double stage16_observer_eva_draw(double least, double greatest)
{
#ifdef FINITE
    return Frama_C_double_interval(least, greatest);
#else
    (void)least;
    (void)greatest;
    return stage16_observer_eva_source;
#endif
}

static uint32_t stage16_observer_eva_count(uint32_t least, uint32_t greatest)
{
    return (uint32_t)Frama_C_unsigned_int_interval(least, greatest);
}

/* Any tick. */
static uint32_t stage16_observer_eva_tick(void)
{
    return stage16_observer_eva_count(0U, 4294967295U);
}

/* Fields that nothing has set. */
static void stage16_observer_eva_blank(stage16_observer *self)
{
    self->start = 42U;
    self->u1 = 42.0;
    self->seen = 42U;
    self->x1_hat = 42.0;
    self->x1_next = 42.0;
    self->x2_hat = 42.0;
    self->x2_next = 42.0;
    self->x3_hat = 42.0;
    self->x3_next = 42.0;
    self->d_hat = 42.0;
    self->d_next = 42.0;
}

static void stage16_observer_eva_untouched(const stage16_observer *self)
{
    (void)self;
    //@ assert untouched: self->start == 42;
    //@ assert untouched: self->u1 == 42.0;
    //@ assert untouched: self->seen == 42;
    //@ assert untouched: self->x1_hat == 42.0;
    //@ assert untouched: self->x1_next == 42.0;
    //@ assert untouched: self->x2_hat == 42.0;
    //@ assert untouched: self->x2_next == 42.0;
    //@ assert untouched: self->x3_hat == 42.0;
    //@ assert untouched: self->x3_next == 42.0;
    //@ assert untouched: self->d_hat == 42.0;
    //@ assert untouched: self->d_next == 42.0;
}

/* What calls may leave, and more. */
static void stage16_observer_eva_kept(stage16_observer *self)
{
    self->start = stage16_observer_eva_tick();
    self->u1 = stage16_observer_eva_draw(-STAGE16_OBSERVER_EVA_U1_MAX, STAGE16_OBSERVER_EVA_U1_MAX);
    self->seen = stage16_observer_eva_count(0U, 1U);
    self->x1_hat = stage16_observer_eva_draw(-STAGE16_OBSERVER_EVA_X1_HAT_MAX, STAGE16_OBSERVER_EVA_X1_HAT_MAX);
    self->x1_next = stage16_observer_eva_draw(-STAGE16_OBSERVER_EVA_X1_NEXT_MAX, STAGE16_OBSERVER_EVA_X1_NEXT_MAX);
    self->x2_hat = stage16_observer_eva_draw(-STAGE16_OBSERVER_EVA_X2_HAT_MAX, STAGE16_OBSERVER_EVA_X2_HAT_MAX);
    self->x2_next = stage16_observer_eva_draw(-STAGE16_OBSERVER_EVA_X2_NEXT_MAX, STAGE16_OBSERVER_EVA_X2_NEXT_MAX);
    self->x3_hat = stage16_observer_eva_draw(-STAGE16_OBSERVER_EVA_X3_HAT_MAX, STAGE16_OBSERVER_EVA_X3_HAT_MAX);
    self->x3_next = stage16_observer_eva_draw(-STAGE16_OBSERVER_EVA_X3_NEXT_MAX, STAGE16_OBSERVER_EVA_X3_NEXT_MAX);
    self->d_hat = stage16_observer_eva_draw(-STAGE16_OBSERVER_EVA_D_HAT_MAX, STAGE16_OBSERVER_EVA_D_HAT_MAX);
    self->d_next = stage16_observer_eva_draw(-STAGE16_OBSERVER_EVA_D_NEXT_MAX, STAGE16_OBSERVER_EVA_D_NEXT_MAX);
}

/* A call at any tick, and the estimates behind it: a status. */
static void stage16_observer_eva_use(stage16_observer *self, double limit, int level)
{
    const uint32_t k = stage16_observer_eva_tick();
    double y[2];
    ptc_status status;
    const double u = stage16_observer_eva_draw(-STAGE16_OBSERVER_EVA_APPLIED_MAX, STAGE16_OBSERVER_EVA_APPLIED_MAX);
    double xhat[3];
    double d;

    (void)limit;
    (void)level;
    y[0] = stage16_observer_eva_draw(-STAGE16_OBSERVER_EVA_Y1_MAX, STAGE16_OBSERVER_EVA_Y1_MAX);
    y[1] = stage16_observer_eva_draw(-STAGE16_OBSERVER_EVA_Y2_MAX, STAGE16_OBSERVER_EVA_Y2_MAX);
    status = stage16_observer_update(self, k, y, u);
    //@ assert known: -3 <= status <= 3 && status != PTC_E_PARAM;
#ifdef FINITE
    //@ assert accepted: status >= 0;
#endif
    status = stage16_observer_estimate(self, xhat);
    //@ assert given: status == PTC_OK;
    status = stage16_observer_disturbance(self, &d);
    //@ assert given: status == PTC_OK;
    //@ assert initialized: \initialized(xhat + (0 .. 2));
    //@ assert initialized: \initialized(&d);
}

/* init and the first call, then arm and any call. */
static void stage16_observer_eva_live(double limit, int level)
{
    stage16_observer_params params;
    stage16_observer own;
    stage16_observer *const self = &own;
    ptc_status status;

    params.none = 0;
    stage16_observer_eva_blank(self);
    status = stage16_observer_init(self, &params);
    if (status == PTC_OK) {
        stage16_observer_eva_use(self, limit, level);
        status = stage16_observer_arm(self, stage16_observer_eva_tick());
        //@ assert armed: status == PTC_OK;
        stage16_observer_eva_kept(self);
        stage16_observer_eva_use(self, limit, level);
    } else {
        //@ assert refused: status == PTC_E_PARAM;
        stage16_observer_eva_untouched(self);
#ifdef FINITE
        //@ assert started: \false;
#endif
    }
}

#ifndef FINITE
/* NULL for every pointer that is checked, and no number for every input. */
static void stage16_observer_eva_null(void)
{
    stage16_observer_params params;
    stage16_observer own;
    stage16_observer *const self = &own;
    ptc_status status;
    const uint32_t k = stage16_observer_eva_tick();
    double y[2];
    double u = 0.0;
    double xhat[3];
    double d;

    params.none = 0;
    stage16_observer_eva_blank(self);
    status = stage16_observer_init(NULL, &params);
    //@ assert no_self: status == PTC_E_PARAM;
    y[0] = stage16_observer_eva_draw(0.0, 0.0);
    y[1] = stage16_observer_eva_draw(0.0, 0.0);
    status = stage16_observer_arm(NULL, k);
    //@ assert missing: status == PTC_E_INPUT;
    status = stage16_observer_update(NULL, k, y, u);
    //@ assert missing: status == PTC_E_INPUT;
    status = stage16_observer_update(self, k, NULL, u);
    //@ assert missing: status == PTC_E_INPUT;
    status = stage16_observer_estimate(NULL, xhat);
    //@ assert missing: status == PTC_E_INPUT;
    status = stage16_observer_estimate(self, NULL);
    //@ assert missing: status == PTC_E_INPUT;
    status = stage16_observer_disturbance(NULL, &d);
    //@ assert missing: status == PTC_E_INPUT;
    status = stage16_observer_disturbance(self, NULL);
    //@ assert missing: status == PTC_E_INPUT;
    stage16_observer_eva_untouched(self);
    y[0] = 0.0;
    y[1] = 0.0;
    y[0] = NAN;
    status = stage16_observer_update(self, k, y, u);
    //@ assert no_number: status == PTC_E_INPUT;
    y[0] = 0.0;
    y[1] = NAN;
    status = stage16_observer_update(self, k, y, u);
    //@ assert no_number: status == PTC_E_INPUT;
    y[1] = 0.0;
    u = INFINITY;
    status = stage16_observer_update(self, k, y, u);
    //@ assert no_number: status == PTC_E_INPUT;
    stage16_observer_eva_untouched(self);
}
#endif

/* The whole proof of stage16_observer. */
void stage16_observer_eva(void)
{
#ifndef FINITE
    stage16_observer_eva_null();
#endif
    stage16_observer_eva_live(0.0, 1);
}

/* Left out where a program of several proofs has a main of its own. */
#ifndef PTC_EVA_PART
int main(void)
{
    stage16_observer_eva();
    return 0;
}
#endif
