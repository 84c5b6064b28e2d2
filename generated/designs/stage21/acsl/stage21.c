/* Prescribed-time controller stage21: see stage21.h. DO NOT EDIT. */
#include "stage21.h"

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
#define STAGE21_B_4 (-0.5234375) /* -67/128, weight of u1 in the law */

ptc_status stage21_init(stage21 *self, const stage21_params *params)
{
    ptc_status status = PTC_E_PARAM;

    if ((self != NULL) && (params != NULL)) {
        if ((params->samples > 3U)
            && (1e-150 <= params->h)
            && (params->h <= 1e150)
            && (params->u_max > 0.0)
            && PTC_FINITE_F64(params->k[0])
            && PTC_FINITE_F64(params->k[1])
            && PTC_FINITE_F64(params->k[2])
            && PTC_FINITE_F64(params->k[3])
            && PTC_FINITE_F64(params->deadbeat)
            && (params->deadbeat >= 0.0)
            && PTC_FINITE_F64(params->size)) {
            const uint32_t samples = params->samples;
            const double h = params->h;
            const double p_size = params->size;
            const double c_r3 = 2.0 * p_size;
            const double c_r5 = 12.0 * p_size;
            const double c_r6 = 0.75 * h;
            const double c_r12 = (-0.25) * h;
            const double s1 = (params->k[3] - 9.0) + 4.0;
            const double s2 = (s1 < 8.0) ? 8.0 : s1;
            const double deadbeat = (params->deadbeat > 0.0) ? params->deadbeat : s2;
            const double s3 = 1.0 / (params->h * params->h * params->h);
            const double w1_1 = 0.5 * (-params->k[0]) * s3;
            const double w1_2 = (-0.875) * (-params->k[0]) * (1.0 / (params->h * params->h));
            const double w1_3 = 0.6822916666666666 * (-params->k[0]) * (1.0 / params->h);
            const double w1_4 = (-0.6015625) * (-params->k[0]);
            const double s4 = 0.5 * (((1.0 - params->k[1]) + params->k[2]) - params->k[3]);
            const double w2_2 = s4 * (1.0 / (params->h * params->h));
            const double s5 = (-0.625) * (((1.0 - params->k[1]) + params->k[2]) - params->k[3]);
            const double w2_3 = s5 * (1.0 / params->h);
            const double w2_4 = 0.65625 * (((1.0 - params->k[1]) + params->k[2]) - params->k[3]);
            const double s6 = 0.5 * (((-7.0) - params->k[2]) + (3.0 * params->k[3]));
            const double w3_3 = s6 * (1.0 / params->h);
            const double w3_4 = (-0.75) * (((-7.0) - params->k[2]) + (3.0 * params->k[3]));
            const double w4_4 = 6.0 - params->k[3];
            const double b_1 = (-0.5) * (1.0 / (params->h * params->h * params->h));
            const double b_2 = (-1.125) * (1.0 / (params->h * params->h));
            const double b_3 = (-1.1822916666666667) * (1.0 / params->h);
            const double u_max = params->u_max;
            if (PTC_FINITE_F64(c_r3)
                && PTC_FINITE_F64(c_r5)
                && PTC_FINITE_F64(c_r6)
                && PTC_FINITE_F64(c_r12)
                && PTC_FINITE_F64(deadbeat)
                && PTC_FINITE_F64(w1_1)
                && PTC_FINITE_F64(w1_2)
                && PTC_FINITE_F64(w1_3)
                && PTC_FINITE_F64(w1_4)
                && PTC_FINITE_F64(w2_2)
                && PTC_FINITE_F64(w2_3)
                && PTC_FINITE_F64(w2_4)
                && PTC_FINITE_F64(w3_3)
                && PTC_FINITE_F64(w3_4)
                && PTC_FINITE_F64(w4_4)
                && PTC_FINITE_F64(b_1)
                && PTC_FINITE_F64(b_2)
                && PTC_FINITE_F64(b_3)
                && (params->h * params->h * params->h >= 1e-200)
                && (1.0 / (params->h * params->h * params->h) >= 1e-200)) {
                self->start = 0U;
                self->samples = samples;
                self->u1 = 0.0;
                self->h = h;
                self->p_size = p_size;
                self->c_r3 = c_r3;
                self->c_r5 = c_r5;
                self->c_r6 = c_r6;
                self->c_r12 = c_r12;
                self->deadbeat = deadbeat;
                self->w1_1 = w1_1;
                self->w1_2 = w1_2;
                self->w1_3 = w1_3;
                self->w1_4 = w1_4;
                self->w2_2 = w2_2;
                self->w2_3 = w2_3;
                self->w2_4 = w2_4;
                self->w3_3 = w3_3;
                self->w3_4 = w3_4;
                self->w4_4 = w4_4;
                self->b_1 = b_1;
                self->b_2 = b_2;
                self->b_3 = b_3;
                self->u_max = u_max;
                status = PTC_OK;
            }
        }
    }
    return status;
}

ptc_status stage21_arm(stage21 *self, uint32_t k)
{
    ptc_status status = PTC_E_INPUT;

    if (self != NULL) {
        self->start = k;
        status = PTC_OK;
    }
    return status;
}

ptc_status stage21_step(stage21 *self, uint32_t k, const double x[3], double *u)
{
    ptc_status status = PTC_E_INPUT;

    if (u != NULL) {
        *u = 0.0;
    }
    if ((self != NULL) && (x != NULL) && (u != NULL)) {
        if (PTC_FINITE_F64(x[0]) && PTC_FINITE_F64(x[1]) && PTC_FINITE_F64(x[2])) {
            const uint32_t elapsed = k - self->start;
            const double x1 = x[0];
            const double x2 = x[1];
            const double x3 = x[2];

            /* The tracking error. */
            const double t = ((double)elapsed) * self->h;
            const double v_r1 = t * t;
            const double v_r2 = 1.0 + v_r1;
            const double reference0 = (self->p_size * v_r1) / v_r2;
            const double v_r4 = v_r2 * v_r2;
            const double reference1 = (self->c_r3 * t * (v_r2 - v_r1)) / v_r4;
            const double s1 = ((v_r4 + (4.0 * v_r1 * v_r1)) - (4.0 * v_r2 * t * t)) - (v_r2 * v_r1);
            const double reference2 = (self->c_r3 * s1) / (v_r2 * v_r4);
            const double v_r7 = t + self->c_r6;
            const double v_r8 = v_r7 * v_r7;
            const double v_r9 = 1.0 + v_r8;
            const double v_r10 = v_r9 * v_r9;
            const double v_r11 = v_r10 * v_r7;
            const double s2 = ((4.0 * v_r9 * v_r7 * v_r8) + (2.0 * v_r9 * v_r8 * v_r7)) - v_r11;
            const double s3 = self->c_r5 * ((s2 - v_r11) - (4.0 * v_r8 * (v_r7 * v_r8)));
            const double rho0 = s3 / (v_r10 * v_r10);
            const double v_r13 = t + self->c_r12;
            const double v_r14 = (v_r13 < 0.0) ? 0.0 : v_r13;
            const double v_r15 = v_r14 * v_r14;
            const double v_r16 = 1.0 + v_r15;
            const double v_r17 = v_r16 * v_r16;
            const double v_r18 = v_r17 * v_r14;
            const double s4 = (4.0 * v_r16 * v_r14 * v_r15) + (2.0 * v_r16 * v_r15 * v_r14);
            const double s5 = ((s4 - v_r18) - v_r18) - (4.0 * v_r15 * (v_r14 * v_r15));
            const double rho1 = (self->c_r5 * s5) / (v_r17 * v_r17);
            const double e1 = x1 - reference0;
            const double e2 = x2 - reference1;
            const double e3 = x3 - reference2;
            const uint32_t left = (elapsed < self->samples) ? (self->samples - elapsed) : 0U;
            const double m0 = (double)left;
            double v;
            if (m0 > self->deadbeat) {
                /* The exact law in samples. */
                const double s6 = (self->w1_1 * e1) + (self->w1_2 * e2) + (self->w1_3 * e3);
                const double z1 = s6 + (self->w1_4 * (self->u1 - (0.5 * rho1)));
                const double s7 = self->w2_4 * (self->u1 - (0.5 * rho1));
                const double z2 = (self->w2_2 * e2) + (self->w2_3 * e3) + s7;
                const double z3 = (self->w3_3 * e3) + (self->w3_4 * (self->u1 - (0.5 * rho1)));
                const double z4 = self->w4_4 * (self->u1 - (0.5 * rho1));
                const double m0f2 = m0 * (m0 - 1.0);
                const double m0f3 = m0f2 * (m0 - 2.0);
                const double s8 = (z1 + (z2 * m0) + (z3 * m0f2) + (z4 * m0f3)) / (m0f3 * (m0 - 3.0));
                v = s8 + (self->u1 - (0.5 * rho1)) + (0.5 * rho0);
            } else {
                /* Deadbeat. */
                const double s9 = (self->b_1 * e1) + (self->b_2 * e2) + (self->b_3 * e3);
                v = s9 + (STAGE21_B_4 * (self->u1 - (0.5 * rho1))) + (0.5 * rho0);
            }
            status = PTC_E_RANGE;
            if (PTC_FINITE_F64(v)) {
                double u_now;
                if (v > self->u_max) {
                    u_now = self->u_max;
                } else if (v < -self->u_max) {
                    u_now = -self->u_max;
                } else {
                    u_now = v;
                }
                self->u1 = u_now;
                *u = u_now;
                if ((v > self->u_max) || (v < -self->u_max)) {
                    status = PTC_SATURATED;
                } else if (elapsed < self->samples) {
                    status = PTC_OK;
                } else {
                    status = PTC_HOLD;
                }
            }
        }
    }
    return status;
}
