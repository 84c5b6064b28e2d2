/* Prescribed-time controller ptc_rational2_input_gain: see ptc_rational2_input_gain.h. DO NOT EDIT. */
#include "ptc_rational2_input_gain.h"

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

ptc_status ptc_rational2_input_gain_init(
    ptc_rational2_input_gain *self,
    const ptc_rational2_input_gain_params *params)
{
    ptc_status status = PTC_E_PARAM;
    struct ptc_rational2_input_gain built;

    if ((self != NULL) && (params != NULL)) {
        const double tau = params->tau;
        const double t0 = params->t0;
        const double eps = params->eps;
        const double u_max = params->u_max;
        const double a = params->a;
        const double k1 = params->k[0];
        const double k2 = params->k[1];
        if (PTC_FINITE_F64(tau)
            && (1e-150 <= tau)
            && (tau <= 1e150)
            && PTC_FINITE_F64(t0)
            && (eps >= 1e-150)
            && (u_max > 0.0)
            && PTC_FINITE_F64(a)
            && (1e-150 <= a)
            && (a <= 1e150)
            && PTC_FINITE_F64(k1)
            && PTC_FINITE_F64(k2)
            && (eps < tau)) {
            const double rate = a / tau;
            const double v1 = rate * rate;
            const double K1 = k1 / v1;
            const double K2 = k2 / rate;
            const double c1 = -K1;
            const double c2_0 = -K2;
            const double hold_from = -eps;
            const double size_K1 = (fabs(k1) <= 0.0) ? 1e-200 : fabs(K1);
            const double size_K2 = (fabs(k2) <= 0.0) ? 1e-200 : fabs(K2);
            if ((v1 >= 1e-200)
                && (size_K1 >= 1e-200)
                && (size_K2 >= 1e-200)
                && PTC_FINITE_F64(c1)
                && PTC_FINITE_F64(c2_0)
                && PTC_FINITE_F64(hold_from)) {
                built.tau = tau;
                built.c1 = c1;
                built.c2_0 = c2_0;
                built.eps = eps;
                built.hold_from = hold_from;
                built.u_max = u_max;
                built.t0 = 0.0;
                built.deadline = 0.0;
                built.correction = 0.0;
                status = ptc_rational2_input_gain_arm(&built, t0);
                if (status == PTC_OK) {
                    *self = built;
                }
            }
        }
    }
    return status;
}

ptc_status ptc_rational2_input_gain_arm(ptc_rational2_input_gain *self, double t0)
{
    ptc_status status = PTC_E_PARAM;

    if (self != NULL) {
        if (PTC_FINITE_F64(t0)) {
            const double deadline = t0 + self->tau;
            const double v1 = deadline - t0;
            const double correction = (t0 - (deadline - v1)) + (self->tau - v1);
            if (PTC_FINITE_F64(deadline)) {
                self->t0 = t0;
                self->deadline = deadline;
                self->correction = correction;
                status = PTC_OK;
            }
        }
    }
    return status;
}

ptc_status ptc_rational2_input_gain_step(
    const ptc_rational2_input_gain *self,
    double t,
    const double x[2],
    double *u)
{
    ptc_status status = PTC_E_INPUT;

    if (u != NULL) {
        *u = 0.0;
    }
    if ((self != NULL) && (x != NULL) && (u != NULL)) {
        if (t >= self->t0) {
            const double past = (t - self->deadline) - self->correction;
            const double late = (past < self->hold_from) ? past : self->hold_from;
            const double row2 = ((-2.0) * late) + self->c2_0;
            const double inv_T_squared = 1.0 / (late * late);
            const double s1 = (self->c1 * x[0] * inv_T_squared) + (row2 * x[1]);
            const double v1 = s1 * inv_T_squared;
            const double input_gain = 2.0 + (x[0] * x[0]);
            const double v = v1 / (((input_gain < 0.0) || (input_gain > 0.0)) ? input_gain : (double)NAN);
            *u = v;
            if (PTC_FINITE_F64(v) && (fabs(v) <= self->u_max) && (late < self->hold_from)) {
                status = PTC_OK;
            } else if (PTC_FINITE_F64(t) && PTC_FINITE_F64(x[0]) && PTC_FINITE_F64(x[1])) {
                if (PTC_FINITE_F64(v)) {
                    if (v > self->u_max) {
                        *u = self->u_max;
                        status = PTC_SATURATED;
                    } else if (v < -self->u_max) {
                        *u = -self->u_max;
                        status = PTC_SATURATED;
                    } else {
                        status = PTC_HOLD;
                    }
                } else {
                    *u = 0.0;
                    status = PTC_E_RANGE;
                }
            } else {
                *u = 0.0;
                status = PTC_E_INPUT;
            }
        }
    }
    return status;
}
