/* Prescribed-time controller ptc_tanh3_extern: see ptc_tanh3_extern.h. DO NOT EDIT. */
#include "ptc_tanh3_extern.h"

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

ptc_status ptc_tanh3_extern_init(ptc_tanh3_extern *self, const ptc_tanh3_extern_params *params)
{
    ptc_status status = PTC_E_PARAM;
    struct ptc_tanh3_extern built;

    if ((self != NULL) && (params != NULL)) {
        const double tau = params->tau;
        const double t0 = params->t0;
        const double eps = params->eps;
        const double u_max = params->u_max;
        const double a = params->a;
        if (PTC_FINITE_F64(tau)
            && (1e-150 <= tau)
            && (tau <= 1e150)
            && PTC_FINITE_F64(t0)
            && (eps >= 1e-150)
            && (u_max > 0.0)
            && PTC_FINITE_F64(a)
            && (1e-150 <= a)
            && (a <= 1e150)
            && (eps < tau)) {
            const double hold_from = -eps;
            const double f16 = 2.0 * tau;
            const double f22 = 2.0 * a;
            const double f24 = f16 * a;
            const double f29 = 1.0 / tau;
            if (PTC_FINITE_F64(hold_from)
                && PTC_FINITE_F64(f16)
                && PTC_FINITE_F64(f22)
                && PTC_FINITE_F64(f24)
                && PTC_FINITE_F64(f29)) {
                built.tau = tau;
                built.eps = eps;
                built.hold_from = hold_from;
                built.f16 = f16;
                built.a = a;
                built.f22 = f22;
                built.f24 = f24;
                built.f29 = f29;
                built.u_max = u_max;
                built.t0 = 0.0;
                built.deadline = 0.0;
                built.correction = 0.0;
                status = ptc_tanh3_extern_arm(&built, t0);
                if (status == PTC_OK) {
                    *self = built;
                }
            }
        }
    }
    return status;
}

ptc_status ptc_tanh3_extern_arm(ptc_tanh3_extern *self, double t0)
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

ptc_status ptc_tanh3_extern_step(
    const ptc_tanh3_extern *self,
    double t,
    const double x[3],
    ptc_tanh3_extern_pi0 pi0,
    ptc_tanh3_extern_after after,
    void *context,
    double *u)
{
    ptc_status status = PTC_E_INPUT;

    if (u != NULL) {
        *u = 0.0;
    }
    if ((self != NULL) && (x != NULL) && (pi0 != NULL) && (after != NULL) && (u != NULL)) {
        const double x1 = x[0];
        const double x2 = x[1];
        const double x3 = x[2];
        if (PTC_FINITE_F64(t)
            && (t >= self->t0)
            && PTC_FINITE_F64(x1)
            && PTC_FINITE_F64(x2)
            && PTC_FINITE_F64(x3)) {
            const double past = (t - self->deadline) - self->correction;
            const double late = (past < self->hold_from) ? past : self->hold_from;
            const double T = -late;
            const double v1 = T * self->a;
            const double v2 = self->f24 + (-v1);
            const double unit = self->f29 * v2;
            const double v3 = v1 * (1.0 / v2);
            const double v4 = v3 - 1.0;
            const double v5 = v4 * 0.5;
            const double v6 = T * unit;
            const double inv_r1 = 1.0 / v6;
            const double xi2 = x2 * v6;
            const double xi3 = ((x3 * v6) + (2.0 * (v5 * unit) * x2)) * v6;
            const double t_kappa = self->t0 + ((-log(T / (self->f16 - T))) / self->f22);
            const double xi[3] = {x1, xi2, xi3};
            const double law = pi0(context, xi, t_kappa);
            double applied;
            if (past >= 0.0) {
                applied = after(context, x, t);
            } else {
                const double s1 = ((v4 * v4) + (2.0 * (-v3))) * 0.16666666666666666;
                const double s2 = ((law * inv_r1) + ((-6.0) * (s1 * (unit * unit)) * x2)) * inv_r1;
                applied = (s2 + ((-3.0) * ((v5 + v5) * unit) * x3)) * inv_r1;
            }
            const double v = applied;
            if (PTC_FINITE_F64(v)) {
                if (v > self->u_max) {
                    *u = self->u_max;
                    status = PTC_SATURATED;
                } else if (v < -self->u_max) {
                    *u = -self->u_max;
                    status = PTC_SATURATED;
                } else if (late < self->hold_from) {
                    *u = v;
                    status = PTC_OK;
                } else if (past >= 0.0) {
                    *u = v;
                    status = PTC_AFTER;
                } else {
                    *u = v;
                    status = PTC_HOLD;
                }
            } else {
                status = PTC_E_RANGE;
            }
        }
    }
    return status;
}
