/* Prescribed-time controller stage34: see stage34.h. DO NOT EDIT. */
#include "stage34.h"

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

ptc_status stage34_init(stage34 *self, const stage34_params *params)
{
    ptc_status status = PTC_E_PARAM;

    if ((self != NULL) && (params != NULL)) {
        if ((params->samples > 2U)
            && (1e-150 <= params->h)
            && (params->h <= 1e150)
            && (params->u_max > 0.0)
            && (1e-150 <= params->a)
            && (params->a <= 1e150)
            && PTC_FINITE_F64(params->k[0])
            && PTC_FINITE_F64(params->k[1])
            && PTC_FINITE_F64(params->k[2])
            && PTC_FINITE_F64(params->deadbeat)
            && (params->deadbeat >= 0.0)) {
            const uint32_t samples = params->samples;
            const double s1 = ((params->k[2] / params->a) - 4.0) + 3.0;
            const double s2 = (s1 < 6.0) ? 6.0 : s1;
            const double deadbeat_1 = (params->deadbeat > 0.0) ? params->deadbeat : s2;
            const double s3 = -(params->k[0] / (params->a * params->a * params->a));
            const double s4 = 1.0 / (params->h * params->h * params->h);
            const double w1_1_1 = 0.3333333333333333 * s3 * s4;
            const double s5 = -(params->k[0] / (params->a * params->a * params->a));
            const double w1_2_1 = (-0.3333333333333333) * s5 * (1.0 / (params->h * params->h));
            const double s6 = -(params->k[0] / (params->a * params->a * params->a));
            const double w1_3_1 = 0.1111111111111111 * s6 * (1.0 / params->h);
            const double s7 = (-1.0) - (params->k[1] / (params->a * params->a));
            const double s8 = 0.3333333333333333 * (s7 + (params->k[2] / params->a));
            const double w2_2_1 = s8 * (1.0 / (params->h * params->h));
            const double s9 = (-1.0) - (params->k[1] / (params->a * params->a));
            const double s10 = (-0.16666666666666666) * (s9 + (params->k[2] / params->a));
            const double w2_3_1 = s10 * (1.0 / params->h);
            const double s11 = 0.3333333333333333 * (3.0 - (params->k[2] / params->a));
            const double w3_3_1 = s11 * (1.0 / params->h);
            const double s12 = 1.0 / (params->h * params->h * params->h);
            const double b_1_1 = (-0.3333333333333333) * s12;
            const double b_2_1 = (-0.6666666666666666) * (1.0 / (params->h * params->h));
            const double b_3_1 = (-0.6111111111111112) * (1.0 / params->h);
            const double u_max = params->u_max;
            if (PTC_FINITE_F64(deadbeat_1)
                && PTC_FINITE_F64(w1_1_1)
                && PTC_FINITE_F64(w1_2_1)
                && PTC_FINITE_F64(w1_3_1)
                && PTC_FINITE_F64(w2_2_1)
                && PTC_FINITE_F64(w2_3_1)
                && PTC_FINITE_F64(w3_3_1)
                && PTC_FINITE_F64(b_1_1)
                && PTC_FINITE_F64(b_2_1)
                && PTC_FINITE_F64(b_3_1)
                && (params->h * params->h * params->h >= 1e-200)
                && (1.0 / (params->h * params->h * params->h) >= 1e-200)) {
                self->start = 0U;
                self->samples = samples;
                self->deadbeat_1 = deadbeat_1;
                self->w1_1_1 = w1_1_1;
                self->w1_2_1 = w1_2_1;
                self->w1_3_1 = w1_3_1;
                self->w2_2_1 = w2_2_1;
                self->w2_3_1 = w2_3_1;
                self->w3_3_1 = w3_3_1;
                self->b_1_1 = b_1_1;
                self->b_2_1 = b_2_1;
                self->b_3_1 = b_3_1;
                self->u_max = u_max;
                status = PTC_OK;
            }
        }
    }
    return status;
}

ptc_status stage34_arm(stage34 *self, uint32_t k)
{
    ptc_status status = PTC_OK;

    self->start = k;
    status = PTC_OK;
    return status;
}

ptc_status stage34_step(
    const stage34 *self,
    uint32_t k,
    const double x[2][3],
    const double r[2][4],
    double u[2],
    ptc_status axes[2])
{
    ptc_status status = PTC_OK;

    const uint32_t elapsed = k - self->start;
    const double x1_1 = x[0][0];
    const double x2_1 = x[0][1];
    const double x3_1 = x[0][2];
    const double x1_2 = x[1][0];
    const double x2_2 = x[1][1];
    const double x3_2 = x[1][2];

    /* The tracking error. */
    const double e1_1 = x1_1 - r[0][0];
    const double e2_1 = x2_1 - r[0][1];
    const double e3_1 = x3_1 - r[0][2];
    const double e1_2 = x1_2 - r[1][0];
    const double e2_2 = x2_2 - r[1][1];
    const double e3_2 = x3_2 - r[1][2];
    const uint32_t left = (elapsed < self->samples) ? (self->samples - elapsed) : 0U;
    const double m0_1 = (double)left;
    double law_1;
    const double m0_2 = (double)left;
    double law_2;
    if (m0_1 > self->deadbeat_1) {
        /* The exact law in samples. */
        const double s1 = (self->w1_1_1 * e1_1) + (self->w1_2_1 * e2_1);
        const double z1_1 = s1 + (self->w1_3_1 * e3_1);
        const double z2_1 = (self->w2_2_1 * e2_1) + (self->w2_3_1 * e3_1);
        const double z3_1 = self->w3_3_1 * e3_1;
        const double m0f_12 = m0_1 * (m0_1 - 1.0);
        const double s2 = (z1_1 + (z2_1 * m0_1) + (z3_1 * m0f_12)) / (m0f_12 * (m0_1 - 2.0));
        law_1 = s2 + (0.3333333333333333 * r[0][3]);
    } else {
        /* Deadbeat. */
        const double s3 = (self->b_1_1 * e1_1) + (self->b_2_1 * e2_1);
        law_1 = s3 + (self->b_3_1 * e3_1) + (0.3333333333333333 * r[0][3]);
    }
    if (m0_2 > self->deadbeat_1) {
        /* The exact law in samples. */
        const double s4 = (self->w1_1_1 * e1_2) + (self->w1_2_1 * e2_2);
        const double z1_2 = s4 + (self->w1_3_1 * e3_2);
        const double z2_2 = (self->w2_2_1 * e2_2) + (self->w2_3_1 * e3_2);
        const double z3_2 = self->w3_3_1 * e3_2;
        const double m0f_22 = m0_2 * (m0_2 - 1.0);
        const double s5 = (z1_2 + (z2_2 * m0_2) + (z3_2 * m0f_22)) / (m0f_22 * (m0_2 - 2.0));
        law_2 = s5 + (0.3333333333333333 * r[1][3]);
    } else {
        /* Deadbeat. */
        const double s6 = (self->b_1_1 * e1_2) + (self->b_2_1 * e2_2);
        law_2 = s6 + (self->b_3_1 * e3_2) + (0.3333333333333333 * r[1][3]);
    }
    if (elapsed < self->samples) {
        status = PTC_OK;
    } else {
        status = PTC_HOLD;
    }
    if (PTC_FINITE_F64(law_1) && PTC_FINITE_F64(law_2)) {
        u[0] = law_1;
        axes[0] = status;
        u[1] = law_2;
        axes[1] = status;
        if (law_1 > self->u_max) {
            u[0] = self->u_max;
            axes[0] = PTC_SATURATED;
            status = PTC_SATURATED;
        } else if (law_1 < -self->u_max) {
            u[0] = -self->u_max;
            axes[0] = PTC_SATURATED;
            status = PTC_SATURATED;
        } else {
            /* neither */
        }
        if (law_2 > self->u_max) {
            u[1] = self->u_max;
            axes[1] = PTC_SATURATED;
            status = PTC_SATURATED;
        } else if (law_2 < -self->u_max) {
            u[1] = -self->u_max;
            axes[1] = PTC_SATURATED;
            status = PTC_SATURATED;
        } else {
            /* neither */
        }
    } else {
        u[0] = 0.0;
        if (PTC_FINITE_F64(law_1)) {
            axes[0] = status;
        } else {
            axes[0] = PTC_E_RANGE;
        }
        u[1] = 0.0;
        if (PTC_FINITE_F64(law_2)) {
            axes[1] = status;
        } else {
            axes[1] = PTC_E_RANGE;
        }
        status = PTC_E_RANGE;
    }
    return status;
}
