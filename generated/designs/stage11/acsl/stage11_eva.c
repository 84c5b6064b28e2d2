/*
 * Proof that stage11.c has no error at run time, with the plug-in Eva of Frama-C. Here are stage11.h,
 * stage11.c and this file, all three written by ptc-codegen emit --acsl. DO NOT EDIT.
 *
 * Any inputs, with NaN, infinities and NULL:
 *   frama-c -eva -eva-slevel 1000 -eva-slevel-merge-after-loop @all -eva-split-return full -eva-subdivide-non-linear 20 -eva-domains equality -warn-special-float none stage11_eva.c stage11.c
 * Finite inputs, and no value on the way may overflow or be NaN:
 *   frama-c -cpp-extra-args=-DFINITE -eva -eva-slevel 1000 -eva-slevel-merge-after-loop @all -eva-split-return full -eva-subdivide-non-linear 20 -eva-domains equality -warn-special-float non-finite stage11_eva.c stage11.c
 *
 * It is proved where no line begins with [eva:alarm] and the summary has no property unknown. A call is
 * proved from whatever the calls before it may have left. In finite mode values are drawn from the ranges
 * below; give others with -cpp-extra-args="-DFINITE -D<macro>=<number>".
 */
#include "stage11.h"

#include <math.h>
#include <stddef.h>

#include "__fc_builtin.h"

#ifndef STAGE11_EVA_SAMPLES_MIN
#define STAGE11_EVA_SAMPLES_MIN 10U
#endif
#ifndef STAGE11_EVA_SAMPLES_MAX
#define STAGE11_EVA_SAMPLES_MAX 1000U
#endif
#ifndef STAGE11_EVA_U_MAX_MIN
#define STAGE11_EVA_U_MAX_MIN 10.0f
#endif
#ifndef STAGE11_EVA_U_MAX_MAX
#define STAGE11_EVA_U_MAX_MAX 10.0f
#endif
#ifndef STAGE11_EVA_K1_MIN
#define STAGE11_EVA_K1_MIN -100.0f
#endif
#ifndef STAGE11_EVA_K1_MAX
#define STAGE11_EVA_K1_MAX 100.0f
#endif
#ifndef STAGE11_EVA_K2_MIN
#define STAGE11_EVA_K2_MIN -100.0f
#endif
#ifndef STAGE11_EVA_K2_MAX
#define STAGE11_EVA_K2_MAX 100.0f
#endif
#ifndef STAGE11_EVA_K3_MIN
#define STAGE11_EVA_K3_MIN -100.0f
#endif
#ifndef STAGE11_EVA_K3_MAX
#define STAGE11_EVA_K3_MAX 100.0f
#endif
#ifndef STAGE11_EVA_K4_MIN
#define STAGE11_EVA_K4_MIN -100.0f
#endif
#ifndef STAGE11_EVA_K4_MAX
#define STAGE11_EVA_K4_MAX 100.0f
#endif
#ifndef STAGE11_EVA_DEADBEAT_MIN
#define STAGE11_EVA_DEADBEAT_MIN 0.0f
#endif
#ifndef STAGE11_EVA_DEADBEAT_MAX
#define STAGE11_EVA_DEADBEAT_MAX 0.0f
#endif
/* Bounds of what is measured, and of the fields that calls change. */
#ifndef STAGE11_EVA_Y1_MAX
#define STAGE11_EVA_Y1_MAX 10.0f
#endif
#ifndef STAGE11_EVA_U1_MAX
#define STAGE11_EVA_U1_MAX 10.0f
#endif
#ifndef STAGE11_EVA_X1_HAT_MAX
#define STAGE11_EVA_X1_HAT_MAX 10.0f
#endif
#ifndef STAGE11_EVA_X2_HAT_MAX
#define STAGE11_EVA_X2_HAT_MAX 10.0f
#endif
#ifndef STAGE11_EVA_X3_HAT_MAX
#define STAGE11_EVA_X3_HAT_MAX 10.0f
#endif
#ifndef STAGE11_EVA_X4_HAT_MAX
#define STAGE11_EVA_X4_HAT_MAX 10.0f
#endif
#ifndef STAGE11_EVA_D_HAT_MAX
#define STAGE11_EVA_D_HAT_MAX 10.0f
#endif

/* Frama-C leaves the sign of a true isfinite open; the code only asks whether it is 0. */
/*@ ensures \result >= 0; */
extern int __finite(double d);
/*@ ensures \result >= 0; */
extern int __finitef(float f);

static volatile float stage11_eva_source;

/* Any number, or in finite mode one of least to greatest. */
static float stage11_eva_draw(float least, float greatest)
{
#ifdef FINITE
    return Frama_C_float_interval(least, greatest);
#else
    (void)least;
    (void)greatest;
    return stage11_eva_source;
#endif
}

/* The same, but at the levels above 0 finite: Eva takes NaN to both sides of a comparison, so that it does
 * not see that one refuses it. */
static float stage11_eva_number(int level, float least, float greatest)
{
    const float v = stage11_eva_draw(least, greatest);

    return ((level > 0) && (isfinite(v) == 0)) ? greatest : v;
}

static uint32_t stage11_eva_count(uint32_t least, uint32_t greatest)
{
    return (uint32_t)Frama_C_unsigned_int_interval(least, greatest);
}

/* Any tick. */
static uint32_t stage11_eva_tick(void)
{
    return stage11_eva_count(0U, 4294967295U);
}

/* Fields that nothing has set. */
static void stage11_eva_blank(stage11 *self)
{
    self->start = 42U;
    self->samples = 42U;
    self->u1 = 42.0f;
    self->seen = 42U;
    self->x1_hat = 42.0f;
    self->x2_hat = 42.0f;
    self->x3_hat = 42.0f;
    self->x4_hat = 42.0f;
    self->d_hat = 42.0f;
    self->deadbeat = 42.0f;
    self->w1_1 = 42.0f;
    self->w1_2 = 42.0f;
    self->w1_3 = 42.0f;
    self->w1_4 = 42.0f;
    self->w2_2 = 42.0f;
    self->w2_3 = 42.0f;
    self->w2_4 = 42.0f;
    self->w3_3 = 42.0f;
    self->w3_4 = 42.0f;
    self->w4_4 = 42.0f;
    self->u_max = 42.0f;
}

static void stage11_eva_untouched(const stage11 *self)
{
    (void)self;
    //@ assert untouched: self->start == 42;
    //@ assert untouched: self->samples == 42;
    //@ assert untouched: self->u1 == 42.0;
    //@ assert untouched: self->seen == 42;
    //@ assert untouched: self->x1_hat == 42.0;
    //@ assert untouched: self->x2_hat == 42.0;
    //@ assert untouched: self->x3_hat == 42.0;
    //@ assert untouched: self->x4_hat == 42.0;
    //@ assert untouched: self->d_hat == 42.0;
    //@ assert untouched: self->deadbeat == 42.0;
    //@ assert untouched: self->w1_1 == 42.0;
    //@ assert untouched: self->w1_2 == 42.0;
    //@ assert untouched: self->w1_3 == 42.0;
    //@ assert untouched: self->w1_4 == 42.0;
    //@ assert untouched: self->w2_2 == 42.0;
    //@ assert untouched: self->w2_3 == 42.0;
    //@ assert untouched: self->w2_4 == 42.0;
    //@ assert untouched: self->w3_3 == 42.0;
    //@ assert untouched: self->w3_4 == 42.0;
    //@ assert untouched: self->w4_4 == 42.0;
    //@ assert untouched: self->u_max == 42.0;
}

/* What calls may leave, and more. */
static void stage11_eva_kept(stage11 *self)
{
    self->start = stage11_eva_tick();
    self->u1 = stage11_eva_draw(-STAGE11_EVA_U1_MAX, STAGE11_EVA_U1_MAX);
    self->seen = stage11_eva_count(0U, 1U);
    self->x1_hat = stage11_eva_draw(-STAGE11_EVA_X1_HAT_MAX, STAGE11_EVA_X1_HAT_MAX);
    self->x2_hat = stage11_eva_draw(-STAGE11_EVA_X2_HAT_MAX, STAGE11_EVA_X2_HAT_MAX);
    self->x3_hat = stage11_eva_draw(-STAGE11_EVA_X3_HAT_MAX, STAGE11_EVA_X3_HAT_MAX);
    self->x4_hat = stage11_eva_draw(-STAGE11_EVA_X4_HAT_MAX, STAGE11_EVA_X4_HAT_MAX);
    self->d_hat = stage11_eva_draw(-STAGE11_EVA_D_HAT_MAX, STAGE11_EVA_D_HAT_MAX);
}

/* A call at any tick, and the estimates behind it: a status, with u = 0 where it is negative; at level 1 that
 * u is finite, at 2 its bound. */
static void stage11_eva_use(stage11 *self, float limit, int level)
{
    const uint32_t k = stage11_eva_tick();
    float y[1];
    ptc_status status;
    float u;
    float xhat[4];
    float d;

    (void)limit;
    (void)level;
    y[0] = stage11_eva_draw(-STAGE11_EVA_Y1_MAX, STAGE11_EVA_Y1_MAX);
    status = stage11_step(self, k, y, &u);
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
    status = stage11_estimate(self, xhat);
    //@ assert given: status == PTC_OK;
    status = stage11_disturbance(self, &d);
    //@ assert given: status == PTC_OK;
    //@ assert initialized: \initialized(xhat + (0 .. 3));
    //@ assert initialized: \initialized(&d);
}

/* init and the first call, then arm and any call. */
static void stage11_eva_live(float limit, int level)
{
    stage11_params params;
    stage11 own;
    stage11 *const self = &own;
    ptc_status status;

    params.u_max = limit;
    params.samples = stage11_eva_count(STAGE11_EVA_SAMPLES_MIN, STAGE11_EVA_SAMPLES_MAX);
    params.k[0] = stage11_eva_draw(STAGE11_EVA_K1_MIN, STAGE11_EVA_K1_MAX);
    params.k[1] = stage11_eva_draw(STAGE11_EVA_K2_MIN, STAGE11_EVA_K2_MAX);
    params.k[2] = stage11_eva_draw(STAGE11_EVA_K3_MIN, STAGE11_EVA_K3_MAX);
    params.k[3] = stage11_eva_draw(STAGE11_EVA_K4_MIN, STAGE11_EVA_K4_MAX);
    params.deadbeat = stage11_eva_draw(STAGE11_EVA_DEADBEAT_MIN, STAGE11_EVA_DEADBEAT_MAX);
    stage11_eva_blank(self);
    status = stage11_init(self, &params);
    if (status == PTC_OK) {
        stage11_eva_use(self, limit, level);
        status = stage11_arm(self, stage11_eva_tick());
        //@ assert armed: status == PTC_OK;
        stage11_eva_kept(self);
        stage11_eva_use(self, limit, level);
    } else {
        //@ assert refused: status == PTC_E_PARAM;
        stage11_eva_untouched(self);
#ifdef FINITE
        //@ assert started: \false;
#endif
    }
}

#ifndef FINITE
/* NULL for every pointer that is checked, and no number for every input. */
static void stage11_eva_null(void)
{
    stage11_params params;
    stage11 own;
    stage11 *const self = &own;
    ptc_status status;
    const uint32_t k = stage11_eva_tick();
    float y[1];
    float u;
    float xhat[4];
    float d;

    params.u_max = stage11_eva_draw(0.0f, 0.0f);
    params.samples = stage11_eva_tick();
    params.k[0] = stage11_eva_draw(0.0f, 0.0f);
    params.k[1] = stage11_eva_draw(0.0f, 0.0f);
    params.k[2] = stage11_eva_draw(0.0f, 0.0f);
    params.k[3] = stage11_eva_draw(0.0f, 0.0f);
    params.deadbeat = stage11_eva_draw(0.0f, 0.0f);
    stage11_eva_blank(self);
    status = stage11_init(NULL, &params);
    //@ assert no_self: status == PTC_E_PARAM;
    status = stage11_init(self, NULL);
    //@ assert no_params: status == PTC_E_PARAM;
    stage11_eva_untouched(self);
    y[0] = stage11_eva_draw(0.0f, 0.0f);
    status = stage11_arm(NULL, k);
    //@ assert missing: status == PTC_E_INPUT;
    status = stage11_step(NULL, k, y, &u);
    //@ assert missing: status == PTC_E_INPUT;
    //@ assert zero: u == 0.0;
    status = stage11_step(self, k, NULL, &u);
    //@ assert missing: status == PTC_E_INPUT;
    //@ assert zero: u == 0.0;
    status = stage11_step(self, k, y, NULL);
    //@ assert missing: status == PTC_E_INPUT;
    status = stage11_estimate(NULL, xhat);
    //@ assert missing: status == PTC_E_INPUT;
    status = stage11_estimate(self, NULL);
    //@ assert missing: status == PTC_E_INPUT;
    status = stage11_disturbance(NULL, &d);
    //@ assert missing: status == PTC_E_INPUT;
    status = stage11_disturbance(self, NULL);
    //@ assert missing: status == PTC_E_INPUT;
    stage11_eva_untouched(self);
    y[0] = 0.0f;
    y[0] = NAN;
    status = stage11_step(self, k, y, &u);
    //@ assert no_number: status == PTC_E_INPUT;
    y[0] = 0.0f;
    stage11_eva_untouched(self);
}
#endif

/* The whole proof of stage11. */
void stage11_eva(void)
{
#ifndef FINITE
    stage11_eva_null();
    stage11_eva_live(stage11_eva_draw(0.0f, 0.0f), 0);
    stage11_eva_live(stage11_eva_number(1, 0.0f, 1.0f), 1);
#endif
    stage11_eva_live(STAGE11_EVA_U_MAX_MIN, 2);
    if (STAGE11_EVA_U_MAX_MAX > STAGE11_EVA_U_MAX_MIN) {
        stage11_eva_live(STAGE11_EVA_U_MAX_MAX, 2);
    }
}

/* Left out where a program of several proofs has a main of its own. */
#ifndef PTC_EVA_PART
int main(void)
{
    stage11_eva();
    return 0;
}
#endif
