/* Prescribed-time controller ptc_exp3: see ptc_exp3.h. DO NOT EDIT. */
#include "ptc_exp3.h"

#include <math.h>
#include <stddef.h>

ptc_status ptc_exp3_init(ptc_exp3 *self, const ptc_exp3_params *params)
{
    ptc_status status = PTC_E_PARAM;
    struct ptc_exp3 built;

    if ((self != NULL) && (params != NULL)) {
        const double tau = params->tau;
        const double t0 = params->t0;
        const double eps = params->eps;
        const double u_max = params->u_max;
        const double k1 = params->k[0];
        const double k2 = params->k[1];
        const double k3 = params->k[2];
        if ((isfinite(tau) != 0)
            && (1e-150 <= tau)
            && (tau <= 1e150)
            && (isfinite(t0) != 0)
            && (1e-150 <= eps)
            && (0.0 < u_max)
            && (isfinite(k1) != 0)
            && (isfinite(k2) != 0)
            && (isfinite(k3) != 0)
            && (eps < tau)) {
            const double c1 = -k1;
            const double c2 = ((-k2) + k3) - 1.0;
            const double c3 = (-k3) + 3.0;
            const double hold_from = -eps;
            const double size_c1 = (fabs(k1) <= 0.0) ? 1e-200 : fabs(c1);
            if ((1e-200 <= size_c1)
                && (isfinite(c1) != 0)
                && (isfinite(c2) != 0)
                && (isfinite(c3) != 0)
                && (isfinite(hold_from) != 0)) {
                built.c1 = c1;
                built.c2 = c2;
                built.c3 = c3;
                built.tau = tau;
                built.eps = eps;
                built.hold_from = hold_from;
                built.u_max = u_max;
                built.t0 = 0.0;
                built.deadline = 0.0;
                built.correction = 0.0;
                status = ptc_exp3_arm(&built, t0);
                if (status == PTC_OK) {
                    *self = built;
                }
            }
        }
    }
    return status;
}

ptc_status ptc_exp3_arm(ptc_exp3 *self, double t0)
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

ptc_status ptc_exp3_step(const ptc_exp3 *self, double t, const double x[3], double *u)
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
            const double s1 = ((self->c1 * x[0] * inv_T) + (self->c2 * x[1])) * inv_T;
            const double v = (s1 + (self->c3 * x[2])) * inv_T;
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

ptc_status ptc_exp3_tick(const ptc_exp3 *self, double t, ptc_exp3_gains *gains)
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (gains != NULL)) {
        if ((isfinite(t) != 0) && (self->t0 <= t)) {
            const double past = (t - self->deadline) - self->correction;
            const double late = (past < self->hold_from) ? past : self->hold_from;
            const double inv_T = (-1.0) / late;
            gains->gain[0] = self->c1 * (inv_T * inv_T) * inv_T;
            gains->gain[1] = self->c2 * inv_T * inv_T;
            gains->gain[2] = self->c3 * inv_T;
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

ptc_status ptc_exp3_axis(const ptc_exp3_gains *gains, const double x[3], double *u)
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
