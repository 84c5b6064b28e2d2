/* Prescribed-time controller stage7: see stage7.h. DO NOT EDIT. */
#include "stage7.h"

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
#define STAGE7_Q1_1 (-20.0f) /* weight in the observer's gain l1 */
#define STAGE7_Q1_2 8.0f /* weight in the observer's gain l1 */

ptc_status stage7_init(stage7 *self, const stage7_params *params)
{
    ptc_status status = PTC_E_PARAM;

    if ((self != NULL) && (params != NULL)) {
        if ((params->samples > 3U)
            && (1e-18f <= params->h)
            && (params->h <= 1e18f)
            && (params->u_max > 0.0f)) {
            const uint32_t samples = params->samples;
            const float phi1_2 = params->h;
            const float q2_1 = 12.0f * (1.0f / params->h);
            const float e1_2 = 1.0f / params->h;
            const float e0_2 = 0.33333334f * (1.0f / params->h);
            const float w1_1 = (-3.0f) * (1.0f / params->h);
            const float u_max = params->u_max;
            if (PTC_FINITE_F32(q2_1)
                && PTC_FINITE_F32(e1_2)
                && PTC_FINITE_F32(e0_2)
                && PTC_FINITE_F32(w1_1)
                && (params->h >= 1e-30f)
                && (1.0f / params->h >= 1e-30f)) {
                self->start = 0U;
                self->samples = samples;
                self->u1 = 0.0f;
                self->seen = 0U;
                self->x1_hat = 0.0f;
                self->d_hat = 0.0f;
                self->phi1_2 = phi1_2;
                self->q2_1 = q2_1;
                self->e1_2 = e1_2;
                self->e0_2 = e0_2;
                self->w1_1 = w1_1;
                self->u_max = u_max;
                status = PTC_OK;
            }
        }
    }
    return status;
}

ptc_status stage7_arm(stage7 *self, uint32_t k)
{
    ptc_status status = PTC_OK;

    self->start = k;
    const float size = fabsf(self->x1_hat) + fabsf(self->d_hat);
    if (!(size <= 1e18f)) {
        self->seen = 0U;
        self->x1_hat = 0.0f;
        self->d_hat = 0.0f;
    }
    status = PTC_OK;
    return status;
}

ptc_status stage7_step(stage7 *self, uint32_t k, const float y[1], float *u)
{
    ptc_status status = PTC_OK;

    *u = 0.0f;
    const uint32_t elapsed = k - self->start;

    /* Predict. */
    const float s1 = self->x1_hat + (self->phi1_2 * self->d_hat);
    const float p1 = s1 + (self->phi1_2 * self->u1);
    const float p2 = self->d_hat;

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
    if (o0 > 6.0f) {
        const float r0 = 1.0f / (o0 * (o0 - 1.0f));
        l1 = (STAGE7_Q1_1 + (STAGE7_Q1_2 * o0)) * r0;
        l2 = self->q2_1 * r0;
    } else if (left_o == 6U) {
        l1 = 1.0f;
        l2 = self->e0_2;
    } else {
        l1 = 1.0f;
        l2 = self->e1_2;
    }
    const float x1 = base + (l1 * miss);
    const float d = p2 + (l2 * miss);
    const uint32_t left = (elapsed < self->samples) ? (self->samples - elapsed) : 0U;
    const float m0 = ((float)left < 1.0f) ? 1.0f : (float)left;
    float v;

    /* The exact law in samples. */
    const float z1 = self->w1_1 * x1;
    v = (z1 / (m0 + 2.0f)) - d;
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
    return status;
}

ptc_status stage7_estimate(const stage7 *self, float xhat[1])
{
    ptc_status status = PTC_OK;

    xhat[0] = self->x1_hat;
    status = PTC_OK;
    return status;
}

ptc_status stage7_disturbance(const stage7 *self, float *d)
{
    ptc_status status = PTC_OK;

    *d = self->d_hat;
    status = PTC_OK;
    return status;
}
