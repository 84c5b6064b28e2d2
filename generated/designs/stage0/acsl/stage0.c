/* Prescribed-time controller stage0: see stage0.h. DO NOT EDIT. */
#include "stage0.h"

#include <math.h>
#include <stddef.h>

ptc_status stage0_init(stage0 *self, const stage0_params *params)
{
    ptc_status status = PTC_E_PARAM;

    if ((self != NULL) && (params != NULL)) {
        if ((0U < params->samples)
            && (1e-150 <= params->h)
            && (params->h <= 1e150)
            && (0.0 < params->u_max)
            && (1e-150 <= params->a)
            && (params->a <= 1e150)
            && (isfinite(params->k[0]) != 0)
            && (isfinite(params->deadbeat) != 0)
            && (0.0 <= params->deadbeat)) {
            const uint32_t samples = params->samples;
            const double s1 = (params->k[0] / params->a) + 1.0;
            const double s2 = (s1 < 2.0) ? 2.0 : s1;
            const double deadbeat = (0.0 < params->deadbeat) ? params->deadbeat : s2;
            const double w1_1 = (-(params->k[0] / params->a)) * (1.0 / params->h);
            const double b_1 = -(1.0 / params->h);
            const double u_max = params->u_max;
            if ((isfinite(deadbeat) != 0)
                && (isfinite(w1_1) != 0)
                && (isfinite(b_1) != 0)
                && (1e-200 <= params->h)
                && (1e-200 <= 1.0 / params->h)) {
                self->start = 0U;
                self->samples = samples;
                self->deadbeat = deadbeat;
                self->w1_1 = w1_1;
                self->b_1 = b_1;
                self->u_max = u_max;
                status = PTC_OK;
            }
        }
    }
    return status;
}

ptc_status stage0_arm(stage0 *self, uint32_t k)
{
    ptc_status status = PTC_E_INPUT;

    if (self != NULL) {
        self->start = k;
        status = PTC_OK;
    }
    return status;
}

ptc_status stage0_step(const stage0 *self, uint32_t k, const double x[1], double *u)
{
    ptc_status status = PTC_E_INPUT;

    if (u != NULL) {
        *u = 0.0;
    }
    if ((self != NULL) && (x != NULL) && (u != NULL)) {
        if (isfinite(x[0]) != 0) {
            const uint32_t elapsed = k - self->start;
            const double x1 = x[0];
            const uint32_t left = (elapsed < self->samples) ? (self->samples - elapsed) : 0U;
            const double m0 = (double)left;
            double v;
            if (self->deadbeat < m0) {
                /* The exact law in samples. */
                const double z1 = self->w1_1 * x1;
                v = z1 / m0;
            } else {
                /* Deadbeat. */
                v = self->b_1 * x1;
            }
            if (isfinite(v) != 0) {
                if (self->u_max < v) {
                    *u = self->u_max;
                    status = PTC_SATURATED;
                } else if (v < -self->u_max) {
                    *u = -self->u_max;
                    status = PTC_SATURATED;
                } else if (elapsed < self->samples) {
                    *u = v;
                    status = PTC_OK;
                } else {
                    *u = v;
                    status = PTC_HOLD;
                }
            } else {
                status = PTC_E_RANGE;
            }
        }
    }
    return status;
}
