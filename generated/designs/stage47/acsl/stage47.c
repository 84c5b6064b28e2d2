/* Prescribed-time controller stage47: see stage47.h. DO NOT EDIT. */
#include "stage47.h"

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
#define STAGE47_GAMMA1 0.00010803832226644697 /* prediction from u */
#define STAGE47_GAMMA2 0.030892799233141147 /* prediction from u */
#define STAGE47_GAMMA3 0.3745921515889058 /* prediction from u */
#define STAGE47_OBSERVER_SAMPLES 20U /* samples of the round of the observer */
#define STAGE47_Q1_1_1 (-8.0) /* weight in the observer's gain l1_1 */
#define STAGE47_Q1_1_2 8.0 /* weight in the observer's gain l1_1 */
#define STAGE47_Q1_2_1 1207.0156938434693 /* weight in the observer's gain l1_2 */
#define STAGE47_Q1_2_2 (-4.007471679722458) /* weight in the observer's gain l1_2 */
#define STAGE47_Q1_4_1 359.9103398433305 /* weight in the observer's gain l1_4 */
#define STAGE47_Q2_2_1 (-1.8587963031465917) /* weight in the observer's gain l2_2 */
#define STAGE47_Q2_2_2 0.9913796378212842 /* weight in the observer's gain l2_2 */
#define STAGE47_Q2_3_1 (-12.0) /* weight in the observer's gain l2_3 */
#define STAGE47_Q2_3_2 12.0 /* weight in the observer's gain l2_3 */
#define STAGE47_Q2_4_1 79.82759275642569 /* weight in the observer's gain l2_4 */
#define STAGE47_E0_1_1 0.9950193780571475 /* gain of the observer at its end */
#define STAGE47_E0_1_2 (-0.49380107331759976) /* gain of the observer at its end */
#define STAGE47_E0_1_3 0.056139026437663865 /* gain of the observer at its end */
#define STAGE47_E0_2_1 0.0014392695129337434 /* gain of the observer at its end */
#define STAGE47_E0_2_2 0.220357858722901 /* gain of the observer at its end */
#define STAGE47_E0_2_3 1.0319630246108107 /* gain of the observer at its end */
#define STAGE47_E0_2_4 1.3304598792737614 /* gain of the observer at its end */
#define STAGE47_E1_1_1 1.9950193780571475 /* gain of the observer at its end */
#define STAGE47_E1_1_2 99.25595014702932 /* gain of the observer at its end */
#define STAGE47_E1_1_3 0.056139026437663865 /* gain of the observer at its end */
#define STAGE47_E1_1_4 29.992528320277543 /* gain of the observer at its end */
#define STAGE47_E1_2_1 0.0014392695129337434 /* gain of the observer at its end */
#define STAGE47_E1_2_2 0.24720839921003274 /* gain of the observer at its end */
#define STAGE47_E1_2_3 1.5319630246108107 /* gain of the observer at its end */
#define STAGE47_E1_2_4 2.660919758547523 /* gain of the observer at its end */
#define STAGE47_PHI1_2 0.009942671770940647 /* prediction of x1 from x2 */
#define STAGE47_PHI1_3 0.000617855984662823 /* prediction of x1 from x3 */
#define STAGE47_PHI1_4 0.00010803832226644697 /* prediction of x1 from d */
#define STAGE47_PHI2_2 0.9857608243445873 /* prediction of x2 from x2 */
#define STAGE47_PHI2_3 0.11206871748434033 /* prediction of x2 from x3 */
#define STAGE47_PHI2_4 0.030892799233141147 /* prediction of x2 from d */
#define STAGE47_PHI3_2 (-0.11206871748434033) /* prediction of x3 from x2 */
#define STAGE47_PHI3_3 0.5412215783233707 /* prediction of x3 from x3 */
#define STAGE47_PHI3_4 0.3745921515889058 /* prediction of x3 from d */
#define STAGE47_HOLD 6.0 /* samples to go at which the gains are held */
#define STAGE47_W1_1 (-106850.90292251826) /* weight of x1 in the law */
#define STAGE47_W1_2 1124.1848178645955 /* weight of x2 in the law */
#define STAGE47_W1_3 (-61.894579201640425) /* weight of x3 in the law */
#define STAGE47_W2_2 (-642.8726851005619) /* weight of x2 in the law */
#define STAGE47_W2_3 53.018026963569255 /* weight of x3 in the law */
#define STAGE47_W3_2 0.8030787004640786 /* weight of x2 in the law */
#define STAGE47_W3_3 (-24.09236101392236) /* weight of x3 in the law */
#define STAGE47_C_2 0.29872942459099683 /* weight of x2 in the law */
#define STAGE47_C_3 1.238117262270095 /* weight of x3 in the law */

ptc_status stage47_init(stage47 *self, const stage47_params *params)
{
    ptc_status status = PTC_E_PARAM;

    if ((self != NULL) && (params != NULL)) {
        if ((params->samples > 22U) && (params->u_max > 0.0)) {
            const uint32_t samples = params->samples;
            const double u_max = params->u_max;
            self->start = 0U;
            self->samples = samples;
            self->u1 = 0.0;
            self->seen = 0U;
            self->x1_hat = 0.0;
            self->x1_next = 0.0;
            self->x2_hat = 0.0;
            self->x2_next = 0.0;
            self->x3_hat = 0.0;
            self->x3_next = 0.0;
            self->d_hat = 0.0;
            self->d_next = 0.0;
            self->u_max = u_max;
            status = PTC_OK;
        }
    }
    return status;
}

ptc_status stage47_arm(stage47 *self, uint32_t k)
{
    ptc_status status = PTC_E_INPUT;

    if (self != NULL) {
        self->start = k;
        const double s1 = fabs(self->x1_next) + fabs(self->x2_next);
        const double size = s1 + fabs(self->x3_next) + fabs(self->d_next);
        if (!(size <= 1e150)) {
            self->seen = 0U;
            self->x1_hat = 0.0;
            self->x1_next = 0.0;
            self->x2_hat = 0.0;
            self->x2_next = 0.0;
            self->x3_hat = 0.0;
            self->x3_next = 0.0;
            self->d_hat = 0.0;
            self->d_next = 0.0;
        }
        status = PTC_OK;
    }
    return status;
}

ptc_status stage47_step(stage47 *self, uint32_t k, const double y[2], double *u)
{
    ptc_status status = PTC_E_INPUT;

    if (u != NULL) {
        *u = 0.0;
    }
    if ((self != NULL) && (y != NULL) && (u != NULL)) {
        if (PTC_FINITE_F64(y[0]) && PTC_FINITE_F64(y[1])) {
            const uint32_t elapsed = k - self->start;

            /* The estimates; at first what y shows. */
            double x1;
            double x2;
            double x3;
            double d;
            if (self->seen == 0U) {
                x1 = y[0];
                x2 = 0.0;
                x3 = y[1];
                d = 0.0;
            } else {
                x1 = self->x1_next + (STAGE47_GAMMA1 * self->u1);
                x2 = self->x2_next + (STAGE47_GAMMA2 * self->u1);
                x3 = self->x3_next + (STAGE47_GAMMA3 * self->u1);
                d = self->d_next;
            }

            /* Prediction of the next sample. */
            const double miss1 = y[0] - x1;
            const double miss2 = y[1] - x3;
            const double off1 = miss1;
            const double off2 = miss2;
            const uint32_t left_o = (elapsed < STAGE47_OBSERVER_SAMPLES) ? (STAGE47_OBSERVER_SAMPLES - elapsed) : 0U;
            const double o0 = (double)left_o;
            double l1_1;
            double l1_2;
            double l1_3;
            double l1_4;
            double l2_1;
            double l2_2;
            double l2_3;
            double l2_4;
            if (left_o == 0U) {
                l1_1 = 0.5288853188994155;
                l1_2 = 11.043581739724111;
                l1_3 = -1.95232951580154;
                l1_4 = -4.310227400623051;
                l2_1 = 0.00186202868892253;
                l2_2 = 0.2724600360147846;
                l2_3 = 1.5302977387244094;
                l2_4 = 2.6662087225258313;
            } else if (o0 > 8.0) {
                const double r0 = 1.0 / (o0 * (o0 - 1.0));
                const double s1 = (STAGE47_Q1_1_1 + (STAGE47_Q1_1_2 * o0)) * r0;
                l1_1 = s1 - 0.004980621942852573;
                const double s2 = (STAGE47_Q1_2_1 + (STAGE47_Q1_2_2 * o0)) * r0;
                l1_2 = s2 + 0.007132886647707467;
                l1_3 = 0.056139026437663865;
                l1_4 = STAGE47_Q1_4_1 * r0;
                l2_1 = 0.0014392695129337434;
                const double s3 = (STAGE47_Q2_2_1 + (STAGE47_Q2_2_2 * o0)) * r0;
                l2_2 = s3 + 0.11089234841732894;
                const double s4 = (STAGE47_Q2_3_1 + (STAGE47_Q2_3_2 * o0)) * r0;
                l2_3 = s4 - 0.4680369753891894;
                l2_4 = STAGE47_Q2_4_1 * r0;
            } else if (left_o == 8U) {
                l1_1 = STAGE47_E0_1_1;
                l1_2 = STAGE47_E0_1_2;
                l1_3 = STAGE47_E0_1_3;
                l1_4 = 0.0;
                l2_1 = STAGE47_E0_2_1;
                l2_2 = STAGE47_E0_2_2;
                l2_3 = STAGE47_E0_2_3;
                l2_4 = STAGE47_E0_2_4;
            } else {
                l1_1 = STAGE47_E1_1_1;
                l1_2 = STAGE47_E1_1_2;
                l1_3 = STAGE47_E1_1_3;
                l1_4 = STAGE47_E1_1_4;
                l2_1 = STAGE47_E1_2_1;
                l2_2 = STAGE47_E1_2_2;
                l2_3 = STAGE47_E1_2_3;
                l2_4 = STAGE47_E1_2_4;
            }
            const double s5 = x1 + (STAGE47_PHI1_2 * x2) + (STAGE47_PHI1_3 * x3);
            const double x1_on = s5 + (STAGE47_PHI1_4 * d) + (l1_1 * off1) + (l2_1 * off2);
            const double s6 = (STAGE47_PHI2_2 * x2) + (STAGE47_PHI2_3 * x3);
            const double x2_on = s6 + (STAGE47_PHI2_4 * d) + (l1_2 * off1) + (l2_2 * off2);
            const double s7 = (STAGE47_PHI3_2 * x2) + (STAGE47_PHI3_3 * x3);
            const double x3_on = s7 + (STAGE47_PHI3_4 * d) + (l1_3 * off1) + (l2_3 * off2);
            const double d_on = d + (l1_4 * off1) + (l2_4 * off2);
            const uint32_t left = (elapsed < self->samples) ? (self->samples - elapsed) : 0U;
            const double m0 = ((double)left < STAGE47_HOLD) ? STAGE47_HOLD : (double)left;
            double v;

            /* The exact law in samples. */
            const double z1 = (STAGE47_W1_1 * x1) + (STAGE47_W1_2 * x2) + (STAGE47_W1_3 * x3);
            const double z2 = (STAGE47_W2_2 * x2) + (STAGE47_W2_3 * x3);
            const double z3 = (STAGE47_W3_2 * x2) + (STAGE47_W3_3 * x3);
            const double m0f1 = m0 + 2.0;
            const double m0f2 = m0f1 * (m0 + 1.0);
            const double s8 = (z1 + (z2 * m0f1) + (z3 * m0f2)) / (m0f2 * m0);
            v = (s8 + ((STAGE47_C_2 * x2) + (STAGE47_C_3 * x3))) - d;
            status = PTC_E_RANGE;
            if (PTC_FINITE_F64(v)
                && PTC_FINITE_F64(x1_on)
                && PTC_FINITE_F64(x2_on)
                && PTC_FINITE_F64(x3_on)
                && PTC_FINITE_F64(d_on)) {
                double u_now;
                if (v > self->u_max) {
                    u_now = self->u_max;
                } else if (v < -self->u_max) {
                    u_now = -self->u_max;
                } else {
                    u_now = v;
                }
                self->u1 = u_now;
                self->x1_hat = x1;
                self->x1_next = x1_on;
                self->x2_hat = x2;
                self->x2_next = x2_on;
                self->x3_hat = x3;
                self->x3_next = x3_on;
                self->d_hat = d;
                self->d_next = d_on;
                self->seen = 1U;
                *u = u_now;
                if ((v > self->u_max) || (v < -self->u_max)) {
                    status = PTC_SATURATED;
                } else if ((double)left <= STAGE47_HOLD) {
                    status = PTC_HOLD;
                } else {
                    status = PTC_OK;
                }
            }
        }
    }
    return status;
}

ptc_status stage47_estimate(const stage47 *self, double xhat[3])
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

ptc_status stage47_disturbance(const stage47 *self, double *d)
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (d != NULL)) {
        *d = self->d_hat;
        status = PTC_OK;
    }
    return status;
}
