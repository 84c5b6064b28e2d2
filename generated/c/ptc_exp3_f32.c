/* Prescribed-time controller ptc_exp3_f32: see ptc_exp3_f32.h. DO NOT EDIT. */
#include "ptc_exp3_f32.h"

#include <math.h>
#include <stddef.h>

/* Whether a product keeps its digits: it is well above the least normal number, or 0 with a factor. */
static int ptc_exp3_f32_kept(float product, float factor)
{
    return ((fabsf(product) >= 1e-30f) || (fabsf(factor) <= 0.0f)) ? 1 : 0;
}

ptc_status ptc_exp3_f32_init(ptc_exp3_f32 *self, const ptc_exp3_f32_params *params)
{
    ptc_status status = PTC_E_PARAM;

    if ((self != NULL) && (params != NULL)) {
        const float tau = params->tau;
        const float t0 = params->t0;
        const float eps = params->eps;
        const float u_max = params->u_max;
        const float a = params->a;
        const float k1 = params->k[0];
        const float k2 = params->k[1];
        const float k3 = params->k[2];

        if (isfinite(tau)
            && (tau >= 1e-18f)
            && (tau <= 1e18f)
            && isfinite(t0)
            && (eps >= 1e-18f)
            && (u_max > 0.0f)
            && isfinite(a)
            && (a >= 1e-18f)
            && (a <= 1e18f)
            && isfinite(k1)
            && isfinite(k2)
            && isfinite(k3)
            && (eps < tau)) {
            struct ptc_exp3_f32 built;

            const float v1 = a * a;
            const float v2 = a * v1;
            const float K1 = k1 / v2;
            const float K2 = k2 / v1;
            const float K3 = k3 / a;
            const float c1 = -K1;
            const float c2 = ((-K2) + K3) - 1.0f;
            const float c3 = (-K3) + 3.0f;
            const float hold_from = -eps;
            built.c1 = c1;
            built.c2 = c2;
            built.c3 = c3;
            built.tau = tau;
            built.eps = eps;
            built.hold_from = hold_from;
            built.u_max = u_max;
            built.t0 = 0.0f;
            built.deadline = 0.0f;
            built.correction = 0.0f;

            if ((v2 >= 1e-30f)
                && (ptc_exp3_f32_kept(K1, k1) != 0)
                && (ptc_exp3_f32_kept(K2, k2) != 0)
                && (ptc_exp3_f32_kept(K3, k3) != 0)
                && isfinite(built.c1)
                && isfinite(built.c2)
                && isfinite(built.c3)
                && isfinite(built.hold_from)) {
                status = ptc_exp3_f32_arm(&built, t0);
            }
            if (status == PTC_OK) {
                *self = built;
            }
        }
    }
    return status;
}

ptc_status ptc_exp3_f32_arm(ptc_exp3_f32 *self, float t0)
{
    ptc_status status = PTC_E_PARAM;

    if ((self != NULL) && isfinite(t0)) {
        const float deadline = t0 + self->tau;
        const float v1 = deadline - t0;
        const float correction = (t0 - (deadline - v1)) + (self->tau - v1);

        if (isfinite(deadline) != 0) {
            self->t0 = t0;
            self->deadline = deadline;
            self->correction = correction;
            status = PTC_OK;
        }
    }
    return status;
}

ptc_status ptc_exp3_f32_step(const ptc_exp3_f32 *self, float t, const float x[3], float *u)
{
    ptc_status status = PTC_E_INPUT;

    if (u != NULL) {
        *u = 0.0f;
    }
    if ((self != NULL) && (x != NULL) && (u != NULL)) {
        const float x1 = x[0];
        const float x2 = x[1];
        const float x3 = x[2];

        if (isfinite(t)
            && (t >= self->t0)
            && isfinite(x1)
            && isfinite(x2)
            && isfinite(x3)) {
            const float past = (t - self->deadline) - self->correction;
            const float late = (past < self->hold_from) ? past : self->hold_from;
            const float inv_T = (-1.0f) / late;
            const float v1 = (((self->c1 * x1 * inv_T) + (self->c2 * x2)) * inv_T) + (self->c3 * x3);
            float v = v1 * inv_T;

            if (v > self->u_max) {
                v = self->u_max;
                status = PTC_SATURATED;
            } else if (v < -self->u_max) {
                v = -self->u_max;
                status = PTC_SATURATED;
            } else if (isfinite(v) == 0) {
                v = 0.0f;
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

ptc_status ptc_exp3_f32_tick(const ptc_exp3_f32 *self, float t, ptc_exp3_f32_gains *gains)
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL)
        && (gains != NULL)
        && isfinite(t)
        && (t >= self->t0)) {
        const float past = (t - self->deadline) - self->correction;
        const float late = (past < self->hold_from) ? past : self->hold_from;
        const float inv_T = (-1.0f) / late;
        status = (late < self->hold_from) ? PTC_OK : PTC_HOLD;
        gains->gain[0] = self->c1 * (inv_T * inv_T) * inv_T;
        gains->gain[1] = self->c2 * inv_T * inv_T;
        gains->gain[2] = self->c3 * inv_T;
        gains->u_max = self->u_max;
        gains->status = status;
    }
    return status;
}

ptc_status ptc_exp3_f32_axis(const ptc_exp3_f32_gains *gains, const float x[3], float *u)
{
    ptc_status status = PTC_E_INPUT;

    if (u != NULL) {
        *u = 0.0f;
    }
    if ((gains != NULL) && (x != NULL) && (u != NULL)) {
        const float x1 = x[0];
        const float x2 = x[1];
        const float x3 = x[2];

        if (isfinite(x1)
            && isfinite(x2)
            && isfinite(x3)) {
            const float v1 = (gains->gain[0] * x1) + (gains->gain[1] * x2) + (gains->gain[2] * x3);
            float v = v1;

            status = gains->status;
            if (v > gains->u_max) {
                v = gains->u_max;
                status = PTC_SATURATED;
            } else if (v < -gains->u_max) {
                v = -gains->u_max;
                status = PTC_SATURATED;
            } else if (isfinite(v) == 0) {
                v = 0.0f;
                status = PTC_E_RANGE;
            } else {
                /* within the bound */
            }
            *u = v;
        }
    }
    return status;
}
