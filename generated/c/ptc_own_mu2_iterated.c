/* Prescribed-time controller ptc_own_mu2_iterated: see ptc_own_mu2_iterated.h. DO NOT EDIT. */
#include "ptc_own_mu2_iterated.h"

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

ptc_status ptc_own_mu2_iterated_init(
    ptc_own_mu2_iterated *self,
    const ptc_own_mu2_iterated_params *params)
{
    ptc_status status = PTC_E_PARAM;
    struct ptc_own_mu2_iterated built;

    if ((self != NULL) && (params != NULL)) {
        const double tau = params->tau;
        const double t0 = params->t0;
        const double eps = params->eps;
        const double u_max = params->u_max;
        const double k1 = params->k[0];
        const double k2 = params->k[1];
        const double p_a = params->a;
        if (PTC_FINITE_F64(tau)
            && (1e-150 <= tau)
            && (tau <= 1e150)
            && PTC_FINITE_F64(t0)
            && (eps >= 1e-150)
            && (u_max > 0.0)
            && PTC_FINITE_F64(k1)
            && PTC_FINITE_F64(k2)
            && PTC_FINITE_F64(p_a)
            && (1e-150 <= p_a)
            && (p_a <= 1e150)
            && (eps < tau)) {
            const double hold_from = -eps;
            const double f29 = (-2.0) * p_a;
            const double w1 = -k1;
            const double w2 = -k2;
            const double size_w1 = (fabs(k1) <= 0.0) ? 1e-200 : fabs(w1);
            const double size_w2 = (fabs(k2) <= 0.0) ? 1e-200 : fabs(w2);
            const double f63 = f29 * f29 * 0.5;
            if ((size_w1 >= 1e-200)
                && (size_w2 >= 1e-200)
                && PTC_FINITE_F64(hold_from)
                && PTC_FINITE_F64(f29)
                && PTC_FINITE_F64(f63)
                && PTC_FINITE_F64(w1)
                && PTC_FINITE_F64(w2)) {
                built.tau = tau;
                built.eps = eps;
                built.hold_from = hold_from;
                built.f29 = f29;
                built.f63 = f63;
                built.w1 = w1;
                built.w2 = w2;
                built.u_max = u_max;
                built.t0 = 0.0;
                built.deadline = 0.0;
                built.correction = 0.0;
                status = ptc_own_mu2_iterated_arm(&built, t0);
                if (status == PTC_OK) {
                    *self = built;
                }
            }
        }
    }
    return status;
}

ptc_status ptc_own_mu2_iterated_arm(ptc_own_mu2_iterated *self, double t0)
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

ptc_status ptc_own_mu2_iterated_step(
    const ptc_own_mu2_iterated *self,
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
            const double T = -late;
            double y = 0.0;
            double y_low = 0.0;
            double y_high = 1e300;
            for (uint32_t attempt = 0U; attempt < 100U; attempt++) {
                const double v1 = (y + 1.0) * 2.0;
                const double v2 = self->tau / v1;
                const double v3 = exp(y * self->f29);
                const double v4 = 1.0 + v3;
                const double v5 = (v3 * self->tau) / v4;
                const double v6 = v2 + v5;
                const double v7 = log(v6 / T);
                const double s1 = v5 * ((-(v3 * self->f29 * (1.0 / v4))) + self->f29);
                const double y_next = y - (v7 * (v6 / ((v2 * (-(2.0 * (1.0 / v1)))) + s1)));
                const double y_size = fabs(v7);
                if (v7 > 0.0) {
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
            const double v8 = (y + 1.0) * 2.0;
            const double v9 = 2.0 * (1.0 / v8);
            const double v10 = -v9;
            const double v11 = self->tau / v8;
            const double v12 = exp(y * self->f29);
            const double v13 = 1.0 + v12;
            const double v14 = 1.0 / v13;
            const double v15 = v12 * self->f29 * v14;
            const double v16 = -v15;
            const double v17 = (v12 * self->tau) / v13;
            const double v18 = (v11 * v10) + (v17 * (v16 + self->f29));
            const double inv_r1 = 1.0 / (-v18);
            const double s2 = (-((v15 * v16) + (v12 * self->f63 * v14))) + (self->f29 * v16);
            const double s3 = ((v11 * (-(v9 * v10))) + (v17 * (s2 + self->f63))) * (1.0 / v18);
            const double s4 = (self->w1 * x[0] * inv_r1) + ((self->w2 + ((-2.0) * s3)) * x[1]);
            const double v = s4 * inv_r1;
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

ptc_status ptc_own_mu2_iterated_tick(
    const ptc_own_mu2_iterated *self,
    double t,
    ptc_own_mu2_iterated_gains *gains)
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
                const double v1 = (y + 1.0) * 2.0;
                const double v2 = self->tau / v1;
                const double v3 = exp(y * self->f29);
                const double v4 = 1.0 + v3;
                const double v5 = (v3 * self->tau) / v4;
                const double v6 = v2 + v5;
                const double v7 = log(v6 / T);
                const double s1 = v5 * ((-(v3 * self->f29 * (1.0 / v4))) + self->f29);
                const double y_next = y - (v7 * (v6 / ((v2 * (-(2.0 * (1.0 / v1)))) + s1)));
                const double y_size = fabs(v7);
                if (v7 > 0.0) {
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
            const double v8 = (y + 1.0) * 2.0;
            const double v9 = 2.0 * (1.0 / v8);
            const double v10 = -v9;
            const double v11 = self->tau / v8;
            const double v12 = exp(y * self->f29);
            const double v13 = 1.0 + v12;
            const double v14 = 1.0 / v13;
            const double v15 = v12 * self->f29 * v14;
            const double v16 = -v15;
            const double v17 = (v12 * self->tau) / v13;
            const double v18 = (v11 * v10) + (v17 * (v16 + self->f29));
            const double inv_r1 = 1.0 / (-v18);
            const double s2 = (-((v15 * v16) + (v12 * self->f63 * v14))) + (self->f29 * v16);
            const double s3 = ((v11 * (-(v9 * v10))) + (v17 * (s2 + self->f63))) * (1.0 / v18);
            gains->gain[0] = self->w1 * inv_r1 * inv_r1;
            gains->gain[1] = (self->w2 + ((-2.0) * s3)) * inv_r1;
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

ptc_status ptc_own_mu2_iterated_axis(
    const ptc_own_mu2_iterated_gains *gains,
    const double x[2],
    double *u)
{
    ptc_status status = PTC_E_INPUT;

    if (u != NULL) {
        *u = 0.0;
    }
    if ((gains != NULL) && (x != NULL) && (u != NULL)) {
        const double v = (gains->gain[0] * x[0]) + (gains->gain[1] * x[1]);
        *u = v;
        if (PTC_FINITE_F64(v) && (fabs(v) <= gains->u_max)) {
            status = gains->status;
        } else if (PTC_FINITE_F64(x[0]) && PTC_FINITE_F64(x[1])) {
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
