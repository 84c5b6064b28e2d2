/* Prescribed-time controller ptc_soft2: see ptc_soft2.h. DO NOT EDIT. */
#include "ptc_soft2.h"

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

ptc_status ptc_soft2_init(ptc_soft2 *self, const ptc_soft2_params *params)
{
    ptc_status status = PTC_E_PARAM;
    struct ptc_soft2 built;

    if ((self != NULL) && (params != NULL)) {
        const double tau = params->tau;
        const double t0 = params->t0;
        const double eps = params->eps;
        const double u_max = params->u_max;
        const double a = params->a;
        const double start = params->start;
        const double k1 = params->k[0];
        const double k2 = params->k[1];
        if (PTC_FINITE_F64(tau)
            && (1e-150 <= tau)
            && (tau <= 1e150)
            && PTC_FINITE_F64(t0)
            && (eps >= 1e-150)
            && (u_max > 0.0)
            && PTC_FINITE_F64(a)
            && (1e-150 <= a)
            && (a <= 1e150)
            && PTC_FINITE_F64(start)
            && (1e-12 <= start)
            && (start <= 1.0)
            && PTC_FINITE_F64(k1)
            && PTC_FINITE_F64(k2)
            && (eps < tau)) {
            const double K1 = k1 / (a * a);
            const double K2 = k2 / a;
            const double c1 = -K1;
            const double c2_0 = (-K2) + 1.0;
            const double first_slope = start * tau;
            const double softness = 1.0 - start;
            const double hold_after = tau - eps;
            const double hold_from = -eps;
            const double size_K1 = (fabs(k1) <= 0.0) ? 1e-200 : fabs(K1);
            const double size_K2 = (fabs(k2) <= 0.0) ? 1e-200 : fabs(K2);
            if ((size_K1 >= 1e-200)
                && (size_K2 >= 1e-200)
                && PTC_FINITE_F64(c1)
                && PTC_FINITE_F64(c2_0)
                && PTC_FINITE_F64(first_slope)
                && PTC_FINITE_F64(softness)
                && PTC_FINITE_F64(hold_after)
                && PTC_FINITE_F64(hold_from)) {
                built.c1 = c1;
                built.c2_0 = c2_0;
                built.tau = tau;
                built.first_slope = first_slope;
                built.softness = softness;
                built.eps = eps;
                built.hold_after = hold_after;
                built.hold_from = hold_from;
                built.u_max = u_max;
                built.t0 = 0.0;
                built.deadline = 0.0;
                built.correction = 0.0;
                status = ptc_soft2_arm(&built, t0);
                if (status == PTC_OK) {
                    *self = built;
                }
            }
        }
    }
    return status;
}

ptc_status ptc_soft2_arm(ptc_soft2 *self, double t0)
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

ptc_status ptc_soft2_step(const ptc_soft2 *self, double t, const double x[2], double *u)
{
    ptc_status status = PTC_E_INPUT;

    if (u != NULL) {
        *u = 0.0;
    }
    if ((self != NULL) && (x != NULL) && (u != NULL)) {
        if (PTC_FINITE_F64(t) && (t >= self->t0)) {
            const double v1 = t - self->t0;
            const double elapsed = (v1 < self->hold_after) ? v1 : self->hold_after;
            const double past = (t - self->deadline) - self->correction;
            const double late = (past < self->hold_from) ? past : self->hold_from;
            const double T = -late;
            const double v2 = self->softness * elapsed;
            const double decay = T * (self->tau + v2);
            const double fall = self->first_slope + (2.0 * v2);
            const double inv_H = fall / decay;
            const double y = self->softness / (fall * inv_H);
            const double row2 = (2.0 * y) + self->c2_0;
            const double v = ((self->c1 * x[0] * inv_H) + (row2 * x[1])) * inv_H;
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

ptc_status ptc_soft2_tick(const ptc_soft2 *self, double t, ptc_soft2_gains *gains)
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (gains != NULL)) {
        if (PTC_FINITE_F64(t) && (t >= self->t0)) {
            const double v1 = t - self->t0;
            const double elapsed = (v1 < self->hold_after) ? v1 : self->hold_after;
            const double past = (t - self->deadline) - self->correction;
            const double late = (past < self->hold_from) ? past : self->hold_from;
            const double T = -late;
            const double v2 = self->softness * elapsed;
            const double decay = T * (self->tau + v2);
            const double fall = self->first_slope + (2.0 * v2);
            const double inv_H = fall / decay;
            const double y = self->softness / (fall * inv_H);
            const double row2 = (2.0 * y) + self->c2_0;
            gains->gain[0] = self->c1 * inv_H * inv_H;
            gains->gain[1] = row2 * inv_H;
            gains->u_max = self->u_max;
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

ptc_status ptc_soft2_axis(const ptc_soft2_gains *gains, const double x[2], double *u)
{
    ptc_status status = PTC_E_INPUT;

    if (u != NULL) {
        *u = 0.0;
    }
    if ((gains != NULL) && (x != NULL) && (u != NULL)) {
        const double v = (gains->gain[0] * x[0]) + (gains->gain[1] * x[1]);
        *u = v;
        if (PTC_FINITE_F64(v) && (fabs(v) <= gains->u_max)) {
            status = gains->status;
        } else if (PTC_FINITE_F64(x[0]) && PTC_FINITE_F64(x[1])) {
            if (PTC_FINITE_F64(v)) {
                if (v > gains->u_max) {
                    *u = gains->u_max;
                    status = PTC_SATURATED;
                } else {
                    *u = -gains->u_max;
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
