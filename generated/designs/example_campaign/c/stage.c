/* Prescribed-time controller stage: see stage.h. DO NOT EDIT. */
#include "stage.h"

#include <math.h>
#include <stddef.h>

ptc_status stage_init(stage *self, const stage_params *params)
{
    ptc_status status = PTC_E_PARAM;
    struct stage built;

    if ((self != NULL) && (params != NULL)) {
        const double tau = params->tau;
        const double t0 = params->t0;
        const double eps = params->eps;
        const double u_max = params->u_max;
        if ((isfinite(tau) != 0)
            && (1e-150 <= tau)
            && (tau <= 1e150)
            && (isfinite(t0) != 0)
            && (1e-150 <= eps)
            && (0.0 < u_max)
            && (eps < tau)) {
            const double hold_from = -eps;
            if (isfinite(hold_from) != 0) {
                built.tau = tau;
                built.eps = eps;
                built.hold_from = hold_from;
                built.u_max = u_max;
                built.t0 = 0.0;
                built.deadline = 0.0;
                built.correction = 0.0;
                status = stage_arm(&built, t0);
                if (status == PTC_OK) {
                    *self = built;
                }
            }
        }
    }
    return status;
}

ptc_status stage_arm(stage *self, double t0)
{
    ptc_status status = PTC_E_PARAM;

    if (self != NULL) {
        if (isfinite(t0) != 0) {
            const double deadline = t0 + self->tau;
            const double v1 = deadline - t0;
            const double correction = (t0 - (deadline - v1)) + (self->tau - v1);
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

ptc_status stage_step(const stage *self, double t, const double x[3], double *u)
{
    ptc_status status = PTC_E_INPUT;

    if (u != NULL) {
        *u = 0.0;
    }
    if ((self != NULL) && (x != NULL) && (u != NULL)) {
        if (self->t0 <= t) {
            const double past = (t - self->deadline) - self->correction;
            const double late = (past < self->hold_from) ? past : self->hold_from;
            const double inv_T = (-1.0) / late;
            const double s1 = (((-120.0) * x[0] * inv_T) + ((-60.0) * x[1])) * inv_T;
            const double v = (s1 + ((-12.0) * x[2])) * inv_T;
            *u = v;
            if ((isfinite(v) != 0) && (fabs(v) <= self->u_max) && (late < self->hold_from)) {
                status = PTC_OK;
            } else if ((isfinite(t) != 0)
                && (isfinite(x[0]) != 0)
                && (isfinite(x[1]) != 0)
                && (isfinite(x[2]) != 0)) {
                if (self->u_max < v) {
                    *u = self->u_max;
                    status = PTC_SATURATED;
                } else if (v < -self->u_max) {
                    *u = -self->u_max;
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
    }
    return status;
}

ptc_status stage_tick(const stage *self, double t, stage_gains *gains)
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (gains != NULL)) {
        if ((isfinite(t) != 0) && (self->t0 <= t)) {
            const double past = (t - self->deadline) - self->correction;
            const double late = (past < self->hold_from) ? past : self->hold_from;
            const double inv_T = (-1.0) / late;
            gains->gain[0] = (-120.0) * (inv_T * inv_T) * inv_T;
            gains->gain[1] = (-60.0) * inv_T * inv_T;
            gains->gain[2] = (-12.0) * inv_T;
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

ptc_status stage_axis(const stage_gains *gains, const double x[3], double *u)
{
    ptc_status status = PTC_E_INPUT;

    if (u != NULL) {
        *u = 0.0;
    }
    if ((gains != NULL) && (x != NULL) && (u != NULL)) {
        const double s1 = (gains->gain[0] * x[0]) + (gains->gain[1] * x[1]);
        const double v = s1 + (gains->gain[2] * x[2]);
        *u = v;
        if ((isfinite(v) != 0) && (fabs(v) <= gains->u_max)) {
            status = gains->status;
        } else if ((isfinite(x[0]) != 0) && (isfinite(x[1]) != 0) && (isfinite(x[2]) != 0)) {
            if (gains->u_max < v) {
                *u = gains->u_max;
                status = PTC_SATURATED;
            } else if (v < -gains->u_max) {
                *u = -gains->u_max;
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
