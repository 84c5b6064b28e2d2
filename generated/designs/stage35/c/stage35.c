/* Prescribed-time controller stage35: see stage35.h. DO NOT EDIT. */
#include "stage35.h"

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
#define STAGE35_W1_1_1 (-120000.0) /* weight of x1 in the law */
#define STAGE35_W1_2_1 600.0 /* weight of x2 in the law */
#define STAGE35_W2_2_1 (-600.0) /* weight of x2 in the law */
#define STAGE35_W1_1_2 (-400.0) /* weight of x1 in the law */

ptc_status stage35_init(stage35 *self, const stage35_params *params)
{
    ptc_status status = PTC_E_PARAM;

    (void)params;
    if (self != NULL) {
        self->start = 0U;
        status = PTC_OK;
    }
    return status;
}

ptc_status stage35_arm(stage35 *self, uint32_t k)
{
    ptc_status status = PTC_E_INPUT;

    if (self != NULL) {
        self->start = k;
        status = PTC_OK;
    }
    return status;
}

ptc_status stage35_step(
    const stage35 *self,
    uint32_t k,
    const double x[3],
    double u[2],
    ptc_status axes[2])
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (x != NULL) && (u != NULL) && (axes != NULL)) {
        if (PTC_FINITE_F64(x[0]) && PTC_FINITE_F64(x[1]) && PTC_FINITE_F64(x[2])) {
            const uint32_t elapsed = k - self->start;

            /* The chain of each output as it is sampled. */
            const double x1_2 = x[2];
            const double s1 = x[0] + ((-4.16676736285295e-6) * x[1]);
            const double x1_1 = s1 + (2.499973960459077e-5 * x1_2);
            const double x2_1 = 1.0000166669696244 * x[1];
            double law_1;

            /* The exact law in samples. */
            const double m0_1 = (elapsed < 28U) ? ((double)(32U - elapsed)) : 4.0;
            const double z1_1 = (STAGE35_W1_1_1 * x1_1) + (STAGE35_W1_2_1 * x2_1);
            const double z2_1 = STAGE35_W2_2_1 * x2_1;
            law_1 = (z1_1 + (z2_1 * m0_1)) / (m0_1 * (m0_1 - 1.0));
            double law_2;
            const double m0_2 = (elapsed < 29U) ? ((double)(33U - elapsed)) : 4.0;
            const double z1_2 = STAGE35_W1_1_2 * x1_2;
            law_2 = z1_2 / m0_2;

            /* The inputs that give all of them. */
            const double s2 = ((-1.993127946172519) * x[0]) + ((-0.5087209499488312) * x[1]);
            const double v1 = law_1 - (s2 + (2.9333536080559304 * x1_2));
            const double s3 = (0.12252888444119461 * x[0]) + (0.0006157089861155933 * x[1]);
            const double v2 = law_2 - (s3 + ((-3.921049966023507) * x1_2));
            const double control1 = (1.002518807547881 * v1) + ((-0.015112747669367257) * v2);
            const double control2 = ((-2.106833310985952e-6) * v1) + (1.0201333455511812 * v2);
            if (elapsed < 30U) {
                status = PTC_OK;
            } else {
                status = PTC_HOLD;
            }
            if (PTC_FINITE_F64(control1) && PTC_FINITE_F64(control2)) {
                u[0] = control1;
                axes[0] = status;
                u[1] = control2;
                axes[1] = status;
                if (control1 > 20.0) {
                    u[0] = 20.0;
                    axes[0] = PTC_SATURATED;
                    status = PTC_SATURATED;
                } else if (control1 < -20.0) {
                    u[0] = -20.0;
                    axes[0] = PTC_SATURATED;
                    status = PTC_SATURATED;
                } else {
                    /* neither */
                }
                if (control2 > 30.0) {
                    u[1] = 30.0;
                    axes[1] = PTC_SATURATED;
                    status = PTC_SATURATED;
                } else if (control2 < -30.0) {
                    u[1] = -30.0;
                    axes[1] = PTC_SATURATED;
                    status = PTC_SATURATED;
                } else {
                    /* neither */
                }
            } else {
                u[0] = 0.0;
                if (PTC_FINITE_F64(control1)) {
                    axes[0] = status;
                } else {
                    axes[0] = PTC_E_RANGE;
                }
                u[1] = 0.0;
                if (PTC_FINITE_F64(control2)) {
                    axes[1] = status;
                } else {
                    axes[1] = PTC_E_RANGE;
                }
                status = PTC_E_RANGE;
            }
        } else {
            for (uint32_t i = 0U; i < 2U; i++) {
                u[i] = 0.0;
                axes[i] = PTC_E_INPUT;
            }
        }
    } else {
        if (u != NULL) {
            for (uint32_t i = 0U; i < 2U; i++) {
                u[i] = 0.0;
            }
        }
        if (axes != NULL) {
            for (uint32_t i = 0U; i < 2U; i++) {
                axes[i] = PTC_E_INPUT;
            }
        }
    }
    return status;
}
