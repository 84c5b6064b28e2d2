/* Prescribed-time controller ptc_rational5: see ptc_rational5.h. DO NOT EDIT. */
#include "ptc_rational5.h"

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

ptc_status ptc_rational5_init(ptc_rational5 *self, const ptc_rational5_params *params)
{
    ptc_status status = PTC_E_PARAM;
    struct ptc_rational5 built;

    if ((self != NULL) && (params != NULL)) {
        const double tau = params->tau;
        const double t0 = params->t0;
        const double eps = params->eps;
        const double u_max = params->u_max;
        const double a = params->a;
        const double k1 = params->k[0];
        const double k2 = params->k[1];
        const double k3 = params->k[2];
        const double k4 = params->k[3];
        const double k5 = params->k[4];
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
            && PTC_FINITE_F64(k3)
            && PTC_FINITE_F64(k4)
            && PTC_FINITE_F64(k5)
            && (eps < tau)) {
            const double rate = a / tau;
            const double v1 = rate * rate;
            const double v2 = v1 * v1;
            const double v3 = rate * v2;
            const double K1 = k1 / v3;
            const double K2 = k2 / v2;
            const double v4 = rate * v1;
            const double K3 = k3 / v4;
            const double K4 = k4 / v1;
            const double K5 = k5 / rate;
            const double c1 = -K1;
            const double c2_0 = -K2;
            const double c2_1 = -(2.0 * K3);
            const double c3_1 = -(6.0 * K4);
            const double c2_3 = -(24.0 * K5);
            const double hold_from = -eps;
            const double c3_0 = -K3;
            const double c3_2 = -(36.0 * K5);
            const double c4_0 = -K4;
            const double c4_1 = -(12.0 * K5);
            const double c5_0 = -K5;
            const double size_K1 = (fabs(k1) <= 0.0) ? 1e-200 : fabs(K1);
            const double size_K2 = (fabs(k2) <= 0.0) ? 1e-200 : fabs(K2);
            const double size_K3 = (fabs(k3) <= 0.0) ? 1e-200 : fabs(K3);
            const double size_K4 = (fabs(k4) <= 0.0) ? 1e-200 : fabs(K4);
            const double size_K5 = (fabs(k5) <= 0.0) ? 1e-200 : fabs(K5);
            if ((v1 >= 1e-200)
                && (v2 >= 1e-200)
                && (v3 >= 1e-200)
                && (size_K1 >= 1e-200)
                && (size_K2 >= 1e-200)
                && (v4 >= 1e-200)
                && (size_K3 >= 1e-200)
                && (size_K4 >= 1e-200)
                && (size_K5 >= 1e-200)
                && PTC_FINITE_F64(c1)
                && PTC_FINITE_F64(c2_0)
                && PTC_FINITE_F64(c2_1)
                && PTC_FINITE_F64(c3_1)
                && PTC_FINITE_F64(c2_3)
                && PTC_FINITE_F64(hold_from)
                && PTC_FINITE_F64(c3_0)
                && PTC_FINITE_F64(c3_2)
                && PTC_FINITE_F64(c4_0)
                && PTC_FINITE_F64(c4_1)
                && PTC_FINITE_F64(c5_0)) {
                built.tau = tau;
                built.c1 = c1;
                built.c2_0 = c2_0;
                built.c2_1 = c2_1;
                built.c3_1 = c3_1;
                built.c2_3 = c2_3;
                built.eps = eps;
                built.hold_from = hold_from;
                built.c3_0 = c3_0;
                built.c3_2 = c3_2;
                built.c4_0 = c4_0;
                built.c4_1 = c4_1;
                built.c5_0 = c5_0;
                built.u_max = u_max;
                built.t0 = 0.0;
                built.deadline = 0.0;
                built.correction = 0.0;
                status = ptc_rational5_arm(&built, t0);
                if (status == PTC_OK) {
                    *self = built;
                }
            }
        }
    }
    return status;
}

ptc_status ptc_rational5_arm(ptc_rational5 *self, double t0)
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

ptc_status ptc_rational5_step(const ptc_rational5 *self, double t, const double x[5], double *u)
{
    ptc_status status = PTC_E_INPUT;

    if (u != NULL) {
        *u = 0.0;
    }
    if ((self != NULL) && (x != NULL) && (u != NULL)) {
        if (t >= self->t0) {
            const double past = (t - self->deadline) - self->correction;
            const double late = (past < self->hold_from) ? past : self->hold_from;
            const double v1 = (-120.0) * late;
            const double s1 = ((((v1 + self->c2_3) * late) + self->c3_1) * late) + self->c2_1;
            const double row2 = (s1 * late) + self->c2_0;
            const double s2 = (((((-240.0) * late) + self->c3_2) * late) + self->c3_1) * late;
            const double row3 = s2 + self->c3_0;
            const double row4 = ((v1 + self->c4_1) * late) + self->c4_0;
            const double row5 = ((-20.0) * late) + self->c5_0;
            const double inv_T_squared = 1.0 / (late * late);
            const double s3 = (self->c1 * x[0] * inv_T_squared) + (row2 * x[1]);
            const double s4 = ((s3 * inv_T_squared) + (row3 * x[2])) * inv_T_squared;
            const double s5 = ((s4 + (row4 * x[3])) * inv_T_squared) + (row5 * x[4]);
            const double v = s5 * inv_T_squared;
            *u = v;
            if (PTC_FINITE_F64(v) && (fabs(v) <= self->u_max) && (late < self->hold_from)) {
                status = PTC_OK;
            } else if (PTC_FINITE_F64(t)
                && PTC_FINITE_F64(x[0])
                && PTC_FINITE_F64(x[1])
                && PTC_FINITE_F64(x[2])
                && PTC_FINITE_F64(x[3])
                && PTC_FINITE_F64(x[4])) {
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

ptc_status ptc_rational5_tick(const ptc_rational5 *self, double t, ptc_rational5_gains *gains)
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (gains != NULL)) {
        if (PTC_FINITE_F64(t) && (t >= self->t0)) {
            const double past = (t - self->deadline) - self->correction;
            const double late = (past < self->hold_from) ? past : self->hold_from;
            const double v1 = (-120.0) * late;
            const double s1 = ((((v1 + self->c2_3) * late) + self->c3_1) * late) + self->c2_1;
            const double row2 = (s1 * late) + self->c2_0;
            const double s2 = (((((-240.0) * late) + self->c3_2) * late) + self->c3_1) * late;
            const double row3 = s2 + self->c3_0;
            const double row4 = ((v1 + self->c4_1) * late) + self->c4_0;
            const double row5 = ((-20.0) * late) + self->c5_0;
            const double inv_T_squared = 1.0 / (late * late);
            const double v2 = inv_T_squared * inv_T_squared;
            gains->gain[0] = self->c1 * (v2 * inv_T_squared) * v2;
            gains->gain[1] = row2 * v2 * v2;
            gains->gain[2] = row3 * v2 * inv_T_squared;
            gains->gain[3] = row4 * inv_T_squared * inv_T_squared;
            gains->gain[4] = row5 * inv_T_squared;
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

ptc_status ptc_rational5_axis(const ptc_rational5_gains *gains, const double x[5], double *u)
{
    ptc_status status = PTC_E_INPUT;

    if (u != NULL) {
        *u = 0.0;
    }
    if ((gains != NULL) && (x != NULL) && (u != NULL)) {
        const double s1 = (gains->gain[0] * x[0]) + (gains->gain[1] * x[1]);
        const double s2 = s1 + (gains->gain[2] * x[2]) + (gains->gain[3] * x[3]);
        const double v = s2 + (gains->gain[4] * x[4]);
        *u = v;
        if (PTC_FINITE_F64(v) && (fabs(v) <= gains->u_max)) {
            status = gains->status;
        } else if (PTC_FINITE_F64(x[0])
            && PTC_FINITE_F64(x[1])
            && PTC_FINITE_F64(x[2])
            && PTC_FINITE_F64(x[3])
            && PTC_FINITE_F64(x[4])) {
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
