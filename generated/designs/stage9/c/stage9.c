/* Prescribed-time controller stage9: see stage9.h. DO NOT EDIT. */
#include "stage9.h"

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
#define STAGE9_Q1_1 120.0 /* weight in the observer's gain l1 */
#define STAGE9_Q1_2 (-60.0) /* weight in the observer's gain l1 */
#define STAGE9_Q1_3 12.0 /* weight in the observer's gain l1 */
#define STAGE9_DEADBEAT 3.5 /* 7/2, samples to go at which deadbeat takes over */
#define STAGE9_B_4 (-3.0) /* weight of u1 in the law */
#define STAGE9_U_MAX 1000.0 /* bound of |u| */

ptc_status stage9_init(stage9 *self, const stage9_params *params)
{
    ptc_status status = PTC_E_PARAM;

    if ((self != NULL) && (params != NULL)) {
        if ((params->samples > 7U)
            && (1e-150 <= params->h)
            && (params->h <= 1e150)
            && PTC_FINITE_F64(params->k[0])
            && PTC_FINITE_F64(params->k[1])
            && PTC_FINITE_F64(params->k[2])
            && PTC_FINITE_F64(params->k[3])
            && PTC_FINITE_F64(params->deadbeat)
            && (params->deadbeat >= 0.0)) {
            const uint32_t samples = params->samples;
            const double phi1_2 = params->h;
            const double phi1_3 = 0.5 * (params->h * params->h);
            const double gamma1 = 0.16666666666666666 * (params->h * params->h * params->h);
            const double hold_o = 0.05 / params->h;
            const double q2_1 = (-108.0) * (1.0 / params->h);
            const double q2_2 = 36.0 * (1.0 / params->h);
            const double q3_1 = 24.0 * (1.0 / (params->h * params->h));
            const double hold = 0.02 / params->h;
            const double w1_1 = (-params->k[0]) * (1.0 / (params->h * params->h * params->h));
            const double w1_2 = params->k[0] * (1.0 / (params->h * params->h));
            const double w1_3 = 0.3333333333333333 * (-params->k[0]) * (1.0 / params->h);
            const double s1 = ((1.0 - params->k[1]) + params->k[2]) - params->k[3];
            const double w2_2 = s1 * (1.0 / (params->h * params->h));
            const double s2 = (-0.5) * (((1.0 - params->k[1]) + params->k[2]) - params->k[3]);
            const double w2_3 = s2 * (1.0 / params->h);
            const double w3_3 = (((-7.0) - params->k[2]) + (3.0 * params->k[3])) * (1.0 / params->h);
            const double w4_4 = 6.0 - params->k[3];
            const double b_1 = -(1.0 / (params->h * params->h * params->h));
            const double b_2 = (-3.0) * (1.0 / (params->h * params->h));
            const double b_3 = (-4.333333333333333) * (1.0 / params->h);
            if (PTC_FINITE_F64(phi1_3)
                && PTC_FINITE_F64(gamma1)
                && PTC_FINITE_F64(hold_o)
                && PTC_FINITE_F64(q2_1)
                && PTC_FINITE_F64(q2_2)
                && PTC_FINITE_F64(q3_1)
                && PTC_FINITE_F64(hold)
                && PTC_FINITE_F64(w1_1)
                && PTC_FINITE_F64(w1_2)
                && PTC_FINITE_F64(w1_3)
                && PTC_FINITE_F64(w2_2)
                && PTC_FINITE_F64(w2_3)
                && PTC_FINITE_F64(w3_3)
                && PTC_FINITE_F64(w4_4)
                && PTC_FINITE_F64(b_1)
                && PTC_FINITE_F64(b_2)
                && PTC_FINITE_F64(b_3)
                && (params->h * params->h * params->h >= 1e-200)
                && (1.0 / (params->h * params->h * params->h) >= 1e-200)
                && (hold_o >= 3.0)) {
                self->start = 0U;
                self->samples = samples;
                self->u1 = 0.0;
                self->u2 = 0.0;
                self->seen = 0U;
                self->x1_hat = 0.0;
                self->x2_hat = 0.0;
                self->x3_hat = 0.0;
                self->phi1_2 = phi1_2;
                self->phi1_3 = phi1_3;
                self->gamma1 = gamma1;
                self->hold_o = hold_o;
                self->q2_1 = q2_1;
                self->q2_2 = q2_2;
                self->q3_1 = q3_1;
                self->hold = hold;
                self->w1_1 = w1_1;
                self->w1_2 = w1_2;
                self->w1_3 = w1_3;
                self->w2_2 = w2_2;
                self->w2_3 = w2_3;
                self->w3_3 = w3_3;
                self->w4_4 = w4_4;
                self->b_1 = b_1;
                self->b_2 = b_2;
                self->b_3 = b_3;
                status = PTC_OK;
            }
        }
    }
    return status;
}

ptc_status stage9_arm(stage9 *self, uint32_t k)
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

ptc_status stage9_step(stage9 *self, uint32_t k, const double y[1], double *u)
{
    ptc_status status = PTC_E_INPUT;

    if (u != NULL) {
        *u = 0.0;
    }
    if ((self != NULL) && (y != NULL) && (u != NULL)) {
        if (PTC_FINITE_F64(y[0])) {
            const uint32_t elapsed = k - self->start;

            /* Predict. */
            const double s1 = self->x1_hat + (self->phi1_2 * self->x2_hat);
            const double p1 = s1 + (self->phi1_3 * self->x3_hat) + (self->gamma1 * self->u2);
            const double s2 = self->x2_hat + (self->phi1_2 * self->x3_hat);
            const double p2 = s2 + (self->phi1_3 * self->u2);
            const double p3 = self->x3_hat + (self->phi1_2 * self->u2);

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
            const double o0 = ((double)left_o < self->hold_o) ? self->hold_o : (double)left_o;
            double l1;
            double l2;
            double l3;
            const double o0f2 = o0 * (o0 - 1.0);
            const double r0 = 1.0 / (o0f2 * (o0 - 2.0));
            l1 = (STAGE9_Q1_1 + (STAGE9_Q1_2 * o0) + (STAGE9_Q1_3 * o0f2)) * r0;
            l2 = (self->q2_1 + (self->q2_2 * o0)) * r0;
            l3 = self->q3_1 * r0;
            const double x1 = base + (l1 * miss);
            const double x2 = p2 + (l2 * miss);
            const double x3 = p3 + (l3 * miss);
            const uint32_t left = (elapsed < self->samples) ? (self->samples - elapsed) : 0U;
            const double m0 = ((double)left < self->hold) ? self->hold : (double)left;
            double v;
            if (m0 > STAGE9_DEADBEAT) {
                /* The exact law in samples. */
                const double z1 = (self->w1_1 * x1) + (self->w1_2 * x2) + (self->w1_3 * x3);
                const double z2 = (self->w2_2 * x2) + (self->w2_3 * x3);
                const double z3 = self->w3_3 * x3;
                const double z4 = self->w4_4 * self->u1;
                const double m0f2 = m0 * (m0 - 1.0);
                const double m0f3 = m0f2 * (m0 - 2.0);
                const double s3 = (z1 + (z2 * m0) + (z3 * m0f2) + (z4 * m0f3)) / (m0f3 * (m0 - 3.0));
                v = s3 + self->u1;
            } else {
                /* Deadbeat. */
                const double s4 = (self->b_1 * x1) + (self->b_2 * x2) + (self->b_3 * x3);
                v = s4 + (STAGE9_B_4 * self->u1);
            }
            status = PTC_E_RANGE;
            if (PTC_FINITE_F64(v)) {
                double u_now;
                if (v > STAGE9_U_MAX) {
                    u_now = STAGE9_U_MAX;
                } else if (v < -STAGE9_U_MAX) {
                    u_now = -STAGE9_U_MAX;
                } else {
                    u_now = v;
                }
                self->u2 = self->u1;
                self->u1 = u_now;
                self->x1_hat = x1;
                self->x2_hat = x2;
                self->x3_hat = x3;
                self->seen = 1U;
                *u = u_now;
                if ((v > STAGE9_U_MAX) || (v < -STAGE9_U_MAX)) {
                    status = PTC_SATURATED;
                } else if ((double)left <= self->hold) {
                    status = PTC_HOLD;
                } else {
                    status = PTC_OK;
                }
            }
        }
    }
    return status;
}

ptc_status stage9_estimate(const stage9 *self, double xhat[3])
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
