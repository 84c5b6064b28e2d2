/* Prescribed-time controller duration: see duration.h. DO NOT EDIT. */
#include "duration.h"

#include <float.h>
#include <math.h>
#include <stddef.h>

/* What this file requires of its compiler. */
#if (defined(FLT_MANT_DIG) && (FLT_MANT_DIG != 24))
#error "float is not IEEE 754 binary32 here"
#endif
#if defined(FLT_EVAL_METHOD) && !defined(PTC_ALLOW_EXCESS_PRECISION)
#if (FLT_EVAL_METHOD > 0) && (FLT_EVAL_METHOD < 3)
#error "float is computed with more digits than it has: on x86 compile with -msse2 -mfpmath=sse, or define PTC_ALLOW_EXCESS_PRECISION"
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

#if !defined(PTC_FINITE_F32)
#if defined(isfinite) && !defined(__MINGW32__)
#define PTC_FINITE_F32(x) (isfinite(x) != 0)
#else
#define PTC_FINITE_F32(x) (fabsf(x) <= FLT_MAX)
#endif
#endif

ptc_status duration_init(duration *self, const duration_params *params)
{
    ptc_status status = PTC_E_PARAM;
    struct duration built;

    if ((self != NULL) && (params != NULL)) {
        const float tau = params->tau;
        const float t0 = params->t0;
        const float eps = params->eps;
        const float a = params->a;
        if (PTC_FINITE_F32(tau)
            && (1e-18f <= tau)
            && (tau <= 1e18f)
            && PTC_FINITE_F32(t0)
            && (eps >= 1e-18f)
            && PTC_FINITE_F32(a)
            && (1e-18f <= a)
            && (a <= 1e18f)
            && (eps < tau)) {
            const float v1 = a * a;
            const float v2 = a * v1;
            const float K1 = 120.0f / v2;
            const float K2 = 74.0f / v1;
            const float K3 = 15.0f / a;
            const float c1_3 = -K1;
            const float hold_from = -eps;
            const float c2_2 = (-(2.0f * K2)) - 6.0f;
            const float f69 = (-(2.467401f * K2)) + 4.934802f;
            const float f73 = 3.1415927f * K3;
            const float f81 = 1.2732395f * K3;
            const float f85 = -(0.40528473f * K2);
            const float f99 = -(1.5707964f * K3);
            const float f103 = -(0.63661975f * K3);
            if ((v2 >= 1e-30f)
                && (K1 >= 1e-30f)
                && PTC_FINITE_F32(c1_3)
                && PTC_FINITE_F32(hold_from)
                && PTC_FINITE_F32(f69)
                && PTC_FINITE_F32(f73)
                && PTC_FINITE_F32(c2_2)
                && PTC_FINITE_F32(f81)
                && PTC_FINITE_F32(f85)
                && PTC_FINITE_F32(f99)
                && PTC_FINITE_F32(f103)) {
                built.c1_3 = c1_3;
                built.eps = eps;
                built.hold_from = hold_from;
                built.f69 = f69;
                built.f73 = f73;
                built.c2_2 = c2_2;
                built.f81 = f81;
                built.f85 = f85;
                built.f99 = f99;
                built.f103 = f103;
                built.tau = 0.0f;
                built.angle_rate = 0.0f;
                built.inv_angle_rate = 0.0f;
                built.t0 = 0.0f;
                built.deadline = 0.0f;
                built.correction = 0.0f;
                built.inv_tau = 0.0f;
                built.c2_0 = 0.0f;
                built.c2_1 = 0.0f;
                built.c2_3 = 0.0f;
                built.c2_4 = 0.0f;
                built.c3_0 = 0.0f;
                built.c3_2 = 0.0f;
                status = duration_arm_for(&built, t0, tau);
                if (status == PTC_OK) {
                    *self = built;
                }
            }
        }
    }
    return status;
}

ptc_status duration_arm(duration *self, float t0)
{
    ptc_status status = PTC_E_PARAM;

    if (self != NULL) {
        if (PTC_FINITE_F32(t0)) {
            const float deadline = t0 + self->tau;
            const float v1 = deadline - t0;
            const float correction = (t0 - (deadline - v1)) + (self->tau - v1);
            if (PTC_FINITE_F32(deadline)) {
                self->t0 = t0;
                self->deadline = deadline;
                self->correction = correction;
                status = PTC_OK;
            }
        }
    }
    return status;
}

ptc_status duration_arm_for(duration *self, float t0, float tau)
{
    ptc_status status = PTC_E_PARAM;

    if (self != NULL) {
        if (PTC_FINITE_F32(t0)
            && PTC_FINITE_F32(tau)
            && (1e-18f <= tau)
            && (tau <= 1e18f)
            && (tau > self->eps)) {
            const float angle_rate = 1.5707964f / tau;
            const float inv_angle_rate = 0.63661975f * tau;
            const float deadline = t0 + tau;
            const float v1 = deadline - t0;
            const float correction = (t0 - (deadline - v1)) + (tau - v1);
            const float inv_tau = 1.0f / tau;
            const float v2 = tau * tau;
            const float c2_0 = self->f69 / v2;
            const float c2_1 = self->f73 / tau;
            const float c2_3 = self->f81 * tau;
            const float c2_4 = self->f85 * v2;
            const float c3_0 = self->f99 / tau;
            const float c3_2 = self->f103 * tau;
            if (PTC_FINITE_F32(deadline)
                && (c2_4 <= -1e-30f)
                && PTC_FINITE_F32(angle_rate)
                && PTC_FINITE_F32(inv_angle_rate)
                && PTC_FINITE_F32(inv_tau)
                && PTC_FINITE_F32(c2_0)
                && PTC_FINITE_F32(c2_1)
                && PTC_FINITE_F32(c2_3)
                && PTC_FINITE_F32(c2_4)
                && PTC_FINITE_F32(c3_0)
                && PTC_FINITE_F32(c3_2)) {
                self->tau = tau;
                self->angle_rate = angle_rate;
                self->inv_angle_rate = inv_angle_rate;
                self->t0 = t0;
                self->deadline = deadline;
                self->correction = correction;
                self->inv_tau = inv_tau;
                self->c2_0 = c2_0;
                self->c2_1 = c2_1;
                self->c2_3 = c2_3;
                self->c2_4 = c2_4;
                self->c3_0 = c3_0;
                self->c3_2 = c3_2;
                status = PTC_OK;
            }
        }
    }
    return status;
}

ptc_status duration_step(const duration *self, float t, const float x[3], float *u)
{
    ptc_status status = PTC_E_INPUT;

    if (u != NULL) {
        *u = 0.0f;
    }
    if ((self != NULL) && (x != NULL) && (u != NULL)) {
        if (t >= self->t0) {
            const float past = (t - self->deadline) - self->correction;
            const float late = (past < self->hold_from) ? past : self->hold_from;
            const float v1 = late * self->inv_tau;
            const float inv_T_squared = 1.0f / (late * late);
            const float v2 = v1 * v1;
            const float s1 = (((((-9.25448e-5f) * v2) - 7.2446054e-9f) * v2) - 0.0006016576f) * v2;
            const float s2 = ((((s1 - 0.0018990984f) * v2) - 0.007859069f) * v2) - 0.031790096f;
            const float th_cot_th = (((((s2 * v2) - 0.13529049f) * v2) - 0.822467f) * v2) + 1.0f;
            const float cot_rate_squared = inv_T_squared * (th_cot_th * th_cot_th);
            const float slope = self->angle_rate + (self->inv_angle_rate * cot_rate_squared);
            const float row1 = self->c1_3 * slope * slope * slope;
            const float T = -late;
            const float cot_rate = T * inv_T_squared * th_cot_th;
            const float s3 = (self->c2_4 * cot_rate_squared) + self->c2_2;
            const float s4 = ((self->c2_3 * cot_rate_squared) + self->c2_1) * cot_rate;
            const float row2 = (s3 * cot_rate_squared) + self->c2_0 + s4;
            const float row3 = (self->c3_2 * cot_rate_squared) + self->c3_0 + (6.0f * cot_rate);
            const float v = (row1 * x[0]) + (row2 * x[1]) + (row3 * x[2]);
            *u = v;
            if (PTC_FINITE_F32(v) && (fabsf(v) <= 100.0f) && (late < self->hold_from)) {
                status = PTC_OK;
            } else if (PTC_FINITE_F32(t)
                && PTC_FINITE_F32(x[0])
                && PTC_FINITE_F32(x[1])
                && PTC_FINITE_F32(x[2])) {
                if (PTC_FINITE_F32(v)) {
                    if (v > 100.0f) {
                        *u = 100.0f;
                        status = PTC_SATURATED;
                    } else if (v < -100.0f) {
                        *u = -100.0f;
                        status = PTC_SATURATED;
                    } else {
                        status = PTC_HOLD;
                    }
                } else {
                    *u = 0.0f;
                    status = PTC_E_RANGE;
                }
            } else {
                *u = 0.0f;
                status = PTC_E_INPUT;
            }
        }
    }
    return status;
}

ptc_status duration_tick(const duration *self, float t, duration_gains *gains)
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (gains != NULL)) {
        if (PTC_FINITE_F32(t) && (t >= self->t0)) {
            const float past = (t - self->deadline) - self->correction;
            const float late = (past < self->hold_from) ? past : self->hold_from;
            const float v1 = late * self->inv_tau;
            const float inv_T_squared = 1.0f / (late * late);
            const float v2 = v1 * v1;
            const float s1 = (((((-9.25448e-5f) * v2) - 7.2446054e-9f) * v2) - 0.0006016576f) * v2;
            const float s2 = ((((s1 - 0.0018990984f) * v2) - 0.007859069f) * v2) - 0.031790096f;
            const float th_cot_th = (((((s2 * v2) - 0.13529049f) * v2) - 0.822467f) * v2) + 1.0f;
            const float cot_rate_squared = inv_T_squared * (th_cot_th * th_cot_th);
            const float slope = self->angle_rate + (self->inv_angle_rate * cot_rate_squared);
            const float row1 = self->c1_3 * slope * slope * slope;
            const float T = -late;
            const float cot_rate = T * inv_T_squared * th_cot_th;
            const float s3 = (self->c2_4 * cot_rate_squared) + self->c2_2;
            const float s4 = ((self->c2_3 * cot_rate_squared) + self->c2_1) * cot_rate;
            const float row2 = (s3 * cot_rate_squared) + self->c2_0 + s4;
            const float row3 = (self->c3_2 * cot_rate_squared) + self->c3_0 + (6.0f * cot_rate);
            gains->gain[0] = row1;
            gains->gain[1] = row2;
            gains->gain[2] = row3;
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

ptc_status duration_axis(const duration_gains *gains, const float x[3], float *u)
{
    ptc_status status = PTC_E_INPUT;

    if (u != NULL) {
        *u = 0.0f;
    }
    if ((gains != NULL) && (x != NULL) && (u != NULL)) {
        const float s1 = (gains->gain[0] * x[0]) + (gains->gain[1] * x[1]);
        const float v = s1 + (gains->gain[2] * x[2]);
        *u = v;
        if (PTC_FINITE_F32(v) && (fabsf(v) <= 100.0f)) {
            status = gains->status;
        } else if (PTC_FINITE_F32(x[0]) && PTC_FINITE_F32(x[1]) && PTC_FINITE_F32(x[2])) {
            if (PTC_FINITE_F32(v)) {
                if (v > 100.0f) {
                    *u = 100.0f;
                    status = PTC_SATURATED;
                } else {
                    *u = -100.0f;
                    status = PTC_SATURATED;
                }
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
