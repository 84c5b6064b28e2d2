/*
 * Proof that stage48.c has no error at run time, with the plug-in Eva of Frama-C. Here are stage48.h,
 * stage48.c and this file, all three written by ptc-codegen emit --acsl. DO NOT EDIT.
 *
 * Any inputs, with NaN, infinities and NULL:
 *   frama-c -eva -eva-slevel 1000 -eva-slevel-merge-after-loop @all -eva-split-return full -eva-subdivide-non-linear 20 -eva-domains equality -warn-special-float none stage48_eva.c stage48.c
 * Finite inputs, and no value on the way may overflow or be NaN:
 *   frama-c -cpp-extra-args=-DFINITE -eva -eva-slevel 1000 -eva-slevel-merge-after-loop @all -eva-split-return full -eva-subdivide-non-linear 20 -eva-domains equality -warn-special-float non-finite stage48_eva.c stage48.c
 *
 * It is proved where no line begins with [eva:alarm] and the summary has no property unknown. A call is
 * proved from whatever the calls before it may have left. In finite mode values are drawn from the ranges
 * below; give others with -cpp-extra-args="-DFINITE -D<macro>=<number>".
 */
#include "stage48.h"

#include <math.h>
#include <stddef.h>

#include "__fc_builtin.h"

/* Bounds of what is measured, and of the fields that calls change. */
#ifndef STAGE48_EVA_Y1_MAX
#define STAGE48_EVA_Y1_MAX 10.0
#endif
#ifndef STAGE48_EVA_U1_MAX
#define STAGE48_EVA_U1_MAX 24.0
#endif
#ifndef STAGE48_EVA_U2_MAX
#define STAGE48_EVA_U2_MAX 24.0
#endif
#ifndef STAGE48_EVA_U3_MAX
#define STAGE48_EVA_U3_MAX 24.0
#endif
#ifndef STAGE48_EVA_X1_HAT_MAX
#define STAGE48_EVA_X1_HAT_MAX 10.0
#endif
#ifndef STAGE48_EVA_X1_NEXT_MAX
#define STAGE48_EVA_X1_NEXT_MAX 10.0
#endif
#ifndef STAGE48_EVA_X2_HAT_MAX
#define STAGE48_EVA_X2_HAT_MAX 10.0
#endif
#ifndef STAGE48_EVA_X2_NEXT_MAX
#define STAGE48_EVA_X2_NEXT_MAX 10.0
#endif
#ifndef STAGE48_EVA_X3_HAT_MAX
#define STAGE48_EVA_X3_HAT_MAX 10.0
#endif
#ifndef STAGE48_EVA_X3_NEXT_MAX
#define STAGE48_EVA_X3_NEXT_MAX 10.0
#endif
#ifndef STAGE48_EVA_D_HAT_MAX
#define STAGE48_EVA_D_HAT_MAX 10.0
#endif
#ifndef STAGE48_EVA_D_NEXT_MAX
#define STAGE48_EVA_D_NEXT_MAX 10.0
#endif

/* Frama-C leaves the sign of a true isfinite open; the code only asks whether it is 0. */
/*@ ensures \result >= 0; */
extern int __finite(double d);
/*@ ensures \result >= 0; */
extern int __finitef(float f);

static volatile double stage48_eva_source;

/* Any number, or in finite mode one of least to greatest. */
static double stage48_eva_draw(double least, double greatest)
{
#ifdef FINITE
    return Frama_C_double_interval(least, greatest);
#else
    (void)least;
    (void)greatest;
    return stage48_eva_source;
#endif
}

static uint32_t stage48_eva_count(uint32_t least, uint32_t greatest)
{
    return (uint32_t)Frama_C_unsigned_int_interval(least, greatest);
}

/* Any tick. */
static uint32_t stage48_eva_tick(void)
{
    return stage48_eva_count(0U, 4294967295U);
}

/* Fields that nothing has set. */
static void stage48_eva_blank(stage48 *self)
{
    self->start = 42U;
    self->u1 = 42.0;
    self->u2 = 42.0;
    self->u3 = 42.0;
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

static void stage48_eva_untouched(const stage48 *self)
{
    (void)self;
    //@ assert untouched: self->start == 42;
    //@ assert untouched: self->u1 == 42.0;
    //@ assert untouched: self->u2 == 42.0;
    //@ assert untouched: self->u3 == 42.0;
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
static void stage48_eva_kept(stage48 *self)
{
    self->start = stage48_eva_tick();
    self->u1 = stage48_eva_draw(-STAGE48_EVA_U1_MAX, STAGE48_EVA_U1_MAX);
    self->u2 = stage48_eva_draw(-STAGE48_EVA_U2_MAX, STAGE48_EVA_U2_MAX);
    self->u3 = stage48_eva_draw(-STAGE48_EVA_U3_MAX, STAGE48_EVA_U3_MAX);
    self->seen = stage48_eva_count(0U, 1U);
    self->x1_hat = stage48_eva_draw(-STAGE48_EVA_X1_HAT_MAX, STAGE48_EVA_X1_HAT_MAX);
    self->x1_next = stage48_eva_draw(-STAGE48_EVA_X1_NEXT_MAX, STAGE48_EVA_X1_NEXT_MAX);
    self->x2_hat = stage48_eva_draw(-STAGE48_EVA_X2_HAT_MAX, STAGE48_EVA_X2_HAT_MAX);
    self->x2_next = stage48_eva_draw(-STAGE48_EVA_X2_NEXT_MAX, STAGE48_EVA_X2_NEXT_MAX);
    self->x3_hat = stage48_eva_draw(-STAGE48_EVA_X3_HAT_MAX, STAGE48_EVA_X3_HAT_MAX);
    self->x3_next = stage48_eva_draw(-STAGE48_EVA_X3_NEXT_MAX, STAGE48_EVA_X3_NEXT_MAX);
    self->d_hat = stage48_eva_draw(-STAGE48_EVA_D_HAT_MAX, STAGE48_EVA_D_HAT_MAX);
    self->d_next = stage48_eva_draw(-STAGE48_EVA_D_NEXT_MAX, STAGE48_EVA_D_NEXT_MAX);
}

/* A call at any tick, and the estimates behind it: a status, with u = 0 where it is negative; at level 1 that
 * u is finite, at 2 its bound. */
static void stage48_eva_use(stage48 *self, double limit, int level)
{
    const uint32_t k = stage48_eva_tick();
    double y[1];
    ptc_status status;
    double u;
    double xhat[3];
    double d;

    (void)limit;
    (void)level;
    y[0] = stage48_eva_draw(-STAGE48_EVA_Y1_MAX, STAGE48_EVA_Y1_MAX);
    status = stage48_step(self, k, y, &u);
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
    status = stage48_estimate(self, xhat);
    //@ assert given: status == PTC_OK;
    status = stage48_disturbance(self, &d);
    //@ assert given: status == PTC_OK;
    //@ assert initialized: \initialized(xhat + (0 .. 2));
    //@ assert initialized: \initialized(&d);
}

/* init and the first call, then arm and any call. */
static void stage48_eva_live(double limit, int level)
{
    stage48_params params;
    stage48 own;
    stage48 *const self = &own;
    ptc_status status;

    params.none = 0;
    stage48_eva_blank(self);
    status = stage48_init(self, &params);
    if (status == PTC_OK) {
        stage48_eva_use(self, limit, level);
        status = stage48_arm(self, stage48_eva_tick());
        //@ assert armed: status == PTC_OK;
        stage48_eva_kept(self);
        stage48_eva_use(self, limit, level);
    } else {
        //@ assert refused: status == PTC_E_PARAM;
        stage48_eva_untouched(self);
#ifdef FINITE
        //@ assert started: \false;
#endif
    }
}

#ifndef FINITE
/* NULL for every pointer that is checked, and no number for every input. */
static void stage48_eva_null(void)
{
    stage48_params params;
    stage48 own;
    stage48 *const self = &own;
    ptc_status status;
    const uint32_t k = stage48_eva_tick();
    double y[1];
    double u;
    double xhat[3];
    double d;

    params.none = 0;
    stage48_eva_blank(self);
    status = stage48_init(NULL, &params);
    //@ assert no_self: status == PTC_E_PARAM;
    y[0] = stage48_eva_draw(0.0, 0.0);
    status = stage48_arm(NULL, k);
    //@ assert missing: status == PTC_E_INPUT;
    status = stage48_step(NULL, k, y, &u);
    //@ assert missing: status == PTC_E_INPUT;
    //@ assert zero: u == 0.0;
    status = stage48_step(self, k, NULL, &u);
    //@ assert missing: status == PTC_E_INPUT;
    //@ assert zero: u == 0.0;
    status = stage48_step(self, k, y, NULL);
    //@ assert missing: status == PTC_E_INPUT;
    status = stage48_estimate(NULL, xhat);
    //@ assert missing: status == PTC_E_INPUT;
    status = stage48_estimate(self, NULL);
    //@ assert missing: status == PTC_E_INPUT;
    status = stage48_disturbance(NULL, &d);
    //@ assert missing: status == PTC_E_INPUT;
    status = stage48_disturbance(self, NULL);
    //@ assert missing: status == PTC_E_INPUT;
    stage48_eva_untouched(self);
    y[0] = 0.0;
    y[0] = NAN;
    status = stage48_step(self, k, y, &u);
    //@ assert no_number: status == PTC_E_INPUT;
    y[0] = 0.0;
    stage48_eva_untouched(self);
}
#endif

/* The whole proof of stage48. */
void stage48_eva(void)
{
#ifndef FINITE
    stage48_eva_null();
#endif
    stage48_eva_live(24.0, 2);
}

/* Left out where a program of several proofs has a main of its own. */
#ifndef PTC_EVA_PART
int main(void)
{
    stage48_eva();
    return 0;
}
#endif
