/* Prescribed-time controller ptc_exp3_fixed: see ptc_exp3_fixed.h. DO NOT EDIT. */
#include "ptc_exp3_fixed.h"

#include <math.h>
#include <stddef.h>

ptc_status ptc_exp3_fixed_init(ptc_exp3_fixed *self, const ptc_exp3_fixed_params *params)
{
    ptc_status status = PTC_E_PARAM;

    (void)params;
    if (self != NULL) {
        {
            ptc_exp3_fixed built;

            if (1) {
                status = ptc_exp3_fixed_arm(&built, 0.0);
                if (status == PTC_OK) {
                    *self = built;
                }
            }
        }
    }
    return status;
}

ptc_status ptc_exp3_fixed_arm(ptc_exp3_fixed *self, double t0)
{
    ptc_status status = PTC_E_PARAM;

    if ((self != NULL) && isfinite(t0)) {
        const double deadline = t0 + 2.0;
        const double v1 = deadline - t0;
        const double correction = (t0 - (deadline - v1)) + (2.0 - v1);

        if (isfinite(deadline)) {
            self->t0 = t0;
            self->deadline = deadline;
            self->correction = correction;
            status = PTC_OK;
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
        const double x1 = x[0];
        const double x2 = x[1];
        const double x3 = x[2];

        if (isfinite(t)
            && (t >= self->t0)
            && isfinite(x1)
            && isfinite(x2)
            && isfinite(x3)) {
            status = PTC_OK;
            double T = (self->deadline - t) + self->correction;
            if (T <= 0.001) {
                T = 0.001;
                status = PTC_HOLD;
            }
            const double inv_T = 1.0 / T;
            const double v1 = ((((-24.0) * x1 * inv_T) + ((-18.0) * x2)) * inv_T) + ((-6.0) * x3);

            double v = v1 * inv_T;
            if (v > 50.0) {
                v = 50.0;
                status = PTC_SATURATED;
            } else if (v < -50.0) {
                v = -50.0;
                status = PTC_SATURATED;
            } else {
                /* within the bound */
            }
            if (isfinite(v)) {
                *u = v;
            } else {
                status = PTC_E_RANGE;
            }
        }
    }
    return status;
}

ptc_status ptc_exp3_fixed_tick(const ptc_exp3_fixed *self, double t, ptc_exp3_fixed_gains *gains)
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL)
        && (gains != NULL)
        && isfinite(t)
        && (t >= self->t0)) {
        status = PTC_OK;
        double T = (self->deadline - t) + self->correction;
        if (T <= 0.001) {
            T = 0.001;
            status = PTC_HOLD;
        }
        const double inv_T = 1.0 / T;
        const double v1 = inv_T * inv_T;
        gains->gain[0] = (-24.0) * (v1 * inv_T);
        gains->gain[1] = (-18.0) * v1;
        gains->gain[2] = (-6.0) * inv_T;
        gains->status = status;
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
        const double x1 = x[0];
        const double x2 = x[1];
        const double x3 = x[2];

        if (isfinite(x1)
            && isfinite(x2)
            && isfinite(x3)) {
            status = gains->status;
            const double gain1 = gains->gain[0];
            const double gain2 = gains->gain[1];
            const double gain3 = gains->gain[2];

            double v = (gain1 * x1) + (gain2 * x2) + (gain3 * x3);
            if (v > 50.0) {
                v = 50.0;
                status = PTC_SATURATED;
            } else if (v < -50.0) {
                v = -50.0;
                status = PTC_SATURATED;
            } else {
                /* within the bound */
            }
            if (isfinite(v)) {
                *u = v;
            } else {
                status = PTC_E_RANGE;
            }
        }
    }
    return status;
}
