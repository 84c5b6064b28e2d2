/* Prescribed-time observer stage16_observer: see stage16_observer.h. DO NOT EDIT. */
#include "stage16_observer.h"

#include <float.h>
#include <math.h>
#include <stddef.h>
#include <stdint.h>

/* What this file requires of its compiler. */
#if defined(__SDCC) || (defined(DBL_MANT_DIG) && (DBL_MANT_DIG != 53))
#error "double is not IEEE 754 binary64 here: emit with --precision f32, or make double 64 bits wide"
#endif
#if defined(FLT_EVAL_METHOD) && !defined(PTC_ALLOW_EXCESS_PRECISION)
#if (FLT_EVAL_METHOD == 2)
#error "double is computed with more digits than it has: on x86 compile with -msse2 -mfpmath=sse, or define PTC_ALLOW_EXCESS_PRECISION"
#endif
#endif
#if !defined(PTC_ALLOW_FAST_MATH)
#if defined(__FAST_MATH__) || defined(_M_FP_FAST)
#error "the guards need NaN and infinity: compile without -ffast-math, -Ofast and -ffinite-math-only, or define PTC_ALLOW_FAST_MATH"
#elif defined(__FINITE_MATH_ONLY__)
#if __FINITE_MATH_ONLY__ > 0
#error "the guards need NaN and infinity: compile without -ffast-math, -Ofast and -ffinite-math-only, or define PTC_ALLOW_FAST_MATH"
#endif
#endif
#endif

#if !defined(PTC_FINITE_F64)
#if defined(isfinite) && !defined(__MINGW32__)
#define PTC_FINITE_F64(x) (isfinite(x) != 0)
#else
#define PTC_FINITE_F64(x) (fabs(x) <= DBL_MAX)
#endif
#endif

/* Numbers of the design, each rounded once. */
#define STAGE16_OBSERVER_GAMMA1 0.00010816330676811052 /* prediction from u */
#define STAGE16_OBSERVER_GAMMA2 0.30941358230147875 /* prediction from u */
#define STAGE16_OBSERVER_GAMMA3 0.37459048481653323 /* prediction from u */
#define STAGE16_OBSERVER_OBSERVER_SAMPLES 20U /* samples of the round of the observer */
#define STAGE16_OBSERVER_Q1_1_1 (-8.0) /* weight in the observer's gain l1_1 */
#define STAGE16_OBSERVER_Q1_1_2 8.0 /* weight in the observer's gain l1_1 */
#define STAGE16_OBSERVER_Q1_2_1 12007.013438558752 /* weight in the observer's gain l1_2 */
#define STAGE16_OBSERVER_Q1_2_2 (-4.007472019404232) /* weight in the observer's gain l1_2 */
#define STAGE16_OBSERVER_Q1_4_1 359.9910335767149 /* weight in the observer's gain l1_4 */
#define STAGE16_OBSERVER_Q2_2_1 (-18.578489051610646) /* weight in the observer's gain l2_2 */
#define STAGE16_OBSERVER_Q2_2_2 9.913794744612098 /* weight in the observer's gain l2_2 */
#define STAGE16_OBSERVER_Q2_3_1 (-12.0) /* weight in the observer's gain l2_3 */
#define STAGE16_OBSERVER_Q2_3_2 12.0 /* weight in the observer's gain l2_3 */
#define STAGE16_OBSERVER_Q2_4_1 79.8275894892242 /* weight in the observer's gain l2_4 */
#define STAGE16_OBSERVER_E0_1_1 0.9995008164815138 /* gain of the observer at its end */
#define STAGE16_OBSERVER_E0_1_2 (-0.4960345371406728) /* gain of the observer at its end */
#define STAGE16_OBSERVER_E0_1_3 0.005627803367048088 /* gain of the observer at its end */
#define STAGE16_OBSERVER_E0_2_1 0.0014420897963740578 /* gain of the observer at its end */
#define STAGE16_OBSERVER_E0_2_2 2.2101945239792857 /* gain of the observer at its end */
#define STAGE16_OBSERVER_E0_2_3 1.0319275340206813 /* gain of the observer at its end */
#define STAGE16_OBSERVER_E0_2_4 1.3304598248204031 /* gain of the observer at its end */
#define STAGE16_OBSERVER_E1_1_1 1.9995008164815138 /* gain of the observer at its end */
#define STAGE16_OBSERVER_E1_1_2 999.2535286720462 /* gain of the observer at its end */
#define STAGE16_OBSERVER_E1_1_3 0.005627803367048088 /* gain of the observer at its end */
#define STAGE16_OBSERVER_E1_1_4 29.999252798059576 /* gain of the observer at its end */
#define STAGE16_OBSERVER_E1_2_1 0.0014420897963740578 /* gain of the observer at its end */
#define STAGE16_OBSERVER_E1_2_2 2.4788577332214805 /* gain of the observer at its end */
#define STAGE16_OBSERVER_E1_2_3 1.5319275340206813 /* gain of the observer at its end */
#define STAGE16_OBSERVER_E1_2_4 2.6609196496408063 /* gain of the observer at its end */
#define STAGE16_OBSERVER_PHI1_2 0.000996505559752715 /* prediction of x1 from x2 */
#define STAGE16_OBSERVER_PHI1_3 0.0006188271646029575 /* prediction of x1 from x3 */
#define STAGE16_OBSERVER_PHI1_4 0.00010816330676811052 /* prediction of x1 from d */
#define STAGE16_OBSERVER_PHI2_2 0.9902193397510792 /* prediction of x2 from x2 */
#define STAGE16_OBSERVER_PHI2_3 1.1234620408672982 /* prediction of x2 from x3 */
#define STAGE16_OBSERVER_PHI2_4 0.30941358230147875 /* prediction of x2 from d */
#define STAGE16_OBSERVER_PHI3_2 (-0.011234620408672982) /* prediction of x3 from x2 */
#define STAGE16_OBSERVER_PHI3_3 0.5412090107511158 /* prediction of x3 from x3 */
#define STAGE16_OBSERVER_PHI3_4 0.37459048481653323 /* prediction of x3 from d */

ptc_status stage16_observer_init(stage16_observer *self, const stage16_observer_params *params)
{
    ptc_status status = PTC_E_PARAM;

    (void)params;
    if (self != NULL) {
        self->start = 0U;
        self->u1 = 0.0;
        self->seen = 0U;
        self->x1_hat = 0.0;
        self->x1_next = 0.0;
        self->x2_hat = 0.0;
        self->x2_next = 0.0;
        self->x3_hat = 0.0;
        self->x3_next = 0.0;
        self->d_hat = 0.0;
        self->d_next = 0.0;
        status = PTC_OK;
    }
    return status;
}

ptc_status stage16_observer_arm(stage16_observer *self, uint32_t k)
{
    ptc_status status = PTC_E_INPUT;

    if (self != NULL) {
        self->start = k;
        const double s1 = fabs(self->x1_next) + fabs(self->x2_next);
        const double size = s1 + fabs(self->x3_next) + fabs(self->d_next);
        if (!(size <= 1e150)) {
            self->seen = 0U;
            self->x1_hat = 0.0;
            self->x1_next = 0.0;
            self->x2_hat = 0.0;
            self->x2_next = 0.0;
            self->x3_hat = 0.0;
            self->x3_next = 0.0;
            self->d_hat = 0.0;
            self->d_next = 0.0;
        }
        status = PTC_OK;
    }
    return status;
}

ptc_status stage16_observer_update(stage16_observer *self, uint32_t k, const double y[2], double u)
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (y != NULL)) {
        if (PTC_FINITE_F64(y[0]) && PTC_FINITE_F64(y[1]) && PTC_FINITE_F64(u)) {
            const uint32_t elapsed = k - self->start;

            /* The estimates; at first what y shows. */
            double x1;
            double x2;
            double x3;
            double d;
            if (self->seen == 0U) {
                x1 = y[0];
                x2 = 0.0;
                x3 = y[1];
                d = 0.0;
            } else {
                x1 = self->x1_next + (STAGE16_OBSERVER_GAMMA1 * self->u1);
                x2 = self->x2_next + (STAGE16_OBSERVER_GAMMA2 * self->u1);
                x3 = self->x3_next + (STAGE16_OBSERVER_GAMMA3 * self->u1);
                d = self->d_next;
            }

            /* Prediction of the next sample. */
            const double miss1 = y[0] - x1;
            const double miss2 = y[1] - x3;
            const double off1 = miss1;
            const double off2 = miss2;
            const uint32_t left_o = (elapsed < STAGE16_OBSERVER_OBSERVER_SAMPLES) ? (STAGE16_OBSERVER_OBSERVER_SAMPLES - elapsed) : 0U;
            const double o0 = (double)left_o;
            double l1_1;
            double l1_2;
            double l1_3;
            double l1_4;
            double l2_1;
            double l2_2;
            double l2_3;
            double l2_4;
            if (left_o == 0U) {
                l1_1 = 0.17200400622757925;
                l1_2 = 7.693835124666324;
                l1_3 = 0.005627803367048088;
                l1_4 = 0.23319622641969587;
                l2_1 = 0.0014420897963740578;
                l2_2 = 1.2843129003368876;
                l2_3 = -0.2598303207324358;
                l2_4 = 0.028634005234458536;
            } else if (o0 > 8.0) {
                const double r0 = 1.0 / (o0 * (o0 - 1.0));
                const double s1 = (STAGE16_OBSERVER_Q1_1_1 + (STAGE16_OBSERVER_Q1_1_2 * o0)) * r0;
                l1_1 = s1 - 0.0004991835184862197;
                const double s2 = (STAGE16_OBSERVER_Q1_2_1 + (STAGE16_OBSERVER_Q1_2_2 * o0)) * r0;
                l1_2 = s2 + 0.004899465284856127;
                l1_3 = 0.005627803367048088;
                l1_4 = STAGE16_OBSERVER_Q1_4_1 * r0;
                l2_1 = 0.0014420897963740578;
                const double s3 = (STAGE16_OBSERVER_Q2_2_1 + (STAGE16_OBSERVER_Q2_2_2 * o0)) * r0;
                l2_2 = s3 + 1.1153817526860825;
                const double s4 = (STAGE16_OBSERVER_Q2_3_1 + (STAGE16_OBSERVER_Q2_3_2 * o0)) * r0;
                l2_3 = s4 - 0.46807246597931873;
                l2_4 = STAGE16_OBSERVER_Q2_4_1 * r0;
            } else if (left_o == 8U) {
                l1_1 = STAGE16_OBSERVER_E0_1_1;
                l1_2 = STAGE16_OBSERVER_E0_1_2;
                l1_3 = STAGE16_OBSERVER_E0_1_3;
                l1_4 = 0.0;
                l2_1 = STAGE16_OBSERVER_E0_2_1;
                l2_2 = STAGE16_OBSERVER_E0_2_2;
                l2_3 = STAGE16_OBSERVER_E0_2_3;
                l2_4 = STAGE16_OBSERVER_E0_2_4;
            } else {
                l1_1 = STAGE16_OBSERVER_E1_1_1;
                l1_2 = STAGE16_OBSERVER_E1_1_2;
                l1_3 = STAGE16_OBSERVER_E1_1_3;
                l1_4 = STAGE16_OBSERVER_E1_1_4;
                l2_1 = STAGE16_OBSERVER_E1_2_1;
                l2_2 = STAGE16_OBSERVER_E1_2_2;
                l2_3 = STAGE16_OBSERVER_E1_2_3;
                l2_4 = STAGE16_OBSERVER_E1_2_4;
            }
            const double s5 = x1 + (STAGE16_OBSERVER_PHI1_2 * x2) + (STAGE16_OBSERVER_PHI1_3 * x3);
            const double x1_on = s5 + (STAGE16_OBSERVER_PHI1_4 * d) + (l1_1 * off1) + (l2_1 * off2);
            const double s6 = (STAGE16_OBSERVER_PHI2_2 * x2) + (STAGE16_OBSERVER_PHI2_3 * x3);
            const double x2_on = s6 + (STAGE16_OBSERVER_PHI2_4 * d) + (l1_2 * off1) + (l2_2 * off2);
            const double s7 = (STAGE16_OBSERVER_PHI3_2 * x2) + (STAGE16_OBSERVER_PHI3_3 * x3);
            const double x3_on = s7 + (STAGE16_OBSERVER_PHI3_4 * d) + (l1_3 * off1) + (l2_3 * off2);
            const double d_on = d + (l1_4 * off1) + (l2_4 * off2);
            status = PTC_E_RANGE;
            if (PTC_FINITE_F64(x1)
                && PTC_FINITE_F64(x1_on)
                && PTC_FINITE_F64(x2)
                && PTC_FINITE_F64(x2_on)
                && PTC_FINITE_F64(x3)
                && PTC_FINITE_F64(x3_on)
                && PTC_FINITE_F64(d)
                && PTC_FINITE_F64(d_on)) {
                self->u1 = u;
                self->x1_hat = x1;
                self->x1_next = x1_on;
                self->x2_hat = x2;
                self->x2_next = x2_on;
                self->x3_hat = x3;
                self->x3_next = x3_on;
                self->d_hat = d;
                self->d_next = d_on;
                self->seen = 1U;
                if (left_o == 0U) {
                    status = PTC_HOLD;
                } else {
                    status = PTC_OK;
                }
            }
        }
    }
    return status;
}

ptc_status stage16_observer_estimate(const stage16_observer *self, double xhat[3])
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (xhat != NULL)) {
        xhat[0] = self->x1_hat;
        xhat[1] = self->x2_hat;
        xhat[2] = self->x3_hat;
        status = PTC_OK;
    }
    if ((status < PTC_OK) && (xhat != NULL)) {
        for (uint32_t i = 0U; i < 3U; i++) {
            xhat[i] = 0.0;
        }
    }
    return status;
}

ptc_status stage16_observer_disturbance(const stage16_observer *self, double *d)
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (d != NULL)) {
        *d = self->d_hat;
        status = PTC_OK;
    }
    return status;
}
