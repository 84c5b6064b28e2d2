/* Prescribed-time controller motor: see motor.h. DO NOT EDIT. */
#include "motor.h"

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

ptc_status motor_init(motor *self, const motor_params *params)
{
    ptc_status status = PTC_E_PARAM;

    (void)params;
    if (self != NULL) {
        self->start = 0U;
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
        status = PTC_OK;
    }
    return status;
}

ptc_status motor_arm(motor *self, uint32_t k)
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

ptc_status motor_step(motor *self, uint32_t k, const double y[1], double *u)
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
            double d;
            if (self->seen == 0U) {
                x1 = y[0];
                x2 = 0.0;
                x3 = 0.0;
                d = 0.0;
            } else {
                x1 = self->x1_next + (0.00010816330676811052 * self->u2);
                x2 = self->x2_next + (0.30941358230147875 * self->u2);
                x3 = self->x3_next + (0.37459048481653323 * self->u2);
                d = self->d_next;
            }

            /* Prediction of the next sample. */
            const double miss1 = y[0] - x1;
            const double off1 = miss1;
            const uint32_t left_o = (elapsed < 150U) ? (150U - elapsed) : 0U;
            const double o0 = ((double)left_o < 40.0) ? 40.0 : (double)left_o;
            double l1;
            double l2;
            double l3;
            double l4;
            const double r0 = 1.0 / o0;
            const double r1 = 1.0 / (o0 - 1.0);
            const double r2 = 1.0 / (o0 - 2.0);
            const double r3 = 1.0 / (o0 - 3.0);
            const double s1 = (((((((-96.0) * r0) + 96.0) * r1) - 48.0) * r2) + 16.0) * r3;
            l1 = s1 - 0.46857164949780494;
            const double s2 = ((859382.9277311233 * r0) - 513847.60335174634) * r1;
            const double s3 = (((s2 + 125558.23800330989) * r2) - 9808.939721535125) * r3;
            l2 = s3 + 264.4187821124759;
            const double s4 = (((-620544.0922410007) * r0) + 289368.54342637886) * r1;
            const double s5 = (((s4 - 49493.69520132396) * r2) + 3680.3758886140504) * r3;
            l3 = s5 - 98.64522377262374;
            l4 = 42644.35104284018 * r0 * r1 * r2 * r3;
            const double s6 = x1 + (0.000996505559752715 * x2) + (0.0006188271646029575 * x3);
            const double x1_on = s6 + (0.00010816330676811052 * d) + (l1 * off1);
            const double s7 = (0.9902193397510792 * x2) + (1.1234620408672982 * x3);
            const double x2_on = s7 + (0.30941358230147875 * d) + (l2 * off1);
            const double s8 = ((-0.011234620408672982) * x2) + (0.5412090107511158 * x3);
            const double x3_on = s8 + (0.37459048481653323 * d) + (l3 * off1);
            const double d_on = d + (l4 * off1);
            const uint32_t left = (elapsed < 400U) ? (400U - elapsed) : 0U;
            const double m0 = ((double)left < 20.0) ? 20.0 : (double)left;
            double v;

            /* The exact law in samples. */
            const double s9 = ((-1492552.2864994062) * x1) + (1567.1688802442739 * x2);
            const double z1 = s9 - (863.5135156573022 * x3);
            const double z2 = ((-853.121915155696) * x2) + (704.6828966771754 * x3);
            const double z3 = (0.10681268759856057 * x2) - (320.4380627956817 * x3);
            const double s10 = (0.4798607068523099 * x2) + (19.61787944307025 * x3);
            const double z4 = s10 - (16.0 * (self->u1 + d));
            const double s11 = ((((z1 / (m0 + 3.0)) + z2) / (m0 + 2.0)) + z3) / (m0 + 1.0);
            const double s12 = ((-0.014068298956658285) * x2) - (0.5288375642249519 * x3);
            const double s13 = ((s11 + z4) / m0) + (s12 + (1.468571649497805 * (self->u1 + d)));
            v = s13 - d;
            status = PTC_E_RANGE;
            if (PTC_FINITE_F64(v)
                && PTC_FINITE_F64(x1_on)
                && PTC_FINITE_F64(x2_on)
                && PTC_FINITE_F64(x3_on)
                && PTC_FINITE_F64(d_on)) {
                double u_now;
                if (24.0 < v) {
                    u_now = 24.0;
                } else if (v < -24.0) {
                    u_now = -24.0;
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
                if ((24.0 < v) || (v < -24.0)) {
                    status = PTC_SATURATED;
                } else if ((double)left <= 20.0) {
                    status = PTC_HOLD;
                } else {
                    status = PTC_OK;
                }
            }
        }
    }
    return status;
}

ptc_status motor_estimate(const motor *self, double xhat[3])
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

ptc_status motor_disturbance(const motor *self, double *d)
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (d != NULL)) {
        *d = self->d_hat;
        status = PTC_OK;
    }
    return status;
}
