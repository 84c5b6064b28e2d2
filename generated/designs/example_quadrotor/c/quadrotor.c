/* Prescribed-time controller quadrotor: see quadrotor.h. DO NOT EDIT. */
#include "quadrotor.h"

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

ptc_status quadrotor_init(quadrotor *self, const quadrotor_params *params)
{
    ptc_status status = PTC_E_PARAM;
    struct quadrotor built;

    (void)params;
    if (self != NULL) {
        built.t0 = 0.0;
        built.deadline = 0.0;
        built.correction = 0.0;
        status = quadrotor_arm(&built, 0.0);
        if (status == PTC_OK) {
            *self = built;
        }
    }
    return status;
}

ptc_status quadrotor_arm(quadrotor *self, double t0)
{
    ptc_status status = PTC_E_PARAM;

    if (self != NULL) {
        if (PTC_FINITE_F64(t0)) {
            const double deadline = t0 + 2.0;
            const double v1 = deadline - t0;
            const double correction = (t0 - (deadline - v1)) + (2.0 - v1);
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

ptc_status quadrotor_tick(const quadrotor *self, double t, quadrotor_gains *gains)
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (gains != NULL)) {
        if (PTC_FINITE_F64(t) && (t >= self->t0)) {
            const double past = (t - self->deadline) - self->correction;
            const double late = (past < -0.02) ? past : -0.02;
            const double inv_T = (-1.0) / late;
            const double v1 = (-20.0) * inv_T * inv_T;
            const double v2 = (-8.0) * inv_T;
            const double v3 = (-42.0) * inv_T * inv_T;
            const double v4 = (-12.0) * inv_T;
            gains->gain[0] = v1;
            gains->gain[1] = v2;
            gains->gain[2] = v3;
            gains->gain[3] = v4;
            gains->gain[4] = v3;
            gains->gain[5] = v4;
            gains->gain[6] = v1;
            gains->gain[7] = v2;
            gains->input_gain[0] = 0.8333333333333334;
            gains->input_gain[1] = 83.33333333333333;
            gains->input_gain[2] = 76.92307692307692;
            gains->input_gain[3] = 45.45454545454545;
            gains->u_max[0] = 8.0;
            gains->u_max[1] = 0.4;
            gains->u_max[2] = 0.4;
            gains->u_max[3] = 0.1;
            if (late < -0.02) {
                status = PTC_OK;
            } else {
                status = PTC_HOLD;
            }
            gains->status = status;
        }
    }
    return status;
}

ptc_status quadrotor_axis(
    const quadrotor_gains *gains,
    uint32_t axis,
    const double x[2],
    const double r[3],
    double *u)
{
    ptc_status status = PTC_E_INPUT;

    if (u != NULL) {
        *u = 0.0;
    }
    if ((gains != NULL) && (x != NULL) && (r != NULL) && (u != NULL)) {
        if (axis < 4U) {
            const double e1 = x[0] - r[0];
            const double e2 = x[1] - r[1];
            const double s1 = gains->gain[2U * axis] * e1;
            const double v1 = s1 + (gains->gain[(2U * axis) + 1U] * e2) + r[2];
            const double g = gains->input_gain[axis];
            const double v = v1 / (((g < 0.0) || (g > 0.0)) ? g : (double)NAN);
            *u = v;
            if (PTC_FINITE_F64(v) && (fabs(v) <= gains->u_max[axis])) {
                status = gains->status;
            } else if (PTC_FINITE_F64(x[0])
                && PTC_FINITE_F64(x[1])
                && PTC_FINITE_F64(r[0])
                && PTC_FINITE_F64(r[1])
                && PTC_FINITE_F64(r[2])) {
                if (PTC_FINITE_F64(v)) {
                    if (v > gains->u_max[axis]) {
                        *u = gains->u_max[axis];
                        status = PTC_SATURATED;
                    } else {
                        *u = -gains->u_max[axis];
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
    }
    return status;
}

ptc_status quadrotor_step(
    const quadrotor *self,
    double t,
    const double x[4][2],
    const double r[4][3],
    double u[4],
    ptc_status axes[4])
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (x != NULL) && (r != NULL) && (u != NULL) && (axes != NULL)) {
        if (PTC_FINITE_F64(t) && (t >= self->t0)) {
            const double past = (t - self->deadline) - self->correction;
            const double late = (past < -0.02) ? past : -0.02;
            const double inv_T = (-1.0) / late;
            const double v1 = (-20.0) * inv_T * inv_T;
            const double v2 = (-8.0) * inv_T;
            const double v3 = (-42.0) * inv_T * inv_T;
            const double v4 = (-12.0) * inv_T;
            double gain[8];
            gain[0] = v1;
            gain[1] = v2;
            gain[2] = v3;
            gain[3] = v4;
            gain[4] = v3;
            gain[5] = v4;
            gain[6] = v1;
            gain[7] = v2;
            double input_gain[4];
            input_gain[0] = 0.8333333333333334;
            input_gain[1] = 83.33333333333333;
            input_gain[2] = 76.92307692307692;
            input_gain[3] = 45.45454545454545;
            double u_max[4];
            u_max[0] = 8.0;
            u_max[1] = 0.4;
            u_max[2] = 0.4;
            u_max[3] = 0.1;
            if (late < -0.02) {
                status = PTC_OK;
            } else {
                status = PTC_HOLD;
            }
            double wanted[4];
            for (uint32_t axis = 0U; axis < 4U; axis++) {
                const double e1 = x[axis][0] - r[axis][0];
                const double e2 = x[axis][1] - r[axis][1];
                const double v5 = (gain[2U * axis] * e1) + (gain[(2U * axis) + 1U] * e2) + r[axis][2];
                const double g = input_gain[axis];
                wanted[axis] = v5 / (((g < 0.0) || (g > 0.0)) ? g : (double)NAN);
            }
            u[0] = wanted[0];
            u[1] = wanted[1];
            u[2] = wanted[2];
            u[3] = wanted[3];
            for (uint32_t axis = 0U; axis < 4U; axis++) {
                axes[axis] = status;
            }
            uint32_t outside = 0U;
            for (uint32_t axis = 0U; axis < 4U; axis++) {
                const double v = wanted[axis];
                if (!(PTC_FINITE_F64(v) && (fabs(v) <= u_max[axis]))) {
                    outside = 1U;
                    break;
                }
            }
            if (outside == 1U) {
                for (uint32_t axis = 0U; axis < 4U; axis++) {
                    const double v = wanted[axis];
                    if (!(PTC_FINITE_F64(v) && (fabs(v) <= u_max[axis]))) {
                        if (PTC_FINITE_F64(x[axis][0])
                            && PTC_FINITE_F64(x[axis][1])
                            && PTC_FINITE_F64(r[axis][0])
                            && PTC_FINITE_F64(r[axis][1])
                            && PTC_FINITE_F64(r[axis][2])) {
                            if (PTC_FINITE_F64(v)) {
                                if (u_max[axis] < v) {
                                    u[axis] = u_max[axis];
                                    axes[axis] = PTC_SATURATED;
                                } else {
                                    u[axis] = -u_max[axis];
                                    axes[axis] = PTC_SATURATED;
                                }
                            } else {
                                axes[axis] = PTC_E_RANGE;
                            }
                        } else {
                            axes[axis] = PTC_E_INPUT;
                        }
                        if (status >= PTC_OK) {
                            status = axes[axis];
                        }
                    }
                }
                if (status < PTC_OK) {
                    for (uint32_t axis = 0U; axis < 4U; axis++) {
                        u[axis] = 0.0;
                    }
                }
            }
        } else {
            for (uint32_t i = 0U; i < 4U; i++) {
                u[i] = 0.0;
                axes[i] = PTC_E_INPUT;
            }
        }
    } else {
        if (u != NULL) {
            for (uint32_t i = 0U; i < 4U; i++) {
                u[i] = 0.0;
            }
        }
        if (axes != NULL) {
            for (uint32_t i = 0U; i < 4U; i++) {
                axes[i] = PTC_E_INPUT;
            }
        }
    }
    return status;
}
