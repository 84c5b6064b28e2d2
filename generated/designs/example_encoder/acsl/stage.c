/* Prescribed-time controller stage: see stage.h. DO NOT EDIT. */
#include "stage.h"

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
#define STAGE_PHI1_2 0.001 /* 1/1000, prediction of x1 from x2 */
#define STAGE_PHI1_3 3.3333333333333335e-7 /* 1/3000000, prediction of x1 from d */
#define STAGE_GAMMA1 3.3333333333333335e-7 /* 1/3000000, prediction from u */
#define STAGE_PHI2_3 0.0006666666666666666 /* 1/1500, prediction of x2 from d */
#define STAGE_GAMMA2 0.0006666666666666666 /* 1/1500, prediction from u */
#define STAGE_OBSERVER_SAMPLES 200U /* samples of the round of the observer */
#define STAGE_HOLD_O 30.0 /* samples to go at which the observer is held */
#define STAGE_Q1_1 120.0 /* weight in the observer's gain l1 */
#define STAGE_Q1_2 (-60.0) /* weight in the observer's gain l1 */
#define STAGE_Q1_3 12.0 /* weight in the observer's gain l1 */
#define STAGE_Q2_1 (-108000.0) /* weight in the observer's gain l2 */
#define STAGE_Q2_2 36000.0 /* weight in the observer's gain l2 */
#define STAGE_Q3_1 36000000.0 /* weight in the observer's gain l3 */
#define STAGE_SAMPLES 800U /* samples from the start to rest */
#define STAGE_HOLD 20.0 /* samples to go at which the gains are held */
#define STAGE_END_SAMPLES 250.0 /* samples to go at which the law of the end takes over */
#define STAGE_W1_1 (-9000000.0) /* weight of x1 in the law */
#define STAGE_W1_2 (-4500.0) /* weight of x2 in the law */
#define STAGE_W2_2 (-6000.0) /* weight of x2 in the law */
#define STAGE_W2_3 (-4.0) /* weight of u1 in the law */
#define STAGE_END1_1 (-18000000.0) /* weight of x1 in the law */
#define STAGE_END1_2 (-9000.0) /* weight of x2 in the law */
#define STAGE_END2_2 (-9000.0) /* weight of x2 in the law */
#define STAGE_END2_3 (-6.0) /* weight of u1 in the law */
#define STAGE_U_MAX 6.0 /* bound of |u| */

ptc_status stage_init(stage *self, const stage_params *params)
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

ptc_status stage_arm(stage *self, uint32_t k)
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

ptc_status stage_step(stage *self, uint32_t k, const double y[1], double *u)
{
    ptc_status status = PTC_E_INPUT;

    if (u != NULL) {
        *u = 0.0;
    }
    if ((self != NULL) && (y != NULL) && (u != NULL)) {
        if (PTC_FINITE_F64(y[0])) {
            const uint32_t elapsed = k - self->start;

            /* Predict. */
            const double s1 = self->x1_hat + (STAGE_PHI1_2 * self->x2_hat);
            const double s2 = s1 + (STAGE_PHI1_3 * self->d_hat);
            const double p1 = s2 + (STAGE_GAMMA1 * self->u2);
            const double s3 = self->x2_hat + (STAGE_PHI2_3 * self->d_hat);
            const double p2 = s3 + (STAGE_GAMMA2 * self->u2);
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
            const uint32_t left_o = (elapsed < STAGE_OBSERVER_SAMPLES) ? (STAGE_OBSERVER_SAMPLES - elapsed) : 0U;
            const double o0 = ((double)left_o < STAGE_HOLD_O) ? STAGE_HOLD_O : (double)left_o;
            double l1;
            double l2;
            double l3;
            const double o0f2 = o0 * (o0 - 1.0);
            const double r0 = 1.0 / (o0f2 * (o0 - 2.0));
            l1 = (STAGE_Q1_1 + (STAGE_Q1_2 * o0) + (STAGE_Q1_3 * o0f2)) * r0;
            l2 = (STAGE_Q2_1 + (STAGE_Q2_2 * o0)) * r0;
            l3 = STAGE_Q3_1 * r0;
            const double x1 = base + (l1 * miss);
            const double x2 = p2 + (l2 * miss);
            const double d = p3 + (l3 * miss);
            const uint32_t left = (elapsed < STAGE_SAMPLES) ? (STAGE_SAMPLES - elapsed) : 0U;
            const double s4 = ((double)left) - 1.0;
            const double m0 = (s4 < STAGE_HOLD) ? STAGE_HOLD : s4;
            double v;
            if (m0 > STAGE_END_SAMPLES) {
                /* The exact law in samples. */
                const double z1 = (STAGE_W1_1 * x1) + (STAGE_W1_2 * x2);
                const double z2 = (STAGE_W2_2 * x2) + (STAGE_W2_3 * (self->u1 + d));
                const double m0f1 = m0 + 1.0;
                v = ((z1 + (z2 * m0f1)) / (m0f1 * m0)) - d;
            } else {
                /* The law of least energy to the end. */
                const double m1 = (m0 < 2.0) ? 2.0 : m0;
                const double y1 = (STAGE_END1_1 * x1) + (STAGE_END1_2 * x2);
                const double y2 = (STAGE_END2_2 * x2) + (STAGE_END2_3 * (self->u1 + d));
                const double m1f1 = m1 + 2.0;
                v = ((y1 + (y2 * m1f1)) / (m1f1 * (m1 + 1.0))) - d;
            }
            status = PTC_E_RANGE;
            if (PTC_FINITE_F64(v)) {
                double u_now;
                if (v > STAGE_U_MAX) {
                    u_now = STAGE_U_MAX;
                } else if (v < -STAGE_U_MAX) {
                    u_now = -STAGE_U_MAX;
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
                if ((v > STAGE_U_MAX) || (v < -STAGE_U_MAX)) {
                    status = PTC_SATURATED;
                } else if (((double)left) - 1.0 <= STAGE_HOLD) {
                    status = PTC_HOLD;
                } else {
                    status = PTC_OK;
                }
            }
        }
    }
    return status;
}

ptc_status stage_estimate(const stage *self, double xhat[2])
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

ptc_status stage_disturbance(const stage *self, double *d)
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (d != NULL)) {
        *d = self->d_hat;
        status = PTC_OK;
    }
    return status;
}
