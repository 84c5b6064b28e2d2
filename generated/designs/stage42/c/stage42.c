/* Prescribed-time controller stage42: see stage42.h. DO NOT EDIT. */
#include "stage42.h"

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
#define STAGE42_Q1_1 (-5.0) /* weight in the observer's gain l1 */
#define STAGE42_Q1_2 3.5 /* 7/2, weight in the observer's gain l1 */

ptc_status stage42_init(stage42 *self, const stage42_params *params)
{
    ptc_status status = PTC_E_PARAM;

    if ((self != NULL) && (params != NULL)) {
        if ((params->samples > 3U)
            && (1e-150 <= params->h)
            && (params->h <= 1e150)
            && (params->u_max > 0.0)
            && PTC_FINITE_F64(params->k[0])
            && PTC_FINITE_F64(params->k[1])
            && PTC_FINITE_F64(params->deadbeat)
            && (params->deadbeat >= 0.0)) {
            const uint32_t samples = params->samples;
            const double phi1_2 = params->h;
            const double gamma1 = 0.5 * (params->h * params->h);
            const double q2_1 = 1.5 * (1.0 / params->h);
            const double e1_2 = 1.0 / params->h;
            const double e0_2 = (-0.125) * (1.0 / params->h);
            const double s1 = ((params->k[1] / 2.0) - 1.0) + 2.0;
            const double s2 = (s1 < 4.0) ? 4.0 : s1;
            const double deadbeat = (params->deadbeat > 0.0) ? params->deadbeat : s2;
            const double w1_1 = (-(params->k[0] / 4.0)) * (1.0 / (params->h * params->h));
            const double w1_2 = (-0.5) * (-(params->k[0] / 4.0)) * (1.0 / params->h);
            const double w2_2 = (1.0 - (params->k[1] / 2.0)) * (1.0 / params->h);
            const double b_1 = -(1.0 / (params->h * params->h));
            const double b_2 = (-1.5) * (1.0 / params->h);
            const double u_max = params->u_max;
            if (PTC_FINITE_F64(gamma1)
                && PTC_FINITE_F64(q2_1)
                && PTC_FINITE_F64(e1_2)
                && PTC_FINITE_F64(e0_2)
                && PTC_FINITE_F64(deadbeat)
                && PTC_FINITE_F64(w1_1)
                && PTC_FINITE_F64(w1_2)
                && PTC_FINITE_F64(w2_2)
                && PTC_FINITE_F64(b_1)
                && PTC_FINITE_F64(b_2)
                && (params->h * params->h >= 1e-200)
                && (1.0 / (params->h * params->h) >= 1e-200)) {
                self->start = 0U;
                self->samples = samples;
                self->u1 = 0.0;
                self->seen = 0U;
                self->x1_hat = 0.0;
                self->x2_hat = 0.0;
                self->phi1_2 = phi1_2;
                self->gamma1 = gamma1;
                self->q2_1 = q2_1;
                self->e1_2 = e1_2;
                self->e0_2 = e0_2;
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

ptc_status stage42_arm(stage42 *self, uint32_t k)
{
    ptc_status status = PTC_E_INPUT;

    if (self != NULL) {
        self->start = k;
        const double size = fabs(self->x1_hat) + fabs(self->x2_hat);
        if (!(size <= 1e150)) {
            self->seen = 0U;
            self->x1_hat = 0.0;
            self->x2_hat = 0.0;
        }
        status = PTC_OK;
    }
    return status;
}

ptc_status stage42_step(stage42 *self, uint32_t k, const double y[1], double *u)
{
    ptc_status status = PTC_E_INPUT;

    if (u != NULL) {
        *u = 0.0;
    }
    if ((self != NULL) && (y != NULL) && (u != NULL)) {
        if (PTC_FINITE_F64(y[0]) && (fabs(y[0]) <= 1.5)) {
            const uint32_t elapsed = k - self->start;

            /* Predict. */
            const double s1 = self->x1_hat + (self->phi1_2 * self->x2_hat);
            const double p1 = s1 + (self->gamma1 * self->u1);
            const double p2 = self->x2_hat + (self->phi1_2 * self->u1);

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
            const uint32_t left_o = (elapsed < (self->samples / 2U)) ? ((self->samples / 2U) - elapsed) : 0U;
            const double o0 = (double)left_o;
            double l1;
            double l2;
            if (o0 > 4.0) {
                const double r0 = 1.0 / (o0 * (o0 - 1.0));
                l1 = (STAGE42_Q1_1 + (STAGE42_Q1_2 * o0)) * r0;
                l2 = self->q2_1 * r0;
            } else if (left_o == 4U) {
                l1 = 1.0;
                l2 = self->e0_2;
            } else {
                l1 = 1.0;
                l2 = self->e1_2;
            }
            const double x1 = base + (l1 * miss);
            const double x2 = p2 + (l2 * miss);
            const uint32_t left = (elapsed < self->samples) ? (self->samples - elapsed) : 0U;
            const double m0 = (double)left;
            double v;
            if (m0 > self->deadbeat) {
                /* The exact law in samples. */
                const double z1 = (self->w1_1 * x1) + (self->w1_2 * x2);
                const double z2 = self->w2_2 * x2;
                v = (z1 + (z2 * m0)) / (m0 * (m0 - 1.0));
            } else {
                /* Deadbeat. */
                v = (self->b_1 * x1) + (self->b_2 * x2);
            }
            status = PTC_E_RANGE;
            if (PTC_FINITE_F64(v)) {
                double u_now;
                if (elapsed < self->samples) {
                    if (v > self->u_max) {
                        u_now = self->u_max;
                    } else if (v < -self->u_max) {
                        u_now = -self->u_max;
                    } else {
                        u_now = v;
                    }
                } else {
                    u_now = 0.0;
                }
                self->u1 = u_now;
                self->x1_hat = x1;
                self->x2_hat = x2;
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

ptc_status stage42_estimate(const stage42 *self, double xhat[2])
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (xhat != NULL)) {
        xhat[0] = self->x1_hat;
        xhat[1] = self->x2_hat;
        status = PTC_OK;
    }
    if ((status < PTC_OK) && (xhat != NULL)) {
        for (uint32_t i = 0U; i < 2U; i++) {
            xhat[i] = 0.0;
        }
    }
    return status;
}
