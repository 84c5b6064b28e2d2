/* Prescribed-time controller ptc_exp3_axes3_own: see ptc_exp3_axes3_own.h. DO NOT EDIT. */
#include "ptc_exp3_axes3_own.h"

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

ptc_status ptc_exp3_axes3_own_init(
    ptc_exp3_axes3_own *self,
    const ptc_exp3_axes3_own_params *params)
{
    ptc_status status = PTC_E_PARAM;
    struct ptc_exp3_axes3_own built;

    if ((self != NULL) && (params != NULL)) {
        const double tau = params->tau;
        const double t0 = params->t0;
        const double eps = params->eps;
        const double p_m = params->m;
        if (PTC_FINITE_F64(tau)
            && (1e-150 <= tau)
            && (tau <= 1e150)
            && PTC_FINITE_F64(t0)
            && (eps >= 1e-150)
            && PTC_FINITE_F64(p_m)
            && (eps < tau)) {
            const double hold_from = -eps;
            const double input_gain = 1.0 / p_m;
            const double size_input_gain = (fabs(input_gain) <= 0.0) ? 1e-200 : fabs(input_gain);
            if ((size_input_gain >= 1e-200)
                && PTC_FINITE_F64(hold_from)
                && PTC_FINITE_F64(input_gain)) {
                built.tau = tau;
                built.eps = eps;
                built.hold_from = hold_from;
                built.input_gain = input_gain;
                built.t0 = 0.0;
                built.deadline = 0.0;
                built.correction = 0.0;
                status = ptc_exp3_axes3_own_arm(&built, t0);
                if (status == PTC_OK) {
                    *self = built;
                }
            }
        }
    }
    return status;
}

ptc_status ptc_exp3_axes3_own_arm(ptc_exp3_axes3_own *self, double t0)
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

ptc_status ptc_exp3_axes3_own_tick(
    const ptc_exp3_axes3_own *self,
    double t,
    ptc_exp3_axes3_own_gains *gains)
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (gains != NULL)) {
        if (PTC_FINITE_F64(t) && (t >= self->t0)) {
            const double past = (t - self->deadline) - self->correction;
            const double late = (past < self->hold_from) ? past : self->hold_from;
            const double inv_T = (-1.0) / late;
            const double v1 = inv_T * inv_T;
            const double v2 = (-120.0) * v1 * inv_T;
            const double v3 = (-60.0) * inv_T * inv_T;
            const double v4 = (-12.0) * inv_T;
            gains->gain[0] = v2;
            gains->gain[1] = v3;
            gains->gain[2] = v4;
            gains->gain[3] = v2;
            gains->gain[4] = v3;
            gains->gain[5] = v4;
            gains->gain[6] = (-336.0) * v1 * inv_T;
            gains->gain[7] = (-126.0) * inv_T * inv_T;
            gains->gain[8] = (-18.0) * inv_T;
            gains->input_gain[0] = self->input_gain;
            gains->input_gain[1] = self->input_gain;
            gains->input_gain[2] = 2.0;
            gains->u_max[0] = 40.0;
            gains->u_max[1] = 40.0;
            gains->u_max[2] = 15.0;
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

ptc_status ptc_exp3_axes3_own_axis(
    const ptc_exp3_axes3_own_gains *gains,
    uint32_t axis,
    const double x[3],
    double *u)
{
    ptc_status status = PTC_E_INPUT;

    if (u != NULL) {
        *u = 0.0;
    }
    if ((gains != NULL) && (x != NULL) && (u != NULL)) {
        if (axis < 3U) {
            const double s1 = gains->gain[3U * axis] * x[0];
            const double s2 = s1 + (gains->gain[(3U * axis) + 1U] * x[1]);
            const double v1 = s2 + (gains->gain[(3U * axis) + 2U] * x[2]);
            const double g = gains->input_gain[axis];
            const double v = v1 / (((g < 0.0) || (g > 0.0)) ? g : (double)NAN);
            *u = v;
            if (PTC_FINITE_F64(v) && (fabs(v) <= gains->u_max[axis])) {
                status = gains->status;
            } else if (PTC_FINITE_F64(x[0]) && PTC_FINITE_F64(x[1]) && PTC_FINITE_F64(x[2])) {
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

ptc_status ptc_exp3_axes3_own_step(
    const ptc_exp3_axes3_own *self,
    double t,
    const double x[3][3],
    double u[3],
    ptc_status axes[3])
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (x != NULL) && (u != NULL) && (axes != NULL)) {
        if (PTC_FINITE_F64(t) && (t >= self->t0)) {
            const double past = (t - self->deadline) - self->correction;
            const double late = (past < self->hold_from) ? past : self->hold_from;
            const double inv_T = (-1.0) / late;
            const double v1 = inv_T * inv_T;
            const double v2 = (-120.0) * v1 * inv_T;
            const double v3 = (-60.0) * inv_T * inv_T;
            const double v4 = (-12.0) * inv_T;
            double gain[9];
            gain[0] = v2;
            gain[1] = v3;
            gain[2] = v4;
            gain[3] = v2;
            gain[4] = v3;
            gain[5] = v4;
            gain[6] = (-336.0) * v1 * inv_T;
            gain[7] = (-126.0) * inv_T * inv_T;
            gain[8] = (-18.0) * inv_T;
            double input_gain[3];
            input_gain[0] = self->input_gain;
            input_gain[1] = self->input_gain;
            input_gain[2] = 2.0;
            double u_max[3];
            u_max[0] = 40.0;
            u_max[1] = 40.0;
            u_max[2] = 15.0;
            if (late < self->hold_from) {
                status = PTC_OK;
            } else {
                status = PTC_HOLD;
            }
            double wanted[3];
            for (uint32_t axis = 0U; axis < 3U; axis++) {
                const double s1 = (gain[3U * axis] * x[axis][0]) + (gain[(3U * axis) + 1U] * x[axis][1]);
                const double v5 = s1 + (gain[(3U * axis) + 2U] * x[axis][2]);
                const double g = input_gain[axis];
                wanted[axis] = v5 / (((g < 0.0) || (g > 0.0)) ? g : (double)NAN);
            }
            u[0] = wanted[0];
            u[1] = wanted[1];
            u[2] = wanted[2];
            for (uint32_t axis = 0U; axis < 3U; axis++) {
                axes[axis] = status;
            }
            uint32_t outside = 0U;
            for (uint32_t axis = 0U; axis < 3U; axis++) {
                const double v = wanted[axis];
                if (!(PTC_FINITE_F64(v) && (fabs(v) <= u_max[axis]))) {
                    outside = 1U;
                    break;
                }
            }
            if (outside == 1U) {
                for (uint32_t axis = 0U; axis < 3U; axis++) {
                    const double v = wanted[axis];
                    if (!(PTC_FINITE_F64(v) && (fabs(v) <= u_max[axis]))) {
                        if (PTC_FINITE_F64(x[axis][0])
                            && PTC_FINITE_F64(x[axis][1])
                            && PTC_FINITE_F64(x[axis][2])) {
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
                    for (uint32_t axis = 0U; axis < 3U; axis++) {
                        u[axis] = 0.0;
                    }
                }
            }
        } else {
            for (uint32_t i = 0U; i < 3U; i++) {
                u[i] = 0.0;
                axes[i] = PTC_E_INPUT;
            }
        }
    } else {
        if (u != NULL) {
            for (uint32_t i = 0U; i < 3U; i++) {
                u[i] = 0.0;
            }
        }
        if (axes != NULL) {
            for (uint32_t i = 0U; i < 3U; i++) {
                axes[i] = PTC_E_INPUT;
            }
        }
    }
    return status;
}
