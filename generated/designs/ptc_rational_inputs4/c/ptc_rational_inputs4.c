/* Prescribed-time controller ptc_rational_inputs4: see ptc_rational_inputs4.h. DO NOT EDIT. */
#include "ptc_rational_inputs4.h"

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

ptc_status ptc_rational_inputs4_init(
    ptc_rational_inputs4 *self,
    const ptc_rational_inputs4_params *params)
{
    ptc_status status = PTC_E_PARAM;
    struct ptc_rational_inputs4 built;

    if ((self != NULL) && (params != NULL)) {
        const double tau = params->tau;
        const double t0 = params->t0;
        const double eps = params->eps;
        const double u_max = params->u_max;
        const double a = params->a;
        const double k1 = params->k[0];
        const double p_m = params->m;
        if (PTC_FINITE_F64(tau)
            && (1e-150 <= tau)
            && (tau <= 1e150)
            && PTC_FINITE_F64(t0)
            && (eps >= 1e-150)
            && (u_max > 0.0)
            && PTC_FINITE_F64(a)
            && (1e-150 <= a)
            && (a <= 1e150)
            && PTC_FINITE_F64(k1)
            && PTC_FINITE_F64(p_m)
            && (eps < tau)) {
            const double rate_axis1 = a / tau;
            const double K1_axis1 = k1 / rate_axis1;
            const double c1_axis1 = -K1_axis1;
            const double hold_from = -eps;
            const double size_K1_axis1 = (fabs(k1) <= 0.0) ? 1e-200 : fabs(K1_axis1);
            const double size_p_m = (fabs(p_m) <= 0.0) ? 1e-200 : fabs(p_m);
            if ((size_K1_axis1 >= 1e-200)
                && (size_p_m >= 1e-200)
                && PTC_FINITE_F64(c1_axis1)
                && PTC_FINITE_F64(hold_from)) {
                built.tau = tau;
                built.c1_axis1 = c1_axis1;
                built.eps = eps;
                built.hold_from = hold_from;
                built.p_m = p_m;
                built.u_max = u_max;
                built.t0 = 0.0;
                built.deadline = 0.0;
                built.correction = 0.0;
                status = ptc_rational_inputs4_arm(&built, t0);
                if (status == PTC_OK) {
                    *self = built;
                }
            }
        }
    }
    return status;
}

/*
 * Solves a x = b, with a row by row, by elimination with the largest pivot of each column: b
 * becomes x, NaN where a is singular.
 */
static void ptc_rational_inputs4_eliminate(double b[4], double a[16])
{
    for (uint32_t k = 0U; k < 4U; k++) {
        uint32_t most = k;
        double largest = fabs(a[(4U * k) + k]);
        for (uint32_t i = k + 1U; i < 4U; i++) {
            const double size = fabs(a[(4U * i) + k]);
            if (largest < size) {
                largest = size;
                most = i;
            }
        }
        for (uint32_t i = k + 1U; i < 4U; i++) {
            if (most == i) {
                const double kept = b[k];
                b[k] = b[i];
                b[i] = kept;
                for (uint32_t j = k; j < 4U; j++) {
                    const double entry = a[(4U * k) + j];
                    a[(4U * k) + j] = a[(4U * i) + j];
                    a[(4U * i) + j] = entry;
                }
            }
        }
        a[(4U * k) + k] = ((a[(4U * k) + k] < 0.0) || (a[(4U * k) + k] > 0.0)) ? (a[(4U * k) + k]) : (double)NAN;
        for (uint32_t i = k + 1U; i < 4U; i++) {
            const double factor = a[(4U * i) + k] / a[(4U * k) + k];
            for (uint32_t j = k + 1U; j < 4U; j++) {
                a[(4U * i) + j] = a[(4U * i) + j] - (factor * a[(4U * k) + j]);
            }
            b[i] = b[i] - (factor * b[k]);
        }
    }
    for (uint32_t left = 4U; left > 0U; left--) {
        const uint32_t k = left - 1U;
        for (uint32_t j = k + 1U; j < 4U; j++) {
            b[k] = b[k] - (a[(4U * k) + j] * b[j]);
        }
        b[k] = b[k] / a[(4U * k) + k];
    }
}

ptc_status ptc_rational_inputs4_arm(ptc_rational_inputs4 *self, double t0)
{
    ptc_status status = PTC_E_PARAM;

    if (self != NULL) {
        if (PTC_FINITE_F64(t0)) {
            const double deadline = t0 + self->tau;
            const double v1 = deadline - t0;
            const double correction = (t0 - (deadline - v1)) + (self->tau - v1);
            if (PTC_FINITE_F64(deadline)) {
                self->t0 = t0;
                self->deadline = deadline;
                self->correction = correction;
                status = PTC_OK;
            }
        }
    }
    return status;
}

ptc_status ptc_rational_inputs4_step(
    const ptc_rational_inputs4 *self,
    double t,
    const double x[4],
    double u[4],
    ptc_status axes[4])
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (x != NULL) && (u != NULL) && (axes != NULL)) {
        const double x1 = x[0];
        const double x2 = x[1];
        const double x3 = x[2];
        const double x4 = x[3];
        if (PTC_FINITE_F64(t)
            && (t >= self->t0)
            && PTC_FINITE_F64(x1)
            && PTC_FINITE_F64(x2)
            && PTC_FINITE_F64(x3)
            && PTC_FINITE_F64(x4)) {
            const double past = (t - self->deadline) - self->correction;
            const double late = (past < self->hold_from) ? past : self->hold_from;
            const double v1 = late * late;
            const double wanted_axis1 = (self->c1_axis1 * x1) / v1;
            const double drift_axis2 = x1 * x3;
            const double wanted_axis2 = ((self->c1_axis1 * x2) / v1) - drift_axis2;
            const double wanted_axis3 = (self->c1_axis1 * x3) / v1;
            const double wanted_axis4 = (self->c1_axis1 * x4) / v1;
            double inputs[4] = {wanted_axis1, wanted_axis2, wanted_axis3, wanted_axis4};
            double inputs_a[16] = {
                0.0,
                sin(x2),
                3.0,
                x3,
                2.0,
                x1,
                0.0,
                self->p_m,
                x3,
                3.0 + (x2 * x2),
                x4,
                0.0,
                1.0,
                0.0,
                -x1,
                4.0,
            };
            ptc_rational_inputs4_eliminate(inputs, inputs_a);
            const double control1 = inputs[0];
            const double control2 = inputs[1];
            const double control3 = inputs[2];
            const double control4 = inputs[3];
            if (late < self->hold_from) {
                status = PTC_OK;
            } else {
                status = PTC_HOLD;
            }
            if (PTC_FINITE_F64(control1)
                && PTC_FINITE_F64(control2)
                && PTC_FINITE_F64(control3)
                && PTC_FINITE_F64(control4)) {
                u[0] = control1;
                axes[0] = status;
                u[1] = control2;
                axes[1] = status;
                u[2] = control3;
                axes[2] = status;
                u[3] = control4;
                axes[3] = status;
                if (control1 > self->u_max) {
                    u[0] = self->u_max;
                    axes[0] = PTC_SATURATED;
                    status = PTC_SATURATED;
                } else if (control1 < -self->u_max) {
                    u[0] = -self->u_max;
                    axes[0] = PTC_SATURATED;
                    status = PTC_SATURATED;
                } else {
                    /* neither */
                }
                if (control2 > self->u_max) {
                    u[1] = self->u_max;
                    axes[1] = PTC_SATURATED;
                    status = PTC_SATURATED;
                } else if (control2 < -self->u_max) {
                    u[1] = -self->u_max;
                    axes[1] = PTC_SATURATED;
                    status = PTC_SATURATED;
                } else {
                    /* neither */
                }
                if (control3 > self->u_max) {
                    u[2] = self->u_max;
                    axes[2] = PTC_SATURATED;
                    status = PTC_SATURATED;
                } else if (control3 < -self->u_max) {
                    u[2] = -self->u_max;
                    axes[2] = PTC_SATURATED;
                    status = PTC_SATURATED;
                } else {
                    /* neither */
                }
                if (control4 > self->u_max) {
                    u[3] = self->u_max;
                    axes[3] = PTC_SATURATED;
                    status = PTC_SATURATED;
                } else if (control4 < -self->u_max) {
                    u[3] = -self->u_max;
                    axes[3] = PTC_SATURATED;
                    status = PTC_SATURATED;
                } else {
                    /* neither */
                }
            } else {
                u[0] = 0.0;
                if (PTC_FINITE_F64(control1)) {
                    axes[0] = status;
                } else {
                    axes[0] = PTC_E_RANGE;
                }
                u[1] = 0.0;
                if (PTC_FINITE_F64(control2)) {
                    axes[1] = status;
                } else {
                    axes[1] = PTC_E_RANGE;
                }
                u[2] = 0.0;
                if (PTC_FINITE_F64(control3)) {
                    axes[2] = status;
                } else {
                    axes[2] = PTC_E_RANGE;
                }
                u[3] = 0.0;
                if (PTC_FINITE_F64(control4)) {
                    axes[3] = status;
                } else {
                    axes[3] = PTC_E_RANGE;
                }
                status = PTC_E_RANGE;
            }
        } else {
            for (uint32_t i = 0U; i < 4U; i++) {
                u[i] = 0.0;
                axes[i] = PTC_E_INPUT;
            }
        }
    } else {
        if (u != NULL) {
            for (uint32_t i = 0U; i < 4U; i++) {
                u[i] = 0.0;
            }
        }
        if (axes != NULL) {
            for (uint32_t i = 0U; i < 4U; i++) {
                axes[i] = PTC_E_INPUT;
            }
        }
    }
    return status;
}
