/* Prescribed-time controller tank: see tank.h. DO NOT EDIT. */
#include "tank.h"

#include <float.h>
#include <math.h>
#include <stddef.h>
#include <stdint.h>

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

ptc_status tank_init(tank *self, const tank_params *params)
{
    ptc_status status = PTC_E_PARAM;
    struct tank built;

    if ((self != NULL) && (params != NULL)) {
        const double t0 = params->t0;
        if (PTC_FINITE_F64(t0)) {
            built.t0 = 0.0;
            built.deadline = 0.0;
            built.correction = 0.0;
            status = tank_arm(&built, t0);
            if (status == PTC_OK) {
                *self = built;
            }
        }
    }
    return status;
}

ptc_status tank_arm(tank *self, double t0)
{
    ptc_status status = PTC_E_PARAM;

    if (self != NULL) {
        if (PTC_FINITE_F64(t0)) {
            const double deadline = t0 + 30.0;
            const double v1 = deadline - t0;
            const double correction = (t0 - (deadline - v1)) + (30.0 - v1);
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

ptc_status tank_step(
    const tank *self,
    double t,
    const double x[3],
    double u[2],
    ptc_status axes[2])
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (x != NULL) && (u != NULL) && (axes != NULL)) {
        const double x1 = x[0];
        const double x2 = x[1];
        const double x3 = x[2];
        if (PTC_FINITE_F64(t)
            && (t >= self->t0)
            && PTC_FINITE_F64(x1)
            && PTC_FINITE_F64(x2)
            && PTC_FINITE_F64(x3)) {
            const double past = (t - self->deadline) - self->correction;
            const double late = (past < -0.5) ? past : -0.5;
            const double drift_axis1 = (-x1) * 0.1;
            const double wanted_axis1 = ((4.0 * x1) / late) - drift_axis1;
            const double inv_T_axis2 = (-1.0) / late;
            const double v1 = x2 - x3;
            const double determinant = 1.0 + x1;
            const double chain2_axis2 = v1 * determinant;
            const double s1 = (((-x2) * determinant) - chain2_axis2) * determinant;
            const double drift_axis2 = s1 + (v1 * drift_axis1);
            const double s2 = ((-12.0) * x3 * inv_T_axis2) + ((-6.0) * chain2_axis2);
            const double wanted_axis2 = (s2 * inv_T_axis2) - drift_axis2;
            const double over_determinant = 1.0 / (((determinant < 0.0) || (determinant > 0.0)) ? determinant : (double)NAN);
            const double control1 = determinant * wanted_axis1 * over_determinant;
            const double control2 = (((-v1) * wanted_axis1) + wanted_axis2) * over_determinant;
            if (late < -0.5) {
                status = PTC_OK;
            } else {
                status = PTC_HOLD;
            }
            if (PTC_FINITE_F64(control1) && PTC_FINITE_F64(control2)) {
                u[0] = control1;
                axes[0] = status;
                u[1] = control2;
                axes[1] = status;
                if (control1 > 2.0) {
                    u[0] = 2.0;
                    axes[0] = PTC_SATURATED;
                    status = PTC_SATURATED;
                } else if (control1 < -2.0) {
                    u[0] = -2.0;
                    axes[0] = PTC_SATURATED;
                    status = PTC_SATURATED;
                } else {
                    /* neither */
                }
                if (control2 > 50.0) {
                    u[1] = 50.0;
                    axes[1] = PTC_SATURATED;
                    status = PTC_SATURATED;
                } else if (control2 < -50.0) {
                    u[1] = -50.0;
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
        } else {
            for (uint32_t i = 0U; i < 2U; i++) {
                u[i] = 0.0;
                axes[i] = PTC_E_INPUT;
            }
        }
    } else {
        if (u != NULL) {
            for (uint32_t i = 0U; i < 2U; i++) {
                u[i] = 0.0;
            }
        }
        if (axes != NULL) {
            for (uint32_t i = 0U; i < 2U; i++) {
                axes[i] = PTC_E_INPUT;
            }
        }
    }
    return status;
}
