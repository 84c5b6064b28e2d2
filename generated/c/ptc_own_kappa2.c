/* Prescribed-time controller ptc_own_kappa2: see ptc_own_kappa2.h. DO NOT EDIT. */
#include "ptc_own_kappa2.h"

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

ptc_status ptc_own_kappa2_init(ptc_own_kappa2 *self, const ptc_own_kappa2_params *params)
{
    ptc_status status = PTC_E_PARAM;
    struct ptc_own_kappa2 built;

    if ((self != NULL) && (params != NULL)) {
        const double tau = params->tau;
        const double t0 = params->t0;
        const double eps = params->eps;
        const double u_max = params->u_max;
        const double k1 = params->k[0];
        const double k2 = params->k[1];
        if (PTC_FINITE_F64(tau)
            && (1e-150 <= tau)
            && (tau <= 1e150)
            && PTC_FINITE_F64(t0)
            && (eps >= 1e-150)
            && (u_max > 0.0)
            && PTC_FINITE_F64(k1)
            && PTC_FINITE_F64(k2)
            && (eps < tau)) {
            const double hold_from = -eps;
            const double w1 = -k1;
            const double w2 = -k2;
            const double size_w1 = (fabs(k1) <= 0.0) ? 1e-200 : fabs(w1);
            const double size_w2 = (fabs(k2) <= 0.0) ? 1e-200 : fabs(w2);
            const double f15 = tau * tau;
            if ((size_w1 >= 1e-200)
                && (size_w2 >= 1e-200)
                && PTC_FINITE_F64(hold_from)
                && PTC_FINITE_F64(f15)
                && PTC_FINITE_F64(w1)
                && PTC_FINITE_F64(w2)) {
                built.tau = tau;
                built.eps = eps;
                built.hold_from = hold_from;
                built.f15 = f15;
                built.w1 = w1;
                built.w2 = w2;
                built.u_max = u_max;
                built.t0 = 0.0;
                built.deadline = 0.0;
                built.correction = 0.0;
                status = ptc_own_kappa2_arm(&built, t0);
                if (status == PTC_OK) {
                    *self = built;
                }
            }
        }
    }
    return status;
}

ptc_status ptc_own_kappa2_arm(ptc_own_kappa2 *self, double t0)
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

ptc_status ptc_own_kappa2_step(const ptc_own_kappa2 *self, double t, const double x[2], double *u)
{
    ptc_status status = PTC_E_INPUT;

    if (u != NULL) {
        *u = 0.0;
    }
    if ((self != NULL) && (x != NULL) && (u != NULL)) {
        if (PTC_FINITE_F64(t) && (t >= self->t0)) {
            const double past = (t - self->deadline) - self->correction;
            const double late = (past < self->hold_from) ? past : self->hold_from;
            const double T = -late;
            const double v1 = T * T;
            const double v2 = self->f15 + v1;
            const double unit = T / v2;
            const double inv_r1 = 1.0 / (T * unit);
            const double s1 = (-2.0) * ((((-(v1 * (-2.0) * (1.0 / v2))) - 1.0) - 1.0) * 0.5 * unit);
            const double s2 = ((self->w1 * x[0] * inv_r1) + ((self->w2 + s1) * x[1])) * inv_r1;
            const double v = (past >= 0.0) ? 0.0 : s2;
            *u = v;
            if (PTC_FINITE_F64(v) && (fabs(v) <= self->u_max) && (late < self->hold_from)) {
                status = PTC_OK;
            } else if (PTC_FINITE_F64(x[0]) && PTC_FINITE_F64(x[1])) {
                if (PTC_FINITE_F64(v)) {
                    if (v > self->u_max) {
                        *u = self->u_max;
                        status = PTC_SATURATED;
                    } else if (v < -self->u_max) {
                        *u = -self->u_max;
                        status = PTC_SATURATED;
                    } else if (past >= 0.0) {
                        status = PTC_AFTER;
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
