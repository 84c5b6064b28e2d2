/* Prescribed-time controller stage40: see stage40.h. DO NOT EDIT. */
#include "stage40.h"

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
#define STAGE40_PHI1_2 0.001 /* 1/1000, prediction of x1 from x2 */
#define STAGE40_PHI1_3 5e-7 /* 1/2000000, prediction of x1 from d */
#define STAGE40_GAMMA1 5e-7 /* 1/2000000, prediction from u */
#define STAGE40_PHI2_3 0.001 /* 1/1000, prediction of x2 from d */
#define STAGE40_GAMMA2 0.001 /* 1/1000, prediction from u */
#define STAGE40_OBSERVER_SAMPLES 20U /* samples of the round of the observer */
#define STAGE40_Q1_1 120.0 /* weight in the observer's gain l1 */
#define STAGE40_Q1_2 (-60.0) /* weight in the observer's gain l1 */
#define STAGE40_Q1_3 12.0 /* weight in the observer's gain l1 */
#define STAGE40_Q2_1 (-108000.0) /* weight in the observer's gain l2 */
#define STAGE40_Q2_2 36000.0 /* weight in the observer's gain l2 */
#define STAGE40_Q3_1 24000000.0 /* weight in the observer's gain l3 */
#define STAGE40_E0_2 428.57142857142856 /* 3000/7, gain of the observer at its end */
#define STAGE40_E0_3 142857.14285714287 /* 1000000/7, gain of the observer at its end */
#define STAGE40_E1_2 857.1428571428571 /* 6000/7, gain of the observer at its end */
#define STAGE40_E1_3 (-285714.28571428574) /* -2000000/7, gain of the observer at its end */
#define STAGE40_E2_2 1500.0 /* gain of the observer at its end */
#define STAGE40_E2_3 1000000.0 /* gain of the observer at its end */
#define STAGE40_W1_1 (-120000000.0) /* weight of x1 in the law */
#define STAGE40_W1_2 60000.0 /* weight of x2 in the law */
#define STAGE40_W2_2 (-60000.0) /* weight of x2 in the law */
#define STAGE40_W3_3 (-12.0) /* weight of u1 in the law */
#define STAGE40_U_MAX 6.0 /* bound of |u| */
#define STAGE40_SAMPLES 40U /* samples from the start to rest */

ptc_status stage40_init(stage40 *self, const stage40_params *params)
{
    ptc_status status = PTC_E_PARAM;

    (void)params;
    if (self != NULL) {
        self->start = 0U;
        self->u1 = 0.0;
        self->u2 = 0.0;
        self->seen = 0U;
        self->x1_hat = 0.0;
        self->x2_hat = 0.0;
        self->d_hat = 0.0;
        self->trust = 1U;
        self->rho1 = 0.0;
        status = PTC_OK;
    }
    return status;
}

ptc_status stage40_arm(stage40 *self, uint32_t k)
{
    ptc_status status = PTC_E_INPUT;

    if (self != NULL) {
        self->start = k;
        const double size = fabs(self->x1_hat) + fabs(self->x2_hat) + fabs(self->d_hat);
        if (!((self->trust > 1U) && (size <= 1e150))) {
            self->seen = 0U;
            self->x1_hat = 0.0;
            self->x2_hat = 0.0;
            self->d_hat = 0.0;
        }
        status = PTC_OK;
    }
    return status;
}

ptc_status stage40_step(stage40 *self, uint32_t k, const double y[1], const double r[3], double *u)
{
    ptc_status status = PTC_E_INPUT;

    if (u != NULL) {
        *u = 0.0;
    }
    if ((self != NULL) && (y != NULL) && (r != NULL) && (u != NULL)) {
        if (PTC_FINITE_F64(r[0]) && PTC_FINITE_F64(r[1]) && PTC_FINITE_F64(r[2])) {
            const uint32_t elapsed = k - self->start;

            /* Predict. */
            const double s1 = self->x1_hat + (STAGE40_PHI1_2 * self->x2_hat);
            const double s2 = s1 + (STAGE40_PHI1_3 * self->d_hat);
            const double p1 = s2 + (STAGE40_GAMMA1 * self->u2);
            const double s3 = self->x2_hat + (STAGE40_PHI2_3 * self->d_hat);
            const double p2 = s3 + (STAGE40_GAMMA2 * self->u2);
            const double p3 = self->d_hat;

            /* Correct by what is measured, where it is believed. */
            double base;
            double gap;
            if (self->seen == 0U) {
                base = y[0];
                gap = 0.0;
            } else {
                base = p1;
                gap = y[0] - p1;
            }
            double miss;
            uint32_t trust;
            if (PTC_FINITE_F64(y[0]) && (fabs(y[0]) <= 1.5) && (fabs(gap) <= 0.5)) {
                miss = gap;
                trust = 3U;
            } else {
                miss = 0.0;
                trust = (1U < self->trust) ? (self->trust - 1U) : 0U;
            }
            if (trust > 0U) {
                const uint32_t left_o = (elapsed < STAGE40_OBSERVER_SAMPLES) ? (STAGE40_OBSERVER_SAMPLES - elapsed) : 0U;
                const double o0 = (double)left_o;
                double l1;
                double l2;
                double l3;
                if (o0 > 8.0) {
                    const double o0f2 = o0 * (o0 - 1.0);
                    const double r0 = 1.0 / (o0f2 * (o0 - 2.0));
                    l1 = (STAGE40_Q1_1 + (STAGE40_Q1_2 * o0) + (STAGE40_Q1_3 * o0f2)) * r0;
                    l2 = (STAGE40_Q2_1 + (STAGE40_Q2_2 * o0)) * r0;
                    l3 = STAGE40_Q3_1 * r0;
                } else if (left_o == 8U) {
                    l1 = 1.0;
                    l2 = STAGE40_E0_2;
                    l3 = STAGE40_E0_3;
                } else if (left_o == 7U) {
                    l1 = 1.0;
                    l2 = STAGE40_E1_2;
                    l3 = STAGE40_E1_3;
                } else {
                    l1 = 1.0;
                    l2 = STAGE40_E2_2;
                    l3 = STAGE40_E2_3;
                }
                const double x1 = base + (l1 * miss);
                const double x2 = p2 + (l2 * miss);
                const double d = p3 + (l3 * miss);

                /* The tracking error. */
                const double e1 = x1 - r[0];
                const double e2 = x2 - r[1];
                double v;

                /* The exact law in samples. */
                const double m0 = (elapsed < 37U) ? ((double)(43U - elapsed)) : 6.0;
                const double z1 = (STAGE40_W1_1 * e1) + (STAGE40_W1_2 * e2);
                const double z2 = STAGE40_W2_2 * e2;
                const double z3 = STAGE40_W3_3 * ((self->u1 + d) - self->rho1);
                const double m0f2 = m0 * (m0 - 1.0);
                const double s4 = (z1 + (z2 * m0) + (z3 * m0f2)) / (m0f2 * (m0 - 2.0));
                v = ((s4 + ((self->u1 + d) - self->rho1)) - d) + r[2];
                status = PTC_E_RANGE;
                if (PTC_FINITE_F64(v)) {
                    double u_now;
                    if (v > STAGE40_U_MAX) {
                        u_now = STAGE40_U_MAX;
                    } else if (v < -STAGE40_U_MAX) {
                        u_now = -STAGE40_U_MAX;
                    } else {
                        u_now = v;
                    }
                    self->u2 = self->u1;
                    self->u1 = u_now;
                    self->rho1 = r[2];
                    self->x1_hat = x1;
                    self->x2_hat = x2;
                    self->d_hat = d;
                    self->seen = 1U;
                    self->trust = trust;
                    *u = u_now;
                    if (trust < 3U) {
                        status = PTC_GATED;
                    } else if ((v > STAGE40_U_MAX) || (v < -STAGE40_U_MAX)) {
                        status = PTC_SATURATED;
                    } else if (elapsed < STAGE40_SAMPLES) {
                        status = PTC_OK;
                    } else {
                        status = PTC_HOLD;
                    }
                }
            }
        }
    }
    return status;
}

ptc_status stage40_estimate(const stage40 *self, double xhat[2])
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

ptc_status stage40_disturbance(const stage40 *self, double *d)
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (d != NULL)) {
        *d = self->d_hat;
        status = PTC_OK;
    }
    return status;
}
