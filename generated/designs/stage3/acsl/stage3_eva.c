/*
 * Proof that stage3.c has no error at run time, with the plug-in Eva of Frama-C. Here are stage3.h,
 * stage3.c and this file, all three written by ptc-codegen emit --acsl. DO NOT EDIT.
 *
 * Any inputs, with NaN, infinities and NULL:
 *   frama-c -eva -eva-slevel 1000 -eva-slevel-merge-after-loop @all -eva-split-return full -eva-subdivide-non-linear 20 -eva-domains equality -warn-special-float none stage3_eva.c stage3.c
 * Finite inputs, and no value on the way may overflow or be NaN:
 *   frama-c -cpp-extra-args=-DFINITE -eva -eva-slevel 1000 -eva-slevel-merge-after-loop @all -eva-split-return full -eva-subdivide-non-linear 20 -eva-domains equality -warn-special-float non-finite stage3_eva.c stage3.c
 *
 * It is proved where no line begins with [eva:alarm] and the summary has no property unknown. A call is
 * proved from whatever the calls before it may have left. In finite mode values are drawn from the ranges
 * below; give others with -cpp-extra-args="-DFINITE -D<macro>=<number>".
 */
#include "stage3.h"

#include <math.h>
#include <stddef.h>

#include "__fc_builtin.h"

#ifndef STAGE3_EVA_U_MAX_MIN
#define STAGE3_EVA_U_MAX_MIN 10.0
#endif
#ifndef STAGE3_EVA_U_MAX_MAX
#define STAGE3_EVA_U_MAX_MAX 10.0
#endif
/* Bounds of what is measured, and of the fields that calls change. */
#ifndef STAGE3_EVA_Y1_MAX
#define STAGE3_EVA_Y1_MAX 10.0
#endif
#ifndef STAGE3_EVA_U1_MAX
#define STAGE3_EVA_U1_MAX 10.0
#endif
#ifndef STAGE3_EVA_U2_MAX
#define STAGE3_EVA_U2_MAX 10.0
#endif
#ifndef STAGE3_EVA_X1_HAT_MAX
#define STAGE3_EVA_X1_HAT_MAX 10.0
#endif
#ifndef STAGE3_EVA_X2_HAT_MAX
#define STAGE3_EVA_X2_HAT_MAX 10.0
#endif
#ifndef STAGE3_EVA_D_HAT_MAX
#define STAGE3_EVA_D_HAT_MAX 10.0
#endif

/* Frama-C leaves the sign of a true isfinite open; the code only asks whether it is 0. */
/*@ ensures \result >= 0; */
extern int __finite(double d);
/*@ ensures \result >= 0; */
extern int __finitef(float f);

static volatile double stage3_eva_source;

/* Any number, or in finite mode one of least to greatest. */
static double stage3_eva_draw(double least, double greatest)
{
#ifdef FINITE
    return Frama_C_double_interval(least, greatest);
#else
    (void)least;
    (void)greatest;
    return stage3_eva_source;
#endif
}

/* The same, but at the levels above 0 finite: Eva takes NaN to both sides of a comparison, so that it does
 * not see that one refuses it. */
static double stage3_eva_number(int level, double least, double greatest)
{
    const double v = stage3_eva_draw(least, greatest);

    return ((level > 0) && (isfinite(v) == 0)) ? greatest : v;
}

static uint32_t stage3_eva_count(uint32_t least, uint32_t greatest)
{
    return (uint32_t)Frama_C_unsigned_int_interval(least, greatest);
}

/* Any tick. */
static uint32_t stage3_eva_tick(void)
{
    return stage3_eva_count(0U, 4294967295U);
}

/* Fields that nothing has set. */
static void stage3_eva_blank(stage3 *self)
{
    self->start = 42U;
    self->u1 = 42.0;
    self->u2 = 42.0;
    self->seen = 42U;
    self->x1_hat = 42.0;
    self->x2_hat = 42.0;
    self->d_hat = 42.0;
    self->u_max = 42.0;
}

static void stage3_eva_untouched(const stage3 *self)
{
    (void)self;
    //@ assert untouched: self->start == 42;
    //@ assert untouched: self->u1 == 42.0;
    //@ assert untouched: self->u2 == 42.0;
    //@ assert untouched: self->seen == 42;
    //@ assert untouched: self->x1_hat == 42.0;
    //@ assert untouched: self->x2_hat == 42.0;
    //@ assert untouched: self->d_hat == 42.0;
    //@ assert untouched: self->u_max == 42.0;
}

/* What calls may leave, and more. */
static void stage3_eva_kept(stage3 *self)
{
    self->start = stage3_eva_tick();
    self->u1 = stage3_eva_draw(-STAGE3_EVA_U1_MAX, STAGE3_EVA_U1_MAX);
    self->u2 = stage3_eva_draw(-STAGE3_EVA_U2_MAX, STAGE3_EVA_U2_MAX);
    self->seen = stage3_eva_count(0U, 1U);
    self->x1_hat = stage3_eva_draw(-STAGE3_EVA_X1_HAT_MAX, STAGE3_EVA_X1_HAT_MAX);
    self->x2_hat = stage3_eva_draw(-STAGE3_EVA_X2_HAT_MAX, STAGE3_EVA_X2_HAT_MAX);
    self->d_hat = stage3_eva_draw(-STAGE3_EVA_D_HAT_MAX, STAGE3_EVA_D_HAT_MAX);
}

/* A call at any tick, and the estimates behind it: a status, with u = 0 where it is negative; at level 1 that
 * u is finite, at 2 its bound. */
static void stage3_eva_use(stage3 *self, double limit, int level)
{
    const uint32_t k = stage3_eva_tick();
    double y[1];
    ptc_status status;
    double u;
    double xhat[2];
    double d;

    (void)limit;
    (void)level;
    y[0] = stage3_eva_draw(-STAGE3_EVA_Y1_MAX, STAGE3_EVA_Y1_MAX);
    status = stage3_step(self, k, y, &u);
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
    status = stage3_estimate(self, xhat);
    //@ assert given: status == PTC_OK;
    status = stage3_disturbance(self, &d);
    //@ assert given: status == PTC_OK;
    //@ assert initialized: \initialized(xhat + (0 .. 1));
    //@ assert initialized: \initialized(&d);
}

/* init and the first call, then arm and any call. */
static void stage3_eva_live(double limit, int level)
{
    stage3_params params;
    stage3 own;
    stage3 *const self = &own;
    ptc_status status;

    params.u_max = limit;
    stage3_eva_blank(self);
    status = stage3_init(self, &params);
    if (status == PTC_OK) {
        stage3_eva_use(self, limit, level);
        status = stage3_arm(self, stage3_eva_tick());
        //@ assert armed: status == PTC_OK;
        stage3_eva_kept(self);
        stage3_eva_use(self, limit, level);
    } else {
        //@ assert refused: status == PTC_E_PARAM;
        stage3_eva_untouched(self);
#ifdef FINITE
        //@ assert started: \false;
#endif
    }
}

#ifndef FINITE
/* NULL for every pointer that is checked, and no number for every input. */
static void stage3_eva_null(void)
{
    stage3_params params;
    stage3 own;
    stage3 *const self = &own;
    ptc_status status;
    const uint32_t k = stage3_eva_tick();
    double y[1];
    double u;
    double xhat[2];
    double d;

    params.u_max = stage3_eva_draw(0.0, 0.0);
    stage3_eva_blank(self);
    status = stage3_init(NULL, &params);
    //@ assert no_self: status == PTC_E_PARAM;
    status = stage3_init(self, NULL);
    //@ assert no_params: status == PTC_E_PARAM;
    stage3_eva_untouched(self);
    y[0] = stage3_eva_draw(0.0, 0.0);
    status = stage3_arm(NULL, k);
    //@ assert missing: status == PTC_E_INPUT;
    status = stage3_step(NULL, k, y, &u);
    //@ assert missing: status == PTC_E_INPUT;
    //@ assert zero: u == 0.0;
    status = stage3_step(self, k, NULL, &u);
    //@ assert missing: status == PTC_E_INPUT;
    //@ assert zero: u == 0.0;
    status = stage3_step(self, k, y, NULL);
    //@ assert missing: status == PTC_E_INPUT;
    status = stage3_estimate(NULL, xhat);
    //@ assert missing: status == PTC_E_INPUT;
    status = stage3_estimate(self, NULL);
    //@ assert missing: status == PTC_E_INPUT;
    status = stage3_disturbance(NULL, &d);
    //@ assert missing: status == PTC_E_INPUT;
    status = stage3_disturbance(self, NULL);
    //@ assert missing: status == PTC_E_INPUT;
    stage3_eva_untouched(self);
    y[0] = 0.0;
    y[0] = NAN;
    status = stage3_step(self, k, y, &u);
    //@ assert no_number: status == PTC_E_INPUT;
    y[0] = 0.0;
    stage3_eva_untouched(self);
}
#endif

/* The whole proof of stage3. */
void stage3_eva(void)
{
#ifndef FINITE
    stage3_eva_null();
    stage3_eva_live(stage3_eva_draw(0.0, 0.0), 0);
    stage3_eva_live(stage3_eva_number(1, 0.0, 1.0), 1);
#endif
    stage3_eva_live(STAGE3_EVA_U_MAX_MIN, 2);
    if (STAGE3_EVA_U_MAX_MAX > STAGE3_EVA_U_MAX_MIN) {
        stage3_eva_live(STAGE3_EVA_U_MAX_MAX, 2);
    }
}

/* Left out where a program of several proofs has a main of its own. */
#ifndef PTC_EVA_PART
int main(void)
{
    stage3_eva();
    return 0;
}
#endif
