/* Prescribed-time controller stage43: see stage43.h. DO NOT EDIT. */
#include "stage43.h"

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
#define STAGE43_PHI1_2 0.01 /* 1/100, prediction of x1 from x2 */
#define STAGE43_PHI1_3 5e-5 /* 1/20000, prediction of x1 from x3 */
#define STAGE43_GAMMA1 1.640625e-7 /* 21/128000000, prediction from u */
#define STAGE43_LATE_GAMMA1 2.604166666666667e-9 /* 1/384000000, prediction from u */
#define STAGE43_PHI1_4 1.6666666666666668e-7 /* 1/6000000, prediction of x1 from d */
#define STAGE43_PHI2_3 0.01 /* 1/100, prediction of x2 from x3 */
#define STAGE43_GAMMA2 4.6875e-5 /* 3/64000, prediction from u */
#define STAGE43_LATE_GAMMA2 3.125e-6 /* 1/320000, prediction from u */
#define STAGE43_PHI2_4 5e-5 /* 1/20000, prediction of x2 from d */
#define STAGE43_GAMMA3 0.0075 /* 3/400, prediction from u */
#define STAGE43_LATE_GAMMA3 0.0025 /* 1/400, prediction from u */
#define STAGE43_PHI3_4 0.01 /* 1/100, prediction of x3 from d */
#define STAGE43_OBSERVER_SAMPLES 20U /* samples of the round of the observer */
#define STAGE43_Q1_1 (-840.0) /* weight in the observer's gain l1 */
#define STAGE43_Q1_2 480.0 /* weight in the observer's gain l1 */
#define STAGE43_Q1_3 (-120.0) /* weight in the observer's gain l1 */
#define STAGE43_Q1_4 16.0 /* weight in the observer's gain l1 */
#define STAGE43_Q2_1 90800.0 /* weight in the observer's gain l2 */
#define STAGE43_Q2_2 (-43200.0) /* weight in the observer's gain l2 */
#define STAGE43_Q2_3 7200.0 /* weight in the observer's gain l2 */
#define STAGE43_Q3_1 (-3360000.0) /* weight in the observer's gain l3 */
#define STAGE43_Q3_2 960000.0 /* weight in the observer's gain l3 */
#define STAGE43_Q4_1 24000000.0 /* weight in the observer's gain l4 */
#define STAGE43_E0_2 47.77777777777778 /* 430/9, gain of the observer at its end */
#define STAGE43_E0_3 2666.6666666666665 /* 8000/3, gain of the observer at its end */
#define STAGE43_E0_4 (-66666.66666666667) /* -200000/3, gain of the observer at its end */
#define STAGE43_E1_2 81.48148148148148 /* 2200/27, gain of the observer at its end */
#define STAGE43_E1_3 (-2222.222222222222) /* -20000/9, gain of the observer at its end */
#define STAGE43_E1_4 444444.44444444444 /* 4000000/9, gain of the observer at its end */
#define STAGE43_E2_2 116.66666666666667 /* 350/3, gain of the observer at its end */
#define STAGE43_E2_4 (-1000000.0) /* gain of the observer at its end */
#define STAGE43_E3_2 183.33333333333334 /* 550/3, gain of the observer at its end */
#define STAGE43_E3_3 20000.0 /* gain of the observer at its end */
#define STAGE43_E3_4 1000000.0 /* gain of the observer at its end */
#define STAGE43_H 0.01 /* 1/100, sample period */
#define STAGE43_W1_1 (-120000000.0) /* weight of x1 in the law */
#define STAGE43_W1_2 (-2100000.0) /* weight of x2 in the law */
#define STAGE43_W1_3 (-16375.0) /* weight of x3 in the law */
#define STAGE43_W1_6 (-72.1875) /* -1155/16, weight of u3 in the law */
#define STAGE43_W2_2 (-600000.0) /* weight of x2 in the law */
#define STAGE43_W2_3 (-13500.0) /* weight of x3 in the law */
#define STAGE43_W2_5 (-60.0) /* weight of u2 in the law */
#define STAGE43_W2_6 (-84.375) /* -675/8, weight of u3 in the law */
#define STAGE43_W3_3 (-1200.0) /* weight of x3 in the law */
#define STAGE43_W3_4 (-12.0) /* weight of u1 in the law */
#define STAGE43_W3_5 (-12.0) /* weight of u2 in the law */
#define STAGE43_W3_6 (-9.0) /* weight of u3 in the law */
#define STAGE43_U_MAX 6.0 /* bound of |u| */
#define STAGE43_SAMPLES 40U /* samples from the start to rest */

ptc_status stage43_init(stage43 *self, const stage43_params *params)
{
    ptc_status status = PTC_E_PARAM;

    (void)params;
    if (self != NULL) {
        self->start = 0U;
        self->u1 = 0.0;
        self->u2 = 0.0;
        self->u3 = 0.0;
        self->u4 = 0.0;
        self->seen = 0U;
        self->x1_hat = 0.0;
        self->x2_hat = 0.0;
        self->x3_hat = 0.0;
        self->d_hat = 0.0;
        status = PTC_OK;
    }
    return status;
}

ptc_status stage43_arm(stage43 *self, uint32_t k)
{
    ptc_status status = PTC_E_INPUT;

    if (self != NULL) {
        self->start = k;
        const double s1 = fabs(self->x1_hat) + fabs(self->x2_hat) + fabs(self->x3_hat);
        const double size = s1 + fabs(self->d_hat);
        if (!(size <= 1e150)) {
            self->seen = 0U;
            self->x1_hat = 0.0;
            self->x2_hat = 0.0;
            self->x3_hat = 0.0;
            self->d_hat = 0.0;
        }
        status = PTC_OK;
    }
    return status;
}

ptc_status stage43_step(stage43 *self, uint32_t k, const double y[1], double *u)
{
    ptc_status status = PTC_E_INPUT;

    if (u != NULL) {
        *u = 0.0;
    }
    if ((self != NULL) && (y != NULL) && (u != NULL)) {
        if (PTC_FINITE_F64(y[0])) {
            const uint32_t elapsed = k - self->start;

            /* Predict. */
            const double s1 = self->x1_hat + (STAGE43_PHI1_2 * self->x2_hat);
            const double s2 = s1 + (STAGE43_PHI1_3 * self->x3_hat);
            const double s3 = (STAGE43_GAMMA1 * self->u4) + (STAGE43_LATE_GAMMA1 * self->u3);
            const double p1 = s2 + (STAGE43_PHI1_4 * self->d_hat) + s3;
            const double s4 = self->x2_hat + (STAGE43_PHI2_3 * self->x3_hat);
            const double s5 = (STAGE43_GAMMA2 * self->u4) + (STAGE43_LATE_GAMMA2 * self->u3);
            const double p2 = s4 + (STAGE43_PHI2_4 * self->d_hat) + s5;
            const double s6 = (STAGE43_GAMMA3 * self->u4) + (STAGE43_LATE_GAMMA3 * self->u3);
            const double p3 = self->x3_hat + (STAGE43_PHI3_4 * self->d_hat) + s6;
            const double p4 = self->d_hat;

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
            const uint32_t left_o = (elapsed < STAGE43_OBSERVER_SAMPLES) ? (STAGE43_OBSERVER_SAMPLES - elapsed) : 0U;
            const double o0 = (double)left_o;
            double l1;
            double l2;
            double l3;
            double l4;
            if (o0 > 10.0) {
                const double o0f2 = o0 * (o0 - 1.0);
                const double o0f3 = o0f2 * (o0 - 2.0);
                const double r0 = 1.0 / (o0f3 * (o0 - 3.0));
                const double s7 = STAGE43_Q1_1 + (STAGE43_Q1_2 * o0) + (STAGE43_Q1_3 * o0f2);
                l1 = (s7 + (STAGE43_Q1_4 * o0f3)) * r0;
                l2 = (STAGE43_Q2_1 + (STAGE43_Q2_2 * o0) + (STAGE43_Q2_3 * o0f2)) * r0;
                l3 = (STAGE43_Q3_1 + (STAGE43_Q3_2 * o0)) * r0;
                l4 = STAGE43_Q4_1 * r0;
            } else if (left_o == 10U) {
                l1 = 1.0;
                l2 = STAGE43_E0_2;
                l3 = STAGE43_E0_3;
                l4 = STAGE43_E0_4;
            } else if (left_o == 9U) {
                l1 = 1.0;
                l2 = STAGE43_E1_2;
                l3 = STAGE43_E1_3;
                l4 = STAGE43_E1_4;
            } else if (left_o == 8U) {
                l1 = 1.0;
                l2 = STAGE43_E2_2;
                l3 = 0.0;
                l4 = STAGE43_E2_4;
            } else {
                l1 = 1.0;
                l2 = STAGE43_E3_2;
                l3 = STAGE43_E3_3;
                l4 = STAGE43_E3_4;
            }
            const double x1 = base + (l1 * miss);
            const double x2 = p2 + (l2 * miss);
            const double x3 = p3 + (l3 * miss);
            const double d = p4 + (l4 * miss);

            /* The tracking error. */
            const double t = ((double)elapsed) * STAGE43_H;
            const double reference1 = t;
            const double reference0 = reference1 * reference1 * 0.5;
            const double e1 = x1 - reference0;
            const double e2 = x2 - reference1;
            const double e3 = x3 - 1.0;
            double v;

            /* The exact law in samples. */
            const double m0 = (elapsed < 34U) ? ((double)(40U - elapsed)) : 6.0;
            const double s8 = (STAGE43_W1_1 * e1) + (STAGE43_W1_2 * e2) + (STAGE43_W1_3 * e3);
            const double z1 = s8 + (STAGE43_W1_6 * (self->u3 + d));
            const double s9 = (STAGE43_W2_2 * e2) + (STAGE43_W2_3 * e3);
            const double s10 = s9 + (STAGE43_W2_5 * (self->u2 + d));
            const double z2 = s10 + (STAGE43_W2_6 * (self->u3 + d));
            const double s11 = (STAGE43_W3_3 * e3) + (STAGE43_W3_4 * (self->u1 + d));
            const double s12 = s11 + (STAGE43_W3_5 * (self->u2 + d));
            const double z3 = s12 + (STAGE43_W3_6 * (self->u3 + d));
            const double m0f2 = m0 * (m0 - 1.0);
            v = ((z1 + (z2 * m0) + (z3 * m0f2)) / (m0f2 * (m0 - 2.0))) - d;
            status = PTC_E_RANGE;
            if (PTC_FINITE_F64(v)) {
                double u_now;
                if (v > STAGE43_U_MAX) {
                    u_now = STAGE43_U_MAX;
                } else if (v < -STAGE43_U_MAX) {
                    u_now = -STAGE43_U_MAX;
                } else {
                    u_now = v;
                }
                self->u4 = self->u3;
                self->u3 = self->u2;
                self->u2 = self->u1;
                self->u1 = u_now;
                self->x1_hat = x1;
                self->x2_hat = x2;
                self->x3_hat = x3;
                self->d_hat = d;
                self->seen = 1U;
                *u = u_now;
                if ((v > STAGE43_U_MAX) || (v < -STAGE43_U_MAX)) {
                    status = PTC_SATURATED;
                } else if (elapsed < STAGE43_SAMPLES) {
                    status = PTC_OK;
                } else {
                    status = PTC_HOLD;
                }
            }
        }
    }
    return status;
}

ptc_status stage43_estimate(const stage43 *self, double xhat[3])
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

ptc_status stage43_disturbance(const stage43 *self, double *d)
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (d != NULL)) {
        *d = self->d_hat;
        status = PTC_OK;
    }
    return status;
}
