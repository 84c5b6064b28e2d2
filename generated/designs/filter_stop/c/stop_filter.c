/* Prescribed-time filter stop_filter: see stop_filter.h. DO NOT EDIT. */
#include "stop_filter.h"

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
#define STOP_FILTER_S1_2 (-0.0005) /* -1/2000, weight of x2 in the law */
#define STOP_FILTER_U_MAX 10.0 /* bound of |u| */

ptc_status stop_filter_init(stop_filter *self, const stop_filter_params *params)
{
    ptc_status status = PTC_E_PARAM;

    (void)params;
    if (self != NULL) {
        self->start = 0U;
        status = PTC_OK;
    }
    return status;
}

ptc_status stop_filter_arm(stop_filter *self, uint32_t k)
{
    ptc_status status = PTC_E_INPUT;

    if (self != NULL) {
        self->start = k;
        status = PTC_OK;
    }
    return status;
}

ptc_status stop_filter_step(
    stop_filter *self,
    uint32_t k,
    const double x[2],
    double u_nominal,
    double *u)
{
    ptc_status status = PTC_E_INPUT;

    if (u != NULL) {
        *u = 0.0;
    }
    if ((self != NULL) && (x != NULL) && (u != NULL)) {
        if (PTC_FINITE_F64(x[0]) && PTC_FINITE_F64(x[1]) && PTC_FINITE_F64(u_nominal)) {
            const double x1 = x[0];
            const double x2 = x[1];
            const double z1 = x1 + (STOP_FILTER_S1_2 * x2);
            const double z2 = x2;

            /* The limits of u that keep a safe state safe. */
            const double q1_1 = z2 + (9.950166250831947 * z1);
            const double q1_2 = (49.16072709850874 * z2) + (390.1515992227461 * z1);
            double low1 = (-195.07579961137304) - q1_2;
            double high1 = 195.07579961137304 - q1_2;
            const double q2_1 = 39.21056084767679 * z2;
            double low2 = (-31.368448678141434) - q2_1;
            double high2 = 31.368448678141434 - q2_1;
            uint32_t since = self->start;
            uint32_t safe = 1U;
            if ((-0.5000000004656613 <= z1)
                && (z1 <= 0.5000000004656613)
                && (-4.975083130049381 <= q1_1)
                && (q1_1 <= 4.975083130049381)
                && (-0.8000000007450581 <= z2)
                && (z2 <= 0.8000000007450581)) {
                since = k;
            } else {
                safe = 0U;

                /* Outside: u is held to the law of return too. */
                const double left = (double)(((k - since) < 400U) ? (400U - (k - since)) : 0U);
                const double t1 = (left < 2.0) ? 2.0 : left;
                const double law1 = ((((-6000000.0) * z1) / (t1 + 1.0)) - (4000.0 * z2)) / t1;
                const double weight1 = ((-6000000.0) / (t1 + 1.0)) / t1;
                const double low1_back = law1 - ((-0.5) * weight1);
                if (low1 < low1_back) {
                    low1 = low1_back;
                }
                const double high1_back = law1 - (0.5 * weight1);
                if (high1_back < high1) {
                    high1 = high1_back;
                }
                const double t2 = (left < 1.0) ? 1.0 : left;
                const double law2 = ((-1000.0) * z2) / t2;
                const double weight2 = (-1000.0) / t2;
                const double low2_back = law2 - ((-0.8) * weight2);
                if (low2 < low2_back) {
                    low2 = low2_back;
                }
                const double high2_back = law2 - (0.8 * weight2);
                if (high2_back < high2) {
                    high2 = high2_back;
                }
            }

            /* u within them, the bounds of x1 last. */
            double u_now = u_nominal;
            if (u_now < low2) {
                u_now = low2;
            }
            if (high2 < u_now) {
                u_now = high2;
            }
            if (u_now < low1) {
                u_now = low1;
            }
            if (high1 < u_now) {
                u_now = high1;
            }
            if (u_now > STOP_FILTER_U_MAX) {
                u_now = STOP_FILTER_U_MAX;
            }
            if (u_now < -STOP_FILTER_U_MAX) {
                u_now = -STOP_FILTER_U_MAX;
            }
            status = PTC_E_RANGE;
            if (PTC_FINITE_F64(u_now)
                && PTC_FINITE_F64(low1)
                && PTC_FINITE_F64(high1)
                && PTC_FINITE_F64(low2)
                && PTC_FINITE_F64(high2)) {
                self->start = since;
                *u = u_now;
                if ((safe == 0U) || (high2 + 2.9214144384620184e-8 < u_now) || (u_now < low2 - 2.9214144384620184e-8) || (high1 + 1.816784959392371e-7 < u_now) || (u_now < low1 - 1.816784959392371e-7)) {
                    status = PTC_INFEASIBLE;
                } else if ((u_now < u_nominal) || (u_nominal < u_now)) {
                    status = PTC_SATURATED;
                } else {
                    status = PTC_OK;
                }
            }
        }
    }
    return status;
}
