/* Prescribed-time controller stage30: see stage30.h. DO NOT EDIT. */
#include "stage30.h"

#include <float.h>
#include <math.h>
#include <stddef.h>
#include <stdint.h>

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
#define STAGE30_DEADBEAT_1 2.5f /* 5/2, samples to go at which deadbeat takes over */
#define STAGE30_DEADBEAT_2 2.5f /* 5/2, samples to go at which deadbeat takes over */

ptc_status stage30_init(stage30 *self, const stage30_params *params)
{
    ptc_status status = PTC_E_PARAM;

    if ((self != NULL) && (params != NULL)) {
        if ((params->samples > 2U)
            && (1e-18f <= params->h)
            && (params->h <= 1e18f)
            && (params->u_max > 0.0f)
            && (1e-18f <= params->a)
            && (params->a <= 1e18f)
            && PTC_FINITE_F32(params->k[0])
            && PTC_FINITE_F32(params->k[1])
            && PTC_FINITE_F32(params->k[2])
            && PTC_FINITE_F32(params->deadbeat)
            && (params->deadbeat >= 0.0f)) {
            const uint32_t samples = params->samples;
            const float hold = 0.02f / params->h;
            const float s1 = -(params->k[0] / (params->a * params->a * params->a));
            const float w1_1_1 = 0.33333334f * s1 * (1.0f / (params->h * params->h * params->h));
            const float s2 = -(params->k[0] / (params->a * params->a * params->a));
            const float w1_2_1 = (-0.33333334f) * s2 * (1.0f / (params->h * params->h));
            const float s3 = -(params->k[0] / (params->a * params->a * params->a));
            const float w1_3_1 = 0.11111111f * s3 * (1.0f / params->h);
            const float s4 = (-1.0f) - (params->k[1] / (params->a * params->a));
            const float s5 = 0.33333334f * (s4 + (params->k[2] / params->a));
            const float w2_2_1 = s5 * (1.0f / (params->h * params->h));
            const float s6 = (-1.0f) - (params->k[1] / (params->a * params->a));
            const float s7 = (-0.16666667f) * (s6 + (params->k[2] / params->a));
            const float w2_3_1 = s7 * (1.0f / params->h);
            const float s8 = 0.33333334f * (3.0f - (params->k[2] / params->a));
            const float w3_3_1 = s8 * (1.0f / params->h);
            const float b_1_1 = (-0.33333334f) * (1.0f / (params->h * params->h * params->h));
            const float b_2_1 = (-0.6666667f) * (1.0f / (params->h * params->h));
            const float b_3_1 = (-0.6111111f) * (1.0f / params->h);
            const float u_max = params->u_max;
            if (PTC_FINITE_F32(hold)
                && PTC_FINITE_F32(w1_1_1)
                && PTC_FINITE_F32(w1_2_1)
                && PTC_FINITE_F32(w1_3_1)
                && PTC_FINITE_F32(w2_2_1)
                && PTC_FINITE_F32(w2_3_1)
                && PTC_FINITE_F32(w3_3_1)
                && PTC_FINITE_F32(b_1_1)
                && PTC_FINITE_F32(b_2_1)
                && PTC_FINITE_F32(b_3_1)
                && (params->h * params->h * params->h >= 1e-30f)
                && (1.0f / (params->h * params->h * params->h) >= 1e-30f)) {
                self->start = 0U;
                self->samples = samples;
                self->hold = hold;
                self->w1_1_1 = w1_1_1;
                self->w1_2_1 = w1_2_1;
                self->w1_3_1 = w1_3_1;
                self->w2_2_1 = w2_2_1;
                self->w2_3_1 = w2_3_1;
                self->w3_3_1 = w3_3_1;
                self->b_1_1 = b_1_1;
                self->b_2_1 = b_2_1;
                self->b_3_1 = b_3_1;
                self->u_max = u_max;
                status = PTC_OK;
            }
        }
    }
    return status;
}

ptc_status stage30_arm(stage30 *self, uint32_t k)
{
    ptc_status status = PTC_E_INPUT;

    if (self != NULL) {
        self->start = k;
        status = PTC_OK;
    }
    return status;
}

ptc_status stage30_step(
    const stage30 *self,
    uint32_t k,
    const float x[2][3],
    float u[2],
    ptc_status axes[2])
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (x != NULL) && (u != NULL) && (axes != NULL)) {
        if (PTC_FINITE_F32(x[0][0])
            && PTC_FINITE_F32(x[0][1])
            && PTC_FINITE_F32(x[0][2])
            && PTC_FINITE_F32(x[1][0])
            && PTC_FINITE_F32(x[1][1])
            && PTC_FINITE_F32(x[1][2])) {
            const uint32_t elapsed = k - self->start;
            const float x1_1 = x[0][0];
            const float x2_1 = x[0][1];
            const float x3_1 = x[0][2];
            const float x1_2 = x[1][0];
            const float x2_2 = x[1][1];
            const float x3_2 = x[1][2];
            const uint32_t left = (elapsed < self->samples) ? (self->samples - elapsed) : 0U;
            const float m0_1 = ((float)left < self->hold) ? self->hold : (float)left;
            float law_1;
            const float m0_2 = ((float)left < self->hold) ? self->hold : (float)left;
            float law_2;
            if (m0_1 > STAGE30_DEADBEAT_1) {
                /* The exact law in samples. */
                const float s1 = (self->w1_1_1 * x1_1) + (self->w1_2_1 * x2_1);
                const float z1_1 = s1 + (self->w1_3_1 * x3_1);
                const float z2_1 = (self->w2_2_1 * x2_1) + (self->w2_3_1 * x3_1);
                const float z3_1 = self->w3_3_1 * x3_1;
                law_1 = ((((z1_1 / m0_1) + z2_1) / (m0_1 - 1.0f)) + z3_1) / (m0_1 - 2.0f);
            } else {
                /* Deadbeat. */
                const float s2 = (self->b_1_1 * x1_1) + (self->b_2_1 * x2_1);
                law_1 = s2 + (self->b_3_1 * x3_1);
            }
            if (m0_2 > STAGE30_DEADBEAT_2) {
                /* The exact law in samples. */
                const float s3 = (self->w1_1_1 * x1_2) + (self->w1_2_1 * x2_2);
                const float z1_2 = s3 + (self->w1_3_1 * x3_2);
                const float z2_2 = (self->w2_2_1 * x2_2) + (self->w2_3_1 * x3_2);
                const float z3_2 = self->w3_3_1 * x3_2;
                law_2 = ((((z1_2 / m0_2) + z2_2) / (m0_2 - 1.0f)) + z3_2) / (m0_2 - 2.0f);
            } else {
                /* Deadbeat. */
                const float s4 = (self->b_1_1 * x1_2) + (self->b_2_1 * x2_2);
                law_2 = s4 + (self->b_3_1 * x3_2);
            }
            if ((float)left > self->hold) {
                status = PTC_OK;
            } else {
                status = PTC_HOLD;
            }
            if (PTC_FINITE_F32(law_1) && PTC_FINITE_F32(law_2)) {
                u[0] = law_1;
                axes[0] = status;
                u[1] = law_2;
                axes[1] = status;
                if (law_1 > self->u_max) {
                    u[0] = self->u_max;
                    axes[0] = PTC_SATURATED;
                    status = PTC_SATURATED;
                } else if (law_1 < -self->u_max) {
                    u[0] = -self->u_max;
                    axes[0] = PTC_SATURATED;
                    status = PTC_SATURATED;
                } else {
                    /* neither */
                }
                if (law_2 > self->u_max) {
                    u[1] = self->u_max;
                    axes[1] = PTC_SATURATED;
                    status = PTC_SATURATED;
                } else if (law_2 < -self->u_max) {
                    u[1] = -self->u_max;
                    axes[1] = PTC_SATURATED;
                    status = PTC_SATURATED;
                } else {
                    /* neither */
                }
            } else {
                u[0] = 0.0f;
                if (PTC_FINITE_F32(law_1)) {
                    axes[0] = status;
                } else {
                    axes[0] = PTC_E_RANGE;
                }
                u[1] = 0.0f;
                if (PTC_FINITE_F32(law_2)) {
                    axes[1] = status;
                } else {
                    axes[1] = PTC_E_RANGE;
                }
                status = PTC_E_RANGE;
            }
        } else {
            for (uint32_t i = 0U; i < 2U; i++) {
                u[i] = 0.0f;
                axes[i] = PTC_E_INPUT;
            }
        }
    } else {
        if (u != NULL) {
            for (uint32_t i = 0U; i < 2U; i++) {
                u[i] = 0.0f;
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
