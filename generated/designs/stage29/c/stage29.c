/* Prescribed-time controller stage29: see stage29.h. DO NOT EDIT. */
#include "stage29.h"

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
#define STAGE29_W1_1_1 (-400000.0) /* weight of x1 in the law */
#define STAGE29_W1_2_1 2000.0 /* weight of x2 in the law */
#define STAGE29_W2_2_1 (-1600.0) /* weight of x2 in the law */
#define STAGE29_W1_1_2 (-50000.0) /* weight of x1 in the law */
#define STAGE29_W1_2_2 250.0 /* weight of x2 in the law */
#define STAGE29_W2_2_2 (-250.0) /* weight of x2 in the law */
#define STAGE29_END1_1_2 (-60000.0) /* weight of x1 in the law */
#define STAGE29_END1_2_2 300.0 /* weight of x2 in the law */
#define STAGE29_END2_2_2 (-300.0) /* weight of x2 in the law */
#define STAGE29_W1_1_3 450000.0 /* weight of x1 in the law */
#define STAGE29_W1_2_3 (-2250.0) /* weight of x2 in the law */
#define STAGE29_W2_2_3 1250.0 /* weight of x2 in the law */
#define STAGE29_END1_1_3 420000.0 /* weight of x1 in the law */
#define STAGE29_END1_2_3 (-2100.0) /* weight of x2 in the law */
#define STAGE29_END2_2_3 1200.0 /* weight of x2 in the law */

ptc_status stage29_init(stage29 *self, const stage29_params *params)
{
    ptc_status status = PTC_E_PARAM;

    (void)params;
    if (self != NULL) {
        self->start = 0U;
        status = PTC_OK;
    }
    return status;
}

ptc_status stage29_arm(stage29 *self, uint32_t k)
{
    ptc_status status = PTC_E_INPUT;

    if (self != NULL) {
        self->start = k;
        status = PTC_OK;
    }
    return status;
}

ptc_status stage29_step(
    const stage29 *self,
    uint32_t k,
    const double x[3][2],
    double u[3],
    ptc_status axes[3])
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (x != NULL) && (u != NULL) && (axes != NULL)) {
        if (PTC_FINITE_F64(x[0][0])
            && PTC_FINITE_F64(x[0][1])
            && PTC_FINITE_F64(x[1][0])
            && PTC_FINITE_F64(x[1][1])
            && PTC_FINITE_F64(x[2][0])
            && PTC_FINITE_F64(x[2][1])) {
            const uint32_t elapsed = k - self->start;
            const double x1_1 = x[0][0];
            const double x2_1 = x[0][1];
            const double x1_2 = x[1][0];
            const double x2_2 = x[1][1];
            const double x1_3 = x[2][0];
            const double x2_3 = x[2][1];
            double law_1;

            /* The exact law in samples. */
            const double m0_1 = (elapsed < 28U) ? ((double)(33U - elapsed)) : 5.0;
            const double z1_1 = (STAGE29_W1_1_1 * x1_1) + (STAGE29_W1_2_1 * x2_1);
            const double z2_1 = STAGE29_W2_2_1 * x2_1;
            law_1 = (z1_1 + (z2_1 * m0_1)) / (m0_1 * (m0_1 - 1.0));
            double law_2;
            double law_3;
            if (elapsed < 26U) {
                /* The exact law in samples. */
                const double m0_2 = (double)(30U - elapsed);
                const double z1_2 = (STAGE29_W1_1_2 * x1_2) + (STAGE29_W1_2_2 * x2_2);
                const double z2_2 = STAGE29_W2_2_2 * x2_2;
                law_2 = (z1_2 + (z2_2 * m0_2)) / (m0_2 * (m0_2 - 1.0));
            } else {
                /* The law of least energy to the end. */
                const double m1_2 = (elapsed < 28U) ? ((double)(32U - elapsed)) : 4.0;
                const double y1_2 = (STAGE29_END1_1_2 * x1_2) + (STAGE29_END1_2_2 * x2_2);
                const double y2_2 = STAGE29_END2_2_2 * x2_2;
                law_2 = (y1_2 + (y2_2 * m1_2)) / (m1_2 * (m1_2 - 1.0));
            }
            if (elapsed < 21U) {
                /* The exact law in samples. */
                const double m0_3 = (double)(30U - elapsed);
                const double z1_3 = (STAGE29_W1_1_3 * x1_3) + (STAGE29_W1_2_3 * x2_3);
                const double z2_3 = STAGE29_W2_2_3 * x2_3;
                law_3 = (z1_3 + (z2_3 * m0_3)) / (m0_3 * (m0_3 - 1.0));
            } else {
                /* The law of least energy to the end. */
                const double m1_3 = (elapsed < 28U) ? ((double)(35U - elapsed)) : 7.0;
                const double y1_3 = (STAGE29_END1_1_3 * x1_3) + (STAGE29_END1_2_3 * x2_3);
                const double y2_3 = STAGE29_END2_2_3 * x2_3;
                law_3 = (y1_3 + (y2_3 * m1_3)) / (m1_3 * (m1_3 - 1.0));
            }
            if (elapsed < 30U) {
                status = PTC_OK;
            } else {
                status = PTC_HOLD;
            }
            if (PTC_FINITE_F64(law_1) && PTC_FINITE_F64(law_2) && PTC_FINITE_F64(law_3)) {
                u[0] = law_1;
                axes[0] = status;
                u[1] = law_2;
                axes[1] = status;
                u[2] = law_3;
                axes[2] = status;
                if (law_1 > 1.0) {
                    u[0] = 1.0;
                    axes[0] = PTC_SATURATED;
                    status = PTC_SATURATED;
                } else if (law_1 < -1.0) {
                    u[0] = -1.0;
                    axes[0] = PTC_SATURATED;
                    status = PTC_SATURATED;
                } else {
                    /* neither */
                }
                if (law_2 > 2.0) {
                    u[1] = 2.0;
                    axes[1] = PTC_SATURATED;
                    status = PTC_SATURATED;
                } else if (law_2 < -2.0) {
                    u[1] = -2.0;
                    axes[1] = PTC_SATURATED;
                    status = PTC_SATURATED;
                } else {
                    /* neither */
                }
                if (law_3 > 3.0) {
                    u[2] = 3.0;
                    axes[2] = PTC_SATURATED;
                    status = PTC_SATURATED;
                } else if (law_3 < -3.0) {
                    u[2] = -3.0;
                    axes[2] = PTC_SATURATED;
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
                u[2] = 0.0;
                if (PTC_FINITE_F64(law_3)) {
                    axes[2] = status;
                } else {
                    axes[2] = PTC_E_RANGE;
                }
                status = PTC_E_RANGE;
            }
        } else {
            for (uint32_t i = 0U; i < 3U; i++) {
                u[i] = 0.0;
                axes[i] = PTC_E_INPUT;
            }
        }
    } else {
        if (u != NULL) {
            for (uint32_t i = 0U; i < 3U; i++) {
                u[i] = 0.0;
            }
        }
        if (axes != NULL) {
            for (uint32_t i = 0U; i < 3U; i++) {
                axes[i] = PTC_E_INPUT;
            }
        }
    }
    return status;
}
