/* Prescribed-time controller mix: see mix.h. DO NOT EDIT. */
#include "mix.h"

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

ptc_status mix_init(mix *self, const mix_params *params)
{
    ptc_status status = PTC_E_PARAM;
    struct mix built;

    if ((self != NULL) && (params != NULL)) {
        const double tau = params->tau;
        const double t0 = params->t0;
        const double eps = params->eps;
        const double u_max = params->u_max;
        if (PTC_FINITE_F64(tau)
            && (1e-150 <= tau)
            && (tau <= 1e150)
            && PTC_FINITE_F64(t0)
            && (eps >= 1e-150)
            && (u_max > 0.0)
            && (eps < tau)) {
            const double hold_from = -eps;
            if (PTC_FINITE_F64(hold_from)) {
                built.tau = tau;
                built.eps = eps;
                built.hold_from = hold_from;
                built.u_max = u_max;
                built.t0 = 0.0;
                built.deadline = 0.0;
                built.correction = 0.0;
                status = mix_arm(&built, t0);
                if (status == PTC_OK) {
                    *self = built;
                }
            }
        }
    }
    return status;
}

ptc_status mix_arm(mix *self, double t0)
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

ptc_status mix_step(const mix *self, double t, const double x[3], double u[2], ptc_status axes[2])
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
            const double late = (past < self->hold_from) ? past : self->hold_from;
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
            const double control1 = ((v3 * wanted_axis1) + (v4 * wanted_axis2)) * over_determinant;
            const double control2 = ((v4 * wanted_axis1) + (v1 * wanted_axis2)) * over_determinant;
            if (late < self->hold_from) {
                status = PTC_OK;
            } else {
                status = PTC_HOLD;
            }
            if (PTC_FINITE_F64(control1) && PTC_FINITE_F64(control2)) {
                u[0] = control1;
                axes[0] = status;
                u[1] = control2;
                axes[1] = status;
                if (control1 > self->u_max) {
                    u[0] = self->u_max;
                    axes[0] = PTC_SATURATED;
                    status = PTC_SATURATED;
                } else if (control1 < -self->u_max) {
                    u[0] = -self->u_max;
                    axes[0] = PTC_SATURATED;
                    status = PTC_SATURATED;
                } else {
                    /* neither */
                }
                if (control2 > self->u_max) {
                    u[1] = self->u_max;
                    axes[1] = PTC_SATURATED;
                    status = PTC_SATURATED;
                } else if (control2 < -self->u_max) {
                    u[1] = -self->u_max;
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
