/*
 * Proof that stage50.c has no error at run time, with the plug-in Eva of Frama-C. Here are stage50.h,
 * stage50.c and this file, all three written by ptc-codegen emit --acsl. DO NOT EDIT.
 *
 * Any inputs, with NaN, infinities and NULL:
 *   frama-c -eva -eva-slevel 1000 -eva-slevel-merge-after-loop @all -eva-split-return full -eva-subdivide-non-linear 20 -eva-domains equality -warn-special-float none stage50_eva.c stage50.c
 * Finite inputs, and no value on the way may overflow or be NaN:
 *   frama-c -cpp-extra-args=-DFINITE -eva -eva-slevel 1000 -eva-slevel-merge-after-loop @all -eva-split-return full -eva-subdivide-non-linear 20 -eva-domains equality -warn-special-float non-finite stage50_eva.c stage50.c
 *
 * It is proved where no line begins with [eva:alarm] and the summary has no property unknown. A call is
 * proved from whatever the calls before it may have left. In finite mode values are drawn from the ranges
 * below; give others with -cpp-extra-args="-DFINITE -D<macro>=<number>".
 */
#include "stage50.h"

#include <math.h>
#include <stddef.h>

#include "__fc_builtin.h"

#ifndef STAGE50_EVA_U_MAX_MIN
#define STAGE50_EVA_U_MAX_MIN 10.0
#endif
#ifndef STAGE50_EVA_U_MAX_MAX
#define STAGE50_EVA_U_MAX_MAX 10.0
#endif
/* Bounds of what is measured, and of the fields that calls change. */
#ifndef STAGE50_EVA_Y1_MAX
#define STAGE50_EVA_Y1_MAX 10.0
#endif
#ifndef STAGE50_EVA_Y2_MAX
#define STAGE50_EVA_Y2_MAX 10.0
#endif
#ifndef STAGE50_EVA_R0_MAX
#define STAGE50_EVA_R0_MAX 10.0
#endif
#ifndef STAGE50_EVA_R1_MAX
#define STAGE50_EVA_R1_MAX 10.0
#endif
#ifndef STAGE50_EVA_R2_MAX
#define STAGE50_EVA_R2_MAX 10.0
#endif

/* Frama-C leaves the sign of a true isfinite open; the code only asks whether it is 0. */
/*@ ensures \result >= 0; */
extern int __finite(double d);
/*@ ensures \result >= 0; */
extern int __finitef(float f);

static volatile double stage50_eva_source;

/* Any number, or in finite mode one of least to greatest. */
static double stage50_eva_draw(double least, double greatest)
{
#ifdef FINITE
    return Frama_C_double_interval(least, greatest);
#else
    (void)least;
    (void)greatest;
    return stage50_eva_source;
#endif
}

/* The same, but at the levels above 0 finite: Eva takes NaN to both sides of a comparison, so that it does
 * not see that one refuses it. */
static double stage50_eva_number(int level, double least, double greatest)
{
    const double v = stage50_eva_draw(least, greatest);

    return ((level > 0) && (isfinite(v) == 0)) ? greatest : v;
}

static uint32_t stage50_eva_count(uint32_t least, uint32_t greatest)
{
    return (uint32_t)Frama_C_unsigned_int_interval(least, greatest);
}

/* Any tick. */
static uint32_t stage50_eva_tick(void)
{
    return stage50_eva_count(0U, 4294967295U);
}

/* Fields that nothing has set. */
static void stage50_eva_blank(stage50 *self)
{
    self->start = 42U;
    self->u_max = 42.0;
}

static void stage50_eva_untouched(const stage50 *self)
{
    (void)self;
    //@ assert untouched: self->start == 42;
    //@ assert untouched: self->u_max == 42.0;
}

/* What calls may leave, and more. */
static void stage50_eva_kept(stage50 *self)
{
    self->start = stage50_eva_tick();
}

/* A call at any tick, and the estimates behind it: a status, with u = 0 where it is negative; at level 1 that
 * u is finite, at 2 its bound. */
static void stage50_eva_use(stage50 *self, double limit, int level)
{
    const uint32_t k = stage50_eva_tick();
    double x[2];
    double r[3];
    ptc_status status;
    double u;

    (void)limit;
    (void)level;
    x[0] = stage50_eva_draw(-STAGE50_EVA_Y1_MAX, STAGE50_EVA_Y1_MAX);
    x[1] = stage50_eva_draw(-STAGE50_EVA_Y2_MAX, STAGE50_EVA_Y2_MAX);
    r[0] = stage50_eva_draw(-STAGE50_EVA_R0_MAX, STAGE50_EVA_R0_MAX);
    r[1] = stage50_eva_draw(-STAGE50_EVA_R1_MAX, STAGE50_EVA_R1_MAX);
    r[2] = stage50_eva_draw(-STAGE50_EVA_R2_MAX, STAGE50_EVA_R2_MAX);
    status = stage50_step(self, k, x, r, &u);
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
}

/* init and the first call, then arm and any call. */
static void stage50_eva_live(double limit, int level)
{
    stage50_params params;
    stage50 own;
    stage50 *const self = &own;
    ptc_status status;

    params.u_max = limit;
    stage50_eva_blank(self);
    status = stage50_init(self, &params);
    if (status == PTC_OK) {
        stage50_eva_use(self, limit, level);
        status = stage50_arm(self, stage50_eva_tick());
        //@ assert armed: status == PTC_OK;
        stage50_eva_kept(self);
        stage50_eva_use(self, limit, level);
    } else {
        //@ assert refused: status == PTC_E_PARAM;
        stage50_eva_untouched(self);
#ifdef FINITE
        //@ assert started: \false;
#endif
    }
}

#ifndef FINITE
/* NULL for every pointer that is checked, and no number for every input. */
static void stage50_eva_null(void)
{
    stage50_params params;
    stage50 own;
    stage50 *const self = &own;
    ptc_status status;
    const uint32_t k = stage50_eva_tick();
    double x[2];
    double r[3];
    double u;

    params.u_max = stage50_eva_draw(0.0, 0.0);
    stage50_eva_blank(self);
    status = stage50_init(NULL, &params);
    //@ assert no_self: status == PTC_E_PARAM;
    status = stage50_init(self, NULL);
    //@ assert no_params: status == PTC_E_PARAM;
    stage50_eva_untouched(self);
    x[0] = stage50_eva_draw(0.0, 0.0);
    x[1] = stage50_eva_draw(0.0, 0.0);
    r[0] = stage50_eva_draw(0.0, 0.0);
    r[1] = stage50_eva_draw(0.0, 0.0);
    r[2] = stage50_eva_draw(0.0, 0.0);
    status = stage50_arm(NULL, k);
    //@ assert missing: status == PTC_E_INPUT;
    status = stage50_step(NULL, k, x, r, &u);
    //@ assert missing: status == PTC_E_INPUT;
    //@ assert zero: u == 0.0;
    status = stage50_step(self, k, NULL, r, &u);
    //@ assert missing: status == PTC_E_INPUT;
    //@ assert zero: u == 0.0;
    status = stage50_step(self, k, x, NULL, &u);
    //@ assert missing: status == PTC_E_INPUT;
    //@ assert zero: u == 0.0;
    status = stage50_step(self, k, x, r, NULL);
    //@ assert missing: status == PTC_E_INPUT;
    stage50_eva_untouched(self);
    x[0] = 0.0;
    x[1] = 0.0;
    r[0] = 0.0;
    r[1] = 0.0;
    r[2] = 0.0;
    x[0] = NAN;
    status = stage50_step(self, k, x, r, &u);
    //@ assert no_number: status == PTC_E_INPUT;
    x[0] = 0.0;
    x[1] = NAN;
    status = stage50_step(self, k, x, r, &u);
    //@ assert no_number: status == PTC_E_INPUT;
    x[1] = 0.0;
    r[0] = NAN;
    status = stage50_step(self, k, x, r, &u);
    //@ assert no_number: status == PTC_E_INPUT;
    r[0] = 0.0;
    r[1] = NAN;
    status = stage50_step(self, k, x, r, &u);
    //@ assert no_number: status == PTC_E_INPUT;
    r[1] = 0.0;
    r[2] = NAN;
    status = stage50_step(self, k, x, r, &u);
    //@ assert no_number: status == PTC_E_INPUT;
    r[2] = 0.0;
    stage50_eva_untouched(self);
}
#endif

/* The whole proof of stage50. */
void stage50_eva(void)
{
#ifndef FINITE
    stage50_eva_null();
    stage50_eva_live(stage50_eva_draw(0.0, 0.0), 0);
    stage50_eva_live(stage50_eva_number(1, 0.0, 1.0), 1);
#endif
    stage50_eva_live(STAGE50_EVA_U_MAX_MIN, 2);
    if (STAGE50_EVA_U_MAX_MAX > STAGE50_EVA_U_MAX_MIN) {
        stage50_eva_live(STAGE50_EVA_U_MAX_MAX, 2);
    }
}

/* Left out where a program of several proofs has a main of its own. */
#ifndef PTC_EVA_PART
int main(void)
{
    stage50_eva();
    return 0;
}
#endif
