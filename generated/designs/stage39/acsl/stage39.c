/* Prescribed-time controller stage39: see stage39.h. DO NOT EDIT. */
#include "stage39.h"

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
#define STAGE39_U_MIN 0.3333333333333333 /* 1/3, lower limit of u */

ptc_status stage39_init(stage39 *self, const stage39_params *params)
{
    ptc_status status = PTC_E_PARAM;

    if ((self != NULL) && (params != NULL)) {
        if ((params->samples > 0U)
            && (1e-150 <= params->h)
            && (params->h <= 1e150)
            && (1e-150 <= params->a)
            && (params->a <= 1e150)
            && PTC_FINITE_F64(params->k[0])
            && PTC_FINITE_F64(params->deadbeat)
            && (params->deadbeat >= 0.0)
            && (params->u_max > 0.3333333333333333)) {
            const uint32_t samples = params->samples;
            const double s1 = (params->k[0] / params->a) + 1.0;
            const double s2 = (s1 < 2.0) ? 2.0 : s1;
            const double deadbeat = (params->deadbeat > 0.0) ? params->deadbeat : s2;
            const double w1_1 = (-(params->k[0] / params->a)) * (1.0 / params->h);
            const double b_1 = -(1.0 / params->h);
            const double u_max = params->u_max;
            if (PTC_FINITE_F64(deadbeat)
                && PTC_FINITE_F64(w1_1)
                && PTC_FINITE_F64(b_1)
                && (params->h >= 1e-200)
                && (1.0 / params->h >= 1e-200)) {
                self->start = 0U;
                self->samples = samples;
                self->deadbeat = deadbeat;
                self->w1_1 = w1_1;
                self->b_1 = b_1;
                self->u_max = u_max;
                status = PTC_OK;
            }
        }
    }
    return status;
}

ptc_status stage39_arm(stage39 *self, uint32_t k)
{
    ptc_status status = PTC_OK;

    self->start = k;
    status = PTC_OK;
    return status;
}

ptc_status stage39_step(const stage39 *self, uint32_t k, const double x[1], double *u)
{
    ptc_status status = PTC_OK;

    const uint32_t elapsed = k - self->start;
    const double x1 = x[0];
    const uint32_t left = (elapsed < self->samples) ? (self->samples - elapsed) : 0U;
    const double m0 = (double)left;
    double v;
    if (m0 > self->deadbeat) {
        /* The exact law in samples. */
        const double z1 = self->w1_1 * x1;
        v = z1 / m0;
    } else {
        /* Deadbeat. */
        v = self->b_1 * x1;
    }
    if (PTC_FINITE_F64(v)) {
        if (v > self->u_max) {
            *u = self->u_max;
            status = PTC_SATURATED;
        } else if (v < STAGE39_U_MIN) {
            *u = STAGE39_U_MIN;
            status = PTC_SATURATED;
        } else if (elapsed < self->samples) {
            *u = v;
            status = PTC_OK;
        } else {
            *u = v;
            status = PTC_HOLD;
        }
    } else {
        *u = 0.0;
        status = PTC_E_RANGE;
    }
    return status;
}
