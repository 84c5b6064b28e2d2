/* Prescribed-time controller stage31: see stage31.h. DO NOT EDIT. */
#include "stage31.h"

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
#define STAGE31_END_SAMPLES_2 6.0 /* samples to go at which the law of the end takes over */

ptc_status stage31_init(stage31 *self, const stage31_params *params)
{
    ptc_status status = PTC_E_PARAM;

    if ((self != NULL) && (params != NULL)) {
        if ((params->samples > 1U) && (1e-150 <= params->h) && (params->h <= 1e150)) {
            const uint32_t samples = params->samples;
            const double w1_1_1 = (-4.0) * (1.0 / params->h);
            const double w1_1_2 = (-13.5) * (1.0 / (params->h * params->h));
            const double w1_2_2 = 6.75 * (1.0 / params->h);
            const double w2_2_2 = (-6.5) * (1.0 / params->h);
            const double end1_1_2 = (-12.0) * (1.0 / (params->h * params->h));
            const double end1_2_2 = 6.0 * (1.0 / params->h);
            const double end2_2_2 = (-6.0) * (1.0 / params->h);
            if (PTC_FINITE_F64(w1_1_1)
                && PTC_FINITE_F64(w1_1_2)
                && PTC_FINITE_F64(w1_2_2)
                && PTC_FINITE_F64(w2_2_2)
                && PTC_FINITE_F64(end1_1_2)
                && PTC_FINITE_F64(end1_2_2)
                && PTC_FINITE_F64(end2_2_2)
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
                status = PTC_OK;
            }
        }
    }
    return status;
}

ptc_status stage31_arm(stage31 *self, uint32_t k)
{
    ptc_status status = PTC_E_INPUT;

    if (self != NULL) {
        self->start = k;
        status = PTC_OK;
    }
    return status;
}

ptc_status stage31_step(
    const stage31 *self,
    uint32_t k,
    const double x[3],
    const double r[2][3],
    double u[2],
    ptc_status axes[2])
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (x != NULL) && (r != NULL) && (u != NULL) && (axes != NULL)) {
        if (PTC_FINITE_F64(x[0])
            && PTC_FINITE_F64(x[1])
            && PTC_FINITE_F64(x[2])
            && PTC_FINITE_F64(r[0][0])
            && PTC_FINITE_F64(r[0][1])
            && PTC_FINITE_F64(r[1][0])
            && PTC_FINITE_F64(r[1][1])
            && PTC_FINITE_F64(r[1][2])) {
            const uint32_t elapsed = k - self->start;

            /* The chain of each output. */
            const double x1_1 = x[0];
            const double x1_2 = x[2];
            const double v1 = x[1] - x1_2;
            const double v2 = 1.0 + x1_1;
            const double x2_2 = v1 * v2;

            /* The tracking error. */
            const double e1_1 = x1_1 - r[0][0];
            const double e1_2 = x1_2 - r[1][0];
            const double e2_2 = x2_2 - r[1][1];
            const uint32_t left = (elapsed < self->samples) ? (self->samples - elapsed) : 0U;
            const double s1 = ((double)left) - 1.0;
            const double m0_1 = (s1 < 1.0) ? 1.0 : s1;
            double law_1;

            /* The exact law in samples. */
            const double z1_1 = self->w1_1_1 * e1_1;
            law_1 = (z1_1 / (m0_1 + 3.0)) + r[0][1];
            const double m0_2 = ((double)left) - 2.0;
            double law_2;
            if (m0_2 > STAGE31_END_SAMPLES_2) {
                /* The exact law in samples. */
                const double z1_2 = (self->w1_1_2 * e1_2) + (self->w1_2_2 * e2_2);
                const double z2_2 = self->w2_2_2 * e2_2;
                law_2 = ((z1_2 + (z2_2 * m0_2)) / (m0_2 * (m0_2 - 1.0))) + r[1][2];
            } else {
                /* The law of least energy to the end. */
                const double m1_2 = (m0_2 < 2.0) ? 2.0 : m0_2;
                const double y1_2 = (self->end1_1_2 * e1_2) + (self->end1_2_2 * e2_2);
                const double y2_2 = self->end2_2_2 * e2_2;
                const double m1f_21 = m1_2 + 2.0;
                law_2 = ((y1_2 + (y2_2 * m1f_21)) / (m1f_21 * (m1_2 + 1.0))) + r[1][2];
            }

            /* The inputs that give all of them. */
            const double v3 = (-x1_1) * 0.1;
            const double v4 = law_1 - v3;
            const double v5 = 1.0 / (((v2 < 0.0) || (v2 > 0.0)) ? v2 : (double)NAN);
            const double control1 = v2 * v4 * v5;
            const double s2 = ((-v1) * v4) + (law_2 - (((((-x[1]) * v2) - x2_2) * v2) + (v1 * v3)));
            const double control2 = s2 * v5;
            if (elapsed < self->samples) {
                status = PTC_OK;
            } else {
                status = PTC_HOLD;
            }
            if (PTC_FINITE_F64(control1) && PTC_FINITE_F64(control2)) {
                u[0] = control1;
                axes[0] = status;
                u[1] = control2;
                axes[1] = status;
                if (control1 > 2.0) {
                    u[0] = 2.0;
                    axes[0] = PTC_SATURATED;
                    status = PTC_SATURATED;
                } else if (control1 < -2.0) {
                    u[0] = -2.0;
                    axes[0] = PTC_SATURATED;
                    status = PTC_SATURATED;
                } else {
                    /* neither */
                }
                if (control2 > 3.0) {
                    u[1] = 3.0;
                    axes[1] = PTC_SATURATED;
                    status = PTC_SATURATED;
                } else if (control2 < -3.0) {
                    u[1] = -3.0;
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
