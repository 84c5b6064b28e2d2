/* Prescribed-time controller stage12: see stage12.h. DO NOT EDIT. */
#include "stage12.h"

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
#define STAGE12_GAMMA1 0.00010816330676811052 /* prediction from u */
#define STAGE12_GAMMA2 0.30941358230147875 /* prediction from u */
#define STAGE12_GAMMA3 0.37459048481653323 /* prediction from u */
#define STAGE12_Q1_1_1 (-8.0) /* weight in the observer's gain l1_1 */
#define STAGE12_Q1_1_2 8.0 /* weight in the observer's gain l1_1 */
#define STAGE12_Q1_2_1 12007.013438558752 /* weight in the observer's gain l1_2 */
#define STAGE12_Q1_2_2 (-4.007472019404232) /* weight in the observer's gain l1_2 */
#define STAGE12_Q1_4_1 359.9910335767149 /* weight in the observer's gain l1_4 */
#define STAGE12_Q2_2_1 (-18.578489051610646) /* weight in the observer's gain l2_2 */
#define STAGE12_Q2_2_2 9.913794744612098 /* weight in the observer's gain l2_2 */
#define STAGE12_Q2_3_1 (-12.0) /* weight in the observer's gain l2_3 */
#define STAGE12_Q2_3_2 12.0 /* weight in the observer's gain l2_3 */
#define STAGE12_Q2_4_1 79.8275894892242 /* weight in the observer's gain l2_4 */
#define STAGE12_E0_1_1 0.9995008164815138 /* gain of the observer at its end */
#define STAGE12_E0_1_2 (-0.4960345371406728) /* gain of the observer at its end */
#define STAGE12_E0_1_3 0.005627803367048088 /* gain of the observer at its end */
#define STAGE12_E0_2_1 0.0014420897963740578 /* gain of the observer at its end */
#define STAGE12_E0_2_2 2.2101945239792857 /* gain of the observer at its end */
#define STAGE12_E0_2_3 1.0319275340206813 /* gain of the observer at its end */
#define STAGE12_E0_2_4 1.3304598248204031 /* gain of the observer at its end */
#define STAGE12_E1_1_1 1.9995008164815138 /* gain of the observer at its end */
#define STAGE12_E1_1_2 999.2535286720462 /* gain of the observer at its end */
#define STAGE12_E1_1_3 0.005627803367048088 /* gain of the observer at its end */
#define STAGE12_E1_1_4 29.999252798059576 /* gain of the observer at its end */
#define STAGE12_E1_2_1 0.0014420897963740578 /* gain of the observer at its end */
#define STAGE12_E1_2_2 2.4788577332214805 /* gain of the observer at its end */
#define STAGE12_E1_2_3 1.5319275340206813 /* gain of the observer at its end */
#define STAGE12_E1_2_4 2.6609196496408063 /* gain of the observer at its end */
#define STAGE12_PHI1_2 0.000996505559752715 /* prediction of x1 from x2 */
#define STAGE12_PHI1_3 0.0006188271646029575 /* prediction of x1 from x3 */
#define STAGE12_PHI1_4 0.00010816330676811052 /* prediction of x1 from d */
#define STAGE12_PHI2_2 0.9902193397510792 /* prediction of x2 from x2 */
#define STAGE12_PHI2_3 1.1234620408672982 /* prediction of x2 from x3 */
#define STAGE12_PHI2_4 0.30941358230147875 /* prediction of x2 from d */
#define STAGE12_PHI3_2 (-0.011234620408672982) /* prediction of x3 from x2 */
#define STAGE12_PHI3_3 0.5412090107511158 /* prediction of x3 from x3 */
#define STAGE12_PHI3_4 0.37459048481653323 /* prediction of x3 from d */
#define STAGE12_C_2 (-0.014068298956658285) /* weight of x2 in the law */
#define STAGE12_C_3 (-0.5288375642249519) /* weight of x3 in the law */
#define STAGE12_C_4 1.468571649497805 /* weight of u1 in the law */
#define STAGE12_B_1 (-1776.8479601183408) /* weight of x1 in the law */
#define STAGE12_B_2 (-5.132434542441746) /* weight of x2 in the law */
#define STAGE12_B_3 (-6.801905651476086) /* weight of x3 in the law */
#define STAGE12_B_4 (-2.5314283505021953) /* weight of u1 in the law */

ptc_status stage12_init(stage12 *self, const stage12_params *params)
{
    ptc_status status = PTC_E_PARAM;

    if ((self != NULL) && (params != NULL)) {
        if ((params->samples > 7U)
            && (params->u_max > 0.0)
            && PTC_FINITE_F64(params->k[0])
            && PTC_FINITE_F64(params->k[1])
            && PTC_FINITE_F64(params->k[2])
            && PTC_FINITE_F64(params->k[3])
            && PTC_FINITE_F64(params->deadbeat)
            && (params->deadbeat >= 0.0)) {
            const uint32_t samples = params->samples;
            const double s1 = (params->k[3] - 9.0) + 4.0;
            const double s2 = (s1 < 8.0) ? 8.0 : s1;
            const double deadbeat = (params->deadbeat > 0.0) ? params->deadbeat : s2;
            const double w1_1 = 1776.8479601183408 * (-params->k[0]);
            const double w1_2 = (-1.8656772383860403) * (-params->k[0]);
            const double w1_3 = 1.0279922805444073 * (-params->k[0]);
            const double s3 = ((1.0 - params->k[1]) + params->k[2]) - params->k[3];
            const double w2_2 = 1.7773373232410332 * s3;
            const double s4 = ((1.0 - params->k[1]) + params->k[2]) - params->k[3];
            const double w2_3 = (-1.4680893680774487) * s4;
            const double s5 = ((-7.0) - params->k[2]) + (3.0 * params->k[3]);
            const double w3_2 = (-0.0008901057299880047) * s5;
            const double s6 = ((-7.0) - params->k[2]) + (3.0 * params->k[3]);
            const double w3_3 = 2.670317189964014 * s6;
            const double w4_2 = (-0.02999129417826937) * (6.0 - params->k[3]);
            const double w4_3 = (-1.2261174651918907) * (6.0 - params->k[3]);
            const double w4_4 = 6.0 - params->k[3];
            const double u_max = params->u_max;
            if (PTC_FINITE_F64(deadbeat)
                && PTC_FINITE_F64(w1_1)
                && PTC_FINITE_F64(w1_2)
                && PTC_FINITE_F64(w1_3)
                && PTC_FINITE_F64(w2_2)
                && PTC_FINITE_F64(w2_3)
                && PTC_FINITE_F64(w3_2)
                && PTC_FINITE_F64(w3_3)
                && PTC_FINITE_F64(w4_2)
                && PTC_FINITE_F64(w4_3)
                && PTC_FINITE_F64(w4_4)) {
                self->start = 0U;
                self->samples = samples;
                self->u1 = 0.0;
                self->u2 = 0.0;
                self->seen = 0U;
                self->x1_hat = 0.0;
                self->x1_next = 0.0;
                self->x2_hat = 0.0;
                self->x2_next = 0.0;
                self->x3_hat = 0.0;
                self->x3_next = 0.0;
                self->d_hat = 0.0;
                self->d_next = 0.0;
                self->deadbeat = deadbeat;
                self->w1_1 = w1_1;
                self->w1_2 = w1_2;
                self->w1_3 = w1_3;
                self->w2_2 = w2_2;
                self->w2_3 = w2_3;
                self->w3_2 = w3_2;
                self->w3_3 = w3_3;
                self->w4_2 = w4_2;
                self->w4_3 = w4_3;
                self->w4_4 = w4_4;
                self->u_max = u_max;
                status = PTC_OK;
            }
        }
    }
    return status;
}

ptc_status stage12_arm(stage12 *self, uint32_t k)
{
    ptc_status status = PTC_E_INPUT;

    if (self != NULL) {
        self->start = k;
        const double s1 = fabs(self->x1_next) + fabs(self->x2_next);
        const double size = s1 + fabs(self->x3_next) + fabs(self->d_next);
        if (!(size <= 1e150)) {
            self->seen = 0U;
            self->x1_hat = 0.0;
            self->x1_next = 0.0;
            self->x2_hat = 0.0;
            self->x2_next = 0.0;
            self->x3_hat = 0.0;
            self->x3_next = 0.0;
            self->d_hat = 0.0;
            self->d_next = 0.0;
        }
        status = PTC_OK;
    }
    return status;
}

ptc_status stage12_step(stage12 *self, uint32_t k, const double y[2], double *u)
{
    ptc_status status = PTC_E_INPUT;

    if (u != NULL) {
        *u = 0.0;
    }
    if ((self != NULL) && (y != NULL) && (u != NULL)) {
        if (PTC_FINITE_F64(y[0]) && PTC_FINITE_F64(y[1])) {
            const uint32_t elapsed = k - self->start;

            /* The estimates; at first what y shows. */
            double x1;
            double x2;
            double x3;
            double d;
            if (self->seen == 0U) {
                x1 = y[0];
                x2 = 0.0;
                x3 = y[1];
                d = 0.0;
            } else {
                x1 = self->x1_next + (STAGE12_GAMMA1 * self->u2);
                x2 = self->x2_next + (STAGE12_GAMMA2 * self->u2);
                x3 = self->x3_next + (STAGE12_GAMMA3 * self->u2);
                d = self->d_next;
            }

            /* Prediction of the next sample. */
            const double miss1 = y[0] - x1;
            const double miss2 = y[1] - x3;
            const double off1 = miss1;
            const double off2 = miss2;
            const uint32_t left_o = (elapsed < (self->samples / 2U)) ? ((self->samples / 2U) - elapsed) : 0U;
            const double o0 = (double)left_o;
            double l1_1;
            double l1_2;
            double l1_3;
            double l1_4;
            double l2_1;
            double l2_2;
            double l2_3;
            double l2_4;
            if (left_o == 0U) {
                l1_1 = 0.17200400622757925;
                l1_2 = 7.693835124666324;
                l1_3 = 0.005627803367048088;
                l1_4 = 0.23319622641969587;
                l2_1 = 0.0014420897963740578;
                l2_2 = 1.2843129003368876;
                l2_3 = -0.2598303207324358;
                l2_4 = 0.028634005234458536;
            } else if (o0 > 8.0) {
                const double r0 = 1.0 / (o0 * (o0 - 1.0));
                const double s1 = (STAGE12_Q1_1_1 + (STAGE12_Q1_1_2 * o0)) * r0;
                l1_1 = s1 - 0.0004991835184862197;
                const double s2 = (STAGE12_Q1_2_1 + (STAGE12_Q1_2_2 * o0)) * r0;
                l1_2 = s2 + 0.004899465284856127;
                l1_3 = 0.005627803367048088;
                l1_4 = STAGE12_Q1_4_1 * r0;
                l2_1 = 0.0014420897963740578;
                const double s3 = (STAGE12_Q2_2_1 + (STAGE12_Q2_2_2 * o0)) * r0;
                l2_2 = s3 + 1.1153817526860825;
                const double s4 = (STAGE12_Q2_3_1 + (STAGE12_Q2_3_2 * o0)) * r0;
                l2_3 = s4 - 0.46807246597931873;
                l2_4 = STAGE12_Q2_4_1 * r0;
            } else if (left_o == 8U) {
                l1_1 = STAGE12_E0_1_1;
                l1_2 = STAGE12_E0_1_2;
                l1_3 = STAGE12_E0_1_3;
                l1_4 = 0.0;
                l2_1 = STAGE12_E0_2_1;
                l2_2 = STAGE12_E0_2_2;
                l2_3 = STAGE12_E0_2_3;
                l2_4 = STAGE12_E0_2_4;
            } else {
                l1_1 = STAGE12_E1_1_1;
                l1_2 = STAGE12_E1_1_2;
                l1_3 = STAGE12_E1_1_3;
                l1_4 = STAGE12_E1_1_4;
                l2_1 = STAGE12_E1_2_1;
                l2_2 = STAGE12_E1_2_2;
                l2_3 = STAGE12_E1_2_3;
                l2_4 = STAGE12_E1_2_4;
            }
            const double s5 = x1 + (STAGE12_PHI1_2 * x2) + (STAGE12_PHI1_3 * x3);
            const double x1_on = s5 + (STAGE12_PHI1_4 * d) + (l1_1 * off1) + (l2_1 * off2);
            const double s6 = (STAGE12_PHI2_2 * x2) + (STAGE12_PHI2_3 * x3);
            const double x2_on = s6 + (STAGE12_PHI2_4 * d) + (l1_2 * off1) + (l2_2 * off2);
            const double s7 = (STAGE12_PHI3_2 * x2) + (STAGE12_PHI3_3 * x3);
            const double x3_on = s7 + (STAGE12_PHI3_4 * d) + (l1_3 * off1) + (l2_3 * off2);
            const double d_on = d + (l1_4 * off1) + (l2_4 * off2);
            const uint32_t left = (elapsed < self->samples) ? (self->samples - elapsed) : 0U;
            const double m0 = (double)left;
            double v;
            if (m0 > self->deadbeat) {
                /* The exact law in samples. */
                const double z1 = (self->w1_1 * x1) + (self->w1_2 * x2) + (self->w1_3 * x3);
                const double z2 = (self->w2_2 * x2) + (self->w2_3 * x3);
                const double z3 = (self->w3_2 * x2) + (self->w3_3 * x3);
                const double s8 = (self->w4_2 * x2) + (self->w4_3 * x3);
                const double z4 = s8 + (self->w4_4 * (self->u1 + d));
                const double m0f2 = m0 * (m0 - 1.0);
                const double m0f3 = m0f2 * (m0 - 2.0);
                const double s9 = (STAGE12_C_2 * x2) + (STAGE12_C_3 * x3);
                const double s10 = (z1 + (z2 * m0) + (z3 * m0f2) + (z4 * m0f3)) / (m0f3 * (m0 - 3.0));
                v = (s10 + (s9 + (STAGE12_C_4 * (self->u1 + d)))) - d;
            } else {
                /* Deadbeat. */
                const double s11 = (STAGE12_B_1 * x1) + (STAGE12_B_2 * x2) + (STAGE12_B_3 * x3);
                v = (s11 + (STAGE12_B_4 * (self->u1 + d))) - d;
            }
            status = PTC_E_RANGE;
            if (PTC_FINITE_F64(v)
                && PTC_FINITE_F64(x1_on)
                && PTC_FINITE_F64(x2_on)
                && PTC_FINITE_F64(x3_on)
                && PTC_FINITE_F64(d_on)) {
                double u_now;
                if (v > self->u_max) {
                    u_now = self->u_max;
                } else if (v < -self->u_max) {
                    u_now = -self->u_max;
                } else {
                    u_now = v;
                }
                self->u2 = self->u1;
                self->u1 = u_now;
                self->x1_hat = x1;
                self->x1_next = x1_on;
                self->x2_hat = x2;
                self->x2_next = x2_on;
                self->x3_hat = x3;
                self->x3_next = x3_on;
                self->d_hat = d;
                self->d_next = d_on;
                self->seen = 1U;
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

ptc_status stage12_estimate(const stage12 *self, double xhat[3])
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (xhat != NULL)) {
        xhat[0] = self->x1_hat;
        xhat[1] = self->x2_hat;
        xhat[2] = self->x3_hat;
        status = PTC_OK;
    }
    if ((status < PTC_OK) && (xhat != NULL)) {
        for (uint32_t i = 0U; i < 3U; i++) {
            xhat[i] = 0.0;
        }
    }
    return status;
}

ptc_status stage12_disturbance(const stage12 *self, double *d)
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (d != NULL)) {
        *d = self->d_hat;
        status = PTC_OK;
    }
    return status;
}
