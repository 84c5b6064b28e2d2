/* Prescribed-time controller ptc_exp12_axes2: see ptc_exp12_axes2.h. DO NOT EDIT. */
#include "ptc_exp12_axes2.h"

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

ptc_status ptc_exp12_axes2_init(ptc_exp12_axes2 *self, const ptc_exp12_axes2_params *params)
{
    ptc_status status = PTC_E_PARAM;
    struct ptc_exp12_axes2 built;

    if ((self != NULL) && (params != NULL)) {
        const double tau = params->tau;
        const double t0 = params->t0;
        const double eps = params->eps;
        const double u_max = params->u_max;
        const double a = params->a;
        const double k1 = params->k[0];
        const double k2 = params->k[1];
        const double k3 = params->k[2];
        const double k4 = params->k[3];
        const double k5 = params->k[4];
        const double k6 = params->k[5];
        const double k7 = params->k[6];
        const double k8 = params->k[7];
        const double k9 = params->k[8];
        const double k10 = params->k[9];
        const double k11 = params->k[10];
        const double k12 = params->k[11];
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
            && PTC_FINITE_F64(k2)
            && PTC_FINITE_F64(k3)
            && PTC_FINITE_F64(k4)
            && PTC_FINITE_F64(k5)
            && PTC_FINITE_F64(k6)
            && PTC_FINITE_F64(k7)
            && PTC_FINITE_F64(k8)
            && PTC_FINITE_F64(k9)
            && PTC_FINITE_F64(k10)
            && PTC_FINITE_F64(k11)
            && PTC_FINITE_F64(k12)
            && (eps < tau)) {
            const double v1 = a * a;
            const double v2 = v1 * v1;
            const double v3 = v2 * v2;
            const double v4 = v2 * v3;
            const double K1 = k1 / v4;
            const double v5 = a * v1;
            const double v6 = v5 * v3;
            const double K2 = k2 / v6;
            const double v7 = v1 * v3;
            const double K3 = k3 / v7;
            const double v8 = a * v3;
            const double K4 = k4 / v8;
            const double K5 = k5 / v3;
            const double v9 = v5 * v2;
            const double K6 = k6 / v9;
            const double v10 = v1 * v2;
            const double K7 = k7 / v10;
            const double v11 = a * v2;
            const double K8 = k8 / v11;
            const double K9 = k9 / v2;
            const double K10 = k10 / v5;
            const double K11 = k11 / v1;
            const double K12 = k12 / a;
            const double c1 = -K1;
            const double s1 = ((((((((((-K2) + K3) - K4) + K5) - K6) + K7) - K8) + K9) - K10) + K11) - K12;
            const double c2 = s1 + 1.0;
            const double s2 = ((((-K3) + (3.0 * K4)) - (7.0 * K5)) + (15.0 * K6)) - (31.0 * K7);
            const double s3 = (((s2 + (63.0 * K8)) - (127.0 * K9)) + (255.0 * K10)) - (511.0 * K11);
            const double c3 = (s3 + (1023.0 * K12)) - 2047.0;
            const double s4 = ((((-K4) + (6.0 * K5)) - (25.0 * K6)) + (90.0 * K7)) - (301.0 * K8);
            const double s5 = ((s4 + (966.0 * K9)) - (3025.0 * K10)) + (9330.0 * K11);
            const double c4 = (s5 - (28501.0 * K12)) + 86526.0;
            const double s6 = ((((-K5) + (10.0 * K6)) - (65.0 * K7)) + (350.0 * K8)) - (1701.0 * K9);
            const double s7 = ((s6 + (7770.0 * K10)) - (34105.0 * K11)) + (145750.0 * K12);
            const double c5 = s7 - 611501.0;
            const double s8 = (((-K6) + (15.0 * K7)) - (140.0 * K8)) + (1050.0 * K9);
            const double s9 = ((s8 - (6951.0 * K10)) + (42525.0 * K11)) - (246730.0 * K12);
            const double c6 = s9 + 1379400.0;
            const double s10 = (((-K7) + (21.0 * K8)) - (266.0 * K9)) + (2646.0 * K10);
            const double c7 = ((s10 - (22827.0 * K11)) + (179487.0 * K12)) - 1323652.0;
            const double s11 = (((-K8) + (28.0 * K9)) - (462.0 * K10)) + (5880.0 * K11);
            const double c8 = (s11 - (63987.0 * K12)) + 627396.0;
            const double s12 = (((-K9) + (36.0 * K10)) - (750.0 * K11)) + (11880.0 * K12);
            const double c9 = s12 - 159027.0;
            const double c10 = (((-K10) + (45.0 * K11)) - (1155.0 * K12)) + 22275.0;
            const double c11 = ((-K11) + (55.0 * K12)) - 1705.0;
            const double c12 = (-K12) + 66.0;
            const double hold_from = -eps;
            const double size_K1 = (fabs(k1) <= 0.0) ? 1e-200 : fabs(K1);
            const double size_K2 = (fabs(k2) <= 0.0) ? 1e-200 : fabs(K2);
            const double size_K3 = (fabs(k3) <= 0.0) ? 1e-200 : fabs(K3);
            const double size_K4 = (fabs(k4) <= 0.0) ? 1e-200 : fabs(K4);
            const double size_K5 = (fabs(k5) <= 0.0) ? 1e-200 : fabs(K5);
            const double size_K6 = (fabs(k6) <= 0.0) ? 1e-200 : fabs(K6);
            const double size_K7 = (fabs(k7) <= 0.0) ? 1e-200 : fabs(K7);
            const double size_K8 = (fabs(k8) <= 0.0) ? 1e-200 : fabs(K8);
            const double size_K9 = (fabs(k9) <= 0.0) ? 1e-200 : fabs(K9);
            const double size_K10 = (fabs(k10) <= 0.0) ? 1e-200 : fabs(K10);
            const double size_K11 = (fabs(k11) <= 0.0) ? 1e-200 : fabs(K11);
            const double size_K12 = (fabs(k12) <= 0.0) ? 1e-200 : fabs(K12);
            if ((v2 >= 1e-200)
                && (v3 >= 1e-200)
                && (v4 >= 1e-200)
                && (size_K1 >= 1e-200)
                && (v5 >= 1e-200)
                && (v6 >= 1e-200)
                && (size_K2 >= 1e-200)
                && (v7 >= 1e-200)
                && (size_K3 >= 1e-200)
                && (v8 >= 1e-200)
                && (size_K4 >= 1e-200)
                && (size_K5 >= 1e-200)
                && (v9 >= 1e-200)
                && (size_K6 >= 1e-200)
                && (v10 >= 1e-200)
                && (size_K7 >= 1e-200)
                && (v11 >= 1e-200)
                && (size_K8 >= 1e-200)
                && (size_K9 >= 1e-200)
                && (size_K10 >= 1e-200)
                && (size_K11 >= 1e-200)
                && (size_K12 >= 1e-200)
                && PTC_FINITE_F64(c1)
                && PTC_FINITE_F64(c2)
                && PTC_FINITE_F64(c3)
                && PTC_FINITE_F64(c4)
                && PTC_FINITE_F64(c5)
                && PTC_FINITE_F64(c6)
                && PTC_FINITE_F64(c7)
                && PTC_FINITE_F64(c8)
                && PTC_FINITE_F64(c9)
                && PTC_FINITE_F64(c10)
                && PTC_FINITE_F64(c11)
                && PTC_FINITE_F64(c12)
                && PTC_FINITE_F64(hold_from)) {
                built.c1 = c1;
                built.c2 = c2;
                built.c3 = c3;
                built.c4 = c4;
                built.c5 = c5;
                built.c6 = c6;
                built.c7 = c7;
                built.c8 = c8;
                built.c9 = c9;
                built.c10 = c10;
                built.c11 = c11;
                built.c12 = c12;
                built.tau = tau;
                built.eps = eps;
                built.hold_from = hold_from;
                built.u_max = u_max;
                built.t0 = 0.0;
                built.deadline = 0.0;
                built.correction = 0.0;
                status = ptc_exp12_axes2_arm(&built, t0);
                if (status == PTC_OK) {
                    *self = built;
                }
            }
        }
    }
    return status;
}

ptc_status ptc_exp12_axes2_arm(ptc_exp12_axes2 *self, double t0)
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

ptc_status ptc_exp12_axes2_tick(
    const ptc_exp12_axes2 *self,
    double t,
    ptc_exp12_axes2_gains *gains)
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (gains != NULL)) {
        if (PTC_FINITE_F64(t) && (t >= self->t0)) {
            const double past = (t - self->deadline) - self->correction;
            const double late = (past < self->hold_from) ? past : self->hold_from;
            const double inv_T = (-1.0) / late;
            const double v1 = inv_T * inv_T;
            const double v2 = v1 * inv_T;
            const double v3 = v2 * inv_T;
            const double v4 = v3 * inv_T;
            const double v5 = v4 * inv_T;
            gains->gain[0] = self->c1 * v5 * v5;
            gains->gain[1] = self->c2 * v5 * v4;
            gains->gain[2] = self->c3 * v4 * v4;
            gains->gain[3] = self->c4 * v4 * v3;
            gains->gain[4] = self->c5 * v3 * v3;
            gains->gain[5] = self->c6 * v3 * v2;
            gains->gain[6] = self->c7 * v2 * v2;
            gains->gain[7] = self->c8 * v2 * v1;
            gains->gain[8] = self->c9 * v1 * v1;
            gains->gain[9] = self->c10 * v1 * inv_T;
            gains->gain[10] = self->c11 * inv_T * inv_T;
            gains->gain[11] = self->c12 * inv_T;
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

ptc_status ptc_exp12_axes2_axis(const ptc_exp12_axes2_gains *gains, const double x[12], double *u)
{
    ptc_status status = PTC_E_INPUT;

    if (u != NULL) {
        *u = 0.0;
    }
    if ((gains != NULL) && (x != NULL) && (u != NULL)) {
        const double s1 = (gains->gain[0] * x[0]) + (gains->gain[4] * x[4]);
        const double s2 = (gains->gain[2] * x[2]) + (gains->gain[6] * x[6]);
        const double s3 = (gains->gain[1] * x[1]) + (gains->gain[5] * x[5]);
        const double s4 = (gains->gain[3] * x[3]) + (gains->gain[7] * x[7]);
        const double s5 = s1 + (gains->gain[8] * x[8]) + (s2 + (gains->gain[10] * x[10]));
        const double v = s5 + (s3 + (gains->gain[9] * x[9]) + (s4 + (gains->gain[11] * x[11])));
        *u = v;
        if (PTC_FINITE_F64(v) && (fabs(v) <= gains->u_max)) {
            status = gains->status;
        } else if (PTC_FINITE_F64(x[0])
            && PTC_FINITE_F64(x[1])
            && PTC_FINITE_F64(x[2])
            && PTC_FINITE_F64(x[3])
            && PTC_FINITE_F64(x[4])
            && PTC_FINITE_F64(x[5])
            && PTC_FINITE_F64(x[6])
            && PTC_FINITE_F64(x[7])
            && PTC_FINITE_F64(x[8])
            && PTC_FINITE_F64(x[9])
            && PTC_FINITE_F64(x[10])
            && PTC_FINITE_F64(x[11])) {
            if (PTC_FINITE_F64(v)) {
                if (v > gains->u_max) {
                    *u = gains->u_max;
                    status = PTC_SATURATED;
                } else {
                    *u = -gains->u_max;
                    status = PTC_SATURATED;
                }
            } else {
                *u = 0.0;
                status = PTC_E_RANGE;
            }
        } else {
            *u = 0.0;
            status = PTC_E_INPUT;
        }
    }
    return status;
}

ptc_status ptc_exp12_axes2_step(
    const ptc_exp12_axes2 *self,
    double t,
    const double x[2][12],
    double u[2],
    ptc_status axes[2])
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (x != NULL) && (u != NULL) && (axes != NULL)) {
        if (PTC_FINITE_F64(t) && (t >= self->t0)) {
            const double past = (t - self->deadline) - self->correction;
            const double late = (past < self->hold_from) ? past : self->hold_from;
            const double inv_T = (-1.0) / late;
            const double v1 = inv_T * inv_T;
            const double v2 = v1 * inv_T;
            const double v3 = v2 * inv_T;
            const double v4 = v3 * inv_T;
            const double v5 = v4 * inv_T;
            double gain[12];
            gain[0] = self->c1 * v5 * v5;
            gain[1] = self->c2 * v5 * v4;
            gain[2] = self->c3 * v4 * v4;
            gain[3] = self->c4 * v4 * v3;
            gain[4] = self->c5 * v3 * v3;
            gain[5] = self->c6 * v3 * v2;
            gain[6] = self->c7 * v2 * v2;
            gain[7] = self->c8 * v2 * v1;
            gain[8] = self->c9 * v1 * v1;
            gain[9] = self->c10 * v1 * inv_T;
            gain[10] = self->c11 * inv_T * inv_T;
            gain[11] = self->c12 * inv_T;
            if (late < self->hold_from) {
                status = PTC_OK;
            } else {
                status = PTC_HOLD;
            }
            double part[8];
            for (uint32_t axis = 0U; axis < 2U; axis++) {
                const double s1 = (gain[0] * x[axis][0]) + (gain[4] * x[axis][4]);
                part[4U * axis] = s1 + (gain[8] * x[axis][8]);
                const double s2 = (gain[1] * x[axis][1]) + (gain[5] * x[axis][5]);
                part[(4U * axis) + 1U] = s2 + (gain[9] * x[axis][9]);
                const double s3 = (gain[2] * x[axis][2]) + (gain[6] * x[axis][6]);
                part[(4U * axis) + 2U] = s3 + (gain[10] * x[axis][10]);
                const double s4 = (gain[3] * x[axis][3]) + (gain[7] * x[axis][7]);
                part[(4U * axis) + 3U] = s4 + (gain[11] * x[axis][11]);
            }
            double half[4];
            for (uint32_t axis = 0U; axis < 2U; axis++) {
                half[2U * axis] = part[4U * axis] + part[(4U * axis) + 2U];
                half[(2U * axis) + 1U] = part[(4U * axis) + 1U] + part[(4U * axis) + 3U];
            }
            double wanted[2];
            for (uint32_t axis = 0U; axis < 2U; axis++) {
                wanted[axis] = half[2U * axis] + half[(2U * axis) + 1U];
            }
            const double bound = (self->u_max < 1.7976931348623157e308) ? self->u_max : 1.7976931348623157e308;
            u[0] = wanted[0];
            u[1] = wanted[1];
            for (uint32_t axis = 0U; axis < 2U; axis++) {
                axes[axis] = status;
            }
            uint32_t outside = 0U;
            for (uint32_t axis = 0U; axis < 2U; axis++) {
                const double v = wanted[axis];
                if (!(fabs(v) <= bound)) {
                    outside = 1U;
                    break;
                }
            }
            if (outside == 1U) {
                for (uint32_t axis = 0U; axis < 2U; axis++) {
                    const double v = wanted[axis];
                    if (!(fabs(v) <= bound)) {
                        if (PTC_FINITE_F64(x[axis][0])
                            && PTC_FINITE_F64(x[axis][1])
                            && PTC_FINITE_F64(x[axis][2])
                            && PTC_FINITE_F64(x[axis][3])
                            && PTC_FINITE_F64(x[axis][4])
                            && PTC_FINITE_F64(x[axis][5])
                            && PTC_FINITE_F64(x[axis][6])
                            && PTC_FINITE_F64(x[axis][7])
                            && PTC_FINITE_F64(x[axis][8])
                            && PTC_FINITE_F64(x[axis][9])
                            && PTC_FINITE_F64(x[axis][10])
                            && PTC_FINITE_F64(x[axis][11])) {
                            if (PTC_FINITE_F64(v)) {
                                if (v > self->u_max) {
                                    u[axis] = self->u_max;
                                    axes[axis] = PTC_SATURATED;
                                } else {
                                    u[axis] = -self->u_max;
                                    axes[axis] = PTC_SATURATED;
                                }
                            } else {
                                axes[axis] = PTC_E_RANGE;
                            }
                        } else {
                            axes[axis] = PTC_E_INPUT;
                        }
                        if (status >= PTC_OK) {
                            status = axes[axis];
                        }
                    }
                }
                if (status < PTC_OK) {
                    for (uint32_t axis = 0U; axis < 2U; axis++) {
                        u[axis] = 0.0;
                    }
                }
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
        if (axes != NULL) {
            for (uint32_t i = 0U; i < 2U; i++) {
                axes[i] = PTC_E_INPUT;
            }
        }
    }
    return status;
}
