/* Prescribed-time controller stage27: see stage27.h. DO NOT EDIT. */
#include "stage27.h"

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
#define STAGE27_END_SAMPLES_2 6.0 /* samples to go at which the law of the end takes over */
#define STAGE27_END_SAMPLES_3 7.0 /* samples to go at which the law of the end takes over */
#define STAGE27_END_SAMPLES_4 9.0 /* samples to go at which the law of the end takes over */

ptc_status stage27_init(stage27 *self, const stage27_params *params)
{
    ptc_status status = PTC_E_PARAM;

    if ((self != NULL) && (params != NULL)) {
        if ((params->samples > 1U) && (1e-150 <= params->h) && (params->h <= 1e150)) {
            const uint32_t samples = params->samples;
            const double w1_1_1 = (-5.0) * (1.0 / params->h);
            const double w1_1_2 = (-18.75) * (1.0 / (params->h * params->h));
            const double w1_2_2 = 9.375 * (1.0 / params->h);
            const double w2_2_2 = (-7.75) * (1.0 / params->h);
            const double end1_1_2 = (-20.0) * (1.0 / (params->h * params->h));
            const double end1_2_2 = 10.0 * (1.0 / params->h);
            const double end2_2_2 = (-8.0) * (1.0 / params->h);
            const double w1_1_3 = (-6.25) * (1.0 / params->h);
            const double end1_1_3 = (-7.0) * (1.0 / params->h);
            const double w1_1_4 = (-23.4375) * (1.0 / (params->h * params->h));
            const double w1_2_4 = 11.71875 * (1.0 / params->h);
            const double w2_2_4 = (-9.625) * (1.0 / params->h);
            if (PTC_FINITE_F64(w1_1_1)
                && PTC_FINITE_F64(w1_1_2)
                && PTC_FINITE_F64(w1_2_2)
                && PTC_FINITE_F64(w2_2_2)
                && PTC_FINITE_F64(end1_1_2)
                && PTC_FINITE_F64(end1_2_2)
                && PTC_FINITE_F64(end2_2_2)
                && PTC_FINITE_F64(w1_1_3)
                && PTC_FINITE_F64(end1_1_3)
                && PTC_FINITE_F64(w1_1_4)
                && PTC_FINITE_F64(w1_2_4)
                && PTC_FINITE_F64(w2_2_4)
                && (params->h * params->h >= 1e-200)
                && (1.0 / (params->h * params->h) >= 1e-200)) {
                self->start = 0U;
                self->samples = samples;
                self->w1_1_1 = w1_1_1;
                self->w1_1_2 = w1_1_2;
                self->w1_2_2 = w1_2_2;
                self->w2_2_2 = w2_2_2;
                self->end1_1_2 = end1_1_2;
                self->end1_2_2 = end1_2_2;
                self->end2_2_2 = end2_2_2;
                self->w1_1_3 = w1_1_3;
                self->end1_1_3 = end1_1_3;
                self->w1_1_4 = w1_1_4;
                self->w1_2_4 = w1_2_4;
                self->w2_2_4 = w2_2_4;
                status = PTC_OK;
            }
        }
    }
    return status;
}

/*
 * Solves a x = b, with a row by row, by elimination with the largest pivot of each column: b
 * becomes x, NaN where a is singular.
 */
static void stage27_eliminate(double b[4], double a[16])
{
    for (uint32_t k = 0U; k < 4U; k++) {
        uint32_t most = k;
        double largest = fabs(a[(4U * k) + k]);
        for (uint32_t i = k + 1U; i < 4U; i++) {
            const double size = fabs(a[(4U * i) + k]);
            if (largest < size) {
                largest = size;
                most = i;
            }
        }
        for (uint32_t i = k + 1U; i < 4U; i++) {
            if (most == i) {
                const double kept = b[k];
                b[k] = b[i];
                b[i] = kept;
                for (uint32_t j = k; j < 4U; j++) {
                    const double entry = a[(4U * k) + j];
                    a[(4U * k) + j] = a[(4U * i) + j];
                    a[(4U * i) + j] = entry;
                }
            }
        }
        a[(4U * k) + k] = ((a[(4U * k) + k] < 0.0) || (a[(4U * k) + k] > 0.0)) ? (a[(4U * k) + k]) : (double)NAN;
        for (uint32_t i = k + 1U; i < 4U; i++) {
            const double factor = a[(4U * i) + k] / a[(4U * k) + k];
            for (uint32_t j = k + 1U; j < 4U; j++) {
                a[(4U * i) + j] = a[(4U * i) + j] - (factor * a[(4U * k) + j]);
            }
            b[i] = b[i] - (factor * b[k]);
        }
    }
    for (uint32_t left = 4U; left > 0U; left--) {
        const uint32_t k = left - 1U;
        for (uint32_t j = k + 1U; j < 4U; j++) {
            b[k] = b[k] - (a[(4U * k) + j] * b[j]);
        }
        b[k] = b[k] / a[(4U * k) + k];
    }
}

ptc_status stage27_arm(stage27 *self, uint32_t k)
{
    ptc_status status = PTC_E_INPUT;

    if (self != NULL) {
        self->start = k;
        status = PTC_OK;
    }
    return status;
}

ptc_status stage27_step(
    const stage27 *self,
    uint32_t k,
    const double x[6],
    double u[4],
    ptc_status axes[4])
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (x != NULL) && (u != NULL) && (axes != NULL)) {
        if (PTC_FINITE_F64(x[0])
            && PTC_FINITE_F64(x[1])
            && PTC_FINITE_F64(x[2])
            && PTC_FINITE_F64(x[3])
            && PTC_FINITE_F64(x[4])
            && PTC_FINITE_F64(x[5])) {
            const uint32_t elapsed = k - self->start;

            /* The chain of each output. */
            const double x1_1 = x[0];
            const double x1_2 = x[1];
            const double x2_2 = x[2];
            const double x1_3 = x[3];
            const double x1_4 = x[4];
            const double x2_4 = x[5];
            const uint32_t left = (elapsed < self->samples) ? (self->samples - elapsed) : 0U;
            const double s1 = ((double)left) - 1.0;
            const double m0_1 = (s1 < 1.0) ? 1.0 : s1;
            double law_1;

            /* The exact law in samples. */
            const double z1_1 = self->w1_1_1 * x1_1;
            law_1 = z1_1 / (m0_1 + 4.0);
            const double m0_2 = ((double)left) - 2.0;
            double law_2;
            const double m0_3 = ((double)left) - 1.0;
            double law_3;
            const double m0_4 = ((double)left) - 2.0;
            double law_4;
            if (m0_2 > STAGE27_END_SAMPLES_2) {
                /* The exact law in samples. */
                const double z1_2 = (self->w1_1_2 * x1_2) + (self->w1_2_2 * x2_2);
                const double z2_2 = self->w2_2_2 * x2_2;
                law_2 = (z1_2 + (z2_2 * m0_2)) / (m0_2 * (m0_2 - 1.0));
            } else {
                /* The law of least energy to the end. */
                const double m1_2 = (m0_2 < 2.0) ? 2.0 : m0_2;
                const double y1_2 = (self->end1_1_2 * x1_2) + (self->end1_2_2 * x2_2);
                const double y2_2 = self->end2_2_2 * x2_2;
                const double m1f_21 = m1_2 + 3.0;
                law_2 = (y1_2 + (y2_2 * m1f_21)) / (m1f_21 * (m1_2 + 2.0));
            }
            if (m0_3 > STAGE27_END_SAMPLES_3) {
                /* The exact law in samples. */
                const double z1_3 = self->w1_1_3 * x1_3;
                law_3 = z1_3 / m0_3;
            } else {
                /* The law of least energy to the end. */
                const double m1_3 = (m0_3 < 1.0) ? 1.0 : m0_3;
                const double y1_3 = self->end1_1_3 * x1_3;
                law_3 = y1_3 / (m1_3 + 6.0);
            }
            if (m0_4 > STAGE27_END_SAMPLES_4) {
                /* The exact law in samples. */
                const double z1_4 = (self->w1_1_4 * x1_4) + (self->w1_2_4 * x2_4);
                const double z2_4 = self->w2_2_4 * x2_4;
                law_4 = (z1_4 + (z2_4 * m0_4)) / (m0_4 * (m0_4 - 1.0));
            } else {
                /* The law of least energy to the end. */
                const double m1_4 = (m0_4 < 2.0) ? 2.0 : m0_4;
                const double y1_4 = (self->end1_1_2 * x1_4) + (self->end1_2_2 * x2_4);
                const double y2_4 = self->end2_2_2 * x2_4;
                const double m1f_41 = m1_4 + 3.0;
                law_4 = (y1_4 + (y2_4 * m1f_41)) / (m1f_41 * (m1_4 + 2.0));
            }

            /* The inputs that give all of them. */
            double v1[4] = {
                law_1 - ((-x1_1) * x1_3),
                law_2 - ((-x1_2) * x2_4),
                law_3 - (-(x1_3 * x1_3)),
                law_4 - x1_1,
            };
            double v1_a[16] = {
                2.0 + (x1_2 * x1_2),
                1.0,
                0.0,
                0.0,
                0.0,
                3.0 + x1_1,
                x1_4,
                0.0,
                0.0,
                0.0,
                1.0,
                x1_1,
                x1_3,
                0.0,
                0.0,
                2.0 - x1_2,
            };
            stage27_eliminate(v1, v1_a);
            const double control1 = v1[0];
            const double control2 = v1[1];
            const double control3 = v1[2];
            const double control4 = v1[3];
            if (elapsed < self->samples) {
                status = PTC_OK;
            } else {
                status = PTC_HOLD;
            }
            if (PTC_FINITE_F64(control1)
                && PTC_FINITE_F64(control2)
                && PTC_FINITE_F64(control3)
                && PTC_FINITE_F64(control4)) {
                u[0] = control1;
                axes[0] = status;
                u[1] = control2;
                axes[1] = status;
                u[2] = control3;
                axes[2] = status;
                u[3] = control4;
                axes[3] = status;
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
                u[2] = 0.0;
                if (PTC_FINITE_F64(control3)) {
                    axes[2] = status;
                } else {
                    axes[2] = PTC_E_RANGE;
                }
                u[3] = 0.0;
                if (PTC_FINITE_F64(control4)) {
                    axes[3] = status;
                } else {
                    axes[3] = PTC_E_RANGE;
                }
                status = PTC_E_RANGE;
            }
        } else {
            for (uint32_t i = 0U; i < 4U; i++) {
                u[i] = 0.0;
                axes[i] = PTC_E_INPUT;
            }
        }
    } else {
        if (u != NULL) {
            for (uint32_t i = 0U; i < 4U; i++) {
                u[i] = 0.0;
            }
        }
        if (axes != NULL) {
            for (uint32_t i = 0U; i < 4U; i++) {
                axes[i] = PTC_E_INPUT;
            }
        }
    }
    return status;
}
