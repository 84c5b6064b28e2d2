/* Prescribed-time controller stage44: see stage44.h. DO NOT EDIT. */
#include "stage44.h"

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
#define STAGE44_GAMMA1 9.353143640028875e-5 /* prediction from u */
#define STAGE44_LATE_GAMMA1 1.4506885866158227e-5 /* prediction from u */
#define STAGE44_GAMMA2 0.02240015856569381 /* prediction from u */
#define STAGE44_LATE_GAMMA2 0.008492640667447336 /* prediction from u */
#define STAGE44_GAMMA3 0.15880933131841984 /* prediction from u */
#define STAGE44_LATE_GAMMA3 0.21578282027048595 /* prediction from u */
#define STAGE44_Q1_1 24.0 /* weight in the observer's gain l1 */
#define STAGE44_Q1_2 (-24.0) /* weight in the observer's gain l1 */
#define STAGE44_Q1_3 12.0 /* weight in the observer's gain l1 */
#define STAGE44_Q2_1 (-12889.952685745366) /* weight in the observer's gain l2 */
#define STAGE44_Q2_2 6304.212917508586 /* weight in the observer's gain l2 */
#define STAGE44_Q2_3 (-742.8703573620571) /* weight in the observer's gain l2 */
#define STAGE44_Q3_1 72521.99132748511 /* weight in the observer's gain l3 */
#define STAGE44_Q3_2 (-24808.851670034343) /* weight in the observer's gain l3 */
#define STAGE44_Q3_3 2767.4814294482285 /* weight in the observer's gain l3 */
#define STAGE44_E0_1 1.026982402667958 /* gain of the observer at its end */
#define STAGE44_E0_2 9.393065010983802 /* gain of the observer at its end */
#define STAGE44_E0_3 72.1724949708503 /* gain of the observer at its end */
#define STAGE44_E1_1 1.2412681169536723 /* gain of the observer at its end */
#define STAGE44_E1_2 (-0.9955098611216602) /* gain of the observer at its end */
#define STAGE44_E1_3 (-271.5264302640074) /* gain of the observer at its end */
#define STAGE44_E2_1 2.526982402667958 /* gain of the observer at its end */
#define STAGE44_E2_2 168.91277532831796 /* gain of the observer at its end */
#define STAGE44_E2_3 171.81438886235838 /* gain of the observer at its end */
#define STAGE44_PHI1_2 0.009942671770940647 /* prediction of x1 from x2 */
#define STAGE44_PHI1_3 0.000617855984662823 /* prediction of x1 from x3 */
#define STAGE44_PHI2_2 0.9857608243445873 /* prediction of x2 from x2 */
#define STAGE44_PHI2_3 0.11206871748434033 /* prediction of x2 from x3 */
#define STAGE44_PHI3_2 (-0.11206871748434033) /* prediction of x3 from x2 */
#define STAGE44_PHI3_3 0.5412215783233707 /* prediction of x3 from x3 */
#define STAGE44_HOLD 6.0 /* samples to go at which the gains are held */
#define STAGE44_W1_1 (-106850.90292251826) /* weight of x1 in the law */
#define STAGE44_W1_2 (-482.3692808208648) /* weight of x2 in the law */
#define STAGE44_W1_3 4.807633485406011 /* weight of x3 in the law */
#define STAGE44_W1_4 (-1.2197801784387233e-74) /* weight of u1 in the law */
#define STAGE44_W1_5 4.609258112111791 /* weight of u2 in the law */
#define STAGE44_W2_2 (-633.6322203514217) /* weight of x2 in the law */
#define STAGE44_W2_3 (-73.36956899710586) /* weight of x3 in the law */
#define STAGE44_W2_4 (-1.2733281521282373e-76) /* weight of u1 in the law */
#define STAGE44_W2_5 (-14.786896717013052) /* weight of u2 in the law */
#define STAGE44_W3_2 4.311208496599377 /* weight of x2 in the law */
#define STAGE44_W3_3 (-9.337493806987991) /* weight of x3 in the law */
#define STAGE44_W3_4 (-9.0) /* weight of u1 in the law */
#define STAGE44_W3_5 (-2.7645844206856207) /* weight of u2 in the law */
#define STAGE44_C_2 0.10945032226632541 /* weight of x2 in the law */
#define STAGE44_C_3 0.5296658086896372 /* weight of x3 in the law */
#define STAGE44_C_4 0.47301759733204196 /* weight of u1 in the law */
#define STAGE44_C_5 0.15314166966017376 /* weight of u2 in the law */

ptc_status stage44_init(stage44 *self, const stage44_params *params)
{
    ptc_status status = PTC_E_PARAM;

    if ((self != NULL) && (params != NULL)) {
        if ((params->samples > 9U) && (params->u_max > 0.0)) {
            const uint32_t samples = params->samples;
            const double u_max = params->u_max;
            self->start = 0U;
            self->samples = samples;
            self->u1 = 0.0;
            self->u2 = 0.0;
            self->u3 = 0.0;
            self->seen = 0U;
            self->x1_hat = 0.0;
            self->x1_next = 0.0;
            self->x2_hat = 0.0;
            self->x2_next = 0.0;
            self->x3_hat = 0.0;
            self->x3_next = 0.0;
            self->u_max = u_max;
            status = PTC_OK;
        }
    }
    return status;
}

ptc_status stage44_arm(stage44 *self, uint32_t k)
{
    ptc_status status = PTC_E_INPUT;

    if (self != NULL) {
        self->start = k;
        const double s1 = fabs(self->x1_next) + fabs(self->x2_next);
        const double size = s1 + fabs(self->x3_next);
        if (!(size <= 1e150)) {
            self->seen = 0U;
            self->x1_hat = 0.0;
            self->x1_next = 0.0;
            self->x2_hat = 0.0;
            self->x2_next = 0.0;
            self->x3_hat = 0.0;
            self->x3_next = 0.0;
        }
        status = PTC_OK;
    }
    return status;
}

ptc_status stage44_step(stage44 *self, uint32_t k, const double y[1], double *u)
{
    ptc_status status = PTC_E_INPUT;

    if (u != NULL) {
        *u = 0.0;
    }
    if ((self != NULL) && (y != NULL) && (u != NULL)) {
        if (PTC_FINITE_F64(y[0])) {
            const uint32_t elapsed = k - self->start;

            /* The estimates; at first what y shows. */
            double x1;
            double x2;
            double x3;
            if (self->seen == 0U) {
                x1 = y[0];
                x2 = 0.0;
                x3 = 0.0;
            } else {
                const double s1 = (STAGE44_GAMMA1 * self->u3) + (STAGE44_LATE_GAMMA1 * self->u2);
                x1 = self->x1_next + s1;
                const double s2 = (STAGE44_GAMMA2 * self->u3) + (STAGE44_LATE_GAMMA2 * self->u2);
                x2 = self->x2_next + s2;
                const double s3 = (STAGE44_GAMMA3 * self->u3) + (STAGE44_LATE_GAMMA3 * self->u2);
                x3 = self->x3_next + s3;
            }

            /* Prediction of the next sample. */
            const double miss1 = y[0] - x1;
            const double off1 = miss1;
            const uint32_t left_o = (elapsed < (self->samples / 2U)) ? ((self->samples / 2U) - elapsed) : 0U;
            const double o0 = (double)left_o;
            double l1;
            double l2;
            double l3;
            if (o0 > 8.0) {
                const double o0f2 = o0 * (o0 - 1.0);
                const double r0 = 1.0 / (o0f2 * (o0 - 2.0));
                const double s4 = (STAGE44_Q1_1 + (STAGE44_Q1_2 * o0) + (STAGE44_Q1_3 * o0f2)) * r0;
                l1 = s4 - 0.47301759733204196;
                const double s5 = (STAGE44_Q2_1 + (STAGE44_Q2_2 * o0) + (STAGE44_Q2_3 * o0f2)) * r0;
                l2 = s5 + 26.72716299730578;
                const double s6 = (STAGE44_Q3_1 + (STAGE44_Q3_2 * o0) + (STAGE44_Q3_3 * o0f2)) * r0;
                l3 = s6 - 98.86735283457841;
            } else if (left_o == 8U) {
                l1 = STAGE44_E0_1;
                l2 = STAGE44_E0_2;
                l3 = STAGE44_E0_3;
            } else if (left_o == 7U) {
                l1 = STAGE44_E1_1;
                l2 = STAGE44_E1_2;
                l3 = STAGE44_E1_3;
            } else {
                l1 = STAGE44_E2_1;
                l2 = STAGE44_E2_2;
                l3 = STAGE44_E2_3;
            }
            const double x1_on = x1 + (STAGE44_PHI1_2 * x2) + (STAGE44_PHI1_3 * x3) + (l1 * off1);
            const double x2_on = (STAGE44_PHI2_2 * x2) + (STAGE44_PHI2_3 * x3) + (l2 * off1);
            const double x3_on = (STAGE44_PHI3_2 * x2) + (STAGE44_PHI3_3 * x3) + (l3 * off1);
            const uint32_t left = (elapsed < self->samples) ? (self->samples - elapsed) : 0U;
            const double s7 = ((double)left) - 2.0;
            const double m0 = (s7 < STAGE44_HOLD) ? STAGE44_HOLD : s7;
            double v;

            /* The exact law in samples. */
            const double s8 = (STAGE44_W1_1 * x1) + (STAGE44_W1_2 * x2) + (STAGE44_W1_3 * x3);
            const double z1 = s8 + (STAGE44_W1_4 * self->u1) + (STAGE44_W1_5 * self->u2);
            const double s9 = (STAGE44_W2_2 * x2) + (STAGE44_W2_3 * x3);
            const double z2 = s9 + (STAGE44_W2_4 * self->u1) + (STAGE44_W2_5 * self->u2);
            const double s10 = (STAGE44_W3_2 * x2) + (STAGE44_W3_3 * x3);
            const double z3 = s10 + (STAGE44_W3_4 * self->u1) + (STAGE44_W3_5 * self->u2);
            const double m0f1 = m0 + 2.0;
            const double m0f2 = m0f1 * (m0 + 1.0);
            const double s11 = (STAGE44_C_2 * x2) + (STAGE44_C_3 * x3);
            const double s12 = s11 + (STAGE44_C_4 * self->u1) + (STAGE44_C_5 * self->u2);
            v = ((z1 + (z2 * m0f1) + (z3 * m0f2)) / (m0f2 * m0)) + s12;
            status = PTC_E_RANGE;
            if (PTC_FINITE_F64(v)
                && PTC_FINITE_F64(x1_on)
                && PTC_FINITE_F64(x2_on)
                && PTC_FINITE_F64(x3_on)) {
                double u_now;
                if (v > self->u_max) {
                    u_now = self->u_max;
                } else if (v < -self->u_max) {
                    u_now = -self->u_max;
                } else {
                    u_now = v;
                }
                self->u3 = self->u2;
                self->u2 = self->u1;
                self->u1 = u_now;
                self->x1_hat = x1;
                self->x1_next = x1_on;
                self->x2_hat = x2;
                self->x2_next = x2_on;
                self->x3_hat = x3;
                self->x3_next = x3_on;
                self->seen = 1U;
                *u = u_now;
                if ((v > self->u_max) || (v < -self->u_max)) {
                    status = PTC_SATURATED;
                } else if (((double)left) - 2.0 <= STAGE44_HOLD) {
                    status = PTC_HOLD;
                } else {
                    status = PTC_OK;
                }
            }
        }
    }
    return status;
}

ptc_status stage44_estimate(const stage44 *self, double xhat[3])
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
