/*
 * Proof that ptc_exp3.c has no error at run time, with the plug-in Eva of Frama-C. Here are ptc_exp3.h,
 * ptc_exp3.c and this file, all three written by ptc-codegen emit --acsl. DO NOT EDIT.
 *
 * Any inputs, with NaN, infinities and NULL:
 *   frama-c -eva -eva-slevel 1000 -eva-slevel-merge-after-loop @all -eva-split-return full -eva-subdivide-non-linear 20 -eva-domains equality -warn-special-float none ptc_exp3_eva.c ptc_exp3.c
 * Finite inputs, and no value on the way may overflow or be NaN:
 *   frama-c -cpp-extra-args=-DFINITE -eva -eva-slevel 1000 -eva-slevel-merge-after-loop @all -eva-split-return full -eva-subdivide-non-linear 20 -eva-domains equality -warn-special-float non-finite ptc_exp3_eva.c ptc_exp3.c
 *
 * It is proved where no line begins with [eva:alarm] and the summary has no property unknown. In finite mode
 * values are drawn from the ranges below; give others with -cpp-extra-args="-DFINITE -D<macro>=<number>".
 */
#include "ptc_exp3.h"

#include <math.h>
#include <stddef.h>

#include "__fc_builtin.h"

#ifndef PTC_EXP3_EVA_TAU_MIN
#define PTC_EXP3_EVA_TAU_MIN 1.0
#endif
#ifndef PTC_EXP3_EVA_TAU_MAX
#define PTC_EXP3_EVA_TAU_MAX 1.0
#endif
#ifndef PTC_EXP3_EVA_T0_MIN
#define PTC_EXP3_EVA_T0_MIN 0.0
#endif
#ifndef PTC_EXP3_EVA_T0_MAX
#define PTC_EXP3_EVA_T0_MAX 0.0
#endif
#ifndef PTC_EXP3_EVA_EPS_MIN
#define PTC_EXP3_EVA_EPS_MIN 0.015625
#endif
#ifndef PTC_EXP3_EVA_EPS_MAX
#define PTC_EXP3_EVA_EPS_MAX 0.015625
#endif
#ifndef PTC_EXP3_EVA_U_MAX_MIN
#define PTC_EXP3_EVA_U_MAX_MIN 10.0
#endif
#ifndef PTC_EXP3_EVA_U_MAX_MAX
#define PTC_EXP3_EVA_U_MAX_MAX 10.0
#endif
#ifndef PTC_EXP3_EVA_K1_MIN
#define PTC_EXP3_EVA_K1_MIN -100.0
#endif
#ifndef PTC_EXP3_EVA_K1_MAX
#define PTC_EXP3_EVA_K1_MAX 100.0
#endif
#ifndef PTC_EXP3_EVA_K2_MIN
#define PTC_EXP3_EVA_K2_MIN -100.0
#endif
#ifndef PTC_EXP3_EVA_K2_MAX
#define PTC_EXP3_EVA_K2_MAX 100.0
#endif
#ifndef PTC_EXP3_EVA_K3_MIN
#define PTC_EXP3_EVA_K3_MIN -100.0
#endif
#ifndef PTC_EXP3_EVA_K3_MAX
#define PTC_EXP3_EVA_K3_MAX 100.0
#endif
/* Bounds of |x_i|. */
#ifndef PTC_EXP3_EVA_X1_MAX
#define PTC_EXP3_EVA_X1_MAX 10.0
#endif
#ifndef PTC_EXP3_EVA_X2_MAX
#define PTC_EXP3_EVA_X2_MAX 10.0
#endif
#ifndef PTC_EXP3_EVA_X3_MAX
#define PTC_EXP3_EVA_X3_MAX 10.0
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

static volatile double ptc_exp3_eva_source;

/* Any number, or in finite mode one of least to greatest. */
static double ptc_exp3_eva_draw(double least, double greatest)
{
#ifdef FINITE
    return Frama_C_double_interval(least, greatest);
#else
    (void)least;
    (void)greatest;
    return ptc_exp3_eva_source;
#endif
}

/* The same, but at the levels above 0 finite: Eva takes NaN to both sides of a comparison, so that it does
 * not see that one refuses it. */
static double ptc_exp3_eva_number(int level, double least, double greatest)
{
    const double v = ptc_exp3_eva_draw(least, greatest);

    return ((level > 0) && (isfinite(v) == 0)) ? greatest : v;
}

/* Fields that nothing has set. */
static void ptc_exp3_eva_blank(ptc_exp3 *self)
{
    self->c1 = 42.0;
    self->c2 = 42.0;
    self->c3 = 42.0;
    self->t0 = 42.0;
    self->tau = 42.0;
    self->deadline = 42.0;
    self->correction = 42.0;
    self->eps = 42.0;
    self->hold_from = 42.0;
    self->u_max = 42.0;
}

static void ptc_exp3_eva_untouched(const ptc_exp3 *self)
{
    (void)self;
    //@ assert untouched: self->c1 == 42.0;
    //@ assert untouched: self->c2 == 42.0;
    //@ assert untouched: self->c3 == 42.0;
    //@ assert untouched: self->t0 == 42.0;
    //@ assert untouched: self->tau == 42.0;
    //@ assert untouched: self->deadline == 42.0;
    //@ assert untouched: self->correction == 42.0;
    //@ assert untouched: self->eps == 42.0;
    //@ assert untouched: self->hold_from == 42.0;
    //@ assert untouched: self->u_max == 42.0;
}

/* What every call that gives u keeps: a status, with u = 0 where it is negative; at level 1 that u is finite,
 * at 2 its bound. in_time is 1 where t0 is over for certain, -1 where it is
 * to come for certain. */
static void ptc_exp3_eva_check(ptc_status status, double u, double limit, int level, int in_time)
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
static void ptc_exp3_eva_use(const ptc_exp3 *self, double t, double t0, double limit, int level, int in_time)
{
    double x[3];
    double u;
    ptc_status status;
    ptc_exp3_gains gains;

    x[0] = ptc_exp3_eva_draw(-PTC_EXP3_EVA_X1_MAX, PTC_EXP3_EVA_X1_MAX);
    x[1] = ptc_exp3_eva_draw(-PTC_EXP3_EVA_X2_MAX, PTC_EXP3_EVA_X2_MAX);
    x[2] = ptc_exp3_eva_draw(-PTC_EXP3_EVA_X3_MAX, PTC_EXP3_EVA_X3_MAX);
    (void)t0;
    status = ptc_exp3_step(self, t, x, &u);
    ptc_exp3_eva_check(status, u, limit, level, in_time);

    gains.gain[0] = 42.0;
    gains.gain[1] = 42.0;
    gains.gain[2] = 42.0;
    status = ptc_exp3_tick(self, t, &gains);
    if (status >= 0) {
        //@ assert handed_on: gains.status == status;
        //@ assert early: in_time >= 0;
        status = ptc_exp3_axis(&gains, x, &u);
        ptc_exp3_eva_check(status, u, limit, level, in_time);
    } else {
        //@ assert untouched: gains.gain[0] == 42.0;
        //@ assert untouched: gains.gain[1] == 42.0;
        //@ assert untouched: gains.gain[2] == 42.0;
#ifdef FINITE
        if (in_time > 0) {
            //@ assert accepted: \false;
        }
#endif
    }
}

/* One life: before t0, tracking in pieces of time-to-go, the hold, and long after. */
static void ptc_exp3_eva_times(const ptc_exp3 *self, double t0, double t0_low, double t0_high, double tau_low, double tau_high, double limit, int level)
{
#ifdef FINITE
    const int in_time = (t0_high <= t0_low);
    double low = t0_low;
    double far = tau_high;
    ptc_exp3_eva_use(self, ptc_exp3_eva_draw((t0_low - tau_high) - tau_high, t0_low - tau_high), t0, limit, level, -1);
    ptc_exp3_eva_use(self, ptc_exp3_eva_draw(t0_low - tau_high, t0_low), t0, limit, level, 0);
    /*@ loop unroll 10000; */
    while (far > PTC_EXP3_EVA_EPS_MIN) {
        const double near = far * 0.6;

        ptc_exp3_eva_use(self, ptc_exp3_eva_draw(low, (t0_high + tau_high) - near), t0, limit, level, in_time);
        low = (t0_low + tau_low) - near;
        if (low < t0_low) {
            low = t0_low;
        }
        far = near;
    }
    ptc_exp3_eva_use(self, ptc_exp3_eva_draw(low, t0_high + tau_high + 1.0), t0, limit, level, in_time);
    ptc_exp3_eva_use(self, ptc_exp3_eva_draw(t0_high + tau_high, t0_high + tau_high + 1000000.0), t0, limit, level, in_time);
#else
    (void)t0_low;
    (void)t0_high;
    (void)tau_low;
    (void)tau_high;
    ptc_exp3_eva_use(self, ptc_exp3_eva_draw(0.0, 0.0), t0, limit, level, 0);
#endif
}

/* init, use, arm and use again; and arm on what was never used. */
static void ptc_exp3_eva_live(double t0_low, double t0_high, double tau_low, double tau_high, double limit, int level)
{
    ptc_exp3_params params;
    ptc_exp3 self;
    ptc_status status;
    double t0 = ptc_exp3_eva_draw(t0_low, t0_high);

    params.tau = ptc_exp3_eva_draw(tau_low, tau_high);
    params.t0 = t0;
    params.u_max = limit;
    params.eps = ptc_exp3_eva_number(level, PTC_EXP3_EVA_EPS_MIN, PTC_EXP3_EVA_EPS_MAX);
    params.k[0] = ptc_exp3_eva_draw(PTC_EXP3_EVA_K1_MIN, PTC_EXP3_EVA_K1_MAX);
    params.k[1] = ptc_exp3_eva_draw(PTC_EXP3_EVA_K2_MIN, PTC_EXP3_EVA_K2_MAX);
    params.k[2] = ptc_exp3_eva_draw(PTC_EXP3_EVA_K3_MIN, PTC_EXP3_EVA_K3_MAX);
#ifdef FINITE
    //@ assert legal: ptc_exp3_legal(&params);
#endif
    ptc_exp3_eva_blank(&self);
    status = ptc_exp3_init(&self, &params);
    if (status == PTC_OK) {
        ptc_exp3_eva_times(&self, t0, t0_low, t0_high, tau_low, tau_high, limit, level);
        t0 = ptc_exp3_eva_draw(t0_low, t0_high);
        status = ptc_exp3_arm(&self, t0);
        if (status == PTC_OK) {
            ptc_exp3_eva_times(&self, t0, t0_low, t0_high, tau_low, tau_high, limit, level);
        } else {
            //@ assert refused: status == PTC_E_PARAM;
#ifdef FINITE
            //@ assert armed: \false;
#endif
        }
    } else {
        //@ assert refused: status == PTC_E_PARAM;
        ptc_exp3_eva_untouched(&self);
    }
    ptc_exp3_eva_blank(&self);
    status = ptc_exp3_arm(&self, ptc_exp3_eva_draw(t0_low, t0_high));
    if (status != PTC_OK) {
        ptc_exp3_eva_untouched(&self);
    }
}

/* Every piece of tau and of t0: in each, time-to-go is nearly known from the time. */
static void ptc_exp3_eva_pieces(double limit, int level)
{
#ifdef FINITE
    double tau_low = PTC_EXP3_EVA_TAU_MIN;

    /*@ loop unroll 10000; */
    do {
        double tau_high = tau_low * 1.05;
        double t0_low = PTC_EXP3_EVA_T0_MIN;

        if (tau_high > PTC_EXP3_EVA_TAU_MAX) {
            tau_high = PTC_EXP3_EVA_TAU_MAX;
        }
        /*@ loop unroll 10000; */
        do {
            double t0_high = t0_low + (PTC_EXP3_EVA_TAU_MIN / 16.0);

            if (t0_high > PTC_EXP3_EVA_T0_MAX) {
                t0_high = PTC_EXP3_EVA_T0_MAX;
            }
            ptc_exp3_eva_live(t0_low, t0_high, tau_low, tau_high, limit, level);
            t0_low = t0_high;
        } while (t0_low < PTC_EXP3_EVA_T0_MAX);
        tau_low = tau_high;
    } while (tau_low < PTC_EXP3_EVA_TAU_MAX);
#else
    ptc_exp3_eva_live(0.0, 0.0, 0.0, 0.0, limit, level);
#endif
}

#ifndef FINITE
/* NULL for every pointer that is checked, and no number for every input. */
static void ptc_exp3_eva_null(void)
{
    ptc_exp3 self;
    double u;
    double x[3];
    double t = ptc_exp3_eva_draw(0.0, 0.0);
    ptc_exp3_gains gains;
    ptc_exp3_params params;
    ptc_status status;

    params.tau = ptc_exp3_eva_draw(0.0, 0.0);
    params.t0 = ptc_exp3_eva_draw(0.0, 0.0);
    params.eps = ptc_exp3_eva_draw(0.0, 0.0);
    params.u_max = ptc_exp3_eva_draw(0.0, 0.0);
    params.k[0] = ptc_exp3_eva_draw(0.0, 0.0);
    params.k[1] = ptc_exp3_eva_draw(0.0, 0.0);
    params.k[2] = ptc_exp3_eva_draw(0.0, 0.0);
    ptc_exp3_eva_blank(&self);
    status = ptc_exp3_init(NULL, &params);
    //@ assert no_self: status == PTC_E_PARAM;
    status = ptc_exp3_init(&self, NULL);
    //@ assert no_params: status == PTC_E_PARAM;
    ptc_exp3_eva_untouched(&self);
    status = ptc_exp3_arm(NULL, 0.0);
    //@ assert no_self: status == PTC_E_PARAM;
    self.hold_from = -1.0;
    x[0] = ptc_exp3_eva_draw(0.0, 0.0);
    x[1] = ptc_exp3_eva_draw(0.0, 0.0);
    x[2] = ptc_exp3_eva_draw(0.0, 0.0);
    gains.gain[0] = 1.0;
    gains.gain[1] = 1.0;
    gains.gain[2] = 1.0;
    gains.u_max = 1.0;
    gains.status = PTC_OK;
    status = ptc_exp3_step(NULL, t, x, &u);
    //@ assert missing: status == PTC_E_INPUT;
    //@ assert zero: u == 0.0;
    status = ptc_exp3_step(&self, t, NULL, &u);
    //@ assert missing: status == PTC_E_INPUT;
    //@ assert zero: u == 0.0;
    status = ptc_exp3_step(&self, t, x, NULL);
    //@ assert missing: status == PTC_E_INPUT;
    status = ptc_exp3_tick(NULL, t, &gains);
    //@ assert missing: status == PTC_E_INPUT;
    status = ptc_exp3_tick(&self, t, NULL);
    //@ assert missing: status == PTC_E_INPUT;
    status = ptc_exp3_axis(NULL, x, &u);
    //@ assert missing: status == PTC_E_INPUT;
    //@ assert zero: u == 0.0;
    status = ptc_exp3_axis(&gains, NULL, &u);
    //@ assert missing: status == PTC_E_INPUT;
    //@ assert zero: u == 0.0;
    status = ptc_exp3_axis(&gains, x, NULL);
    //@ assert missing: status == PTC_E_INPUT;
    x[0] = NAN;
    status = ptc_exp3_step(&self, t, x, &u);
    //@ assert no_number: status == PTC_E_INPUT;
    status = ptc_exp3_axis(&gains, x, &u);
    //@ assert no_number: status == PTC_E_INPUT;
    x[0] = 0.0;
    x[1] = NAN;
    status = ptc_exp3_step(&self, t, x, &u);
    //@ assert no_number: status == PTC_E_INPUT;
    status = ptc_exp3_axis(&gains, x, &u);
    //@ assert no_number: status == PTC_E_INPUT;
    x[1] = 0.0;
    x[2] = NAN;
    status = ptc_exp3_step(&self, t, x, &u);
    //@ assert no_number: status == PTC_E_INPUT;
    status = ptc_exp3_axis(&gains, x, &u);
    //@ assert no_number: status == PTC_E_INPUT;
    x[2] = 0.0;
    t = INFINITY;
    status = ptc_exp3_step(&self, t, x, &u);
    //@ assert no_number: status == PTC_E_INPUT;
    status = ptc_exp3_tick(&self, t, &gains);
    //@ assert no_number: status == PTC_E_INPUT;
}
#endif

/* The whole proof of ptc_exp3. */
void ptc_exp3_eva(void)
{
#ifndef FINITE
    ptc_exp3_eva_null();
    ptc_exp3_eva_pieces(ptc_exp3_eva_draw(0.0, 0.0), 0);
    ptc_exp3_eva_pieces(ptc_exp3_eva_number(1, 0.0, 0.0), 1);
#endif
    ptc_exp3_eva_pieces(PTC_EXP3_EVA_U_MAX_MIN, 2);
    if (PTC_EXP3_EVA_U_MAX_MAX > PTC_EXP3_EVA_U_MAX_MIN) {
        ptc_exp3_eva_pieces(PTC_EXP3_EVA_U_MAX_MAX, 2);
    }
}

/* Left out where a program of several proofs has a main of its own. */
#ifndef PTC_EVA_PART
int main(void)
{
    ptc_exp3_eva();
    return 0;
}
#endif
