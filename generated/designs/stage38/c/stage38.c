/* Prescribed-time controller stage38: see stage38.h. DO NOT EDIT. */
#include "stage38.h"

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
#define STAGE38_PHI1_2 0.01f /* 1/100, prediction of x1 from x2 */
#define STAGE38_PHI1_3 5e-5f /* 1/20000, prediction of x1 from d */
#define STAGE38_GAMMA1 5e-5f /* 1/20000, prediction from u */
#define STAGE38_PHI2_3 0.01f /* 1/100, prediction of x2 from d */
#define STAGE38_GAMMA2 0.01f /* 1/100, prediction from u */
#define STAGE38_OBSERVER_SAMPLES 20U /* samples of the round of the observer */
#define STAGE38_Q1_1 120.0f /* weight in the observer's gain l1 */
#define STAGE38_Q1_2 (-60.0f) /* weight in the observer's gain l1 */
#define STAGE38_Q1_3 12.0f /* weight in the observer's gain l1 */
#define STAGE38_Q2_1 (-10800.0f) /* weight in the observer's gain l2 */
#define STAGE38_Q2_2 3600.0f /* weight in the observer's gain l2 */
#define STAGE38_Q3_1 240000.0f /* weight in the observer's gain l3 */
#define STAGE38_E0_2 42.857143f /* 300/7, gain of the observer at its end */
#define STAGE38_E0_3 1428.5714f /* 10000/7, gain of the observer at its end */
#define STAGE38_E1_2 85.71429f /* 600/7, gain of the observer at its end */
#define STAGE38_E1_3 (-2857.1428f) /* -20000/7, gain of the observer at its end */
#define STAGE38_E2_2 150.0f /* gain of the observer at its end */
#define STAGE38_E2_3 10000.0f /* gain of the observer at its end */
#define STAGE38_W1_1 (-1200000.0f) /* weight of x1 in the law */
#define STAGE38_W1_2 6000.0f /* weight of x2 in the law */
#define STAGE38_W2_2 (-6000.0f) /* weight of x2 in the law */
#define STAGE38_W3_3 (-12.0f) /* weight of u1 in the law */
#define STAGE38_SAMPLES 40U /* samples from the start to rest */

ptc_status stage38_init(stage38 *self, const stage38_params *params)
{
    ptc_status status = PTC_E_PARAM;

    (void)params;
    if (self != NULL) {
        self->start = 0U;
        self->u1 = 0.0f;
        self->u2 = 0.0f;
        self->seen = 0U;
        self->x1_hat = 0.0f;
        self->x2_hat = 0.0f;
        self->d_hat = 0.0f;
        status = PTC_OK;
    }
    return status;
}

ptc_status stage38_arm(stage38 *self, uint32_t k)
{
    ptc_status status = PTC_E_INPUT;

    if (self != NULL) {
        self->start = k;
        const float size = fabsf(self->x1_hat) + fabsf(self->x2_hat) + fabsf(self->d_hat);
        if (!(size <= 1e18f)) {
            self->seen = 0U;
            self->x1_hat = 0.0f;
            self->x2_hat = 0.0f;
            self->d_hat = 0.0f;
        }
        status = PTC_OK;
    }
    return status;
}

ptc_status stage38_step(stage38 *self, uint32_t k, const float y[1], float *u)
{
    ptc_status status = PTC_E_INPUT;

    if (u != NULL) {
        *u = 0.0f;
    }
    if ((self != NULL) && (y != NULL) && (u != NULL)) {
        if (PTC_FINITE_F32(y[0])) {
            const uint32_t elapsed = k - self->start;

            /* Predict. */
            const float s1 = self->x1_hat + (STAGE38_PHI1_2 * self->x2_hat);
            const float s2 = s1 + (STAGE38_PHI1_3 * self->d_hat);
            const float p1 = s2 + (STAGE38_GAMMA1 * self->u2);
            const float s3 = self->x2_hat + (STAGE38_PHI2_3 * self->d_hat);
            const float p2 = s3 + (STAGE38_GAMMA2 * self->u2);
            const float p3 = self->d_hat;

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
            const uint32_t left_o = (elapsed < STAGE38_OBSERVER_SAMPLES) ? (STAGE38_OBSERVER_SAMPLES - elapsed) : 0U;
            const float o0 = (float)left_o;
            float l1;
            float l2;
            float l3;
            if (o0 > 8.0f) {
                const float o0f2 = o0 * (o0 - 1.0f);
                const float r0 = 1.0f / (o0f2 * (o0 - 2.0f));
                l1 = (STAGE38_Q1_1 + (STAGE38_Q1_2 * o0) + (STAGE38_Q1_3 * o0f2)) * r0;
                l2 = (STAGE38_Q2_1 + (STAGE38_Q2_2 * o0)) * r0;
                l3 = STAGE38_Q3_1 * r0;
            } else if (left_o == 8U) {
                l1 = 1.0f;
                l2 = STAGE38_E0_2;
                l3 = STAGE38_E0_3;
            } else if (left_o == 7U) {
                l1 = 1.0f;
                l2 = STAGE38_E1_2;
                l3 = STAGE38_E1_3;
            } else {
                l1 = 1.0f;
                l2 = STAGE38_E2_2;
                l3 = STAGE38_E2_3;
            }
            const float x1 = base + (l1 * miss);
            const float x2 = p2 + (l2 * miss);
            const float d = p3 + (l3 * miss);
            float v;

            /* The exact law in samples. */
            const float m0 = (elapsed < 37U) ? ((float)(43U - elapsed)) : 6.0f;
            const float z1 = (STAGE38_W1_1 * x1) + (STAGE38_W1_2 * x2);
            const float z2 = STAGE38_W2_2 * x2;
            const float z3 = STAGE38_W3_3 * (self->u1 + d);
            const float m0f2 = m0 * (m0 - 1.0f);
            const float s4 = (z1 + (z2 * m0) + (z3 * m0f2)) / (m0f2 * (m0 - 2.0f));
            v = (s4 + (self->u1 + d)) - d;
            status = PTC_E_RANGE;
            if (PTC_FINITE_F32(v)) {
                float u_now;
                if (elapsed < STAGE38_SAMPLES) {
                    if (v > 1.0f) {
                        u_now = 1.0f;
                    } else if (v < 0.0f) {
                        u_now = 0.0f;
                    } else {
                        u_now = v;
                    }
                } else {
                    u_now = 0.0f;
                }
                self->u2 = self->u1;
                self->u1 = u_now;
                self->x1_hat = x1;
                self->x2_hat = x2;
                self->d_hat = d;
                self->seen = 1U;
                *u = u_now;
                if (elapsed < STAGE38_SAMPLES) {
                    if ((v > 1.0f) || (v < 0.0f)) {
                        status = PTC_SATURATED;
                    } else {
                        status = PTC_OK;
                    }
                } else {
                    status = PTC_AFTER;
                }
            }
        }
    }
    return status;
}

ptc_status stage38_estimate(const stage38 *self, float xhat[2])
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (xhat != NULL)) {
        xhat[0] = self->x1_hat;
        xhat[1] = self->x2_hat;
        status = PTC_OK;
    }
    if ((status < PTC_OK) && (xhat != NULL)) {
        for (uint32_t i = 0U; i < 2U; i++) {
            xhat[i] = 0.0f;
        }
    }
    return status;
}

ptc_status stage38_disturbance(const stage38 *self, float *d)
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (d != NULL)) {
        *d = self->d_hat;
        status = PTC_OK;
    }
    return status;
}
