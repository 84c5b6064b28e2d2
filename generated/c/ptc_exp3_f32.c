/* Prescribed-time controller ptc_exp3_f32: see ptc_exp3_f32.h. DO NOT EDIT. */
#include "ptc_exp3_f32.h"

#include <float.h>
#include <math.h>
#include <stddef.h>

/* What this file requires of its compiler. */
#if (defined(FLT_MANT_DIG) && (FLT_MANT_DIG != 24))
#error "float is not IEEE 754 binary32 here"
#endif
#if defined(FLT_EVAL_METHOD) && !defined(PTC_ALLOW_EXCESS_PRECISION)
#if (FLT_EVAL_METHOD > 0) && (FLT_EVAL_METHOD < 3)
#error "float is computed with more digits than it has: on x86 compile with -msse2 -mfpmath=sse, or define PTC_ALLOW_EXCESS_PRECISION"
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

#if !defined(PTC_FINITE_F32)
#if defined(isfinite) && !defined(__MINGW32__)
#define PTC_FINITE_F32(x) (isfinite(x) != 0)
#else
#define PTC_FINITE_F32(x) (fabsf(x) <= FLT_MAX)
#endif
#endif

ptc_status ptc_exp3_f32_init(ptc_exp3_f32 *self, const ptc_exp3_f32_params *params)
{
    ptc_status status = PTC_E_PARAM;
    struct ptc_exp3_f32 built;

    if ((self != NULL) && (params != NULL)) {
        const float tau = params->tau;
        const float t0 = params->t0;
        const float eps = params->eps;
        const float u_max = params->u_max;
        const float a = params->a;
        const float k1 = params->k[0];
        const float k2 = params->k[1];
        const float k3 = params->k[2];
        if (PTC_FINITE_F32(tau)
            && (1e-18f <= tau)
            && (tau <= 1e18f)
            && PTC_FINITE_F32(t0)
            && (eps >= 1e-18f)
            && (u_max > 0.0f)
            && PTC_FINITE_F32(a)
            && (1e-18f <= a)
            && (a <= 1e18f)
            && PTC_FINITE_F32(k1)
            && PTC_FINITE_F32(k2)
            && PTC_FINITE_F32(k3)
            && (eps < tau)) {
            const float v1 = a * a;
            const float v2 = a * v1;
            const float K1 = k1 / v2;
            const float K2 = k2 / v1;
            const float K3 = k3 / a;
            const float c1 = -K1;
            const float c2 = ((-K2) + K3) - 1.0f;
            const float c3 = (-K3) + 3.0f;
            const float hold_from = -eps;
            const float size_K1 = (fabsf(k1) <= 0.0f) ? 1e-30f : fabsf(K1);
            const float size_K2 = (fabsf(k2) <= 0.0f) ? 1e-30f : fabsf(K2);
            const float size_K3 = (fabsf(k3) <= 0.0f) ? 1e-30f : fabsf(K3);
            if ((v2 >= 1e-30f)
                && (size_K1 >= 1e-30f)
                && (size_K2 >= 1e-30f)
                && (size_K3 >= 1e-30f)
                && PTC_FINITE_F32(c1)
                && PTC_FINITE_F32(c2)
                && PTC_FINITE_F32(c3)
                && PTC_FINITE_F32(hold_from)) {
                built.c1 = c1;
                built.c2 = c2;
                built.c3 = c3;
                built.tau = tau;
                built.eps = eps;
                built.hold_from = hold_from;
                built.u_max = u_max;
                built.t0 = 0.0f;
                built.deadline = 0.0f;
                built.correction = 0.0f;
                status = ptc_exp3_f32_arm(&built, t0);
                if (status == PTC_OK) {
                    *self = built;
                }
            }
        }
    }
    return status;
}

ptc_status ptc_exp3_f32_arm(ptc_exp3_f32 *self, float t0)
{
    ptc_status status = PTC_E_PARAM;

    if (self != NULL) {
        if (PTC_FINITE_F32(t0)) {
            const float deadline = t0 + self->tau;
            const float v1 = deadline - t0;
            const float correction = (t0 - (deadline - v1)) + (self->tau - v1);
            if (PTC_FINITE_F32(deadline)) {
                self->t0 = t0;
                self->deadline = deadline;
                self->correction = correction;
                status = PTC_OK;
            }
        }
    }
    return status;
}

ptc_status ptc_exp3_f32_step(const ptc_exp3_f32 *self, float t, const float x[3], float *u)
{
    ptc_status status = PTC_E_INPUT;

    if (u != NULL) {
        *u = 0.0f;
    }
    if ((self != NULL) && (x != NULL) && (u != NULL)) {
        if (t >= self->t0) {
            const float past = (t - self->deadline) - self->correction;
            const float late = (past < self->hold_from) ? past : self->hold_from;
            const float inv_T = (-1.0f) / late;
            const float s1 = ((self->c1 * x[0] * inv_T) + (self->c2 * x[1])) * inv_T;
            const float v = (s1 + (self->c3 * x[2])) * inv_T;
            *u = v;
            if (PTC_FINITE_F32(v) && (fabsf(v) <= self->u_max) && (late < self->hold_from)) {
                status = PTC_OK;
            } else if (PTC_FINITE_F32(t)
                && PTC_FINITE_F32(x[0])
                && PTC_FINITE_F32(x[1])
                && PTC_FINITE_F32(x[2])) {
                if (PTC_FINITE_F32(v)) {
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
                    *u = 0.0f;
                    status = PTC_E_RANGE;
                }
            } else {
                *u = 0.0f;
                status = PTC_E_INPUT;
            }
        }
    }
    return status;
}

ptc_status ptc_exp3_f32_tick(const ptc_exp3_f32 *self, float t, ptc_exp3_f32_gains *gains)
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (gains != NULL)) {
        if (PTC_FINITE_F32(t) && (t >= self->t0)) {
            const float past = (t - self->deadline) - self->correction;
            const float late = (past < self->hold_from) ? past : self->hold_from;
            const float inv_T = (-1.0f) / late;
            gains->gain[0] = self->c1 * (inv_T * inv_T) * inv_T;
            gains->gain[1] = self->c2 * inv_T * inv_T;
            gains->gain[2] = self->c3 * inv_T;
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

ptc_status ptc_exp3_f32_axis(const ptc_exp3_f32_gains *gains, const float x[3], float *u)
{
    ptc_status status = PTC_E_INPUT;

    if (u != NULL) {
        *u = 0.0f;
    }
    if ((gains != NULL) && (x != NULL) && (u != NULL)) {
        const float s1 = (gains->gain[0] * x[0]) + (gains->gain[1] * x[1]);
        const float v = s1 + (gains->gain[2] * x[2]);
        *u = v;
        if (PTC_FINITE_F32(v) && (fabsf(v) <= gains->u_max)) {
            status = gains->status;
        } else if (PTC_FINITE_F32(x[0]) && PTC_FINITE_F32(x[1]) && PTC_FINITE_F32(x[2])) {
            if (PTC_FINITE_F32(v)) {
                if (v > gains->u_max) {
                    *u = gains->u_max;
                    status = PTC_SATURATED;
                } else {
                    *u = -gains->u_max;
                    status = PTC_SATURATED;
                }
            } else {
                *u = 0.0f;
                status = PTC_E_RANGE;
            }
        } else {
            *u = 0.0f;
            status = PTC_E_INPUT;
        }
    }
    return status;
}
