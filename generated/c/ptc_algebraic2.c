/* Prescribed-time controller ptc_algebraic2: see ptc_algebraic2.h. DO NOT EDIT. */
#include "ptc_algebraic2.h"

#include <math.h>
#include <stddef.h>

ptc_status ptc_algebraic2_init(ptc_algebraic2 *self, const ptc_algebraic2_params *params)
{
    ptc_status status = PTC_E_PARAM;
    struct ptc_algebraic2 built;

    if ((self != NULL) && (params != NULL)) {
        const double tau = params->tau;
        const double t0 = params->t0;
        const double eps = params->eps;
        const double u_max = params->u_max;
        const double a = params->a;
        const double k1 = params->k[0];
        const double k2 = params->k[1];
        if ((isfinite(tau) != 0)
            && (1e-150 <= tau)
            && (tau <= 1e150)
            && (isfinite(t0) != 0)
            && (1e-150 <= eps)
            && (0.0 < u_max)
            && (isfinite(a) != 0)
            && (1e-150 <= a)
            && (a <= 1e150)
            && (isfinite(k1) != 0)
            && (isfinite(k2) != 0)
            && (eps < tau)) {
            const double K1 = k1 / (a * a);
            const double K2 = k2 / a;
            const double c1_2 = (-K1) / (tau * tau);
            const double hold_from = -eps;
            const double two_tau = 2.0 * tau;
            const double half_tau = 0.5 * tau;
            const double c2_2 = (-K2) / tau;
            const double c2_1 = 3.0 / tau;
            const double inv_tau = 1.0 / tau;
            const double size_K1 = (fabs(k1) <= 0.0) ? 1e-200 : fabs(K1);
            const double size_K2 = (fabs(k2) <= 0.0) ? 1e-200 : fabs(K2);
            const double size_c1_2 = (fabs(k1) <= 0.0) ? 1e-200 : fabs(c1_2);
            const double size_c2_2 = (fabs(k2) <= 0.0) ? 1e-200 : fabs(c2_2);
            if ((1e-200 <= size_K1)
                && (1e-200 <= size_K2)
                && (1e-200 <= size_c1_2)
                && (1e-200 <= size_c2_2)
                && (isfinite(c1_2) != 0)
                && (isfinite(hold_from) != 0)
                && (isfinite(two_tau) != 0)
                && (isfinite(half_tau) != 0)
                && (isfinite(c2_2) != 0)
                && (isfinite(c2_1) != 0)
                && (isfinite(inv_tau) != 0)) {
                built.tau = tau;
                built.c1_2 = c1_2;
                built.eps = eps;
                built.hold_from = hold_from;
                built.two_tau = two_tau;
                built.half_tau = half_tau;
                built.c2_2 = c2_2;
                built.c2_1 = c2_1;
                built.inv_tau = inv_tau;
                built.u_max = u_max;
                built.t0 = 0.0;
                built.deadline = 0.0;
                built.correction = 0.0;
                status = ptc_algebraic2_arm(&built, t0);
                if (status == PTC_OK) {
                    *self = built;
                }
            }
        }
    }
    return status;
}

ptc_status ptc_algebraic2_arm(ptc_algebraic2 *self, double t0)
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

ptc_status ptc_algebraic2_step(const ptc_algebraic2 *self, double t, const double x[2], double *u)
{
    ptc_status status = PTC_E_INPUT;

    if (u != NULL) {
        *u = 0.0;
    }
    if ((self != NULL) && (x != NULL) && (u != NULL)) {
        if (self->t0 <= t) {
            const double past = (t - self->deadline) - self->correction;
            const double late = (past < self->hold_from) ? past : self->hold_from;
            const double s1 = self->half_tau / (self->two_tau + late);
            const double one_plus_y2 = s1 - (self->half_tau / late);
            const double row1 = self->c1_2 * one_plus_y2 * one_plus_y2;
            const double sec = sqrt(one_plus_y2);
            const double y = ((late * self->inv_tau) + 1.0) * sec;
            const double y_squared = one_plus_y2 - 1.0;
            const double row2 = (self->c2_2 * y_squared) + self->c2_2 + (self->c2_1 * y);
            const double v = ((row1 * x[0] * sec) + (row2 * x[1])) * sec;
            *u = v;
            if ((isfinite(v) != 0) && (fabs(v) <= self->u_max) && (late < self->hold_from)) {
                status = PTC_OK;
            } else if ((isfinite(t) != 0) && (isfinite(x[0]) != 0) && (isfinite(x[1]) != 0)) {
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

ptc_status ptc_algebraic2_tick(const ptc_algebraic2 *self, double t, ptc_algebraic2_gains *gains)
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (gains != NULL)) {
        if ((isfinite(t) != 0) && (self->t0 <= t)) {
            const double past = (t - self->deadline) - self->correction;
            const double late = (past < self->hold_from) ? past : self->hold_from;
            const double s1 = self->half_tau / (self->two_tau + late);
            const double one_plus_y2 = s1 - (self->half_tau / late);
            const double row1 = self->c1_2 * one_plus_y2 * one_plus_y2;
            const double sec = sqrt(one_plus_y2);
            const double y = ((late * self->inv_tau) + 1.0) * sec;
            const double y_squared = one_plus_y2 - 1.0;
            const double row2 = (self->c2_2 * y_squared) + self->c2_2 + (self->c2_1 * y);
            gains->gain[0] = row1 * sec * sec;
            gains->gain[1] = row2 * sec;
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

ptc_status ptc_algebraic2_axis(const ptc_algebraic2_gains *gains, const double x[2], double *u)
{
    ptc_status status = PTC_E_INPUT;

    if (u != NULL) {
        *u = 0.0;
    }
    if ((gains != NULL) && (x != NULL) && (u != NULL)) {
        const double v = (gains->gain[0] * x[0]) + (gains->gain[1] * x[1]);
        *u = v;
        if ((isfinite(v) != 0) && (fabs(v) <= gains->u_max)) {
            status = gains->status;
        } else if ((isfinite(x[0]) != 0) && (isfinite(x[1]) != 0)) {
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
