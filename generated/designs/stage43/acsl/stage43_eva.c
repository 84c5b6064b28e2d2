/*
 * Proof that stage43.c has no error at run time, with the plug-in Eva of Frama-C. Here are stage43.h,
 * stage43.c and this file, all three written by ptc-codegen emit --acsl. DO NOT EDIT.
 *
 * Any inputs, with NaN, infinities and NULL:
 *   frama-c -eva -eva-slevel 1000 -eva-slevel-merge-after-loop @all -eva-split-return full -eva-subdivide-non-linear 20 -eva-domains equality -warn-special-float none stage43_eva.c stage43.c
 * Finite inputs, and no value on the way may overflow or be NaN:
 *   frama-c -cpp-extra-args=-DFINITE -eva -eva-slevel 1000 -eva-slevel-merge-after-loop @all -eva-split-return full -eva-subdivide-non-linear 20 -eva-domains equality -warn-special-float non-finite stage43_eva.c stage43.c
 *
 * It is proved where no line begins with [eva:alarm] and the summary has no property unknown. A call is
 * proved from whatever the calls before it may have left. In finite mode values are drawn from the ranges
 * below; give others with -cpp-extra-args="-DFINITE -D<macro>=<number>".
 */
#include "stage43.h"

#include <math.h>
#include <stddef.h>

#include "__fc_builtin.h"

/* Upper bound of the ticks since the start: the precision represents each up to here exactly. */
#ifndef STAGE43_EVA_ELAPSED_MAX
#define STAGE43_EVA_ELAPSED_MAX 4294967295U
#endif
/* Bounds of what is measured, and of the fields that calls change. */
#ifndef STAGE43_EVA_Y1_MAX
#define STAGE43_EVA_Y1_MAX 10.0
#endif
#ifndef STAGE43_EVA_U1_MAX
#define STAGE43_EVA_U1_MAX 6.0
#endif
#ifndef STAGE43_EVA_U2_MAX
#define STAGE43_EVA_U2_MAX 6.0
#endif
#ifndef STAGE43_EVA_U3_MAX
#define STAGE43_EVA_U3_MAX 6.0
#endif
#ifndef STAGE43_EVA_U4_MAX
#define STAGE43_EVA_U4_MAX 6.0
#endif
#ifndef STAGE43_EVA_X1_HAT_MAX
#define STAGE43_EVA_X1_HAT_MAX 10.0
#endif
#ifndef STAGE43_EVA_X2_HAT_MAX
#define STAGE43_EVA_X2_HAT_MAX 10.0
#endif
#ifndef STAGE43_EVA_X3_HAT_MAX
#define STAGE43_EVA_X3_HAT_MAX 10.0
#endif
#ifndef STAGE43_EVA_D_HAT_MAX
#define STAGE43_EVA_D_HAT_MAX 10.0
#endif

/* Frama-C leaves the sign of a true isfinite open; the code only asks whether it is 0. */
/*@ ensures \result >= 0; */
extern int __finite(double d);
/*@ ensures \result >= 0; */
extern int __finitef(float f);

static volatile double stage43_eva_source;

/* Any number, or in finite mode one of least to greatest. */
static double stage43_eva_draw(double least, double greatest)
{
#ifdef FINITE
    return Frama_C_double_interval(least, greatest);
#else
    (void)least;
    (void)greatest;
    return stage43_eva_source;
#endif
}

static uint32_t stage43_eva_count(uint32_t least, uint32_t greatest)
{
    return (uint32_t)Frama_C_unsigned_int_interval(least, greatest);
}

/* Any tick. */
static uint32_t stage43_eva_tick(void)
{
    return stage43_eva_count(0U, 4294967295U);
}

/* Fields that nothing has set. */
static void stage43_eva_blank(stage43 *self)
{
    self->start = 42U;
    self->u1 = 42.0;
    self->u2 = 42.0;
    self->u3 = 42.0;
    self->u4 = 42.0;
    self->seen = 42U;
    self->x1_hat = 42.0;
    self->x2_hat = 42.0;
    self->x3_hat = 42.0;
    self->d_hat = 42.0;
}

static void stage43_eva_untouched(const stage43 *self)
{
    (void)self;
    //@ assert untouched: self->start == 42;
    //@ assert untouched: self->u1 == 42.0;
    //@ assert untouched: self->u2 == 42.0;
    //@ assert untouched: self->u3 == 42.0;
    //@ assert untouched: self->u4 == 42.0;
    //@ assert untouched: self->seen == 42;
    //@ assert untouched: self->x1_hat == 42.0;
    //@ assert untouched: self->x2_hat == 42.0;
    //@ assert untouched: self->x3_hat == 42.0;
    //@ assert untouched: self->d_hat == 42.0;
}

/* What calls may leave, and more. */
static void stage43_eva_kept(stage43 *self)
{
    self->start = stage43_eva_tick();
    self->u1 = stage43_eva_draw(-STAGE43_EVA_U1_MAX, STAGE43_EVA_U1_MAX);
    self->u2 = stage43_eva_draw(-STAGE43_EVA_U2_MAX, STAGE43_EVA_U2_MAX);
    self->u3 = stage43_eva_draw(-STAGE43_EVA_U3_MAX, STAGE43_EVA_U3_MAX);
    self->u4 = stage43_eva_draw(-STAGE43_EVA_U4_MAX, STAGE43_EVA_U4_MAX);
    self->seen = stage43_eva_count(0U, 1U);
    self->x1_hat = stage43_eva_draw(-STAGE43_EVA_X1_HAT_MAX, STAGE43_EVA_X1_HAT_MAX);
    self->x2_hat = stage43_eva_draw(-STAGE43_EVA_X2_HAT_MAX, STAGE43_EVA_X2_HAT_MAX);
    self->x3_hat = stage43_eva_draw(-STAGE43_EVA_X3_HAT_MAX, STAGE43_EVA_X3_HAT_MAX);
    self->d_hat = stage43_eva_draw(-STAGE43_EVA_D_HAT_MAX, STAGE43_EVA_D_HAT_MAX);
}

/* A call at any tick, and the estimates behind it: a status, with u = 0 where it is negative; at level 1 that
 * u is finite, at 2 its bound. */
static void stage43_eva_use(stage43 *self, double limit, int level)
{
#ifdef FINITE
    /* Only differences of ticks are used. */
    self->start = 0U;
    const uint32_t k = stage43_eva_count(0U, STAGE43_EVA_ELAPSED_MAX);
#else
    const uint32_t k = stage43_eva_tick();
#endif
    double y[1];
    ptc_status status;
    double u;
    double xhat[3];
    double d;

    (void)limit;
    (void)level;
    y[0] = stage43_eva_draw(-STAGE43_EVA_Y1_MAX, STAGE43_EVA_Y1_MAX);
    status = stage43_step(self, k, y, &u);
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
    status = stage43_estimate(self, xhat);
    //@ assert given: status == PTC_OK;
    status = stage43_disturbance(self, &d);
    //@ assert given: status == PTC_OK;
    //@ assert initialized: \initialized(xhat + (0 .. 2));
    //@ assert initialized: \initialized(&d);
}

/* init and the first call, then arm and any call. */
static void stage43_eva_live(double limit, int level)
{
    stage43_params params;
    stage43 own;
    stage43 *const self = &own;
    ptc_status status;

    params.none = 0;
    stage43_eva_blank(self);
    status = stage43_init(self, &params);
    if (status == PTC_OK) {
        stage43_eva_use(self, limit, level);
        status = stage43_arm(self, stage43_eva_tick());
        //@ assert armed: status == PTC_OK;
        stage43_eva_kept(self);
        stage43_eva_use(self, limit, level);
    } else {
        //@ assert refused: status == PTC_E_PARAM;
        stage43_eva_untouched(self);
#ifdef FINITE
        //@ assert started: \false;
#endif
    }
}

#ifndef FINITE
/* NULL for every pointer that is checked, and no number for every input. */
static void stage43_eva_null(void)
{
    stage43_params params;
    stage43 own;
    stage43 *const self = &own;
    ptc_status status;
    const uint32_t k = stage43_eva_tick();
    double y[1];
    double u;
    double xhat[3];
    double d;

    params.none = 0;
    stage43_eva_blank(self);
    status = stage43_init(NULL, &params);
    //@ assert no_self: status == PTC_E_PARAM;
    y[0] = stage43_eva_draw(0.0, 0.0);
    status = stage43_arm(NULL, k);
    //@ assert missing: status == PTC_E_INPUT;
    status = stage43_step(NULL, k, y, &u);
    //@ assert missing: status == PTC_E_INPUT;
    //@ assert zero: u == 0.0;
    status = stage43_step(self, k, NULL, &u);
    //@ assert missing: status == PTC_E_INPUT;
    //@ assert zero: u == 0.0;
    status = stage43_step(self, k, y, NULL);
    //@ assert missing: status == PTC_E_INPUT;
    status = stage43_estimate(NULL, xhat);
    //@ assert missing: status == PTC_E_INPUT;
    status = stage43_estimate(self, NULL);
    //@ assert missing: status == PTC_E_INPUT;
    status = stage43_disturbance(NULL, &d);
    //@ assert missing: status == PTC_E_INPUT;
    status = stage43_disturbance(self, NULL);
    //@ assert missing: status == PTC_E_INPUT;
    stage43_eva_untouched(self);
    y[0] = 0.0;
    y[0] = NAN;
    status = stage43_step(self, k, y, &u);
    //@ assert no_number: status == PTC_E_INPUT;
    y[0] = 0.0;
    stage43_eva_untouched(self);
}
#endif

/* The whole proof of stage43. */
void stage43_eva(void)
{
#ifndef FINITE
    stage43_eva_null();
#endif
    stage43_eva_live(6.0, 2);
}

/* Left out where a program of several proofs has a main of its own. */
#ifndef PTC_EVA_PART
int main(void)
{
    stage43_eva();
    return 0;
}
#endif
