/*
 * Proof that stage23.c has no error at run time, with the plug-in Eva of Frama-C. Here are stage23.h,
 * stage23.c and this file, all three written by ptc-codegen emit --acsl. DO NOT EDIT.
 *
 * Any inputs, with NaN, infinities and NULL:
 *   frama-c -eva -eva-slevel 1000 -eva-slevel-merge-after-loop @all -eva-split-return full -eva-subdivide-non-linear 20 -eva-domains equality -warn-special-float none stage23_eva.c stage23.c
 * Finite inputs, and no value on the way may overflow or be NaN:
 *   frama-c -cpp-extra-args=-DFINITE -eva -eva-slevel 1000 -eva-slevel-merge-after-loop @all -eva-split-return full -eva-subdivide-non-linear 20 -eva-domains equality -warn-special-float non-finite stage23_eva.c stage23.c
 *
 * It is proved where no line begins with [eva:alarm] and the summary has no property unknown. A call is
 * proved from whatever the calls before it may have left. In finite mode values are drawn from the ranges
 * below; give others with -cpp-extra-args="-DFINITE -D<macro>=<number>".
 */
#include "stage23.h"

#include <math.h>
#include <stddef.h>

#include "__fc_builtin.h"

#ifndef STAGE23_EVA_U_MAX_MIN
#define STAGE23_EVA_U_MAX_MIN 10.0
#endif
#ifndef STAGE23_EVA_U_MAX_MAX
#define STAGE23_EVA_U_MAX_MAX 10.0
#endif
/* Bounds of what is measured, and of the fields that calls change. */
#ifndef STAGE23_EVA_Y1_MAX
#define STAGE23_EVA_Y1_MAX 10.0
#endif
#ifndef STAGE23_EVA_R0_MAX
#define STAGE23_EVA_R0_MAX 10.0
#endif
#ifndef STAGE23_EVA_R1_MAX
#define STAGE23_EVA_R1_MAX 10.0
#endif
#ifndef STAGE23_EVA_R2_MAX
#define STAGE23_EVA_R2_MAX 10.0
#endif
#ifndef STAGE23_EVA_R3_MAX
#define STAGE23_EVA_R3_MAX 10.0
#endif
#ifndef STAGE23_EVA_U1_MAX
#define STAGE23_EVA_U1_MAX 10.0
#endif
#ifndef STAGE23_EVA_U2_MAX
#define STAGE23_EVA_U2_MAX 10.0
#endif
#ifndef STAGE23_EVA_X1_HAT_MAX
#define STAGE23_EVA_X1_HAT_MAX 10.0
#endif
#ifndef STAGE23_EVA_X1_NEXT_MAX
#define STAGE23_EVA_X1_NEXT_MAX 10.0
#endif
#ifndef STAGE23_EVA_X2_HAT_MAX
#define STAGE23_EVA_X2_HAT_MAX 10.0
#endif
#ifndef STAGE23_EVA_X2_NEXT_MAX
#define STAGE23_EVA_X2_NEXT_MAX 10.0
#endif
#ifndef STAGE23_EVA_X3_HAT_MAX
#define STAGE23_EVA_X3_HAT_MAX 10.0
#endif
#ifndef STAGE23_EVA_X3_NEXT_MAX
#define STAGE23_EVA_X3_NEXT_MAX 10.0
#endif
#ifndef STAGE23_EVA_U_R1_MAX
#define STAGE23_EVA_U_R1_MAX 10.0
#endif

/* Frama-C leaves the sign of a true isfinite open; the code only asks whether it is 0. */
/*@ ensures \result >= 0; */
extern int __finite(double d);
/*@ ensures \result >= 0; */
extern int __finitef(float f);

static volatile double stage23_eva_source;

/* Any number, or in finite mode one of least to greatest. */
static double stage23_eva_draw(double least, double greatest)
{
#ifdef FINITE
    return Frama_C_double_interval(least, greatest);
#else
    (void)least;
    (void)greatest;
    return stage23_eva_source;
#endif
}

/* The same, but at the levels above 0 finite: Eva takes NaN to both sides of a comparison, so that it does
 * not see that one refuses it. */
static double stage23_eva_number(int level, double least, double greatest)
{
    const double v = stage23_eva_draw(least, greatest);

    return ((level > 0) && (isfinite(v) == 0)) ? greatest : v;
}

static uint32_t stage23_eva_count(uint32_t least, uint32_t greatest)
{
    return (uint32_t)Frama_C_unsigned_int_interval(least, greatest);
}

/* Any tick. */
static uint32_t stage23_eva_tick(void)
{
    return stage23_eva_count(0U, 4294967295U);
}

/* Fields that nothing has set. */
static void stage23_eva_blank(stage23 *self)
{
    self->start = 42U;
    self->u1 = 42.0;
    self->u2 = 42.0;
    self->seen = 42U;
    self->x1_hat = 42.0;
    self->x1_next = 42.0;
    self->x2_hat = 42.0;
    self->x2_next = 42.0;
    self->x3_hat = 42.0;
    self->x3_next = 42.0;
    self->u_r1 = 42.0;
    self->u_max = 42.0;
}

static void stage23_eva_untouched(const stage23 *self)
{
    (void)self;
    //@ assert untouched: self->start == 42;
    //@ assert untouched: self->u1 == 42.0;
    //@ assert untouched: self->u2 == 42.0;
    //@ assert untouched: self->seen == 42;
    //@ assert untouched: self->x1_hat == 42.0;
    //@ assert untouched: self->x1_next == 42.0;
    //@ assert untouched: self->x2_hat == 42.0;
    //@ assert untouched: self->x2_next == 42.0;
    //@ assert untouched: self->x3_hat == 42.0;
    //@ assert untouched: self->x3_next == 42.0;
    //@ assert untouched: self->u_r1 == 42.0;
    //@ assert untouched: self->u_max == 42.0;
}

/* What calls may leave, and more. */
static void stage23_eva_kept(stage23 *self)
{
    self->start = stage23_eva_tick();
    self->u1 = stage23_eva_draw(-STAGE23_EVA_U1_MAX, STAGE23_EVA_U1_MAX);
    self->u2 = stage23_eva_draw(-STAGE23_EVA_U2_MAX, STAGE23_EVA_U2_MAX);
    self->seen = stage23_eva_count(0U, 1U);
    self->x1_hat = stage23_eva_draw(-STAGE23_EVA_X1_HAT_MAX, STAGE23_EVA_X1_HAT_MAX);
    self->x1_next = stage23_eva_draw(-STAGE23_EVA_X1_NEXT_MAX, STAGE23_EVA_X1_NEXT_MAX);
    self->x2_hat = stage23_eva_draw(-STAGE23_EVA_X2_HAT_MAX, STAGE23_EVA_X2_HAT_MAX);
    self->x2_next = stage23_eva_draw(-STAGE23_EVA_X2_NEXT_MAX, STAGE23_EVA_X2_NEXT_MAX);
    self->x3_hat = stage23_eva_draw(-STAGE23_EVA_X3_HAT_MAX, STAGE23_EVA_X3_HAT_MAX);
    self->x3_next = stage23_eva_draw(-STAGE23_EVA_X3_NEXT_MAX, STAGE23_EVA_X3_NEXT_MAX);
    self->u_r1 = stage23_eva_draw(-STAGE23_EVA_U_R1_MAX, STAGE23_EVA_U_R1_MAX);
}

/* A call at any tick, and the estimates behind it: a status, with u = 0 where it is negative; at level 1 that
 * u is finite, at 2 its bound. */
static void stage23_eva_use(stage23 *self, double limit, int level)
{
    const uint32_t k = stage23_eva_tick();
    double y[1];
    double r[4];
    ptc_status status;
    double u;
    double xhat[3];

    (void)limit;
    (void)level;
    y[0] = stage23_eva_draw(-STAGE23_EVA_Y1_MAX, STAGE23_EVA_Y1_MAX);
    r[0] = stage23_eva_draw(-STAGE23_EVA_R0_MAX, STAGE23_EVA_R0_MAX);
    r[1] = stage23_eva_draw(-STAGE23_EVA_R1_MAX, STAGE23_EVA_R1_MAX);
    r[2] = stage23_eva_draw(-STAGE23_EVA_R2_MAX, STAGE23_EVA_R2_MAX);
    r[3] = stage23_eva_draw(-STAGE23_EVA_R3_MAX, STAGE23_EVA_R3_MAX);
    status = stage23_step(self, k, y, r, &u);
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
    status = stage23_estimate(self, xhat);
    //@ assert given: status == PTC_OK;
    //@ assert initialized: \initialized(xhat + (0 .. 2));
}

/* init and the first call, then arm and any call. */
static void stage23_eva_live(double limit, int level)
{
    stage23_params params;
    stage23 own;
    stage23 *const self = &own;
    ptc_status status;

    params.u_max = limit;
    stage23_eva_blank(self);
    status = stage23_init(self, &params);
    if (status == PTC_OK) {
        stage23_eva_use(self, limit, level);
        status = stage23_arm(self, stage23_eva_tick());
        //@ assert armed: status == PTC_OK;
        stage23_eva_kept(self);
        stage23_eva_use(self, limit, level);
    } else {
        //@ assert refused: status == PTC_E_PARAM;
        stage23_eva_untouched(self);
#ifdef FINITE
        //@ assert started: \false;
#endif
    }
}

#ifndef FINITE
/* NULL for every pointer that is checked, and no number for every input. */
static void stage23_eva_null(void)
{
    stage23_params params;
    stage23 own;
    stage23 *const self = &own;
    ptc_status status;
    const uint32_t k = stage23_eva_tick();
    double y[1];
    double r[4];
    double u;
    double xhat[3];

    params.u_max = stage23_eva_draw(0.0, 0.0);
    stage23_eva_blank(self);
    status = stage23_init(NULL, &params);
    //@ assert no_self: status == PTC_E_PARAM;
    status = stage23_init(self, NULL);
    //@ assert no_params: status == PTC_E_PARAM;
    stage23_eva_untouched(self);
    y[0] = stage23_eva_draw(0.0, 0.0);
    r[0] = stage23_eva_draw(0.0, 0.0);
    r[1] = stage23_eva_draw(0.0, 0.0);
    r[2] = stage23_eva_draw(0.0, 0.0);
    r[3] = stage23_eva_draw(0.0, 0.0);
    status = stage23_arm(NULL, k);
    //@ assert missing: status == PTC_E_INPUT;
    status = stage23_step(NULL, k, y, r, &u);
    //@ assert missing: status == PTC_E_INPUT;
    //@ assert zero: u == 0.0;
    status = stage23_step(self, k, NULL, r, &u);
    //@ assert missing: status == PTC_E_INPUT;
    //@ assert zero: u == 0.0;
    status = stage23_step(self, k, y, NULL, &u);
    //@ assert missing: status == PTC_E_INPUT;
    //@ assert zero: u == 0.0;
    status = stage23_step(self, k, y, r, NULL);
    //@ assert missing: status == PTC_E_INPUT;
    status = stage23_estimate(NULL, xhat);
    //@ assert missing: status == PTC_E_INPUT;
    status = stage23_estimate(self, NULL);
    //@ assert missing: status == PTC_E_INPUT;
    stage23_eva_untouched(self);
    y[0] = 0.0;
    r[0] = 0.0;
    r[1] = 0.0;
    r[2] = 0.0;
    r[3] = 0.0;
    y[0] = NAN;
    status = stage23_step(self, k, y, r, &u);
    //@ assert no_number: status == PTC_E_INPUT;
    y[0] = 0.0;
    r[0] = NAN;
    status = stage23_step(self, k, y, r, &u);
    //@ assert no_number: status == PTC_E_INPUT;
    r[0] = 0.0;
    r[1] = NAN;
    status = stage23_step(self, k, y, r, &u);
    //@ assert no_number: status == PTC_E_INPUT;
    r[1] = 0.0;
    r[2] = NAN;
    status = stage23_step(self, k, y, r, &u);
    //@ assert no_number: status == PTC_E_INPUT;
    r[2] = 0.0;
    r[3] = NAN;
    status = stage23_step(self, k, y, r, &u);
    //@ assert no_number: status == PTC_E_INPUT;
    r[3] = 0.0;
    stage23_eva_untouched(self);
}
#endif

/* The whole proof of stage23. */
void stage23_eva(void)
{
#ifndef FINITE
    stage23_eva_null();
    stage23_eva_live(stage23_eva_draw(0.0, 0.0), 0);
    stage23_eva_live(stage23_eva_number(1, 0.0, 1.0), 1);
#endif
    stage23_eva_live(STAGE23_EVA_U_MAX_MIN, 2);
    if (STAGE23_EVA_U_MAX_MAX > STAGE23_EVA_U_MAX_MIN) {
        stage23_eva_live(STAGE23_EVA_U_MAX_MAX, 2);
    }
}

/* Left out where a program of several proofs has a main of its own. */
#ifndef PTC_EVA_PART
int main(void)
{
    stage23_eva();
    return 0;
}
#endif
