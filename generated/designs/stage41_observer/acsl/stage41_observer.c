/* Prescribed-time observer stage41_observer: see stage41_observer.h. DO NOT EDIT. */
#include "stage41_observer.h"

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
#define STAGE41_OBSERVER_GAMMA1 0.00010803832f /* prediction from u */
#define STAGE41_OBSERVER_GAMMA2 0.030892799f /* prediction from u */
#define STAGE41_OBSERVER_GAMMA3 0.37459216f /* prediction from u */
#define STAGE41_OBSERVER_OBSERVER_SAMPLES 20U /* samples of the round of the observer */
#define STAGE41_OBSERVER_Q1_1_1 (-8.0f) /* weight in the observer's gain l1_1 */
#define STAGE41_OBSERVER_Q1_1_2 8.0f /* weight in the observer's gain l1_1 */
#define STAGE41_OBSERVER_Q1_2_1 1218.3761f /* weight in the observer's gain l1_2 */
#define STAGE41_OBSERVER_Q1_2_2 (-11.457022f) /* weight in the observer's gain l1_2 */
#define STAGE41_OBSERVER_Q1_3_1 90.17191f /* weight in the observer's gain l1_3 */
#define STAGE41_OBSERVER_Q1_3_2 (-90.17191f) /* weight in the observer's gain l1_3 */
#define STAGE41_OBSERVER_Q2_2_1 (-0.37285107f) /* weight in the observer's gain l2_2 */
#define STAGE41_OBSERVER_Q2_3_1 6.0f /* weight in the observer's gain l2_3 */
#define STAGE41_OBSERVER_E0_1_1 1.1216538f /* gain of the observer at its end */
#define STAGE41_OBSERVER_E0_1_2 11.488578f /* gain of the observer at its end */
#define STAGE41_OBSERVER_E0_1_3 (-7.5500894f) /* gain of the observer at its end */
#define STAGE41_OBSERVER_E0_2_2 0.05081172f /* gain of the observer at its end */
#define STAGE41_OBSERVER_E0_2_3 0.5481857f /* gain of the observer at its end */
#define STAGE41_OBSERVER_E1_1_1 1.9787967f /* gain of the observer at its end */
#define STAGE41_OBSERVER_E1_1_2 96.46954f /* gain of the observer at its end */
#define STAGE41_OBSERVER_E1_1_3 (-17.211365f) /* gain of the observer at its end */
#define STAGE41_OBSERVER_E1_2_2 0.05081172f /* gain of the observer at its end */
#define STAGE41_OBSERVER_E1_2_3 0.5481857f /* gain of the observer at its end */
#define STAGE41_OBSERVER_PHI1_2 0.009942672f /* prediction of x1 from x2 */
#define STAGE41_OBSERVER_PHI1_3 0.000617856f /* prediction of x1 from x3 */
#define STAGE41_OBSERVER_PHI2_2 0.9857608f /* prediction of x2 from x2 */
#define STAGE41_OBSERVER_PHI2_3 0.11206872f /* prediction of x2 from x3 */
#define STAGE41_OBSERVER_PHI3_2 (-0.11206872f) /* prediction of x3 from x2 */
#define STAGE41_OBSERVER_PHI3_3 0.54122156f /* prediction of x3 from x3 */

ptc_status stage41_observer_init(stage41_observer *self, const stage41_observer_params *params)
{
    ptc_status status = PTC_E_PARAM;

    (void)params;
    if (self != NULL) {
        self->start = 0U;
        self->seen = 0U;
        self->x1_hat = 0.0f;
        self->x1_next = 0.0f;
        self->x2_hat = 0.0f;
        self->x2_next = 0.0f;
        self->x3_hat = 0.0f;
        self->x3_next = 0.0f;
        self->trust = 1U;
        status = PTC_OK;
    }
    return status;
}

ptc_status stage41_observer_arm(stage41_observer *self, uint32_t k)
{
    ptc_status status = PTC_E_INPUT;

    if (self != NULL) {
        self->start = k;
        const float s1 = fabsf(self->x1_next) + fabsf(self->x2_next);
        const float size = s1 + fabsf(self->x3_next);
        if (!((self->trust > 1U) && (size <= 1e18f))) {
            self->seen = 0U;
            self->x1_hat = 0.0f;
            self->x1_next = 0.0f;
            self->x2_hat = 0.0f;
            self->x2_next = 0.0f;
            self->x3_hat = 0.0f;
            self->x3_next = 0.0f;
        }
        status = PTC_OK;
    }
    return status;
}

ptc_status stage41_observer_update(stage41_observer *self, uint32_t k, const float y[2], float u)
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (y != NULL)) {
        if (PTC_FINITE_F32(u)) {
            const uint32_t elapsed = k - self->start;

            /* The estimates; at first what y shows. */
            float x1;
            float x2;
            float x3;
            if (self->seen == 0U) {
                x1 = y[0];
                x2 = 0.0f;
                x3 = y[1];
            } else {
                x1 = self->x1_next + (STAGE41_OBSERVER_GAMMA1 * u);
                x2 = self->x2_next + (STAGE41_OBSERVER_GAMMA2 * u);
                x3 = self->x3_next + (STAGE41_OBSERVER_GAMMA3 * u);
            }

            /* Prediction of the next sample. */
            const float gap1 = y[0] - x1;
            const float gap2 = y[1] - x3;
            float miss1;
            float miss2;
            uint32_t trust;
            if (PTC_FINITE_F32(y[0])
                && (fabsf(gap1) <= 1.0f)
                && PTC_FINITE_F32(y[1])
                && (fabsf(gap2) <= 0.75f)) {
                miss1 = gap1;
                miss2 = gap2;
                trust = 2U;
            } else {
                miss1 = 0.0f;
                miss2 = 0.0f;
                trust = (1U < self->trust) ? (self->trust - 1U) : 0U;
            }
            if (trust > 0U) {
                const float off1 = miss1;
                const float off2 = (11.271489f * miss1) + miss2;
                const uint32_t left_o = (elapsed < STAGE41_OBSERVER_OBSERVER_SAMPLES) ? (STAGE41_OBSERVER_OBSERVER_SAMPLES - elapsed) : 0U;
                const float o0 = (float)left_o;
                float l1_1;
                float l1_2;
                float l1_3;
                float l2_1;
                float l2_2;
                float l2_3;
                if (o0 > 7.0f) {
                    const float r0 = 1.0f / (o0 * (o0 - 1.0f));
                    l1_1 = ((STAGE41_OBSERVER_Q1_1_1 + (STAGE41_OBSERVER_Q1_1_2 * o0)) * r0) - 0.021203334f;
                    l1_2 = ((STAGE41_OBSERVER_Q1_2_1 + (STAGE41_OBSERVER_Q1_2_2 * o0)) * r0) - 1.242789f;
                    l1_3 = ((STAGE41_OBSERVER_Q1_3_1 + (STAGE41_OBSERVER_Q1_3_2 * o0)) * r0) + 5.3316126f;
                    l2_1 = 0.0f;
                    l2_2 = (STAGE41_OBSERVER_Q2_2_1 * r0) + 0.112953566f;
                    l2_3 = (STAGE41_OBSERVER_Q2_3_1 * r0) - 0.45181426f;
                } else if (left_o == 7U) {
                    l1_1 = STAGE41_OBSERVER_E0_1_1;
                    l1_2 = STAGE41_OBSERVER_E0_1_2;
                    l1_3 = STAGE41_OBSERVER_E0_1_3;
                    l2_1 = 0.0f;
                    l2_2 = STAGE41_OBSERVER_E0_2_2;
                    l2_3 = STAGE41_OBSERVER_E0_2_3;
                } else {
                    l1_1 = STAGE41_OBSERVER_E1_1_1;
                    l1_2 = STAGE41_OBSERVER_E1_1_2;
                    l1_3 = STAGE41_OBSERVER_E1_1_3;
                    l2_1 = 0.0f;
                    l2_2 = STAGE41_OBSERVER_E1_2_2;
                    l2_3 = STAGE41_OBSERVER_E1_2_3;
                }
                const float s1 = x1 + (STAGE41_OBSERVER_PHI1_2 * x2) + (STAGE41_OBSERVER_PHI1_3 * x3);
                const float x1_on = s1 + (l1_1 * off1) + (l2_1 * off2);
                const float s2 = (STAGE41_OBSERVER_PHI2_2 * x2) + (STAGE41_OBSERVER_PHI2_3 * x3) + (l1_2 * off1);
                const float x2_on = s2 + (l2_2 * off2);
                const float s3 = (STAGE41_OBSERVER_PHI3_2 * x2) + (STAGE41_OBSERVER_PHI3_3 * x3) + (l1_3 * off1);
                const float x3_on = s3 + (l2_3 * off2);
                status = PTC_E_RANGE;
                if (PTC_FINITE_F32(x1)
                    && PTC_FINITE_F32(x1_on)
                    && PTC_FINITE_F32(x2)
                    && PTC_FINITE_F32(x2_on)
                    && PTC_FINITE_F32(x3)
                    && PTC_FINITE_F32(x3_on)) {
                    self->x1_hat = x1;
                    self->x1_next = x1_on;
                    self->x2_hat = x2;
                    self->x2_next = x2_on;
                    self->x3_hat = x3;
                    self->x3_next = x3_on;
                    self->seen = 1U;
                    self->trust = trust;
                    if (trust < 2U) {
                        status = PTC_GATED;
                    } else if (left_o == 0U) {
                        status = PTC_HOLD;
                    } else {
                        status = PTC_OK;
                    }
                }
            }
        }
    }
    return status;
}

ptc_status stage41_observer_estimate(const stage41_observer *self, float xhat[3])
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (xhat != NULL)) {
        xhat[0] = self->x1_hat;
        xhat[1] = self->x2_hat;
        xhat[2] = self->x3_hat;
        status = PTC_OK;
    }
    if ((status < PTC_OK) && (xhat != NULL)) {
        for (uint32_t i = 0U; i < 3U; i++) {
            xhat[i] = 0.0f;
        }
    }
    return status;
}
