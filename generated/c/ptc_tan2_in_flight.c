/* Prescribed-time controller ptc_tan2_in_flight: see ptc_tan2_in_flight.h. DO NOT EDIT. */
#include "ptc_tan2_in_flight.h"

#include <float.h>
#include <math.h>
#include <stddef.h>

/* What this file requires of its compiler. */
#if defined(__SDCC) || (defined(DBL_MANT_DIG) && (DBL_MANT_DIG != 53))
#error "double is not IEEE 754 binary64 here: emit with --precision f32, or make double 64 bits wide"
#endif
#if defined(FLT_EVAL_METHOD) && !defined(PTC_ALLOW_EXCESS_PRECISION)
#if (FLT_EVAL_METHOD == 2)
#error "double is computed with more digits than it has: on x86 compile with -msse2 -mfpmath=sse, or define PTC_ALLOW_EXCESS_PRECISION"
#endif
#endif
#if !defined(PTC_ALLOW_FAST_MATH)
#if defined(__FAST_MATH__) || defined(_M_FP_FAST)
#error "the guards need NaN and infinity: compile without -ffast-math, -Ofast and -ffinite-math-only, or define PTC_ALLOW_FAST_MATH"
#elif defined(__FINITE_MATH_ONLY__)
#if __FINITE_MATH_ONLY__ > 0
#error "the guards need NaN and infinity: compile without -ffast-math, -Ofast and -ffinite-math-only, or define PTC_ALLOW_FAST_MATH"
#endif
#endif
#endif

#if !defined(PTC_FINITE_F64)
#if defined(isfinite) && !defined(__MINGW32__)
#define PTC_FINITE_F64(x) (isfinite(x) != 0)
#else
#define PTC_FINITE_F64(x) (fabs(x) <= DBL_MAX)
#endif
#endif

ptc_status ptc_tan2_in_flight_init(
    ptc_tan2_in_flight *self,
    const ptc_tan2_in_flight_params *params)
{
    ptc_status status = PTC_E_PARAM;
    struct ptc_tan2_in_flight built;

    if ((self != NULL) && (params != NULL)) {
        const double tau = params->tau;
        const double t0 = params->t0;
        const double eps = params->eps;
        const double u_max = params->u_max;
        const double a = params->a;
        const double k1 = params->k[0];
        const double k2 = params->k[1];
        if (PTC_FINITE_F64(tau)
            && (1e-150 <= tau)
            && (tau <= 1e150)
            && PTC_FINITE_F64(t0)
            && (eps >= 1e-150)
            && (u_max > 0.0)
            && PTC_FINITE_F64(a)
            && (1e-150 <= a)
            && (a <= 1e150)
            && PTC_FINITE_F64(k1)
            && PTC_FINITE_F64(k2)
            && (eps < tau)) {
            const double K1 = k1 / (a * a);
            const double K2 = k2 / a;
            const double c1_2 = -K1;
            const double hold_from = -eps;
            const double size_K1 = (fabs(k1) <= 0.0) ? 1e-200 : fabs(K1);
            const double size_K2 = (fabs(k2) <= 0.0) ? 1e-200 : fabs(K2);
            const double f83 = -(1.5707963267948966 * K2);
            const double f88 = -(0.6366197723675814 * K2);
            if ((size_K1 >= 1e-200)
                && (size_K2 >= 1e-200)
                && PTC_FINITE_F64(c1_2)
                && PTC_FINITE_F64(hold_from)
                && PTC_FINITE_F64(f83)
                && PTC_FINITE_F64(f88)) {
                built.k2 = k2;
                built.c1_2 = c1_2;
                built.eps = eps;
                built.hold_from = hold_from;
                built.f83 = f83;
                built.f88 = f88;
                built.u_max = u_max;
                built.tau = 0.0;
                built.angle_rate = 0.0;
                built.inv_angle_rate = 0.0;
                built.t0 = 0.0;
                built.deadline = 0.0;
                built.correction = 0.0;
                built.inv_tau = 0.0;
                built.c2_0 = 0.0;
                built.c2_2 = 0.0;
                status = ptc_tan2_in_flight_arm_for(&built, t0, tau);
                if (status == PTC_OK) {
                    *self = built;
                }
            }
        }
    }
    return status;
}

ptc_status ptc_tan2_in_flight_arm(ptc_tan2_in_flight *self, double t0)
{
    ptc_status status = PTC_E_PARAM;

    if (self != NULL) {
        if (PTC_FINITE_F64(t0)) {
            const double deadline = t0 + self->tau;
            const double v1 = deadline - t0;
            const double correction = (t0 - (deadline - v1)) + (self->tau - v1);
            if (PTC_FINITE_F64(deadline)) {
                self->t0 = t0;
                self->deadline = deadline;
                self->correction = correction;
                status = PTC_OK;
            }
        }
    }
    return status;
}

ptc_status ptc_tan2_in_flight_arm_for(ptc_tan2_in_flight *self, double t0, double tau)
{
    ptc_status status = PTC_E_PARAM;

    if (self != NULL) {
        if (PTC_FINITE_F64(t0)
            && PTC_FINITE_F64(tau)
            && (1e-150 <= tau)
            && (tau <= 1e150)
            && (tau > self->eps)) {
            const double angle_rate = 1.5707963267948966 / tau;
            const double inv_angle_rate = 0.6366197723675814 * tau;
            const double deadline = t0 + tau;
            const double v1 = deadline - t0;
            const double correction = (t0 - (deadline - v1)) + (tau - v1);
            const double inv_tau = 1.0 / tau;
            const double c2_0 = self->f83 / tau;
            const double c2_2 = self->f88 * tau;
            const double size_c2_0 = (fabs(self->k2) <= 0.0) ? 1e-200 : fabs(c2_0);
            const double size_c2_2 = (fabs(self->k2) <= 0.0) ? 1e-200 : fabs(c2_2);
            if (PTC_FINITE_F64(deadline)
                && (size_c2_0 >= 1e-200)
                && (size_c2_2 >= 1e-200)
                && PTC_FINITE_F64(angle_rate)
                && PTC_FINITE_F64(inv_angle_rate)
                && PTC_FINITE_F64(inv_tau)
                && PTC_FINITE_F64(c2_0)
                && PTC_FINITE_F64(c2_2)) {
                self->tau = tau;
                self->angle_rate = angle_rate;
                self->inv_angle_rate = inv_angle_rate;
                self->t0 = t0;
                self->deadline = deadline;
                self->correction = correction;
                self->inv_tau = inv_tau;
                self->c2_0 = c2_0;
                self->c2_2 = c2_2;
                status = PTC_OK;
            }
        }
    }
    return status;
}

ptc_status ptc_tan2_in_flight_step(
    const ptc_tan2_in_flight *self,
    double t,
    const double x[2],
    double *u)
{
    ptc_status status = PTC_E_INPUT;

    if (u != NULL) {
        *u = 0.0;
    }
    if ((self != NULL) && (x != NULL) && (u != NULL)) {
        if (t >= self->t0) {
            const double past = (t - self->deadline) - self->correction;
            const double late = (past < self->hold_from) ? past : self->hold_from;
            const double v1 = late * self->inv_tau;
            const double inv_T_squared = 1.0 / (late * late);
            const double v2 = v1 * v1;
            const double s1 = (((-1.4910885650059303e-8) * v2) + 5.2188099741561376e-8) * v2;
            const double s2 = ((s1 - 1.6867939433688022e-7) * v2) + 8.247582914168544e-8;
            const double s3 = ((s2 * v2) - 6.748341805449633e-7) * v2;
            const double s4 = ((s3 - 1.7709607183780777e-6) * v2) - 7.696335899623563e-6;
            const double s5 = ((s4 * v2) - 3.049467456647586e-5) * v2;
            const double s6 = ((s5 - 0.00012208352032846455) * v2) - 0.0004884004503196425;
            const double s7 = ((s6 * v2) - 0.001955067633906801) * v2;
            const double s8 = ((s7 - 0.007844354338480027) * v2) - 0.031791970687246554;
            const double s9 = (((s8 * v2) - 0.13529040421388916) * v2) - 0.8224670334241132;
            const double th_cot_th = (s9 * v2) + 1.0;
            const double cot_rate_squared = inv_T_squared * (th_cot_th * th_cot_th);
            const double slope = self->angle_rate + (self->inv_angle_rate * cot_rate_squared);
            const double row1 = self->c1_2 * slope * slope;
            const double T = -late;
            const double cot_rate = T * inv_T_squared * th_cot_th;
            const double row2 = (self->c2_2 * cot_rate_squared) + self->c2_0 + (2.0 * cot_rate);
            const double v = (row1 * x[0]) + (row2 * x[1]);
            *u = v;
            if (PTC_FINITE_F64(v) && (fabs(v) <= self->u_max) && (late < self->hold_from)) {
                status = PTC_OK;
            } else if (PTC_FINITE_F64(t) && PTC_FINITE_F64(x[0]) && PTC_FINITE_F64(x[1])) {
                if (PTC_FINITE_F64(v)) {
                    if (v > self->u_max) {
                        *u = self->u_max;
                        status = PTC_SATURATED;
                    } else if (v < -self->u_max) {
                        *u = -self->u_max;
                        status = PTC_SATURATED;
                    } else {
                        status = PTC_HOLD;
                    }
                } else {
                    *u = 0.0;
                    status = PTC_E_RANGE;
                }
            } else {
                *u = 0.0;
                status = PTC_E_INPUT;
            }
        }
    }
    return status;
}

ptc_status ptc_tan2_in_flight_tick(
    const ptc_tan2_in_flight *self,
    double t,
    ptc_tan2_in_flight_gains *gains)
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (gains != NULL)) {
        if (PTC_FINITE_F64(t) && (t >= self->t0)) {
            const double past = (t - self->deadline) - self->correction;
            const double late = (past < self->hold_from) ? past : self->hold_from;
            const double v1 = late * self->inv_tau;
            const double inv_T_squared = 1.0 / (late * late);
            const double v2 = v1 * v1;
            const double s1 = (((-1.4910885650059303e-8) * v2) + 5.2188099741561376e-8) * v2;
            const double s2 = ((s1 - 1.6867939433688022e-7) * v2) + 8.247582914168544e-8;
            const double s3 = ((s2 * v2) - 6.748341805449633e-7) * v2;
            const double s4 = ((s3 - 1.7709607183780777e-6) * v2) - 7.696335899623563e-6;
            const double s5 = ((s4 * v2) - 3.049467456647586e-5) * v2;
            const double s6 = ((s5 - 0.00012208352032846455) * v2) - 0.0004884004503196425;
            const double s7 = ((s6 * v2) - 0.001955067633906801) * v2;
            const double s8 = ((s7 - 0.007844354338480027) * v2) - 0.031791970687246554;
            const double s9 = (((s8 * v2) - 0.13529040421388916) * v2) - 0.8224670334241132;
            const double th_cot_th = (s9 * v2) + 1.0;
            const double cot_rate_squared = inv_T_squared * (th_cot_th * th_cot_th);
            const double slope = self->angle_rate + (self->inv_angle_rate * cot_rate_squared);
            const double row1 = self->c1_2 * slope * slope;
            const double T = -late;
            const double cot_rate = T * inv_T_squared * th_cot_th;
            const double row2 = (self->c2_2 * cot_rate_squared) + self->c2_0 + (2.0 * cot_rate);
            gains->gain[0] = row1;
            gains->gain[1] = row2;
            gains->u_max = self->u_max;
            if (late < self->hold_from) {
                status = PTC_OK;
            } else {
                status = PTC_HOLD;
            }
            gains->status = status;
        }
    }
    return status;
}

ptc_status ptc_tan2_in_flight_axis(
    const ptc_tan2_in_flight_gains *gains,
    const double x[2],
    double *u)
{
    ptc_status status = PTC_E_INPUT;

    if (u != NULL) {
        *u = 0.0;
    }
    if ((gains != NULL) && (x != NULL) && (u != NULL)) {
        const double v = (gains->gain[0] * x[0]) + (gains->gain[1] * x[1]);
        *u = v;
        if (PTC_FINITE_F64(v) && (fabs(v) <= gains->u_max)) {
            status = gains->status;
        } else if (PTC_FINITE_F64(x[0]) && PTC_FINITE_F64(x[1])) {
            if (PTC_FINITE_F64(v)) {
                if (v > gains->u_max) {
                    *u = gains->u_max;
                    status = PTC_SATURATED;
                } else {
                    *u = -gains->u_max;
                    status = PTC_SATURATED;
                }
            } else {
                *u = 0.0;
                status = PTC_E_RANGE;
            }
        } else {
            *u = 0.0;
            status = PTC_E_INPUT;
        }
    }
    return status;
}
