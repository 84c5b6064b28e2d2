/* Prescribed-time controller ptc_exp3_fixed: see ptc_exp3_fixed.h. DO NOT EDIT. */
#include "ptc_exp3_fixed.h"

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

ptc_status ptc_exp3_fixed_init(ptc_exp3_fixed *self, const ptc_exp3_fixed_params *params)
{
    ptc_status status = PTC_E_PARAM;
    struct ptc_exp3_fixed built;

    (void)params;
    if (self != NULL) {
        built.t0 = 0.0;
        built.deadline = 0.0;
        built.correction = 0.0;
        status = ptc_exp3_fixed_arm(&built, 0.0);
        if (status == PTC_OK) {
            *self = built;
        }
    }
    return status;
}

ptc_status ptc_exp3_fixed_arm(ptc_exp3_fixed *self, double t0)
{
    ptc_status status = PTC_E_PARAM;

    if (self != NULL) {
        if (PTC_FINITE_F64(t0)) {
            const double deadline = t0 + 2.0;
            const double v1 = deadline - t0;
            const double correction = (t0 - (deadline - v1)) + (2.0 - v1);
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

ptc_status ptc_exp3_fixed_step(const ptc_exp3_fixed *self, double t, const double x[3], double *u)
{
    ptc_status status = PTC_E_INPUT;

    if (u != NULL) {
        *u = 0.0;
    }
    if ((self != NULL) && (x != NULL) && (u != NULL)) {
        if (t >= self->t0) {
            const double past = (t - self->deadline) - self->correction;
            const double late = (past < -0.001) ? past : -0.001;
            const double inv_T = (-1.0) / late;
            const double s1 = (((-120.0) * x[0] * inv_T) + ((-60.0) * x[1])) * inv_T;
            const double v = (s1 + ((-12.0) * x[2])) * inv_T;
            *u = v;
            if (PTC_FINITE_F64(v) && (fabs(v) <= 50.0) && (late < -0.001)) {
                status = PTC_OK;
            } else if (PTC_FINITE_F64(t)
                && PTC_FINITE_F64(x[0])
                && PTC_FINITE_F64(x[1])
                && PTC_FINITE_F64(x[2])) {
                if (PTC_FINITE_F64(v)) {
                    if (v > 50.0) {
                        *u = 50.0;
                        status = PTC_SATURATED;
                    } else if (v < -50.0) {
                        *u = -50.0;
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

ptc_status ptc_exp3_fixed_tick(const ptc_exp3_fixed *self, double t, ptc_exp3_fixed_gains *gains)
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (gains != NULL)) {
        if (PTC_FINITE_F64(t) && (t >= self->t0)) {
            const double past = (t - self->deadline) - self->correction;
            const double late = (past < -0.001) ? past : -0.001;
            const double inv_T = (-1.0) / late;
            gains->gain[0] = (-120.0) * (inv_T * inv_T) * inv_T;
            gains->gain[1] = (-60.0) * inv_T * inv_T;
            gains->gain[2] = (-12.0) * inv_T;
            if (late < -0.001) {
                status = PTC_OK;
            } else {
                status = PTC_HOLD;
            }
            gains->status = status;
        }
    }
    return status;
}

ptc_status ptc_exp3_fixed_axis(const ptc_exp3_fixed_gains *gains, const double x[3], double *u)
{
    ptc_status status = PTC_E_INPUT;

    if (u != NULL) {
        *u = 0.0;
    }
    if ((gains != NULL) && (x != NULL) && (u != NULL)) {
        const double s1 = (gains->gain[0] * x[0]) + (gains->gain[1] * x[1]);
        const double v = s1 + (gains->gain[2] * x[2]);
        *u = v;
        if (PTC_FINITE_F64(v) && (fabs(v) <= 50.0)) {
            status = gains->status;
        } else if (PTC_FINITE_F64(x[0]) && PTC_FINITE_F64(x[1]) && PTC_FINITE_F64(x[2])) {
            if (PTC_FINITE_F64(v)) {
                if (v > 50.0) {
                    *u = 50.0;
                    status = PTC_SATURATED;
                } else {
                    *u = -50.0;
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
