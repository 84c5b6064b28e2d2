/* Prescribed-time controller stage11: see stage11.h. DO NOT EDIT. */
#include "stage11.h"

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
#define STAGE11_PHI1_2 0.01f /* 1/100, prediction of x1 from x2 */
#define STAGE11_PHI1_3 5e-5f /* 1/20000, prediction of x1 from x3 */
#define STAGE11_PHI1_4 1.6666667e-7f /* 1/6000000, prediction of x1 from x4 */
#define STAGE11_PHI1_5 4.1666667e-10f /* 1/2400000000, prediction of x1 from d */
#define STAGE11_GAMMA1 4.1666667e-10f /* 1/2400000000, prediction from u */
#define STAGE11_PHI2_3 0.01f /* 1/100, prediction of x2 from x3 */
#define STAGE11_PHI2_4 5e-5f /* 1/20000, prediction of x2 from x4 */
#define STAGE11_PHI2_5 1.6666667e-7f /* 1/6000000, prediction of x2 from d */
#define STAGE11_GAMMA2 1.6666667e-7f /* 1/6000000, prediction from u */
#define STAGE11_PHI3_4 0.01f /* 1/100, prediction of x3 from x4 */
#define STAGE11_PHI3_5 5e-5f /* 1/20000, prediction of x3 from d */
#define STAGE11_GAMMA3 5e-5f /* 1/20000, prediction from u */
#define STAGE11_PHI4_5 0.01f /* 1/100, prediction of x4 from d */
#define STAGE11_GAMMA4 0.01f /* 1/100, prediction from u */
#define STAGE11_Q1_1 6720.0f /* weight in the observer's gain l1 */
#define STAGE11_Q1_2 (-4200.0f) /* weight in the observer's gain l1 */
#define STAGE11_Q1_3 1200.0f /* weight in the observer's gain l1 */
#define STAGE11_Q1_4 (-200.0f) /* weight in the observer's gain l1 */
#define STAGE11_Q1_5 20.0f /* weight in the observer's gain l1 */
#define STAGE11_Q2_1 (-808000.0f) /* weight in the observer's gain l2 */
#define STAGE11_Q2_2 454000.0f /* weight in the observer's gain l2 */
#define STAGE11_Q2_3 (-108000.0f) /* weight in the observer's gain l2 */
#define STAGE11_Q2_4 12000.0f /* weight in the observer's gain l2 */
#define STAGE11_Q3_1 38400000.0f /* weight in the observer's gain l3 */
#define STAGE11_Q3_2 (-16800000.0f) /* weight in the observer's gain l3 */
#define STAGE11_Q3_3 2400000.0f /* weight in the observer's gain l3 */
#define STAGE11_Q4_1 (-480000000.0f) /* weight in the observer's gain l4 */
#define STAGE11_Q4_2 120000000.0f /* weight in the observer's gain l4 */
#define STAGE11_E0_2 50.757576f /* 1675/33, gain of the observer at its end */
#define STAGE11_E0_3 3678.4512f /* 1092500/297, gain of the observer at its end */
#define STAGE11_E0_4 (-166666.67f) /* -500000/3, gain of the observer at its end */
#define STAGE11_E0_5 7070707.0f /* 700000000/99, gain of the observer at its end */
#define STAGE11_E1_2 79.29293f /* 7850/99, gain of the observer at its end */
#define STAGE11_E1_3 (-1414.1414f) /* -140000/99, gain of the observer at its end */
#define STAGE11_E1_4 696969.7f /* 23000000/33, gain of the observer at its end */
#define STAGE11_E1_5 (-48484850.0f) /* -1600000000/33, gain of the observer at its end */
#define STAGE11_E2_2 105.55556f /* 950/9, gain of the observer at its end */
#define STAGE11_E2_3 (-1111.1111f) /* -10000/9, gain of the observer at its end */
#define STAGE11_E2_4 (-333333.34f) /* -1000000/3, gain of the observer at its end */
#define STAGE11_E2_5 133333336.0f /* 400000000/3, gain of the observer at its end */
#define STAGE11_E3_2 138.88889f /* 1250/9, gain of the observer at its end */
#define STAGE11_E3_3 3703.7036f /* 100000/27, gain of the observer at its end */
#define STAGE11_E3_4 (-1666666.6f) /* -5000000/3, gain of the observer at its end */
#define STAGE11_E3_5 (-177777780.0f) /* -1600000000/9, gain of the observer at its end */
#define STAGE11_E4_2 208.33333f /* 625/3, gain of the observer at its end */
#define STAGE11_E4_3 29166.666f /* 87500/3, gain of the observer at its end */
#define STAGE11_E4_4 2500000.0f /* gain of the observer at its end */
#define STAGE11_E4_5 100000000.0f /* gain of the observer at its end */
#define STAGE11_B_1 (-100000000.0f) /* weight of x1 in the law */
#define STAGE11_B_2 (-2500000.0f) /* weight of x2 in the law */
#define STAGE11_B_3 (-29166.666f) /* -87500/3, weight of x3 in the law */
#define STAGE11_B_4 (-208.33333f) /* -625/3, weight of x4 in the law */

ptc_status stage11_init(stage11 *self, const stage11_params *params)
{
    ptc_status status = PTC_E_PARAM;

    if ((self != NULL) && (params != NULL)) {
        if ((params->samples > 9U)
            && (params->u_max > 0.0f)
            && PTC_FINITE_F32(params->k[0])
            && PTC_FINITE_F32(params->k[1])
            && PTC_FINITE_F32(params->k[2])
            && PTC_FINITE_F32(params->k[3])
            && PTC_FINITE_F32(params->deadbeat)
            && (params->deadbeat >= 0.0f)) {
            const uint32_t samples = params->samples;
            const float s1 = (params->k[3] - 9.0f) + 4.0f;
            const float s2 = (s1 < 8.0f) ? 8.0f : s1;
            const float deadbeat = (params->deadbeat > 0.0f) ? params->deadbeat : s2;
            const float w1_1 = 100000000.0f * (-params->k[0]);
            const float w1_2 = 1000000.0f * ((-1.5f) * (-params->k[0]));
            const float w1_3 = 10000.0f * (0.9166667f * (-params->k[0]));
            const float w1_4 = 100.0f * ((-0.25f) * (-params->k[0]));
            const float s3 = ((1.0f - params->k[1]) + params->k[2]) - params->k[3];
            const float w2_2 = 1000000.0f * s3;
            const float s4 = -(((1.0f - params->k[1]) + params->k[2]) - params->k[3]);
            const float w2_3 = 10000.0f * s4;
            const float s5 = ((1.0f - params->k[1]) + params->k[2]) - params->k[3];
            const float w2_4 = 100.0f * (0.33333334f * s5);
            const float w3_3 = 10000.0f * (((-7.0f) - params->k[2]) + (3.0f * params->k[3]));
            const float w3_4 = 100.0f * ((-0.5f) * (((-7.0f) - params->k[2]) + (3.0f * params->k[3])));
            const float w4_4 = 100.0f * (6.0f - params->k[3]);
            const float u_max = params->u_max;
            if (PTC_FINITE_F32(deadbeat)
                && PTC_FINITE_F32(w1_1)
                && PTC_FINITE_F32(w1_2)
                && PTC_FINITE_F32(w1_3)
                && PTC_FINITE_F32(w1_4)
                && PTC_FINITE_F32(w2_2)
                && PTC_FINITE_F32(w2_3)
                && PTC_FINITE_F32(w2_4)
                && PTC_FINITE_F32(w3_3)
                && PTC_FINITE_F32(w3_4)
                && PTC_FINITE_F32(w4_4)) {
                self->start = 0U;
                self->samples = samples;
                self->u1 = 0.0f;
                self->seen = 0U;
                self->x1_hat = 0.0f;
                self->x2_hat = 0.0f;
                self->x3_hat = 0.0f;
                self->x4_hat = 0.0f;
                self->d_hat = 0.0f;
                self->deadbeat = deadbeat;
                self->w1_1 = w1_1;
                self->w1_2 = w1_2;
                self->w1_3 = w1_3;
                self->w1_4 = w1_4;
                self->w2_2 = w2_2;
                self->w2_3 = w2_3;
                self->w2_4 = w2_4;
                self->w3_3 = w3_3;
                self->w3_4 = w3_4;
                self->w4_4 = w4_4;
                self->u_max = u_max;
                status = PTC_OK;
            }
        }
    }
    return status;
}

ptc_status stage11_arm(stage11 *self, uint32_t k)
{
    ptc_status status = PTC_E_INPUT;

    if (self != NULL) {
        self->start = k;
        const float s1 = fabsf(self->x1_hat) + fabsf(self->x2_hat) + fabsf(self->x3_hat);
        const float size = s1 + fabsf(self->x4_hat) + fabsf(self->d_hat);
        if (!(size <= 1e18f)) {
            self->seen = 0U;
            self->x1_hat = 0.0f;
            self->x2_hat = 0.0f;
            self->x3_hat = 0.0f;
            self->x4_hat = 0.0f;
            self->d_hat = 0.0f;
        }
        status = PTC_OK;
    }
    return status;
}

ptc_status stage11_step(stage11 *self, uint32_t k, const float y[1], float *u)
{
    ptc_status status = PTC_E_INPUT;

    if (u != NULL) {
        *u = 0.0f;
    }
    if ((self != NULL) && (y != NULL) && (u != NULL)) {
        if (PTC_FINITE_F32(y[0])) {
            const uint32_t elapsed = k - self->start;

            /* Predict. */
            const float s1 = self->x1_hat + (STAGE11_PHI1_2 * self->x2_hat);
            const float s2 = s1 + (STAGE11_PHI1_3 * self->x3_hat);
            const float s3 = s2 + (STAGE11_PHI1_4 * self->x4_hat);
            const float s4 = s3 + (STAGE11_PHI1_5 * self->d_hat);
            const float p1 = s4 + (STAGE11_GAMMA1 * self->u1);
            const float s5 = self->x2_hat + (STAGE11_PHI2_3 * self->x3_hat);
            const float s6 = s5 + (STAGE11_PHI2_4 * self->x4_hat);
            const float s7 = s6 + (STAGE11_PHI2_5 * self->d_hat);
            const float p2 = s7 + (STAGE11_GAMMA2 * self->u1);
            const float s8 = self->x3_hat + (STAGE11_PHI3_4 * self->x4_hat);
            const float s9 = s8 + (STAGE11_PHI3_5 * self->d_hat);
            const float p3 = s9 + (STAGE11_GAMMA3 * self->u1);
            const float s10 = self->x4_hat + (STAGE11_PHI4_5 * self->d_hat);
            const float p4 = s10 + (STAGE11_GAMMA4 * self->u1);
            const float p5 = self->d_hat;

            /* Correct by what is measured. */
            float base;
            float miss;
            if (self->seen == 0U) {
                base = y[0];
                miss = 0.0f;
            } else {
                base = p1;
                miss = y[0] - p1;
            }
            const uint32_t left_o = (elapsed < (self->samples / 2U)) ? ((self->samples / 2U) - elapsed) : 0U;
            const float o0 = (float)left_o;
            float l1;
            float l2;
            float l3;
            float l4;
            float l5;
            if (o0 > 12.0f) {
                const float r0 = 1.0f / o0;
                const float r1 = 1.0f / (o0 - 1.0f);
                const float r2 = 1.0f / (o0 - 2.0f);
                const float r3 = 1.0f / (o0 - 3.0f);
                const float r4 = 1.0f / (o0 - 4.0f);
                const float s11 = ((((STAGE11_Q1_1 * r0) + STAGE11_Q1_2) * r1) + STAGE11_Q1_3) * r2;
                l1 = (((s11 + STAGE11_Q1_4) * r3) + STAGE11_Q1_5) * r4;
                const float s12 = ((((STAGE11_Q2_1 * r0) + STAGE11_Q2_2) * r1) + STAGE11_Q2_3) * r2;
                l2 = (s12 + STAGE11_Q2_4) * r3 * r4;
                const float s13 = ((((STAGE11_Q3_1 * r0) + STAGE11_Q3_2) * r1) + STAGE11_Q3_3) * r2;
                l3 = s13 * r3 * r4;
                l4 = ((STAGE11_Q4_1 * r0) + STAGE11_Q4_2) * r1 * r2 * r3 * r4;
                l5 = 0.0f;
            } else if (left_o == 12U) {
                l1 = 1.0f;
                l2 = STAGE11_E0_2;
                l3 = STAGE11_E0_3;
                l4 = STAGE11_E0_4;
                l5 = STAGE11_E0_5;
            } else if (left_o == 11U) {
                l1 = 1.0f;
                l2 = STAGE11_E1_2;
                l3 = STAGE11_E1_3;
                l4 = STAGE11_E1_4;
                l5 = STAGE11_E1_5;
            } else if (left_o == 10U) {
                l1 = 1.0f;
                l2 = STAGE11_E2_2;
                l3 = STAGE11_E2_3;
                l4 = STAGE11_E2_4;
                l5 = STAGE11_E2_5;
            } else if (left_o == 9U) {
                l1 = 1.0f;
                l2 = STAGE11_E3_2;
                l3 = STAGE11_E3_3;
                l4 = STAGE11_E3_4;
                l5 = STAGE11_E3_5;
            } else {
                l1 = 1.0f;
                l2 = STAGE11_E4_2;
                l3 = STAGE11_E4_3;
                l4 = STAGE11_E4_4;
                l5 = STAGE11_E4_5;
            }
            const float x1 = base + (l1 * miss);
            const float x2 = p2 + (l2 * miss);
            const float x3 = p3 + (l3 * miss);
            const float x4 = p4 + (l4 * miss);
            const float d = p5 + (l5 * miss);
            const uint32_t left = (elapsed < self->samples) ? (self->samples - elapsed) : 0U;
            const float m0 = (float)left;
            float v;
            if (m0 > self->deadbeat) {
                /* The exact law in samples. */
                const float s14 = (self->w1_1 * x1) + (self->w1_2 * x2) + (self->w1_3 * x3);
                const float z1 = s14 + (self->w1_4 * x4);
                const float z2 = (self->w2_2 * x2) + (self->w2_3 * x3) + (self->w2_4 * x4);
                const float z3 = (self->w3_3 * x3) + (self->w3_4 * x4);
                const float z4 = self->w4_4 * x4;
                const float s15 = (((((z1 / m0) + z2) / (m0 - 1.0f)) + z3) / (m0 - 2.0f)) + z4;
                v = (s15 / (m0 - 3.0f)) - d;
            } else {
                /* Deadbeat. */
                const float s16 = (STAGE11_B_1 * x1) + (STAGE11_B_2 * x2) + (STAGE11_B_3 * x3);
                v = (s16 + (STAGE11_B_4 * x4)) - d;
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
                self->u1 = u_now;
                self->x1_hat = x1;
                self->x2_hat = x2;
                self->x3_hat = x3;
                self->x4_hat = x4;
                self->d_hat = d;
                self->seen = 1U;
                *u = u_now;
                if ((v > self->u_max) || (v < -self->u_max)) {
                    status = PTC_SATURATED;
                } else if (elapsed < self->samples) {
                    status = PTC_OK;
                } else {
                    status = PTC_HOLD;
                }
            }
        }
    }
    return status;
}

ptc_status stage11_estimate(const stage11 *self, float xhat[4])
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (xhat != NULL)) {
        xhat[0] = self->x1_hat;
        xhat[1] = self->x2_hat;
        xhat[2] = self->x3_hat;
        xhat[3] = self->x4_hat;
        status = PTC_OK;
    }
    if ((status < PTC_OK) && (xhat != NULL)) {
        for (uint32_t i = 0U; i < 4U; i++) {
            xhat[i] = 0.0f;
        }
    }
    return status;
}

ptc_status stage11_disturbance(const stage11 *self, float *d)
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (d != NULL)) {
        *d = self->d_hat;
        status = PTC_OK;
    }
    return status;
}
