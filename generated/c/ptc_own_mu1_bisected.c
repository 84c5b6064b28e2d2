/* Prescribed-time controller ptc_own_mu1_bisected: see ptc_own_mu1_bisected.h. DO NOT EDIT. */
#include "ptc_own_mu1_bisected.h"

#include <math.h>
#include <stddef.h>
#include <stdint.h>

ptc_status ptc_own_mu1_bisected_init(
    ptc_own_mu1_bisected *self,
    const ptc_own_mu1_bisected_params *params)
{
    ptc_status status = PTC_E_PARAM;
    struct ptc_own_mu1_bisected built;

    if ((self != NULL) && (params != NULL)) {
        const double tau = params->tau;
        const double t0 = params->t0;
        const double eps = params->eps;
        const double u_max = params->u_max;
        const double k1 = params->k[0];
        if ((isfinite(tau) != 0)
            && (1e-150 <= tau)
            && (tau <= 1e150)
            && (isfinite(t0) != 0)
            && (1e-150 <= eps)
            && (0.0 < u_max)
            && (isfinite(k1) != 0)
            && (eps < tau)) {
            const double hold_from = -eps;
            const double w1 = -k1;
            const double size_w1 = (fabs(k1) <= 0.0) ? 1e-200 : fabs(w1);
            if ((1e-200 <= size_w1) && (isfinite(hold_from) != 0) && (isfinite(w1) != 0)) {
                built.tau = tau;
                built.eps = eps;
                built.hold_from = hold_from;
                built.w1 = w1;
                built.u_max = u_max;
                built.t0 = 0.0;
                built.deadline = 0.0;
                built.correction = 0.0;
                status = ptc_own_mu1_bisected_arm(&built, t0);
                if (status == PTC_OK) {
                    *self = built;
                }
            }
        }
    }
    return status;
}

ptc_status ptc_own_mu1_bisected_arm(ptc_own_mu1_bisected *self, double t0)
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

ptc_status ptc_own_mu1_bisected_step(
    const ptc_own_mu1_bisected *self,
    double t,
    const double x[1],
    double *u)
{
    ptc_status status = PTC_E_INPUT;

    if (u != NULL) {
        *u = 0.0;
    }
    if ((self != NULL) && (x != NULL) && (u != NULL)) {
        if (self->t0 <= t) {
            const double past = (t - self->deadline) - self->correction;
            const double late = (past < self->hold_from) ? past : self->hold_from;
            const double T = -late;
            double y = 0.0;
            double y_low = 0.0;
            double y_high = 1e300;
            for (uint32_t attempt = 0U; attempt < 100U; attempt++) {
                const double v1 = 1.0 + (y * y);
                const double v2 = sqrt(v1);
                const double v3 = 1.0 / (y + 1.0 + v2);
                const double v4 = pow(v3 * 2.0, 0.1) * self->tau;
                const double v5 = log(v4 / T);
                const double s1 = (-((1.0 + (v2 * (0.5 * ((y + y) * (1.0 / v1))))) * v3)) * 2.0 * 0.5;
                const double y_next = y - (v5 * (v4 / (v4 * (0.1 * s1))));
                const double y_size = fabs(v5);
                if (0.0 < v5) {
                    y_low = y;
                } else {
                    y_high = y;
                }
                if ((y_low <= y_next) && (y_next <= y_high)) {
                    y = y_next;
                } else {
                    y = 0.5 * (y_low + y_high);
                }
                if (y_size <= 1e-9) {
                    break;
                }
                if (39U < attempt) {
                    y = sqrt(y_low + 1e-300) * sqrt(y_high);
                }
            }
            const double v6 = 1.0 + (y * y);
            const double v7 = sqrt(v6);
            const double s2 = -((1.0 + (v7 * (0.5 * ((y + y) * (1.0 / v6))))) * (1.0 / (y + 1.0 + v7)));
            const double inv_r1 = 1.0 / (T * (-(0.1 * (s2 * 2.0 * 0.5))));
            const double v = self->w1 * x[0] * inv_r1;
            *u = v;
            if ((isfinite(v) != 0) && (fabs(v) <= self->u_max) && (late < self->hold_from)) {
                status = PTC_OK;
            } else if ((isfinite(t) != 0) && (isfinite(x[0]) != 0)) {
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

ptc_status ptc_own_mu1_bisected_tick(
    const ptc_own_mu1_bisected *self,
    double t,
    ptc_own_mu1_bisected_gains *gains)
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (gains != NULL)) {
        if ((isfinite(t) != 0) && (self->t0 <= t)) {
            const double past = (t - self->deadline) - self->correction;
            const double late = (past < self->hold_from) ? past : self->hold_from;
            const double T = -late;
            double y = 0.0;
            double y_low = 0.0;
            double y_high = 1e300;
            for (uint32_t attempt = 0U; attempt < 100U; attempt++) {
                const double v1 = 1.0 + (y * y);
                const double v2 = sqrt(v1);
                const double v3 = 1.0 / (y + 1.0 + v2);
                const double v4 = pow(v3 * 2.0, 0.1) * self->tau;
                const double v5 = log(v4 / T);
                const double s1 = (-((1.0 + (v2 * (0.5 * ((y + y) * (1.0 / v1))))) * v3)) * 2.0 * 0.5;
                const double y_next = y - (v5 * (v4 / (v4 * (0.1 * s1))));
                const double y_size = fabs(v5);
                if (0.0 < v5) {
                    y_low = y;
                } else {
                    y_high = y;
                }
                if ((y_low <= y_next) && (y_next <= y_high)) {
                    y = y_next;
                } else {
                    y = 0.5 * (y_low + y_high);
                }
                if (y_size <= 1e-9) {
                    break;
                }
                if (39U < attempt) {
                    y = sqrt(y_low + 1e-300) * sqrt(y_high);
                }
            }
            const double v6 = 1.0 + (y * y);
            const double v7 = sqrt(v6);
            const double s2 = -((1.0 + (v7 * (0.5 * ((y + y) * (1.0 / v6))))) * (1.0 / (y + 1.0 + v7)));
            const double inv_r1 = 1.0 / (T * (-(0.1 * (s2 * 2.0 * 0.5))));
            gains->gain[0] = self->w1 * inv_r1;
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

ptc_status ptc_own_mu1_bisected_axis(
    const ptc_own_mu1_bisected_gains *gains,
    const double x[1],
    double *u)
{
    ptc_status status = PTC_E_INPUT;

    if (u != NULL) {
        *u = 0.0;
    }
    if ((gains != NULL) && (x != NULL) && (u != NULL)) {
        const double v = gains->gain[0] * x[0];
        *u = v;
        if ((isfinite(v) != 0) && (fabs(v) <= gains->u_max)) {
            status = gains->status;
        } else if (isfinite(x[0]) != 0) {
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
