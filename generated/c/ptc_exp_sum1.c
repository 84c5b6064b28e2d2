/* Prescribed-time controller ptc_exp_sum1: see ptc_exp_sum1.h. DO NOT EDIT. */
#include "ptc_exp_sum1.h"

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

ptc_status ptc_exp_sum1_init(ptc_exp_sum1 *self, const ptc_exp_sum1_params *params)
{
    ptc_status status = PTC_E_PARAM;
    struct ptc_exp_sum1 built;

    if ((self != NULL) && (params != NULL)) {
        const double tau = params->tau;
        const double t0 = params->t0;
        const double eps = params->eps;
        const double u_max = params->u_max;
        const double a1 = params->rates[0];
        const double a2 = params->rates[1];
        const double k1 = params->k[0];
        if (PTC_FINITE_F64(tau)
            && (1e-150 <= tau)
            && (tau <= 1e150)
            && PTC_FINITE_F64(t0)
            && (eps >= 1e-150)
            && (u_max > 0.0)
            && PTC_FINITE_F64(a1)
            && (1e-150 <= a1)
            && (a1 <= 1e150)
            && PTC_FINITE_F64(a2)
            && (1e-150 <= a2)
            && (a2 <= 1e150)
            && PTC_FINITE_F64(k1)
            && (eps < tau)) {
            const double hold_from = -eps;
            const double target_rate = 2.0 / tau;
            const double v1 = 1.0 / a1;
            const double v2 = 1.0 / a2;
            const double slowest = (v1 < v2) ? v2 : v1;
            const double mean_period = 2.0 / (a1 + a2);
            const double s1 = (a1 < a2) ? a2 : a1;
            const double tolerance = 0.03 / s1;
            const double b1_1 = 0.5 * a1 * tau;
            const double b1_2 = 0.5 * a2 * tau;
            const double w1 = -k1;
            const double size_w1 = (fabs(k1) <= 0.0) ? 1e-200 : fabs(w1);
            if ((size_w1 >= 1e-200)
                && PTC_FINITE_F64(hold_from)
                && PTC_FINITE_F64(target_rate)
                && PTC_FINITE_F64(slowest)
                && PTC_FINITE_F64(mean_period)
                && PTC_FINITE_F64(tolerance)
                && PTC_FINITE_F64(b1_1)
                && PTC_FINITE_F64(b1_2)
                && PTC_FINITE_F64(w1)) {
                built.a1 = a1;
                built.a2 = a2;
                built.tau = tau;
                built.eps = eps;
                built.hold_from = hold_from;
                built.target_rate = target_rate;
                built.slowest = slowest;
                built.mean_period = mean_period;
                built.tolerance = tolerance;
                built.b1_1 = b1_1;
                built.b1_2 = b1_2;
                built.w1 = w1;
                built.u_max = u_max;
                built.t0 = 0.0;
                built.deadline = 0.0;
                built.correction = 0.0;
                status = ptc_exp_sum1_arm(&built, t0);
                if (status == PTC_OK) {
                    *self = built;
                }
            }
        }
    }
    return status;
}

ptc_status ptc_exp_sum1_arm(ptc_exp_sum1 *self, double t0)
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

ptc_status ptc_exp_sum1_step(const ptc_exp_sum1 *self, double t, const double x[1], double *u)
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
            const double target = T * self->target_rate;
            const double v1 = -log(target / 2.0);
            const double v2 = v1 * self->mean_period;
            const double v3 = (v1 - 0.6931467056274414) * self->slowest;
            double y = (v2 < v3) ? v3 : v2;
            double y_low = v2;
            double y_high = v1 * self->slowest;
            for (uint32_t attempt = 0U; attempt < 12U; attempt++) {
                const double v4 = exp(-(self->a1 * y));
                const double v5 = exp(-(self->a2 * y));
                const double v6 = self->a1 * v4;
                const double v7 = v4 + v5;
                const double v8 = self->a2 * v5;
                const double v9 = (2.0 * (v7 - target)) / (v7 + target);
                const double v10 = v9 * (1.0 + (0.08333333333333333 * (v9 * v9)));
                const double v11 = 1.0 / (v6 + v8);
                const double v12 = v7 * v11;
                const double s1 = (((self->a1 * v6) + (self->a2 * v8)) * v11 * v12) - 1.0;
                const double v13 = v10 * v12 * (1.0 + (0.5 * v10 * s1));
                const double y_next = y + v13;
                const double y_size = fabs(v13);
                if (v10 > 0.0) {
                    y_low = y;
                } else {
                    y_high = y;
                }
                if ((y_low <= y_next) && (y_next <= y_high)) {
                    y = y_next;
                } else {
                    y = 0.5 * (y_low + y_high);
                }
                if (y_size <= self->tolerance) {
                    break;
                }
            }
            const double v14 = exp(-(self->a1 * y));
            const double v15 = exp(-(self->a2 * y));
            const double v16 = self->a1 * v14;
            const double v17 = self->a2 * v15;
            const double v18 = 1.0 / (v16 + v17);
            const double v19 = ((v14 + v15) - target) * v18;
            const double s2 = 1.0 + (0.5 * (((self->a1 * v16) + (self->a2 * v17)) * v18 * v19));
            const double v20 = v19 * s2;
            const double v21 = self->a1 * v20;
            const double v22 = self->a2 * v20;
            const double s3 = self->b1_1 * (v14 - (v14 * (v21 * (1.0 - (0.5 * v21)))));
            const double s4 = s3 + (self->b1_2 * (v15 - (v15 * (v22 * (1.0 - (0.5 * v22))))));
            const double inv_r1 = 1.0 / s4;
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

ptc_status ptc_exp_sum1_tick(const ptc_exp_sum1 *self, double t, ptc_exp_sum1_gains *gains)
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (gains != NULL)) {
        if (PTC_FINITE_F64(t) && (t >= self->t0)) {
            const double past = (t - self->deadline) - self->correction;
            const double late = (past < self->hold_from) ? past : self->hold_from;
            const double T = -late;
            const double target = T * self->target_rate;
            const double v1 = -log(target / 2.0);
            const double v2 = v1 * self->mean_period;
            const double v3 = (v1 - 0.6931467056274414) * self->slowest;
            double y = (v2 < v3) ? v3 : v2;
            double y_low = v2;
            double y_high = v1 * self->slowest;
            for (uint32_t attempt = 0U; attempt < 12U; attempt++) {
                const double v4 = exp(-(self->a1 * y));
                const double v5 = exp(-(self->a2 * y));
                const double v6 = self->a1 * v4;
                const double v7 = v4 + v5;
                const double v8 = self->a2 * v5;
                const double v9 = (2.0 * (v7 - target)) / (v7 + target);
                const double v10 = v9 * (1.0 + (0.08333333333333333 * (v9 * v9)));
                const double v11 = 1.0 / (v6 + v8);
                const double v12 = v7 * v11;
                const double s1 = (((self->a1 * v6) + (self->a2 * v8)) * v11 * v12) - 1.0;
                const double v13 = v10 * v12 * (1.0 + (0.5 * v10 * s1));
                const double y_next = y + v13;
                const double y_size = fabs(v13);
                if (v10 > 0.0) {
                    y_low = y;
                } else {
                    y_high = y;
                }
                if ((y_low <= y_next) && (y_next <= y_high)) {
                    y = y_next;
                } else {
                    y = 0.5 * (y_low + y_high);
                }
                if (y_size <= self->tolerance) {
                    break;
                }
            }
            const double v14 = exp(-(self->a1 * y));
            const double v15 = exp(-(self->a2 * y));
            const double v16 = self->a1 * v14;
            const double v17 = self->a2 * v15;
            const double v18 = 1.0 / (v16 + v17);
            const double v19 = ((v14 + v15) - target) * v18;
            const double s2 = 1.0 + (0.5 * (((self->a1 * v16) + (self->a2 * v17)) * v18 * v19));
            const double v20 = v19 * s2;
            const double v21 = self->a1 * v20;
            const double v22 = self->a2 * v20;
            const double s3 = self->b1_1 * (v14 - (v14 * (v21 * (1.0 - (0.5 * v21)))));
            const double s4 = s3 + (self->b1_2 * (v15 - (v15 * (v22 * (1.0 - (0.5 * v22))))));
            const double inv_r1 = 1.0 / s4;
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

ptc_status ptc_exp_sum1_axis(const ptc_exp_sum1_gains *gains, const double x[1], double *u)
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
