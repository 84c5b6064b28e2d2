/* Prescribed-time controller ptc_power2_unbounded: see ptc_power2_unbounded.h. DO NOT EDIT. */
#include "ptc_power2_unbounded.h"

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

ptc_status ptc_power2_unbounded_init(
    ptc_power2_unbounded *self,
    const ptc_power2_unbounded_params *params)
{
    ptc_status status = PTC_E_PARAM;
    struct ptc_power2_unbounded built;

    if ((self != NULL) && (params != NULL)) {
        const double tau = params->tau;
        const double t0 = params->t0;
        const double eps = params->eps;
        if (PTC_FINITE_F64(tau)
            && (1e-150 <= tau)
            && (tau <= 1e150)
            && PTC_FINITE_F64(t0)
            && (1e-150 <= eps)
            && (eps < tau)) {
            const double hold_from = -eps;
            const double minus_tau = -tau;
            const double inv_tau = 1.0 / tau;
            if (PTC_FINITE_F64(hold_from) && PTC_FINITE_F64(minus_tau) && PTC_FINITE_F64(inv_tau)) {
                built.tau = tau;
                built.eps = eps;
                built.hold_from = hold_from;
                built.minus_tau = minus_tau;
                built.inv_tau = inv_tau;
                built.t0 = 0.0;
                built.deadline = 0.0;
                built.correction = 0.0;
                status = ptc_power2_unbounded_arm(&built, t0);
                if (status == PTC_OK) {
                    *self = built;
                }
            }
        }
    }
    return status;
}

ptc_status ptc_power2_unbounded_arm(ptc_power2_unbounded *self, double t0)
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

ptc_status ptc_power2_unbounded_step(
    const ptc_power2_unbounded *self,
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
            const double inv_w = self->minus_tau / late;
            const double q = inv_w * inv_w;
            const double v1 = (-4.0) * q;
            const double row1 = v1 * q;
            const double row2 = v1 + 3.0;
            const double inv_T = inv_w * self->inv_tau;
            const double v = ((row1 * x[0] * inv_T) + (row2 * x[1])) * inv_T;
            *u = v;
            if (PTC_FINITE_F64(v) && (late < self->hold_from)) {
                status = PTC_OK;
            } else if (PTC_FINITE_F64(t) && PTC_FINITE_F64(x[0]) && PTC_FINITE_F64(x[1])) {
                if (PTC_FINITE_F64(v)) {
                    status = PTC_HOLD;
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

ptc_status ptc_power2_unbounded_tick(
    const ptc_power2_unbounded *self,
    double t,
    ptc_power2_unbounded_gains *gains)
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (gains != NULL)) {
        if (PTC_FINITE_F64(t) && (t >= self->t0)) {
            const double past = (t - self->deadline) - self->correction;
            const double late = (past < self->hold_from) ? past : self->hold_from;
            const double inv_w = self->minus_tau / late;
            const double q = inv_w * inv_w;
            const double v1 = (-4.0) * q;
            const double row1 = v1 * q;
            const double row2 = v1 + 3.0;
            const double inv_T = inv_w * self->inv_tau;
            gains->gain[0] = row1 * inv_T * inv_T;
            gains->gain[1] = row2 * inv_T;
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

ptc_status ptc_power2_unbounded_axis(
    const ptc_power2_unbounded_gains *gains,
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
        if (PTC_FINITE_F64(v)) {
            status = gains->status;
        } else if (PTC_FINITE_F64(x[0]) && PTC_FINITE_F64(x[1])) {
            *u = 0.0;
            status = PTC_E_RANGE;
        } else {
            *u = 0.0;
            status = PTC_E_INPUT;
        }
    }
    return status;
}
