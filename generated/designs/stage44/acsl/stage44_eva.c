/*
 * Proof that stage44.c has no error at run time, with the plug-in Eva of Frama-C. Here are stage44.h,
 * stage44.c and this file, all three written by ptc-codegen emit --acsl. DO NOT EDIT.
 *
 * Any inputs, with NaN, infinities and NULL:
 *   frama-c -eva -eva-slevel 1000 -eva-slevel-merge-after-loop @all -eva-split-return full -eva-subdivide-non-linear 20 -eva-domains equality -warn-special-float none stage44_eva.c stage44.c
 * Finite inputs, and no value on the way may overflow or be NaN:
 *   frama-c -cpp-extra-args=-DFINITE -eva -eva-slevel 1000 -eva-slevel-merge-after-loop @all -eva-split-return full -eva-subdivide-non-linear 20 -eva-domains equality -warn-special-float non-finite stage44_eva.c stage44.c
 *
 * It is proved where no line begins with [eva:alarm] and the summary has no property unknown. A call is
 * proved from whatever the calls before it may have left. In finite mode values are drawn from the ranges
 * below; give others with -cpp-extra-args="-DFINITE -D<macro>=<number>".
 */
#include "stage44.h"

#include <math.h>
#include <stddef.h>

#include "__fc_builtin.h"

#ifndef STAGE44_EVA_SAMPLES_MIN
#define STAGE44_EVA_SAMPLES_MIN 10U
#endif
#ifndef STAGE44_EVA_SAMPLES_MAX
#define STAGE44_EVA_SAMPLES_MAX 1000U
#endif
#ifndef STAGE44_EVA_U_MAX_MIN
#define STAGE44_EVA_U_MAX_MIN 10.0
#endif
#ifndef STAGE44_EVA_U_MAX_MAX
#define STAGE44_EVA_U_MAX_MAX 10.0
#endif
/* Bounds of what is measured, and of the fields that calls change. */
#ifndef STAGE44_EVA_Y1_MAX
#define STAGE44_EVA_Y1_MAX 10.0
#endif
#ifndef STAGE44_EVA_U1_MAX
#define STAGE44_EVA_U1_MAX 10.0
#endif
#ifndef STAGE44_EVA_U2_MAX
#define STAGE44_EVA_U2_MAX 10.0
#endif
#ifndef STAGE44_EVA_U3_MAX
#define STAGE44_EVA_U3_MAX 10.0
#endif
#ifndef STAGE44_EVA_X1_HAT_MAX
#define STAGE44_EVA_X1_HAT_MAX 10.0
#endif
#ifndef STAGE44_EVA_X1_NEXT_MAX
#define STAGE44_EVA_X1_NEXT_MAX 10.0
#endif
#ifndef STAGE44_EVA_X2_HAT_MAX
#define STAGE44_EVA_X2_HAT_MAX 10.0
#endif
#ifndef STAGE44_EVA_X2_NEXT_MAX
#define STAGE44_EVA_X2_NEXT_MAX 10.0
#endif
#ifndef STAGE44_EVA_X3_HAT_MAX
#define STAGE44_EVA_X3_HAT_MAX 10.0
#endif
#ifndef STAGE44_EVA_X3_NEXT_MAX
#define STAGE44_EVA_X3_NEXT_MAX 10.0
#endif

/* Frama-C leaves the sign of a true isfinite open; the code only asks whether it is 0. */
/*@ ensures \result >= 0; */
extern int __finite(double d);
/*@ ensures \result >= 0; */
extern int __finitef(float f);

static volatile double stage44_eva_source;

/* Any number, or in finite mode one of least to greatest. */
static double stage44_eva_draw(double least, double greatest)
{
#ifdef FINITE
    return Frama_C_double_interval(least, greatest);
#else
    (void)least;
    (void)greatest;
    return stage44_eva_source;
#endif
}

/* The same, but at the levels above 0 finite: Eva takes NaN to both sides of a comparison, so that it does
 * not see that one refuses it. */
static double stage44_eva_number(int level, double least, double greatest)
{
    const double v = stage44_eva_draw(least, greatest);

    return ((level > 0) && (isfinite(v) == 0)) ? greatest : v;
}

static uint32_t stage44_eva_count(uint32_t least, uint32_t greatest)
{
    return (uint32_t)Frama_C_unsigned_int_interval(least, greatest);
}

/* Any tick. */
static uint32_t stage44_eva_tick(void)
{
    return stage44_eva_count(0U, 4294967295U);
}

/* Fields that nothing has set. */
static void stage44_eva_blank(stage44 *self)
{
    self->start = 42U;
    self->samples = 42U;
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
    self->u_max = 42.0;
}

static void stage44_eva_untouched(const stage44 *self)
{
    (void)self;
    //@ assert untouched: self->start == 42;
    //@ assert untouched: self->samples == 42;
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
    //@ assert untouched: self->u_max == 42.0;
}

/* What calls may leave, and more. */
static void stage44_eva_kept(stage44 *self)
{
    self->start = stage44_eva_tick();
    self->u1 = stage44_eva_draw(-STAGE44_EVA_U1_MAX, STAGE44_EVA_U1_MAX);
    self->u2 = stage44_eva_draw(-STAGE44_EVA_U2_MAX, STAGE44_EVA_U2_MAX);
    self->u3 = stage44_eva_draw(-STAGE44_EVA_U3_MAX, STAGE44_EVA_U3_MAX);
    self->seen = stage44_eva_count(0U, 1U);
    self->x1_hat = stage44_eva_draw(-STAGE44_EVA_X1_HAT_MAX, STAGE44_EVA_X1_HAT_MAX);
    self->x1_next = stage44_eva_draw(-STAGE44_EVA_X1_NEXT_MAX, STAGE44_EVA_X1_NEXT_MAX);
    self->x2_hat = stage44_eva_draw(-STAGE44_EVA_X2_HAT_MAX, STAGE44_EVA_X2_HAT_MAX);
    self->x2_next = stage44_eva_draw(-STAGE44_EVA_X2_NEXT_MAX, STAGE44_EVA_X2_NEXT_MAX);
    self->x3_hat = stage44_eva_draw(-STAGE44_EVA_X3_HAT_MAX, STAGE44_EVA_X3_HAT_MAX);
    self->x3_next = stage44_eva_draw(-STAGE44_EVA_X3_NEXT_MAX, STAGE44_EVA_X3_NEXT_MAX);
}

/* A call at any tick, and the estimates behind it: a status, with u = 0 where it is negative; at level 1 that
 * u is finite, at 2 its bound. */
static void stage44_eva_use(stage44 *self, double limit, int level)
{
    const uint32_t k = stage44_eva_tick();
    double y[1];
    ptc_status status;
    double u;
    double xhat[3];

    (void)limit;
    (void)level;
    y[0] = stage44_eva_draw(-STAGE44_EVA_Y1_MAX, STAGE44_EVA_Y1_MAX);
    status = stage44_step(self, k, y, &u);
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
    status = stage44_estimate(self, xhat);
    //@ assert given: status == PTC_OK;
    //@ assert initialized: \initialized(xhat + (0 .. 2));
}

/* init and the first call, then arm and any call. */
static void stage44_eva_live(double limit, int level)
{
    stage44_params params;
    stage44 own;
    stage44 *const self = &own;
    ptc_status status;

    params.u_max = limit;
    params.samples = stage44_eva_count(STAGE44_EVA_SAMPLES_MIN, STAGE44_EVA_SAMPLES_MAX);
    stage44_eva_blank(self);
    status = stage44_init(self, &params);
    if (status == PTC_OK) {
        stage44_eva_use(self, limit, level);
        status = stage44_arm(self, stage44_eva_tick());
        //@ assert armed: status == PTC_OK;
        stage44_eva_kept(self);
        stage44_eva_use(self, limit, level);
    } else {
        //@ assert refused: status == PTC_E_PARAM;
        stage44_eva_untouched(self);
#ifdef FINITE
        //@ assert started: \false;
#endif
    }
}

#ifndef FINITE
/* NULL for every pointer that is checked, and no number for every input. */
static void stage44_eva_null(void)
{
    stage44_params params;
    stage44 own;
    stage44 *const self = &own;
    ptc_status status;
    const uint32_t k = stage44_eva_tick();
    double y[1];
    double u;
    double xhat[3];

    params.u_max = stage44_eva_draw(0.0, 0.0);
    params.samples = stage44_eva_tick();
    stage44_eva_blank(self);
    status = stage44_init(NULL, &params);
    //@ assert no_self: status == PTC_E_PARAM;
    status = stage44_init(self, NULL);
    //@ assert no_params: status == PTC_E_PARAM;
    stage44_eva_untouched(self);
    y[0] = stage44_eva_draw(0.0, 0.0);
    status = stage44_arm(NULL, k);
    //@ assert missing: status == PTC_E_INPUT;
    status = stage44_step(NULL, k, y, &u);
    //@ assert missing: status == PTC_E_INPUT;
    //@ assert zero: u == 0.0;
    status = stage44_step(self, k, NULL, &u);
    //@ assert missing: status == PTC_E_INPUT;
    //@ assert zero: u == 0.0;
    status = stage44_step(self, k, y, NULL);
    //@ assert missing: status == PTC_E_INPUT;
    status = stage44_estimate(NULL, xhat);
    //@ assert missing: status == PTC_E_INPUT;
    status = stage44_estimate(self, NULL);
    //@ assert missing: status == PTC_E_INPUT;
    stage44_eva_untouched(self);
    y[0] = 0.0;
    y[0] = NAN;
    status = stage44_step(self, k, y, &u);
    //@ assert no_number: status == PTC_E_INPUT;
    y[0] = 0.0;
    stage44_eva_untouched(self);
}
#endif

/* The whole proof of stage44. */
void stage44_eva(void)
{
#ifndef FINITE
    stage44_eva_null();
    stage44_eva_live(stage44_eva_draw(0.0, 0.0), 0);
    stage44_eva_live(stage44_eva_number(1, 0.0, 1.0), 1);
#endif
    stage44_eva_live(STAGE44_EVA_U_MAX_MIN, 2);
    if (STAGE44_EVA_U_MAX_MAX > STAGE44_EVA_U_MAX_MIN) {
        stage44_eva_live(STAGE44_EVA_U_MAX_MAX, 2);
    }
}

/* Left out where a program of several proofs has a main of its own. */
#ifndef PTC_EVA_PART
int main(void)
{
    stage44_eva();
    return 0;
}
#endif
