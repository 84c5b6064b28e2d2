/* Prescribed-time controller stage33: see stage33.h. DO NOT EDIT. */
#include "stage33.h"

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
#define STAGE33_H 0.01f /* 1/100, sample period */
#define STAGE33_W1_1_1 (-400000.0f) /* weight of x1 in the law */
#define STAGE33_W1_2_1 2000.0f /* weight of x2 in the law */
#define STAGE33_W2_2_1 (-1600.0f) /* weight of x2 in the law */
#define STAGE33_W1_1_2 (-50000.0f) /* weight of x1 in the law */
#define STAGE33_W1_2_2 250.0f /* weight of x2 in the law */
#define STAGE33_W2_2_2 (-250.0f) /* weight of x2 in the law */
#define STAGE33_END1_1_2 (-60000.0f) /* weight of x1 in the law */
#define STAGE33_END1_2_2 300.0f /* weight of x2 in the law */
#define STAGE33_END2_2_2 (-300.0f) /* weight of x2 in the law */
#define STAGE33_W1_1_3 450000.0f /* weight of x1 in the law */
#define STAGE33_W1_2_3 (-2250.0f) /* weight of x2 in the law */
#define STAGE33_W2_2_3 1250.0f /* weight of x2 in the law */
#define STAGE33_END1_1_3 420000.0f /* weight of x1 in the law */
#define STAGE33_END1_2_3 (-2100.0f) /* weight of x2 in the law */
#define STAGE33_END2_2_3 1200.0f /* weight of x2 in the law */

ptc_status stage33_init(stage33 *self, const stage33_params *params)
{
    ptc_status status = PTC_E_PARAM;

    if ((self != NULL) && (params != NULL)) {
        if (PTC_FINITE_F32(params->size)) {
            const float p_size = params->size;
            const float c_r10 = 2.0f * p_size;
            if (PTC_FINITE_F32(c_r10)) {
                self->start = 0U;
                self->p_size = p_size;
                self->c_r10 = c_r10;
                status = PTC_OK;
            }
        }
    }
    return status;
}

ptc_status stage33_arm(stage33 *self, uint32_t k)
{
    ptc_status status = PTC_E_INPUT;

    if (self != NULL) {
        self->start = k;
        status = PTC_OK;
    }
    return status;
}

ptc_status stage33_step(
    const stage33 *self,
    uint32_t k,
    const float x[3][2],
    float u[3],
    ptc_status axes[3])
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (x != NULL) && (u != NULL) && (axes != NULL)) {
        if (PTC_FINITE_F32(x[0][0])
            && PTC_FINITE_F32(x[0][1])
            && PTC_FINITE_F32(x[1][0])
            && PTC_FINITE_F32(x[1][1])
            && PTC_FINITE_F32(x[2][0])
            && PTC_FINITE_F32(x[2][1])) {
            const uint32_t elapsed = k - self->start;
            const float x1_1 = x[0][0];
            const float x2_1 = x[0][1];
            const float x1_2 = x[1][0];
            const float x2_2 = x[1][1];
            const float x1_3 = x[2][0];
            const float x2_3 = x[2][1];

            /* The tracking error. */
            const float t = ((float)elapsed) * STAGE33_H;
            const float v_r1 = t * t;
            const float v_r2 = 2.0f + v_r1;
            const float reference0_1 = 1.0f / v_r2;
            const float v_r3 = v_r2 * v_r2;
            const float reference1_1 = ((-2.0f) * t) / v_r3;
            const float v_r4 = t + 0.005f;
            const float v_r5 = v_r4 * v_r4;
            const float v_r6 = 2.0f + v_r5;
            const float v_r7 = v_r6 * v_r6;
            const float v_r8 = v_r6 * v_r7;
            const float rho0_1 = (2.0f * ((4.0f * v_r5) - v_r6)) / v_r8;
            const float v_r9 = 3.0f + t;
            const float reference0_2 = (self->p_size * t) / v_r9;
            const float reference1_2 = (self->p_size * (v_r9 - t)) / (v_r9 * v_r9);
            const float v_r11 = 3.0f + v_r4;
            const float rho0_2 = (self->c_r10 * (v_r4 - v_r11)) / (v_r11 * (v_r11 * v_r11));
            const float reference0_3 = v_r1 / v_r2;
            const float reference1_3 = (2.0f * t * (v_r2 - v_r1)) / v_r3;
            const float rho0_3 = (2.0f * ((v_r7 + (4.0f * (v_r5 * v_r5))) - (5.0f * v_r6 * v_r5))) / v_r8;
            const float e1_1 = x1_1 - reference0_1;
            const float e2_1 = x2_1 - reference1_1;
            const float e1_2 = x1_2 - reference0_2;
            const float e2_2 = x2_2 - reference1_2;
            const float e1_3 = x1_3 - reference0_3;
            const float e2_3 = x2_3 - reference1_3;
            float law_1;

            /* The exact law in samples. */
            const float m0_1 = (elapsed < 28U) ? ((float)(33U - elapsed)) : 5.0f;
            const float z1_1 = (STAGE33_W1_1_1 * e1_1) + (STAGE33_W1_2_1 * e2_1);
            const float z2_1 = STAGE33_W2_2_1 * e2_1;
            law_1 = ((z1_1 + (z2_1 * m0_1)) / (m0_1 * (m0_1 - 1.0f))) + (2.0f * rho0_1);
            float law_2;
            float law_3;
            if (elapsed < 26U) {
                /* The exact law in samples. */
                const float m0_2 = (float)(30U - elapsed);
                const float z1_2 = (STAGE33_W1_1_2 * e1_2) + (STAGE33_W1_2_2 * e2_2);
                const float z2_2 = STAGE33_W2_2_2 * e2_2;
                law_2 = ((z1_2 + (z2_2 * m0_2)) / (m0_2 * (m0_2 - 1.0f))) + (0.5f * rho0_2);
            } else {
                /* The law of least energy to the end. */
                const float m1_2 = (elapsed < 28U) ? ((float)(32U - elapsed)) : 4.0f;
                const float y1_2 = (STAGE33_END1_1_2 * e1_2) + (STAGE33_END1_2_2 * e2_2);
                const float y2_2 = STAGE33_END2_2_2 * e2_2;
                law_2 = ((y1_2 + (y2_2 * m1_2)) / (m1_2 * (m1_2 - 1.0f))) + (0.5f * rho0_2);
            }
            if (elapsed < 21U) {
                /* The exact law in samples. */
                const float m0_3 = (float)(30U - elapsed);
                const float z1_3 = (STAGE33_W1_1_3 * e1_3) + (STAGE33_W1_2_3 * e2_3);
                const float z2_3 = STAGE33_W2_2_3 * e2_3;
                law_3 = ((z1_3 + (z2_3 * m0_3)) / (m0_3 * (m0_3 - 1.0f))) - rho0_3;
            } else {
                /* The law of least energy to the end. */
                const float m1_3 = (elapsed < 28U) ? ((float)(35U - elapsed)) : 7.0f;
                const float y1_3 = (STAGE33_END1_1_3 * e1_3) + (STAGE33_END1_2_3 * e2_3);
                const float y2_3 = STAGE33_END2_2_3 * e2_3;
                law_3 = ((y1_3 + (y2_3 * m1_3)) / (m1_3 * (m1_3 - 1.0f))) - rho0_3;
            }
            if (elapsed < 30U) {
                status = PTC_OK;
            } else {
                status = PTC_HOLD;
            }
            if (PTC_FINITE_F32(law_1) && PTC_FINITE_F32(law_2) && PTC_FINITE_F32(law_3)) {
                u[0] = law_1;
                axes[0] = status;
                u[1] = law_2;
                axes[1] = status;
                u[2] = law_3;
                axes[2] = status;
                if (law_1 > 1.0f) {
                    u[0] = 1.0f;
                    axes[0] = PTC_SATURATED;
                    status = PTC_SATURATED;
                } else if (law_1 < -1.0f) {
                    u[0] = -1.0f;
                    axes[0] = PTC_SATURATED;
                    status = PTC_SATURATED;
                } else {
                    /* neither */
                }
                if (law_2 > 2.0f) {
                    u[1] = 2.0f;
                    axes[1] = PTC_SATURATED;
                    status = PTC_SATURATED;
                } else if (law_2 < -2.0f) {
                    u[1] = -2.0f;
                    axes[1] = PTC_SATURATED;
                    status = PTC_SATURATED;
                } else {
                    /* neither */
                }
                if (law_3 > 3.0f) {
                    u[2] = 3.0f;
                    axes[2] = PTC_SATURATED;
                    status = PTC_SATURATED;
                } else if (law_3 < -3.0f) {
                    u[2] = -3.0f;
                    axes[2] = PTC_SATURATED;
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
                u[2] = 0.0f;
                if (PTC_FINITE_F32(law_3)) {
                    axes[2] = status;
                } else {
                    axes[2] = PTC_E_RANGE;
                }
                status = PTC_E_RANGE;
            }
        } else {
            for (uint32_t i = 0U; i < 3U; i++) {
                u[i] = 0.0f;
                axes[i] = PTC_E_INPUT;
            }
        }
    } else {
        if (u != NULL) {
            for (uint32_t i = 0U; i < 3U; i++) {
                u[i] = 0.0f;
            }
        }
        if (axes != NULL) {
            for (uint32_t i = 0U; i < 3U; i++) {
                axes[i] = PTC_E_INPUT;
            }
        }
    }
    return status;
}
