/* Prescribed-time controller ptc_algebraic4: see ptc_algebraic4.h. DO NOT EDIT. */
#include "ptc_algebraic4.h"

#include <math.h>
#include <stddef.h>

/* Whether a product keeps its digits: it is well above the least normal number, or 0 with a factor. */
static int ptc_algebraic4_kept(double product, double factor)
{
    return ((fabs(product) >= 1e-200) || (fabs(factor) <= 0.0)) ? 1 : 0;
}

ptc_status ptc_algebraic4_init(ptc_algebraic4 *self, const ptc_algebraic4_params *params)
{
    ptc_status status = PTC_E_PARAM;

    if ((self != NULL) && (params != NULL)) {
        const double tau = params->tau;
        const double t0 = params->t0;
        const double eps = params->eps;
        const double u_max = params->u_max;
        const double a = params->a;
        const double k1 = params->k[0];
        const double k2 = params->k[1];
        const double k3 = params->k[2];
        const double k4 = params->k[3];

        if (isfinite(tau)
            && (tau >= 1e-150)
            && (tau <= 1e150)
            && isfinite(t0)
            && (eps >= 1e-150)
            && (u_max > 0.0)
            && isfinite(a)
            && (a >= 1e-150)
            && (a <= 1e150)
            && isfinite(k1)
            && isfinite(k2)
            && isfinite(k3)
            && isfinite(k4)
            && (eps < tau)) {
            struct ptc_algebraic4 built;

            const double v1 = a * a;
            const double v2 = v1 * v1;
            const double K1 = k1 / v2;
            const double v3 = a * v1;
            const double K2 = k2 / v3;
            const double K3 = k3 / v1;
            const double K4 = k4 / a;
            const double v4 = tau * tau;
            const double v5 = v4 * v4;
            const double c1_4 = (-K1) / v5;
            const double hold_from = -eps;
            const double two_tau = 2.0 * tau;
            const double half_tau = 0.5 * tau;
            const double v6 = -K2;
            const double v7 = v6 + (3.0 * K4);
            const double v8 = tau * v4;
            const double c2_0 = v7 / v8;
            const double v9 = 3.0 * K3;
            const double v10 = v9 - 45.0;
            const double c2_1 = v10 / v8;
            const double v11 = -(3.0 * K2);
            const double v12 = 9.0 * K4;
            const double v13 = v11 - v12;
            const double c2_2 = v13 / v8;
            const double v14 = (6.0 * K3) + 60.0;
            const double c2_3 = v14 / v8;
            const double v15 = v11 - (12.0 * K4);
            const double c2_4 = v15 / v8;
            const double c2_5 = v9 / v8;
            const double c2_6 = v6 / v8;
            const double inv_tau = 1.0 / tau;
            const double v16 = -K3;
            const double c3_0 = (v16 + 12.0) / v4;
            const double c3_3 = v12 / v4;
            const double c3_2 = ((-(2.0 * K3)) - 75.0) / v4;
            const double c3_4 = v16 / v4;
            const double c4_2 = (-K4) / tau;
            const double c4_1 = 18.0 / tau;
            built.tau = tau;
            built.c1_4 = c1_4;
            built.eps = eps;
            built.hold_from = hold_from;
            built.two_tau = two_tau;
            built.half_tau = half_tau;
            built.c2_0 = c2_0;
            built.c2_1 = c2_1;
            built.c2_2 = c2_2;
            built.c2_3 = c2_3;
            built.c2_4 = c2_4;
            built.c2_5 = c2_5;
            built.c2_6 = c2_6;
            built.inv_tau = inv_tau;
            built.c3_0 = c3_0;
            built.c3_3 = c3_3;
            built.c3_2 = c3_2;
            built.c3_4 = c3_4;
            built.c4_2 = c4_2;
            built.c4_1 = c4_1;
            built.u_max = u_max;
            built.t0 = 0.0;
            built.deadline = 0.0;
            built.correction = 0.0;

            if ((v2 >= 1e-200)
                && (ptc_algebraic4_kept(K1, k1) != 0)
                && (v3 >= 1e-200)
                && (ptc_algebraic4_kept(K2, k2) != 0)
                && (ptc_algebraic4_kept(K3, k3) != 0)
                && (ptc_algebraic4_kept(K4, k4) != 0)
                && (v5 >= 1e-200)
                && (ptc_algebraic4_kept(c1_4, k1) != 0)
                && (v8 >= 1e-200)
                && (ptc_algebraic4_kept(c2_0, v7) != 0)
                && (ptc_algebraic4_kept(c2_1, v10) != 0)
                && (ptc_algebraic4_kept(c2_2, v13) != 0)
                && (ptc_algebraic4_kept(c2_3, v14) != 0)
                && (ptc_algebraic4_kept(c2_4, v15) != 0)
                && (ptc_algebraic4_kept(c2_5, k3) != 0)
                && (ptc_algebraic4_kept(c2_6, k2) != 0)
                && (ptc_algebraic4_kept(c3_3, k4) != 0)
                && (ptc_algebraic4_kept(c3_4, k3) != 0)
                && (ptc_algebraic4_kept(c4_2, k4) != 0)
                && isfinite(built.c1_4)
                && isfinite(built.hold_from)
                && isfinite(built.two_tau)
                && isfinite(built.half_tau)
                && isfinite(built.c2_0)
                && isfinite(built.c2_1)
                && isfinite(built.c2_2)
                && isfinite(built.c2_3)
                && isfinite(built.c2_4)
                && isfinite(built.c2_5)
                && isfinite(built.c2_6)
                && isfinite(built.inv_tau)
                && isfinite(built.c3_0)
                && isfinite(built.c3_3)
                && isfinite(built.c3_2)
                && isfinite(built.c3_4)
                && isfinite(built.c4_2)
                && isfinite(built.c4_1)) {
                status = ptc_algebraic4_arm(&built, t0);
            }
            if (status == PTC_OK) {
                *self = built;
            }
        }
    }
    return status;
}

ptc_status ptc_algebraic4_arm(ptc_algebraic4 *self, double t0)
{
    ptc_status status = PTC_E_PARAM;

    if ((self != NULL) && isfinite(t0)) {
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
    return status;
}

ptc_status ptc_algebraic4_step(const ptc_algebraic4 *self, double t, const double x[4], double *u)
{
    ptc_status status = PTC_E_INPUT;

    if (u != NULL) {
        *u = 0.0;
    }
    if ((self != NULL) && (x != NULL) && (u != NULL)) {
        const double x1 = x[0];
        const double x2 = x[1];
        const double x3 = x[2];
        const double x4 = x[3];

        if (isfinite(t)
            && (t >= self->t0)
            && isfinite(x1)
            && isfinite(x2)
            && isfinite(x3)
            && isfinite(x4)) {
            const double past = (t - self->deadline) - self->correction;
            const double late = (past < self->hold_from) ? past : self->hold_from;
            const double T = -late;
            const double one_plus_y2 = (self->half_tau / T) + (self->half_tau / (self->two_tau + late));
            const double v1 = one_plus_y2 * one_plus_y2;
            const double row1 = self->c1_4 * v1 * v1;
            const double sec = sqrt(one_plus_y2);
            const double y = ((late * self->inv_tau) + 1.0) * sec;
            const double y_squared = one_plus_y2 - 1.0;
            const double v2 = (((self->c2_5 * y_squared) + self->c2_3) * y_squared) + self->c2_1;
            const double v3 = (((self->c2_6 * y_squared) + self->c2_4) * y_squared) + self->c2_2;
            const double row2 = (v3 * y_squared) + self->c2_0 + (v2 * y);
            const double v4 = (((self->c3_4 * y_squared) + self->c3_2) * y_squared) + self->c3_0;
            const double row3 = v4 + (((self->c3_3 * y_squared) + self->c3_3) * y);
            const double row4 = (self->c4_2 * y_squared) + self->c4_2 + (self->c4_1 * y);
            const double v5 = (((((row1 * x1 * sec) + (row2 * x2)) * sec) + (row3 * x3)) * sec) + (row4 * x4);
            double v = v5 * sec;

            if (v > self->u_max) {
                v = self->u_max;
                status = PTC_SATURATED;
            } else if (v < -self->u_max) {
                v = -self->u_max;
                status = PTC_SATURATED;
            } else if (isfinite(v) == 0) {
                v = 0.0;
                status = PTC_E_RANGE;
            } else if (late < self->hold_from) {
                status = PTC_OK;
            } else {
                status = PTC_HOLD;
            }
            *u = v;
        }
    }
    return status;
}

ptc_status ptc_algebraic4_tick(const ptc_algebraic4 *self, double t, ptc_algebraic4_gains *gains)
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL)
        && (gains != NULL)
        && isfinite(t)
        && (t >= self->t0)) {
        const double past = (t - self->deadline) - self->correction;
        const double late = (past < self->hold_from) ? past : self->hold_from;
        const double T = -late;
        const double one_plus_y2 = (self->half_tau / T) + (self->half_tau / (self->two_tau + late));
        const double v1 = one_plus_y2 * one_plus_y2;
        const double row1 = self->c1_4 * v1 * v1;
        const double sec = sqrt(one_plus_y2);
        const double y = ((late * self->inv_tau) + 1.0) * sec;
        const double y_squared = one_plus_y2 - 1.0;
        const double v2 = (((self->c2_5 * y_squared) + self->c2_3) * y_squared) + self->c2_1;
        const double v3 = (((self->c2_6 * y_squared) + self->c2_4) * y_squared) + self->c2_2;
        const double row2 = (v3 * y_squared) + self->c2_0 + (v2 * y);
        const double v4 = (((self->c3_4 * y_squared) + self->c3_2) * y_squared) + self->c3_0;
        const double row3 = v4 + (((self->c3_3 * y_squared) + self->c3_3) * y);
        const double row4 = (self->c4_2 * y_squared) + self->c4_2 + (self->c4_1 * y);
        const double v5 = sec * sec;
        status = (late < self->hold_from) ? PTC_OK : PTC_HOLD;
        gains->gain[0] = row1 * v5 * v5;
        gains->gain[1] = row2 * v5 * sec;
        gains->gain[2] = row3 * sec * sec;
        gains->gain[3] = row4 * sec;
        gains->u_max = self->u_max;
        gains->status = status;
    }
    return status;
}

ptc_status ptc_algebraic4_axis(const ptc_algebraic4_gains *gains, const double x[4], double *u)
{
    ptc_status status = PTC_E_INPUT;

    if (u != NULL) {
        *u = 0.0;
    }
    if ((gains != NULL) && (x != NULL) && (u != NULL)) {
        const double x1 = x[0];
        const double x2 = x[1];
        const double x3 = x[2];
        const double x4 = x[3];

        if (isfinite(x1)
            && isfinite(x2)
            && isfinite(x3)
            && isfinite(x4)) {
            const double v1 = (gains->gain[0] * x1) + (gains->gain[1] * x2) + (gains->gain[2] * x3);
            double v = v1 + (gains->gain[3] * x4);

            status = gains->status;
            if (v > gains->u_max) {
                v = gains->u_max;
                status = PTC_SATURATED;
            } else if (v < -gains->u_max) {
                v = -gains->u_max;
                status = PTC_SATURATED;
            } else if (isfinite(v) == 0) {
                v = 0.0;
                status = PTC_E_RANGE;
            } else {
                /* within the bound */
            }
            *u = v;
        }
    }
    return status;
}
