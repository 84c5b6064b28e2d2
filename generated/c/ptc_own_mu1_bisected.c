/* Prescribed-time controller ptc_own_mu1_bisected: see ptc_own_mu1_bisected.h. DO NOT EDIT. */
#include "ptc_own_mu1_bisected.h"

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

ptc_status ptc_own_mu1_bisected_init(
    ptc_own_mu1_bisected *self,
    const ptc_own_mu1_bisected_params *params)
{
    ptc_status status = PTC_E_PARAM;
    struct ptc_own_mu1_bisected built;

    if ((self != NULL) && (params != NULL)) {
        const double tau = params->tau;
        const double t0 = params->t0;
        const double eps = params->eps;
        const double u_max = params->u_max;
        const double k1 = params->k[0];
        if (PTC_FINITE_F64(tau)
            && (1e-150 <= tau)
            && (tau <= 1e150)
            && PTC_FINITE_F64(t0)
            && (eps >= 1e-150)
            && (u_max > 0.0)
            && PTC_FINITE_F64(k1)
            && (eps < tau)) {
            const double hold_from = -eps;
            const double w1 = -k1;
            const double size_w1 = (fabs(k1) <= 0.0) ? 1e-200 : fabs(w1);
            if ((size_w1 >= 1e-200) && PTC_FINITE_F64(hold_from) && PTC_FINITE_F64(w1)) {
                built.tau = tau;
                built.eps = eps;
                built.hold_from = hold_from;
                built.w1 = w1;
                built.u_max = u_max;
                built.t0 = 0.0;
                built.deadline = 0.0;
                built.correction = 0.0;
                status = ptc_own_mu1_bisected_arm(&built, t0);
                if (status == PTC_OK) {
                    *self = built;
                }
            }
        }
    }
    return status;
}

ptc_status ptc_own_mu1_bisected_arm(ptc_own_mu1_bisected *self, double t0)
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

ptc_status ptc_own_mu1_bisected_step(
    const ptc_own_mu1_bisected *self,
    double t,
    const double x[1],
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
            const double T = -late;
            double y = 0.0;
            double y_low = 0.0;
            double y_high = 1e300;
            for (uint32_t attempt = 0U; attempt < 100U; attempt++) {
                const double v1 = 1.0 + (y * y);
                const double v2 = sqrt(v1);
                const double v3 = 1.0 / (y + 1.0 + v2);
                const double v4 = pow(v3 * 2.0, 0.1) * self->tau;
                const double v5 = log(v4 / T);
                const double s1 = (-((1.0 + (v2 * (0.5 * ((y + y) * (1.0 / v1))))) * v3)) * 2.0 * 0.5;
                const double y_next = y - (v5 * (v4 / (v4 * (0.1 * s1))));
                const double y_size = fabs(v5);
                if (v5 > 0.0) {
                    y_low = y;
                } else {
                    y_high = y;
                }
                if ((y_low <= y_next) && (y_next <= y_high)) {
                    y = y_next;
                } else {
                    y = 0.5 * (y_low + y_high);
                }
                if (y_size <= 1e-9) {
                    break;
                }
                if (attempt > 39U) {
                    y = sqrt(y_low + 1e-300) * sqrt(y_high);
                }
            }
            const double v6 = 1.0 + (y * y);
            const double v7 = sqrt(v6);
            const double s2 = -((1.0 + (v7 * (0.5 * ((y + y) * (1.0 / v6))))) * (1.0 / (y + 1.0 + v7)));
            const double inv_r1 = 1.0 / (T * (-(0.1 * (s2 * 2.0 * 0.5))));
            const double v = self->w1 * x[0] * inv_r1;
            *u = v;
            if (PTC_FINITE_F64(v) && (fabs(v) <= self->u_max) && (late < self->hold_from)) {
                status = PTC_OK;
            } else if (PTC_FINITE_F64(t) && PTC_FINITE_F64(x[0])) {
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

ptc_status ptc_own_mu1_bisected_tick(
    const ptc_own_mu1_bisected *self,
    double t,
    ptc_own_mu1_bisected_gains *gains)
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (gains != NULL)) {
        if (PTC_FINITE_F64(t) && (t >= self->t0)) {
            const double past = (t - self->deadline) - self->correction;
            const double late = (past < self->hold_from) ? past : self->hold_from;
            const double T = -late;
            double y = 0.0;
            double y_low = 0.0;
            double y_high = 1e300;
            for (uint32_t attempt = 0U; attempt < 100U; attempt++) {
                const double v1 = 1.0 + (y * y);
                const double v2 = sqrt(v1);
                const double v3 = 1.0 / (y + 1.0 + v2);
                const double v4 = pow(v3 * 2.0, 0.1) * self->tau;
                const double v5 = log(v4 / T);
                const double s1 = (-((1.0 + (v2 * (0.5 * ((y + y) * (1.0 / v1))))) * v3)) * 2.0 * 0.5;
                const double y_next = y - (v5 * (v4 / (v4 * (0.1 * s1))));
                const double y_size = fabs(v5);
                if (v5 > 0.0) {
                    y_low = y;
                } else {
                    y_high = y;
                }
                if ((y_low <= y_next) && (y_next <= y_high)) {
                    y = y_next;
                } else {
                    y = 0.5 * (y_low + y_high);
                }
                if (y_size <= 1e-9) {
                    break;
                }
                if (attempt > 39U) {
                    y = sqrt(y_low + 1e-300) * sqrt(y_high);
                }
            }
            const double v6 = 1.0 + (y * y);
            const double v7 = sqrt(v6);
            const double s2 = -((1.0 + (v7 * (0.5 * ((y + y) * (1.0 / v6))))) * (1.0 / (y + 1.0 + v7)));
            const double inv_r1 = 1.0 / (T * (-(0.1 * (s2 * 2.0 * 0.5))));
            gains->gain[0] = self->w1 * inv_r1;
            gains->u_max = self->u_max;
            if (late < self->hold_from) {
                status = PTC_OK;
            } else {
                status = PTC_HOLD;
            }
            gains->status = status;
        }
    }
    return status;
}

ptc_status ptc_own_mu1_bisected_axis(
    const ptc_own_mu1_bisected_gains *gains,
    const double x[1],
    double *u)
{
    ptc_status status = PTC_E_INPUT;

    if (u != NULL) {
        *u = 0.0;
    }
    if ((gains != NULL) && (x != NULL) && (u != NULL)) {
        const double v = gains->gain[0] * x[0];
        *u = v;
        if (PTC_FINITE_F64(v) && (fabs(v) <= gains->u_max)) {
            status = gains->status;
        } else if (PTC_FINITE_F64(x[0])) {
            if (PTC_FINITE_F64(v)) {
                if (v > gains->u_max) {
                    *u = gains->u_max;
                    status = PTC_SATURATED;
                } else {
                    *u = -gains->u_max;
                    status = PTC_SATURATED;
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
    return status;
}
