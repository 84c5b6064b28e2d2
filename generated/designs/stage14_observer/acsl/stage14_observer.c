/* Prescribed-time observer stage14_observer: see stage14_observer.h. DO NOT EDIT. */
#include "stage14_observer.h"

#include <float.h>
#include <math.h>
#include <stddef.h>
#include <stdint.h>

/* What this file requires of its compiler. */
#if defined(__SDCC) || (defined(DBL_MANT_DIG) && (DBL_MANT_DIG != 53))
#error "double is not IEEE 754 binary64 here: emit with --precision f32, or make double 64 bits wide"
#endif
#if defined(FLT_EVAL_METHOD) && !defined(PTC_ALLOW_EXCESS_PRECISION)
#if (FLT_EVAL_METHOD == 2)
#error "double is computed with more digits than it has: on x86 compile with -msse2 -mfpmath=sse, or define PTC_ALLOW_EXCESS_PRECISION"
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

#if !defined(PTC_FINITE_F64)
#if defined(isfinite) && !defined(__MINGW32__)
#define PTC_FINITE_F64(x) (isfinite(x) != 0)
#else
#define PTC_FINITE_F64(x) (fabs(x) <= DBL_MAX)
#endif
#endif

/* Numbers of the design, each rounded once. */
#define STAGE14_OBSERVER_OBSERVER_SAMPLES 12U /* samples of the round of the observer */
#define STAGE14_OBSERVER_Q1_1 104.0 /* weight in the observer's gain l1 */
#define STAGE14_OBSERVER_Q1_2 (-53.0) /* weight in the observer's gain l1 */
#define STAGE14_OBSERVER_Q1_3 11.0 /* weight in the observer's gain l1 */

ptc_status stage14_observer_init(stage14_observer *self, const stage14_observer_params *params)
{
    ptc_status status = PTC_E_PARAM;

    if ((self != NULL) && (params != NULL)) {
        if ((1e-150 <= params->h) && (params->h <= 1e150)) {
            const double phi1_2 = params->h;
            const double phi1_3 = 0.5 * (params->h * params->h);
            const double gamma1 = 0.16666666666666666 * (params->h * params->h * params->h);
            const double q2_1 = (-92.0) * (1.0 / params->h);
            const double q2_2 = 31.0 * (1.0 / params->h);
            const double q3_1 = 20.0 * (1.0 / (params->h * params->h));
            const double e2_2 = 1.5 * (1.0 / params->h);
            const double e2_3 = 1.0 / (params->h * params->h);
            const double e1_2 = 0.9166666666666666 * (1.0 / params->h);
            const double e1_3 = (-0.16666666666666666) * (1.0 / (params->h * params->h));
            const double e0_2 = 0.4880952380952381 * (1.0 / params->h);
            const double e0_3 = 0.16666666666666666 * (1.0 / (params->h * params->h));
            if (PTC_FINITE_F64(phi1_3)
                && PTC_FINITE_F64(gamma1)
                && PTC_FINITE_F64(q2_1)
                && PTC_FINITE_F64(q2_2)
                && PTC_FINITE_F64(q3_1)
                && PTC_FINITE_F64(e2_2)
                && PTC_FINITE_F64(e2_3)
                && PTC_FINITE_F64(e1_2)
                && PTC_FINITE_F64(e1_3)
                && PTC_FINITE_F64(e0_2)
                && PTC_FINITE_F64(e0_3)
                && (params->h * params->h * params->h >= 1e-200)
                && (1.0 / (params->h * params->h * params->h) >= 1e-200)) {
                self->start = 0U;
                self->seen = 0U;
                self->x1_hat = 0.0;
                self->x2_hat = 0.0;
                self->x3_hat = 0.0;
                self->phi1_2 = phi1_2;
                self->phi1_3 = phi1_3;
                self->gamma1 = gamma1;
                self->q2_1 = q2_1;
                self->q2_2 = q2_2;
                self->q3_1 = q3_1;
                self->e2_2 = e2_2;
                self->e2_3 = e2_3;
                self->e1_2 = e1_2;
                self->e1_3 = e1_3;
                self->e0_2 = e0_2;
                self->e0_3 = e0_3;
                status = PTC_OK;
            }
        }
    }
    return status;
}

ptc_status stage14_observer_arm(stage14_observer *self, uint32_t k)
{
    ptc_status status = PTC_E_INPUT;

    if (self != NULL) {
        self->start = k;
        const double size = fabs(self->x1_hat) + fabs(self->x2_hat) + fabs(self->x3_hat);
        if (!(size <= 1e150)) {
            self->seen = 0U;
            self->x1_hat = 0.0;
            self->x2_hat = 0.0;
            self->x3_hat = 0.0;
        }
        status = PTC_OK;
    }
    return status;
}

ptc_status stage14_observer_update(stage14_observer *self, uint32_t k, const double y[1], double u)
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (y != NULL)) {
        if (PTC_FINITE_F64(y[0]) && PTC_FINITE_F64(u)) {
            const uint32_t elapsed = k - self->start;

            /* Predict. */
            const double s1 = self->x1_hat + (self->phi1_2 * self->x2_hat);
            const double p1 = s1 + (self->phi1_3 * self->x3_hat) + (self->gamma1 * u);
            const double s2 = self->x2_hat + (self->phi1_2 * self->x3_hat);
            const double p2 = s2 + (self->phi1_3 * u);
            const double p3 = self->x3_hat + (self->phi1_2 * u);

            /* Correct by what is measured. */
            double base;
            double miss;
            if (self->seen == 0U) {
                base = y[0];
                miss = 0.0;
            } else {
                base = p1;
                miss = y[0] - p1;
            }
            const uint32_t left_o = (elapsed < STAGE14_OBSERVER_OBSERVER_SAMPLES) ? (STAGE14_OBSERVER_OBSERVER_SAMPLES - elapsed) : 0U;
            const double o0 = (double)left_o;
            double l1;
            double l2;
            double l3;
            if (o0 > 7.0) {
                const double o0f2 = o0 * (o0 - 1.0);
                const double r0 = 1.0 / (o0f2 * (o0 - 2.0));
                l1 = (STAGE14_OBSERVER_Q1_1 + (STAGE14_OBSERVER_Q1_2 * o0) + (STAGE14_OBSERVER_Q1_3 * o0f2)) * r0;
                l2 = (self->q2_1 + (self->q2_2 * o0)) * r0;
                l3 = self->q3_1 * r0;
            } else if (left_o == 7U) {
                l1 = 1.0;
                l2 = self->e0_2;
                l3 = self->e0_3;
            } else if (left_o == 6U) {
                l1 = 1.0;
                l2 = self->e1_2;
                l3 = self->e1_3;
            } else {
                l1 = 1.0;
                l2 = self->e2_2;
                l3 = self->e2_3;
            }
            const double x1 = base + (l1 * miss);
            const double x2 = p2 + (l2 * miss);
            const double x3 = p3 + (l3 * miss);
            status = PTC_E_RANGE;
            if (PTC_FINITE_F64(x1) && PTC_FINITE_F64(x2) && PTC_FINITE_F64(x3)) {
                self->x1_hat = x1;
                self->x2_hat = x2;
                self->x3_hat = x3;
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

ptc_status stage14_observer_estimate(const stage14_observer *self, double xhat[3])
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
            xhat[i] = 0.0;
        }
    }
    return status;
}
