/* Prescribed-time controller stage25: see stage25.h. DO NOT EDIT. */
#include "stage25.h"

#include <math.h>
#include <stddef.h>
#include <stdint.h>

ptc_status stage25_init(stage25 *self, const stage25_params *params)
{
    ptc_status status = PTC_E_PARAM;

    (void)params;
    if (self != NULL) {
        self->start = 0U;
        status = PTC_OK;
    }
    return status;
}

ptc_status stage25_arm(stage25 *self, uint32_t k)
{
    ptc_status status = PTC_E_INPUT;

    if (self != NULL) {
        self->start = k;
        status = PTC_OK;
    }
    return status;
}

ptc_status stage25_step(
    const stage25 *self,
    uint32_t k,
    const double x[3],
    double u[2],
    ptc_status axes[2])
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (x != NULL) && (u != NULL) && (axes != NULL)) {
        if ((isfinite(x[0]) != 0) && (isfinite(x[1]) != 0) && (isfinite(x[2]) != 0)) {
            const uint32_t elapsed = k - self->start;

            /* The chain of each output. */
            const double x1_1 = x[0];
            const double x1_2 = x[2];
            const double v1 = x[1] - x1_2;
            const double v2 = 1.0 + x1_1;
            const double x2_2 = v1 * v2;
            const uint32_t left = (elapsed < 30U) ? (30U - elapsed) : 0U;
            const double m0 = ((double)left < 4.0) ? 4.0 : (double)left;
            double law_1;
            double law_2;
            if (0.5 < m0) {
                /* The exact law in samples. */
                const double z1_1 = (-400.0) * x1_1;
                law_1 = z1_1 / m0;
            } else {
                /* Deadbeat. */
                law_1 = (-100.0) * x1_1;
            }
            if (1.5 < m0) {
                /* The exact law in samples. */
                const double z1_2 = ((-135000.0) * x1_2) + (675.0 * x2_2);
                const double z2_2 = (-650.0) * x2_2;
                law_2 = ((z1_2 / m0) + z2_2) / (m0 - 1.0);
            } else {
                /* Deadbeat. */
                law_2 = ((-10000.0) * x1_2) - (150.0 * x2_2);
            }

            /* The inputs that give all of them. */
            const double v3 = (-x1_1) * 0.1;
            const double v4 = law_1 - v3;
            const double v5 = 1.0 / (((v2 < 0.0) || (v2 > 0.0)) ? v2 : (double)NAN);
            const double control1 = v2 * v4 * v5;
            const double s1 = ((-v1) * v4) + (law_2 - (((((-x[1]) * v2) - x2_2) * v2) + (v1 * v3)));
            const double control2 = s1 * v5;
            if (4.0 < (double)left) {
                status = PTC_OK;
            } else {
                status = PTC_HOLD;
            }
            if ((isfinite(control1) != 0) && (isfinite(control2) != 0)) {
                u[0] = control1;
                axes[0] = status;
                u[1] = control2;
                axes[1] = status;
                if (2.0 < control1) {
                    u[0] = 2.0;
                    axes[0] = PTC_SATURATED;
                    status = PTC_SATURATED;
                } else if (control1 < -2.0) {
                    u[0] = -2.0;
                    axes[0] = PTC_SATURATED;
                    status = PTC_SATURATED;
                } else {
                    /* neither */
                }
                if (3.0 < control2) {
                    u[1] = 3.0;
                    axes[1] = PTC_SATURATED;
                    status = PTC_SATURATED;
                } else if (control2 < -3.0) {
                    u[1] = -3.0;
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
