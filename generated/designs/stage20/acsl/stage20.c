/* Prescribed-time controller stage20: see stage20.h. DO NOT EDIT. */
#include "stage20.h"

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
#define STAGE20_Q1_1 120.0 /* weight in the observer's gain l1 */
#define STAGE20_Q1_2 (-60.0) /* weight in the observer's gain l1 */
#define STAGE20_Q1_3 12.0 /* weight in the observer's gain l1 */
#define STAGE20_C_3 2.0 /* weight of u1 in the law */
#define STAGE20_B_3 (-2.0) /* weight of u1 in the law */
#define STAGE20_B_4 (-0.65625) /* -21/32, weight of u2 in the law */

ptc_status stage20_init(stage20 *self, const stage20_params *params)
{
    ptc_status status = PTC_E_PARAM;

    if ((self != NULL) && (params != NULL)) {
        if ((params->samples > 7U)
            && (1e-150 <= params->h)
            && (params->h <= 1e150)
            && (params->u_max > 0.0)
            && PTC_FINITE_F64(params->k[0])
            && PTC_FINITE_F64(params->k[1])
            && PTC_FINITE_F64(params->k[2])
            && PTC_FINITE_F64(params->k[3])
            && PTC_FINITE_F64(params->deadbeat)
            && (params->deadbeat >= 0.0)) {
            const uint32_t samples = params->samples;
            const double phi1_2 = params->h;
            const double phi1_3 = 0.25 * (params->h * params->h);
            const double gamma1 = 0.109375 * (params->h * params->h);
            const double late_gamma1 = 0.140625 * (params->h * params->h);
            const double phi2_3 = 0.5 * params->h;
            const double gamma2 = 0.125 * params->h;
            const double late_gamma2 = 0.375 * params->h;
            const double q2_1 = (-108.0) * (1.0 / params->h);
            const double q2_2 = 36.0 * (1.0 / params->h);
            const double q3_1 = 48.0 * (1.0 / (params->h * params->h));
            const double e2_2 = 1.5 * (1.0 / params->h);
            const double e2_3 = 2.0 * (1.0 / (params->h * params->h));
            const double e1_2 = 0.8571428571428571 * (1.0 / params->h);
            const double e1_3 = (-0.5714285714285714) * (1.0 / (params->h * params->h));
            const double e0_2 = 0.42857142857142855 * (1.0 / params->h);
            const double e0_3 = 0.2857142857142857 * (1.0 / (params->h * params->h));
            const double s1 = (params->k[3] - 9.0) + 4.0;
            const double s2 = (s1 < 8.0) ? 8.0 : s1;
            const double deadbeat = (params->deadbeat > 0.0) ? params->deadbeat : s2;
            const double w1_1 = 2.0 * (-params->k[0]) * (1.0 / (params->h * params->h));
            const double w1_2 = (-2.5) * (-params->k[0]) * (1.0 / params->h);
            const double w1_4 = 0.65625 * (-params->k[0]);
            const double s3 = 2.0 * (((1.0 - params->k[1]) + params->k[2]) - params->k[3]);
            const double w2_2 = s3 * (1.0 / params->h);
            const double w2_4 = (-0.75) * (((1.0 - params->k[1]) + params->k[2]) - params->k[3]);
            const double w3_4 = ((-7.0) - params->k[2]) + (3.0 * params->k[3]);
            const double w4_3 = 6.0 - params->k[3];
            const double w4_4 = -(6.0 - params->k[3]);
            const double b_1 = (-2.0) * (1.0 / (params->h * params->h));
            const double b_2 = (-5.5) * (1.0 / params->h);
            const double u_max = params->u_max;
            if (PTC_FINITE_F64(phi1_3)
                && PTC_FINITE_F64(gamma1)
                && PTC_FINITE_F64(late_gamma1)
                && PTC_FINITE_F64(phi2_3)
                && PTC_FINITE_F64(gamma2)
                && PTC_FINITE_F64(late_gamma2)
                && PTC_FINITE_F64(q2_1)
                && PTC_FINITE_F64(q2_2)
                && PTC_FINITE_F64(q3_1)
                && PTC_FINITE_F64(e2_2)
                && PTC_FINITE_F64(e2_3)
                && PTC_FINITE_F64(e1_2)
                && PTC_FINITE_F64(e1_3)
                && PTC_FINITE_F64(e0_2)
                && PTC_FINITE_F64(e0_3)
                && PTC_FINITE_F64(deadbeat)
                && PTC_FINITE_F64(w1_1)
                && PTC_FINITE_F64(w1_2)
                && PTC_FINITE_F64(w1_4)
                && PTC_FINITE_F64(w2_2)
                && PTC_FINITE_F64(w2_4)
                && PTC_FINITE_F64(w3_4)
                && PTC_FINITE_F64(w4_3)
                && PTC_FINITE_F64(w4_4)
                && PTC_FINITE_F64(b_1)
                && PTC_FINITE_F64(b_2)
                && (params->h * params->h >= 1e-200)
                && (1.0 / (params->h * params->h) >= 1e-200)) {
                self->start = 0U;
                self->samples = samples;
                self->u1 = 0.0;
                self->u2 = 0.0;
                self->u3 = 0.0;
                self->seen = 0U;
                self->x1_hat = 0.0;
                self->x2_hat = 0.0;
                self->d_hat = 0.0;
                self->phi1_2 = phi1_2;
                self->phi1_3 = phi1_3;
                self->gamma1 = gamma1;
                self->late_gamma1 = late_gamma1;
                self->phi2_3 = phi2_3;
                self->gamma2 = gamma2;
                self->late_gamma2 = late_gamma2;
                self->q2_1 = q2_1;
                self->q2_2 = q2_2;
                self->q3_1 = q3_1;
                self->e2_2 = e2_2;
                self->e2_3 = e2_3;
                self->e1_2 = e1_2;
                self->e1_3 = e1_3;
                self->e0_2 = e0_2;
                self->e0_3 = e0_3;
                self->rho1 = 0.0;
                self->rho2 = 0.0;
                self->deadbeat = deadbeat;
                self->w1_1 = w1_1;
                self->w1_2 = w1_2;
                self->w1_4 = w1_4;
                self->w2_2 = w2_2;
                self->w2_4 = w2_4;
                self->w3_4 = w3_4;
                self->w4_3 = w4_3;
                self->w4_4 = w4_4;
                self->b_1 = b_1;
                self->b_2 = b_2;
                self->u_max = u_max;
                status = PTC_OK;
            }
        }
    }
    return status;
}

ptc_status stage20_arm(stage20 *self, uint32_t k)
{
    ptc_status status = PTC_E_INPUT;

    if (self != NULL) {
        self->start = k;
        const double size = fabs(self->x1_hat) + fabs(self->x2_hat) + fabs(self->d_hat);
        if (!(size <= 1e150)) {
            self->seen = 0U;
            self->x1_hat = 0.0;
            self->x2_hat = 0.0;
            self->d_hat = 0.0;
        }
        status = PTC_OK;
    }
    return status;
}

ptc_status stage20_step(stage20 *self, uint32_t k, const double y[1], const double r[3], double *u)
{
    ptc_status status = PTC_E_INPUT;

    if (u != NULL) {
        *u = 0.0;
    }
    if ((self != NULL) && (y != NULL) && (r != NULL) && (u != NULL)) {
        if (PTC_FINITE_F64(y[0])
            && PTC_FINITE_F64(r[0])
            && PTC_FINITE_F64(r[1])
            && PTC_FINITE_F64(r[2])) {
            const uint32_t elapsed = k - self->start;

            /* Predict. */
            const double s1 = self->x1_hat + (self->phi1_2 * self->x2_hat);
            const double s2 = self->late_gamma1 * (self->u2 + 0.5);
            const double s3 = (self->gamma1 * (self->u3 + 0.5)) + s2;
            const double p1 = s1 + (self->phi1_3 * self->d_hat) + s3;
            const double s4 = self->late_gamma2 * (self->u2 + 0.5);
            const double s5 = self->x2_hat + (self->phi2_3 * self->d_hat);
            const double p2 = s5 + ((self->gamma2 * (self->u3 + 0.5)) + s4);
            const double p3 = self->d_hat;

            /* Correct by what is measured. */
            double base;
            double miss;
            if (self->seen == 0U) {
                base = y[0];
                miss = 0.0;
            } else {
                base = p1;
                miss = y[0] - p1;
            }
            const uint32_t left_o = (elapsed < (self->samples / 2U)) ? ((self->samples / 2U) - elapsed) : 0U;
            const double o0 = (double)left_o;
            double l1;
            double l2;
            double l3;
            if (o0 > 8.0) {
                const double o0f2 = o0 * (o0 - 1.0);
                const double r0 = 1.0 / (o0f2 * (o0 - 2.0));
                l1 = (STAGE20_Q1_1 + (STAGE20_Q1_2 * o0) + (STAGE20_Q1_3 * o0f2)) * r0;
                l2 = (self->q2_1 + (self->q2_2 * o0)) * r0;
                l3 = self->q3_1 * r0;
            } else if (left_o == 8U) {
                l1 = 1.0;
                l2 = self->e0_2;
                l3 = self->e0_3;
            } else if (left_o == 7U) {
                l1 = 1.0;
                l2 = self->e1_2;
                l3 = self->e1_3;
            } else {
                l1 = 1.0;
                l2 = self->e2_2;
                l3 = self->e2_3;
            }
            const double x1 = base + (l1 * miss);
            const double x2 = p2 + (l2 * miss);
            const double d = p3 + (l3 * miss);

            /* The tracking error. */
            const double e1 = x1 - r[0];
            const double e2 = x2 - r[1];
            const uint32_t left = (elapsed < self->samples) ? (self->samples - elapsed) : 0U;
            const double m0 = (double)left;
            double v;
            if (m0 > self->deadbeat) {
                /* The exact law in samples. */
                const double s6 = self->w1_4 * ((self->u2 + (d + 0.5)) - (2.0 * self->rho2));
                const double z1 = (self->w1_1 * e1) + (self->w1_2 * e2) + s6;
                const double s7 = self->w2_4 * ((self->u2 + (d + 0.5)) - (2.0 * self->rho2));
                const double z2 = (self->w2_2 * e2) + s7;
                const double z3 = self->w3_4 * ((self->u2 + (d + 0.5)) - (2.0 * self->rho2));
                const double s8 = self->w4_3 * ((self->u1 + (d + 0.5)) - (2.0 * self->rho1));
                const double z4 = s8 + (self->w4_4 * ((self->u2 + (d + 0.5)) - (2.0 * self->rho2)));
                const double m0f2 = m0 * (m0 - 1.0);
                const double m0f3 = m0f2 * (m0 - 2.0);
                const double s9 = STAGE20_C_3 * ((self->u1 + (d + 0.5)) - (2.0 * self->rho1));
                const double s10 = (z1 + (z2 * m0) + (z3 * m0f2) + (z4 * m0f3)) / (m0f3 * (m0 - 3.0));
                const double s11 = (s10 + (s9 - ((self->u2 + (d + 0.5)) - (2.0 * self->rho2)))) - (d + 0.5);
                v = s11 + (2.0 * r[2]);
            } else {
                /* Deadbeat. */
                const double s12 = STAGE20_B_3 * ((self->u1 + (d + 0.5)) - (2.0 * self->rho1));
                const double s13 = STAGE20_B_4 * ((self->u2 + (d + 0.5)) - (2.0 * self->rho2));
                const double s14 = ((self->b_1 * e1) + (self->b_2 * e2) + s12 + s13) - (d + 0.5);
                v = s14 + (2.0 * r[2]);
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
                self->u3 = self->u2;
                self->u2 = self->u1;
                self->u1 = u_now;
                self->rho2 = self->rho1;
                self->rho1 = r[2];
                self->x1_hat = x1;
                self->x2_hat = x2;
                self->d_hat = d;
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

ptc_status stage20_estimate(const stage20 *self, double xhat[2])
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (xhat != NULL)) {
        xhat[0] = self->x1_hat;
        xhat[1] = self->x2_hat;
        status = PTC_OK;
    }
    if ((status < PTC_OK) && (xhat != NULL)) {
        for (uint32_t i = 0U; i < 2U; i++) {
            xhat[i] = 0.0;
        }
    }
    return status;
}

ptc_status stage20_disturbance(const stage20 *self, double *d)
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (d != NULL)) {
        *d = self->d_hat;
        status = PTC_OK;
    }
    return status;
}
