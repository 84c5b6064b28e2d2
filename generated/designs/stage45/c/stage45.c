/* Prescribed-time controller stage45: see stage45.h. DO NOT EDIT. */
#include "stage45.h"

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
#define STAGE45_B_3 (-2.0f) /* weight of u1 in the law */
#define STAGE45_B_4 (-3.0f) /* weight of u2 in the law */
#define STAGE45_B_5 (-4.0f) /* weight of u3 in the law */
#define STAGE45_B_6 (-5.0f) /* weight of u4 in the law */
#define STAGE45_B_7 (-6.0f) /* weight of u5 in the law */

ptc_status stage45_init(stage45 *self, const stage45_params *params)
{
    ptc_status status = PTC_E_PARAM;

    if ((self != NULL) && (params != NULL)) {
        if ((params->samples > 6U)
            && (1e-18f <= params->h)
            && (params->h <= 1e18f)
            && (params->u_max > 0.0f)
            && (1e-18f <= params->a)
            && (params->a <= 1e18f)
            && PTC_FINITE_F32(params->k[0])
            && PTC_FINITE_F32(params->k[1])
            && PTC_FINITE_F32(params->deadbeat)
            && (params->deadbeat >= 0.0f)) {
            const uint32_t samples = params->samples;
            const float s1 = ((params->k[1] / params->a) - 1.0f) + 2.0f;
            const float s2 = (s1 < 4.0f) ? 4.0f : s1;
            const float deadbeat = (params->deadbeat > 0.0f) ? params->deadbeat : s2;
            const float s3 = -(params->k[0] / (params->a * params->a));
            const float w1_1 = s3 * (1.0f / (params->h * params->h));
            const float s4 = 4.5f * (-(params->k[0] / (params->a * params->a)));
            const float w1_2 = s4 * (1.0f / params->h);
            const float w1_4 = -(params->k[0] / (params->a * params->a));
            const float w1_5 = 2.0f * (-(params->k[0] / (params->a * params->a)));
            const float w1_6 = 3.0f * (-(params->k[0] / (params->a * params->a)));
            const float w1_7 = 4.0f * (-(params->k[0] / (params->a * params->a)));
            const float w2_2 = (1.0f - (params->k[1] / params->a)) * (1.0f / params->h);
            const float w2_3 = 1.0f - (params->k[1] / params->a);
            const float b_1 = -(1.0f / (params->h * params->h));
            const float b_2 = (-6.5f) * (1.0f / params->h);
            const float u_max = params->u_max;
            if (PTC_FINITE_F32(deadbeat)
                && PTC_FINITE_F32(w1_1)
                && PTC_FINITE_F32(w1_2)
                && PTC_FINITE_F32(w1_4)
                && PTC_FINITE_F32(w1_5)
                && PTC_FINITE_F32(w1_6)
                && PTC_FINITE_F32(w1_7)
                && PTC_FINITE_F32(w2_2)
                && PTC_FINITE_F32(w2_3)
                && PTC_FINITE_F32(b_1)
                && PTC_FINITE_F32(b_2)
                && (params->h * params->h >= 1e-30f)
                && (1.0f / (params->h * params->h) >= 1e-30f)) {
                self->start = 0U;
                self->samples = samples;
                self->u1 = 0.0f;
                self->u2 = 0.0f;
                self->u3 = 0.0f;
                self->u4 = 0.0f;
                self->u5 = 0.0f;
                self->deadbeat = deadbeat;
                self->w1_1 = w1_1;
                self->w1_2 = w1_2;
                self->w1_4 = w1_4;
                self->w1_5 = w1_5;
                self->w1_6 = w1_6;
                self->w1_7 = w1_7;
                self->w2_2 = w2_2;
                self->w2_3 = w2_3;
                self->b_1 = b_1;
                self->b_2 = b_2;
                self->u_max = u_max;
                status = PTC_OK;
            }
        }
    }
    return status;
}

ptc_status stage45_arm(stage45 *self, uint32_t k)
{
    ptc_status status = PTC_OK;

    self->start = k;
    status = PTC_OK;
    return status;
}

ptc_status stage45_step(stage45 *self, uint32_t k, const float x[2], float *u)
{
    ptc_status status = PTC_OK;

    *u = 0.0f;
    const uint32_t elapsed = k - self->start;
    const float x1 = x[0];
    const float x2 = x[1];
    const uint32_t left = (elapsed < self->samples) ? (self->samples - elapsed) : 0U;
    const float m0 = ((float)left) - 5.0f;
    float v;
    if (m0 > self->deadbeat) {
        /* The exact law in samples. */
        const float s1 = (self->w1_1 * x1) + (self->w1_2 * x2) + (self->w1_4 * self->u2);
        const float s2 = s1 + (self->w1_5 * self->u3) + (self->w1_6 * self->u4);
        const float z1 = s2 + (self->w1_7 * self->u5);
        const float s3 = (self->w2_2 * x2) + (self->w2_3 * self->u1);
        const float s4 = s3 + (self->w2_3 * self->u2) + (self->w2_3 * self->u3);
        const float z2 = s4 + (self->w2_3 * self->u4) + (self->w2_3 * self->u5);
        v = (z1 + (z2 * m0)) / (m0 * (m0 - 1.0f));
    } else {
        /* Deadbeat. */
        const float s5 = (self->b_1 * x1) + (self->b_2 * x2) + (STAGE45_B_3 * self->u1);
        const float s6 = s5 + (STAGE45_B_4 * self->u2) + (STAGE45_B_5 * self->u3);
        v = s6 + (STAGE45_B_6 * self->u4) + (STAGE45_B_7 * self->u5);
    }
    status = PTC_E_RANGE;
    if (PTC_FINITE_F32(v)) {
        float u_now;
        if (v > self->u_max) {
            u_now = self->u_max;
        } else if (v < -self->u_max) {
            u_now = -self->u_max;
        } else {
            u_now = v;
        }
        self->u5 = self->u4;
        self->u4 = self->u3;
        self->u3 = self->u2;
        self->u2 = self->u1;
        self->u1 = u_now;
        *u = u_now;
        if ((v > self->u_max) || (v < -self->u_max)) {
            status = PTC_SATURATED;
        } else if (elapsed < self->samples) {
            status = PTC_OK;
        } else {
            status = PTC_HOLD;
        }
    }
    return status;
}
