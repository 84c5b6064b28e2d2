/* Prescribed-time controller table: see table.h. DO NOT EDIT. */
#include "table.h"

#include <math.h>
#include <stddef.h>

ptc_status table_init(table *self, const table_params *params)
{
    ptc_status status = PTC_E_PARAM;
    struct table built;

    if ((self != NULL) && (params != NULL)) {
        const double t0 = params->t0;
        /*@ slevel merge; */
        if (isfinite(t0) != 0) {
            built.t0 = 0.0;
            built.deadline = 0.0;
            built.correction = 0.0;
            status = table_arm(&built, t0);
            if (status == PTC_OK) {
                *self = built;
            }
        }
    }
    return status;
}

ptc_status table_arm(table *self, double t0)
{
    ptc_status status = PTC_E_PARAM;

    if (self != NULL) {
        if (isfinite(t0) != 0) {
            const double deadline = t0 + 1.0;
            const double v1 = deadline - t0;
            const double correction = (t0 - (deadline - v1)) + (1.0 - v1);
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

ptc_status table_step(const table *self, double t, const double x[2], double *u)
{
    ptc_status status = PTC_E_INPUT;

    if (u != NULL) {
        *u = 0.0;
    }
    if ((self != NULL) && (x != NULL) && (u != NULL)) {
        if (self->t0 <= t) {
            const double past = (t - self->deadline) - self->correction;
            const double late = (past < -0.0361) ? past : -0.0361;
            const double inv_T = (-1.0) / late;
            const double v = (((-20.0) * x[0] * inv_T) + ((-8.0) * x[1])) * inv_T * 0.02;
            *u = v;
            if ((isfinite(v) != 0) && (fabs(v) <= 0.5) && (late < -0.0361)) {
                status = PTC_OK;
            } else if ((isfinite(t) != 0) && (isfinite(x[0]) != 0) && (isfinite(x[1]) != 0)) {
                if (0.5 < v) {
                    *u = 0.5;
                    status = PTC_SATURATED;
                } else if (v < -0.5) {
                    *u = -0.5;
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

ptc_status table_tick(const table *self, double t, table_gains *gains)
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (gains != NULL)) {
        if ((isfinite(t) != 0) && (self->t0 <= t)) {
            const double past = (t - self->deadline) - self->correction;
            const double late = (past < -0.0361) ? past : -0.0361;
            const double inv_T = (-1.0) / late;
            gains->gain[0] = (-20.0) * inv_T * inv_T;
            gains->gain[1] = (-8.0) * inv_T;
            if (late < -0.0361) {
                status = PTC_OK;
            } else {
                status = PTC_HOLD;
            }
            gains->status = status;
        }
    }
    return status;
}

ptc_status table_axis(const table_gains *gains, const double x[2], double *u)
{
    ptc_status status = PTC_E_INPUT;

    if (u != NULL) {
        *u = 0.0;
    }
    if ((gains != NULL) && (x != NULL) && (u != NULL)) {
        const double v = ((gains->gain[0] * x[0]) + (gains->gain[1] * x[1])) * 0.02;
        *u = v;
        if ((isfinite(v) != 0) && (fabs(v) <= 0.5)) {
            status = gains->status;
        } else if ((isfinite(x[0]) != 0) && (isfinite(x[1]) != 0)) {
            if (0.5 < v) {
                *u = 0.5;
                status = PTC_SATURATED;
            } else if (v < -0.5) {
                *u = -0.5;
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
