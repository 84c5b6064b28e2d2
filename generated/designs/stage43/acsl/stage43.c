/* Prescribed-time controller stage43: see stage43.h. DO NOT EDIT. */
#include "stage43.h"

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

ptc_status stage43_init(stage43 *self, const stage43_params *params)
{
    ptc_status status = PTC_E_PARAM;

    (void)params;
    if (self != NULL) {
        self->start = 0U;
        self->u1 = 0.0;
        self->u2 = 0.0;
        self->u3 = 0.0;
        self->u4 = 0.0;
        self->seen = 0U;
        self->x1_hat = 0.0;
        self->x2_hat = 0.0;
        self->x3_hat = 0.0;
        self->d_hat = 0.0;
        status = PTC_OK;
    }
    return status;
}

ptc_status stage43_arm(stage43 *self, uint32_t k)
{
    ptc_status status = PTC_E_INPUT;

    if (self != NULL) {
        self->start = k;
        const double s1 = fabs(self->x1_hat) + fabs(self->x2_hat) + fabs(self->x3_hat);
        const double size = s1 + fabs(self->d_hat);
        if (!(size <= 1e150)) {
            self->seen = 0U;
            self->x1_hat = 0.0;
            self->x2_hat = 0.0;
            self->x3_hat = 0.0;
            self->d_hat = 0.0;
        }
        status = PTC_OK;
    }
    return status;
}

ptc_status stage43_step(stage43 *self, uint32_t k, const double y[1], double *u)
{
    ptc_status status = PTC_E_INPUT;

    if (u != NULL) {
        *u = 0.0;
    }
    if ((self != NULL) && (y != NULL) && (u != NULL)) {
        if (PTC_FINITE_F64(y[0])) {
            const uint32_t elapsed = k - self->start;

            /* Predict. */
            const double s1 = self->x1_hat + (0.01 * self->x2_hat) + (5e-5 * self->x3_hat);
            const double s2 = (1.640625e-7 * self->u4) + (2.604166666666667e-9 * self->u3);
            const double p1 = s1 + (1.6666666666666668e-7 * self->d_hat) + s2;
            const double s3 = self->x2_hat + (0.01 * self->x3_hat) + (5e-5 * self->d_hat);
            const double p2 = s3 + ((4.6875e-5 * self->u4) + (3.125e-6 * self->u3));
            const double s4 = (0.0075 * self->u4) + (0.0025 * self->u3);
            const double p3 = self->x3_hat + (0.01 * self->d_hat) + s4;
            const double p4 = self->d_hat;

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
            const uint32_t left_o = (elapsed < 20U) ? (20U - elapsed) : 0U;
            const double o0 = (double)left_o;
            double l1;
            double l2;
            double l3;
            double l4;
            if (10.0 < o0) {
                const double r0 = 1.0 / o0;
                const double r1 = 1.0 / (o0 - 1.0);
                const double r2 = 1.0 / (o0 - 2.0);
                const double r3 = 1.0 / (o0 - 3.0);
                l1 = (((((((-840.0) * r0) + 480.0) * r1) - 120.0) * r2) + 16.0) * r3;
                l2 = ((((90800.0 * r0) - 43200.0) * r1) + 7200.0) * r2 * r3;
                l3 = (((-3360000.0) * r0) + 960000.0) * r1 * r2 * r3;
                l4 = 24000000.0 * r0 * r1 * r2 * r3;
            } else if (left_o == 10U) {
                l1 = 1.0;
                l2 = 47.77777777777778;
                l3 = 2666.6666666666665;
                l4 = -66666.66666666667;
            } else if (left_o == 9U) {
                l1 = 1.0;
                l2 = 81.48148148148148;
                l3 = -2222.222222222222;
                l4 = 444444.44444444444;
            } else if (left_o == 8U) {
                l1 = 1.0;
                l2 = 116.66666666666667;
                l3 = 0.0;
                l4 = -1000000.0;
            } else {
                l1 = 1.0;
                l2 = 183.33333333333334;
                l3 = 20000.0;
                l4 = 1000000.0;
            }
            const double x1 = base + (l1 * miss);
            const double x2 = p2 + (l2 * miss);
            const double x3 = p3 + (l3 * miss);
            const double d = p4 + (l4 * miss);

            /* The tracking error. */
            const double t = 0.01 * ((double)elapsed);
            const double reference1 = t;
            const double reference0 = reference1 * reference1 * 0.5;
            const double e1 = x1 - reference0;
            const double e2 = x2 - reference1;
            const double e3 = x3 - 1.0;
            double v;

            /* The exact law in samples. */
            const double m0 = (elapsed < 34U) ? ((double)(40U - elapsed)) : 6.0;
            const double s5 = (((-120000000.0) * e1) - (2100000.0 * e2)) - (16375.0 * e3);
            const double z1 = s5 - (72.1875 * (self->u3 + d));
            const double s6 = (((-600000.0) * e2) - (13500.0 * e3)) - (60.0 * (self->u2 + d));
            const double z2 = s6 - (84.375 * (self->u3 + d));
            const double s7 = ((-1200.0) * e3) - (12.0 * (self->u1 + d));
            const double z3 = (s7 - (12.0 * (self->u2 + d))) - (9.0 * (self->u3 + d));
            v = (((((z1 / m0) + z2) / (m0 - 1.0)) + z3) / (m0 - 2.0)) - d;
            status = PTC_E_RANGE;
            if (PTC_FINITE_F64(v)) {
                double u_now;
                if (6.0 < v) {
                    u_now = 6.0;
                } else if (v < -6.0) {
                    u_now = -6.0;
                } else {
                    u_now = v;
                }
                self->u4 = self->u3;
                self->u3 = self->u2;
                self->u2 = self->u1;
                self->u1 = u_now;
                self->x1_hat = x1;
                self->x2_hat = x2;
                self->x3_hat = x3;
                self->d_hat = d;
                self->seen = 1U;
                *u = u_now;
                if ((6.0 < v) || (v < -6.0)) {
                    status = PTC_SATURATED;
                } else if (elapsed < 40U) {
                    status = PTC_OK;
                } else {
                    status = PTC_HOLD;
                }
            }
        }
    }
    return status;
}

ptc_status stage43_estimate(const stage43 *self, double xhat[3])
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

ptc_status stage43_disturbance(const stage43 *self, double *d)
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (d != NULL)) {
        *d = self->d_hat;
        status = PTC_OK;
    }
    return status;
}
