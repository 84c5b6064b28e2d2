/* Prescribed-time controller stage10: see stage10.h. DO NOT EDIT. */
#include "stage10.h"

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

/* Numbers of the design, each rounded once. */
#define STAGE10_DEADBEAT 20.0f /* samples to go at which deadbeat takes over */

ptc_status stage10_init(stage10 *self, const stage10_params *params)
{
    ptc_status status = PTC_E_PARAM;

    if ((self != NULL) && (params != NULL)) {
        if ((params->samples > 1U)
            && (1e-18f <= params->h)
            && (params->h <= 1e18f)
            && (params->u_max > 0.0f)
            && PTC_FINITE_F32(params->k[0])
            && PTC_FINITE_F32(params->k[1])) {
            const uint32_t samples = params->samples;
            const float w1_1 = (-(params->k[0] / 1.69f)) * (1.0f / (params->h * params->h));
            const float w1_2 = (-0.5f) * (-(params->k[0] / 1.69f)) * (1.0f / params->h);
            const float w2_2 = (1.0f - (params->k[1] / 1.3f)) * (1.0f / params->h);
            const float b_1 = -(1.0f / (params->h * params->h));
            const float b_2 = (-1.5f) * (1.0f / params->h);
            const float u_max = params->u_max;
            if (PTC_FINITE_F32(w1_1)
                && PTC_FINITE_F32(w1_2)
                && PTC_FINITE_F32(w2_2)
                && PTC_FINITE_F32(b_1)
                && PTC_FINITE_F32(b_2)
                && (params->h * params->h >= 1e-30f)
                && (1.0f / (params->h * params->h) >= 1e-30f)) {
                self->start = 0U;
                self->samples = samples;
                self->w1_1 = w1_1;
                self->w1_2 = w1_2;
                self->w2_2 = w2_2;
                self->b_1 = b_1;
                self->b_2 = b_2;
                self->u_max = u_max;
                status = PTC_OK;
            }
        }
    }
    return status;
}

ptc_status stage10_arm(stage10 *self, uint32_t k)
{
    ptc_status status = PTC_E_INPUT;

    if (self != NULL) {
        self->start = k;
        status = PTC_OK;
    }
    return status;
}

ptc_status stage10_step(const stage10 *self, uint32_t k, const float x[2], float *u)
{
    ptc_status status = PTC_E_INPUT;

    if (u != NULL) {
        *u = 0.0f;
    }
    if ((self != NULL) && (x != NULL) && (u != NULL)) {
        if (PTC_FINITE_F32(x[0]) && PTC_FINITE_F32(x[1])) {
            const uint32_t elapsed = k - self->start;
            const float x1 = x[0];
            const float x2 = x[1];
            const uint32_t left = (elapsed < self->samples) ? (self->samples - elapsed) : 0U;
            const float m0 = (float)left;
            float v;
            if (m0 > STAGE10_DEADBEAT) {
                /* The exact law in samples. */
                const float z1 = (self->w1_1 * x1) + (self->w1_2 * x2);
                const float z2 = self->w2_2 * x2;
                v = (z1 + (z2 * m0)) / (m0 * (m0 - 1.0f));
            } else {
                /* Deadbeat. */
                v = (self->b_1 * x1) + (self->b_2 * x2);
            }
            if (PTC_FINITE_F32(v)) {
                if (v > self->u_max) {
                    *u = self->u_max;
                    status = PTC_SATURATED;
                } else if (v < -self->u_max) {
                    *u = -self->u_max;
                    status = PTC_SATURATED;
                } else if (elapsed < self->samples) {
                    *u = v;
                    status = PTC_OK;
                } else {
                    *u = v;
                    status = PTC_HOLD;
                }
            } else {
                status = PTC_E_RANGE;
            }
        }
    }
    return status;
}
