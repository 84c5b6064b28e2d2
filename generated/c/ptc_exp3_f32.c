/* Prescribed-time controller ptc_exp3_f32: see ptc_exp3_f32.h. DO NOT EDIT. */
#include "ptc_exp3_f32.h"

#include <math.h>
#include <stddef.h>

ptc_status ptc_exp3_f32_init(ptc_exp3_f32 *self, const ptc_exp3_f32_params *params)
{
    ptc_status status = PTC_E_PARAM;
    struct ptc_exp3_f32 built;

    if ((self != NULL) && (params != NULL)) {
        const float tau = params->tau;
        const float t0 = params->t0;
        const float eps = params->eps;
        const float u_max = params->u_max;
        const float a = params->a;
        const float k1 = params->k[0];
        const float k2 = params->k[1];
        const float k3 = params->k[2];
        if ((isfinite(tau) != 0)
            && (1e-18f <= tau)
            && (tau <= 1e18f)
            && (isfinite(t0) != 0)
            && (1e-18f <= eps)
            && (0.0f < u_max)
            && (isfinite(a) != 0)
            && (1e-18f <= a)
            && (a <= 1e18f)
            && (isfinite(k1) != 0)
            && (isfinite(k2) != 0)
            && (isfinite(k3) != 0)
            && (eps < tau)) {
            const float v1 = a * a;
            const float v2 = a * v1;
            const float K1 = k1 / v2;
            const float K2 = k2 / v1;
            const float K3 = k3 / a;
            const float c1 = -K1;
            const float c2 = ((-K2) + K3) - 1.0f;
            const float c3 = (-K3) + 3.0f;
            const float hold_from = -eps;
            const float size_K1 = (fabsf(k1) <= 0.0f) ? 1e-30f : fabsf(K1);
            const float size_K2 = (fabsf(k2) <= 0.0f) ? 1e-30f : fabsf(K2);
            const float size_K3 = (fabsf(k3) <= 0.0f) ? 1e-30f : fabsf(K3);
            if ((1e-30f <= v2)
                && (1e-30f <= size_K1)
                && (1e-30f <= size_K2)
                && (1e-30f <= size_K3)
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
                built.t0 = 0.0f;
                built.deadline = 0.0f;
                built.correction = 0.0f;
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

    if (self != NULL) {
        if (isfinite(t0) != 0) {
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
        const float past = (t - self->deadline) - self->correction;
        const float late = (past < self->hold_from) ? past : self->hold_from;
        const float inv_T = (-1.0f) / late;
        const float s1 = ((self->c1 * x[0] * inv_T) + (self->c2 * x[1])) * inv_T;
        const float v = (s1 + (self->c3 * x[2])) * inv_T;
        *u = v;
        if ((self->t0 <= t)
            && (isfinite(v) != 0)
            && (fabsf(v) <= self->u_max)
            && (late < self->hold_from)) {
            status = PTC_OK;
        } else if ((isfinite(t) != 0)
            && (self->t0 <= t)
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
                *u = 0.0f;
                status = PTC_E_RANGE;
            }
        } else {
            *u = 0.0f;
            status = PTC_E_INPUT;
        }
    }
    return status;
}

ptc_status ptc_exp3_f32_tick(const ptc_exp3_f32 *self, float t, ptc_exp3_f32_gains *gains)
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (gains != NULL)) {
        if ((isfinite(t) != 0) && (self->t0 <= t)) {
            const float past = (t - self->deadline) - self->correction;
            const float late = (past < self->hold_from) ? past : self->hold_from;
            const float inv_T = (-1.0f) / late;
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

ptc_status ptc_exp3_f32_axis(const ptc_exp3_f32_gains *gains, const float x[3], float *u)
{
    ptc_status status = PTC_E_INPUT;

    if (u != NULL) {
        *u = 0.0f;
    }
    if ((gains != NULL) && (x != NULL) && (u != NULL)) {
        const float s1 = (gains->gain[0] * x[0]) + (gains->gain[1] * x[1]);
        const float v = s1 + (gains->gain[2] * x[2]);
        *u = v;
        if ((isfinite(v) != 0) && (fabsf(v) <= gains->u_max)) {
            status = gains->status;
        } else if ((isfinite(x[0]) != 0) && (isfinite(x[1]) != 0) && (isfinite(x[2]) != 0)) {
            if (gains->u_max < v) {
                *u = gains->u_max;
                status = PTC_SATURATED;
            } else if (v < -gains->u_max) {
                *u = -gains->u_max;
                status = PTC_SATURATED;
            } else {
                *u = 0.0f;
                status = PTC_E_RANGE;
            }
        } else {
            *u = 0.0f;
            status = PTC_E_INPUT;
        }
    }
    return status;
}
