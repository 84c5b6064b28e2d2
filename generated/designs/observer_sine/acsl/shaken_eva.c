/*
 * Proof that shaken.c has no error at run time, with the plug-in Eva of Frama-C. Here are shaken.h,
 * shaken.c and this file, all three written by ptc-codegen emit --acsl. DO NOT EDIT.
 *
 * Any inputs, with NaN, infinities and NULL:
 *   frama-c -eva -eva-slevel 1000 -eva-slevel-merge-after-loop @all -eva-split-return full -eva-subdivide-non-linear 20 -eva-domains equality -warn-special-float none shaken_eva.c shaken.c
 * Finite inputs, and no value on the way may overflow or be NaN:
 *   frama-c -cpp-extra-args=-DFINITE -eva -eva-slevel 1000 -eva-slevel-merge-after-loop @all -eva-split-return full -eva-subdivide-non-linear 20 -eva-domains equality -warn-special-float non-finite shaken_eva.c shaken.c
 *
 * It is proved where no line begins with [eva:alarm] and the summary has no property unknown. A call is
 * proved from whatever the calls before it may have left. In finite mode values are drawn from the ranges
 * below; give others with -cpp-extra-args="-DFINITE -D<macro>=<number>".
 */
#include "shaken.h"

#include <math.h>
#include <stddef.h>

#include "__fc_builtin.h"

/* Bounds of what is measured, and of the fields that calls change. */
#ifndef SHAKEN_EVA_Y1_MAX
#define SHAKEN_EVA_Y1_MAX 10.0
#endif
#ifndef SHAKEN_EVA_U1_MAX
#define SHAKEN_EVA_U1_MAX 8.0
#endif
#ifndef SHAKEN_EVA_U2_MAX
#define SHAKEN_EVA_U2_MAX 8.0
#endif
#ifndef SHAKEN_EVA_U3_MAX
#define SHAKEN_EVA_U3_MAX 8.0
#endif
#ifndef SHAKEN_EVA_X1_HAT_MAX
#define SHAKEN_EVA_X1_HAT_MAX 10.0
#endif
#ifndef SHAKEN_EVA_X2_HAT_MAX
#define SHAKEN_EVA_X2_HAT_MAX 10.0
#endif
#ifndef SHAKEN_EVA_D_HAT_MAX
#define SHAKEN_EVA_D_HAT_MAX 10.0
#endif
#ifndef SHAKEN_EVA_D_RATE_HAT_MAX
#define SHAKEN_EVA_D_RATE_HAT_MAX 10.0
#endif

/* Frama-C leaves the sign of a true isfinite open; the code only asks whether it is 0. */
/*@ ensures \result >= 0; */
extern int __finite(double d);
/*@ ensures \result >= 0; */
extern int __finitef(float f);

static volatile double shaken_eva_source;

/* Any number, or in finite mode one of least to greatest. */
static double shaken_eva_draw(double least, double greatest)
{
#ifdef FINITE
    return Frama_C_double_interval(least, greatest);
#else
    (void)least;
    (void)greatest;
    return shaken_eva_source;
#endif
}

static uint32_t shaken_eva_count(uint32_t least, uint32_t greatest)
{
    return (uint32_t)Frama_C_unsigned_int_interval(least, greatest);
}

/* Any tick. */
static uint32_t shaken_eva_tick(void)
{
    return shaken_eva_count(0U, 4294967295U);
}

/* Fields that nothing has set. */
static void shaken_eva_blank(shaken *self)
{
    self->start = 42U;
    self->u1 = 42.0;
    self->u2 = 42.0;
    self->u3 = 42.0;
    self->seen = 42U;
    self->x1_hat = 42.0;
    self->x2_hat = 42.0;
    self->d_hat = 42.0;
    self->d_rate_hat = 42.0;
}

static void shaken_eva_untouched(const shaken *self)
{
    (void)self;
    //@ assert untouched: self->start == 42;
    //@ assert untouched: self->u1 == 42.0;
    //@ assert untouched: self->u2 == 42.0;
    //@ assert untouched: self->u3 == 42.0;
    //@ assert untouched: self->seen == 42;
    //@ assert untouched: self->x1_hat == 42.0;
    //@ assert untouched: self->x2_hat == 42.0;
    //@ assert untouched: self->d_hat == 42.0;
    //@ assert untouched: self->d_rate_hat == 42.0;
}

/* What calls may leave, and more. */
static void shaken_eva_kept(shaken *self)
{
    self->start = shaken_eva_tick();
    self->u1 = shaken_eva_draw(-SHAKEN_EVA_U1_MAX, SHAKEN_EVA_U1_MAX);
    self->u2 = shaken_eva_draw(-SHAKEN_EVA_U2_MAX, SHAKEN_EVA_U2_MAX);
    self->u3 = shaken_eva_draw(-SHAKEN_EVA_U3_MAX, SHAKEN_EVA_U3_MAX);
    self->seen = shaken_eva_count(0U, 1U);
    self->x1_hat = shaken_eva_draw(-SHAKEN_EVA_X1_HAT_MAX, SHAKEN_EVA_X1_HAT_MAX);
    self->x2_hat = shaken_eva_draw(-SHAKEN_EVA_X2_HAT_MAX, SHAKEN_EVA_X2_HAT_MAX);
    self->d_hat = shaken_eva_draw(-SHAKEN_EVA_D_HAT_MAX, SHAKEN_EVA_D_HAT_MAX);
    self->d_rate_hat = shaken_eva_draw(-SHAKEN_EVA_D_RATE_HAT_MAX, SHAKEN_EVA_D_RATE_HAT_MAX);
}

/* A call at any tick, and the estimates behind it: a status, with u = 0 where it is negative; at level 1 that
 * u is finite, at 2 its bound. */
static void shaken_eva_use(shaken *self, double limit, int level)
{
    const uint32_t k = shaken_eva_tick();
    double y[1];
    ptc_status status;
    double u;
    double xhat[2];
    double d;

    (void)limit;
    (void)level;
    y[0] = shaken_eva_draw(-SHAKEN_EVA_Y1_MAX, SHAKEN_EVA_Y1_MAX);
    status = shaken_step(self, k, y, &u);
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
    status = shaken_estimate(self, xhat);
    //@ assert given: status == PTC_OK;
    status = shaken_disturbance(self, &d);
    //@ assert given: status == PTC_OK;
    //@ assert initialized: \initialized(xhat + (0 .. 1));
    //@ assert initialized: \initialized(&d);
}

/* init and the first call, then arm and any call. */
static void shaken_eva_live(double limit, int level)
{
    shaken_params params;
    shaken own;
    shaken *const self = &own;
    ptc_status status;

    params.none = 0;
    shaken_eva_blank(self);
    status = shaken_init(self, &params);
    if (status == PTC_OK) {
        shaken_eva_use(self, limit, level);
        status = shaken_arm(self, shaken_eva_tick());
        //@ assert armed: status == PTC_OK;
        shaken_eva_kept(self);
        shaken_eva_use(self, limit, level);
    } else {
        //@ assert refused: status == PTC_E_PARAM;
        shaken_eva_untouched(self);
#ifdef FINITE
        //@ assert started: \false;
#endif
    }
}

#ifndef FINITE
/* NULL for every pointer that is checked, and no number for every input. */
static void shaken_eva_null(void)
{
    shaken_params params;
    shaken own;
    shaken *const self = &own;
    ptc_status status;
    const uint32_t k = shaken_eva_tick();
    double y[1];
    double u;
    double xhat[2];
    double d;

    params.none = 0;
    shaken_eva_blank(self);
    status = shaken_init(NULL, &params);
    //@ assert no_self: status == PTC_E_PARAM;
    y[0] = shaken_eva_draw(0.0, 0.0);
    status = shaken_arm(NULL, k);
    //@ assert missing: status == PTC_E_INPUT;
    status = shaken_step(NULL, k, y, &u);
    //@ assert missing: status == PTC_E_INPUT;
    //@ assert zero: u == 0.0;
    status = shaken_step(self, k, NULL, &u);
    //@ assert missing: status == PTC_E_INPUT;
    //@ assert zero: u == 0.0;
    status = shaken_step(self, k, y, NULL);
    //@ assert missing: status == PTC_E_INPUT;
    status = shaken_estimate(NULL, xhat);
    //@ assert missing: status == PTC_E_INPUT;
    status = shaken_estimate(self, NULL);
    //@ assert missing: status == PTC_E_INPUT;
    status = shaken_disturbance(NULL, &d);
    //@ assert missing: status == PTC_E_INPUT;
    status = shaken_disturbance(self, NULL);
    //@ assert missing: status == PTC_E_INPUT;
    shaken_eva_untouched(self);
    y[0] = 0.0;
    y[0] = NAN;
    status = shaken_step(self, k, y, &u);
    //@ assert no_number: status == PTC_E_INPUT;
    y[0] = 0.0;
    shaken_eva_untouched(self);
}
#endif

/* The whole proof of shaken. */
void shaken_eva(void)
{
#ifndef FINITE
    shaken_eva_null();
#endif
    shaken_eva_live(8.0, 2);
}

/* Left out where a program of several proofs has a main of its own. */
#ifndef PTC_EVA_PART
int main(void)
{
    shaken_eva();
    return 0;
}
#endif
