/* Prescribed-time controller stage36: see stage36.h. DO NOT EDIT. */
#include "stage36.h"

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
#define STAGE36_B_1_1 (-2500.0f) /* weight of x1 in the law */
#define STAGE36_B_2_1 (-75.0f) /* weight of x2 in the law */
#define STAGE36_B_1_2 (-2500.0f) /* weight of x1 in the law */
#define STAGE36_B_2_2 (-75.0f) /* weight of x2 in the law */

ptc_status stage36_init(stage36 *self, const stage36_params *params)
{
    ptc_status status = PTC_E_PARAM;

    if ((self != NULL) && (params != NULL)) {
        if ((params->samples > 1U)
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
            const float deadbeat_1 = (params->deadbeat > 0.0f) ? params->deadbeat : s2;
            const float w1_1_1 = 2500.0f * (-(params->k[0] / (params->a * params->a)));
            const float w1_2_1 = 50.0f * ((-0.5f) * (-(params->k[0] / (params->a * params->a))));
            const float w2_2_1 = 50.0f * (1.0f - (params->k[1] / params->a));
            const float u_max = params->u_max;
            if (PTC_FINITE_F32(deadbeat_1)
                && PTC_FINITE_F32(w1_1_1)
                && PTC_FINITE_F32(w1_2_1)
                && PTC_FINITE_F32(w2_2_1)) {
                self->start = 0U;
                self->samples = samples;
                self->deadbeat_1 = deadbeat_1;
                self->w1_1_1 = w1_1_1;
                self->w1_2_1 = w1_2_1;
                self->w2_2_1 = w2_2_1;
                self->u_max = u_max;
                status = PTC_OK;
            }
        }
    }
    return status;
}

ptc_status stage36_arm(stage36 *self, uint32_t k)
{
    ptc_status status = PTC_E_INPUT;

    if (self != NULL) {
        self->start = k;
        status = PTC_OK;
    }
    return status;
}

ptc_status stage36_step(
    const stage36 *self,
    uint32_t k,
    const float x[4],
    float u[2],
    ptc_status axes[2])
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (x != NULL) && (u != NULL) && (axes != NULL)) {
        if (PTC_FINITE_F32(x[0])
            && PTC_FINITE_F32(x[1])
            && PTC_FINITE_F32(x[2])
            && PTC_FINITE_F32(x[3])) {
            const uint32_t elapsed = k - self->start;

            /* The chain of each output as it is sampled. */
            const float x1_1 = x[0] + ((-4.7624485e-6f) * x[2]) + (5.4430127e-11f * x[3]);
            const float x2_1 = (1.0000571f * x[2]) + ((-5.71533e-5f) * x[3]);
            const float x1_2 = x[1] + (2.3814148e-6f * x[2]) + ((-2.7217397e-11f) * x[3]);
            const float x2_2 = ((-2.857665e-5f) * x[2]) + (1.0000952f * x[3]);
            const uint32_t left = (elapsed < self->samples) ? (self->samples - elapsed) : 0U;
            const float m0_1 = (float)left;
            float law_1;
            const float m0_2 = (float)left;
            float law_2;
            if (m0_1 > self->deadbeat_1) {
                /* The exact law in samples. */
                const float z1_1 = (self->w1_1_1 * x1_1) + (self->w1_2_1 * x2_1);
                const float z2_1 = self->w2_2_1 * x2_1;
                law_1 = (z1_1 + (z2_1 * m0_1)) / (m0_1 * (m0_1 - 1.0f));
            } else {
                /* Deadbeat. */
                law_1 = (STAGE36_B_1_1 * x1_1) + (STAGE36_B_2_1 * x2_1);
            }
            if (m0_2 > self->deadbeat_1) {
                /* The exact law in samples. */
                const float z1_2 = (self->w1_1_1 * x1_2) + (self->w1_2_1 * x2_2);
                const float z2_2 = self->w2_2_1 * x2_2;
                law_2 = (z1_2 + (z2_2 * m0_2)) / (m0_2 * (m0_2 - 1.0f));
            } else {
                /* Deadbeat. */
                law_2 = (STAGE36_B_1_2 * x1_2) + (STAGE36_B_2_2 * x2_2);
            }

            /* The inputs that give all of them. */
            const float s1 = ((-1.7116923f) * x[0]) + (1.7115782f * x[1]) + ((-0.15976757f) * x[2]);
            const float v1 = law_1 - (s1 + (0.017126543f * x[3]));
            const float s2 = (0.855789f * x[0]) + ((-2.8555987f) * x[1]) + (0.07987902f * x[2]);
            const float v2 = law_2 - (s2 + ((-0.028563272f) * x[3]));
            const float control1 = (2.0026014f * v1) + (0.49993333f * v2);
            const float control2 = (0.49999994f * v1) + (1.0000666f * v2);
            if (elapsed < self->samples) {
                status = PTC_OK;
            } else {
                status = PTC_HOLD;
            }
            if (PTC_FINITE_F32(control1) && PTC_FINITE_F32(control2)) {
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
                u[0] = 0.0f;
                if (PTC_FINITE_F32(control1)) {
                    axes[0] = status;
                } else {
                    axes[0] = PTC_E_RANGE;
                }
                u[1] = 0.0f;
                if (PTC_FINITE_F32(control2)) {
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
