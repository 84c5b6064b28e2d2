/* Prescribed-time controller stage24: see stage24.h. DO NOT EDIT. */
#include "stage24.h"

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
#define STAGE24_H 0.01f /* 1/100, sample period */
#define STAGE24_W1_1 (-137042.42f) /* weight of x1 in the law */
#define STAGE24_W1_2 69031.28f /* weight of x2 in the law */
#define STAGE24_W2_1 1353.4108f /* weight of x1 in the law */
#define STAGE24_W2_2 (-1082.7286f) /* weight of x2 in the law */
#define STAGE24_C_1 (-5.658292f) /* weight of x1 in the law */
#define STAGE24_C_2 4.3266335f /* weight of x2 in the law */
#define STAGE24_B_1 (-6519.427f) /* weight of x1 in the law */
#define STAGE24_B_2 3185.2085f /* weight of x2 in the law */
#define STAGE24_SAMPLES 30U /* samples from the start to rest */

ptc_status stage24_init(stage24 *self, const stage24_params *params)
{
    ptc_status status = PTC_E_PARAM;

    if ((self != NULL) && (params != NULL)) {
        if ((params->u_max > 0.0f) && PTC_FINITE_F32(params->size)) {
            const float p_size = params->size;
            const float c_r4 = 2.0f * p_size;
            const float u_max = params->u_max;
            if (PTC_FINITE_F32(c_r4)) {
                self->start = 0U;
                self->p_size = p_size;
                self->c_r4 = c_r4;
                self->u_max = u_max;
                status = PTC_OK;
            }
        }
    }
    return status;
}

ptc_status stage24_arm(stage24 *self, uint32_t k)
{
    ptc_status status = PTC_E_INPUT;

    if (self != NULL) {
        self->start = k;
        status = PTC_OK;
    }
    return status;
}

ptc_status stage24_step(const stage24 *self, uint32_t k, const float x[2], float *u)
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

            /* The tracking error. */
            const float t = ((float)elapsed) * STAGE24_H;
            const float v_r1 = t * t;
            const float v_r2 = 1.0f + v_r1;
            const float v_r3 = (self->p_size * v_r1) / v_r2;
            const float v_r5 = (self->c_r4 * t * (v_r2 - v_r1)) / (v_r2 * v_r2);
            const float x_r1 = ((-1.3333334f) * v_r3) + ((-0.33333334f) * v_r5);
            const float x_r2 = ((-1.6666666f) * v_r3) + ((-0.6666667f) * v_r5);
            const float v_r6 = t + 0.005f;
            const float v_r7 = v_r6 * v_r6;
            const float v_r8 = 1.0f + v_r7;
            const float v_r9 = v_r8 * v_r8;
            const float s1 = (self->c_r4 * v_r6 * (v_r8 - v_r7)) / v_r9;
            const float s2 = (v_r9 + (4.0f * v_r7 * v_r7)) - (4.0f * v_r8 * v_r6 * v_r6);
            const float s3 = (-0.33333334f) * ((self->c_r4 * (s2 - (v_r8 * v_r7))) / (v_r8 * v_r9));
            const float u_r0 = ((0.33333334f * ((self->p_size * v_r7) / v_r8)) - s1) + s3;
            const float e1 = x1 - x_r1;
            const float e2 = x2 - x_r2;
            float v;
            if (elapsed < 28U) {
                /* The exact law in samples. */
                const float m0 = (float)(33U - elapsed);
                const float z1 = (STAGE24_W1_1 * e1) + (STAGE24_W1_2 * e2);
                const float z2 = (STAGE24_W2_1 * e1) + (STAGE24_W2_2 * e2);
                const float s4 = (STAGE24_C_1 * e1) + (STAGE24_C_2 * e2);
                v = ((z1 + (z2 * m0)) / (m0 * (m0 - 1.0f))) + s4 + u_r0;
            } else {
                /* Deadbeat. */
                v = (STAGE24_B_1 * e1) + (STAGE24_B_2 * e2) + u_r0;
            }
            if (PTC_FINITE_F32(v)) {
                if (v > self->u_max) {
                    *u = self->u_max;
                    status = PTC_SATURATED;
                } else if (v < -self->u_max) {
                    *u = -self->u_max;
                    status = PTC_SATURATED;
                } else if (elapsed < STAGE24_SAMPLES) {
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
