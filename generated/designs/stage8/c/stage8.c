/* Prescribed-time controller stage8: see stage8.h. DO NOT EDIT. */
#include "stage8.h"

#include <math.h>
#include <stddef.h>

ptc_status stage8_init(stage8 *self, const stage8_params *params)
{
    ptc_status status = PTC_E_PARAM;

    (void)params;
    if (self != NULL) {
        self->start = 0U;
        status = PTC_OK;
    }
    return status;
}

ptc_status stage8_arm(stage8 *self, uint32_t k)
{
    ptc_status status = PTC_E_INPUT;

    if (self != NULL) {
        self->start = k;
        status = PTC_OK;
    }
    return status;
}

ptc_status stage8_step(const stage8 *self, uint32_t k, const double x[2], double *u)
{
    ptc_status status = PTC_E_INPUT;

    if (u != NULL) {
        *u = 0.0;
    }
    if ((self != NULL) && (x != NULL) && (u != NULL)) {
        if ((isfinite(x[0]) != 0) && (isfinite(x[1]) != 0)) {
            const uint32_t elapsed = k - self->start;
            const double x1 = x[0];
            const double x2 = x[1];
            const uint32_t left = (elapsed < 30U) ? (30U - elapsed) : 0U;
            const double m0 = ((double)left < 5.0) ? 5.0 : (double)left;
            double v;
            if (1.5 < m0) {
                /* The exact law in samples. */
                const double z1 = ((-20000000.0) * x1) + (10000.0 * x2);
                const double z2 = (-8000.0) * x2;
                v = ((z1 / m0) + z2) / (m0 - 1.0);
            } else {
                /* Deadbeat. */
                v = ((-1000000.0) * x1) - (1500.0 * x2);
            }
            if (isfinite(v) != 0) {
                if (elapsed < 30U) {
                    if (3.0 < v) {
                        *u = 3.0;
                        status = PTC_SATURATED;
                    } else if (v < -3.0) {
                        *u = -3.0;
                        status = PTC_SATURATED;
                    } else if ((double)left <= 5.0) {
                        *u = v;
                        status = PTC_HOLD;
                    } else {
                        *u = v;
                        status = PTC_OK;
                    }
                } else {
                    *u = 0.0;
                    status = PTC_AFTER;
                }
            } else {
                status = PTC_E_RANGE;
            }
        }
    }
    return status;
}
