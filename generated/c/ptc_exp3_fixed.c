/* Prescribed-time controller ptc_exp3_fixed: see ptc_exp3_fixed.h. DO NOT EDIT. */
#include "ptc_exp3_fixed.h"

#include <math.h>
#include <stddef.h>

ptc_status ptc_exp3_fixed_init(ptc_exp3_fixed *self, const ptc_exp3_fixed_params *params)
{
    ptc_status status = PTC_E_PARAM;
    struct ptc_exp3_fixed built;

    (void)params;
    if (self != NULL) {
        built.t0 = 0.0;
        built.deadline = 0.0;
        built.correction = 0.0;
        status = ptc_exp3_fixed_arm(&built, 0.0);
        if (status == PTC_OK) {
            *self = built;
        }
    }
    return status;
}

ptc_status ptc_exp3_fixed_arm(ptc_exp3_fixed *self, double t0)
{
    ptc_status status = PTC_E_PARAM;

    if (self != NULL) {
        if (isfinite(t0) != 0) {
            const double deadline = t0 + 2.0;
            const double v1 = deadline - t0;
            const double correction = (t0 - (deadline - v1)) + (2.0 - v1);
            if (isfinite(deadline) != 0) {
                self->t0 = t0;
                self->deadline = deadline;
                self->correction = correction;
                status = PTC_OK;
            }
        }
    }
    return status;
}

ptc_status ptc_exp3_fixed_step(const ptc_exp3_fixed *self, double t, const double x[3], double *u)
{
    ptc_status status = PTC_E_INPUT;

    if (u != NULL) {
        *u = 0.0;
    }
    if ((self != NULL) && (x != NULL) && (u != NULL)) {
        const double past = (t - self->deadline) - self->correction;
        const double late = (past < -0.001) ? past : -0.001;
        const double inv_T = (-1.0) / late;
        const double s1 = (((-120.0) * x[0] * inv_T) + ((-60.0) * x[1])) * inv_T;
        const double v = (s1 + ((-12.0) * x[2])) * inv_T;
        *u = v;
        if ((self->t0 <= t) && (isfinite(v) != 0) && (fabs(v) <= 50.0) && (late < -0.001)) {
            status = PTC_OK;
        } else if ((isfinite(t) != 0)
            && (self->t0 <= t)
            && (isfinite(x[0]) != 0)
            && (isfinite(x[1]) != 0)
            && (isfinite(x[2]) != 0)) {
            if (50.0 < v) {
                *u = 50.0;
                status = PTC_SATURATED;
            } else if (v < -50.0) {
                *u = -50.0;
                status = PTC_SATURATED;
            } else if (isfinite(v) != 0) {
                status = PTC_HOLD;
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

ptc_status ptc_exp3_fixed_tick(const ptc_exp3_fixed *self, double t, ptc_exp3_fixed_gains *gains)
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (gains != NULL)) {
        if ((isfinite(t) != 0) && (self->t0 <= t)) {
            const double past = (t - self->deadline) - self->correction;
            const double late = (past < -0.001) ? past : -0.001;
            const double inv_T = (-1.0) / late;
            gains->gain[0] = (-120.0) * (inv_T * inv_T) * inv_T;
            gains->gain[1] = (-60.0) * inv_T * inv_T;
            gains->gain[2] = (-12.0) * inv_T;
            if (late < -0.001) {
                status = PTC_OK;
            } else {
                status = PTC_HOLD;
            }
            gains->status = status;
        }
    }
    return status;
}

ptc_status ptc_exp3_fixed_axis(const ptc_exp3_fixed_gains *gains, const double x[3], double *u)
{
    ptc_status status = PTC_E_INPUT;

    if (u != NULL) {
        *u = 0.0;
    }
    if ((gains != NULL) && (x != NULL) && (u != NULL)) {
        const double s1 = (gains->gain[0] * x[0]) + (gains->gain[1] * x[1]);
        const double v = s1 + (gains->gain[2] * x[2]);
        *u = v;
        if ((isfinite(v) != 0) && (fabs(v) <= 50.0)) {
            status = gains->status;
        } else if ((isfinite(x[0]) != 0) && (isfinite(x[1]) != 0) && (isfinite(x[2]) != 0)) {
            if (50.0 < v) {
                *u = 50.0;
                status = PTC_SATURATED;
            } else if (v < -50.0) {
                *u = -50.0;
                status = PTC_SATURATED;
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
