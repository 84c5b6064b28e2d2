/* Prescribed-time controller mix_fixed: see mix_fixed.h. DO NOT EDIT. */
#include "mix_fixed.h"

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

ptc_status mix_fixed_init(mix_fixed *self, const mix_fixed_params *params)
{
    ptc_status status = PTC_E_PARAM;
    struct mix_fixed built;

    if ((self != NULL) && (params != NULL)) {
        const double t0 = params->t0;
        if (PTC_FINITE_F64(t0)) {
            built.deadline = 0.0;
            built.correction = 0.0;
            status = mix_fixed_arm(&built, t0);
            if (status == PTC_OK) {
                *self = built;
            }
        }
    }
    return status;
}

ptc_status mix_fixed_arm(mix_fixed *self, double t0)
{
    ptc_status status = PTC_E_PARAM;

    if (self != NULL) {
        if (PTC_FINITE_F64(t0)) {
            const double deadline = t0 + 1.0;
            const double v1 = deadline - t0;
            const double correction = (t0 - (deadline - v1)) + (1.0 - v1);
            if (PTC_FINITE_F64(deadline)) {
                self->deadline = deadline;
                self->correction = correction;
                status = PTC_OK;
            }
        }
    }
    return status;
}

ptc_status mix_fixed_step(
    const mix_fixed *self,
    double t,
    const double x[3],
    double u[2],
    ptc_status axes[2])
{
    ptc_status status = PTC_OK;

    const double x1 = x[0];
    const double x2 = x[1];
    const double x3 = x[2];
    const double past = (t - self->deadline) - self->correction;
    const double late = (past < -0.01) ? past : -0.01;
    const double inv_T_axis1 = (-1.0) / late;
    const double drift_axis1 = -x2;
    const double s1 = (((-20.0) * x1 * inv_T_axis1) + ((-8.0) * x2)) * inv_T_axis1;
    const double wanted_axis1 = s1 - drift_axis1;
    const double drift_axis2 = x2 * x3;
    const double wanted_axis2 = ((-3.0) * x3 * inv_T_axis1) - drift_axis2;
    const double v1 = 2.0 + sin(x1);
    const double v2 = x3 * x3;
    const double v3 = 2.0 + v2;
    const double determinant = (v1 * v3) - v2;
    const double over_determinant = 1.0 / (((determinant < 0.0) || (determinant > 0.0)) ? determinant : (double)NAN);
    const double v4 = -x3;
    const double s2 = ((v3 * wanted_axis1) + (v4 * wanted_axis2)) * over_determinant;
    const double control1 = s2 + (t - t);
    const double s3 = ((v4 * wanted_axis1) + (v1 * wanted_axis2)) * over_determinant;
    const double control2 = s3 + (t - t);
    if (late < -0.01) {
        status = PTC_OK;
    } else {
        status = PTC_HOLD;
    }
    if (PTC_FINITE_F64(control1) && PTC_FINITE_F64(control2)) {
        u[0] = control1;
        axes[0] = status;
        u[1] = control2;
        axes[1] = status;
        if (control1 > 40.0) {
            u[0] = 40.0;
            axes[0] = PTC_SATURATED;
            status = PTC_SATURATED;
        } else if (control1 < -40.0) {
            u[0] = -40.0;
            axes[0] = PTC_SATURATED;
            status = PTC_SATURATED;
        } else {
            /* neither */
        }
        if (control2 > 15.0) {
            u[1] = 15.0;
            axes[1] = PTC_SATURATED;
            status = PTC_SATURATED;
        } else if (control2 < -15.0) {
            u[1] = -15.0;
            axes[1] = PTC_SATURATED;
            status = PTC_SATURATED;
        } else {
            /* neither */
        }
    } else {
        u[0] = 0.0;
        if (PTC_FINITE_F64(control1)) {
            axes[0] = status;
        } else {
            axes[0] = PTC_E_RANGE;
        }
        u[1] = 0.0;
        if (PTC_FINITE_F64(control2)) {
            axes[1] = status;
        } else {
            axes[1] = PTC_E_RANGE;
        }
        status = PTC_E_RANGE;
    }
    return status;
}
