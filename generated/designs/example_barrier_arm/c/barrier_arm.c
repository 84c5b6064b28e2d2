/* Prescribed-time controller barrier_arm: see barrier_arm.h. DO NOT EDIT. */
#include "barrier_arm.h"

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

ptc_status barrier_arm_init(barrier_arm *self, const barrier_arm_params *params)
{
    ptc_status status = PTC_E_PARAM;
    struct barrier_arm built;

    if ((self != NULL) && (params != NULL)) {
        const double t0 = params->t0;
        if (PTC_FINITE_F64(t0)) {
            built.t0 = 0.0;
            built.deadline = 0.0;
            built.correction = 0.0;
            status = barrier_arm_arm(&built, t0);
            if (status == PTC_OK) {
                *self = built;
            }
        }
    }
    return status;
}

ptc_status barrier_arm_arm(barrier_arm *self, double t0)
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

ptc_status barrier_arm_step(
    const barrier_arm *self,
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
            const double T_axis1 = -late;
            const double unit_axis1 = (0.05 * T_axis1) / 20.0;
            const double v1 = T_axis1 * unit_axis1;
            const double inv_r1_axis1 = 1.0 / v1;
            const double xi2_axis1 = x3 * v1;
            const double xi2_axis2 = x4 * v1;
            const double v2 = cos(x2);
            const double v3 = 1.635 + (0.8999999999999999 * v2);
            const double v4 = 0.375 + (0.44999999999999996 * v2);
            const double v5 = 1.0 / ((v3 * 0.375) - (v4 * v4));
            const double v6 = sin(x2);
            const double v7 = x1 * 0.8333333333333334;
            const double s1 = (2.0 * xi2_axis1 * xi2_axis2) + (xi2_axis2 * xi2_axis2);
            const double s2 = (0.45 * v6 * s1) - ((3.0 * x1) / (1.0 - (v7 * v7)));
            const double v8 = s2 - (4.0 * xi2_axis1);
            const double v9 = (-v4) * v5;
            const double v10 = x2 * 1.25;
            const double s3 = (-0.45) * v6 * (xi2_axis1 * xi2_axis1);
            const double v11 = (s3 - ((3.0 * x2) / (1.0 - (v10 * v10)))) - (4.0 * xi2_axis2);
            const double law_axis1 = (0.375 * v5 * v8) + (v9 * v11);
            const double v12 = (-2.0) * (-unit_axis1);
            const double wanted_axis1 = ((law_axis1 * inv_r1_axis1) + (v12 * x3)) * inv_r1_axis1;
            const double law_axis2 = (v9 * v8) + (v3 * v5 * v11);
            const double wanted_axis2 = ((law_axis2 * inv_r1_axis1) + (v12 * x4)) * inv_r1_axis1;
            const double v13 = 7.3575 * cos(x1 + x2);
            const double s4 = (-0.44999999999999996) * v6 * ((2.0 * x3 * x4) + (x4 * x4));
            const double s5 = (v3 * wanted_axis1) + (v4 * wanted_axis2);
            const double control1 = s5 + (s4 + (20.601 * cos(x1)) + v13);
            const double s6 = (v4 * wanted_axis1) + (0.375 * wanted_axis2);
            const double control2 = s6 + ((0.44999999999999996 * v6 * (x3 * x3)) + v13);
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
