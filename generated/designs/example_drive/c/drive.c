/* Prescribed-time controller drive: see drive.h. DO NOT EDIT. */
#include "drive.h"

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

ptc_status drive_init(drive *self, const drive_params *params)
{
    ptc_status status = PTC_E_PARAM;
    struct drive built;

    if ((self != NULL) && (params != NULL)) {
        const double t0 = params->t0;
        const double eps = params->eps;
        if (PTC_FINITE_F64(t0) && (1e-150 <= eps) && (eps < 0.4)) {
            const double hold_from = -eps;
            if (PTC_FINITE_F64(hold_from)) {
                built.eps = eps;
                built.hold_from = hold_from;
                built.t0 = 0.0;
                built.deadline = 0.0;
                built.correction = 0.0;
                status = drive_arm(&built, t0);
                if (status == PTC_OK) {
                    *self = built;
                }
            }
        }
    }
    return status;
}

ptc_status drive_arm(drive *self, double t0)
{
    ptc_status status = PTC_E_PARAM;

    if (self != NULL) {
        if (PTC_FINITE_F64(t0)) {
            const double deadline = t0 + 0.4;
            const double v1 = deadline - t0;
            const double correction = (t0 - (deadline - v1)) + (0.4 - v1);
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

ptc_status drive_step(const drive *self, double t, const double x[3], double *u)
{
    ptc_status status = PTC_E_INPUT;

    if (u != NULL) {
        *u = 0.0;
    }
    if ((self != NULL) && (x != NULL) && (u != NULL)) {
        if (t >= self->t0) {
            const double past = (t - self->deadline) - self->correction;
            const double late = (past < self->hold_from) ? past : self->hold_from;
            const double inv_T = (-1.0) / late;
            const double drift = ((-0.029999666666666668) * x[1]) - (1.201 * x[2]);
            const double s1 = (((-0.00016) * x[0] * inv_T) + ((-8e-5) * x[1])) * inv_T;
            const double v = ((s1 + (((-0.024) * x[2]) - ((-8e-6) * x[1]))) * inv_T) - drift;
            *u = v;
            if (PTC_FINITE_F64(v) && (fabs(v) <= 24.0) && (late < self->hold_from)) {
                status = PTC_OK;
            } else if (PTC_FINITE_F64(t)
                && PTC_FINITE_F64(x[0])
                && PTC_FINITE_F64(x[1])
                && PTC_FINITE_F64(x[2])) {
                if (PTC_FINITE_F64(v)) {
                    if (v > 24.0) {
                        *u = 24.0;
                        status = PTC_SATURATED;
                    } else if (v < -24.0) {
                        *u = -24.0;
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
