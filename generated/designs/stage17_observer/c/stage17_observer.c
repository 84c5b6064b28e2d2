/* Prescribed-time observer stage17_observer: see stage17_observer.h. DO NOT EDIT. */
#include "stage17_observer.h"

#include <float.h>
#include <math.h>
#include <stddef.h>

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
#define STAGE17_OBSERVER_OBSERVER_SAMPLES 8U /* samples of the round of the observer */
#define STAGE17_OBSERVER_Q1_1 (-20.0) /* weight in the observer's gain l1 */
#define STAGE17_OBSERVER_Q1_2 8.0 /* weight in the observer's gain l1 */

ptc_status stage17_observer_init(stage17_observer *self, const stage17_observer_params *params)
{
    ptc_status status = PTC_E_PARAM;

    if ((self != NULL) && (params != NULL)) {
        if ((1e-150 <= params->h) && (params->h <= 1e150)) {
            const double phi1_2 = params->h;
            const double q2_1 = 12.0 * (1.0 / params->h);
            const double e1_2 = 1.0 / params->h;
            const double e0_2 = 0.3333333333333333 * (1.0 / params->h);
            if (PTC_FINITE_F64(q2_1)
                && PTC_FINITE_F64(e1_2)
                && PTC_FINITE_F64(e0_2)
                && (params->h * params->h >= 1e-200)
                && (1.0 / (params->h * params->h) >= 1e-200)) {
                self->start = 0U;
                self->seen = 0U;
                self->x2_hat = 0.0;
                self->d_hat = 0.0;
                self->phi1_2 = phi1_2;
                self->q2_1 = q2_1;
                self->e1_2 = e1_2;
                self->e0_2 = e0_2;
                status = PTC_OK;
            }
        }
    }
    return status;
}

ptc_status stage17_observer_arm(stage17_observer *self, uint32_t k)
{
    ptc_status status = PTC_OK;

    self->start = k;
    const double size = fabs(self->x2_hat) + fabs(self->d_hat);
    if (!(size <= 1e150)) {
        self->seen = 0U;
        self->x2_hat = 0.0;
        self->d_hat = 0.0;
    }
    status = PTC_OK;
    return status;
}

ptc_status stage17_observer_update(stage17_observer *self, uint32_t k, const double y[2], double u)
{
    ptc_status status = PTC_OK;

    const uint32_t elapsed = k - self->start;

    /* Predict. */
    const double s1 = self->x2_hat + (self->phi1_2 * self->d_hat);
    const double p1 = s1 + (self->phi1_2 * u);
    const double p2 = self->d_hat;

    /* Correct by what is measured. */
    double base;
    double miss;
    if (self->seen == 0U) {
        base = y[1];
        miss = 0.0;
    } else {
        base = p1;
        miss = y[1] - p1;
    }
    const uint32_t left_o = (elapsed < STAGE17_OBSERVER_OBSERVER_SAMPLES) ? (STAGE17_OBSERVER_OBSERVER_SAMPLES - elapsed) : 0U;
    const double o0 = (double)left_o;
    double l1;
    double l2;
    if (o0 > 6.0) {
        const double r0 = 1.0 / (o0 * (o0 - 1.0));
        l1 = (STAGE17_OBSERVER_Q1_1 + (STAGE17_OBSERVER_Q1_2 * o0)) * r0;
        l2 = self->q2_1 * r0;
    } else if (left_o == 6U) {
        l1 = 1.0;
        l2 = self->e0_2;
    } else {
        l1 = 1.0;
        l2 = self->e1_2;
    }
    const double x2 = base + (l1 * miss);
    const double d = p2 + (l2 * miss);
    status = PTC_E_RANGE;
    if (PTC_FINITE_F64(x2) && PTC_FINITE_F64(d)) {
        self->x2_hat = x2;
        self->d_hat = d;
        self->seen = 1U;
        if (left_o == 0U) {
            status = PTC_HOLD;
        } else {
            status = PTC_OK;
        }
    }
    return status;
}

ptc_status stage17_observer_estimate(const stage17_observer *self, double xhat[1])
{
    ptc_status status = PTC_OK;

    xhat[0] = self->x2_hat;
    status = PTC_OK;
    return status;
}

ptc_status stage17_observer_disturbance(const stage17_observer *self, double *d)
{
    ptc_status status = PTC_OK;

    *d = self->d_hat;
    status = PTC_OK;
    return status;
}
