/* Prescribed-time controller duration_latched: see duration_latched.h. DO NOT EDIT. */
#include "duration_latched.h"

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

ptc_status duration_latched_init(
    duration_latched *self,
    const duration_latched_params *params,
    const double x0[2])
{
    ptc_status status = PTC_E_PARAM;
    struct duration_latched built;

    if ((self != NULL) && (params != NULL)) {
        const double tau = params->tau;
        const double t0 = params->t0;
        const double eps = params->eps;
        const double u_max = params->u_max;
        const double p_c = params->c;
        if (PTC_FINITE_F64(tau)
            && (1e-150 <= tau)
            && (tau <= 1e150)
            && PTC_FINITE_F64(t0)
            && (eps >= 1e-150)
            && (u_max > 0.0)
            && (0.5 <= p_c)
            && (p_c <= 2.0)
            && (eps < tau)) {
            const double hold_from = -eps;
            if (PTC_FINITE_F64(hold_from)) {
                built.eps = eps;
                built.hold_from = hold_from;
                built.p_c = p_c;
                built.u_max = u_max;
                built.t0 = 0.0;
                built.tau = 0.0;
                built.deadline = 0.0;
                built.correction = 0.0;
                built.f44 = 0.0;
                status = duration_latched_arm_for(&built, t0, tau, x0);
                if (status == PTC_OK) {
                    *self = built;
                }
            }
        }
    }
    return status;
}

ptc_status duration_latched_arm(duration_latched *self, double t0, const double x0[2])
{
    ptc_status status = PTC_E_PARAM;

    if ((self != NULL) && (x0 != NULL)) {
        if (PTC_FINITE_F64(t0) && PTC_FINITE_F64(x0[0]) && PTC_FINITE_F64(x0[1])) {
            const double deadline = t0 + self->tau;
            const double v1 = deadline - t0;
            const double correction = (t0 - (deadline - v1)) + (self->tau - v1);
            const double f44 = x0[0] * 0.125;
            if (PTC_FINITE_F64(deadline) && PTC_FINITE_F64(f44)) {
                self->t0 = t0;
                self->deadline = deadline;
                self->correction = correction;
                self->f44 = f44;
                status = PTC_OK;
            }
        }
    }
    return status;
}

ptc_status duration_latched_arm_for(
    duration_latched *self,
    double t0,
    double tau,
    const double x0[2])
{
    ptc_status status = PTC_E_PARAM;

    if ((self != NULL) && (x0 != NULL)) {
        if (PTC_FINITE_F64(t0)
            && PTC_FINITE_F64(x0[0])
            && PTC_FINITE_F64(x0[1])
            && PTC_FINITE_F64(tau)
            && (1e-150 <= tau)
            && (tau <= 1e150)
            && (tau > self->eps)) {
            const double deadline = t0 + tau;
            const double v1 = deadline - t0;
            const double correction = (t0 - (deadline - v1)) + (tau - v1);
            const double f44 = x0[0] * 0.125;
            if (PTC_FINITE_F64(deadline) && PTC_FINITE_F64(f44)) {
                self->t0 = t0;
                self->tau = tau;
                self->deadline = deadline;
                self->correction = correction;
                self->f44 = f44;
                status = PTC_OK;
            }
        }
    }
    return status;
}

ptc_status duration_latched_step(
    const duration_latched *self,
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
            const double T = -late;
            const double v1 = T * T * self->p_c;
            const double v2 = 1.0 + v1;
            const double unit = (T * self->p_c) / v2;
            const double v3 = T * unit;
            const double inv_r1 = 1.0 / v3;
            const double xi2 = x[1] * v3;
            const double law = (((-6.0) * x[0]) - (5.0 * xi2)) + self->f44;
            const double s1 = (-2.0) * ((((-(v1 * (-2.0) * (1.0 / v2))) - 1.0) - 1.0) * 0.5 * unit);
            const double v = ((law * inv_r1) + (s1 * x[1])) * inv_r1;
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
