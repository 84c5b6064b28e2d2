/* Prescribed-time controller ptc_power2_unbounded: see ptc_power2_unbounded.h. DO NOT EDIT. */
#include "ptc_power2_unbounded.h"

#include <math.h>
#include <stddef.h>

ptc_status ptc_power2_unbounded_init(
    ptc_power2_unbounded *self,
    const ptc_power2_unbounded_params *params)
{
    ptc_status status = PTC_E_PARAM;
    struct ptc_power2_unbounded built;

    if ((self != NULL) && (params != NULL)) {
        const double tau = params->tau;
        const double t0 = params->t0;
        const double eps = params->eps;
        if ((isfinite(tau) != 0)
            && (1e-150 <= tau)
            && (tau <= 1e150)
            && (isfinite(t0) != 0)
            && (1e-150 <= eps)
            && (eps < tau)) {
            const double hold_from = -eps;
            const double minus_tau = -tau;
            const double inv_tau = 1.0 / tau;
            if ((isfinite(hold_from) != 0)
                && (isfinite(minus_tau) != 0)
                && (isfinite(inv_tau) != 0)) {
                built.tau = tau;
                built.eps = eps;
                built.hold_from = hold_from;
                built.minus_tau = minus_tau;
                built.inv_tau = inv_tau;
                built.t0 = 0.0;
                built.deadline = 0.0;
                built.correction = 0.0;
                status = ptc_power2_unbounded_arm(&built, t0);
                if (status == PTC_OK) {
                    *self = built;
                }
            }
        }
    }
    return status;
}

ptc_status ptc_power2_unbounded_arm(ptc_power2_unbounded *self, double t0)
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

ptc_status ptc_power2_unbounded_step(
    const ptc_power2_unbounded *self,
    double t,
    const double x[2],
    double *u)
{
    ptc_status status = PTC_E_INPUT;

    if (u != NULL) {
        *u = 0.0;
    }
    if ((self != NULL) && (x != NULL) && (u != NULL)) {
        const double past = (t - self->deadline) - self->correction;
        const double late = (past < self->hold_from) ? past : self->hold_from;
        const double inv_w = self->minus_tau / late;
        const double q = inv_w * inv_w;
        const double v1 = (-4.0) * q;
        const double row1 = v1 * q;
        const double row2 = v1 + 3.0;
        const double inv_T = inv_w * self->inv_tau;
        const double v = ((row1 * x[0] * inv_T) + (row2 * x[1])) * inv_T;
        *u = v;
        if ((self->t0 <= t) && (isfinite(v) != 0) && (late < self->hold_from)) {
            status = PTC_OK;
        } else if ((isfinite(t) != 0)
            && (self->t0 <= t)
            && (isfinite(x[0]) != 0)
            && (isfinite(x[1]) != 0)) {
            if (isfinite(v) != 0) {
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

ptc_status ptc_power2_unbounded_tick(
    const ptc_power2_unbounded *self,
    double t,
    ptc_power2_unbounded_gains *gains)
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (gains != NULL)) {
        if ((isfinite(t) != 0) && (self->t0 <= t)) {
            const double past = (t - self->deadline) - self->correction;
            const double late = (past < self->hold_from) ? past : self->hold_from;
            const double inv_w = self->minus_tau / late;
            const double q = inv_w * inv_w;
            const double v1 = (-4.0) * q;
            const double row1 = v1 * q;
            const double row2 = v1 + 3.0;
            const double inv_T = inv_w * self->inv_tau;
            gains->gain[0] = row1 * inv_T * inv_T;
            gains->gain[1] = row2 * inv_T;
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

ptc_status ptc_power2_unbounded_axis(
    const ptc_power2_unbounded_gains *gains,
    const double x[2],
    double *u)
{
    ptc_status status = PTC_E_INPUT;

    if (u != NULL) {
        *u = 0.0;
    }
    if ((gains != NULL) && (x != NULL) && (u != NULL)) {
        const double v = (gains->gain[0] * x[0]) + (gains->gain[1] * x[1]);
        *u = v;
        if (isfinite(v) != 0) {
            status = gains->status;
        } else if ((isfinite(x[0]) != 0) && (isfinite(x[1]) != 0)) {
            *u = 0.0;
            status = PTC_E_RANGE;
        } else {
            *u = 0.0;
            status = PTC_E_INPUT;
        }
    }
    return status;
}
