/*
 * Proof that stage12.c has no error at run time, with the plug-in Eva of Frama-C. Here are stage12.h,
 * stage12.c and this file, all three written by ptc-codegen emit --acsl. DO NOT EDIT.
 *
 * Any inputs, with NaN, infinities and NULL:
 *   frama-c -eva -eva-slevel 1000 -eva-slevel-merge-after-loop @all -eva-split-return full -eva-subdivide-non-linear 20 -eva-domains equality -warn-special-float none stage12_eva.c stage12.c
 * Finite inputs, and no value on the way may overflow or be NaN:
 *   frama-c -cpp-extra-args=-DFINITE -eva -eva-slevel 1000 -eva-slevel-merge-after-loop @all -eva-split-return full -eva-subdivide-non-linear 20 -eva-domains equality -warn-special-float non-finite stage12_eva.c stage12.c
 *
 * It is proved where no line begins with [eva:alarm] and the summary has no property unknown. A call is
 * proved from whatever the calls before it may have left. In finite mode values are drawn from the ranges
 * below; give others with -cpp-extra-args="-DFINITE -D<macro>=<number>".
 */
#include "stage12.h"

#include <math.h>
#include <stddef.h>

#include "__fc_builtin.h"

#ifndef STAGE12_EVA_SAMPLES_MIN
#define STAGE12_EVA_SAMPLES_MIN 8U
#endif
#ifndef STAGE12_EVA_SAMPLES_MAX
#define STAGE12_EVA_SAMPLES_MAX 1000U
#endif
#ifndef STAGE12_EVA_U_MAX_MIN
#define STAGE12_EVA_U_MAX_MIN 10.0
#endif
#ifndef STAGE12_EVA_U_MAX_MAX
#define STAGE12_EVA_U_MAX_MAX 10.0
#endif
#ifndef STAGE12_EVA_K1_MIN
#define STAGE12_EVA_K1_MIN -100.0
#endif
#ifndef STAGE12_EVA_K1_MAX
#define STAGE12_EVA_K1_MAX 100.0
#endif
#ifndef STAGE12_EVA_K2_MIN
#define STAGE12_EVA_K2_MIN -100.0
#endif
#ifndef STAGE12_EVA_K2_MAX
#define STAGE12_EVA_K2_MAX 100.0
#endif
#ifndef STAGE12_EVA_K3_MIN
#define STAGE12_EVA_K3_MIN -100.0
#endif
#ifndef STAGE12_EVA_K3_MAX
#define STAGE12_EVA_K3_MAX 100.0
#endif
#ifndef STAGE12_EVA_K4_MIN
#define STAGE12_EVA_K4_MIN -100.0
#endif
#ifndef STAGE12_EVA_K4_MAX
#define STAGE12_EVA_K4_MAX 100.0
#endif
#ifndef STAGE12_EVA_DEADBEAT_MIN
#define STAGE12_EVA_DEADBEAT_MIN 0.0
#endif
#ifndef STAGE12_EVA_DEADBEAT_MAX
#define STAGE12_EVA_DEADBEAT_MAX 0.0
#endif
/* Bounds of what is measured, and of the fields that calls change. */
#ifndef STAGE12_EVA_Y1_MAX
#define STAGE12_EVA_Y1_MAX 10.0
#endif
#ifndef STAGE12_EVA_Y2_MAX
#define STAGE12_EVA_Y2_MAX 10.0
#endif
#ifndef STAGE12_EVA_U1_MAX
#define STAGE12_EVA_U1_MAX 10.0
#endif
#ifndef STAGE12_EVA_U2_MAX
#define STAGE12_EVA_U2_MAX 10.0
#endif
#ifndef STAGE12_EVA_X1_HAT_MAX
#define STAGE12_EVA_X1_HAT_MAX 10.0
#endif
#ifndef STAGE12_EVA_X1_NEXT_MAX
#define STAGE12_EVA_X1_NEXT_MAX 10.0
#endif
#ifndef STAGE12_EVA_X2_HAT_MAX
#define STAGE12_EVA_X2_HAT_MAX 10.0
#endif
#ifndef STAGE12_EVA_X2_NEXT_MAX
#define STAGE12_EVA_X2_NEXT_MAX 10.0
#endif
#ifndef STAGE12_EVA_X3_HAT_MAX
#define STAGE12_EVA_X3_HAT_MAX 10.0
#endif
#ifndef STAGE12_EVA_X3_NEXT_MAX
#define STAGE12_EVA_X3_NEXT_MAX 10.0
#endif
#ifndef STAGE12_EVA_D_HAT_MAX
#define STAGE12_EVA_D_HAT_MAX 10.0
#endif
#ifndef STAGE12_EVA_D_NEXT_MAX
#define STAGE12_EVA_D_NEXT_MAX 10.0
#endif

/* Frama-C leaves the sign of a true isfinite open; the code only asks whether it is 0. */
/*@ ensures \result >= 0; */
extern int __finite(double d);
/*@ ensures \result >= 0; */
extern int __finitef(float f);

static volatile double stage12_eva_source;

/* Any number, or in finite mode one of least to greatest. */
static double stage12_eva_draw(double least, double greatest)
{
#ifdef FINITE
    return Frama_C_double_interval(least, greatest);
#else
    (void)least;
    (void)greatest;
    return stage12_eva_source;
#endif
}

/* The same, but at the levels above 0 finite: Eva takes NaN to both sides of a comparison, so that it does
 * not see that one refuses it. */
static double stage12_eva_number(int level, double least, double greatest)
{
    const double v = stage12_eva_draw(least, greatest);

    return ((level > 0) && (isfinite(v) == 0)) ? greatest : v;
}

static uint32_t stage12_eva_count(uint32_t least, uint32_t greatest)
{
    return (uint32_t)Frama_C_unsigned_int_interval(least, greatest);
}

/* Any tick. */
static uint32_t stage12_eva_tick(void)
{
    return stage12_eva_count(0U, 4294967295U);
}

/* Fields that nothing has set. */
static void stage12_eva_blank(stage12 *self)
{
    self->start = 42U;
    self->samples = 42U;
    self->u1 = 42.0;
    self->u2 = 42.0;
    self->seen = 42U;
    self->x1_hat = 42.0;
    self->x1_next = 42.0;
    self->x2_hat = 42.0;
    self->x2_next = 42.0;
    self->x3_hat = 42.0;
    self->x3_next = 42.0;
    self->d_hat = 42.0;
    self->d_next = 42.0;
    self->deadbeat = 42.0;
    self->w1_1 = 42.0;
    self->w1_2 = 42.0;
    self->w1_3 = 42.0;
    self->w2_2 = 42.0;
    self->w2_3 = 42.0;
    self->w3_2 = 42.0;
    self->w3_3 = 42.0;
    self->w4_2 = 42.0;
    self->w4_3 = 42.0;
    self->w4_4 = 42.0;
    self->u_max = 42.0;
}

static void stage12_eva_untouched(const stage12 *self)
{
    (void)self;
    //@ assert untouched: self->start == 42;
    //@ assert untouched: self->samples == 42;
    //@ assert untouched: self->u1 == 42.0;
    //@ assert untouched: self->u2 == 42.0;
    //@ assert untouched: self->seen == 42;
    //@ assert untouched: self->x1_hat == 42.0;
    //@ assert untouched: self->x1_next == 42.0;
    //@ assert untouched: self->x2_hat == 42.0;
    //@ assert untouched: self->x2_next == 42.0;
    //@ assert untouched: self->x3_hat == 42.0;
    //@ assert untouched: self->x3_next == 42.0;
    //@ assert untouched: self->d_hat == 42.0;
    //@ assert untouched: self->d_next == 42.0;
    //@ assert untouched: self->deadbeat == 42.0;
    //@ assert untouched: self->w1_1 == 42.0;
    //@ assert untouched: self->w1_2 == 42.0;
    //@ assert untouched: self->w1_3 == 42.0;
    //@ assert untouched: self->w2_2 == 42.0;
    //@ assert untouched: self->w2_3 == 42.0;
    //@ assert untouched: self->w3_2 == 42.0;
    //@ assert untouched: self->w3_3 == 42.0;
    //@ assert untouched: self->w4_2 == 42.0;
    //@ assert untouched: self->w4_3 == 42.0;
    //@ assert untouched: self->w4_4 == 42.0;
    //@ assert untouched: self->u_max == 42.0;
}

/* What calls may leave, and more. */
static void stage12_eva_kept(stage12 *self)
{
    self->start = stage12_eva_tick();
    self->u1 = stage12_eva_draw(-STAGE12_EVA_U1_MAX, STAGE12_EVA_U1_MAX);
    self->u2 = stage12_eva_draw(-STAGE12_EVA_U2_MAX, STAGE12_EVA_U2_MAX);
    self->seen = stage12_eva_count(0U, 1U);
    self->x1_hat = stage12_eva_draw(-STAGE12_EVA_X1_HAT_MAX, STAGE12_EVA_X1_HAT_MAX);
    self->x1_next = stage12_eva_draw(-STAGE12_EVA_X1_NEXT_MAX, STAGE12_EVA_X1_NEXT_MAX);
    self->x2_hat = stage12_eva_draw(-STAGE12_EVA_X2_HAT_MAX, STAGE12_EVA_X2_HAT_MAX);
    self->x2_next = stage12_eva_draw(-STAGE12_EVA_X2_NEXT_MAX, STAGE12_EVA_X2_NEXT_MAX);
    self->x3_hat = stage12_eva_draw(-STAGE12_EVA_X3_HAT_MAX, STAGE12_EVA_X3_HAT_MAX);
    self->x3_next = stage12_eva_draw(-STAGE12_EVA_X3_NEXT_MAX, STAGE12_EVA_X3_NEXT_MAX);
    self->d_hat = stage12_eva_draw(-STAGE12_EVA_D_HAT_MAX, STAGE12_EVA_D_HAT_MAX);
    self->d_next = stage12_eva_draw(-STAGE12_EVA_D_NEXT_MAX, STAGE12_EVA_D_NEXT_MAX);
}

/* A call at any tick, and the estimates behind it: a status, with u = 0 where it is negative; at level 1 that
 * u is finite, at 2 its bound. */
static void stage12_eva_use(stage12 *self, double limit, int level)
{
    const uint32_t k = stage12_eva_tick();
    double y[2];
    ptc_status status;
    double u;
    double xhat[3];
    double d;

    (void)limit;
    (void)level;
    y[0] = stage12_eva_draw(-STAGE12_EVA_Y1_MAX, STAGE12_EVA_Y1_MAX);
    y[1] = stage12_eva_draw(-STAGE12_EVA_Y2_MAX, STAGE12_EVA_Y2_MAX);
    status = stage12_step(self, k, y, &u);
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
    status = stage12_estimate(self, xhat);
    //@ assert given: status == PTC_OK;
    status = stage12_disturbance(self, &d);
    //@ assert given: status == PTC_OK;
    //@ assert initialized: \initialized(xhat + (0 .. 2));
    //@ assert initialized: \initialized(&d);
}

/* init and the first call, then arm and any call. */
static void stage12_eva_live(double limit, int level)
{
    stage12_params params;
    stage12 own;
    stage12 *const self = &own;
    ptc_status status;

    params.u_max = limit;
    params.samples = stage12_eva_count(STAGE12_EVA_SAMPLES_MIN, STAGE12_EVA_SAMPLES_MAX);
    params.k[0] = stage12_eva_draw(STAGE12_EVA_K1_MIN, STAGE12_EVA_K1_MAX);
    params.k[1] = stage12_eva_draw(STAGE12_EVA_K2_MIN, STAGE12_EVA_K2_MAX);
    params.k[2] = stage12_eva_draw(STAGE12_EVA_K3_MIN, STAGE12_EVA_K3_MAX);
    params.k[3] = stage12_eva_draw(STAGE12_EVA_K4_MIN, STAGE12_EVA_K4_MAX);
    params.deadbeat = stage12_eva_draw(STAGE12_EVA_DEADBEAT_MIN, STAGE12_EVA_DEADBEAT_MAX);
    stage12_eva_blank(self);
    status = stage12_init(self, &params);
    if (status == PTC_OK) {
        stage12_eva_use(self, limit, level);
        status = stage12_arm(self, stage12_eva_tick());
        //@ assert armed: status == PTC_OK;
        stage12_eva_kept(self);
        stage12_eva_use(self, limit, level);
    } else {
        //@ assert refused: status == PTC_E_PARAM;
        stage12_eva_untouched(self);
#ifdef FINITE
        //@ assert started: \false;
#endif
    }
}

#ifndef FINITE
/* NULL for every pointer that is checked, and no number for every input. */
static void stage12_eva_null(void)
{
    stage12_params params;
    stage12 own;
    stage12 *const self = &own;
    ptc_status status;
    const uint32_t k = stage12_eva_tick();
    double y[2];
    double u;
    double xhat[3];
    double d;

    params.u_max = stage12_eva_draw(0.0, 0.0);
    params.samples = stage12_eva_tick();
    params.k[0] = stage12_eva_draw(0.0, 0.0);
    params.k[1] = stage12_eva_draw(0.0, 0.0);
    params.k[2] = stage12_eva_draw(0.0, 0.0);
    params.k[3] = stage12_eva_draw(0.0, 0.0);
    params.deadbeat = stage12_eva_draw(0.0, 0.0);
    stage12_eva_blank(self);
    status = stage12_init(NULL, &params);
    //@ assert no_self: status == PTC_E_PARAM;
    status = stage12_init(self, NULL);
    //@ assert no_params: status == PTC_E_PARAM;
    stage12_eva_untouched(self);
    y[0] = stage12_eva_draw(0.0, 0.0);
    y[1] = stage12_eva_draw(0.0, 0.0);
    status = stage12_arm(NULL, k);
    //@ assert missing: status == PTC_E_INPUT;
    status = stage12_step(NULL, k, y, &u);
    //@ assert missing: status == PTC_E_INPUT;
    //@ assert zero: u == 0.0;
    status = stage12_step(self, k, NULL, &u);
    //@ assert missing: status == PTC_E_INPUT;
    //@ assert zero: u == 0.0;
    status = stage12_step(self, k, y, NULL);
    //@ assert missing: status == PTC_E_INPUT;
    status = stage12_estimate(NULL, xhat);
    //@ assert missing: status == PTC_E_INPUT;
    status = stage12_estimate(self, NULL);
    //@ assert missing: status == PTC_E_INPUT;
    status = stage12_disturbance(NULL, &d);
    //@ assert missing: status == PTC_E_INPUT;
    status = stage12_disturbance(self, NULL);
    //@ assert missing: status == PTC_E_INPUT;
    stage12_eva_untouched(self);
    y[0] = 0.0;
    y[1] = 0.0;
    y[0] = NAN;
    status = stage12_step(self, k, y, &u);
    //@ assert no_number: status == PTC_E_INPUT;
    y[0] = 0.0;
    y[1] = NAN;
    status = stage12_step(self, k, y, &u);
    //@ assert no_number: status == PTC_E_INPUT;
    y[1] = 0.0;
    stage12_eva_untouched(self);
}
#endif

/* The whole proof of stage12. */
void stage12_eva(void)
{
#ifndef FINITE
    stage12_eva_null();
    stage12_eva_live(stage12_eva_draw(0.0, 0.0), 0);
    stage12_eva_live(stage12_eva_number(1, 0.0, 1.0), 1);
#endif
    stage12_eva_live(STAGE12_EVA_U_MAX_MIN, 2);
    if (STAGE12_EVA_U_MAX_MAX > STAGE12_EVA_U_MAX_MIN) {
        stage12_eva_live(STAGE12_EVA_U_MAX_MAX, 2);
    }
}

/* Left out where a program of several proofs has a main of its own. */
#ifndef PTC_EVA_PART
int main(void)
{
    stage12_eva();
    return 0;
}
#endif
