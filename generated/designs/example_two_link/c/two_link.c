/* Prescribed-time controller two_link: see two_link.h. DO NOT EDIT. */
#include "two_link.h"

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

ptc_status two_link_init(two_link *self, const two_link_params *params)
{
    ptc_status status = PTC_E_PARAM;
    struct two_link built;

    if ((self != NULL) && (params != NULL)) {
        const double t0 = params->t0;
        if (PTC_FINITE_F64(t0)) {
            built.t0 = 0.0;
            built.deadline = 0.0;
            built.correction = 0.0;
            status = two_link_arm(&built, t0);
            if (status == PTC_OK) {
                *self = built;
            }
        }
    }
    return status;
}

ptc_status two_link_arm(two_link *self, double t0)
{
    ptc_status status = PTC_E_PARAM;

    if (self != NULL) {
        if (PTC_FINITE_F64(t0)) {
            const double deadline = t0 + 20.0;
            const double v1 = deadline - t0;
            const double correction = (t0 - (deadline - v1)) + (20.0 - v1);
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

ptc_status two_link_step(
    const two_link *self,
    double t,
    const double x[4],
    double u[2],
    ptc_status axes[2])
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (x != NULL) && (u != NULL) && (axes != NULL)) {
        const double x1 = x[0];
        const double x2 = x[1];
        const double x3 = x[2];
        const double x4 = x[3];
        if (PTC_FINITE_F64(t)
            && (t >= self->t0)
            && PTC_FINITE_F64(x1)
            && PTC_FINITE_F64(x2)
            && PTC_FINITE_F64(x3)
            && PTC_FINITE_F64(x4)) {
            const double past = (t - self->deadline) - self->correction;
            const double late = (past < -1.0) ? past : -1.0;
            const double row2_axis1 = ((-2.0) * late) - 1000.0;
            const double inv_T_squared_axis1 = 1.0 / (late * late);
            const double s1 = ((-240000.0) * x1 * inv_T_squared_axis1) + (row2_axis1 * x3);
            const double wanted_axis1 = s1 * inv_T_squared_axis1;
            const double s2 = ((-240000.0) * x2 * inv_T_squared_axis1) + (row2_axis1 * x4);
            const double wanted_axis2 = s2 * inv_T_squared_axis1;
            const double v1 = sin(x2);
            const double v2 = 7.3575 * cos(x1 + x2);
            const double v3 = cos(x2);
            const double v4 = 0.375 + (0.44999999999999996 * v3);
            const double s3 = (1.635 + (0.8999999999999999 * v3)) * wanted_axis1;
            const double s4 = (-0.44999999999999996) * v1 * ((2.0 * x3 * x4) + (x4 * x4));
            const double control1 = s3 + (v4 * wanted_axis2) + (s4 + (20.601 * cos(x1)) + v2);
            const double s5 = (v4 * wanted_axis1) + (0.375 * wanted_axis2);
            const double control2 = s5 + ((0.44999999999999996 * v1 * (x3 * x3)) + v2);
            if (late < -1.0) {
                status = PTC_OK;
            } else {
                status = PTC_HOLD;
            }
            if (PTC_FINITE_F64(control1) && PTC_FINITE_F64(control2)) {
                u[0] = control1;
                axes[0] = status;
                u[1] = control2;
                axes[1] = status;
                if (control1 > 120.0) {
                    u[0] = 120.0;
                    axes[0] = PTC_SATURATED;
                    status = PTC_SATURATED;
                } else if (control1 < -120.0) {
                    u[0] = -120.0;
                    axes[0] = PTC_SATURATED;
                    status = PTC_SATURATED;
                } else {
                    /* neither */
                }
                if (control2 > 60.0) {
                    u[1] = 60.0;
                    axes[1] = PTC_SATURATED;
                    status = PTC_SATURATED;
                } else if (control2 < -60.0) {
                    u[1] = -60.0;
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
