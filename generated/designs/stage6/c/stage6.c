/* Prescribed-time controller stage6: see stage6.h. DO NOT EDIT. */
#include "stage6.h"

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
#define STAGE6_PHI1_2 0.002 /* 1/500, prediction of x2 from x3 */
#define STAGE6_GAMMA1 4e-6 /* 1/250000, prediction from u */
#define STAGE6_GAMMA2 0.004 /* 1/250, prediction from u */
#define STAGE6_Q1_1 (-43.265306122448976) /* -2120/49, weight in the observer's gain l1 */
#define STAGE6_Q1_2 12.285714285714286 /* 86/7, weight in the observer's gain l1 */
#define STAGE6_Q2_1 15489.795918367347 /* 759000/49, weight in the observer's gain l2 */
#define STAGE6_E0_2 182.53968253968253 /* 11500/63, gain of the observer at its end */
#define STAGE6_E1_2 500.0 /* gain of the observer at its end */
#define STAGE6_B_1 (-62500000.0) /* weight of x1 in the law */
#define STAGE6_B_2 (-250000.0) /* weight of x2 in the law */
#define STAGE6_B_3 (-458.3333333333333) /* -1375/3, weight of x3 in the law */

ptc_status stage6_init(stage6 *self, const stage6_params *params)
{
    ptc_status status = PTC_E_PARAM;

    if ((self != NULL) && (params != NULL)) {
        if ((params->samples > 5U)
            && (params->u_max > 0.0)
            && PTC_FINITE_F64(params->k[0])
            && PTC_FINITE_F64(params->k[1])
            && PTC_FINITE_F64(params->k[2])
            && PTC_FINITE_F64(params->deadbeat)
            && (params->deadbeat >= 0.0)) {
            const uint32_t samples = params->samples;
            const double s1 = ((params->k[2] / 0.7) - 4.0) + 3.0;
            const double s2 = (s1 < 6.0) ? 6.0 : s1;
            const double deadbeat = (params->deadbeat > 0.0) ? params->deadbeat : s2;
            const double w1_1 = 125000000.0 * (0.5 * (-(params->k[0] / 0.343)));
            const double w1_2 = 250000.0 * ((-0.5) * (-(params->k[0] / 0.343)));
            const double w1_3 = 500.0 * (0.16666666666666666 * (-(params->k[0] / 0.343)));
            const double s3 = 0.5 * (((-1.0) - (params->k[1] / 0.49)) + (params->k[2] / 0.7));
            const double w2_2 = 250000.0 * s3;
            const double s4 = (-0.25) * (((-1.0) - (params->k[1] / 0.49)) + (params->k[2] / 0.7));
            const double w2_3 = 500.0 * s4;
            const double w3_3 = 500.0 * (0.5 * (3.0 - (params->k[2] / 0.7)));
            const double u_max = params->u_max;
            if (PTC_FINITE_F64(deadbeat)
                && PTC_FINITE_F64(w1_1)
                && PTC_FINITE_F64(w1_2)
                && PTC_FINITE_F64(w1_3)
                && PTC_FINITE_F64(w2_2)
                && PTC_FINITE_F64(w2_3)
                && PTC_FINITE_F64(w3_3)) {
                self->start = 0U;
                self->samples = samples;
                self->u1 = 0.0;
                self->seen = 0U;
                self->x2_hat = 0.0;
                self->x3_hat = 0.0;
                self->deadbeat = deadbeat;
                self->w1_1 = w1_1;
                self->w1_2 = w1_2;
                self->w1_3 = w1_3;
                self->w2_2 = w2_2;
                self->w2_3 = w2_3;
                self->w3_3 = w3_3;
                self->u_max = u_max;
                status = PTC_OK;
            }
        }
    }
    return status;
}

ptc_status stage6_arm(stage6 *self, uint32_t k)
{
    ptc_status status = PTC_E_INPUT;

    if (self != NULL) {
        self->start = k;
        const double size = fabs(self->x2_hat) + fabs(self->x3_hat);
        if (!(size <= 1e150)) {
            self->seen = 0U;
            self->x2_hat = 0.0;
            self->x3_hat = 0.0;
        }
        status = PTC_OK;
    }
    return status;
}

ptc_status stage6_step(stage6 *self, uint32_t k, const double y[2], double *u)
{
    ptc_status status = PTC_E_INPUT;

    if (u != NULL) {
        *u = 0.0;
    }
    if ((self != NULL) && (y != NULL) && (u != NULL)) {
        if (PTC_FINITE_F64(y[0]) && PTC_FINITE_F64(y[1])) {
            const uint32_t elapsed = k - self->start;

            /* Predict. */
            const double s1 = self->x2_hat + (STAGE6_PHI1_2 * self->x3_hat);
            const double p1 = s1 + (STAGE6_GAMMA1 * (self->u1 + 0.25));
            const double p2 = self->x3_hat + (STAGE6_GAMMA2 * (self->u1 + 0.25));

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
            const uint32_t left_o = (elapsed < (self->samples / 2U)) ? ((self->samples / 2U) - elapsed) : 0U;
            const double o0 = (double)left_o;
            double l1;
            double l2;
            if (o0 > 9.0) {
                const double r0 = 1.0 / (o0 * (o0 - 1.0));
                l1 = (STAGE6_Q1_1 + (STAGE6_Q1_2 * o0)) * r0;
                l2 = STAGE6_Q2_1 * r0;
            } else if (left_o == 9U) {
                l1 = 1.0;
                l2 = STAGE6_E0_2;
            } else {
                l1 = 1.0;
                l2 = STAGE6_E1_2;
            }
            const double x1 = y[0];
            const double x2 = base + (l1 * miss);
            const double x3 = p2 + (l2 * miss);
            const uint32_t left = (elapsed < self->samples) ? (self->samples - elapsed) : 0U;
            const double m0 = (double)left;
            double v;
            if (m0 > self->deadbeat) {
                /* The exact law in samples. */
                const double z1 = (self->w1_1 * x1) + (self->w1_2 * x2) + (self->w1_3 * x3);
                const double z2 = (self->w2_2 * x2) + (self->w2_3 * x3);
                const double z3 = self->w3_3 * x3;
                const double m0f2 = m0 * (m0 - 1.0);
                v = ((z1 + (z2 * m0) + (z3 * m0f2)) / (m0f2 * (m0 - 2.0))) - 0.25;
            } else {
                /* Deadbeat. */
                const double s2 = (STAGE6_B_1 * x1) + (STAGE6_B_2 * x2) + (STAGE6_B_3 * x3);
                v = s2 - 0.25;
            }
            status = PTC_E_RANGE;
            if (PTC_FINITE_F64(v)) {
                double u_now;
                if (v > self->u_max) {
                    u_now = self->u_max;
                } else if (v < -self->u_max) {
                    u_now = -self->u_max;
                } else {
                    u_now = v;
                }
                self->u1 = u_now;
                self->x2_hat = x2;
                self->x3_hat = x3;
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
        }
    }
    return status;
}

ptc_status stage6_estimate(const stage6 *self, double xhat[2])
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
