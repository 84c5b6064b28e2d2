/* Prescribed-time observer stage15_observer: see stage15_observer.h. DO NOT EDIT. */
#include "stage15_observer.h"

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
#define STAGE15_OBSERVER_OBSERVER_SAMPLES 9U /* samples of the round of the observer */
#define STAGE15_OBSERVER_Q1_1 35.555557f /* 320/9, weight in the observer's gain l1 */
#define STAGE15_OBSERVER_Q1_2 (-23.88889f) /* -215/9, weight in the observer's gain l1 */
#define STAGE15_OBSERVER_Q1_3 7.0f /* weight in the observer's gain l1 */

ptc_status stage15_observer_init(stage15_observer *self, const stage15_observer_params *params)
{
    ptc_status status = PTC_E_PARAM;

    if ((self != NULL) && (params != NULL)) {
        if ((1e-18f <= params->h) && (params->h <= 1e18f)) {
            const float phi1_2 = params->h;
            const float phi1_3 = 0.25f * (params->h * params->h);
            const float gamma1 = 0.1875f * (params->h * params->h);
            const float late_gamma1 = 0.0625f * (params->h * params->h);
            const float phi2_3 = 0.5f * params->h;
            const float gamma2 = 0.25f * params->h;
            const float hold_o = 0.05f / params->h;
            const float q2_1 = (-22.444445f) * (1.0f / params->h);
            const float q2_2 = 9.888889f * (1.0f / params->h);
            const float q3_1 = 3.5555556f * (1.0f / (params->h * params->h));
            if (PTC_FINITE_F32(phi1_3)
                && PTC_FINITE_F32(gamma1)
                && PTC_FINITE_F32(late_gamma1)
                && PTC_FINITE_F32(phi2_3)
                && PTC_FINITE_F32(gamma2)
                && PTC_FINITE_F32(hold_o)
                && PTC_FINITE_F32(q2_1)
                && PTC_FINITE_F32(q2_2)
                && PTC_FINITE_F32(q3_1)
                && (params->h * params->h >= 1e-30f)
                && (1.0f / (params->h * params->h) >= 1e-30f)
                && (hold_o >= 3.0f)) {
                self->start = 0U;
                self->u1 = 0.0f;
                self->u2 = 0.0f;
                self->seen = 0U;
                self->x1_hat = 0.0f;
                self->x2_hat = 0.0f;
                self->d_hat = 0.0f;
                self->phi1_2 = phi1_2;
                self->phi1_3 = phi1_3;
                self->gamma1 = gamma1;
                self->late_gamma1 = late_gamma1;
                self->phi2_3 = phi2_3;
                self->gamma2 = gamma2;
                self->hold_o = hold_o;
                self->q2_1 = q2_1;
                self->q2_2 = q2_2;
                self->q3_1 = q3_1;
                status = PTC_OK;
            }
        }
    }
    return status;
}

ptc_status stage15_observer_arm(stage15_observer *self, uint32_t k)
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

ptc_status stage15_observer_update(stage15_observer *self, uint32_t k, const float y[1], float u)
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (y != NULL)) {
        if (PTC_FINITE_F32(y[0]) && PTC_FINITE_F32(u)) {
            const uint32_t elapsed = k - self->start;

            /* Predict. */
            const float s1 = self->x1_hat + (self->phi1_2 * self->x2_hat);
            const float s2 = self->late_gamma1 * (self->u1 - 19.62f);
            const float s3 = (self->gamma1 * (self->u2 - 19.62f)) + s2;
            const float p1 = s1 + (self->phi1_3 * self->d_hat) + s3;
            const float s4 = self->gamma2 * (self->u2 - 19.62f);
            const float s5 = self->x2_hat + (self->phi2_3 * self->d_hat);
            const float p2 = s5 + (s4 + (self->gamma2 * (self->u1 - 19.62f)));
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
            const uint32_t left_o = (elapsed < STAGE15_OBSERVER_OBSERVER_SAMPLES) ? (STAGE15_OBSERVER_OBSERVER_SAMPLES - elapsed) : 0U;
            const float o0 = ((float)left_o < self->hold_o) ? self->hold_o : (float)left_o;
            float l1;
            float l2;
            float l3;
            const float o0f2 = o0 * (o0 - 1.0f);
            const float r0 = 1.0f / (o0f2 * (o0 - 2.0f));
            l1 = (STAGE15_OBSERVER_Q1_1 + (STAGE15_OBSERVER_Q1_2 * o0) + (STAGE15_OBSERVER_Q1_3 * o0f2)) * r0;
            l2 = (self->q2_1 + (self->q2_2 * o0)) * r0;
            l3 = self->q3_1 * r0;
            const float x1 = base + (l1 * miss);
            const float x2 = p2 + (l2 * miss);
            const float d = p3 + (l3 * miss);
            status = PTC_E_RANGE;
            if (PTC_FINITE_F32(x1) && PTC_FINITE_F32(x2) && PTC_FINITE_F32(d)) {
                self->u2 = self->u1;
                self->u1 = u;
                self->x1_hat = x1;
                self->x2_hat = x2;
                self->d_hat = d;
                self->seen = 1U;
                if (left_o == 0U) {
                    status = PTC_HOLD;
                } else {
                    status = PTC_OK;
                }
            }
        }
    }
    return status;
}

ptc_status stage15_observer_estimate(const stage15_observer *self, float xhat[2])
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

ptc_status stage15_observer_disturbance(const stage15_observer *self, float *d)
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (d != NULL)) {
        *d = self->d_hat;
        status = PTC_OK;
    }
    return status;
}
