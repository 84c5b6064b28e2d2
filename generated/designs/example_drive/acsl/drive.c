/* Prescribed-time controller drive: see drive.h. DO NOT EDIT. */
#include "drive.h"

#include <math.h>
#include <stddef.h>

ptc_status drive_init(drive *self, const drive_params *params)
{
    ptc_status status = PTC_E_PARAM;
    struct drive built;

    if ((self != NULL) && (params != NULL)) {
        const double t0 = params->t0;
        const double eps = params->eps;
        /*@ slevel merge; */
        if ((isfinite(t0) != 0) && (1e-150 <= eps) && (eps < 0.4)) {
            const double hold_from = -eps;
            /*@ slevel merge; */
            if (isfinite(hold_from) != 0) {
                built.eps = eps;
                built.hold_from = hold_from;
                built.t0 = 0.0;
                built.deadline = 0.0;
                built.correction = 0.0;
                status = drive_arm(&built, t0);
                if (status == PTC_OK) {
                    *self = built;
                }
            }
        }
    }
    return status;
}

ptc_status drive_arm(drive *self, double t0)
{
    ptc_status status = PTC_E_PARAM;

    if (self != NULL) {
        if (isfinite(t0) != 0) {
            const double deadline = t0 + 0.4;
            const double v1 = deadline - t0;
            const double correction = (t0 - (deadline - v1)) + (0.4 - v1);
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

ptc_status drive_step(const drive *self, double t, const double x[3], double *u)
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
            const double drift = ((-0.029999666666666668) * x[1]) - (1.201 * x[2]);
            const double s1 = (((-0.00016) * x[0] * inv_T) + ((-8e-5) * x[1])) * inv_T;
            const double v = ((s1 + (((-0.024) * x[2]) - ((-8e-6) * x[1]))) * inv_T) - drift;
            *u = v;
            if ((isfinite(v) != 0) && (fabs(v) <= 24.0) && (late < self->hold_from)) {
                status = PTC_OK;
            } else if ((isfinite(t) != 0)
                && (isfinite(x[0]) != 0)
                && (isfinite(x[1]) != 0)
                && (isfinite(x[2]) != 0)) {
                if (24.0 < v) {
                    *u = 24.0;
                    status = PTC_SATURATED;
                } else if (v < -24.0) {
                    *u = -24.0;
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
