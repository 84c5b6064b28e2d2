/* Prescribed-time controller stage37: see stage37.h. DO NOT EDIT. */
#include "stage37.h"

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

ptc_status stage37_init(stage37 *self, const stage37_params *params)
{
    ptc_status status = PTC_E_PARAM;

    if ((self != NULL) && (params != NULL)) {
        if ((params->samples > 1U)
            && (1e-150 <= params->h)
            && (params->h <= 1e150)
            && (1e-150 <= params->a)
            && (params->a <= 1e150)
            && PTC_FINITE_F64(params->k[0])
            && PTC_FINITE_F64(params->k[1])
            && PTC_FINITE_F64(params->deadbeat)
            && (params->deadbeat >= 0.0)
            && (params->u_min < params->u_max)) {
            const uint32_t samples = params->samples;
            const double s1 = ((params->k[1] / params->a) - 1.0) + 2.0;
            const double s2 = (s1 < 4.0) ? 4.0 : s1;
            const double deadbeat = (params->deadbeat > 0.0) ? params->deadbeat : s2;
            const double s3 = -(params->k[0] / (params->a * params->a));
            const double w1_1 = s3 * (1.0 / (params->h * params->h));
            const double s4 = (-0.5) * (-(params->k[0] / (params->a * params->a)));
            const double w1_2 = s4 * (1.0 / params->h);
            const double w2_2 = (1.0 - (params->k[1] / params->a)) * (1.0 / params->h);
            const double b_1 = -(1.0 / (params->h * params->h));
            const double b_2 = (-1.5) * (1.0 / params->h);
            const double u_max = params->u_max;
            const double u_min = params->u_min;
            if (PTC_FINITE_F64(deadbeat)
                && PTC_FINITE_F64(w1_1)
                && PTC_FINITE_F64(w1_2)
                && PTC_FINITE_F64(w2_2)
                && PTC_FINITE_F64(b_1)
                && PTC_FINITE_F64(b_2)
                && (params->h * params->h >= 1e-200)
                && (1.0 / (params->h * params->h) >= 1e-200)) {
                self->start = 0U;
                self->samples = samples;
                self->deadbeat = deadbeat;
                self->w1_1 = w1_1;
                self->w1_2 = w1_2;
                self->w2_2 = w2_2;
                self->b_1 = b_1;
                self->b_2 = b_2;
                self->u_max = u_max;
                self->u_min = u_min;
                status = PTC_OK;
            }
        }
    }
    return status;
}

ptc_status stage37_arm(stage37 *self, uint32_t k)
{
    ptc_status status = PTC_E_INPUT;

    if (self != NULL) {
        self->start = k;
        status = PTC_OK;
    }
    return status;
}

ptc_status stage37_step(const stage37 *self, uint32_t k, const double x[2], double *u)
{
    ptc_status status = PTC_E_INPUT;

    if (u != NULL) {
        *u = 0.0;
    }
    if ((self != NULL) && (x != NULL) && (u != NULL)) {
        if (PTC_FINITE_F64(x[0]) && PTC_FINITE_F64(x[1])) {
            const uint32_t elapsed = k - self->start;
            const double x1 = x[0];
            const double x2 = x[1];
            const uint32_t left = (elapsed < self->samples) ? (self->samples - elapsed) : 0U;
            const double m0 = (double)left;
            double v;
            if (m0 > self->deadbeat) {
                /* The exact law in samples. */
                const double z1 = (self->w1_1 * x1) + (self->w1_2 * x2);
                const double z2 = self->w2_2 * x2;
                v = (z1 + (z2 * m0)) / (m0 * (m0 - 1.0));
            } else {
                /* Deadbeat. */
                v = (self->b_1 * x1) + (self->b_2 * x2);
            }
            if (PTC_FINITE_F64(v)) {
                if (v > self->u_max) {
                    *u = self->u_max;
                    status = PTC_SATURATED;
                } else if (v < self->u_min) {
                    *u = self->u_min;
                    status = PTC_SATURATED;
                } else if (elapsed < self->samples) {
                    *u = v;
                    status = PTC_OK;
                } else {
                    *u = v;
                    status = PTC_HOLD;
                }
            } else {
                status = PTC_E_RANGE;
            }
        }
    }
    return status;
}
