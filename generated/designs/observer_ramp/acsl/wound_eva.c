/*
 * Proof that wound.c has no error at run time, with the plug-in Eva of Frama-C. Here are wound.h,
 * wound.c and this file, all three written by ptc-codegen emit --acsl. DO NOT EDIT.
 *
 * Any inputs, with NaN, infinities and NULL:
 *   frama-c -eva -eva-slevel 1000 -eva-slevel-merge-after-loop @all -eva-split-return full -eva-subdivide-non-linear 20 -eva-domains equality -warn-special-float none wound_eva.c wound.c
 * Finite inputs, and no value on the way may overflow or be NaN:
 *   frama-c -cpp-extra-args=-DFINITE -eva -eva-slevel 1000 -eva-slevel-merge-after-loop @all -eva-split-return full -eva-subdivide-non-linear 20 -eva-domains equality -warn-special-float non-finite wound_eva.c wound.c
 *
 * It is proved where no line begins with [eva:alarm] and the summary has no property unknown. A call is
 * proved from whatever the calls before it may have left. In finite mode values are drawn from the ranges
 * below; give others with -cpp-extra-args="-DFINITE -D<macro>=<number>".
 */
#include "wound.h"

#include <math.h>
#include <stddef.h>

#include "__fc_builtin.h"

/* Bounds of what is measured, and of the fields that calls change. */
#ifndef WOUND_EVA_Y1_MAX
#define WOUND_EVA_Y1_MAX 10.0
#endif
#ifndef WOUND_EVA_U1_MAX
#define WOUND_EVA_U1_MAX 10.0
#endif
#ifndef WOUND_EVA_X1_HAT_MAX
#define WOUND_EVA_X1_HAT_MAX 10.0
#endif
#ifndef WOUND_EVA_X1_NEXT_MAX
#define WOUND_EVA_X1_NEXT_MAX 10.0
#endif
#ifndef WOUND_EVA_X2_HAT_MAX
#define WOUND_EVA_X2_HAT_MAX 10.0
#endif
#ifndef WOUND_EVA_X2_NEXT_MAX
#define WOUND_EVA_X2_NEXT_MAX 10.0
#endif
#ifndef WOUND_EVA_D_HAT_MAX
#define WOUND_EVA_D_HAT_MAX 10.0
#endif
#ifndef WOUND_EVA_D_NEXT_MAX
#define WOUND_EVA_D_NEXT_MAX 10.0
#endif
#ifndef WOUND_EVA_D_RATE_HAT_MAX
#define WOUND_EVA_D_RATE_HAT_MAX 10.0
#endif
#ifndef WOUND_EVA_D_RATE_NEXT_MAX
#define WOUND_EVA_D_RATE_NEXT_MAX 10.0
#endif

/* Frama-C leaves the sign of a true isfinite open; the code only asks whether it is 0. */
/*@ ensures \result >= 0; */
extern int __finite(double d);
/*@ ensures \result >= 0; */
extern int __finitef(float f);

static volatile double wound_eva_source;

/* Any number, or in finite mode one of least to greatest. */
static double wound_eva_draw(double least, double greatest)
{
#ifdef FINITE
    return Frama_C_double_interval(least, greatest);
#else
    (void)least;
    (void)greatest;
    return wound_eva_source;
#endif
}

static uint32_t wound_eva_count(uint32_t least, uint32_t greatest)
{
    return (uint32_t)Frama_C_unsigned_int_interval(least, greatest);
}

/* Any tick. */
static uint32_t wound_eva_tick(void)
{
    return wound_eva_count(0U, 4294967295U);
}

/* Fields that nothing has set. */
static void wound_eva_blank(wound *self)
{
    self->start = 42U;
    self->u1 = 42.0;
    self->seen = 42U;
    self->x1_hat = 42.0;
    self->x1_next = 42.0;
    self->x2_hat = 42.0;
    self->x2_next = 42.0;
    self->d_hat = 42.0;
    self->d_next = 42.0;
    self->d_rate_hat = 42.0;
    self->d_rate_next = 42.0;
}

static void wound_eva_untouched(const wound *self)
{
    (void)self;
    //@ assert untouched: self->start == 42;
    //@ assert untouched: self->u1 == 42.0;
    //@ assert untouched: self->seen == 42;
    //@ assert untouched: self->x1_hat == 42.0;
    //@ assert untouched: self->x1_next == 42.0;
    //@ assert untouched: self->x2_hat == 42.0;
    //@ assert untouched: self->x2_next == 42.0;
    //@ assert untouched: self->d_hat == 42.0;
    //@ assert untouched: self->d_next == 42.0;
    //@ assert untouched: self->d_rate_hat == 42.0;
    //@ assert untouched: self->d_rate_next == 42.0;
}

/* What calls may leave, and more. */
static void wound_eva_kept(wound *self)
{
    self->start = wound_eva_tick();
    self->u1 = wound_eva_draw(-WOUND_EVA_U1_MAX, WOUND_EVA_U1_MAX);
    self->seen = wound_eva_count(0U, 1U);
    self->x1_hat = wound_eva_draw(-WOUND_EVA_X1_HAT_MAX, WOUND_EVA_X1_HAT_MAX);
    self->x1_next = wound_eva_draw(-WOUND_EVA_X1_NEXT_MAX, WOUND_EVA_X1_NEXT_MAX);
    self->x2_hat = wound_eva_draw(-WOUND_EVA_X2_HAT_MAX, WOUND_EVA_X2_HAT_MAX);
    self->x2_next = wound_eva_draw(-WOUND_EVA_X2_NEXT_MAX, WOUND_EVA_X2_NEXT_MAX);
    self->d_hat = wound_eva_draw(-WOUND_EVA_D_HAT_MAX, WOUND_EVA_D_HAT_MAX);
    self->d_next = wound_eva_draw(-WOUND_EVA_D_NEXT_MAX, WOUND_EVA_D_NEXT_MAX);
    self->d_rate_hat = wound_eva_draw(-WOUND_EVA_D_RATE_HAT_MAX, WOUND_EVA_D_RATE_HAT_MAX);
    self->d_rate_next = wound_eva_draw(-WOUND_EVA_D_RATE_NEXT_MAX, WOUND_EVA_D_RATE_NEXT_MAX);
}

/* A call at any tick, and the estimates behind it: a status, with u = 0 where it is negative; at level 1 that
 * u is finite, at 2 its bound. */
static void wound_eva_use(wound *self, double limit, int level)
{
    const uint32_t k = wound_eva_tick();
    double y[1];
    ptc_status status;
    double u;
    double xhat[2];
    double d;

    (void)limit;
    (void)level;
    y[0] = wound_eva_draw(-WOUND_EVA_Y1_MAX, WOUND_EVA_Y1_MAX);
    status = wound_step(self, k, y, &u);
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
    status = wound_estimate(self, xhat);
    //@ assert given: status == PTC_OK;
    status = wound_disturbance(self, &d);
    //@ assert given: status == PTC_OK;
    //@ assert initialized: \initialized(xhat + (0 .. 1));
    //@ assert initialized: \initialized(&d);
}

/* init and the first call, then arm and any call. */
static void wound_eva_live(double limit, int level)
{
    wound_params params;
    wound own;
    wound *const self = &own;
    ptc_status status;

    params.none = 0;
    wound_eva_blank(self);
    status = wound_init(self, &params);
    if (status == PTC_OK) {
        wound_eva_use(self, limit, level);
        status = wound_arm(self, wound_eva_tick());
        //@ assert armed: status == PTC_OK;
        wound_eva_kept(self);
        wound_eva_use(self, limit, level);
    } else {
        //@ assert refused: status == PTC_E_PARAM;
        wound_eva_untouched(self);
#ifdef FINITE
        //@ assert started: \false;
#endif
    }
}

#ifndef FINITE
/* NULL for every pointer that is checked, and no number for every input. */
static void wound_eva_null(void)
{
    wound_params params;
    wound own;
    wound *const self = &own;
    ptc_status status;
    const uint32_t k = wound_eva_tick();
    double y[1];
    double u;
    double xhat[2];
    double d;

    params.none = 0;
    wound_eva_blank(self);
    status = wound_init(NULL, &params);
    //@ assert no_self: status == PTC_E_PARAM;
    y[0] = wound_eva_draw(0.0, 0.0);
    status = wound_arm(NULL, k);
    //@ assert missing: status == PTC_E_INPUT;
    status = wound_step(NULL, k, y, &u);
    //@ assert missing: status == PTC_E_INPUT;
    //@ assert zero: u == 0.0;
    status = wound_step(self, k, NULL, &u);
    //@ assert missing: status == PTC_E_INPUT;
    //@ assert zero: u == 0.0;
    status = wound_step(self, k, y, NULL);
    //@ assert missing: status == PTC_E_INPUT;
    status = wound_estimate(NULL, xhat);
    //@ assert missing: status == PTC_E_INPUT;
    status = wound_estimate(self, NULL);
    //@ assert missing: status == PTC_E_INPUT;
    status = wound_disturbance(NULL, &d);
    //@ assert missing: status == PTC_E_INPUT;
    status = wound_disturbance(self, NULL);
    //@ assert missing: status == PTC_E_INPUT;
    wound_eva_untouched(self);
    y[0] = 0.0;
    y[0] = NAN;
    status = wound_step(self, k, y, &u);
    //@ assert no_number: status == PTC_E_INPUT;
    y[0] = 0.0;
    wound_eva_untouched(self);
}
#endif

/* The whole proof of wound. */
void wound_eva(void)
{
#ifndef FINITE
    wound_eva_null();
#endif
    wound_eva_live(10.0, 2);
}

/* Left out where a program of several proofs has a main of its own. */
#ifndef PTC_EVA_PART
int main(void)
{
    wound_eva();
    return 0;
}
#endif
