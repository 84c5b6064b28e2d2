/* Prescribed-time controller ptc_algebraic5: see ptc_algebraic5.h. DO NOT EDIT. */
#include "ptc_algebraic5.h"

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

ptc_status ptc_algebraic5_init(ptc_algebraic5 *self, const ptc_algebraic5_params *params)
{
    ptc_status status = PTC_E_PARAM;
    struct ptc_algebraic5 built;

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
            const double v1 = a * a;
            const double v2 = v1 * v1;
            const double v3 = a * v2;
            const double K1 = k1 / v3;
            const double K2 = k2 / v2;
            const double v4 = a * v1;
            const double K3 = k3 / v4;
            const double K4 = k4 / v1;
            const double K5 = k5 / a;
            const double v5 = tau * tau;
            const double v6 = v5 * v5;
            const double v7 = tau * v6;
            const double c1_5 = (-K1) / v7;
            const double hold_from = -eps;
            const double two_tau = 2.0 * tau;
            const double half_tau = 0.5 * tau;
            const double v8 = -K2;
            const double v9 = (v8 + (3.0 * K4)) - 45.0;
            const double c2_0 = v9 / v6;
            const double v10 = 3.0 * K3;
            const double v11 = v10 - (45.0 * K5);
            const double c2_1 = v11 / v6;
            const double v12 = -(4.0 * K2);
            const double v13 = (v12 - (6.0 * K4)) + 540.0;
            const double c2_2 = v13 / v6;
            const double v14 = 9.0 * K3;
            const double v15 = v14 + (15.0 * K5);
            const double c2_3 = v15 / v6;
            const double v16 = ((-(6.0 * K2)) - (21.0 * K4)) - 360.0;
            const double c2_4 = v16 / v6;
            const double v17 = v14 + (60.0 * K5);
            const double c2_5 = v17 / v6;
            const double v18 = v12 - (12.0 * K4);
            const double c2_6 = v18 / v6;
            const double c2_7 = v10 / v6;
            const double c2_8 = v8 / v6;
            const double inv_tau = 1.0 / tau;
            const double v19 = -K3;
            const double v20 = v19 + (12.0 * K5);
            const double v21 = tau * v5;
            const double c3_0 = v20 / v21;
            const double v22 = 9.0 * K4;
            const double v23 = v22 - 315.0;
            const double c3_1 = v23 / v21;
            const double v24 = -v10;
            const double v25 = v24 - (63.0 * K5);
            const double c3_2 = v25 / v21;
            const double v26 = (18.0 * K4) + 660.0;
            const double c3_3 = v26 / v21;
            const double v27 = v24 - (75.0 * K5);
            const double c3_4 = v27 / v21;
            const double c3_5 = v22 / v21;
            const double c3_6 = v19 / v21;
            const double v28 = -K4;
            const double c4_0 = (v28 + 30.0) / v5;
            const double c4_3 = (18.0 * K5) / v5;
            const double c4_2 = ((-(2.0 * K4)) - 255.0) / v5;
            const double c4_4 = v28 / v5;
            const double c5_2 = (-K5) / tau;
            const double c5_1 = 30.0 / tau;
            const double size_K1 = (fabs(k1) <= 0.0) ? 1e-200 : fabs(K1);
            const double size_K2 = (fabs(k2) <= 0.0) ? 1e-200 : fabs(K2);
            const double size_K3 = (fabs(k3) <= 0.0) ? 1e-200 : fabs(K3);
            const double size_K4 = (fabs(k4) <= 0.0) ? 1e-200 : fabs(K4);
            const double size_K5 = (fabs(k5) <= 0.0) ? 1e-200 : fabs(K5);
            const double size_c1_5 = (fabs(k1) <= 0.0) ? 1e-200 : fabs(c1_5);
            const double size_c2_0 = (fabs(v9) <= 0.0) ? 1e-200 : fabs(c2_0);
            const double size_c2_1 = (fabs(v11) <= 0.0) ? 1e-200 : fabs(c2_1);
            const double size_c2_2 = (fabs(v13) <= 0.0) ? 1e-200 : fabs(c2_2);
            const double size_c2_3 = (fabs(v15) <= 0.0) ? 1e-200 : fabs(c2_3);
            const double size_c2_4 = (fabs(v16) <= 0.0) ? 1e-200 : fabs(c2_4);
            const double size_c2_5 = (fabs(v17) <= 0.0) ? 1e-200 : fabs(c2_5);
            const double size_c2_6 = (fabs(v18) <= 0.0) ? 1e-200 : fabs(c2_6);
            const double size_c2_7 = (fabs(k3) <= 0.0) ? 1e-200 : fabs(c2_7);
            const double size_c2_8 = (fabs(k2) <= 0.0) ? 1e-200 : fabs(c2_8);
            const double size_c3_0 = (fabs(v20) <= 0.0) ? 1e-200 : fabs(c3_0);
            const double size_c3_1 = (fabs(v23) <= 0.0) ? 1e-200 : fabs(c3_1);
            const double size_c3_2 = (fabs(v25) <= 0.0) ? 1e-200 : fabs(c3_2);
            const double size_c3_3 = (fabs(v26) <= 0.0) ? 1e-200 : fabs(c3_3);
            const double size_c3_4 = (fabs(v27) <= 0.0) ? 1e-200 : fabs(c3_4);
            const double size_c3_5 = (fabs(k4) <= 0.0) ? 1e-200 : fabs(c3_5);
            const double size_c3_6 = (fabs(k3) <= 0.0) ? 1e-200 : fabs(c3_6);
            const double size_c4_3 = (fabs(k5) <= 0.0) ? 1e-200 : fabs(c4_3);
            const double size_c4_4 = (fabs(k4) <= 0.0) ? 1e-200 : fabs(c4_4);
            const double size_c5_2 = (fabs(k5) <= 0.0) ? 1e-200 : fabs(c5_2);
            if ((v2 >= 1e-200)
                && (v3 >= 1e-200)
                && (size_K1 >= 1e-200)
                && (size_K2 >= 1e-200)
                && (v4 >= 1e-200)
                && (size_K3 >= 1e-200)
                && (size_K4 >= 1e-200)
                && (size_K5 >= 1e-200)
                && (v6 >= 1e-200)
                && (v7 >= 1e-200)
                && (size_c1_5 >= 1e-200)
                && (size_c2_0 >= 1e-200)
                && (size_c2_1 >= 1e-200)
                && (size_c2_2 >= 1e-200)
                && (size_c2_3 >= 1e-200)
                && (size_c2_4 >= 1e-200)
                && (size_c2_5 >= 1e-200)
                && (size_c2_6 >= 1e-200)
                && (size_c2_7 >= 1e-200)
                && (size_c2_8 >= 1e-200)
                && (v21 >= 1e-200)
                && (size_c3_0 >= 1e-200)
                && (size_c3_1 >= 1e-200)
                && (size_c3_2 >= 1e-200)
                && (size_c3_3 >= 1e-200)
                && (size_c3_4 >= 1e-200)
                && (size_c3_5 >= 1e-200)
                && (size_c3_6 >= 1e-200)
                && (size_c4_3 >= 1e-200)
                && (size_c4_4 >= 1e-200)
                && (size_c5_2 >= 1e-200)
                && PTC_FINITE_F64(c1_5)
                && PTC_FINITE_F64(hold_from)
                && PTC_FINITE_F64(two_tau)
                && PTC_FINITE_F64(half_tau)
                && PTC_FINITE_F64(c2_0)
                && PTC_FINITE_F64(c2_1)
                && PTC_FINITE_F64(c2_2)
                && PTC_FINITE_F64(c2_3)
                && PTC_FINITE_F64(c2_4)
                && PTC_FINITE_F64(c2_5)
                && PTC_FINITE_F64(c2_6)
                && PTC_FINITE_F64(c2_7)
                && PTC_FINITE_F64(c2_8)
                && PTC_FINITE_F64(inv_tau)
                && PTC_FINITE_F64(c3_0)
                && PTC_FINITE_F64(c3_1)
                && PTC_FINITE_F64(c3_2)
                && PTC_FINITE_F64(c3_3)
                && PTC_FINITE_F64(c3_4)
                && PTC_FINITE_F64(c3_5)
                && PTC_FINITE_F64(c3_6)
                && PTC_FINITE_F64(c4_0)
                && PTC_FINITE_F64(c4_3)
                && PTC_FINITE_F64(c4_2)
                && PTC_FINITE_F64(c4_4)
                && PTC_FINITE_F64(c5_2)
                && PTC_FINITE_F64(c5_1)) {
                built.tau = tau;
                built.c1_5 = c1_5;
                built.eps = eps;
                built.hold_from = hold_from;
                built.two_tau = two_tau;
                built.half_tau = half_tau;
                built.c2_0 = c2_0;
                built.c2_1 = c2_1;
                built.c2_2 = c2_2;
                built.c2_3 = c2_3;
                built.c2_4 = c2_4;
                built.c2_5 = c2_5;
                built.c2_6 = c2_6;
                built.c2_7 = c2_7;
                built.c2_8 = c2_8;
                built.inv_tau = inv_tau;
                built.c3_0 = c3_0;
                built.c3_1 = c3_1;
                built.c3_2 = c3_2;
                built.c3_3 = c3_3;
                built.c3_4 = c3_4;
                built.c3_5 = c3_5;
                built.c3_6 = c3_6;
                built.c4_0 = c4_0;
                built.c4_3 = c4_3;
                built.c4_2 = c4_2;
                built.c4_4 = c4_4;
                built.c5_2 = c5_2;
                built.c5_1 = c5_1;
                built.u_max = u_max;
                built.t0 = 0.0;
                built.deadline = 0.0;
                built.correction = 0.0;
                status = ptc_algebraic5_arm(&built, t0);
                if (status == PTC_OK) {
                    *self = built;
                }
            }
        }
    }
    return status;
}

ptc_status ptc_algebraic5_arm(ptc_algebraic5 *self, double t0)
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

ptc_status ptc_algebraic5_step(const ptc_algebraic5 *self, double t, const double x[5], double *u)
{
    ptc_status status = PTC_E_INPUT;

    if (u != NULL) {
        *u = 0.0;
    }
    if ((self != NULL) && (x != NULL) && (u != NULL)) {
        if (t >= self->t0) {
            const double past = (t - self->deadline) - self->correction;
            const double late = (past < self->hold_from) ? past : self->hold_from;
            const double s1 = self->half_tau / (self->two_tau + late);
            const double one_plus_y2 = s1 - (self->half_tau / late);
            const double v1 = one_plus_y2 * one_plus_y2;
            const double row1 = self->c1_5 * one_plus_y2 * v1 * v1;
            const double sec = sqrt(one_plus_y2);
            const double y = (self->tau + late) * self->inv_tau * sec;
            const double y_squared = one_plus_y2 - 1.0;
            const double s2 = ((self->c2_8 * y_squared) + self->c2_6) * y_squared;
            const double s3 = (((s2 + self->c2_4) * y_squared) + self->c2_2) * y_squared;
            const double s4 = ((self->c2_7 * y_squared) + self->c2_5) * y_squared;
            const double s5 = (((s4 + self->c2_3) * y_squared) + self->c2_1) * y;
            const double row2 = s3 + self->c2_0 + s5;
            const double s6 = ((self->c3_6 * y_squared) + self->c3_4) * y_squared;
            const double s7 = ((self->c3_5 * y_squared) + self->c3_3) * y_squared;
            const double s8 = ((s6 + self->c3_2) * y_squared) + self->c3_0;
            const double row3 = s8 + ((s7 + self->c3_1) * y);
            const double s9 = ((self->c4_4 * y_squared) + self->c4_2) * y_squared;
            const double row4 = s9 + self->c4_0 + (((self->c4_3 * y_squared) + self->c4_3) * y);
            const double row5 = (self->c5_2 * y_squared) + self->c5_2 + (self->c5_1 * y);
            const double s10 = ((((row1 * x[0] * sec) + (row2 * x[1])) * sec) + (row3 * x[2])) * sec;
            const double v = (((s10 + (row4 * x[3])) * sec) + (row5 * x[4])) * sec;
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

ptc_status ptc_algebraic5_tick(const ptc_algebraic5 *self, double t, ptc_algebraic5_gains *gains)
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (gains != NULL)) {
        if (PTC_FINITE_F64(t) && (t >= self->t0)) {
            const double past = (t - self->deadline) - self->correction;
            const double late = (past < self->hold_from) ? past : self->hold_from;
            const double s1 = self->half_tau / (self->two_tau + late);
            const double one_plus_y2 = s1 - (self->half_tau / late);
            const double v1 = one_plus_y2 * one_plus_y2;
            const double row1 = self->c1_5 * one_plus_y2 * v1 * v1;
            const double sec = sqrt(one_plus_y2);
            const double y = (self->tau + late) * self->inv_tau * sec;
            const double y_squared = one_plus_y2 - 1.0;
            const double s2 = ((self->c2_8 * y_squared) + self->c2_6) * y_squared;
            const double s3 = (((s2 + self->c2_4) * y_squared) + self->c2_2) * y_squared;
            const double s4 = ((self->c2_7 * y_squared) + self->c2_5) * y_squared;
            const double s5 = (((s4 + self->c2_3) * y_squared) + self->c2_1) * y;
            const double row2 = s3 + self->c2_0 + s5;
            const double s6 = ((self->c3_6 * y_squared) + self->c3_4) * y_squared;
            const double s7 = ((self->c3_5 * y_squared) + self->c3_3) * y_squared;
            const double s8 = ((s6 + self->c3_2) * y_squared) + self->c3_0;
            const double row3 = s8 + ((s7 + self->c3_1) * y);
            const double s9 = ((self->c4_4 * y_squared) + self->c4_2) * y_squared;
            const double row4 = s9 + self->c4_0 + (((self->c4_3 * y_squared) + self->c4_3) * y);
            const double row5 = (self->c5_2 * y_squared) + self->c5_2 + (self->c5_1 * y);
            const double v2 = sec * sec;
            gains->gain[0] = row1 * (v2 * sec) * v2;
            gains->gain[1] = row2 * v2 * v2;
            gains->gain[2] = row3 * v2 * sec;
            gains->gain[3] = row4 * sec * sec;
            gains->gain[4] = row5 * sec;
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

ptc_status ptc_algebraic5_axis(const ptc_algebraic5_gains *gains, const double x[5], double *u)
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
