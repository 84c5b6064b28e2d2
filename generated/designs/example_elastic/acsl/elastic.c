/* Prescribed-time controller elastic: see elastic.h. DO NOT EDIT. */
#include "elastic.h"

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
#define ELASTIC_PHI1_2 0.0005 /* 1/2000, prediction of x1 from x2 */
#define ELASTIC_PHI1_3 3.571428571428571e-8 /* 1/28000000, prediction of x1 from d */
#define ELASTIC_GAMMA1 3.571428571428571e-8 /* 1/28000000, prediction from u */
#define ELASTIC_PHI2_3 0.00014285714285714287 /* 1/7000, prediction of x2 from d */
#define ELASTIC_GAMMA2 0.00014285714285714287 /* 1/7000, prediction from u */
#define ELASTIC_OBSERVER_SAMPLES 200U /* samples of the round of the observer */
#define ELASTIC_Q1_1 210.0 /* weight in the observer's gain l1 */
#define ELASTIC_Q1_2 (-90.0) /* weight in the observer's gain l1 */
#define ELASTIC_Q1_3 15.0 /* weight in the observer's gain l1 */
#define ELASTIC_Q2_1 (-420000.0) /* weight in the observer's gain l2 */
#define ELASTIC_Q2_2 120000.0 /* weight in the observer's gain l2 */
#define ELASTIC_Q3_1 840000000.0 /* weight in the observer's gain l3 */
#define ELASTIC_E0_2 1166.6666666666667 /* 3500/3, gain of the observer at its end */
#define ELASTIC_E0_3 2333333.3333333335 /* 7000000/3, gain of the observer at its end */
#define ELASTIC_E1_2 1875.0 /* gain of the observer at its end */
#define ELASTIC_E1_3 (-1750000.0) /* gain of the observer at its end */
#define ELASTIC_E2_2 3000.0 /* gain of the observer at its end */
#define ELASTIC_E2_3 14000000.0 /* gain of the observer at its end */
#define ELASTIC_SAMPLES 1000U /* samples from the start to rest */
#define ELASTIC_HOLD 193.0 /* samples to go at which the gains are held */
#define ELASTIC_W1_1 (-1260000000.0) /* weight of x1 in the law */
#define ELASTIC_W1_2 315000.0 /* weight of x2 in the law */
#define ELASTIC_W2_2 (-336000.0) /* weight of x2 in the law */
#define ELASTIC_W3_3 (-10.5) /* -21/2, weight of u1 in the law */
#define ELASTIC_U_MAX 100.0 /* bound of |u| */

ptc_status elastic_init(elastic *self, const elastic_params *params)
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
        status = PTC_OK;
    }
    return status;
}

ptc_status elastic_arm(elastic *self, uint32_t k)
{
    ptc_status status = PTC_E_INPUT;

    if (self != NULL) {
        self->start = k;
        const double size = fabs(self->x1_hat) + fabs(self->x2_hat) + fabs(self->d_hat);
        if (!(size <= 1e150)) {
            self->seen = 0U;
            self->x1_hat = 0.0;
            self->x2_hat = 0.0;
            self->d_hat = 0.0;
        }
        status = PTC_OK;
    }
    return status;
}

ptc_status elastic_step(elastic *self, uint32_t k, const double y[1], double *u)
{
    ptc_status status = PTC_E_INPUT;

    if (u != NULL) {
        *u = 0.0;
    }
    if ((self != NULL) && (y != NULL) && (u != NULL)) {
        if (PTC_FINITE_F64(y[0])) {
            const uint32_t elapsed = k - self->start;

            /* Predict. */
            const double s1 = self->x1_hat + (ELASTIC_PHI1_2 * self->x2_hat);
            const double s2 = s1 + (ELASTIC_PHI1_3 * self->d_hat);
            const double p1 = s2 + (ELASTIC_GAMMA1 * self->u2);
            const double s3 = self->x2_hat + (ELASTIC_PHI2_3 * self->d_hat);
            const double p2 = s3 + (ELASTIC_GAMMA2 * self->u2);
            const double p3 = self->d_hat;

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
            const uint32_t left_o = (elapsed < ELASTIC_OBSERVER_SAMPLES) ? (ELASTIC_OBSERVER_SAMPLES - elapsed) : 0U;
            const double o0 = (left_o == 0U) ? 25.0 : (double)left_o;
            double l1;
            double l2;
            double l3;
            if (o0 > 9.0) {
                const double o0f2 = o0 * (o0 - 1.0);
                const double r0 = 1.0 / (o0f2 * (o0 - 2.0));
                l1 = (ELASTIC_Q1_1 + (ELASTIC_Q1_2 * o0) + (ELASTIC_Q1_3 * o0f2)) * r0;
                l2 = (ELASTIC_Q2_1 + (ELASTIC_Q2_2 * o0)) * r0;
                l3 = ELASTIC_Q3_1 * r0;
            } else if (left_o == 9U) {
                l1 = 1.0;
                l2 = ELASTIC_E0_2;
                l3 = ELASTIC_E0_3;
            } else if (left_o == 8U) {
                l1 = 1.0;
                l2 = ELASTIC_E1_2;
                l3 = ELASTIC_E1_3;
            } else {
                l1 = 1.0;
                l2 = ELASTIC_E2_2;
                l3 = ELASTIC_E2_3;
            }
            const double x1 = base + (l1 * miss);
            const double x2 = p2 + (l2 * miss);
            const double d = p3 + (l3 * miss);
            const uint32_t left = (elapsed < ELASTIC_SAMPLES) ? (ELASTIC_SAMPLES - elapsed) : 0U;
            const double m0 = ((double)left < ELASTIC_HOLD) ? ELASTIC_HOLD : (double)left;
            double v;

            /* The exact law in samples. */
            const double z1 = (ELASTIC_W1_1 * x1) + (ELASTIC_W1_2 * x2);
            const double z2 = ELASTIC_W2_2 * x2;
            const double z3 = ELASTIC_W3_3 * (self->u1 + d);
            const double m0f2 = m0 * (m0 - 1.0);
            const double s4 = (z1 + (z2 * m0) + (z3 * m0f2)) / (m0f2 * (m0 - 2.0));
            v = (s4 + (self->u1 + d)) - d;
            status = PTC_E_RANGE;
            if (PTC_FINITE_F64(v)) {
                double u_now;
                if (v > ELASTIC_U_MAX) {
                    u_now = ELASTIC_U_MAX;
                } else if (v < -ELASTIC_U_MAX) {
                    u_now = -ELASTIC_U_MAX;
                } else {
                    u_now = v;
                }
                self->u2 = self->u1;
                self->u1 = u_now;
                self->x1_hat = x1;
                self->x2_hat = x2;
                self->d_hat = d;
                self->seen = 1U;
                *u = u_now;
                if ((v > ELASTIC_U_MAX) || (v < -ELASTIC_U_MAX)) {
                    status = PTC_SATURATED;
                } else if ((double)left <= ELASTIC_HOLD) {
                    status = PTC_HOLD;
                } else {
                    status = PTC_OK;
                }
            }
        }
    }
    return status;
}

ptc_status elastic_estimate(const elastic *self, double xhat[2])
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

ptc_status elastic_disturbance(const elastic *self, double *d)
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (d != NULL)) {
        *d = self->d_hat;
        status = PTC_OK;
    }
    return status;
}
