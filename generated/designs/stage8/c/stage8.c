/* Prescribed-time controller stage8: see stage8.h. DO NOT EDIT. */
#include "stage8.h"

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
#define STAGE8_SAMPLES 30U /* samples from the start to rest */
#define STAGE8_HOLD 5.0 /* samples to go at which the gains are held */
#define STAGE8_W1_1 (-20000000.0) /* weight of x1 in the law */
#define STAGE8_W1_2 10000.0 /* weight of x2 in the law */
#define STAGE8_W2_2 (-8000.0) /* weight of x2 in the law */
#define STAGE8_U_MAX 3.0 /* bound of |u| */

ptc_status stage8_init(stage8 *self, const stage8_params *params)
{
    ptc_status status = PTC_E_PARAM;

    (void)params;
    if (self != NULL) {
        self->start = 0U;
        status = PTC_OK;
    }
    return status;
}

ptc_status stage8_arm(stage8 *self, uint32_t k)
{
    ptc_status status = PTC_E_INPUT;

    if (self != NULL) {
        self->start = k;
        status = PTC_OK;
    }
    return status;
}

ptc_status stage8_step(const stage8 *self, uint32_t k, const double x[2], double *u)
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
            const uint32_t left = (elapsed < STAGE8_SAMPLES) ? (STAGE8_SAMPLES - elapsed) : 0U;
            const double m0 = ((double)left < STAGE8_HOLD) ? STAGE8_HOLD : (double)left;
            double v;

            /* The exact law in samples. */
            const double z1 = (STAGE8_W1_1 * x1) + (STAGE8_W1_2 * x2);
            const double z2 = STAGE8_W2_2 * x2;
            const double m0f1 = m0 + 3.0;
            v = (z1 + (z2 * m0f1)) / (m0f1 * (m0 + 2.0));
            if (PTC_FINITE_F64(v)) {
                if (elapsed < STAGE8_SAMPLES) {
                    if (v > STAGE8_U_MAX) {
                        *u = STAGE8_U_MAX;
                        status = PTC_SATURATED;
                    } else if (v < -STAGE8_U_MAX) {
                        *u = -STAGE8_U_MAX;
                        status = PTC_SATURATED;
                    } else if ((double)left <= STAGE8_HOLD) {
                        *u = v;
                        status = PTC_HOLD;
                    } else {
                        *u = v;
                        status = PTC_OK;
                    }
                } else {
                    *u = 0.0;
                    status = PTC_AFTER;
                }
            } else {
                status = PTC_E_RANGE;
            }
        }
    }
    return status;
}
