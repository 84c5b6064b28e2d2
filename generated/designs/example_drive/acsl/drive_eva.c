/*
 * Proof that drive.c has no error at run time, with the plug-in Eva of Frama-C. Here are drive.h,
 * drive.c and this file, all three written by ptc-codegen emit --acsl. DO NOT EDIT.
 *
 * Any inputs, with NaN, infinities and NULL:
 *   frama-c -eva -eva-slevel 1000 -eva-slevel-merge-after-loop @all -eva-split-return full -eva-subdivide-non-linear 20 -eva-domains equality -warn-special-float none drive_eva.c drive.c
 * Finite inputs, and no value on the way may overflow or be NaN:
 *   frama-c -cpp-extra-args=-DFINITE -eva -eva-slevel 1000 -eva-slevel-merge-after-loop @all -eva-split-return full -eva-subdivide-non-linear 20 -eva-domains equality -warn-special-float non-finite drive_eva.c drive.c
 *
 * It is proved where no line begins with [eva:alarm] and the summary has no property unknown. In finite mode
 * values are drawn from the ranges below; give others with -cpp-extra-args="-DFINITE -D<macro>=<number>".
 */
#include "drive.h"

#include <math.h>
#include <stddef.h>

#include "__fc_builtin.h"

#define DRIVE_EVA_TAU_MIN 0.4
#define DRIVE_EVA_TAU_MAX 0.4
#ifndef DRIVE_EVA_T0_MIN
#define DRIVE_EVA_T0_MIN 0.0
#endif
#ifndef DRIVE_EVA_T0_MAX
#define DRIVE_EVA_T0_MAX 0.0
#endif
#ifndef DRIVE_EVA_EPS_MIN
#define DRIVE_EVA_EPS_MIN 0.00625
#endif
#ifndef DRIVE_EVA_EPS_MAX
#define DRIVE_EVA_EPS_MAX 0.00625
#endif
/* Bounds of |x_i|. */
#ifndef DRIVE_EVA_X1_MAX
#define DRIVE_EVA_X1_MAX 10.0
#endif
#ifndef DRIVE_EVA_X2_MAX
#define DRIVE_EVA_X2_MAX 10.0
#endif
#ifndef DRIVE_EVA_X3_MAX
#define DRIVE_EVA_X3_MAX 10.0
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

static volatile double drive_eva_source;

/* Any number, or in finite mode one of least to greatest. */
static double drive_eva_draw(double least, double greatest)
{
#ifdef FINITE
    return Frama_C_double_interval(least, greatest);
#else
    (void)least;
    (void)greatest;
    return drive_eva_source;
#endif
}

/* The same, but at the levels above 0 finite: Eva takes NaN to both sides of a comparison, so that it does
 * not see that one refuses it. */
static double drive_eva_number(int level, double least, double greatest)
{
    const double v = drive_eva_draw(least, greatest);

    return ((level > 0) && (isfinite(v) == 0)) ? greatest : v;
}

/* Fields that nothing has set. */
static void drive_eva_blank(drive *self)
{
    self->t0 = 42.0;
    self->deadline = 42.0;
    self->correction = 42.0;
    self->eps = 42.0;
    self->hold_from = 42.0;
}

static void drive_eva_untouched(const drive *self)
{
    (void)self;
    //@ assert untouched: self->t0 == 42.0;
    //@ assert untouched: self->deadline == 42.0;
    //@ assert untouched: self->correction == 42.0;
    //@ assert untouched: self->eps == 42.0;
    //@ assert untouched: self->hold_from == 42.0;
}

/* What every call that gives u keeps: a status, with u = 0 where it is negative; at level 1 that u is finite,
 * at 2 its bound. in_time is 1 where t0 is over for certain, -1 where it is
 * to come for certain. */
static void drive_eva_check(ptc_status status, double u, double limit, int level, int in_time)
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
static void drive_eva_use(const drive *self, double t, double t0, double limit, int level, int in_time)
{
    double x[3];
    double u;
    ptc_status status;

    x[0] = drive_eva_draw(-DRIVE_EVA_X1_MAX, DRIVE_EVA_X1_MAX);
    x[1] = drive_eva_draw(-DRIVE_EVA_X2_MAX, DRIVE_EVA_X2_MAX);
    x[2] = drive_eva_draw(-DRIVE_EVA_X3_MAX, DRIVE_EVA_X3_MAX);
    (void)t0;
    status = drive_step(self, t, x, &u);
    drive_eva_check(status, u, limit, level, in_time);
}

/* One life: before t0, tracking in pieces of time-to-go, the hold, and long after. */
static void drive_eva_times(const drive *self, double t0, double t0_low, double t0_high, double tau_low, double tau_high, double limit, int level)
{
#ifdef FINITE
    const int in_time = (t0_high <= t0_low);
    double low = t0_low;
    double far = tau_high;
    drive_eva_use(self, drive_eva_draw((t0_low - tau_high) - tau_high, t0_low - tau_high), t0, limit, level, -1);
    drive_eva_use(self, drive_eva_draw(t0_low - tau_high, t0_low), t0, limit, level, 0);
    /*@ loop unroll 10000; */
    while (far > DRIVE_EVA_EPS_MIN) {
        const double near = far * 0.6;

        drive_eva_use(self, drive_eva_draw(low, (t0_high + tau_high) - near), t0, limit, level, in_time);
        low = (t0_low + tau_low) - near;
        if (low < t0_low) {
            low = t0_low;
        }
        far = near;
    }
    drive_eva_use(self, drive_eva_draw(low, t0_high + tau_high + 1.0), t0, limit, level, in_time);
    drive_eva_use(self, drive_eva_draw(t0_high + tau_high, t0_high + tau_high + 1000000.0), t0, limit, level, in_time);
#else
    (void)t0_low;
    (void)t0_high;
    (void)tau_low;
    (void)tau_high;
    drive_eva_use(self, drive_eva_draw(0.0, 0.0), t0, limit, level, 0);
#endif
}

/* init, use, arm and use again; and arm on what was never used. */
static void drive_eva_live(double t0_low, double t0_high, double tau_low, double tau_high, double limit, int level)
{
    drive_params params;
    drive self;
    ptc_status status;
    double t0 = drive_eva_draw(t0_low, t0_high);

    params.t0 = t0;
    params.eps = drive_eva_number(level, DRIVE_EVA_EPS_MIN, DRIVE_EVA_EPS_MAX);
#ifdef FINITE
    //@ assert legal: drive_legal(&params);
#endif
    drive_eva_blank(&self);
    status = drive_init(&self, &params);
    if (status == PTC_OK) {
        drive_eva_times(&self, t0, t0_low, t0_high, tau_low, tau_high, limit, level);
        t0 = drive_eva_draw(t0_low, t0_high);
        status = drive_arm(&self, t0);
        if (status == PTC_OK) {
            drive_eva_times(&self, t0, t0_low, t0_high, tau_low, tau_high, limit, level);
        } else {
            //@ assert refused: status == PTC_E_PARAM;
#ifdef FINITE
            //@ assert armed: \false;
#endif
        }
    } else {
        //@ assert refused: status == PTC_E_PARAM;
        drive_eva_untouched(&self);
#ifdef FINITE
        //@ assert started: \false;
#endif
    }
    drive_eva_blank(&self);
    status = drive_arm(&self, drive_eva_draw(t0_low, t0_high));
    if (status != PTC_OK) {
        drive_eva_untouched(&self);
    }
}

/* Every piece of tau and of t0: in each, time-to-go is nearly known from the time. */
static void drive_eva_pieces(double limit, int level)
{
#ifdef FINITE
    double tau_low = DRIVE_EVA_TAU_MIN;

    /*@ loop unroll 10000; */
    do {
        double tau_high = tau_low * 1.05;
        double t0_low = DRIVE_EVA_T0_MIN;

        if (tau_high > DRIVE_EVA_TAU_MAX) {
            tau_high = DRIVE_EVA_TAU_MAX;
        }
        /*@ loop unroll 10000; */
        do {
            double t0_high = t0_low + (DRIVE_EVA_TAU_MIN / 16.0);

            if (t0_high > DRIVE_EVA_T0_MAX) {
                t0_high = DRIVE_EVA_T0_MAX;
            }
            drive_eva_live(t0_low, t0_high, tau_low, tau_high, limit, level);
            t0_low = t0_high;
        } while (t0_low < DRIVE_EVA_T0_MAX);
        tau_low = tau_high;
    } while (tau_low < DRIVE_EVA_TAU_MAX);
#else
    drive_eva_live(0.0, 0.0, 0.0, 0.0, limit, level);
#endif
}

#ifndef FINITE
/* NULL for every pointer that is checked, and no number for every input. */
static void drive_eva_null(void)
{
    drive self;
    double u;
    double x[3];
    double t = drive_eva_draw(0.0, 0.0);
    drive_params params;
    ptc_status status;

    params.t0 = drive_eva_draw(0.0, 0.0);
    params.eps = drive_eva_draw(0.0, 0.0);
    drive_eva_blank(&self);
    status = drive_init(NULL, &params);
    //@ assert no_self: status == PTC_E_PARAM;
    status = drive_init(&self, NULL);
    //@ assert no_params: status == PTC_E_PARAM;
    drive_eva_untouched(&self);
    status = drive_arm(NULL, 0.0);
    //@ assert no_self: status == PTC_E_PARAM;
    self.hold_from = -1.0;
    x[0] = drive_eva_draw(0.0, 0.0);
    x[1] = drive_eva_draw(0.0, 0.0);
    x[2] = drive_eva_draw(0.0, 0.0);
    status = drive_step(NULL, t, x, &u);
    //@ assert missing: status == PTC_E_INPUT;
    //@ assert zero: u == 0.0;
    status = drive_step(&self, t, NULL, &u);
    //@ assert missing: status == PTC_E_INPUT;
    //@ assert zero: u == 0.0;
    status = drive_step(&self, t, x, NULL);
    //@ assert missing: status == PTC_E_INPUT;
    x[0] = NAN;
    status = drive_step(&self, t, x, &u);
    //@ assert no_number: status == PTC_E_INPUT;
    x[0] = 0.0;
    x[1] = NAN;
    status = drive_step(&self, t, x, &u);
    //@ assert no_number: status == PTC_E_INPUT;
    x[1] = 0.0;
    x[2] = NAN;
    status = drive_step(&self, t, x, &u);
    //@ assert no_number: status == PTC_E_INPUT;
    x[2] = 0.0;
    t = INFINITY;
    status = drive_step(&self, t, x, &u);
    //@ assert no_number: status == PTC_E_INPUT;
}
#endif

/* The whole proof of drive. */
void drive_eva(void)
{
#ifndef FINITE
    drive_eva_null();
    drive_eva_pieces(0.0, 0);
#endif
    drive_eva_pieces(24.0, 2);
}

/* Left out where a program of several proofs has a main of its own. */
#ifndef PTC_EVA_PART
int main(void)
{
    drive_eva();
    return 0;
}
#endif
