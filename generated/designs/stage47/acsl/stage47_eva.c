/*
 * Proof that stage47.c has no error at run time, with the plug-in Eva of Frama-C. Here are stage47.h,
 * stage47.c and this file, all three written by ptc-codegen emit --acsl. DO NOT EDIT.
 *
 * Any inputs, with NaN, infinities and NULL:
 *   frama-c -eva -eva-slevel 1000 -eva-slevel-merge-after-loop @all -eva-split-return full -eva-subdivide-non-linear 20 -eva-domains equality -warn-special-float none stage47_eva.c stage47.c
 * Finite inputs, and no value on the way may overflow or be NaN:
 *   frama-c -cpp-extra-args=-DFINITE -eva -eva-slevel 1000 -eva-slevel-merge-after-loop @all -eva-split-return full -eva-subdivide-non-linear 20 -eva-domains equality -warn-special-float non-finite stage47_eva.c stage47.c
 *
 * It is proved where no line begins with [eva:alarm] and the summary has no property unknown. A call is
 * proved from whatever the calls before it may have left. In finite mode values are drawn from the ranges
 * below; give others with -cpp-extra-args="-DFINITE -D<macro>=<number>".
 */
#include "stage47.h"

#include <math.h>
#include <stddef.h>

#include "__fc_builtin.h"

#ifndef STAGE47_EVA_SAMPLES_MIN
#define STAGE47_EVA_SAMPLES_MIN 23U
#endif
#ifndef STAGE47_EVA_SAMPLES_MAX
#define STAGE47_EVA_SAMPLES_MAX 1000U
#endif
#ifndef STAGE47_EVA_U_MAX_MIN
#define STAGE47_EVA_U_MAX_MIN 10.0
#endif
#ifndef STAGE47_EVA_U_MAX_MAX
#define STAGE47_EVA_U_MAX_MAX 10.0
#endif
/* Bounds of what is measured, and of the fields that calls change. */
#ifndef STAGE47_EVA_Y1_MAX
#define STAGE47_EVA_Y1_MAX 10.0
#endif
#ifndef STAGE47_EVA_Y2_MAX
#define STAGE47_EVA_Y2_MAX 10.0
#endif
#ifndef STAGE47_EVA_U1_MAX
#define STAGE47_EVA_U1_MAX 10.0
#endif
#ifndef STAGE47_EVA_X1_HAT_MAX
#define STAGE47_EVA_X1_HAT_MAX 10.0
#endif
#ifndef STAGE47_EVA_X1_NEXT_MAX
#define STAGE47_EVA_X1_NEXT_MAX 10.0
#endif
#ifndef STAGE47_EVA_X2_HAT_MAX
#define STAGE47_EVA_X2_HAT_MAX 10.0
#endif
#ifndef STAGE47_EVA_X2_NEXT_MAX
#define STAGE47_EVA_X2_NEXT_MAX 10.0
#endif
#ifndef STAGE47_EVA_X3_HAT_MAX
#define STAGE47_EVA_X3_HAT_MAX 10.0
#endif
#ifndef STAGE47_EVA_X3_NEXT_MAX
#define STAGE47_EVA_X3_NEXT_MAX 10.0
#endif
#ifndef STAGE47_EVA_D_HAT_MAX
#define STAGE47_EVA_D_HAT_MAX 10.0
#endif
#ifndef STAGE47_EVA_D_NEXT_MAX
#define STAGE47_EVA_D_NEXT_MAX 10.0
#endif

/* Frama-C leaves the sign of a true isfinite open; the code only asks whether it is 0. */
/*@ ensures \result >= 0; */
extern int __finite(double d);
/*@ ensures \result >= 0; */
extern int __finitef(float f);

static volatile double stage47_eva_source;

/* Any number, or in finite mode one of least to greatest. */
static double stage47_eva_draw(double least, double greatest)
{
#ifdef FINITE
    return Frama_C_double_interval(least, greatest);
#else
    (void)least;
    (void)greatest;
    return stage47_eva_source;
#endif
}

/* The same, but at the levels above 0 finite: Eva takes NaN to both sides of a comparison, so that it does
 * not see that one refuses it. */
static double stage47_eva_number(int level, double least, double greatest)
{
    const double v = stage47_eva_draw(least, greatest);

    return ((level > 0) && (isfinite(v) == 0)) ? greatest : v;
}

static uint32_t stage47_eva_count(uint32_t least, uint32_t greatest)
{
    return (uint32_t)Frama_C_unsigned_int_interval(least, greatest);
}

/* Any tick. */
static uint32_t stage47_eva_tick(void)
{
    return stage47_eva_count(0U, 4294967295U);
}

/* Fields that nothing has set. */
static void stage47_eva_blank(stage47 *self)
{
    self->start = 42U;
    self->samples = 42U;
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
    self->u_max = 42.0;
}

static void stage47_eva_untouched(const stage47 *self)
{
    (void)self;
    //@ assert untouched: self->start == 42;
    //@ assert untouched: self->samples == 42;
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
    //@ assert untouched: self->u_max == 42.0;
}

/* What calls may leave, and more. */
static void stage47_eva_kept(stage47 *self)
{
    self->start = stage47_eva_tick();
    self->u1 = stage47_eva_draw(-STAGE47_EVA_U1_MAX, STAGE47_EVA_U1_MAX);
    self->seen = stage47_eva_count(0U, 1U);
    self->x1_hat = stage47_eva_draw(-STAGE47_EVA_X1_HAT_MAX, STAGE47_EVA_X1_HAT_MAX);
    self->x1_next = stage47_eva_draw(-STAGE47_EVA_X1_NEXT_MAX, STAGE47_EVA_X1_NEXT_MAX);
    self->x2_hat = stage47_eva_draw(-STAGE47_EVA_X2_HAT_MAX, STAGE47_EVA_X2_HAT_MAX);
    self->x2_next = stage47_eva_draw(-STAGE47_EVA_X2_NEXT_MAX, STAGE47_EVA_X2_NEXT_MAX);
    self->x3_hat = stage47_eva_draw(-STAGE47_EVA_X3_HAT_MAX, STAGE47_EVA_X3_HAT_MAX);
    self->x3_next = stage47_eva_draw(-STAGE47_EVA_X3_NEXT_MAX, STAGE47_EVA_X3_NEXT_MAX);
    self->d_hat = stage47_eva_draw(-STAGE47_EVA_D_HAT_MAX, STAGE47_EVA_D_HAT_MAX);
    self->d_next = stage47_eva_draw(-STAGE47_EVA_D_NEXT_MAX, STAGE47_EVA_D_NEXT_MAX);
}

/* A call at any tick, and the estimates behind it: a status, with u = 0 where it is negative; at level 1 that
 * u is finite, at 2 its bound. */
static void stage47_eva_use(stage47 *self, double limit, int level)
{
    const uint32_t k = stage47_eva_tick();
    double y[2];
    ptc_status status;
    double u;
    double xhat[3];
    double d;

    (void)limit;
    (void)level;
    y[0] = stage47_eva_draw(-STAGE47_EVA_Y1_MAX, STAGE47_EVA_Y1_MAX);
    y[1] = stage47_eva_draw(-STAGE47_EVA_Y2_MAX, STAGE47_EVA_Y2_MAX);
    status = stage47_step(self, k, y, &u);
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
    status = stage47_estimate(self, xhat);
    //@ assert given: status == PTC_OK;
    status = stage47_disturbance(self, &d);
    //@ assert given: status == PTC_OK;
    //@ assert initialized: \initialized(xhat + (0 .. 2));
    //@ assert initialized: \initialized(&d);
}

/* init and the first call, then arm and any call. */
static void stage47_eva_live(double limit, int level)
{
    stage47_params params;
    stage47 own;
    stage47 *const self = &own;
    ptc_status status;

    params.u_max = limit;
    params.samples = stage47_eva_count(STAGE47_EVA_SAMPLES_MIN, STAGE47_EVA_SAMPLES_MAX);
    stage47_eva_blank(self);
    status = stage47_init(self, &params);
    if (status == PTC_OK) {
        stage47_eva_use(self, limit, level);
        status = stage47_arm(self, stage47_eva_tick());
        //@ assert armed: status == PTC_OK;
        stage47_eva_kept(self);
        stage47_eva_use(self, limit, level);
    } else {
        //@ assert refused: status == PTC_E_PARAM;
        stage47_eva_untouched(self);
#ifdef FINITE
        //@ assert started: \false;
#endif
    }
}

#ifndef FINITE
/* NULL for every pointer that is checked, and no number for every input. */
static void stage47_eva_null(void)
{
    stage47_params params;
    stage47 own;
    stage47 *const self = &own;
    ptc_status status;
    const uint32_t k = stage47_eva_tick();
    double y[2];
    double u;
    double xhat[3];
    double d;

    params.u_max = stage47_eva_draw(0.0, 0.0);
    params.samples = stage47_eva_tick();
    stage47_eva_blank(self);
    status = stage47_init(NULL, &params);
    //@ assert no_self: status == PTC_E_PARAM;
    status = stage47_init(self, NULL);
    //@ assert no_params: status == PTC_E_PARAM;
    stage47_eva_untouched(self);
    y[0] = stage47_eva_draw(0.0, 0.0);
    y[1] = stage47_eva_draw(0.0, 0.0);
    status = stage47_arm(NULL, k);
    //@ assert missing: status == PTC_E_INPUT;
    status = stage47_step(NULL, k, y, &u);
    //@ assert missing: status == PTC_E_INPUT;
    //@ assert zero: u == 0.0;
    status = stage47_step(self, k, NULL, &u);
    //@ assert missing: status == PTC_E_INPUT;
    //@ assert zero: u == 0.0;
    status = stage47_step(self, k, y, NULL);
    //@ assert missing: status == PTC_E_INPUT;
    status = stage47_estimate(NULL, xhat);
    //@ assert missing: status == PTC_E_INPUT;
    status = stage47_estimate(self, NULL);
    //@ assert missing: status == PTC_E_INPUT;
    status = stage47_disturbance(NULL, &d);
    //@ assert missing: status == PTC_E_INPUT;
    status = stage47_disturbance(self, NULL);
    //@ assert missing: status == PTC_E_INPUT;
    stage47_eva_untouched(self);
    y[0] = 0.0;
    y[1] = 0.0;
    y[0] = NAN;
    status = stage47_step(self, k, y, &u);
    //@ assert no_number: status == PTC_E_INPUT;
    y[0] = 0.0;
    y[1] = NAN;
    status = stage47_step(self, k, y, &u);
    //@ assert no_number: status == PTC_E_INPUT;
    y[1] = 0.0;
    stage47_eva_untouched(self);
}
#endif

/* The whole proof of stage47. */
void stage47_eva(void)
{
#ifndef FINITE
    stage47_eva_null();
    stage47_eva_live(stage47_eva_draw(0.0, 0.0), 0);
    stage47_eva_live(stage47_eva_number(1, 0.0, 1.0), 1);
#endif
    stage47_eva_live(STAGE47_EVA_U_MAX_MIN, 2);
    if (STAGE47_EVA_U_MAX_MAX > STAGE47_EVA_U_MAX_MIN) {
        stage47_eva_live(STAGE47_EVA_U_MAX_MAX, 2);
    }
}

/* Left out where a program of several proofs has a main of its own. */
#ifndef PTC_EVA_PART
int main(void)
{
    stage47_eva();
    return 0;
}
#endif
