/* Prescribed-time controller stage29: see stage29.h. DO NOT EDIT. */
#include "stage29.h"

#include <math.h>
#include <stddef.h>
#include <stdint.h>

ptc_status stage29_init(stage29 *self, const stage29_params *params)
{
    ptc_status status = PTC_E_PARAM;

    (void)params;
    if (self != NULL) {
        self->start = 0U;
        status = PTC_OK;
    }
    return status;
}

ptc_status stage29_arm(stage29 *self, uint32_t k)
{
    ptc_status status = PTC_E_INPUT;

    if (self != NULL) {
        self->start = k;
        status = PTC_OK;
    }
    return status;
}

ptc_status stage29_step(
    const stage29 *self,
    uint32_t k,
    const double x[3][2],
    double u[3],
    ptc_status axes[3])
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (x != NULL) && (u != NULL) && (axes != NULL)) {
        if ((isfinite(x[0][0]) != 0)
            && (isfinite(x[0][1]) != 0)
            && (isfinite(x[1][0]) != 0)
            && (isfinite(x[1][1]) != 0)
            && (isfinite(x[2][0]) != 0)
            && (isfinite(x[2][1]) != 0)) {
            const uint32_t elapsed = k - self->start;
            const double x1_1 = x[0][0];
            const double x2_1 = x[0][1];
            const double x1_2 = x[1][0];
            const double x2_2 = x[1][1];
            const double x1_3 = x[2][0];
            const double x2_3 = x[2][1];
            double law_1;
            double law_2;
            double law_3;
            if (elapsed < 24U) {
                /* The exact law in samples. */
                const double m0 = (double)(30U - elapsed);
                const double z1_1 = ((-400000.0) * x1_1) + (2000.0 * x2_1);
                const double z2_1 = (-1600.0) * x2_1;
                law_1 = ((z1_1 / m0) + z2_1) / (m0 - 1.0);
            } else {
                /* Deadbeat. */
                law_1 = ((-20000.0) * x1_1) - (300.0 * x2_1);
            }
            if (elapsed < 26U) {
                /* The exact law in samples. */
                const double m0 = (double)(30U - elapsed);
                const double z1_2 = ((-50000.0) * x1_2) + (250.0 * x2_2);
                const double z2_2 = (-250.0) * x2_2;
                law_2 = ((z1_2 / m0) + z2_2) / (m0 - 1.0);
            } else {
                /* Deadbeat. */
                law_2 = ((-5000.0) * x1_2) - (75.0 * x2_2);
            }
            if (elapsed < 21U) {
                /* The exact law in samples. */
                const double m0 = (double)(30U - elapsed);
                const double z1_3 = (450000.0 * x1_3) - (2250.0 * x2_3);
                const double z2_3 = 1250.0 * x2_3;
                law_3 = ((z1_3 / m0) + z2_3) / (m0 - 1.0);
            } else {
                /* Deadbeat. */
                law_3 = (10000.0 * x1_3) + (150.0 * x2_3);
            }
            if (elapsed < 30U) {
                status = PTC_OK;
            } else {
                status = PTC_HOLD;
            }
            if ((isfinite(law_1) != 0) && (isfinite(law_2) != 0) && (isfinite(law_3) != 0)) {
                u[0] = law_1;
                axes[0] = status;
                u[1] = law_2;
                axes[1] = status;
                u[2] = law_3;
                axes[2] = status;
                if (1.0 < law_1) {
                    u[0] = 1.0;
                    axes[0] = PTC_SATURATED;
                    status = PTC_SATURATED;
                } else if (law_1 < -1.0) {
                    u[0] = -1.0;
                    axes[0] = PTC_SATURATED;
                    status = PTC_SATURATED;
                } else {
                    /* neither */
                }
                if (2.0 < law_2) {
                    u[1] = 2.0;
                    axes[1] = PTC_SATURATED;
                    status = PTC_SATURATED;
                } else if (law_2 < -2.0) {
                    u[1] = -2.0;
                    axes[1] = PTC_SATURATED;
                    status = PTC_SATURATED;
                } else {
                    /* neither */
                }
                if (3.0 < law_3) {
                    u[2] = 3.0;
                    axes[2] = PTC_SATURATED;
                    status = PTC_SATURATED;
                } else if (law_3 < -3.0) {
                    u[2] = -3.0;
                    axes[2] = PTC_SATURATED;
                    status = PTC_SATURATED;
                } else {
                    /* neither */
                }
            } else {
                u[0] = 0.0;
                if (isfinite(law_1) != 0) {
                    axes[0] = status;
                } else {
                    axes[0] = PTC_E_RANGE;
                }
                u[1] = 0.0;
                if (isfinite(law_2) != 0) {
                    axes[1] = status;
                } else {
                    axes[1] = PTC_E_RANGE;
                }
                u[2] = 0.0;
                if (isfinite(law_3) != 0) {
                    axes[2] = status;
                } else {
                    axes[2] = PTC_E_RANGE;
                }
                status = PTC_E_RANGE;
            }
        } else {
            for (uint32_t i = 0U; i < 3U; i++) {
                u[i] = 0.0;
                axes[i] = PTC_E_INPUT;
            }
        }
    } else {
        if (u != NULL) {
            for (uint32_t i = 0U; i < 3U; i++) {
                u[i] = 0.0;
            }
        }
    }
    return status;
}
