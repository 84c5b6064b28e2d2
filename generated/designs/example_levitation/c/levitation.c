/* Prescribed-time controller levitation: see levitation.h. DO NOT EDIT. */
#include "levitation.h"

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

ptc_status levitation_init(levitation *self, const levitation_params *params)
{
    ptc_status status = PTC_E_PARAM;
    struct levitation built;

    if ((self != NULL) && (params != NULL)) {
        const double tau = params->tau;
        const double t0 = params->t0;
        const double u_max = params->u_max;
        const double p_L = params->L;
        const double p_R = params->R;
        const double p_i0 = params->i0;
        const double p_z0 = params->z0;
        if (PTC_FINITE_F64(tau)
            && (1e-150 <= tau)
            && (tau <= 1e150)
            && PTC_FINITE_F64(t0)
            && (u_max > 0.0)
            && PTC_FINITE_F64(p_L)
            && PTC_FINITE_F64(p_R)
            && (0.1 <= p_i0)
            && (p_i0 <= 5.0)
            && (0.005 <= p_z0)
            && (p_z0 <= 0.02)
            && (tau > 0.001)) {
            const double f42 = p_L * (p_i0 * p_i0);
            const double f53 = -p_L;
            const double size_f42 = (fabs(p_L) <= 0.0) ? 1e-200 : fabs(f42);
            const double size_f53 = (fabs(p_L) <= 0.0) ? 1e-200 : fabs(f53);
            const double size_p_R = (fabs(p_R) <= 0.0) ? 1e-200 : fabs(p_R);
            const double f49 = (-19.62) * (p_z0 * p_z0);
            const double f56 = p_R * p_z0;
            const double f61 = f53 * p_i0;
            if ((size_f42 >= 1e-200)
                && (size_f53 >= 1e-200)
                && (size_p_R >= 1e-200)
                && PTC_FINITE_F64(f42)
                && PTC_FINITE_F64(f49)
                && PTC_FINITE_F64(f53)
                && PTC_FINITE_F64(f56)
                && PTC_FINITE_F64(f61)) {
                built.tau = tau;
                built.p_i0 = p_i0;
                built.p_z0 = p_z0;
                built.f42 = f42;
                built.f49 = f49;
                built.f53 = f53;
                built.p_R = p_R;
                built.f56 = f56;
                built.f61 = f61;
                built.u_max = u_max;
                built.t0 = 0.0;
                built.deadline = 0.0;
                built.correction = 0.0;
                status = levitation_arm(&built, t0);
                if (status == PTC_OK) {
                    *self = built;
                }
            }
        }
    }
    return status;
}

ptc_status levitation_arm(levitation *self, double t0)
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

ptc_status levitation_step(const levitation *self, double t, const double x[3], double *u)
{
    ptc_status status = PTC_E_INPUT;

    if (u != NULL) {
        *u = 0.0;
    }
    if ((self != NULL) && (x != NULL) && (u != NULL)) {
        if (t >= self->t0) {
            const double past = (t - self->deadline) - self->correction;
            const double late = (past < -0.001) ? past : -0.001;
            const double inv_T = (-1.0) / late;
            const double v1 = (1.0 + (x[2] / self->p_i0)) / (1.0 + (x[0] / self->p_z0));
            const double v2 = self->p_z0 + x[0];
            const double s1 = (((-120.0) * x[0] * inv_T) + ((-60.0) * x[1])) * inv_T;
            const double s2 = (s1 + ((-117.72) * (1.0 - (v1 * v1)))) * inv_T;
            const double v3 = s2 * (self->f42 * (v2 * v2));
            const double numerator = self->f49 * (self->p_i0 + x[2]);
            const double s3 = (((self->f53 * x[1]) - self->f56) - (self->p_R * x[0])) * x[2];
            const double drift = (s3 + (self->f61 * x[1])) / v2;
            const double s4 = v3 / (((numerator < 0.0) || (numerator > 0.0)) ? numerator : (double)NAN);
            const double v = s4 - drift;
            *u = v;
            if (PTC_FINITE_F64(v) && (fabs(v) <= self->u_max) && (late < -0.001)) {
                status = PTC_OK;
            } else if (PTC_FINITE_F64(t)
                && PTC_FINITE_F64(x[0])
                && PTC_FINITE_F64(x[1])
                && PTC_FINITE_F64(x[2])) {
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
