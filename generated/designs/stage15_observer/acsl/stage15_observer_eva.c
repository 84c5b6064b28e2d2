/*
 * Proof that stage15_observer.c has no error at run time, with the plug-in Eva of Frama-C. Here are stage15_observer.h,
 * stage15_observer.c and this file, all three written by ptc-codegen emit --acsl. DO NOT EDIT.
 *
 * Any inputs, with NaN, infinities and NULL:
 *   frama-c -eva -eva-slevel 1000 -eva-slevel-merge-after-loop @all -eva-split-return full -eva-subdivide-non-linear 20 -eva-domains equality -warn-special-float none stage15_observer_eva.c stage15_observer.c
 * Finite inputs, and no value on the way may overflow or be NaN:
 *   frama-c -cpp-extra-args=-DFINITE -eva -eva-slevel 1000 -eva-slevel-merge-after-loop @all -eva-split-return full -eva-subdivide-non-linear 20 -eva-domains equality -warn-special-float non-finite stage15_observer_eva.c stage15_observer.c
 *
 * It is proved where no line begins with [eva:alarm] and the summary has no property unknown. A call is
 * proved from whatever the calls before it may have left. In finite mode values are drawn from the ranges
 * below; give others with -cpp-extra-args="-DFINITE -D<macro>=<number>".
 */
#include "stage15_observer.h"

#include <math.h>
#include <stddef.h>

#include "__fc_builtin.h"

#ifndef STAGE15_OBSERVER_EVA_H_MIN
#define STAGE15_OBSERVER_EVA_H_MIN 0.01f
#endif
#ifndef STAGE15_OBSERVER_EVA_H_MAX
#define STAGE15_OBSERVER_EVA_H_MAX 0.01f
#endif
/* Bounds of what is measured, and of the fields that calls change. */
#ifndef STAGE15_OBSERVER_EVA_Y1_MAX
#define STAGE15_OBSERVER_EVA_Y1_MAX 10.0f
#endif
#ifndef STAGE15_OBSERVER_EVA_APPLIED_MAX
#define STAGE15_OBSERVER_EVA_APPLIED_MAX 10.0f
#endif
#ifndef STAGE15_OBSERVER_EVA_U1_MAX
#define STAGE15_OBSERVER_EVA_U1_MAX 10.0f
#endif
#ifndef STAGE15_OBSERVER_EVA_U2_MAX
#define STAGE15_OBSERVER_EVA_U2_MAX 10.0f
#endif
#ifndef STAGE15_OBSERVER_EVA_X1_HAT_MAX
#define STAGE15_OBSERVER_EVA_X1_HAT_MAX 10.0f
#endif
#ifndef STAGE15_OBSERVER_EVA_X2_HAT_MAX
#define STAGE15_OBSERVER_EVA_X2_HAT_MAX 10.0f
#endif
#ifndef STAGE15_OBSERVER_EVA_D_HAT_MAX
#define STAGE15_OBSERVER_EVA_D_HAT_MAX 10.0f
#endif

/* Frama-C leaves the sign of a true isfinite open; the code only asks whether it is 0. */
/*@ ensures \result >= 0; */
extern int __finite(double d);
/*@ ensures \result >= 0; */
extern int __finitef(float f);

static volatile float stage15_observer_eva_source;

/* Any number, or in finite mode one of least to greatest. */
static float stage15_observer_eva_draw(float least, float greatest)
{
#ifdef FINITE
    return Frama_C_float_interval(least, greatest);
#else
    (void)least;
    (void)greatest;
    return stage15_observer_eva_source;
#endif
}

static uint32_t stage15_observer_eva_count(uint32_t least, uint32_t greatest)
{
    return (uint32_t)Frama_C_unsigned_int_interval(least, greatest);
}

/* Any tick. */
static uint32_t stage15_observer_eva_tick(void)
{
    return stage15_observer_eva_count(0U, 4294967295U);
}

/* Fields that nothing has set. */
static void stage15_observer_eva_blank(stage15_observer *self)
{
    self->start = 42U;
    self->u1 = 42.0f;
    self->u2 = 42.0f;
    self->seen = 42U;
    self->x1_hat = 42.0f;
    self->x2_hat = 42.0f;
    self->d_hat = 42.0f;
    self->phi1_2 = 42.0f;
    self->phi1_3 = 42.0f;
    self->gamma1 = 42.0f;
    self->late_gamma1 = 42.0f;
    self->phi2_3 = 42.0f;
    self->gamma2 = 42.0f;
    self->hold_o = 42.0f;
    self->q2_1 = 42.0f;
    self->q2_2 = 42.0f;
    self->q3_1 = 42.0f;
}

static void stage15_observer_eva_untouched(const stage15_observer *self)
{
    (void)self;
    //@ assert untouched: self->start == 42;
    //@ assert untouched: self->u1 == 42.0;
    //@ assert untouched: self->u2 == 42.0;
    //@ assert untouched: self->seen == 42;
    //@ assert untouched: self->x1_hat == 42.0;
    //@ assert untouched: self->x2_hat == 42.0;
    //@ assert untouched: self->d_hat == 42.0;
    //@ assert untouched: self->phi1_2 == 42.0;
    //@ assert untouched: self->phi1_3 == 42.0;
    //@ assert untouched: self->gamma1 == 42.0;
    //@ assert untouched: self->late_gamma1 == 42.0;
    //@ assert untouched: self->phi2_3 == 42.0;
    //@ assert untouched: self->gamma2 == 42.0;
    //@ assert untouched: self->hold_o == 42.0;
    //@ assert untouched: self->q2_1 == 42.0;
    //@ assert untouched: self->q2_2 == 42.0;
    //@ assert untouched: self->q3_1 == 42.0;
}

/* What calls may leave, and more. */
static void stage15_observer_eva_kept(stage15_observer *self)
{
    self->start = stage15_observer_eva_tick();
    self->u1 = stage15_observer_eva_draw(-STAGE15_OBSERVER_EVA_U1_MAX, STAGE15_OBSERVER_EVA_U1_MAX);
    self->u2 = stage15_observer_eva_draw(-STAGE15_OBSERVER_EVA_U2_MAX, STAGE15_OBSERVER_EVA_U2_MAX);
    self->seen = stage15_observer_eva_count(0U, 1U);
    self->x1_hat = stage15_observer_eva_draw(-STAGE15_OBSERVER_EVA_X1_HAT_MAX, STAGE15_OBSERVER_EVA_X1_HAT_MAX);
    self->x2_hat = stage15_observer_eva_draw(-STAGE15_OBSERVER_EVA_X2_HAT_MAX, STAGE15_OBSERVER_EVA_X2_HAT_MAX);
    self->d_hat = stage15_observer_eva_draw(-STAGE15_OBSERVER_EVA_D_HAT_MAX, STAGE15_OBSERVER_EVA_D_HAT_MAX);
}

/* A call at any tick, and the estimates behind it: a status. */
static void stage15_observer_eva_use(stage15_observer *self, float limit, int level)
{
    const uint32_t k = stage15_observer_eva_tick();
    float y[1];
    ptc_status status;
    const float u = stage15_observer_eva_draw(-STAGE15_OBSERVER_EVA_APPLIED_MAX, STAGE15_OBSERVER_EVA_APPLIED_MAX);
    float xhat[2];
    float d;

    (void)limit;
    (void)level;
    y[0] = stage15_observer_eva_draw(-STAGE15_OBSERVER_EVA_Y1_MAX, STAGE15_OBSERVER_EVA_Y1_MAX);
    status = stage15_observer_update(self, k, y, u);
    //@ assert known: -3 <= status <= 3 && status != PTC_E_PARAM;
#ifdef FINITE
    //@ assert accepted: status >= 0;
#endif
    status = stage15_observer_estimate(self, xhat);
    //@ assert given: status == PTC_OK;
    status = stage15_observer_disturbance(self, &d);
    //@ assert given: status == PTC_OK;
    //@ assert initialized: \initialized(xhat + (0 .. 1));
    //@ assert initialized: \initialized(&d);
}

/* init and the first call, then arm and any call. */
static void stage15_observer_eva_live(float limit, int level)
{
    stage15_observer_params params;
    stage15_observer own;
    stage15_observer *const self = &own;
    ptc_status status;

    params.h = stage15_observer_eva_draw(STAGE15_OBSERVER_EVA_H_MIN, STAGE15_OBSERVER_EVA_H_MAX);
    stage15_observer_eva_blank(self);
    status = stage15_observer_init(self, &params);
    if (status == PTC_OK) {
        stage15_observer_eva_use(self, limit, level);
        status = stage15_observer_arm(self, stage15_observer_eva_tick());
        //@ assert armed: status == PTC_OK;
        stage15_observer_eva_kept(self);
        stage15_observer_eva_use(self, limit, level);
    } else {
        //@ assert refused: status == PTC_E_PARAM;
        stage15_observer_eva_untouched(self);
#ifdef FINITE
        //@ assert started: \false;
#endif
    }
}

#ifndef FINITE
/* NULL for every pointer that is checked, and no number for every input. */
static void stage15_observer_eva_null(void)
{
    stage15_observer_params params;
    stage15_observer own;
    stage15_observer *const self = &own;
    ptc_status status;
    const uint32_t k = stage15_observer_eva_tick();
    float y[1];
    float u = 0.0f;
    float xhat[2];
    float d;

    params.h = stage15_observer_eva_draw(0.0f, 0.0f);
    stage15_observer_eva_blank(self);
    status = stage15_observer_init(NULL, &params);
    //@ assert no_self: status == PTC_E_PARAM;
    status = stage15_observer_init(self, NULL);
    //@ assert no_params: status == PTC_E_PARAM;
    stage15_observer_eva_untouched(self);
    y[0] = stage15_observer_eva_draw(0.0f, 0.0f);
    status = stage15_observer_arm(NULL, k);
    //@ assert missing: status == PTC_E_INPUT;
    status = stage15_observer_update(NULL, k, y, u);
    //@ assert missing: status == PTC_E_INPUT;
    status = stage15_observer_update(self, k, NULL, u);
    //@ assert missing: status == PTC_E_INPUT;
    status = stage15_observer_estimate(NULL, xhat);
    //@ assert missing: status == PTC_E_INPUT;
    status = stage15_observer_estimate(self, NULL);
    //@ assert missing: status == PTC_E_INPUT;
    status = stage15_observer_disturbance(NULL, &d);
    //@ assert missing: status == PTC_E_INPUT;
    status = stage15_observer_disturbance(self, NULL);
    //@ assert missing: status == PTC_E_INPUT;
    stage15_observer_eva_untouched(self);
    y[0] = 0.0f;
    y[0] = NAN;
    status = stage15_observer_update(self, k, y, u);
    //@ assert no_number: status == PTC_E_INPUT;
    y[0] = 0.0f;
    u = INFINITY;
    status = stage15_observer_update(self, k, y, u);
    //@ assert no_number: status == PTC_E_INPUT;
    stage15_observer_eva_untouched(self);
}
#endif

/* The whole proof of stage15_observer. */
void stage15_observer_eva(void)
{
#ifndef FINITE
    stage15_observer_eva_null();
#endif
    stage15_observer_eva_live(0.0f, 1);
}

/* Left out where a program of several proofs has a main of its own. */
#ifndef PTC_EVA_PART
int main(void)
{
    stage15_observer_eva();
    return 0;
}
#endif
