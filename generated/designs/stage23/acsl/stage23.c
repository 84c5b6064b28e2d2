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

ptc_status stage23_init(stage23 *self, const stage23_params *params)
{
    ptc_status status = PTC_E_PARAM;

    if ((self != NULL) && (params != NULL)) {
        if (0.0 < params->u_max) {
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
                x1 = self->x1_next + (0.00014736313620654503 * self->u2);
                x2 = self->x2_next + (0.04245805872561294 * self->u2);
                x3 = self->x3_next + (0.7866781644184895 * self->u2);
            }

            /* Prediction of the next sample. */
            const double miss1 = y[0] - x1;
            const double off1 = miss1;
            const uint32_t left_o = (elapsed < 25U) ? (25U - elapsed) : 0U;
            const double o0 = (double)left_o;
            double l1;
            double l2;
            double l3;
            if (8.0 < o0) {
                const double r0 = 1.0 / o0;
                const double r1 = 1.0 / (o0 - 1.0);
                const double r2 = 1.0 / (o0 - 2.0);
                l1 = (((((24.0 * r0) - 24.0) * r1) + 12.0) * r2) - 0.4049846310800092;
                const double s1 = (((-12098.699806867564) * r0) + 5834.153087954333) * r1;
                l2 = ((s1 - 616.5581920200482) * r2) + 20.107642470674392;
                const double s2 = ((90981.25917900148 * r0) - 29002.765439771665) * r1;
                l3 = ((s2 + 2998.7909601002407) * r2) - 97.7033199358119;
            } else if (left_o == 8U) {
                l1 = 1.0950153689199909;
                l2 = 15.297392853547647;
                l3 = 98.32269091567703;
            } else if (left_o == 7U) {
                l1 = 1.309301083205705;
                l2 = 6.605837883444068;
                l3 = -407.1438225313707;
            } else {
                l1 = 2.5950153689199906;
                l2 = 180.07490250022406;
                l3 = 358.78371927742626;
            }
            const double s3 = x1 + (0.009947226521739929 * x2);
            const double x1_on = s3 + (0.00042458058725612934 * x3) + (l1 * off1);
            const double s4 = (0.9892036123037478 * x2) + (0.07824323585459282 * x3);
            const double x2_on = s4 + (l2 * off1);
            const double s5 = ((-0.015648647170918566) * x2) + (0.605811756616243 * x3);
            const double x3_on = s5 + (l3 * off1);

            /* The tracking error. */
            const double u_r = (0.07 * r[1]) + (0.05205 * r[2]) + (0.0017731666666666666 * r[3]);
            const double e1 = x1 - r[0];
            const double e2 = x2 - r[1];
            const double e3 = x3 - ((0.1 * r[1]) + (0.1 * r[2]));
            double v;
            if (elapsed < 46U) {
                /* The exact law in samples. */
                const double m0 = (double)(53U - elapsed);
                const double s6 = ((-1072951.6050632286) * e1) + (11224.193450693596 * e2);
                const double z1 = s6 - (404.795716419329 * e3);
                const double z2 = ((-6164.422229232715) * e2) + (332.70200299979865 * e3);
                const double z3 = (15.336789013047456 * e2) - (153.36789013047456 * e3);
                const double s7 = (0.29792241063993585 * e2) + (8.220775893600642 * e3);
                const double z4 = s7 - (16.0 * (self->u1 - self->u_r1));
                const double s8 = (((((z1 / m0) + z2) / (m0 - 1.0)) + z3) / (m0 - 2.0)) + z4;
                const double s9 = ((-0.00824128170492625) * e2) - (0.20107642470674394 * e3);
                const double s10 = s9 + (1.4049846310800091 * (self->u1 - self->u_r1));
                v = (s8 / (m0 - 3.0)) + s10 + u_r;
            } else {
                /* Deadbeat. */
                const double s11 = ((-1277.3233393609864) * e1) - (37.174971411649004 * e2);
                const double s12 = 2.5950153689199906 * (self->u1 - self->u_r1);
                v = ((s11 - (3.523659928569286 * e3)) - s12) + u_r;
            }
            status = PTC_E_RANGE;
            if (PTC_FINITE_F64(v)
                && PTC_FINITE_F64(x1_on)
                && PTC_FINITE_F64(x2_on)
                && PTC_FINITE_F64(x3_on)) {
                double u_now;
                if (self->u_max < v) {
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
                if ((self->u_max < v) || (v < -self->u_max)) {
                    status = PTC_SATURATED;
                } else if (elapsed < 50U) {
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
    } else {
        if (xhat != NULL) {
            for (uint32_t i = 0U; i < 3U; i++) {
                xhat[i] = 0.0;
            }
        }
    }
    return status;
}
