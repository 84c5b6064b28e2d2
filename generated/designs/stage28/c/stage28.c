/* Prescribed-time controller stage28: see stage28.h. DO NOT EDIT. */
#include "stage28.h"

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
#define STAGE28_DEADBEAT_1 9.0 /* samples to go at which deadbeat takes over */
#define STAGE28_DEADBEAT_2 9.0 /* samples to go at which deadbeat takes over */

ptc_status stage28_init(stage28 *self, const stage28_params *params)
{
    ptc_status status = PTC_E_PARAM;

    if ((self != NULL) && (params != NULL)) {
        if ((params->samples > 0U)
            && (1e-150 <= params->h)
            && (params->h <= 1e150)
            && (params->u_max > 0.0)
            && PTC_FINITE_F64(params->k)) {
            const uint32_t samples = params->samples;
            const double w1_1_1 = (-3.0) * (1.0 / params->h);
            const double b_1_1 = -(1.0 / params->h);
            const double w1_1_2 = (-4.5) * (1.0 / params->h);
            const double p_k = params->k;
            const double c1 = -p_k;
            const double u_max = params->u_max;
            if (PTC_FINITE_F64(w1_1_1)
                && PTC_FINITE_F64(b_1_1)
                && PTC_FINITE_F64(w1_1_2)
                && PTC_FINITE_F64(c1)
                && (params->h >= 1e-200)
                && (1.0 / params->h >= 1e-200)) {
                self->start = 0U;
                self->samples = samples;
                self->w1_1_1 = w1_1_1;
                self->b_1_1 = b_1_1;
                self->w1_1_2 = w1_1_2;
                self->p_k = p_k;
                self->c1 = c1;
                self->u_max = u_max;
                status = PTC_OK;
            }
        }
    }
    return status;
}

ptc_status stage28_arm(stage28 *self, uint32_t k)
{
    ptc_status status = PTC_E_INPUT;

    if (self != NULL) {
        self->start = k;
        status = PTC_OK;
    }
    return status;
}

ptc_status stage28_step(
    const stage28 *self,
    uint32_t k,
    const double x[2],
    double u[2],
    ptc_status axes[2])
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (x != NULL) && (u != NULL) && (axes != NULL)) {
        if (PTC_FINITE_F64(x[0]) && PTC_FINITE_F64(x[1])) {
            const uint32_t elapsed = k - self->start;

            /* The chain of each output. */
            const double x1_1 = x[0];
            const double x1_2 = x[1];
            const uint32_t left = (elapsed < self->samples) ? (self->samples - elapsed) : 0U;
            const double m0_1 = (double)left;
            double law_1;
            const double m0_2 = (double)left;
            double law_2;
            if (m0_1 > STAGE28_DEADBEAT_1) {
                /* The exact law in samples. */
                const double z1_1 = self->w1_1_1 * x1_1;
                law_1 = z1_1 / m0_1;
            } else {
                /* Deadbeat. */
                law_1 = self->b_1_1 * x1_1;
            }
            if (m0_2 > STAGE28_DEADBEAT_2) {
                /* The exact law in samples. */
                const double z1_2 = self->w1_1_2 * x1_2;
                law_2 = z1_2 / m0_2;
            } else {
                /* Deadbeat. */
                law_2 = self->b_1_1 * x1_2;
            }

            /* The inputs that give all of them. */
            const double v2 = x1_2 - 1.0;
            const double v3 = 1.0 / (((v2 < 0.0) || (v2 > 0.0)) ? v2 : (double)NAN);
            const double control1 = law_1 * v3;
            const double control2 = ((-law_1) + (v2 * (law_2 - (self->c1 * x1_1)))) * v3;
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
                if (control1 > self->u_max) {
                    u[0] = self->u_max;
                    axes[0] = PTC_SATURATED;
                    status = PTC_SATURATED;
                } else if (control1 < -self->u_max) {
                    u[0] = -self->u_max;
                    axes[0] = PTC_SATURATED;
                    status = PTC_SATURATED;
                } else {
                    /* neither */
                }
                if (control2 > self->u_max) {
                    u[1] = self->u_max;
                    axes[1] = PTC_SATURATED;
                    status = PTC_SATURATED;
                } else if (control2 < -self->u_max) {
                    u[1] = -self->u_max;
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
