/* Prescribed-time observer drift_observer: see drift_observer.h. DO NOT EDIT. */
#include "drift_observer.h"

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
#define DRIFT_OBSERVER_OBSERVER_SAMPLES 60U /* samples of the round of the observer */
#define DRIFT_OBSERVER_Q1_1 (-840.0) /* weight in the observer's gain l1 */
#define DRIFT_OBSERVER_Q1_2 480.0 /* weight in the observer's gain l1 */
#define DRIFT_OBSERVER_Q1_3 (-120.0) /* weight in the observer's gain l1 */
#define DRIFT_OBSERVER_Q1_4 16.0 /* weight in the observer's gain l1 */

ptc_status drift_observer_init(drift_observer *self, const drift_observer_params *params)
{
    ptc_status status = PTC_E_PARAM;

    if ((self != NULL) && (params != NULL)) {
        if ((1e-150 <= params->h) && (params->h <= 1e150)) {
            const double phi1_2 = params->h;
            const double phi1_3 = 0.5 * (params->h * params->h);
            const double phi1_4 = 0.16666666666666666 * (params->h * params->h * params->h);
            const double q2_1 = 908.0 * (1.0 / params->h);
            const double q2_2 = (-432.0) * (1.0 / params->h);
            const double q2_3 = 72.0 * (1.0 / params->h);
            const double q3_1 = (-336.0) * (1.0 / (params->h * params->h));
            const double q3_2 = 96.0 * (1.0 / (params->h * params->h));
            const double q4_1 = 24.0 * (1.0 / (params->h * params->h * params->h));
            const double e3_2 = 1.8333333333333333 * (1.0 / params->h);
            const double e3_3 = 2.0 * (1.0 / (params->h * params->h));
            const double e3_4 = 1.0 / (params->h * params->h * params->h);
            const double e2_2 = 1.1666666666666667 * (1.0 / params->h);
            const double e2_4 = -(1.0 / (params->h * params->h * params->h));
            const double e1_2 = 0.8148148148148148 * (1.0 / params->h);
            const double e1_3 = (-0.2222222222222222) * (1.0 / (params->h * params->h));
            const double s1 = 1.0 / (params->h * params->h * params->h);
            const double e1_4 = 0.4444444444444444 * s1;
            const double e0_2 = 0.4777777777777778 * (1.0 / params->h);
            const double e0_3 = 0.26666666666666666 * (1.0 / (params->h * params->h));
            const double s2 = 1.0 / (params->h * params->h * params->h);
            const double e0_4 = (-0.06666666666666667) * s2;
            if (PTC_FINITE_F64(phi1_3)
                && PTC_FINITE_F64(phi1_4)
                && PTC_FINITE_F64(q2_1)
                && PTC_FINITE_F64(q2_2)
                && PTC_FINITE_F64(q2_3)
                && PTC_FINITE_F64(q3_1)
                && PTC_FINITE_F64(q3_2)
                && PTC_FINITE_F64(q4_1)
                && PTC_FINITE_F64(e3_2)
                && PTC_FINITE_F64(e3_3)
                && PTC_FINITE_F64(e3_4)
                && PTC_FINITE_F64(e2_2)
                && PTC_FINITE_F64(e2_4)
                && PTC_FINITE_F64(e1_2)
                && PTC_FINITE_F64(e1_3)
                && PTC_FINITE_F64(e1_4)
                && PTC_FINITE_F64(e0_2)
                && PTC_FINITE_F64(e0_3)
                && PTC_FINITE_F64(e0_4)
                && (params->h * params->h * params->h >= 1e-200)
                && (1.0 / (params->h * params->h * params->h) >= 1e-200)) {
                self->start = 0U;
                self->seen = 0U;
                self->x2_hat = 0.0;
                self->x3_hat = 0.0;
                self->d_hat = 0.0;
                self->d_rate_hat = 0.0;
                self->phi1_2 = phi1_2;
                self->phi1_3 = phi1_3;
                self->phi1_4 = phi1_4;
                self->q2_1 = q2_1;
                self->q2_2 = q2_2;
                self->q2_3 = q2_3;
                self->q3_1 = q3_1;
                self->q3_2 = q3_2;
                self->q4_1 = q4_1;
                self->e3_2 = e3_2;
                self->e3_3 = e3_3;
                self->e3_4 = e3_4;
                self->e2_2 = e2_2;
                self->e2_4 = e2_4;
                self->e1_2 = e1_2;
                self->e1_3 = e1_3;
                self->e1_4 = e1_4;
                self->e0_2 = e0_2;
                self->e0_3 = e0_3;
                self->e0_4 = e0_4;
                status = PTC_OK;
            }
        }
    }
    return status;
}

ptc_status drift_observer_arm(drift_observer *self, uint32_t k)
{
    ptc_status status = PTC_E_INPUT;

    if (self != NULL) {
        self->start = k;
        const double s1 = fabs(self->x2_hat) + fabs(self->x3_hat) + fabs(self->d_hat);
        const double size = s1 + fabs(self->d_rate_hat);
        if (!(size <= 1e150)) {
            self->seen = 0U;
            self->x2_hat = 0.0;
            self->x3_hat = 0.0;
            self->d_hat = 0.0;
            self->d_rate_hat = 0.0;
        }
        status = PTC_OK;
    }
    return status;
}

ptc_status drift_observer_update(drift_observer *self, uint32_t k, const double y[2], double u)
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (y != NULL)) {
        if (PTC_FINITE_F64(y[0]) && PTC_FINITE_F64(y[1]) && PTC_FINITE_F64(u)) {
            const uint32_t elapsed = k - self->start;

            /* Predict. */
            const double s1 = self->x2_hat + (self->phi1_2 * self->x3_hat);
            const double s2 = s1 + (self->phi1_3 * self->d_hat);
            const double p1 = s2 + (self->phi1_4 * self->d_rate_hat) + (self->phi1_3 * u);
            const double s3 = self->x3_hat + (self->phi1_2 * self->d_hat);
            const double p2 = s3 + (self->phi1_3 * self->d_rate_hat) + (self->phi1_2 * u);
            const double p3 = self->d_hat + (self->phi1_2 * self->d_rate_hat);
            const double p4 = self->d_rate_hat;

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
            const uint32_t left_o = (elapsed < DRIFT_OBSERVER_OBSERVER_SAMPLES) ? (DRIFT_OBSERVER_OBSERVER_SAMPLES - elapsed) : 0U;
            const double o0 = (double)left_o;
            double l1;
            double l2;
            double l3;
            double l4;
            if (o0 > 10.0) {
                const double o0f2 = o0 * (o0 - 1.0);
                const double o0f3 = o0f2 * (o0 - 2.0);
                const double r0 = 1.0 / (o0f3 * (o0 - 3.0));
                const double s4 = DRIFT_OBSERVER_Q1_1 + (DRIFT_OBSERVER_Q1_2 * o0) + (DRIFT_OBSERVER_Q1_3 * o0f2);
                l1 = (s4 + (DRIFT_OBSERVER_Q1_4 * o0f3)) * r0;
                l2 = (self->q2_1 + (self->q2_2 * o0) + (self->q2_3 * o0f2)) * r0;
                l3 = (self->q3_1 + (self->q3_2 * o0)) * r0;
                l4 = self->q4_1 * r0;
            } else if (left_o == 10U) {
                l1 = 1.0;
                l2 = self->e0_2;
                l3 = self->e0_3;
                l4 = self->e0_4;
            } else if (left_o == 9U) {
                l1 = 1.0;
                l2 = self->e1_2;
                l3 = self->e1_3;
                l4 = self->e1_4;
            } else if (left_o == 8U) {
                l1 = 1.0;
                l2 = self->e2_2;
                l3 = 0.0;
                l4 = self->e2_4;
            } else {
                l1 = 1.0;
                l2 = self->e3_2;
                l3 = self->e3_3;
                l4 = self->e3_4;
            }
            const double x2 = base + (l1 * miss);
            const double x3 = p2 + (l2 * miss);
            const double d = p3 + (l3 * miss);
            const double d_rate = p4 + (l4 * miss);
            status = PTC_E_RANGE;
            if (PTC_FINITE_F64(x2)
                && PTC_FINITE_F64(x3)
                && PTC_FINITE_F64(d)
                && PTC_FINITE_F64(d_rate)) {
                self->x2_hat = x2;
                self->x3_hat = x3;
                self->d_hat = d;
                self->d_rate_hat = d_rate;
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

ptc_status drift_observer_estimate(const drift_observer *self, double xhat[2])
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (xhat != NULL)) {
        xhat[0] = self->x2_hat;
        xhat[1] = self->x3_hat;
        status = PTC_OK;
    }
    if ((status < PTC_OK) && (xhat != NULL)) {
        for (uint32_t i = 0U; i < 2U; i++) {
            xhat[i] = 0.0;
        }
    }
    return status;
}

ptc_status drift_observer_disturbance(const drift_observer *self, double *d)
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (d != NULL)) {
        *d = self->d_hat;
        status = PTC_OK;
    }
    return status;
}
