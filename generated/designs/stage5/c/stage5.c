/* Prescribed-time controller stage5: see stage5.h. DO NOT EDIT. */
#include "stage5.h"

#include <float.h>
#include <math.h>
#include <stddef.h>

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
#define STAGE5_DEADBEAT 5.5 /* 11/2, samples to go at which deadbeat takes over */
#define STAGE5_C_5 2.0 /* weight of u1 in the law */
#define STAGE5_B_5 (-4.0) /* weight of u1 in the law */
#define STAGE5_B_6 (-10.0) /* weight of u2 in the law */

ptc_status stage5_init(stage5 *self, const stage5_params *params)
{
    ptc_status status = PTC_E_PARAM;

    if ((self != NULL) && (params != NULL)) {
        if ((params->samples > 5U)
            && (1e-150 <= params->h)
            && (params->h <= 1e150)
            && (params->u_max > 0.0)
            && (1e-150 <= params->a)
            && (params->a <= 1e150)
            && PTC_FINITE_F64(params->k[0])
            && PTC_FINITE_F64(params->k[1])
            && PTC_FINITE_F64(params->k[2])
            && PTC_FINITE_F64(params->k[3])
            && PTC_FINITE_F64(params->k[4])
            && PTC_FINITE_F64(params->k[5])
            && PTC_FINITE_F64(params->deadbeat)
            && (params->deadbeat >= 0.0)) {
            const uint32_t samples = params->samples;
            const double hold = 0.01 / params->h;
            const double s1 = params->a * params->a * params->a * params->a * params->a;
            const double s2 = 1.0 / (params->h * params->h * params->h * params->h);
            const double w1_1 = (-(params->k[0] / (s1 * params->a))) * s2;
            const double s3 = params->a * params->a * params->a * params->a * params->a;
            const double s4 = (-1.5) * (-(params->k[0] / (s3 * params->a)));
            const double w1_2 = s4 * (1.0 / (params->h * params->h * params->h));
            const double s5 = params->a * params->a * params->a * params->a * params->a;
            const double s6 = 0.9166666666666666 * (-(params->k[0] / (s5 * params->a)));
            const double w1_3 = s6 * (1.0 / (params->h * params->h));
            const double s7 = params->a * params->a * params->a * params->a * params->a;
            const double w1_4 = (-0.25) * (-(params->k[0] / (s7 * params->a))) * (1.0 / params->h);
            const double s8 = params->a * params->a * params->a * params->a * params->a;
            const double s9 = params->a * params->a * params->a * params->a;
            const double s10 = params->k[3] / (params->a * params->a * params->a);
            const double s11 = ((1.0 - (params->k[1] / s8)) + (params->k[2] / s9)) - s10;
            const double s12 = s11 + (params->k[4] / (params->a * params->a));
            const double s13 = 1.0 / (params->h * params->h * params->h);
            const double w2_2 = (s12 - (params->k[5] / params->a)) * s13;
            const double s14 = params->a * params->a * params->a * params->a * params->a;
            const double s15 = params->a * params->a * params->a * params->a;
            const double s16 = params->k[3] / (params->a * params->a * params->a);
            const double s17 = ((1.0 - (params->k[1] / s14)) + (params->k[2] / s15)) - s16;
            const double s18 = s17 + (params->k[4] / (params->a * params->a));
            const double s19 = -(s18 - (params->k[5] / params->a));
            const double w2_3 = s19 * (1.0 / (params->h * params->h));
            const double s20 = params->a * params->a * params->a * params->a * params->a;
            const double s21 = params->a * params->a * params->a * params->a;
            const double s22 = params->k[3] / (params->a * params->a * params->a);
            const double s23 = ((1.0 - (params->k[1] / s20)) + (params->k[2] / s21)) - s22;
            const double s24 = s23 + (params->k[4] / (params->a * params->a));
            const double s25 = 0.3333333333333333 * (s24 - (params->k[5] / params->a));
            const double w2_4 = s25 * (1.0 / params->h);
            const double s26 = params->a * params->a * params->a * params->a;
            const double s27 = 3.0 * (params->k[3] / (params->a * params->a * params->a));
            const double s28 = 7.0 * (params->k[4] / (params->a * params->a));
            const double s29 = (((-31.0) - (params->k[2] / s26)) + s27) - s28;
            const double s30 = s29 + (15.0 * (params->k[5] / params->a));
            const double w3_3 = s30 * (1.0 / (params->h * params->h));
            const double s31 = params->a * params->a * params->a * params->a;
            const double s32 = 3.0 * (params->k[3] / (params->a * params->a * params->a));
            const double s33 = 7.0 * (params->k[4] / (params->a * params->a));
            const double s34 = (((-31.0) - (params->k[2] / s31)) + s32) - s33;
            const double s35 = (-0.5) * (s34 + (15.0 * (params->k[5] / params->a)));
            const double w3_4 = s35 * (1.0 / params->h);
            const double s36 = 90.0 - (params->k[3] / (params->a * params->a * params->a));
            const double s37 = s36 + (6.0 * (params->k[4] / (params->a * params->a)));
            const double w4_4 = (s37 - (25.0 * (params->k[5] / params->a))) * (1.0 / params->h);
            const double s38 = (-65.0) - (params->k[4] / (params->a * params->a));
            const double w5_6 = s38 + (10.0 * (params->k[5] / params->a));
            const double w6_5 = 15.0 - (params->k[5] / params->a);
            const double w6_6 = -(15.0 - (params->k[5] / params->a));
            const double b_1 = -(1.0 / (params->h * params->h * params->h * params->h));
            const double b_2 = (-4.5) * (1.0 / (params->h * params->h * params->h));
            const double b_3 = (-9.916666666666666) * (1.0 / (params->h * params->h));
            const double b_4 = (-14.25) * (1.0 / params->h);
            const double u_max = params->u_max;
            if (PTC_FINITE_F64(hold)
                && PTC_FINITE_F64(w1_1)
                && PTC_FINITE_F64(w1_2)
                && PTC_FINITE_F64(w1_3)
                && PTC_FINITE_F64(w1_4)
                && PTC_FINITE_F64(w2_2)
                && PTC_FINITE_F64(w2_3)
                && PTC_FINITE_F64(w2_4)
                && PTC_FINITE_F64(w3_3)
                && PTC_FINITE_F64(w3_4)
                && PTC_FINITE_F64(w4_4)
                && PTC_FINITE_F64(w5_6)
                && PTC_FINITE_F64(w6_5)
                && PTC_FINITE_F64(w6_6)
                && PTC_FINITE_F64(b_1)
                && PTC_FINITE_F64(b_2)
                && PTC_FINITE_F64(b_3)
                && PTC_FINITE_F64(b_4)
                && (params->h * params->h * params->h * params->h >= 1e-200)
                && (1.0 / (params->h * params->h * params->h * params->h) >= 1e-200)) {
                self->start = 0U;
                self->samples = samples;
                self->u1 = 0.0;
                self->u2 = 0.0;
                self->hold = hold;
                self->w1_1 = w1_1;
                self->w1_2 = w1_2;
                self->w1_3 = w1_3;
                self->w1_4 = w1_4;
                self->w2_2 = w2_2;
                self->w2_3 = w2_3;
                self->w2_4 = w2_4;
                self->w3_3 = w3_3;
                self->w3_4 = w3_4;
                self->w4_4 = w4_4;
                self->w5_6 = w5_6;
                self->w6_5 = w6_5;
                self->w6_6 = w6_6;
                self->b_1 = b_1;
                self->b_2 = b_2;
                self->b_3 = b_3;
                self->b_4 = b_4;
                self->u_max = u_max;
                status = PTC_OK;
            }
        }
    }
    return status;
}

ptc_status stage5_arm(stage5 *self, uint32_t k)
{
    ptc_status status = PTC_OK;

    self->start = k;
    status = PTC_OK;
    return status;
}

ptc_status stage5_step(stage5 *self, uint32_t k, const double x[4], double *u)
{
    ptc_status status = PTC_OK;

    *u = 0.0;
    const uint32_t elapsed = k - self->start;
    const double x1 = x[0];
    const double x2 = x[1];
    const double x3 = x[2];
    const double x4 = x[3];
    const uint32_t left = (elapsed < self->samples) ? (self->samples - elapsed) : 0U;
    const double m0 = ((double)left < self->hold) ? self->hold : (double)left;
    double v;
    if (m0 > STAGE5_DEADBEAT) {
        /* The exact law in samples. */
        const double s1 = (self->w1_1 * x1) + (self->w1_2 * x2) + (self->w1_3 * x3);
        const double z1 = s1 + (self->w1_4 * x4);
        const double z2 = (self->w2_2 * x2) + (self->w2_3 * x3) + (self->w2_4 * x4);
        const double z3 = (self->w3_3 * x3) + (self->w3_4 * x4);
        const double z4 = self->w4_4 * x4;
        const double z5 = self->w5_6 * self->u2;
        const double z6 = (self->w6_5 * self->u1) + (self->w6_6 * self->u2);
        const double m0f2 = m0 * (m0 - 1.0);
        const double m0f3 = m0f2 * (m0 - 2.0);
        const double m0f4 = m0f3 * (m0 - 3.0);
        const double m0f5 = m0f4 * (m0 - 4.0);
        const double s2 = z1 + (z2 * m0) + (z3 * m0f2) + (z4 * m0f3) + (z5 * m0f4);
        const double s3 = (s2 + (z6 * m0f5)) / (m0f5 * (m0 - 5.0));
        v = s3 + ((STAGE5_C_5 * self->u1) - self->u2);
    } else {
        /* Deadbeat. */
        const double s4 = (self->b_1 * x1) + (self->b_2 * x2) + (self->b_3 * x3);
        const double s5 = s4 + (self->b_4 * x4) + (STAGE5_B_5 * self->u1);
        v = s5 + (STAGE5_B_6 * self->u2);
    }
    status = PTC_E_RANGE;
    if (PTC_FINITE_F64(v)) {
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
        *u = u_now;
        if ((v > self->u_max) || (v < -self->u_max)) {
            status = PTC_SATURATED;
        } else if ((double)left <= self->hold) {
            status = PTC_HOLD;
        } else {
            status = PTC_OK;
        }
    }
    return status;
}
