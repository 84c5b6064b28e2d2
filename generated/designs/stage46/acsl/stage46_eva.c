/*
 * Proof that stage46.c has no error at run time, with the plug-in Eva of Frama-C. Here are stage46.h,
 * stage46.c and this file, all three written by ptc-codegen emit --acsl. DO NOT EDIT.
 *
 * Any inputs, with NaN, infinities and NULL:
 *   frama-c -eva -eva-slevel 1000 -eva-slevel-merge-after-loop @all -eva-split-return full -eva-subdivide-non-linear 20 -eva-domains equality -warn-special-float none stage46_eva.c stage46.c
 * Finite inputs, and no value on the way may overflow or be NaN:
 *   frama-c -cpp-extra-args=-DFINITE -eva -eva-slevel 1000 -eva-slevel-merge-after-loop @all -eva-split-return full -eva-subdivide-non-linear 20 -eva-domains equality -warn-special-float non-finite stage46_eva.c stage46.c
 *
 * It is proved where no line begins with [eva:alarm] and the summary has no property unknown. A call is
 * proved from whatever the calls before it may have left. In finite mode values are drawn from the ranges
 * below; give others with -cpp-extra-args="-DFINITE -D<macro>=<number>".
 */
#include "stage46.h"

#include <math.h>
#include <stddef.h>

#include "__fc_builtin.h"

/* Bounds of what is measured, and of the fields that calls change. */
#ifndef STAGE46_EVA_Y1_MAX
#define STAGE46_EVA_Y1_MAX 10.0
#endif
#ifndef STAGE46_EVA_U1_MAX
#define STAGE46_EVA_U1_MAX 6.0
#endif
#ifndef STAGE46_EVA_U2_MAX
#define STAGE46_EVA_U2_MAX 6.0
#endif
#ifndef STAGE46_EVA_X1_HAT_MAX
#define STAGE46_EVA_X1_HAT_MAX 10.0
#endif
#ifndef STAGE46_EVA_X2_HAT_MAX
#define STAGE46_EVA_X2_HAT_MAX 10.0
#endif
#ifndef STAGE46_EVA_D_HAT_MAX
#define STAGE46_EVA_D_HAT_MAX 10.0
#endif

/* Frama-C leaves the sign of a true isfinite open; the code only asks whether it is 0. */
/*@ ensures \result >= 0; */
extern int __finite(double d);
/*@ ensures \result >= 0; */
extern int __finitef(float f);

static volatile double stage46_eva_source;

/* Any number, or in finite mode one of least to greatest. */
static double stage46_eva_draw(double least, double greatest)
{
#ifdef FINITE
    return Frama_C_double_interval(least, greatest);
#else
    (void)least;
    (void)greatest;
    return stage46_eva_source;
#endif
}

static uint32_t stage46_eva_count(uint32_t least, uint32_t greatest)
{
    return (uint32_t)Frama_C_unsigned_int_interval(least, greatest);
}

/* Any tick. */
static uint32_t stage46_eva_tick(void)
{
    return stage46_eva_count(0U, 4294967295U);
}

/* Fields that nothing has set. */
static void stage46_eva_blank(stage46 *self)
{
    self->start = 42U;
    self->u1 = 42.0;
    self->u2 = 42.0;
    self->seen = 42U;
    self->x1_hat = 42.0;
    self->x2_hat = 42.0;
    self->d_hat = 42.0;
}

static void stage46_eva_untouched(const stage46 *self)
{
    (void)self;
    //@ assert untouched: self->start == 42;
    //@ assert untouched: self->u1 == 42.0;
    //@ assert untouched: self->u2 == 42.0;
    //@ assert untouched: self->seen == 42;
    //@ assert untouched: self->x1_hat == 42.0;
    //@ assert untouched: self->x2_hat == 42.0;
    //@ assert untouched: self->d_hat == 42.0;
}

/* What calls may leave, and more. */
static void stage46_eva_kept(stage46 *self)
{
    self->start = stage46_eva_tick();
    self->u1 = stage46_eva_draw(-STAGE46_EVA_U1_MAX, STAGE46_EVA_U1_MAX);
    self->u2 = stage46_eva_draw(-STAGE46_EVA_U2_MAX, STAGE46_EVA_U2_MAX);
    self->seen = stage46_eva_count(0U, 1U);
    self->x1_hat = stage46_eva_draw(-STAGE46_EVA_X1_HAT_MAX, STAGE46_EVA_X1_HAT_MAX);
    self->x2_hat = stage46_eva_draw(-STAGE46_EVA_X2_HAT_MAX, STAGE46_EVA_X2_HAT_MAX);
    self->d_hat = stage46_eva_draw(-STAGE46_EVA_D_HAT_MAX, STAGE46_EVA_D_HAT_MAX);
}

/* A call at any tick, and the estimates behind it: a status, with u = 0 where it is negative; at level 1 that
 * u is finite, at 2 its bound. */
static void stage46_eva_use(stage46 *self, double limit, int level)
{
    const uint32_t k = stage46_eva_tick();
    double y[1];
    ptc_status status;
    double u;
    double xhat[2];
    double d;

    (void)limit;
    (void)level;
    y[0] = stage46_eva_draw(-STAGE46_EVA_Y1_MAX, STAGE46_EVA_Y1_MAX);
    status = stage46_step(self, k, y, &u);
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
    status = stage46_estimate(self, xhat);
    //@ assert given: status == PTC_OK;
    status = stage46_disturbance(self, &d);
    //@ assert given: status == PTC_OK;
    //@ assert initialized: \initialized(xhat + (0 .. 1));
    //@ assert initialized: \initialized(&d);
}

/* init and the first call, then arm and any call. */
static void stage46_eva_live(double limit, int level)
{
    stage46_params params;
    stage46 own;
    stage46 *const self = &own;
    ptc_status status;

    params.none = 0;
    stage46_eva_blank(self);
    status = stage46_init(self, &params);
    if (status == PTC_OK) {
        stage46_eva_use(self, limit, level);
        status = stage46_arm(self, stage46_eva_tick());
        //@ assert armed: status == PTC_OK;
        stage46_eva_kept(self);
        stage46_eva_use(self, limit, level);
    } else {
        //@ assert refused: status == PTC_E_PARAM;
        stage46_eva_untouched(self);
#ifdef FINITE
        //@ assert started: \false;
#endif
    }
}

#ifndef FINITE
/* NULL for every pointer that is checked, and no number for every input. */
static void stage46_eva_null(void)
{
    stage46_params params;
    stage46 own;
    stage46 *const self = &own;
    ptc_status status;
    const uint32_t k = stage46_eva_tick();
    double y[1];
    double u;
    double xhat[2];
    double d;

    params.none = 0;
    stage46_eva_blank(self);
    status = stage46_init(NULL, &params);
    //@ assert no_self: status == PTC_E_PARAM;
    y[0] = stage46_eva_draw(0.0, 0.0);
    status = stage46_arm(NULL, k);
    //@ assert missing: status == PTC_E_INPUT;
    status = stage46_step(NULL, k, y, &u);
    //@ assert missing: status == PTC_E_INPUT;
    //@ assert zero: u == 0.0;
    status = stage46_step(self, k, NULL, &u);
    //@ assert missing: status == PTC_E_INPUT;
    //@ assert zero: u == 0.0;
    status = stage46_step(self, k, y, NULL);
    //@ assert missing: status == PTC_E_INPUT;
    status = stage46_estimate(NULL, xhat);
    //@ assert missing: status == PTC_E_INPUT;
    status = stage46_estimate(self, NULL);
    //@ assert missing: status == PTC_E_INPUT;
    status = stage46_disturbance(NULL, &d);
    //@ assert missing: status == PTC_E_INPUT;
    status = stage46_disturbance(self, NULL);
    //@ assert missing: status == PTC_E_INPUT;
    stage46_eva_untouched(self);
    y[0] = 0.0;
    y[0] = NAN;
    status = stage46_step(self, k, y, &u);
    //@ assert no_number: status == PTC_E_INPUT;
    y[0] = 0.0;
    stage46_eva_untouched(self);
}
#endif

/* The whole proof of stage46. */
void stage46_eva(void)
{
#ifndef FINITE
    stage46_eva_null();
#endif
    stage46_eva_live(6.0, 2);
}

/* Left out where a program of several proofs has a main of its own. */
#ifndef PTC_EVA_PART
int main(void)
{
    stage46_eva();
    return 0;
}
#endif
