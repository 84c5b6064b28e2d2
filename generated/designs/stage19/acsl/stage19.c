/* Prescribed-time controller stage19: see stage19.h. DO NOT EDIT. */
#include "stage19.h"

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

ptc_status stage19_init(stage19 *self, const stage19_params *params)
{
    ptc_status status = PTC_E_PARAM;

    if ((self != NULL) && (params != NULL)) {
        if ((params->samples > 2U)
            && (1e-18f <= params->h)
            && (params->h <= 1e18f)
            && PTC_FINITE_F32(params->k[0])
            && PTC_FINITE_F32(params->k[1])
            && PTC_FINITE_F32(params->k[2])
            && PTC_FINITE_F32(params->deadbeat)
            && (params->deadbeat >= 0.0f)) {
            const uint32_t samples = params->samples;
            const float s1 = (params->k[2] - 4.0f) + 3.0f;
            const float s2 = (s1 < 6.0f) ? 6.0f : s1;
            const float deadbeat = (params->deadbeat > 0.0f) ? params->deadbeat : s2;
            const float w1_1 = (-params->k[0]) * (1.0f / (params->h * params->h * params->h));
            const float w1_2 = params->k[0] * (1.0f / (params->h * params->h));
            const float w1_3 = 0.33333334f * (-params->k[0]) * (1.0f / params->h);
            const float s3 = ((-1.0f) - params->k[1]) + params->k[2];
            const float w2_2 = s3 * (1.0f / (params->h * params->h));
            const float s4 = (-0.5f) * (((-1.0f) - params->k[1]) + params->k[2]);
            const float w2_3 = s4 * (1.0f / params->h);
            const float w3_3 = (3.0f - params->k[2]) * (1.0f / params->h);
            const float b_1 = -(1.0f / (params->h * params->h * params->h));
            const float b_2 = (-2.0f) * (1.0f / (params->h * params->h));
            const float b_3 = (-1.8333334f) * (1.0f / params->h);
            if (PTC_FINITE_F32(deadbeat)
                && PTC_FINITE_F32(w1_1)
                && PTC_FINITE_F32(w1_2)
                && PTC_FINITE_F32(w1_3)
                && PTC_FINITE_F32(w2_2)
                && PTC_FINITE_F32(w2_3)
                && PTC_FINITE_F32(w3_3)
                && PTC_FINITE_F32(b_1)
                && PTC_FINITE_F32(b_2)
                && PTC_FINITE_F32(b_3)
                && (params->h * params->h * params->h >= 1e-30f)
                && (1.0f / (params->h * params->h * params->h) >= 1e-30f)) {
                self->start = 0U;
                self->samples = samples;
                self->deadbeat = deadbeat;
                self->w1_1 = w1_1;
                self->w1_2 = w1_2;
                self->w1_3 = w1_3;
                self->w2_2 = w2_2;
                self->w2_3 = w2_3;
                self->w3_3 = w3_3;
                self->b_1 = b_1;
                self->b_2 = b_2;
                self->b_3 = b_3;
                status = PTC_OK;
            }
        }
    }
    return status;
}

ptc_status stage19_arm(stage19 *self, uint32_t k)
{
    ptc_status status = PTC_OK;

    self->start = k;
    status = PTC_OK;
    return status;
}

ptc_status stage19_step(const stage19 *self, uint32_t k, const float x[3], float *u)
{
    ptc_status status = PTC_OK;

    const uint32_t elapsed = k - self->start;

    /* The chain of the output. */
    const float x1 = x[0];
    const float x2 = x[1];
    const float v1 = 1.0f + (x1 * x1);
    const float x3 = (x[2] / v1) - (x2 * 0.25f);
    const uint32_t left = (elapsed < self->samples) ? (self->samples - elapsed) : 0U;
    const float m0 = (float)left;
    float w;
    if (m0 > self->deadbeat) {
        /* The exact law in samples. */
        const float z1 = (self->w1_1 * x1) + (self->w1_2 * x2) + (self->w1_3 * x3);
        const float z2 = (self->w2_2 * x2) + (self->w2_3 * x3);
        const float z3 = self->w3_3 * x3;
        w = ((((z1 / m0) + z2) / (m0 - 1.0f)) + z3) / (m0 - 2.0f);
    } else {
        /* Deadbeat. */
        w = (self->b_1 * x1) + (self->b_2 * x2) + (self->b_3 * x3);
    }
    const float s1 = ((-50.0f) * (x2 + (2.0f * x[2])) * v1) - (x[2] * (2.0f * x1 * x2));
    const float v = (w - ((s1 / (v1 * v1)) - (x3 * 0.25f))) * v1 * 0.02f;
    if (PTC_FINITE_F32(v)) {
        if (elapsed < self->samples) {
            *u = v;
            status = PTC_OK;
        } else {
            *u = 0.0f;
            status = PTC_AFTER;
        }
    } else {
        *u = 0.0f;
        status = PTC_E_RANGE;
    }
    return status;
}
