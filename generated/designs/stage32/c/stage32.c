/* Prescribed-time controller stage32: see stage32.h. DO NOT EDIT. */
#include "stage32.h"

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
#define STAGE32_H 0.01 /* 1/100, sample period */
#define STAGE32_SAMPLES 30U /* samples from the start to rest */
#define STAGE32_HOLD 4.0 /* samples to go at which the gains are held */

ptc_status stage32_init(stage32 *self, const stage32_params *params)
{
    ptc_status status = PTC_E_PARAM;

    if ((self != NULL) && (params != NULL)) {
        if ((params->u_max > 0.0)
            && (1e-150 <= params->a)
            && (params->a <= 1e150)
            && PTC_FINITE_F64(params->k[0])
            && PTC_FINITE_F64(params->k[1])
            && PTC_FINITE_F64(params->deadbeat)
            && (params->deadbeat >= 0.0)
            && PTC_FINITE_F64(params->m)
            && PTC_FINITE_F64(params->size)) {
            const double p_size = params->size;
            const double c_r3 = 2.0 * p_size;
            const double w1_1_1 = 10000.0 * (-(params->k[0] / (params->a * params->a)));
            const double w1_2_1 = 100.0 * ((-0.5) * (-(params->k[0] / (params->a * params->a))));
            const double w2_2_1 = 100.0 * (1.0 - (params->k[1] / params->a));
            const double p_m = params->m;
            const double u_max = params->u_max;
            if (PTC_FINITE_F64(c_r3)
                && PTC_FINITE_F64(w1_1_1)
                && PTC_FINITE_F64(w1_2_1)
                && PTC_FINITE_F64(w2_2_1)) {
                self->start = 0U;
                self->p_size = p_size;
                self->c_r3 = c_r3;
                self->w1_1_1 = w1_1_1;
                self->w1_2_1 = w1_2_1;
                self->w2_2_1 = w2_2_1;
                self->p_m = p_m;
                self->u_max = u_max;
                status = PTC_OK;
            }
        }
    }
    return status;
}

ptc_status stage32_arm(stage32 *self, uint32_t k)
{
    ptc_status status = PTC_E_INPUT;

    if (self != NULL) {
        self->start = k;
        status = PTC_OK;
    }
    return status;
}

ptc_status stage32_step(
    const stage32 *self,
    uint32_t k,
    const double x[4],
    double u[2],
    ptc_status axes[2])
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (x != NULL) && (u != NULL) && (axes != NULL)) {
        if (PTC_FINITE_F64(x[0])
            && PTC_FINITE_F64(x[1])
            && PTC_FINITE_F64(x[2])
            && PTC_FINITE_F64(x[3])) {
            const uint32_t elapsed = k - self->start;

            /* The chain of each output. */
            const double x1_1 = x[0];
            const double x2_1 = x[2];
            const double x1_2 = x[1];
            const double x2_2 = x[3];

            /* The tracking error. */
            const double t = ((double)elapsed) * STAGE32_H;
            const double v_r1 = t * t;
            const double v_r2 = 1.0 + v_r1;
            const double reference0_1 = (self->p_size * v_r1) / v_r2;
            const double reference1_1 = (self->c_r3 * t * (v_r2 - v_r1)) / (v_r2 * v_r2);
            const double v_r4 = t + 0.005;
            const double v_r5 = v_r4 * v_r4;
            const double v_r6 = 1.0 + v_r5;
            const double v_r7 = v_r6 * v_r6;
            const double s1 = (v_r7 + (4.0 * v_r5 * v_r5)) - (4.0 * v_r6 * v_r4 * v_r4);
            const double rho0_1 = (self->c_r3 * (s1 - (v_r6 * v_r5))) / (v_r6 * v_r7);
            const double e1_1 = x1_1 - reference0_1;
            const double e2_1 = x2_1 - reference1_1;
            const double e1_2 = x1_2;
            const double e2_2 = x2_2;
            const uint32_t left = (elapsed < STAGE32_SAMPLES) ? (STAGE32_SAMPLES - elapsed) : 0U;
            const double m0_1 = ((double)left < STAGE32_HOLD) ? STAGE32_HOLD : (double)left;
            double law_1;

            /* The exact law in samples. */
            const double z1_1 = (self->w1_1_1 * e1_1) + (self->w1_2_1 * e2_1);
            const double z2_1 = self->w2_2_1 * e2_1;
            law_1 = ((z1_1 + (z2_1 * m0_1)) / (m0_1 * (m0_1 - 1.0))) + rho0_1;
            const double m0_2 = ((double)left < STAGE32_HOLD) ? STAGE32_HOLD : (double)left;
            double law_2;
            const double z1_2 = (self->w1_1_1 * e1_2) + (self->w1_2_1 * e2_2);
            const double z2_2 = self->w2_2_1 * e2_2;
            law_2 = (z1_2 + (z2_2 * m0_2)) / (m0_2 * (m0_2 - 1.0));

            /* The inputs that give all of them. */
            const double s2 = ((self->p_m + (x1_2 * x1_2)) * law_1) + (x1_2 * law_2);
            const double control1 = s2 + (self->p_m * x1_2 * x2_1 * x2_2);
            const double control2 = (x1_2 * law_1) + law_2 + ((x2_1 * x2_1 * 0.5) - x1_1);
            if ((double)left > STAGE32_HOLD) {
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
