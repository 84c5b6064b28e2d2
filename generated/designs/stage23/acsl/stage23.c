/* Prescribed-time controller stage23: see stage23.h. DO NOT EDIT. */
#include "stage23.h"

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
#define STAGE23_GAMMA1 0.00014736313620654503 /* prediction from u */
#define STAGE23_GAMMA2 0.04245805872561294 /* prediction from u */
#define STAGE23_GAMMA3 0.7866781644184895 /* prediction from u */
#define STAGE23_OBSERVER_SAMPLES 25U /* samples of the round of the observer */
#define STAGE23_Q1_1 24.0 /* weight in the observer's gain l1 */
#define STAGE23_Q1_2 (-24.0) /* weight in the observer's gain l1 */
#define STAGE23_Q1_3 12.0 /* weight in the observer's gain l1 */
#define STAGE23_Q2_1 (-12098.699806867564) /* weight in the observer's gain l2 */
#define STAGE23_Q2_2 5834.153087954333 /* weight in the observer's gain l2 */
#define STAGE23_Q2_3 (-616.5581920200482) /* weight in the observer's gain l2 */
#define STAGE23_Q3_1 90981.25917900148 /* weight in the observer's gain l3 */
#define STAGE23_Q3_2 (-29002.765439771665) /* weight in the observer's gain l3 */
#define STAGE23_Q3_3 2998.7909601002407 /* weight in the observer's gain l3 */
#define STAGE23_E0_1 1.0950153689199909 /* gain of the observer at its end */
#define STAGE23_E0_2 15.297392853547647 /* gain of the observer at its end */
#define STAGE23_E0_3 98.32269091567703 /* gain of the observer at its end */
#define STAGE23_E1_1 1.309301083205705 /* gain of the observer at its end */
#define STAGE23_E1_2 6.605837883444068 /* gain of the observer at its end */
#define STAGE23_E1_3 (-407.1438225313707) /* gain of the observer at its end */
#define STAGE23_E2_1 2.5950153689199906 /* gain of the observer at its end */
#define STAGE23_E2_2 180.07490250022406 /* gain of the observer at its end */
#define STAGE23_E2_3 358.78371927742626 /* gain of the observer at its end */
#define STAGE23_PHI1_2 0.009947226521739929 /* prediction of x1 from x2 */
#define STAGE23_PHI1_3 0.00042458058725612934 /* prediction of x1 from x3 */
#define STAGE23_PHI2_2 0.9892036123037478 /* prediction of x2 from x2 */
#define STAGE23_PHI2_3 0.07824323585459282 /* prediction of x2 from x3 */
#define STAGE23_PHI3_2 (-0.015648647170918566) /* prediction of x3 from x2 */
#define STAGE23_PHI3_3 0.605811756616243 /* prediction of x3 from x3 */
#define STAGE23_W1_1 (-1072951.6050632286) /* weight of x1 in the law */
#define STAGE23_W1_2 11224.193450693596 /* weight of x2 in the law */
#define STAGE23_W1_3 (-404.795716419329) /* weight of x3 in the law */
#define STAGE23_W2_2 (-6164.422229232715) /* weight of x2 in the law */
#define STAGE23_W2_3 332.70200299979865 /* weight of x3 in the law */
#define STAGE23_W3_2 15.336789013047456 /* weight of x2 in the law */
#define STAGE23_W3_3 (-153.36789013047456) /* weight of x3 in the law */
#define STAGE23_W4_4 (-16.0) /* weight of u1 in the law */
#define STAGE23_W4_2 0.29792241063993585 /* weight of x2 in the law */
#define STAGE23_W4_3 8.220775893600642 /* weight of x3 in the law */
#define STAGE23_C_4 1.4049846310800091 /* weight of u1 in the law */
#define STAGE23_C_2 (-0.00824128170492625) /* weight of x2 in the law */
#define STAGE23_C_3 (-0.20107642470674394) /* weight of x3 in the law */
#define STAGE23_B_1 (-1277.3233393609864) /* weight of x1 in the law */
#define STAGE23_B_2 (-37.174971411649004) /* weight of x2 in the law */
#define STAGE23_B_3 (-3.523659928569286) /* weight of x3 in the law */
#define STAGE23_B_4 (-2.5950153689199906) /* weight of u1 in the law */
#define STAGE23_SAMPLES 50U /* samples from the start to rest */

ptc_status stage23_init(stage23 *self, const stage23_params *params)
{
    ptc_status status = PTC_E_PARAM;

    if ((self != NULL) && (params != NULL)) {
        if (params->u_max > 0.0) {
            const double u_max = params->u_max;
            self->start = 0U;
            self->u1 = 0.0;
            self->u2 = 0.0;
            self->seen = 0U;
            self->x1_hat = 0.0;
            self->x1_next = 0.0;
            self->x2_hat = 0.0;
            self->x2_next = 0.0;
            self->x3_hat = 0.0;
            self->x3_next = 0.0;
            self->u_r1 = 0.0;
            self->u_max = u_max;
            status = PTC_OK;
        }
    }
    return status;
}

ptc_status stage23_arm(stage23 *self, uint32_t k)
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

ptc_status stage23_step(stage23 *self, uint32_t k, const double y[1], const double r[4], double *u)
{
    ptc_status status = PTC_E_INPUT;

    if (u != NULL) {
        *u = 0.0;
    }
    if ((self != NULL) && (y != NULL) && (r != NULL) && (u != NULL)) {
        if (PTC_FINITE_F64(y[0])
            && PTC_FINITE_F64(r[0])
            && PTC_FINITE_F64(r[1])
            && PTC_FINITE_F64(r[2])
            && PTC_FINITE_F64(r[3])) {
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
                x1 = self->x1_next + (STAGE23_GAMMA1 * self->u2);
                x2 = self->x2_next + (STAGE23_GAMMA2 * self->u2);
                x3 = self->x3_next + (STAGE23_GAMMA3 * self->u2);
            }

            /* Prediction of the next sample. */
            const double miss1 = y[0] - x1;
            const double off1 = miss1;
            const uint32_t left_o = (elapsed < STAGE23_OBSERVER_SAMPLES) ? (STAGE23_OBSERVER_SAMPLES - elapsed) : 0U;
            const double o0 = (double)left_o;
            double l1;
            double l2;
            double l3;
            if (o0 > 8.0) {
                const double o0f2 = o0 * (o0 - 1.0);
                const double r0 = 1.0 / (o0f2 * (o0 - 2.0));
                const double s1 = (STAGE23_Q1_1 + (STAGE23_Q1_2 * o0) + (STAGE23_Q1_3 * o0f2)) * r0;
                l1 = s1 - 0.4049846310800092;
                const double s2 = (STAGE23_Q2_1 + (STAGE23_Q2_2 * o0) + (STAGE23_Q2_3 * o0f2)) * r0;
                l2 = s2 + 20.107642470674392;
                const double s3 = (STAGE23_Q3_1 + (STAGE23_Q3_2 * o0) + (STAGE23_Q3_3 * o0f2)) * r0;
                l3 = s3 - 97.7033199358119;
            } else if (left_o == 8U) {
                l1 = STAGE23_E0_1;
                l2 = STAGE23_E0_2;
                l3 = STAGE23_E0_3;
            } else if (left_o == 7U) {
                l1 = STAGE23_E1_1;
                l2 = STAGE23_E1_2;
                l3 = STAGE23_E1_3;
            } else {
                l1 = STAGE23_E2_1;
                l2 = STAGE23_E2_2;
                l3 = STAGE23_E2_3;
            }
            const double x1_on = x1 + (STAGE23_PHI1_2 * x2) + (STAGE23_PHI1_3 * x3) + (l1 * off1);
            const double x2_on = (STAGE23_PHI2_2 * x2) + (STAGE23_PHI2_3 * x3) + (l2 * off1);
            const double x3_on = (STAGE23_PHI3_2 * x2) + (STAGE23_PHI3_3 * x3) + (l3 * off1);

            /* The tracking error. */
            const double u_r = (0.07 * r[1]) + (0.05205 * r[2]) + (0.0017731666666666666 * r[3]);
            const double e1 = x1 - r[0];
            const double e2 = x2 - r[1];
            const double e3 = x3 - ((0.1 * r[1]) + (0.1 * r[2]));
            double v;
            if (elapsed < 46U) {
                /* The exact law in samples. */
                const double m0 = (double)(53U - elapsed);
                const double z1 = (STAGE23_W1_1 * e1) + (STAGE23_W1_2 * e2) + (STAGE23_W1_3 * e3);
                const double z2 = (STAGE23_W2_2 * e2) + (STAGE23_W2_3 * e3);
                const double z3 = (STAGE23_W3_2 * e2) + (STAGE23_W3_3 * e3);
                const double s4 = STAGE23_W4_4 * (self->u1 - self->u_r1);
                const double z4 = (STAGE23_W4_2 * e2) + (STAGE23_W4_3 * e3) + s4;
                const double m0f2 = m0 * (m0 - 1.0);
                const double m0f3 = m0f2 * (m0 - 2.0);
                const double s5 = STAGE23_C_4 * (self->u1 - self->u_r1);
                const double s6 = (z1 + (z2 * m0) + (z3 * m0f2) + (z4 * m0f3)) / (m0f3 * (m0 - 3.0));
                v = s6 + ((STAGE23_C_2 * e2) + (STAGE23_C_3 * e3) + s5) + u_r;
            } else {
                /* Deadbeat. */
                const double s7 = (STAGE23_B_1 * e1) + (STAGE23_B_2 * e2) + (STAGE23_B_3 * e3);
                v = s7 + (STAGE23_B_4 * (self->u1 - self->u_r1)) + u_r;
            }
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
                self->u2 = self->u1;
                self->u1 = u_now;
                self->u_r1 = u_r;
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
                } else if (elapsed < STAGE23_SAMPLES) {
                    status = PTC_OK;
                } else {
                    status = PTC_HOLD;
                }
            }
        }
    }
    return status;
}

ptc_status stage23_estimate(const stage23 *self, double xhat[3])
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
