/*
 * Proof that table.c has no error at run time, with the plug-in Eva of Frama-C. Here are table.h,
 * table.c and this file, all three written by ptc-codegen emit --acsl. DO NOT EDIT.
 *
 * Any inputs, with NaN, infinities and NULL:
 *   frama-c -eva -eva-slevel 1000 -eva-slevel-merge-after-loop @all -eva-split-return full -eva-subdivide-non-linear 20 -eva-domains equality -warn-special-float none table_eva.c table.c
 * Finite inputs, and no value on the way may overflow or be NaN:
 *   frama-c -cpp-extra-args=-DFINITE -eva -eva-slevel 1000 -eva-slevel-merge-after-loop @all -eva-split-return full -eva-subdivide-non-linear 20 -eva-domains equality -warn-special-float non-finite table_eva.c table.c
 *
 * It is proved where no line begins with [eva:alarm] and the summary has no property unknown. In finite mode
 * values are drawn from the ranges below; give others with -cpp-extra-args="-DFINITE -D<macro>=<number>".
 */
#include "table.h"

#include <math.h>
#include <stddef.h>

#include "__fc_builtin.h"

#define TABLE_EVA_TAU_MIN 1.0
#define TABLE_EVA_TAU_MAX 1.0
#ifndef TABLE_EVA_T0_MIN
#define TABLE_EVA_T0_MIN 0.0
#endif
#ifndef TABLE_EVA_T0_MAX
#define TABLE_EVA_T0_MAX 0.0
#endif
#define TABLE_EVA_EPS_MIN 0.0493
#define TABLE_EVA_EPS_MAX 0.0493
/* Bounds of |x_i|. */
#ifndef TABLE_EVA_X1_MAX
#define TABLE_EVA_X1_MAX 10.0
#endif
#ifndef TABLE_EVA_X2_MAX
#define TABLE_EVA_X2_MAX 10.0
#endif

/* Frama-C leaves the sign of a true isfinite open; the code only asks whether it is 0. */
/*@ ensures \result >= 0; */
extern int __finite(double d);
/*@ ensures \result >= 0; */
extern int __finitef(float f);
/* The contract of fabs keeps no relation to its argument, from which Eva could tell that |u| <= u_max
 * bounds u. */
double fabs(double x)
{
    return (x < 0.0) ? -x : x;
}

static volatile double table_eva_source;

/* Any number, or in finite mode one of least to greatest. */
static double table_eva_draw(double least, double greatest)
{
#ifdef FINITE
    return Frama_C_double_interval(least, greatest);
#else
    (void)least;
    (void)greatest;
    return table_eva_source;
#endif
}

/* Fields that nothing has set. */
static void table_eva_blank(table *self)
{
    self->t0 = 42.0;
    self->deadline = 42.0;
    self->correction = 42.0;
}

static void table_eva_untouched(const table *self)
{
    (void)self;
    //@ assert untouched: self->t0 == 42.0;
    //@ assert untouched: self->deadline == 42.0;
    //@ assert untouched: self->correction == 42.0;
}

/* What every call that gives u keeps: a status, with u = 0 where it is negative; at level 1 that u is finite,
 * at 2 its bound. in_time is 1 where t0 is over for certain, -1 where it is
 * to come for certain. */
static void table_eva_check(ptc_status status, double u, double limit, int level, int in_time)
{
    //@ assert known: -3 <= status <= 3 && status != PTC_E_PARAM;
    //@ assert refused: status < 0 ==> u == 0.0;
    if (level > 0) {
        //@ assert finite: \is_finite(u);
    }
    if (level > 1) {
        //@ assert bounded: status >= 0 ==> -limit <= u <= limit;
    }
#ifdef FINITE
    //@ assert in_range: status != PTC_E_RANGE;
    if (in_time > 0) {
        //@ assert accepted: status >= 0;
    }
    if (in_time < 0) {
        //@ assert early: status == PTC_E_INPUT;
    }
#else
    (void)in_time;
#endif
}

/* The controller at time t. */
static void table_eva_use(const table *self, double t, double t0, double limit, int level, int in_time)
{
    double x[2];
    double u;
    ptc_status status;
    table_gains gains;

    x[0] = table_eva_draw(-TABLE_EVA_X1_MAX, TABLE_EVA_X1_MAX);
    x[1] = table_eva_draw(-TABLE_EVA_X2_MAX, TABLE_EVA_X2_MAX);
    (void)t0;
    status = table_step(self, t, x, &u);
    table_eva_check(status, u, limit, level, in_time);

    gains.gain[0] = 42.0;
    gains.gain[1] = 42.0;
    status = table_tick(self, t, &gains);
    if (status >= 0) {
        //@ assert handed_on: gains.status == status;
        //@ assert early: in_time >= 0;
        status = table_axis(&gains, x, &u);
        table_eva_check(status, u, limit, level, in_time);
    } else {
        //@ assert untouched: gains.gain[0] == 42.0;
        //@ assert untouched: gains.gain[1] == 42.0;
#ifdef FINITE
        if (in_time > 0) {
            //@ assert accepted: \false;
        }
#endif
    }
}

/* One life: before t0, tracking in pieces of time-to-go, the hold, and long after. */
static void table_eva_times(const table *self, double t0, double t0_low, double t0_high, double tau_low, double tau_high, double limit, int level)
{
#ifdef FINITE
    const int in_time = (t0_high <= t0_low);
    double low = t0_low;
    double far = tau_high;
    table_eva_use(self, table_eva_draw((t0_low - tau_high) - tau_high, t0_low - tau_high), t0, limit, level, -1);
    table_eva_use(self, table_eva_draw(t0_low - tau_high, t0_low), t0, limit, level, 0);
    /*@ loop unroll 10000; */
    while (far > TABLE_EVA_EPS_MIN) {
        const double near = far * 0.6;

        table_eva_use(self, table_eva_draw(low, (t0_high + tau_high) - near), t0, limit, level, in_time);
        low = (t0_low + tau_low) - near;
        if (low < t0_low) {
            low = t0_low;
        }
        far = near;
    }
    table_eva_use(self, table_eva_draw(low, t0_high + tau_high + 1.0), t0, limit, level, in_time);
    table_eva_use(self, table_eva_draw(t0_high + tau_high, t0_high + tau_high + 1000000.0), t0, limit, level, in_time);
#else
    (void)t0_low;
    (void)t0_high;
    (void)tau_low;
    (void)tau_high;
    table_eva_use(self, table_eva_draw(0.0, 0.0), t0, limit, level, 0);
#endif
}

/* init, use, arm and use again; and arm on what was never used. */
static void table_eva_live(double t0_low, double t0_high, double tau_low, double tau_high, double limit, int level)
{
    table_params params;
    table self;
    ptc_status status;
    double t0 = table_eva_draw(t0_low, t0_high);

    params.t0 = t0;
#ifdef FINITE
    //@ assert legal: table_legal(&params);
#endif
    table_eva_blank(&self);
    status = table_init(&self, &params);
    if (status == PTC_OK) {
        table_eva_times(&self, t0, t0_low, t0_high, tau_low, tau_high, limit, level);
        t0 = table_eva_draw(t0_low, t0_high);
        status = table_arm(&self, t0);
        if (status == PTC_OK) {
            table_eva_times(&self, t0, t0_low, t0_high, tau_low, tau_high, limit, level);
        } else {
            //@ assert refused: status == PTC_E_PARAM;
#ifdef FINITE
            //@ assert armed: \false;
#endif
        }
    } else {
        //@ assert refused: status == PTC_E_PARAM;
        table_eva_untouched(&self);
#ifdef FINITE
        //@ assert started: \false;
#endif
    }
    table_eva_blank(&self);
    status = table_arm(&self, table_eva_draw(t0_low, t0_high));
    if (status != PTC_OK) {
        table_eva_untouched(&self);
    }
}

/* Every piece of tau and of t0: in each, time-to-go is nearly known from the time. */
static void table_eva_pieces(double limit, int level)
{
#ifdef FINITE
    double tau_low = TABLE_EVA_TAU_MIN;

    /*@ loop unroll 10000; */
    do {
        double tau_high = tau_low * 1.05;
        double t0_low = TABLE_EVA_T0_MIN;

        if (tau_high > TABLE_EVA_TAU_MAX) {
            tau_high = TABLE_EVA_TAU_MAX;
        }
        /*@ loop unroll 10000; */
        do {
            double t0_high = t0_low + (TABLE_EVA_TAU_MIN / 16.0);

            if (t0_high > TABLE_EVA_T0_MAX) {
                t0_high = TABLE_EVA_T0_MAX;
            }
            table_eva_live(t0_low, t0_high, tau_low, tau_high, limit, level);
            t0_low = t0_high;
        } while (t0_low < TABLE_EVA_T0_MAX);
        tau_low = tau_high;
    } while (tau_low < TABLE_EVA_TAU_MAX);
#else
    table_eva_live(0.0, 0.0, 0.0, 0.0, limit, level);
#endif
}

#ifndef FINITE
/* NULL for every pointer that is checked, and no number for every input. */
static void table_eva_null(void)
{
    table self;
    double u;
    double x[2];
    double t = table_eva_draw(0.0, 0.0);
    table_gains gains;
    table_params params;
    ptc_status status;

    params.t0 = table_eva_draw(0.0, 0.0);
    table_eva_blank(&self);
    status = table_init(NULL, &params);
    //@ assert no_self: status == PTC_E_PARAM;
    status = table_init(&self, NULL);
    //@ assert no_params: status == PTC_E_PARAM;
    table_eva_untouched(&self);
    status = table_arm(NULL, 0.0);
    //@ assert no_self: status == PTC_E_PARAM;
    x[0] = table_eva_draw(0.0, 0.0);
    x[1] = table_eva_draw(0.0, 0.0);
    gains.gain[0] = 1.0;
    gains.gain[1] = 1.0;
    gains.status = PTC_OK;
    status = table_step(NULL, t, x, &u);
    //@ assert missing: status == PTC_E_INPUT;
    //@ assert zero: u == 0.0;
    status = table_step(&self, t, NULL, &u);
    //@ assert missing: status == PTC_E_INPUT;
    //@ assert zero: u == 0.0;
    status = table_step(&self, t, x, NULL);
    //@ assert missing: status == PTC_E_INPUT;
    status = table_tick(NULL, t, &gains);
    //@ assert missing: status == PTC_E_INPUT;
    status = table_tick(&self, t, NULL);
    //@ assert missing: status == PTC_E_INPUT;
    status = table_axis(NULL, x, &u);
    //@ assert missing: status == PTC_E_INPUT;
    //@ assert zero: u == 0.0;
    status = table_axis(&gains, NULL, &u);
    //@ assert missing: status == PTC_E_INPUT;
    //@ assert zero: u == 0.0;
    status = table_axis(&gains, x, NULL);
    //@ assert missing: status == PTC_E_INPUT;
    x[0] = NAN;
    status = table_step(&self, t, x, &u);
    //@ assert no_number: status == PTC_E_INPUT;
    status = table_axis(&gains, x, &u);
    //@ assert no_number: status == PTC_E_INPUT;
    x[0] = 0.0;
    x[1] = NAN;
    status = table_step(&self, t, x, &u);
    //@ assert no_number: status == PTC_E_INPUT;
    status = table_axis(&gains, x, &u);
    //@ assert no_number: status == PTC_E_INPUT;
    x[1] = 0.0;
    t = INFINITY;
    status = table_step(&self, t, x, &u);
    //@ assert no_number: status == PTC_E_INPUT;
    status = table_tick(&self, t, &gains);
    //@ assert no_number: status == PTC_E_INPUT;
}
#endif

/* The whole proof of table. */
void table_eva(void)
{
#ifndef FINITE
    table_eva_null();
#endif
    table_eva_pieces(0.5, 2);
}

/* Left out where a program of several proofs has a main of its own. */
#ifndef PTC_EVA_PART
int main(void)
{
    table_eva();
    return 0;
}
#endif
