/* Prescribed-time controller stage13: see stage13.h. DO NOT EDIT. */
#include "stage13.h"

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
#define STAGE13_C_1 54.263023f /* weight of x1 in the law */
#define STAGE13_C_2 4.2855716f /* weight of x2 in the law */
#define STAGE13_B_1 11626.225f /* weight of x1 in the law */
#define STAGE13_B_2 1009.77814f /* weight of x2 in the law */

ptc_status stage13_init(stage13 *self, const stage13_params *params)
{
    ptc_status status = PTC_E_PARAM;

    if ((self != NULL) && (params != NULL)) {
        if ((params->samples > 1U)
            && (params->u_max > 0.0f)
            && PTC_FINITE_F32(params->k[0])
            && PTC_FINITE_F32(params->k[1])
            && PTC_FINITE_F32(params->deadbeat)
            && (params->deadbeat >= 0.0f)) {
            const uint32_t samples = params->samples;
            const float s1 = (params->k[1] - 1.0f) + 2.0f;
            const float s2 = (s1 < 4.0f) ? 4.0f : s1;
            const float deadbeat = (params->deadbeat > 0.0f) ? params->deadbeat : s2;
            const float w1_1 = (-10746.611f) * (-params->k[0]);
            const float w1_2 = (-788.20667f) * (-params->k[0]);
            const float w2_1 = (-412.67474f) * (1.0f - params->k[1]);
            const float w2_2 = (-108.64294f) * (1.0f - params->k[1]);
            const float u_max = params->u_max;
            if (PTC_FINITE_F32(deadbeat)
                && PTC_FINITE_F32(w1_1)
                && PTC_FINITE_F32(w1_2)
                && PTC_FINITE_F32(w2_1)
                && PTC_FINITE_F32(w2_2)) {
                self->start = 0U;
                self->samples = samples;
                self->deadbeat = deadbeat;
                self->w1_1 = w1_1;
                self->w1_2 = w1_2;
                self->w2_1 = w2_1;
                self->w2_2 = w2_2;
                self->u_max = u_max;
                status = PTC_OK;
            }
        }
    }
    return status;
}

ptc_status stage13_arm(stage13 *self, uint32_t k)
{
    ptc_status status = PTC_E_INPUT;

    if (self != NULL) {
        self->start = k;
        status = PTC_OK;
    }
    return status;
}

ptc_status stage13_step(const stage13 *self, uint32_t k, const float y[2], float *u)
{
    ptc_status status = PTC_E_INPUT;

    if (u != NULL) {
        *u = 0.0f;
    }
    if ((self != NULL) && (y != NULL) && (u != NULL)) {
        if (PTC_FINITE_F32(y[0]) && PTC_FINITE_F32(y[1])) {
            const uint32_t elapsed = k - self->start;
            const float x1 = (0.90909094f * y[0]) + (0.45454547f * y[1]);
            const float x2 = (0.18181819f * y[0]) - (0.90909094f * y[1]);
            const uint32_t left = (elapsed < self->samples) ? (self->samples - elapsed) : 0U;
            const float m0 = (float)left;
            float v;
            if (m0 > self->deadbeat) {
                /* The exact law in samples. */
                const float z1 = (self->w1_1 * x1) + (self->w1_2 * x2);
                const float z2 = (self->w2_1 * x1) + (self->w2_2 * x2);
                const float s1 = (STAGE13_C_1 * x1) + (STAGE13_C_2 * x2);
                v = ((z1 + (z2 * m0)) / (m0 * (m0 - 1.0f))) + s1;
            } else {
                /* Deadbeat. */
                v = (STAGE13_B_1 * x1) + (STAGE13_B_2 * x2);
            }
            if (PTC_FINITE_F32(v)) {
                if (elapsed < self->samples) {
                    if (v > self->u_max) {
                        *u = self->u_max;
                        status = PTC_SATURATED;
                    } else if (v < -self->u_max) {
                        *u = -self->u_max;
                        status = PTC_SATURATED;
                    } else {
                        *u = v;
                        status = PTC_OK;
                    }
                } else {
                    *u = 0.0f;
                    status = PTC_AFTER;
                }
            } else {
                status = PTC_E_RANGE;
            }
        }
    }
    return status;
}
