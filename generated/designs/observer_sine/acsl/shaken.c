/* Prescribed-time controller shaken: see shaken.h. DO NOT EDIT. */
#include "shaken.h"

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
#define SHAKEN_PHI1_2 0.001 /* 1/1000, prediction of x1 from x2 */
#define SHAKEN_PHI1_3 9.997000359976858e-7 /* prediction of x1 from d */
#define SHAKEN_GAMMA1 9.375e-7 /* 3/3200000, prediction from u */
#define SHAKEN_LATE_GAMMA1 6.25e-8 /* 1/16000000, prediction from u */
#define SHAKEN_PHI1_4 3.3327333847593334e-10 /* prediction of x1 from d_rate */
#define SHAKEN_PHI2_3 0.001998800215981487 /* prediction of x2 from d */
#define SHAKEN_GAMMA2 0.0015 /* 3/2000, prediction from u */
#define SHAKEN_LATE_GAMMA2 0.0005 /* 1/2000, prediction from u */
#define SHAKEN_PHI2_4 9.997000359976858e-7 /* prediction of x2 from d_rate */
#define SHAKEN_PHI3_4 0.0009994001079907434 /* prediction of d from d_rate */
#define SHAKEN_PHI3_3 0.9982005399352042 /* prediction of d from d */
#define SHAKEN_PHI4_4 0.9982005399352042 /* prediction of d_rate from d_rate */
#define SHAKEN_PHI4_3 (-3.597840388766676) /* prediction of d_rate from d */
#define SHAKEN_OBSERVER_SAMPLES 200U /* samples of the round of the observer */
#define SHAKEN_HOLD_O 30.0 /* samples to go at which the observer is held */
#define SHAKEN_Q1_1 (-840.0) /* weight in the observer's gain l1 */
#define SHAKEN_Q1_2 480.0 /* weight in the observer's gain l1 */
#define SHAKEN_Q1_3 (-120.0) /* weight in the observer's gain l1 */
#define SHAKEN_Q1_4 16.0 /* weight in the observer's gain l1 */
#define SHAKEN_Q2_1 907032.0947896534 /* weight in the observer's gain l2 */
#define SHAKEN_Q2_2 (-431395.04961199313) /* weight in the observer's gain l2 */
#define SHAKEN_Q2_3 71827.15332755336 /* weight in the observer's gain l2 */
#define SHAKEN_Q2_4 28.808643111533488 /* weight in the observer's gain l2 */
#define SHAKEN_Q3_1 (-166538409.07329616) /* weight in the observer's gain l3 */
#define SHAKEN_Q3_2 47150402.59237033 /* weight in the observer's gain l3 */
#define SHAKEN_Q3_3 216000.0 /* weight in the observer's gain l3 */
#define SHAKEN_Q3_4 (-28800.0) /* weight in the observer's gain l3 */
#define SHAKEN_Q4_1 10370942877.471207 /* weight in the observer's gain l4 */
#define SHAKEN_Q4_2 776511089.3015876 /* weight in the observer's gain l4 */
#define SHAKEN_Q4_3 (-129288875.98959604) /* weight in the observer's gain l4 */
#define SHAKEN_Q4_4 (-51855.55760076028) /* weight in the observer's gain l4 */
#define SHAKEN_D0_D 0.990752702693308 /* weight of d in d0 */
#define SHAKEN_D0_D_RATE 0.002242835389486039 /* weight of d_rate in d0 */
#define SHAKEN_D1_D 0.9970392465203709 /* weight of d in d1 */
#define SHAKEN_D1_D_RATE 0.0012486411387069352 /* weight of d_rate in d1 */
#define SHAKEN_D2_D 0.9996625341702274 /* weight of d in d2 */
#define SHAKEN_D2_D_RATE 0.0003749367230213299 /* weight of d_rate in d2 */
#define SHAKEN_SAMPLES 600U /* samples from the start to rest */
#define SHAKEN_HOLD 10.0 /* samples to go at which the gains are held */
#define SHAKEN_W1_1 (-6000000.0) /* weight of x1 in the law */
#define SHAKEN_W1_2 (-7500.0) /* weight of x2 in the law */
#define SHAKEN_W1_4 (-7.875) /* -63/8, weight of u2 in the law */
#define SHAKEN_W2_2 (-3000.0) /* weight of x2 in the law */
#define SHAKEN_W2_3 (-6.0) /* weight of u1 in the law */
#define SHAKEN_W2_4 (-4.5) /* -9/2, weight of u2 in the law */
#define SHAKEN_U_MAX 8.0 /* bound of |u| */

ptc_status shaken_init(shaken *self, const shaken_params *params)
{
    ptc_status status = PTC_E_PARAM;

    (void)params;
    if (self != NULL) {
        self->start = 0U;
        self->u1 = 0.0;
        self->u2 = 0.0;
        self->u3 = 0.0;
        self->seen = 0U;
        self->x1_hat = 0.0;
        self->x2_hat = 0.0;
        self->d_hat = 0.0;
        self->d_rate_hat = 0.0;
        status = PTC_OK;
    }
    return status;
}

ptc_status shaken_arm(shaken *self, uint32_t k)
{
    ptc_status status = PTC_E_INPUT;

    if (self != NULL) {
        self->start = k;
        const double s1 = fabs(self->x1_hat) + fabs(self->x2_hat) + fabs(self->d_hat);
        const double size = s1 + fabs(self->d_rate_hat);
        if (!(size <= 1e150)) {
            self->seen = 0U;
            self->x1_hat = 0.0;
            self->x2_hat = 0.0;
            self->d_hat = 0.0;
            self->d_rate_hat = 0.0;
        }
        status = PTC_OK;
    }
    return status;
}

ptc_status shaken_step(shaken *self, uint32_t k, const double y[1], double *u)
{
    ptc_status status = PTC_E_INPUT;

    if (u != NULL) {
        *u = 0.0;
    }
    if ((self != NULL) && (y != NULL) && (u != NULL)) {
        if (PTC_FINITE_F64(y[0])) {
            const uint32_t elapsed = k - self->start;

            /* Predict. */
            const double s1 = self->x1_hat + (SHAKEN_PHI1_2 * self->x2_hat);
            const double s2 = s1 + (SHAKEN_PHI1_3 * self->d_hat);
            const double s3 = (SHAKEN_GAMMA1 * self->u3) + (SHAKEN_LATE_GAMMA1 * self->u2);
            const double p1 = s2 + (SHAKEN_PHI1_4 * self->d_rate_hat) + s3;
            const double s4 = self->x2_hat + (SHAKEN_PHI2_3 * self->d_hat);
            const double s5 = (SHAKEN_GAMMA2 * self->u3) + (SHAKEN_LATE_GAMMA2 * self->u2);
            const double p2 = s4 + (SHAKEN_PHI2_4 * self->d_rate_hat) + s5;
            const double s6 = SHAKEN_PHI3_4 * self->d_rate_hat;
            const double p3 = (SHAKEN_PHI3_3 * self->d_hat) + s6;
            const double s7 = SHAKEN_PHI4_4 * self->d_rate_hat;
            const double p4 = (SHAKEN_PHI4_3 * self->d_hat) + s7;

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
            const uint32_t left_o = (elapsed < SHAKEN_OBSERVER_SAMPLES) ? (SHAKEN_OBSERVER_SAMPLES - elapsed) : 0U;
            const double o0 = ((double)left_o < SHAKEN_HOLD_O) ? SHAKEN_HOLD_O : (double)left_o;
            double l1;
            double l2;
            double l3;
            double l4;
            const double o0f2 = o0 * (o0 - 1.0);
            const double o0f3 = o0f2 * (o0 - 2.0);
            const double r0 = 1.0 / (o0f3 * (o0 - 3.0));
            const double s8 = SHAKEN_Q1_1 + (SHAKEN_Q1_2 * o0) + (SHAKEN_Q1_3 * o0f2);
            l1 = ((s8 + (SHAKEN_Q1_4 * o0f3)) * r0) - 3.8011523294569497e-121;
            const double s9 = SHAKEN_Q2_1 + (SHAKEN_Q2_2 * o0) + (SHAKEN_Q2_3 * o0f2);
            l2 = ((s9 + (SHAKEN_Q2_4 * o0f3)) * r0) - 3.601080388941686;
            const double s10 = SHAKEN_Q3_1 + (SHAKEN_Q3_2 * o0) + (SHAKEN_Q3_3 * o0f2);
            l3 = ((s10 + (SHAKEN_Q3_4 * o0f3)) * r0) + 1.3694003898462869e-117;
            const double s11 = SHAKEN_Q4_1 + (SHAKEN_Q4_2 * o0) + (SHAKEN_Q4_3 * o0f2);
            l4 = ((s11 + (SHAKEN_Q4_4 * o0f3)) * r0) + 6481.944700095035;
            const double x1 = base + (l1 * miss);
            const double x2 = p2 + (l2 * miss);
            const double d = p3 + (l3 * miss);
            const double d_rate = p4 + (l4 * miss);

            /* The disturbance while each input acts. */
            const double d0 = (SHAKEN_D0_D * d) + (SHAKEN_D0_D_RATE * d_rate);
            const double d1 = (SHAKEN_D1_D * d) + (SHAKEN_D1_D_RATE * d_rate);
            const double d2 = (SHAKEN_D2_D * d) + (SHAKEN_D2_D_RATE * d_rate);
            const uint32_t left = (elapsed < SHAKEN_SAMPLES) ? (SHAKEN_SAMPLES - elapsed) : 0U;
            const double s12 = ((double)left) - 2.0;
            const double m0 = (s12 < SHAKEN_HOLD) ? SHAKEN_HOLD : s12;
            double v;

            /* The exact law in samples. */
            const double s13 = (SHAKEN_W1_1 * x1) + (SHAKEN_W1_2 * x2);
            const double z1 = s13 + (SHAKEN_W1_4 * (self->u2 + d2));
            const double s14 = (SHAKEN_W2_2 * x2) + (SHAKEN_W2_3 * (self->u1 + d1));
            const double z2 = s14 + (SHAKEN_W2_4 * (self->u2 + d2));
            const double m0f1 = m0 + 2.0;
            v = ((z1 + (z2 * m0f1)) / (m0f1 * (m0 + 1.0))) - d0;
            status = PTC_E_RANGE;
            if (PTC_FINITE_F64(v)) {
                double u_now;
                if (v > SHAKEN_U_MAX) {
                    u_now = SHAKEN_U_MAX;
                } else if (v < -SHAKEN_U_MAX) {
                    u_now = -SHAKEN_U_MAX;
                } else {
                    u_now = v;
                }
                self->u3 = self->u2;
                self->u2 = self->u1;
                self->u1 = u_now;
                self->x1_hat = x1;
                self->x2_hat = x2;
                self->d_hat = d;
                self->d_rate_hat = d_rate;
                self->seen = 1U;
                *u = u_now;
                if ((v > SHAKEN_U_MAX) || (v < -SHAKEN_U_MAX)) {
                    status = PTC_SATURATED;
                } else if (((double)left) - 2.0 <= SHAKEN_HOLD) {
                    status = PTC_HOLD;
                } else {
                    status = PTC_OK;
                }
            }
        }
    }
    return status;
}

ptc_status shaken_estimate(const shaken *self, double xhat[2])
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

ptc_status shaken_disturbance(const shaken *self, double *d)
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (d != NULL)) {
        *d = self->d_hat;
        status = PTC_OK;
    }
    return status;
}
