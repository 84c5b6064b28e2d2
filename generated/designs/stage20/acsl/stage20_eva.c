/*
 * Proof that stage20.c has no error at run time, with the plug-in Eva of Frama-C. Here are stage20.h,
 * stage20.c and this file, all three written by ptc-codegen emit --acsl. DO NOT EDIT.
 *
 * Any inputs, with NaN, infinities and NULL:
 *   frama-c -eva -eva-slevel 1000 -eva-slevel-merge-after-loop @all -eva-split-return full -eva-subdivide-non-linear 20 -eva-domains equality -warn-special-float none stage20_eva.c stage20.c
 * Finite inputs, and no value on the way may overflow or be NaN:
 *   frama-c -cpp-extra-args=-DFINITE -eva -eva-slevel 1000 -eva-slevel-merge-after-loop @all -eva-split-return full -eva-subdivide-non-linear 20 -eva-domains equality -warn-special-float non-finite stage20_eva.c stage20.c
 *
 * It is proved where no line begins with [eva:alarm] and the summary has no property unknown. A call is
 * proved from whatever the calls before it may have left. In finite mode values are drawn from the ranges
 * below; give others with -cpp-extra-args="-DFINITE -D<macro>=<number>".
 */
#include "stage20.h"

#include <math.h>
#include <stddef.h>

#include "__fc_builtin.h"

#ifndef STAGE20_EVA_SAMPLES_MIN
#define STAGE20_EVA_SAMPLES_MIN 8U
#endif
#ifndef STAGE20_EVA_SAMPLES_MAX
#define STAGE20_EVA_SAMPLES_MAX 1000U
#endif
#ifndef STAGE20_EVA_H_MIN
#define STAGE20_EVA_H_MIN 0.01
#endif
#ifndef STAGE20_EVA_H_MAX
#define STAGE20_EVA_H_MAX 0.01
#endif
#ifndef STAGE20_EVA_U_MAX_MIN
#define STAGE20_EVA_U_MAX_MIN 10.0
#endif
#ifndef STAGE20_EVA_U_MAX_MAX
#define STAGE20_EVA_U_MAX_MAX 10.0
#endif
#ifndef STAGE20_EVA_K1_MIN
#define STAGE20_EVA_K1_MIN -100.0
#endif
#ifndef STAGE20_EVA_K1_MAX
#define STAGE20_EVA_K1_MAX 100.0
#endif
#ifndef STAGE20_EVA_K2_MIN
#define STAGE20_EVA_K2_MIN -100.0
#endif
#ifndef STAGE20_EVA_K2_MAX
#define STAGE20_EVA_K2_MAX 100.0
#endif
#ifndef STAGE20_EVA_K3_MIN
#define STAGE20_EVA_K3_MIN -100.0
#endif
#ifndef STAGE20_EVA_K3_MAX
#define STAGE20_EVA_K3_MAX 100.0
#endif
#ifndef STAGE20_EVA_K4_MIN
#define STAGE20_EVA_K4_MIN -100.0
#endif
#ifndef STAGE20_EVA_K4_MAX
#define STAGE20_EVA_K4_MAX 100.0
#endif
#ifndef STAGE20_EVA_DEADBEAT_MIN
#define STAGE20_EVA_DEADBEAT_MIN 0.0
#endif
#ifndef STAGE20_EVA_DEADBEAT_MAX
#define STAGE20_EVA_DEADBEAT_MAX 0.0
#endif
/* Bounds of what is measured, and of the fields that calls change. */
#ifndef STAGE20_EVA_Y1_MAX
#define STAGE20_EVA_Y1_MAX 10.0
#endif
#ifndef STAGE20_EVA_R0_MAX
#define STAGE20_EVA_R0_MAX 10.0
#endif
#ifndef STAGE20_EVA_R1_MAX
#define STAGE20_EVA_R1_MAX 10.0
#endif
#ifndef STAGE20_EVA_R2_MAX
#define STAGE20_EVA_R2_MAX 10.0
#endif
#ifndef STAGE20_EVA_U1_MAX
#define STAGE20_EVA_U1_MAX 10.0
#endif
#ifndef STAGE20_EVA_U2_MAX
#define STAGE20_EVA_U2_MAX 10.0
#endif
#ifndef STAGE20_EVA_U3_MAX
#define STAGE20_EVA_U3_MAX 10.0
#endif
#ifndef STAGE20_EVA_X1_HAT_MAX
#define STAGE20_EVA_X1_HAT_MAX 10.0
#endif
#ifndef STAGE20_EVA_X2_HAT_MAX
#define STAGE20_EVA_X2_HAT_MAX 10.0
#endif
#ifndef STAGE20_EVA_D_HAT_MAX
#define STAGE20_EVA_D_HAT_MAX 10.0
#endif
#ifndef STAGE20_EVA_RHO1_MAX
#define STAGE20_EVA_RHO1_MAX 10.0
#endif
#ifndef STAGE20_EVA_RHO2_MAX
#define STAGE20_EVA_RHO2_MAX 10.0
#endif

/* Frama-C leaves the sign of a true isfinite open; the code only asks whether it is 0. */
/*@ ensures \result >= 0; */
extern int __finite(double d);
/*@ ensures \result >= 0; */
extern int __finitef(float f);

static volatile double stage20_eva_source;

/* Any number, or in finite mode one of least to greatest. */
static double stage20_eva_draw(double least, double greatest)
{
#ifdef FINITE
    return Frama_C_double_interval(least, greatest);
#else
    (void)least;
    (void)greatest;
    return stage20_eva_source;
#endif
}

/* The same, but at the levels above 0 finite: Eva takes NaN to both sides of a comparison, so that it does
 * not see that one refuses it. */
static double stage20_eva_number(int level, double least, double greatest)
{
    const double v = stage20_eva_draw(least, greatest);

    return ((level > 0) && (isfinite(v) == 0)) ? greatest : v;
}

static uint32_t stage20_eva_count(uint32_t least, uint32_t greatest)
{
    return (uint32_t)Frama_C_unsigned_int_interval(least, greatest);
}

/* Any tick. */
static uint32_t stage20_eva_tick(void)
{
    return stage20_eva_count(0U, 4294967295U);
}

/* Fields that nothing has set. */
static void stage20_eva_blank(stage20 *self)
{
    self->start = 42U;
    self->samples = 42U;
    self->u1 = 42.0;
    self->u2 = 42.0;
    self->u3 = 42.0;
    self->seen = 42U;
    self->x1_hat = 42.0;
    self->x2_hat = 42.0;
    self->d_hat = 42.0;
    self->phi1_2 = 42.0;
    self->phi1_3 = 42.0;
    self->gamma1 = 42.0;
    self->late_gamma1 = 42.0;
    self->phi2_3 = 42.0;
    self->gamma2 = 42.0;
    self->late_gamma2 = 42.0;
    self->q2_1 = 42.0;
    self->q2_2 = 42.0;
    self->q3_1 = 42.0;
    self->e2_2 = 42.0;
    self->e2_3 = 42.0;
    self->e1_2 = 42.0;
    self->e1_3 = 42.0;
    self->e0_2 = 42.0;
    self->e0_3 = 42.0;
    self->rho1 = 42.0;
    self->rho2 = 42.0;
    self->deadbeat = 42.0;
    self->w1_1 = 42.0;
    self->w1_2 = 42.0;
    self->w1_4 = 42.0;
    self->w2_2 = 42.0;
    self->w2_4 = 42.0;
    self->w3_4 = 42.0;
    self->w4_3 = 42.0;
    self->w4_4 = 42.0;
    self->b_1 = 42.0;
    self->b_2 = 42.0;
    self->u_max = 42.0;
}

static void stage20_eva_untouched(const stage20 *self)
{
    (void)self;
    //@ assert untouched: self->start == 42;
    //@ assert untouched: self->samples == 42;
    //@ assert untouched: self->u1 == 42.0;
    //@ assert untouched: self->u2 == 42.0;
    //@ assert untouched: self->u3 == 42.0;
    //@ assert untouched: self->seen == 42;
    //@ assert untouched: self->x1_hat == 42.0;
    //@ assert untouched: self->x2_hat == 42.0;
    //@ assert untouched: self->d_hat == 42.0;
    //@ assert untouched: self->phi1_2 == 42.0;
    //@ assert untouched: self->phi1_3 == 42.0;
    //@ assert untouched: self->gamma1 == 42.0;
    //@ assert untouched: self->late_gamma1 == 42.0;
    //@ assert untouched: self->phi2_3 == 42.0;
    //@ assert untouched: self->gamma2 == 42.0;
    //@ assert untouched: self->late_gamma2 == 42.0;
    //@ assert untouched: self->q2_1 == 42.0;
    //@ assert untouched: self->q2_2 == 42.0;
    //@ assert untouched: self->q3_1 == 42.0;
    //@ assert untouched: self->e2_2 == 42.0;
    //@ assert untouched: self->e2_3 == 42.0;
    //@ assert untouched: self->e1_2 == 42.0;
    //@ assert untouched: self->e1_3 == 42.0;
    //@ assert untouched: self->e0_2 == 42.0;
    //@ assert untouched: self->e0_3 == 42.0;
    //@ assert untouched: self->rho1 == 42.0;
    //@ assert untouched: self->rho2 == 42.0;
    //@ assert untouched: self->deadbeat == 42.0;
    //@ assert untouched: self->w1_1 == 42.0;
    //@ assert untouched: self->w1_2 == 42.0;
    //@ assert untouched: self->w1_4 == 42.0;
    //@ assert untouched: self->w2_2 == 42.0;
    //@ assert untouched: self->w2_4 == 42.0;
    //@ assert untouched: self->w3_4 == 42.0;
    //@ assert untouched: self->w4_3 == 42.0;
    //@ assert untouched: self->w4_4 == 42.0;
    //@ assert untouched: self->b_1 == 42.0;
    //@ assert untouched: self->b_2 == 42.0;
    //@ assert untouched: self->u_max == 42.0;
}

/* What calls may leave, and more. */
static void stage20_eva_kept(stage20 *self)
{
    self->start = stage20_eva_tick();
    self->u1 = stage20_eva_draw(-STAGE20_EVA_U1_MAX, STAGE20_EVA_U1_MAX);
    self->u2 = stage20_eva_draw(-STAGE20_EVA_U2_MAX, STAGE20_EVA_U2_MAX);
    self->u3 = stage20_eva_draw(-STAGE20_EVA_U3_MAX, STAGE20_EVA_U3_MAX);
    self->seen = stage20_eva_count(0U, 1U);
    self->x1_hat = stage20_eva_draw(-STAGE20_EVA_X1_HAT_MAX, STAGE20_EVA_X1_HAT_MAX);
    self->x2_hat = stage20_eva_draw(-STAGE20_EVA_X2_HAT_MAX, STAGE20_EVA_X2_HAT_MAX);
    self->d_hat = stage20_eva_draw(-STAGE20_EVA_D_HAT_MAX, STAGE20_EVA_D_HAT_MAX);
    self->rho1 = stage20_eva_draw(-STAGE20_EVA_RHO1_MAX, STAGE20_EVA_RHO1_MAX);
    self->rho2 = stage20_eva_draw(-STAGE20_EVA_RHO2_MAX, STAGE20_EVA_RHO2_MAX);
}

/* A call at any tick, and the estimates behind it: a status, with u = 0 where it is negative; at level 1 that
 * u is finite, at 2 its bound. */
static void stage20_eva_use(stage20 *self, double limit, int level)
{
    const uint32_t k = stage20_eva_tick();
    double y[1];
    double r[3];
    ptc_status status;
    double u;
    double xhat[2];
    double d;

    (void)limit;
    (void)level;
    y[0] = stage20_eva_draw(-STAGE20_EVA_Y1_MAX, STAGE20_EVA_Y1_MAX);
    r[0] = stage20_eva_draw(-STAGE20_EVA_R0_MAX, STAGE20_EVA_R0_MAX);
    r[1] = stage20_eva_draw(-STAGE20_EVA_R1_MAX, STAGE20_EVA_R1_MAX);
    r[2] = stage20_eva_draw(-STAGE20_EVA_R2_MAX, STAGE20_EVA_R2_MAX);
    status = stage20_step(self, k, y, r, &u);
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
    status = stage20_estimate(self, xhat);
    //@ assert given: status == PTC_OK;
    status = stage20_disturbance(self, &d);
    //@ assert given: status == PTC_OK;
    //@ assert initialized: \initialized(xhat + (0 .. 1));
    //@ assert initialized: \initialized(&d);
}

/* init and the first call, then arm and any call. */
static void stage20_eva_live(double limit, int level)
{
    stage20_params params;
    stage20 own;
    stage20 *const self = &own;
    ptc_status status;

    params.u_max = limit;
    params.samples = stage20_eva_count(STAGE20_EVA_SAMPLES_MIN, STAGE20_EVA_SAMPLES_MAX);
    params.h = stage20_eva_draw(STAGE20_EVA_H_MIN, STAGE20_EVA_H_MAX);
    params.k[0] = stage20_eva_draw(STAGE20_EVA_K1_MIN, STAGE20_EVA_K1_MAX);
    params.k[1] = stage20_eva_draw(STAGE20_EVA_K2_MIN, STAGE20_EVA_K2_MAX);
    params.k[2] = stage20_eva_draw(STAGE20_EVA_K3_MIN, STAGE20_EVA_K3_MAX);
    params.k[3] = stage20_eva_draw(STAGE20_EVA_K4_MIN, STAGE20_EVA_K4_MAX);
    params.deadbeat = stage20_eva_draw(STAGE20_EVA_DEADBEAT_MIN, STAGE20_EVA_DEADBEAT_MAX);
    stage20_eva_blank(self);
    status = stage20_init(self, &params);
    if (status == PTC_OK) {
        stage20_eva_use(self, limit, level);
        status = stage20_arm(self, stage20_eva_tick());
        //@ assert armed: status == PTC_OK;
        stage20_eva_kept(self);
        stage20_eva_use(self, limit, level);
    } else {
        //@ assert refused: status == PTC_E_PARAM;
        stage20_eva_untouched(self);
#ifdef FINITE
        //@ assert started: \false;
#endif
    }
}

#ifndef FINITE
/* NULL for every pointer that is checked, and no number for every input. */
static void stage20_eva_null(void)
{
    stage20_params params;
    stage20 own;
    stage20 *const self = &own;
    ptc_status status;
    const uint32_t k = stage20_eva_tick();
    double y[1];
    double r[3];
    double u;
    double xhat[2];
    double d;

    params.u_max = stage20_eva_draw(0.0, 0.0);
    params.samples = stage20_eva_tick();
    params.h = stage20_eva_draw(0.0, 0.0);
    params.k[0] = stage20_eva_draw(0.0, 0.0);
    params.k[1] = stage20_eva_draw(0.0, 0.0);
    params.k[2] = stage20_eva_draw(0.0, 0.0);
    params.k[3] = stage20_eva_draw(0.0, 0.0);
    params.deadbeat = stage20_eva_draw(0.0, 0.0);
    stage20_eva_blank(self);
    status = stage20_init(NULL, &params);
    //@ assert no_self: status == PTC_E_PARAM;
    status = stage20_init(self, NULL);
    //@ assert no_params: status == PTC_E_PARAM;
    stage20_eva_untouched(self);
    y[0] = stage20_eva_draw(0.0, 0.0);
    r[0] = stage20_eva_draw(0.0, 0.0);
    r[1] = stage20_eva_draw(0.0, 0.0);
    r[2] = stage20_eva_draw(0.0, 0.0);
    status = stage20_arm(NULL, k);
    //@ assert missing: status == PTC_E_INPUT;
    status = stage20_step(NULL, k, y, r, &u);
    //@ assert missing: status == PTC_E_INPUT;
    //@ assert zero: u == 0.0;
    status = stage20_step(self, k, NULL, r, &u);
    //@ assert missing: status == PTC_E_INPUT;
    //@ assert zero: u == 0.0;
    status = stage20_step(self, k, y, NULL, &u);
    //@ assert missing: status == PTC_E_INPUT;
    //@ assert zero: u == 0.0;
    status = stage20_step(self, k, y, r, NULL);
    //@ assert missing: status == PTC_E_INPUT;
    status = stage20_estimate(NULL, xhat);
    //@ assert missing: status == PTC_E_INPUT;
    status = stage20_estimate(self, NULL);
    //@ assert missing: status == PTC_E_INPUT;
    status = stage20_disturbance(NULL, &d);
    //@ assert missing: status == PTC_E_INPUT;
    status = stage20_disturbance(self, NULL);
    //@ assert missing: status == PTC_E_INPUT;
    stage20_eva_untouched(self);
    y[0] = 0.0;
    r[0] = 0.0;
    r[1] = 0.0;
    r[2] = 0.0;
    y[0] = NAN;
    status = stage20_step(self, k, y, r, &u);
    //@ assert no_number: status == PTC_E_INPUT;
    y[0] = 0.0;
    r[0] = NAN;
    status = stage20_step(self, k, y, r, &u);
    //@ assert no_number: status == PTC_E_INPUT;
    r[0] = 0.0;
    r[1] = NAN;
    status = stage20_step(self, k, y, r, &u);
    //@ assert no_number: status == PTC_E_INPUT;
    r[1] = 0.0;
    r[2] = NAN;
    status = stage20_step(self, k, y, r, &u);
    //@ assert no_number: status == PTC_E_INPUT;
    r[2] = 0.0;
    stage20_eva_untouched(self);
}
#endif

/* The whole proof of stage20. */
void stage20_eva(void)
{
#ifndef FINITE
    stage20_eva_null();
    stage20_eva_live(stage20_eva_draw(0.0, 0.0), 0);
    stage20_eva_live(stage20_eva_number(1, 0.0, 1.0), 1);
#endif
    stage20_eva_live(STAGE20_EVA_U_MAX_MIN, 2);
    if (STAGE20_EVA_U_MAX_MAX > STAGE20_EVA_U_MAX_MIN) {
        stage20_eva_live(STAGE20_EVA_U_MAX_MAX, 2);
    }
}

/* Left out where a program of several proofs has a main of its own. */
#ifndef PTC_EVA_PART
int main(void)
{
    stage20_eva();
    return 0;
}
#endif
