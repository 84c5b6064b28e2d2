/* Prescribed-time controller stage18: see stage18.h. DO NOT EDIT. */
#include "stage18.h"

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
#define STAGE18_W1_1 (-120000.0) /* weight of x1 in the law */
#define STAGE18_W1_2 600.0 /* weight of x2 in the law */
#define STAGE18_W2_2 (-600.0) /* weight of x2 in the law */
#define STAGE18_SAMPLES 30U /* samples from the start to rest */

ptc_status stage18_init(stage18 *self, const stage18_params *params)
{
    ptc_status status = PTC_E_PARAM;

    if ((self != NULL) && (params != NULL)) {
        if ((params->u_max > 0.0) && PTC_FINITE_F64(params->k)) {
            const double p_k = params->k;
            const double u_max = params->u_max;
            self->start = 0U;
            self->p_k = p_k;
            self->u_max = u_max;
            status = PTC_OK;
        }
    }
    return status;
}

ptc_status stage18_arm(stage18 *self, uint32_t k)
{
    ptc_status status = PTC_E_INPUT;

    if (self != NULL) {
        self->start = k;
        status = PTC_OK;
    }
    return status;
}

ptc_status stage18_step(const stage18 *self, uint32_t k, const double x[2], double *u)
{
    ptc_status status = PTC_E_INPUT;

    if (u != NULL) {
        *u = 0.0;
    }
    if ((self != NULL) && (x != NULL) && (u != NULL)) {
        if (PTC_FINITE_F64(x[0]) && PTC_FINITE_F64(x[1])) {
            const uint32_t elapsed = k - self->start;

            /* The chain of the output. */
            const double v1 = x[0] * x[0];
            const double v2 = x[0] * v1;
            const double x1 = x[0] + (v2 * 0.16666666666666666);
            const double v3 = 2.0 + v1;
            const double x2 = x[1] * v3 * 0.5;
            double w;

            /* The exact law in samples. */
            const double m0 = (elapsed < 26U) ? ((double)(30U - elapsed)) : 4.0;
            const double z1 = (STAGE18_W1_1 * x1) + (STAGE18_W1_2 * x2);
            const double z2 = STAGE18_W2_2 * x2;
            w = (z1 + (z2 * m0)) / (m0 * (m0 - 1.0));
            const double s1 = (-((self->p_k * v2) + (3.0 * x[1]))) * v3;
            const double v = (w - ((s1 + (x[1] * (2.0 * x[0] * x[1]))) * 0.5)) * 2.0;
            if (PTC_FINITE_F64(v)) {
                if (v > self->u_max) {
                    *u = self->u_max;
                    status = PTC_SATURATED;
                } else if (v < -self->u_max) {
                    *u = -self->u_max;
                    status = PTC_SATURATED;
                } else if (elapsed < STAGE18_SAMPLES) {
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
