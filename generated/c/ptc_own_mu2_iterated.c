/* Prescribed-time controller ptc_own_mu2_iterated: see ptc_own_mu2_iterated.h. DO NOT EDIT. */
#include "ptc_own_mu2_iterated.h"

#include <math.h>
#include <stddef.h>
#include <stdint.h>

/* Whether a product keeps its digits: it is well above the least normal number, or 0 with a factor. */
static int ptc_own_mu2_iterated_kept(double product, double factor)
{
    return ((fabs(product) >= 1e-200) || (fabs(factor) <= 0.0)) ? 1 : 0;
}

ptc_status ptc_own_mu2_iterated_init(ptc_own_mu2_iterated *self, const ptc_own_mu2_iterated_params *params)
{
    ptc_status status = PTC_E_PARAM;

    if ((self != NULL) && (params != NULL)) {
        const double tau = params->tau;
        const double t0 = params->t0;
        const double eps = params->eps;
        const double u_max = params->u_max;
        const double k1 = params->k[0];
        const double k2 = params->k[1];
        const double p_a = params->a;

        if (isfinite(tau)
            && (tau >= 1e-150)
            && (tau <= 1e150)
            && isfinite(t0)
            && (eps >= 1e-150)
            && (u_max > 0.0)
            && isfinite(k1)
            && isfinite(k2)
            && isfinite(p_a)
            && (p_a >= 1e-150)
            && (p_a <= 1e150)
            && (eps < tau)) {
            struct ptc_own_mu2_iterated built;

            const double hold_from = -eps;
            const double f29 = (-2.0) * p_a;
            const double w1 = -k1;
            const double w2 = -k2;
            built.tau = tau;
            built.eps = eps;
            built.hold_from = hold_from;
            built.f29 = f29;
            built.f63 = f29 * f29 * 0.5;
            built.w1 = w1;
            built.w2 = w2;
            built.u_max = u_max;
            built.t0 = 0.0;
            built.deadline = 0.0;
            built.correction = 0.0;

            if ((ptc_own_mu2_iterated_kept(w1, k1) != 0)
                && (ptc_own_mu2_iterated_kept(w2, k2) != 0)
                && isfinite(built.hold_from)
                && isfinite(built.f29)
                && isfinite(built.f63)
                && isfinite(built.w1)
                && isfinite(built.w2)) {
                status = ptc_own_mu2_iterated_arm(&built, t0);
            }
            if (status == PTC_OK) {
                *self = built;
            }
        }
    }
    return status;
}

ptc_status ptc_own_mu2_iterated_arm(ptc_own_mu2_iterated *self, double t0)
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

ptc_status ptc_own_mu2_iterated_step(const ptc_own_mu2_iterated *self, double t, const double x[2], double *u)
{
    ptc_status status = PTC_E_INPUT;

    if (u != NULL) {
        *u = 0.0;
    }
    if ((self != NULL) && (x != NULL) && (u != NULL)) {
        const double x1 = x[0];
        const double x2 = x[1];

        if (isfinite(t)
            && (t >= self->t0)
            && isfinite(x1)
            && isfinite(x2)) {
            const double past = (t - self->deadline) - self->correction;
            const double late = (past < self->hold_from) ? past : self->hold_from;
            const double T = -late;
            double y = 0.0;
            double y_low = 0.0;
            double y_high = 1e300;
            for (uint32_t round = 0U; round < 40U; round++) {
                const double v1 = (y + 1.0) * 2.0;
                const double v2 = self->tau / v1;
                const double v3 = exp(y * self->f29);
                const double v4 = 1.0 + v3;
                const double v5 = (v3 * self->tau) / v4;
                const double v6 = v2 + v5;
                const double v7 = (v2 * (-(2.0 * (1.0 / v1)))) + (v5 * ((-(v3 * self->f29 * (1.0 / v4))) + self->f29));
                const double v8 = log(v6 / T);
                const double y_next = y - (v8 * (v6 / v7));
                const double y_size = fabs(v8);
                if (v8 > 0.0) {
                    y_low = y;
                } else {
                    y_high = y;
                }
                if ((y_next >= y_low) && (y_next <= y_high)) {
                    y = y_next;
                } else {
                    y = 0.5 * (y_low + y_high);
                }
                if (y_size <= 1e-9) {
                    break;
                }
            }
            const double v9 = (y + 1.0) * 2.0;
            const double v10 = 2.0 * (1.0 / v9);
            const double v11 = -v10;
            const double v12 = self->tau / v9;
            const double v13 = exp(y * self->f29);
            const double v14 = 1.0 + v13;
            const double v15 = 1.0 / v14;
            const double v16 = v13 * self->f29 * v15;
            const double v17 = -v16;
            const double v18 = (-((v16 * v17) + (v13 * self->f63 * v15))) + (self->f29 * v17) + self->f63;
            const double v19 = (v13 * self->tau) / v14;
            const double v20 = (v12 * v11) + (v19 * (v17 + self->f29));
            const double inv_r1 = 1.0 / (-v20);
            const double v21 = self->w2 + ((-2.0) * (((v12 * (-(v10 * v11))) + (v19 * v18)) * (1.0 / v20)));
            double v = ((self->w1 * x1 * inv_r1) + (v21 * x2)) * inv_r1;

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

ptc_status ptc_own_mu2_iterated_tick(const ptc_own_mu2_iterated *self, double t, ptc_own_mu2_iterated_gains *gains)
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL)
        && (gains != NULL)
        && isfinite(t)
        && (t >= self->t0)) {
        const double past = (t - self->deadline) - self->correction;
        const double late = (past < self->hold_from) ? past : self->hold_from;
        const double T = -late;
        double y = 0.0;
        double y_low = 0.0;
        double y_high = 1e300;
        for (uint32_t round = 0U; round < 40U; round++) {
            const double v1 = (y + 1.0) * 2.0;
            const double v2 = self->tau / v1;
            const double v3 = exp(y * self->f29);
            const double v4 = 1.0 + v3;
            const double v5 = (v3 * self->tau) / v4;
            const double v6 = v2 + v5;
            const double v7 = (v2 * (-(2.0 * (1.0 / v1)))) + (v5 * ((-(v3 * self->f29 * (1.0 / v4))) + self->f29));
            const double v8 = log(v6 / T);
            const double y_next = y - (v8 * (v6 / v7));
            const double y_size = fabs(v8);
            if (v8 > 0.0) {
                y_low = y;
            } else {
                y_high = y;
            }
            if ((y_next >= y_low) && (y_next <= y_high)) {
                y = y_next;
            } else {
                y = 0.5 * (y_low + y_high);
            }
            if (y_size <= 1e-9) {
                break;
            }
        }
        const double v9 = (y + 1.0) * 2.0;
        const double v10 = 2.0 * (1.0 / v9);
        const double v11 = -v10;
        const double v12 = self->tau / v9;
        const double v13 = exp(y * self->f29);
        const double v14 = 1.0 + v13;
        const double v15 = 1.0 / v14;
        const double v16 = v13 * self->f29 * v15;
        const double v17 = -v16;
        const double v18 = (-((v16 * v17) + (v13 * self->f63 * v15))) + (self->f29 * v17) + self->f63;
        const double v19 = (v13 * self->tau) / v14;
        const double v20 = (v12 * v11) + (v19 * (v17 + self->f29));
        const double inv_r1 = 1.0 / (-v20);
        const double v21 = self->w2 + ((-2.0) * (((v12 * (-(v10 * v11))) + (v19 * v18)) * (1.0 / v20)));
        status = (late < self->hold_from) ? PTC_OK : PTC_HOLD;
        gains->gain[0] = self->w1 * inv_r1 * inv_r1;
        gains->gain[1] = v21 * inv_r1;
        gains->u_max = self->u_max;
        gains->status = status;
    }
    return status;
}

ptc_status ptc_own_mu2_iterated_axis(const ptc_own_mu2_iterated_gains *gains, const double x[2], double *u)
{
    ptc_status status = PTC_E_INPUT;

    if (u != NULL) {
        *u = 0.0;
    }
    if ((gains != NULL) && (x != NULL) && (u != NULL)) {
        const double x1 = x[0];
        const double x2 = x[1];

        if (isfinite(x1)
            && isfinite(x2)) {
            double v = (gains->gain[0] * x1) + (gains->gain[1] * x2);

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
