/* Prescribed-time controller a_name_that_fills_half_of_a_line_alone_4: see a_name_that_fills_half_of_a_line_alone_4.h. DO NOT EDIT. */
#include "a_name_that_fills_half_of_a_line_alone_4.h"

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
#define A_NAME_THAT_FILLS_HALF_OF_A_LINE_ALONE_4_Q1_1 15.0f /* weight in the observer's gain l1 */
#define A_NAME_THAT_FILLS_HALF_OF_A_LINE_ALONE_4_Q1_2 (-12.0f) /* weight in the observer's gain l1 */
#define A_NAME_THAT_FILLS_HALF_OF_A_LINE_ALONE_4_Q1_3 4.5f /* 9/2, weight in the observer's gain l1 */

ptc_status a_name_that_fills_half_of_a_line_alone_4_init(
    a_name_that_fills_half_of_a_line_alone_4 *self,
    const a_name_that_fills_half_of_a_line_alone_4_params *params)
{
    ptc_status status = PTC_E_PARAM;

    if ((self != NULL) && (params != NULL)) {
        if ((params->samples > 5U)
            && (1e-18f <= params->h)
            && (params->h <= 1e18f)
            && (params->u_max > 0.0f)
            && PTC_FINITE_F32(params->k[0])
            && PTC_FINITE_F32(params->k[1])
            && PTC_FINITE_F32(params->deadbeat)
            && (params->deadbeat >= 0.0f)) {
            const uint32_t samples = params->samples;
            const float phi1_2 = params->h;
            const float phi1_3 = 0.5f * (params->h * params->h);
            const float q2_1 = (-6.0f) * (1.0f / params->h);
            const float q2_2 = 3.0f * (1.0f / params->h);
            const float e2_2 = 1.5f * (1.0f / params->h);
            const float e2_3 = 1.0f / (params->h * params->h);
            const float e1_2 = 0.45f * (1.0f / params->h);
            const float e1_3 = (-1.1f) * (1.0f / (params->h * params->h));
            const float e0_2 = (-0.425f) * (1.0f / params->h);
            const float e0_3 = 0.35f * (1.0f / (params->h * params->h));
            const float s1 = ((params->k[1] / 2.0f) - 1.0f) + 2.0f;
            const float s2 = (s1 < 4.0f) ? 4.0f : s1;
            const float deadbeat = (params->deadbeat > 0.0f) ? params->deadbeat : s2;
            const float w1_1 = (-(params->k[0] / 4.0f)) * (1.0f / (params->h * params->h));
            const float w1_2 = (-0.5f) * (-(params->k[0] / 4.0f)) * (1.0f / params->h);
            const float w2_2 = (1.0f - (params->k[1] / 2.0f)) * (1.0f / params->h);
            const float b_1 = -(1.0f / (params->h * params->h));
            const float b_2 = (-1.5f) * (1.0f / params->h);
            const float u_max = params->u_max;
            if (PTC_FINITE_F32(phi1_3)
                && PTC_FINITE_F32(q2_1)
                && PTC_FINITE_F32(q2_2)
                && PTC_FINITE_F32(e2_2)
                && PTC_FINITE_F32(e2_3)
                && PTC_FINITE_F32(e1_2)
                && PTC_FINITE_F32(e1_3)
                && PTC_FINITE_F32(e0_2)
                && PTC_FINITE_F32(e0_3)
                && PTC_FINITE_F32(deadbeat)
                && PTC_FINITE_F32(w1_1)
                && PTC_FINITE_F32(w1_2)
                && PTC_FINITE_F32(w2_2)
                && PTC_FINITE_F32(b_1)
                && PTC_FINITE_F32(b_2)
                && (params->h * params->h >= 1e-30f)
                && (1.0f / (params->h * params->h) >= 1e-30f)) {
                self->start = 0U;
                self->samples = samples;
                self->u1 = 0.0f;
                self->seen = 0U;
                self->x1_hat = 0.0f;
                self->x2_hat = 0.0f;
                self->d_hat = 0.0f;
                self->phi1_2 = phi1_2;
                self->phi1_3 = phi1_3;
                self->q2_1 = q2_1;
                self->q2_2 = q2_2;
                self->e2_2 = e2_2;
                self->e2_3 = e2_3;
                self->e1_2 = e1_2;
                self->e1_3 = e1_3;
                self->e0_2 = e0_2;
                self->e0_3 = e0_3;
                self->deadbeat = deadbeat;
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

ptc_status a_name_that_fills_half_of_a_line_alone_4_arm(
    a_name_that_fills_half_of_a_line_alone_4 *self,
    uint32_t k)
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

ptc_status a_name_that_fills_half_of_a_line_alone_4_step(
    a_name_that_fills_half_of_a_line_alone_4 *self,
    uint32_t k,
    const float y[1],
    float *u)
{
    ptc_status status = PTC_E_INPUT;

    if (u != NULL) {
        *u = 0.0f;
    }
    if ((self != NULL) && (y != NULL) && (u != NULL)) {
        if (PTC_FINITE_F32(y[0])) {
            const uint32_t elapsed = k - self->start;

            /* Predict. */
            const float s1 = self->x1_hat + (self->phi1_2 * self->x2_hat);
            const float p1 = s1 + (self->phi1_3 * self->d_hat) + (self->phi1_3 * self->u1);
            const float s2 = self->x2_hat + (self->phi1_2 * self->d_hat);
            const float p2 = s2 + (self->phi1_2 * self->u1);
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
            const uint32_t left_o = (elapsed < (self->samples / 2U)) ? ((self->samples / 2U) - elapsed) : 0U;
            const float o0 = (float)left_o;
            float l1;
            float l2;
            float l3;
            if (o0 > 6.0f) {
                const float r0 = 1.0f / o0;
                const float r1 = 1.0f / (o0 - 1.0f);
                const float r2 = 1.0f / (o0 - 2.0f);
                l1 = ((((A_NAME_THAT_FILLS_HALF_OF_A_LINE_ALONE_4_Q1_1 * r0) + A_NAME_THAT_FILLS_HALF_OF_A_LINE_ALONE_4_Q1_2) * r1) + A_NAME_THAT_FILLS_HALF_OF_A_LINE_ALONE_4_Q1_3) * r2;
                l2 = ((self->q2_1 * r0) + self->q2_2) * r1 * r2;
                l3 = 0.0f;
            } else if (left_o == 6U) {
                l1 = 1.0f;
                l2 = self->e0_2;
                l3 = self->e0_3;
            } else if (left_o == 5U) {
                l1 = 1.0f;
                l2 = self->e1_2;
                l3 = self->e1_3;
            } else {
                l1 = 1.0f;
                l2 = self->e2_2;
                l3 = self->e2_3;
            }
            const float x1 = base + (l1 * miss);
            const float x2 = p2 + (l2 * miss);
            const float d = p3 + (l3 * miss);
            const uint32_t left = (elapsed < self->samples) ? (self->samples - elapsed) : 0U;
            const float m0 = (float)left;
            float v;
            if (m0 > self->deadbeat) {
                /* The exact law in samples. */
                const float z1 = (self->w1_1 * x1) + (self->w1_2 * x2);
                const float z2 = self->w2_2 * x2;
                v = ((z1 + (z2 * m0)) / (m0 * (m0 - 1.0f))) - d;
            } else {
                /* Deadbeat. */
                v = ((self->b_1 * x1) + (self->b_2 * x2)) - d;
            }
            status = PTC_E_RANGE;
            if (PTC_FINITE_F32(v)) {
                float u_now;
                if (elapsed < self->samples) {
                    if (v > self->u_max) {
                        u_now = self->u_max;
                    } else if (v < -self->u_max) {
                        u_now = -self->u_max;
                    } else {
                        u_now = v;
                    }
                } else {
                    u_now = 0.0f;
                }
                self->u1 = u_now;
                self->x1_hat = x1;
                self->x2_hat = x2;
                self->d_hat = d;
                self->seen = 1U;
                *u = u_now;
                if (elapsed < self->samples) {
                    if ((v > self->u_max) || (v < -self->u_max)) {
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

ptc_status a_name_that_fills_half_of_a_line_alone_4_estimate(
    const a_name_that_fills_half_of_a_line_alone_4 *self,
    float xhat[2])
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

ptc_status a_name_that_fills_half_of_a_line_alone_4_disturbance(
    const a_name_that_fills_half_of_a_line_alone_4 *self,
    float *d)
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (d != NULL)) {
        *d = self->d_hat;
        status = PTC_OK;
    }
    return status;
}
