/* Prescribed-time controller mix: see mix.h. DO NOT EDIT. */
#include "mix.h"

#include <math.h>
#include <stddef.h>
#include <stdint.h>

ptc_status mix_init(mix *self, const mix_params *params)
{
    ptc_status status = PTC_E_PARAM;
    struct mix built;

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
                status = mix_arm(&built, t0);
                if (status == PTC_OK) {
                    *self = built;
                }
            }
        }
    }
    return status;
}

ptc_status mix_arm(mix *self, double t0)
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

ptc_status mix_step(const mix *self, double t, const double x[3], double u[2], ptc_status axes[2])
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (x != NULL) && (u != NULL) && (axes != NULL)) {
        const double x1 = x[0];
        const double x2 = x[1];
        const double x3 = x[2];
        if ((isfinite(t) != 0)
            && (self->t0 <= t)
            && (isfinite(x1) != 0)
            && (isfinite(x2) != 0)
            && (isfinite(x3) != 0)) {
            const double past = (t - self->deadline) - self->correction;
            const double late = (past < self->hold_from) ? past : self->hold_from;
            const double inv_T_axis1 = (-1.0) / late;
            const double drift_axis1 = -x2;
            const double s1 = (((-20.0) * x1 * inv_T_axis1) + ((-8.0) * x2)) * inv_T_axis1;
            const double wanted_axis1 = s1 - drift_axis1;
            const double drift_axis2 = x2 * x3;
            const double wanted_axis2 = ((-3.0) * x3 * inv_T_axis1) - drift_axis2;
            const double v1 = 2.0 + sin(x1);
            const double v2 = x3 * x3;
            const double v3 = 2.0 + v2;
            const double determinant = (v1 * v3) - v2;
            const double over_determinant = 1.0 / (((determinant < 0.0) || (determinant > 0.0)) ? determinant : (double)NAN);
            const double v4 = -x3;
            const double control1 = ((v3 * wanted_axis1) + (v4 * wanted_axis2)) * over_determinant;
            const double control2 = ((v4 * wanted_axis1) + (v1 * wanted_axis2)) * over_determinant;
            if (late < self->hold_from) {
                status = PTC_OK;
            } else {
                status = PTC_HOLD;
            }
            if ((isfinite(control1) != 0) && (isfinite(control2) != 0)) {
                u[0] = control1;
                axes[0] = status;
                u[1] = control2;
                axes[1] = status;
                if (self->u_max < control1) {
                    u[0] = self->u_max;
                    axes[0] = PTC_SATURATED;
                    status = PTC_SATURATED;
                } else if (control1 < -self->u_max) {
                    u[0] = -self->u_max;
                    axes[0] = PTC_SATURATED;
                    status = PTC_SATURATED;
                } else {
                    /* neither */
                }
                if (self->u_max < control2) {
                    u[1] = self->u_max;
                    axes[1] = PTC_SATURATED;
                    status = PTC_SATURATED;
                } else if (control2 < -self->u_max) {
                    u[1] = -self->u_max;
                    axes[1] = PTC_SATURATED;
                    status = PTC_SATURATED;
                } else {
                    /* neither */
                }
            } else {
                u[0] = 0.0;
                if (isfinite(control1) != 0) {
                    axes[0] = status;
                } else {
                    axes[0] = PTC_E_RANGE;
                }
                u[1] = 0.0;
                if (isfinite(control2) != 0) {
                    axes[1] = status;
                } else {
                    axes[1] = PTC_E_RANGE;
                }
                status = PTC_E_RANGE;
            }
        } else {
            for (uint32_t i = 0U; i < 2U; i++) {
                u[i] = 0.0;
                axes[i] = PTC_E_INPUT;
            }
        }
    } else {
        if (u != NULL) {
            for (uint32_t i = 0U; i < 2U; i++) {
                u[i] = 0.0;
            }
        }
    }
    return status;
}
