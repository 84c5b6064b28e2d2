/* Prescribed-time controller ptc_exp3_f32: see ptc_exp3_f32.h. DO NOT EDIT. */
#include "ptc_exp3_f32.h"

#include <math.h>
#include <stddef.h>

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
            && (tau > 0.0f)
            && isfinite(t0)
            && (eps > 0.0f)
            && (eps < tau)
            && (u_max > 0.0f)
            && isfinite(a)
            && (a > 0.0f)
            && isfinite(k1)
            && isfinite(k2)
            && isfinite(k3)) {
            ptc_exp3_f32 built;

            const float v1 = a * a;
            const float K1 = k1 / (a * v1);
            const float K2 = k2 / v1;
            const float K3 = k3 / a;
            const float c1 = -K1;
            const float c2 = ((-K2) + K3) - 1.0f;
            const float c3 = (-K3) + 3.0f;
            built.c1 = c1;
            built.c2 = c2;
            built.c3 = c3;
            built.tau = tau;
            built.eps = eps;
            built.u_max = u_max;

            if (isfinite(built.c1)
                && isfinite(built.c2)
                && isfinite(built.c3)) {
                status = ptc_exp3_f32_arm(&built, t0);
                if (status == PTC_OK) {
                    *self = built;
                }
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

        if (isfinite(deadline)) {
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
            status = PTC_OK;
            float T = (self->deadline - t) + self->correction;
            if (T <= self->eps) {
                T = self->eps;
                status = PTC_HOLD;
            }
            const float inv_T = 1.0f / T;
            const float v1 = (((self->c1 * x1 * inv_T) + (self->c2 * x2)) * inv_T) + (self->c3 * x3);

            float v = v1 * inv_T;
            if (v > self->u_max) {
                v = self->u_max;
                status = PTC_SATURATED;
            } else if (v < -self->u_max) {
                v = -self->u_max;
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

ptc_status ptc_exp3_f32_tick(const ptc_exp3_f32 *self, float t, ptc_exp3_f32_gains *gains)
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL)
        && (gains != NULL)
        && isfinite(t)
        && (t >= self->t0)) {
        status = PTC_OK;
        float T = (self->deadline - t) + self->correction;
        if (T <= self->eps) {
            T = self->eps;
            status = PTC_HOLD;
        }
        const float inv_T = 1.0f / T;
        const float v1 = inv_T * inv_T;
        gains->gain[0] = self->c1 * (v1 * inv_T);
        gains->gain[1] = self->c2 * v1;
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
            status = gains->status;
            const float gain1 = gains->gain[0];
            const float gain2 = gains->gain[1];
            const float gain3 = gains->gain[2];

            float v = (gain1 * x1) + (gain2 * x2) + (gain3 * x3);
            if (v > gains->u_max) {
                v = gains->u_max;
                status = PTC_SATURATED;
            } else if (v < -gains->u_max) {
                v = -gains->u_max;
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
