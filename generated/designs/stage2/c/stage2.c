/* Prescribed-time controller stage2: see stage2.h. DO NOT EDIT. */
#include "stage2.h"

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
#define STAGE2_W1_1 (-120000000000.0) /* weight of x1 in the law */
#define STAGE2_W1_2 120000000.0 /* weight of x2 in the law */
#define STAGE2_W1_3 (-40000.0) /* weight of x3 in the law */
#define STAGE2_W2_2 (-60000000.0) /* weight of x2 in the law */
#define STAGE2_W2_3 30000.0 /* weight of x3 in the law */
#define STAGE2_W3_3 (-12000.0) /* weight of x3 in the law */
#define STAGE2_SAMPLES 20U /* samples from the start to rest */

ptc_status stage2_init(stage2 *self, const stage2_params *params)
{
    ptc_status status = PTC_E_PARAM;

    (void)params;
    if (self != NULL) {
        self->start = 0U;
        status = PTC_OK;
    }
    return status;
}

ptc_status stage2_arm(stage2 *self, uint32_t k)
{
    ptc_status status = PTC_OK;

    self->start = k;
    status = PTC_OK;
    return status;
}

ptc_status stage2_step(const stage2 *self, uint32_t k, const double x[3], double *u)
{
    ptc_status status = PTC_OK;

    const uint32_t elapsed = k - self->start;
    const double x1 = x[0];
    const double x2 = x[1];
    const double x3 = x[2];
    double v;

    /* The exact law in samples. */
    const double m0 = (elapsed < 17U) ? ((double)(23U - elapsed)) : 6.0;
    const double z1 = (STAGE2_W1_1 * x1) + (STAGE2_W1_2 * x2) + (STAGE2_W1_3 * x3);
    const double z2 = (STAGE2_W2_2 * x2) + (STAGE2_W2_3 * x3);
    const double z3 = STAGE2_W3_3 * x3;
    const double m0f2 = m0 * (m0 - 1.0);
    v = (z1 + (z2 * m0) + (z3 * m0f2)) / (m0f2 * (m0 - 2.0));
    *u = v;
    if (PTC_FINITE_F64(v)) {
        if (!(elapsed < STAGE2_SAMPLES)) {
            status = PTC_HOLD;
        }
    } else {
        *u = 0.0;
        status = PTC_E_RANGE;
    }
    return status;
}
