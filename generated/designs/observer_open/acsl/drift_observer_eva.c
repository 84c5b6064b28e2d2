/*
 * Proof that drift_observer.c has no error at run time, with the plug-in Eva of Frama-C. Here are drift_observer.h,
 * drift_observer.c and this file, all three written by ptc-codegen emit --acsl. DO NOT EDIT.
 *
 * Any inputs, with NaN, infinities and NULL:
 *   frama-c -eva -eva-slevel 1000 -eva-slevel-merge-after-loop @all -eva-split-return full -eva-subdivide-non-linear 20 -eva-domains equality -warn-special-float none drift_observer_eva.c drift_observer.c
 * Finite inputs, and no value on the way may overflow or be NaN:
 *   frama-c -cpp-extra-args=-DFINITE -eva -eva-slevel 1000 -eva-slevel-merge-after-loop @all -eva-split-return full -eva-subdivide-non-linear 20 -eva-domains equality -warn-special-float non-finite drift_observer_eva.c drift_observer.c
 *
 * It is proved where no line begins with [eva:alarm] and the summary has no property unknown. A call is
 * proved from whatever the calls before it may have left. In finite mode values are drawn from the ranges
 * below; give others with -cpp-extra-args="-DFINITE -D<macro>=<number>".
 */
#include "drift_observer.h"

#include <math.h>
#include <stddef.h>

#include "__fc_builtin.h"

#ifndef DRIFT_OBSERVER_EVA_H_MIN
#define DRIFT_OBSERVER_EVA_H_MIN 0.01
#endif
#ifndef DRIFT_OBSERVER_EVA_H_MAX
#define DRIFT_OBSERVER_EVA_H_MAX 0.01
#endif
/* Bounds of what is measured, and of the fields that calls change. */
#ifndef DRIFT_OBSERVER_EVA_Y1_MAX
#define DRIFT_OBSERVER_EVA_Y1_MAX 10.0
#endif
#ifndef DRIFT_OBSERVER_EVA_Y2_MAX
#define DRIFT_OBSERVER_EVA_Y2_MAX 10.0
#endif
#ifndef DRIFT_OBSERVER_EVA_APPLIED_MAX
#define DRIFT_OBSERVER_EVA_APPLIED_MAX 10.0
#endif
#ifndef DRIFT_OBSERVER_EVA_X2_HAT_MAX
#define DRIFT_OBSERVER_EVA_X2_HAT_MAX 10.0
#endif
#ifndef DRIFT_OBSERVER_EVA_X3_HAT_MAX
#define DRIFT_OBSERVER_EVA_X3_HAT_MAX 10.0
#endif
#ifndef DRIFT_OBSERVER_EVA_D_HAT_MAX
#define DRIFT_OBSERVER_EVA_D_HAT_MAX 10.0
#endif
#ifndef DRIFT_OBSERVER_EVA_D_RATE_HAT_MAX
#define DRIFT_OBSERVER_EVA_D_RATE_HAT_MAX 10.0
#endif

/* Frama-C leaves the sign of a true isfinite open; the code only asks whether it is 0. */
/*@ ensures \result >= 0; */
extern int __finite(double d);
/*@ ensures \result >= 0; */
extern int __finitef(float f);

static volatile double drift_observer_eva_source;

/* Any number, or in finite mode one of least to greatest. */
static double drift_observer_eva_draw(double least, double greatest)
{
#ifdef FINITE
    return Frama_C_double_interval(least, greatest);
#else
    (void)least;
    (void)greatest;
    return drift_observer_eva_source;
#endif
}

static uint32_t drift_observer_eva_count(uint32_t least, uint32_t greatest)
{
    return (uint32_t)Frama_C_unsigned_int_interval(least, greatest);
}

/* Any tick. */
static uint32_t drift_observer_eva_tick(void)
{
    return drift_observer_eva_count(0U, 4294967295U);
}

/* Fields that nothing has set. */
static void drift_observer_eva_blank(drift_observer *self)
{
    self->start = 42U;
    self->seen = 42U;
    self->x2_hat = 42.0;
    self->x3_hat = 42.0;
    self->d_hat = 42.0;
    self->d_rate_hat = 42.0;
    self->phi1_2 = 42.0;
    self->phi1_3 = 42.0;
    self->phi1_4 = 42.0;
    self->q2_1 = 42.0;
    self->q2_2 = 42.0;
    self->q2_3 = 42.0;
    self->q3_1 = 42.0;
    self->q3_2 = 42.0;
    self->q4_1 = 42.0;
    self->e3_2 = 42.0;
    self->e3_3 = 42.0;
    self->e3_4 = 42.0;
    self->e2_2 = 42.0;
    self->e2_4 = 42.0;
    self->e1_2 = 42.0;
    self->e1_3 = 42.0;
    self->e1_4 = 42.0;
    self->e0_2 = 42.0;
    self->e0_3 = 42.0;
    self->e0_4 = 42.0;
}

static void drift_observer_eva_untouched(const drift_observer *self)
{
    (void)self;
    //@ assert untouched: self->start == 42;
    //@ assert untouched: self->seen == 42;
    //@ assert untouched: self->x2_hat == 42.0;
    //@ assert untouched: self->x3_hat == 42.0;
    //@ assert untouched: self->d_hat == 42.0;
    //@ assert untouched: self->d_rate_hat == 42.0;
    //@ assert untouched: self->phi1_2 == 42.0;
    //@ assert untouched: self->phi1_3 == 42.0;
    //@ assert untouched: self->phi1_4 == 42.0;
    //@ assert untouched: self->q2_1 == 42.0;
    //@ assert untouched: self->q2_2 == 42.0;
    //@ assert untouched: self->q2_3 == 42.0;
    //@ assert untouched: self->q3_1 == 42.0;
    //@ assert untouched: self->q3_2 == 42.0;
    //@ assert untouched: self->q4_1 == 42.0;
    //@ assert untouched: self->e3_2 == 42.0;
    //@ assert untouched: self->e3_3 == 42.0;
    //@ assert untouched: self->e3_4 == 42.0;
    //@ assert untouched: self->e2_2 == 42.0;
    //@ assert untouched: self->e2_4 == 42.0;
    //@ assert untouched: self->e1_2 == 42.0;
    //@ assert untouched: self->e1_3 == 42.0;
    //@ assert untouched: self->e1_4 == 42.0;
    //@ assert untouched: self->e0_2 == 42.0;
    //@ assert untouched: self->e0_3 == 42.0;
    //@ assert untouched: self->e0_4 == 42.0;
}

/* What calls may leave, and more. */
static void drift_observer_eva_kept(drift_observer *self)
{
    self->start = drift_observer_eva_tick();
    self->seen = drift_observer_eva_count(0U, 1U);
    self->x2_hat = drift_observer_eva_draw(-DRIFT_OBSERVER_EVA_X2_HAT_MAX, DRIFT_OBSERVER_EVA_X2_HAT_MAX);
    self->x3_hat = drift_observer_eva_draw(-DRIFT_OBSERVER_EVA_X3_HAT_MAX, DRIFT_OBSERVER_EVA_X3_HAT_MAX);
    self->d_hat = drift_observer_eva_draw(-DRIFT_OBSERVER_EVA_D_HAT_MAX, DRIFT_OBSERVER_EVA_D_HAT_MAX);
    self->d_rate_hat = drift_observer_eva_draw(-DRIFT_OBSERVER_EVA_D_RATE_HAT_MAX, DRIFT_OBSERVER_EVA_D_RATE_HAT_MAX);
}

/* A call at any tick, and the estimates behind it: a status. */
static void drift_observer_eva_use(drift_observer *self, double limit, int level)
{
    const uint32_t k = drift_observer_eva_tick();
    double y[2];
    ptc_status status;
    const double u = drift_observer_eva_draw(-DRIFT_OBSERVER_EVA_APPLIED_MAX, DRIFT_OBSERVER_EVA_APPLIED_MAX);
    double xhat[2];
    double d;

    (void)limit;
    (void)level;
    y[0] = drift_observer_eva_draw(-DRIFT_OBSERVER_EVA_Y1_MAX, DRIFT_OBSERVER_EVA_Y1_MAX);
    y[1] = drift_observer_eva_draw(-DRIFT_OBSERVER_EVA_Y2_MAX, DRIFT_OBSERVER_EVA_Y2_MAX);
    status = drift_observer_update(self, k, y, u);
    //@ assert known: -3 <= status <= 3 && status != PTC_E_PARAM;
#ifdef FINITE
    //@ assert accepted: status >= 0;
#endif
    status = drift_observer_estimate(self, xhat);
    //@ assert given: status == PTC_OK;
    status = drift_observer_disturbance(self, &d);
    //@ assert given: status == PTC_OK;
    //@ assert initialized: \initialized(xhat + (0 .. 1));
    //@ assert initialized: \initialized(&d);
}

/* init and the first call, then arm and any call. */
static void drift_observer_eva_live(double limit, int level)
{
    drift_observer_params params;
    drift_observer own;
    drift_observer *const self = &own;
    ptc_status status;

    params.h = drift_observer_eva_draw(DRIFT_OBSERVER_EVA_H_MIN, DRIFT_OBSERVER_EVA_H_MAX);
    drift_observer_eva_blank(self);
    status = drift_observer_init(self, &params);
    if (status == PTC_OK) {
        drift_observer_eva_use(self, limit, level);
        status = drift_observer_arm(self, drift_observer_eva_tick());
        //@ assert armed: status == PTC_OK;
        drift_observer_eva_kept(self);
        drift_observer_eva_use(self, limit, level);
    } else {
        //@ assert refused: status == PTC_E_PARAM;
        drift_observer_eva_untouched(self);
#ifdef FINITE
        //@ assert started: \false;
#endif
    }
}

#ifndef FINITE
/* NULL for every pointer that is checked, and no number for every input. */
static void drift_observer_eva_null(void)
{
    drift_observer_params params;
    drift_observer own;
    drift_observer *const self = &own;
    ptc_status status;
    const uint32_t k = drift_observer_eva_tick();
    double y[2];
    double u = 0.0;
    double xhat[2];
    double d;

    params.h = drift_observer_eva_draw(0.0, 0.0);
    drift_observer_eva_blank(self);
    status = drift_observer_init(NULL, &params);
    //@ assert no_self: status == PTC_E_PARAM;
    status = drift_observer_init(self, NULL);
    //@ assert no_params: status == PTC_E_PARAM;
    drift_observer_eva_untouched(self);
    y[0] = drift_observer_eva_draw(0.0, 0.0);
    y[1] = drift_observer_eva_draw(0.0, 0.0);
    status = drift_observer_arm(NULL, k);
    //@ assert missing: status == PTC_E_INPUT;
    status = drift_observer_update(NULL, k, y, u);
    //@ assert missing: status == PTC_E_INPUT;
    status = drift_observer_update(self, k, NULL, u);
    //@ assert missing: status == PTC_E_INPUT;
    status = drift_observer_estimate(NULL, xhat);
    //@ assert missing: status == PTC_E_INPUT;
    status = drift_observer_estimate(self, NULL);
    //@ assert missing: status == PTC_E_INPUT;
    status = drift_observer_disturbance(NULL, &d);
    //@ assert missing: status == PTC_E_INPUT;
    status = drift_observer_disturbance(self, NULL);
    //@ assert missing: status == PTC_E_INPUT;
    drift_observer_eva_untouched(self);
    y[0] = 0.0;
    y[1] = 0.0;
    y[0] = NAN;
    status = drift_observer_update(self, k, y, u);
    //@ assert no_number: status == PTC_E_INPUT;
    y[0] = 0.0;
    y[1] = NAN;
    status = drift_observer_update(self, k, y, u);
    //@ assert no_number: status == PTC_E_INPUT;
    y[1] = 0.0;
    u = INFINITY;
    status = drift_observer_update(self, k, y, u);
    //@ assert no_number: status == PTC_E_INPUT;
    drift_observer_eva_untouched(self);
}
#endif

/* The whole proof of drift_observer. */
void drift_observer_eva(void)
{
#ifndef FINITE
    drift_observer_eva_null();
#endif
    drift_observer_eva_live(0.0, 1);
}

/* Left out where a program of several proofs has a main of its own. */
#ifndef PTC_EVA_PART
int main(void)
{
    drift_observer_eva();
    return 0;
}
#endif
