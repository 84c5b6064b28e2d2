/*
 * Proof that stage41_observer.c has no error at run time, with the plug-in Eva of Frama-C. Here are stage41_observer.h,
 * stage41_observer.c and this file, all three written by ptc-codegen emit --acsl. DO NOT EDIT.
 *
 * Any inputs, with NaN, infinities and NULL:
 *   frama-c -eva -eva-slevel 1000 -eva-slevel-merge-after-loop @all -eva-split-return full -eva-subdivide-non-linear 20 -eva-domains equality -warn-special-float none stage41_observer_eva.c stage41_observer.c
 * Finite inputs, and no value on the way may overflow or be NaN:
 *   frama-c -cpp-extra-args=-DFINITE -eva -eva-slevel 1000 -eva-slevel-merge-after-loop @all -eva-split-return full -eva-subdivide-non-linear 20 -eva-domains equality -warn-special-float non-finite stage41_observer_eva.c stage41_observer.c
 *
 * It is proved where no line begins with [eva:alarm] and the summary has no property unknown. A call is
 * proved from whatever the calls before it may have left. In finite mode values are drawn from the ranges
 * below; give others with -cpp-extra-args="-DFINITE -D<macro>=<number>".
 */
#include "stage41_observer.h"

#include <math.h>
#include <stddef.h>

#include "__fc_builtin.h"

/* Bounds of what is measured, and of the fields that calls change. */
#ifndef STAGE41_OBSERVER_EVA_Y1_MAX
#define STAGE41_OBSERVER_EVA_Y1_MAX 10.0f
#endif
#ifndef STAGE41_OBSERVER_EVA_Y2_MAX
#define STAGE41_OBSERVER_EVA_Y2_MAX 10.0f
#endif
#ifndef STAGE41_OBSERVER_EVA_APPLIED_MAX
#define STAGE41_OBSERVER_EVA_APPLIED_MAX 10.0f
#endif
#ifndef STAGE41_OBSERVER_EVA_X1_HAT_MAX
#define STAGE41_OBSERVER_EVA_X1_HAT_MAX 10.0f
#endif
#ifndef STAGE41_OBSERVER_EVA_X1_NEXT_MAX
#define STAGE41_OBSERVER_EVA_X1_NEXT_MAX 10.0f
#endif
#ifndef STAGE41_OBSERVER_EVA_X2_HAT_MAX
#define STAGE41_OBSERVER_EVA_X2_HAT_MAX 10.0f
#endif
#ifndef STAGE41_OBSERVER_EVA_X2_NEXT_MAX
#define STAGE41_OBSERVER_EVA_X2_NEXT_MAX 10.0f
#endif
#ifndef STAGE41_OBSERVER_EVA_X3_HAT_MAX
#define STAGE41_OBSERVER_EVA_X3_HAT_MAX 10.0f
#endif
#ifndef STAGE41_OBSERVER_EVA_X3_NEXT_MAX
#define STAGE41_OBSERVER_EVA_X3_NEXT_MAX 10.0f
#endif

/* Frama-C leaves the sign of a true isfinite open; the code only asks whether it is 0. */
/*@ ensures \result >= 0; */
extern int __finite(double d);
/*@ ensures \result >= 0; */
extern int __finitef(float f);

static volatile float stage41_observer_eva_source;

/* Any number, or in finite mode one of least to greatest. */
static float stage41_observer_eva_draw(float least, float greatest)
{
#ifdef FINITE
    return Frama_C_float_interval(least, greatest);
#else
    (void)least;
    (void)greatest;
    return stage41_observer_eva_source;
#endif
}

static uint32_t stage41_observer_eva_count(uint32_t least, uint32_t greatest)
{
    return (uint32_t)Frama_C_unsigned_int_interval(least, greatest);
}

/* Any tick. */
static uint32_t stage41_observer_eva_tick(void)
{
    return stage41_observer_eva_count(0U, 4294967295U);
}

/* Fields that nothing has set. */
static void stage41_observer_eva_blank(stage41_observer *self)
{
    self->start = 42U;
    self->seen = 42U;
    self->x1_hat = 42.0f;
    self->x1_next = 42.0f;
    self->x2_hat = 42.0f;
    self->x2_next = 42.0f;
    self->x3_hat = 42.0f;
    self->x3_next = 42.0f;
    self->trust = 42U;
}

static void stage41_observer_eva_untouched(const stage41_observer *self)
{
    (void)self;
    //@ assert untouched: self->start == 42;
    //@ assert untouched: self->seen == 42;
    //@ assert untouched: self->x1_hat == 42.0;
    //@ assert untouched: self->x1_next == 42.0;
    //@ assert untouched: self->x2_hat == 42.0;
    //@ assert untouched: self->x2_next == 42.0;
    //@ assert untouched: self->x3_hat == 42.0;
    //@ assert untouched: self->x3_next == 42.0;
    //@ assert untouched: self->trust == 42;
}

/* What calls may leave, and more. */
static void stage41_observer_eva_kept(stage41_observer *self)
{
    self->start = stage41_observer_eva_tick();
    self->seen = stage41_observer_eva_count(0U, 1U);
    self->x1_hat = stage41_observer_eva_draw(-STAGE41_OBSERVER_EVA_X1_HAT_MAX, STAGE41_OBSERVER_EVA_X1_HAT_MAX);
    self->x1_next = stage41_observer_eva_draw(-STAGE41_OBSERVER_EVA_X1_NEXT_MAX, STAGE41_OBSERVER_EVA_X1_NEXT_MAX);
    self->x2_hat = stage41_observer_eva_draw(-STAGE41_OBSERVER_EVA_X2_HAT_MAX, STAGE41_OBSERVER_EVA_X2_HAT_MAX);
    self->x2_next = stage41_observer_eva_draw(-STAGE41_OBSERVER_EVA_X2_NEXT_MAX, STAGE41_OBSERVER_EVA_X2_NEXT_MAX);
    self->x3_hat = stage41_observer_eva_draw(-STAGE41_OBSERVER_EVA_X3_HAT_MAX, STAGE41_OBSERVER_EVA_X3_HAT_MAX);
    self->x3_next = stage41_observer_eva_draw(-STAGE41_OBSERVER_EVA_X3_NEXT_MAX, STAGE41_OBSERVER_EVA_X3_NEXT_MAX);
    self->trust = stage41_observer_eva_tick();
}

/* A call at any tick, and the estimates behind it: a status. */
static void stage41_observer_eva_use(stage41_observer *self, float limit, int level)
{
    const uint32_t k = stage41_observer_eva_tick();
    float y[2];
    ptc_status status;
    const float u = stage41_observer_eva_draw(-STAGE41_OBSERVER_EVA_APPLIED_MAX, STAGE41_OBSERVER_EVA_APPLIED_MAX);
    float xhat[3];

    (void)limit;
    (void)level;
    y[0] = stage41_observer_eva_draw(-STAGE41_OBSERVER_EVA_Y1_MAX, STAGE41_OBSERVER_EVA_Y1_MAX);
    y[1] = stage41_observer_eva_draw(-STAGE41_OBSERVER_EVA_Y2_MAX, STAGE41_OBSERVER_EVA_Y2_MAX);
    status = stage41_observer_update(self, k, y, u);
    //@ assert known: -3 <= status <= 4 && status != PTC_E_PARAM;
#ifdef FINITE
    //@ assert accepted: status >= 0 || status == PTC_E_INPUT;
#endif
    status = stage41_observer_estimate(self, xhat);
    //@ assert given: status == PTC_OK;
    //@ assert initialized: \initialized(xhat + (0 .. 2));
}

/* init and the first call, then arm and any call. */
static void stage41_observer_eva_live(float limit, int level)
{
    stage41_observer_params params;
    stage41_observer own;
    stage41_observer *const self = &own;
    ptc_status status;

    params.none = 0;
    stage41_observer_eva_blank(self);
    status = stage41_observer_init(self, &params);
    if (status == PTC_OK) {
        stage41_observer_eva_use(self, limit, level);
        status = stage41_observer_arm(self, stage41_observer_eva_tick());
        //@ assert armed: status == PTC_OK;
        stage41_observer_eva_kept(self);
        stage41_observer_eva_use(self, limit, level);
    } else {
        //@ assert refused: status == PTC_E_PARAM;
        stage41_observer_eva_untouched(self);
#ifdef FINITE
        //@ assert started: \false;
#endif
    }
}

#ifndef FINITE
/* NULL for every pointer that is checked, and no number for every input. */
static void stage41_observer_eva_null(void)
{
    stage41_observer_params params;
    stage41_observer own;
    stage41_observer *const self = &own;
    ptc_status status;
    const uint32_t k = stage41_observer_eva_tick();
    float y[2];
    float u = 0.0f;
    float xhat[3];

    params.none = 0;
    stage41_observer_eva_blank(self);
    status = stage41_observer_init(NULL, &params);
    //@ assert no_self: status == PTC_E_PARAM;
    y[0] = stage41_observer_eva_draw(0.0f, 0.0f);
    y[1] = stage41_observer_eva_draw(0.0f, 0.0f);
    status = stage41_observer_arm(NULL, k);
    //@ assert missing: status == PTC_E_INPUT;
    status = stage41_observer_update(NULL, k, y, u);
    //@ assert missing: status == PTC_E_INPUT;
    status = stage41_observer_update(self, k, NULL, u);
    //@ assert missing: status == PTC_E_INPUT;
    status = stage41_observer_estimate(NULL, xhat);
    //@ assert missing: status == PTC_E_INPUT;
    status = stage41_observer_estimate(self, NULL);
    //@ assert missing: status == PTC_E_INPUT;
    stage41_observer_eva_untouched(self);
    y[0] = 0.0f;
    y[1] = 0.0f;
    self->trust = 2U;
    y[0] = NAN;
    status = stage41_observer_update(self, k, y, u);
    //@ assert no_number: status == PTC_E_INPUT || status == PTC_GATED;
    y[0] = 0.0f;
    y[1] = NAN;
    status = stage41_observer_update(self, k, y, u);
    //@ assert no_number: status == PTC_E_INPUT || status == PTC_GATED;
    y[1] = 0.0f;
    stage41_observer_eva_blank(self);
    u = INFINITY;
    status = stage41_observer_update(self, k, y, u);
    //@ assert no_number: status == PTC_E_INPUT;
    stage41_observer_eva_untouched(self);
}
#endif

/* The whole proof of stage41_observer. */
void stage41_observer_eva(void)
{
#ifndef FINITE
    stage41_observer_eva_null();
#endif
    stage41_observer_eva_live(0.0f, 1);
}

/* Left out where a program of several proofs has a main of its own. */
#ifndef PTC_EVA_PART
int main(void)
{
    stage41_observer_eva();
    return 0;
}
#endif
