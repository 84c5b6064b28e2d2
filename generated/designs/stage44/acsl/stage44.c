/* Prescribed-time controller stage44: see stage44.h. DO NOT EDIT. */
#include "stage44.h"

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

ptc_status stage44_init(stage44 *self, const stage44_params *params)
{
    ptc_status status = PTC_E_PARAM;

    if ((self != NULL) && (params != NULL)) {
        if ((9U < params->samples) && (0.0 < params->u_max)) {
            const uint32_t samples = params->samples;
            const double u_max = params->u_max;
            self->start = 0U;
            self->samples = samples;
            self->u1 = 0.0;
            self->u2 = 0.0;
            self->u3 = 0.0;
            self->seen = 0U;
            self->x1_hat = 0.0;
            self->x1_next = 0.0;
            self->x2_hat = 0.0;
            self->x2_next = 0.0;
            self->x3_hat = 0.0;
            self->x3_next = 0.0;
            self->u_max = u_max;
            status = PTC_OK;
        }
    }
    return status;
}

ptc_status stage44_arm(stage44 *self, uint32_t k)
{
    ptc_status status = PTC_E_INPUT;

    if (self != NULL) {
        self->start = k;
        const double s1 = fabs(self->x1_next) + fabs(self->x2_next);
        const double size = s1 + fabs(self->x3_next);
        if (!(size <= 1e150)) {
            self->seen = 0U;
            self->x1_hat = 0.0;
            self->x1_next = 0.0;
            self->x2_hat = 0.0;
            self->x2_next = 0.0;
            self->x3_hat = 0.0;
            self->x3_next = 0.0;
        }
        status = PTC_OK;
    }
    return status;
}

ptc_status stage44_step(stage44 *self, uint32_t k, const double y[1], double *u)
{
    ptc_status status = PTC_E_INPUT;

    if (u != NULL) {
        *u = 0.0;
    }
    if ((self != NULL) && (y != NULL) && (u != NULL)) {
        if (PTC_FINITE_F64(y[0])) {
            const uint32_t elapsed = k - self->start;

            /* The estimates; at first what y shows. */
            double x1;
            double x2;
            double x3;
            if (self->seen == 0U) {
                x1 = y[0];
                x2 = 0.0;
                x3 = 0.0;
            } else {
                const double s1 = 1.4506885866158227e-5 * self->u2;
                x1 = self->x1_next + ((9.353143640028875e-5 * self->u3) + s1);
                const double s2 = 0.008492640667447336 * self->u2;
                x2 = self->x2_next + ((0.02240015856569381 * self->u3) + s2);
                const double s3 = 0.15880933131841984 * self->u3;
                x3 = self->x3_next + (s3 + (0.21578282027048595 * self->u2));
            }

            /* Prediction of the next sample. */
            const double miss1 = y[0] - x1;
            const double off1 = miss1;
            const uint32_t left_o = (elapsed < (self->samples / 2U)) ? ((self->samples / 2U) - elapsed) : 0U;
            const double o0 = (double)left_o;
            double l1;
            double l2;
            double l3;
            if (8.0 < o0) {
                const double r0 = 1.0 / o0;
                const double r1 = 1.0 / (o0 - 1.0);
                const double r2 = 1.0 / (o0 - 2.0);
                l1 = (((((24.0 * r0) - 24.0) * r1) + 12.0) * r2) - 0.47301759733204196;
                const double s4 = (((-12889.952685745366) * r0) + 6304.212917508586) * r1;
                l2 = ((s4 - 742.8703573620571) * r2) + 26.72716299730578;
                const double s5 = ((72521.99132748511 * r0) - 24808.851670034343) * r1;
                l3 = ((s5 + 2767.4814294482285) * r2) - 98.86735283457841;
            } else if (left_o == 8U) {
                l1 = 1.026982402667958;
                l2 = 9.393065010983802;
                l3 = 72.1724949708503;
            } else if (left_o == 7U) {
                l1 = 1.2412681169536723;
                l2 = -0.9955098611216602;
                l3 = -271.5264302640074;
            } else {
                l1 = 2.526982402667958;
                l2 = 168.91277532831796;
                l3 = 171.81438886235838;
            }
            const double s6 = x1 + (0.009942671770940647 * x2) + (0.000617855984662823 * x3);
            const double x1_on = s6 + (l1 * off1);
            const double s7 = (0.9857608243445873 * x2) + (0.11206871748434033 * x3);
            const double x2_on = s7 + (l2 * off1);
            const double s8 = ((-0.11206871748434033) * x2) + (0.5412215783233707 * x3);
            const double x3_on = s8 + (l3 * off1);
            const uint32_t left = (elapsed < self->samples) ? (self->samples - elapsed) : 0U;
            const double s9 = ((double)left) - 2.0;
            const double m0 = (s9 < 6.0) ? 6.0 : s9;
            double v;

            /* The exact law in samples. */
            const double s10 = ((-106850.90292251826) * x1) - (482.3692808208648 * x2);
            const double s11 = 1.2197801784387233e-74 * self->u1;
            const double s12 = (s10 + (4.807633485406011 * x3)) - s11;
            const double z1 = s12 + (4.609258112111791 * self->u2);
            const double s13 = ((-633.6322203514217) * x2) - (73.36956899710586 * x3);
            const double s14 = s13 - (1.2733281521282373e-76 * self->u1);
            const double z2 = s14 - (14.786896717013052 * self->u2);
            const double s15 = (4.311208496599377 * x2) - (9.337493806987991 * x3);
            const double z3 = (s15 - (9.0 * self->u1)) - (2.7645844206856207 * self->u2);
            const double s16 = (0.10945032226632541 * x2) + (0.5296658086896372 * x3);
            const double s17 = s16 + (0.47301759733204196 * self->u1);
            const double s18 = ((((z1 / (m0 + 2.0)) + z2) / (m0 + 1.0)) + z3) / m0;
            v = s18 + (s17 + (0.15314166966017376 * self->u2));
            status = PTC_E_RANGE;
            if (PTC_FINITE_F64(v)
                && PTC_FINITE_F64(x1_on)
                && PTC_FINITE_F64(x2_on)
                && PTC_FINITE_F64(x3_on)) {
                double u_now;
                if (self->u_max < v) {
                    u_now = self->u_max;
                } else if (v < -self->u_max) {
                    u_now = -self->u_max;
                } else {
                    u_now = v;
                }
                self->u3 = self->u2;
                self->u2 = self->u1;
                self->u1 = u_now;
                self->x1_hat = x1;
                self->x1_next = x1_on;
                self->x2_hat = x2;
                self->x2_next = x2_on;
                self->x3_hat = x3;
                self->x3_next = x3_on;
                self->seen = 1U;
                *u = u_now;
                if ((self->u_max < v) || (v < -self->u_max)) {
                    status = PTC_SATURATED;
                } else if (((double)left) - 2.0 <= 6.0) {
                    status = PTC_HOLD;
                } else {
                    status = PTC_OK;
                }
            }
        }
    }
    return status;
}

ptc_status stage44_estimate(const stage44 *self, double xhat[3])
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (xhat != NULL)) {
        xhat[0] = self->x1_hat;
        xhat[1] = self->x2_hat;
        xhat[2] = self->x3_hat;
        status = PTC_OK;
    } else {
        if (xhat != NULL) {
            for (uint32_t i = 0U; i < 3U; i++) {
                xhat[i] = 0.0;
            }
        }
    }
    return status;
}
