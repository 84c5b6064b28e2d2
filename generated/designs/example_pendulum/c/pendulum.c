/* Prescribed-time controller pendulum: see pendulum.h. DO NOT EDIT. */
#include "pendulum.h"

#include <math.h>
#include <stddef.h>

ptc_status pendulum_init(pendulum *self, const pendulum_params *params)
{
    ptc_status status = PTC_E_PARAM;
    struct pendulum built;

    if ((self != NULL) && (params != NULL)) {
        const double t0 = params->t0;
        if (isfinite(t0) != 0) {
            built.t0 = 0.0;
            built.deadline = 0.0;
            built.correction = 0.0;
            status = pendulum_arm(&built, t0);
            if (status == PTC_OK) {
                *self = built;
            }
        }
    }
    return status;
}

ptc_status pendulum_arm(pendulum *self, double t0)
{
    ptc_status status = PTC_E_PARAM;

    if (self != NULL) {
        if (isfinite(t0) != 0) {
            const double deadline = t0 + 0.8;
            const double v1 = deadline - t0;
            const double correction = (t0 - (deadline - v1)) + (0.8 - v1);
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

ptc_status pendulum_step(const pendulum *self, double t, const double x[2], double *u)
{
    ptc_status status = PTC_E_INPUT;

    if (u != NULL) {
        *u = 0.0;
    }
    if ((self != NULL) && (x != NULL) && (u != NULL)) {
        const double x1 = x[0];
        if ((self->t0 <= t) && (isfinite(x1) != 0)) {
            const double past = (t - self->deadline) - self->correction;
            const double late = (past < -0.006) ? past : -0.006;
            const double inv_T = (-1.0) / late;
            const double drift = ((-4.905) * sin(x1)) - (0.02 * x[1]);
            const double v = ((((-3.0) * x1 * inv_T) + ((-1.5) * x[1])) * inv_T) - drift;
            *u = v;
            if ((isfinite(v) != 0) && (fabs(v) <= 25.0) && (late < -0.006)) {
                status = PTC_OK;
            } else if ((isfinite(t) != 0) && (isfinite(x[1]) != 0)) {
                if (25.0 < v) {
                    *u = 25.0;
                    status = PTC_SATURATED;
                } else if (v < -25.0) {
                    *u = -25.0;
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
