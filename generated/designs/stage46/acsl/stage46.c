/* Prescribed-time controller stage46: see stage46.h. DO NOT EDIT. */
#include "stage46.h"

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
#define STAGE46_PHI1_2 0.001 /* 1/1000, prediction of x1 from x2 */
#define STAGE46_PHI1_3 5e-7 /* 1/2000000, prediction of x1 from d */
#define STAGE46_GAMMA1 5e-7 /* 1/2000000, prediction from u */
#define STAGE46_PHI2_3 0.001 /* 1/1000, prediction of x2 from d */
#define STAGE46_GAMMA2 0.001 /* 1/1000, prediction from u */
#define STAGE46_W1_1 (-6000000.0) /* weight of x1 in the law */
#define STAGE46_W1_2 (-3000.0) /* weight of x2 in the law */
#define STAGE46_W2_2 (-4000.0) /* weight of x2 in the law */
#define STAGE46_W2_3 (-4.0) /* weight of u1 in the law */
#define STAGE46_U_MAX 6.0 /* bound of |u| */
#define STAGE46_SAMPLES 40U /* samples from the start to rest */

ptc_status stage46_init(stage46 *self, const stage46_params *params)
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

ptc_status stage46_arm(stage46 *self, uint32_t k)
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

ptc_status stage46_step(stage46 *self, uint32_t k, const double y[1], double *u)
{
    ptc_status status = PTC_E_INPUT;

    if (u != NULL) {
        *u = 0.0;
    }
    if ((self != NULL) && (y != NULL) && (u != NULL)) {
        if (PTC_FINITE_F64(y[0])) {
            const uint32_t elapsed = k - self->start;

            /* Predict. */
            const double s1 = self->x1_hat + (STAGE46_PHI1_2 * self->x2_hat);
            const double s2 = s1 + (STAGE46_PHI1_3 * self->d_hat);
            const double p1 = s2 + (STAGE46_GAMMA1 * self->u2);
            const double s3 = self->x2_hat + (STAGE46_PHI2_3 * self->d_hat);
            const double p2 = s3 + (STAGE46_GAMMA2 * self->u2);
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
            const double l1 = 0.6159148679121326;
            const double l2 = 289.1861751977763;
            const double l3 = 67889.77526148109;
            const double x1 = base + (l1 * miss);
            const double x2 = p2 + (l2 * miss);
            const double d = p3 + (l3 * miss);
            double v;

            /* The exact law in samples. */
            const double m0 = (elapsed < 37U) ? ((double)(40U - elapsed)) : 3.0;
            const double z1 = (STAGE46_W1_1 * x1) + (STAGE46_W1_2 * x2);
            const double z2 = (STAGE46_W2_2 * x2) + (STAGE46_W2_3 * (self->u1 + d));
            v = ((z1 + (z2 * m0)) / (m0 * (m0 - 1.0))) - d;
            status = PTC_E_RANGE;
            if (PTC_FINITE_F64(v)) {
                double u_now;
                if (v > STAGE46_U_MAX) {
                    u_now = STAGE46_U_MAX;
                } else if (v < -STAGE46_U_MAX) {
                    u_now = -STAGE46_U_MAX;
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
                if ((v > STAGE46_U_MAX) || (v < -STAGE46_U_MAX)) {
                    status = PTC_SATURATED;
                } else if (elapsed < STAGE46_SAMPLES) {
                    status = PTC_OK;
                } else {
                    status = PTC_HOLD;
                }
            }
        }
    }
    return status;
}

ptc_status stage46_estimate(const stage46 *self, double xhat[2])
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

ptc_status stage46_disturbance(const stage46 *self, double *d)
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (d != NULL)) {
        *d = self->d_hat;
        status = PTC_OK;
    }
    return status;
}
