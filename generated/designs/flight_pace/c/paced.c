/* Prescribed-time controller paced: see paced.h. DO NOT EDIT. */
#include "paced.h"

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
#define PACED_S1_1 10000.0 /* weight of x1 in the law */
#define PACED_S1_2 (-50.0) /* weight of x2 in the law */
#define PACED_S2_2 100.0 /* weight of x2 in the law */
#define PACED_W1_1 (-1200000.0) /* weight of x1 in the law */
#define PACED_W1_2 6000.0 /* weight of x2 in the law */
#define PACED_W2_2 (-6000.0) /* weight of x2 in the law */
#define PACED_W3_3 (-12.0) /* weight of u1 in the law */

ptc_status paced_init(paced *self, const paced_params *params)
{
    ptc_status status = PTC_E_PARAM;

    if ((self != NULL) && (params != NULL)) {
        if ((params->u_max > -1.0) && (params->u_max >= 0.0)) {
            const double u_max = params->u_max;
            self->start = 0U;
            self->last = 100U;
            self->u1 = 0.0;
            self->u_max = u_max;
            status = PTC_OK;
        }
    }
    return status;
}

ptc_status paced_arm(paced *self, uint32_t k)
{
    ptc_status status = PTC_E_INPUT;

    if (self != NULL) {
        self->start = k;
        self->last = 100U;
        status = PTC_OK;
    }
    return status;
}

ptc_status paced_step(paced *self, uint32_t k, const double x[2], double *u)
{
    ptc_status status = PTC_E_INPUT;

    if (u != NULL) {
        *u = 0.0;
    }
    if ((self != NULL) && (x != NULL) && (u != NULL)) {
        if (PTC_FINITE_F64(x[0]) && PTC_FINITE_F64(x[1])) {
            const uint32_t elapsed = k - self->start;
            const double x1 = x[0];
            const double x2 = x[1];

            /* The deadline that keeps the limits. */
            uint32_t last_now = self->last;
            uint32_t late = 0U;
            if (elapsed < self->last) {
                const uint32_t to_rest = (elapsed < self->last) ? (self->last - elapsed) : 0U;
                const uint32_t ahead = to_rest;
                const double flat1 = (PACED_S1_1 * x1) + (PACED_S1_2 * x2);
                const double flat2 = PACED_S2_2 * x2;
                const double flat3 = self->u1;
                uint32_t below = ((ahead / 16U) < ((1U < ahead) ? (ahead - 1U) : 0U)) ? (((1U < ahead) ? (ahead - 1U) : 0U) - (ahead / 16U)) : 0U;
                if (ahead > 3U) {
                    if (below < 3U) {
                        below = 3U;
                    }
                } else {
                    below = (1U < ahead) ? (ahead - 1U) : 0U;
                }
                uint32_t low = below;
                uint32_t top = 1073741825U;
                uint32_t kept = 0U;
                uint32_t tried = ahead;
                double part = 0.9999999999968848;
                for (uint32_t attempt = 0U; attempt < 64U; attempt++) {
                    const double least = -part;
                    const double most = self->u_max * part;
                    uint32_t fits = 0U;
                    if (tried > 3U) {
                        const double m = (double)tried;
                        const double power1 = m + 3.0;
                        const double power2 = power1 * (m + 2.0);
                        const double power3 = power2 * (m + 1.0);
                        const double power4 = power3 * m;
                        const double power5 = power4 * (m - 1.0);
                        const double power6 = power5 * (m - 2.0);
                        const double scaled2 = flat2 * power1;
                        const double scaled3 = flat3 * power2;
                        const double w1 = ((15.0 * flat1) + (5.0 * scaled2) + (0.5 * scaled3)) / power4;
                        const double w2 = ((((-24.0) * flat1) - (9.0 * scaled2)) - scaled3) / power5;
                        const double w3 = ((10.0 * flat1) + (4.0 * scaled2) + (0.5 * scaled3)) / power6;
                        const double length = m - 4.0;
                        const double b0_c = (144.0 * w1) + (480.0 * w2) + (720.0 * w3);
                        const double b1_c = ((84.0 * w1) + (520.0 * w2) + (1500.0 * w3)) * length;
                        const double b2_l = length * length;
                        const double b2_c = ((12.0 * w1) + (180.0 * w2) + (1050.0 * w3)) * b2_l;
                        const double b3_l = b2_l * length;
                        const double b3_c = ((20.0 * w2) + (300.0 * w3)) * b3_l;
                        const double b4_l = b3_l * length;
                        const double b4_c = 30.0 * w3 * b4_l;
                        const double b1 = b0_c + (0.125 * b1_c);
                        const double b2 = b0_c + (0.25 * b1_c) + (0.03571428571428571 * b2_c);
                        const double s1 = b0_c + (0.375 * b1_c) + (0.10714285714285714 * b2_c);
                        const double b3 = s1 + (0.017857142857142856 * b3_c);
                        const double s2 = b0_c + (0.5 * b1_c) + (0.21428571428571427 * b2_c);
                        const double s3 = s2 + (0.07142857142857142 * b3_c);
                        const double b4 = s3 + (0.014285714285714285 * b4_c);
                        const double s4 = b0_c + (0.625 * b1_c) + (0.35714285714285715 * b2_c);
                        const double s5 = s4 + (0.17857142857142858 * b3_c);
                        const double b5 = s5 + (0.07142857142857142 * b4_c);
                        const double s6 = b0_c + (0.75 * b1_c) + (0.5357142857142857 * b2_c);
                        const double s7 = s6 + (0.35714285714285715 * b3_c);
                        const double b6 = s7 + (0.21428571428571427 * b4_c);
                        const double s8 = b0_c + (0.875 * b1_c) + (0.75 * b2_c) + (0.625 * b3_c);
                        const double b7 = s8 + (0.5 * b4_c);
                        const double b8 = b0_c + b1_c + b2_c + b3_c + b4_c;
                        const double end29 = (72.0 * w1) + (120.0 * w2);
                        const double end30 = 24.0 * w1;
                        if ((least <= b0_c)
                            && (b0_c <= most)
                            && (least <= b1)
                            && (b1 <= most)
                            && (least <= b2)
                            && (b2 <= most)
                            && (least <= b3)
                            && (b3 <= most)
                            && (least <= b4)
                            && (b4 <= most)
                            && (least <= b5)
                            && (b5 <= most)
                            && (least <= b6)
                            && (b6 <= most)
                            && (least <= b7)
                            && (b7 <= most)
                            && (least <= b8)
                            && (b8 <= most)
                            && (least <= end29)
                            && (end29 <= most)
                            && (least <= end30)
                            && (end30 <= most)) {
                            fits = 1U;
                        }
                    } else {
                        const double end0 = ((-flat1) - (3.0 * flat2)) - (2.0 * flat3);
                        const double end1 = flat1 + (2.0 * flat2) + flat3;
                        if ((least <= end0)
                            && (end0 <= most)
                            && (least <= end1)
                            && (end1 <= most)) {
                            fits = 1U;
                        }
                    }
                    if (fits == 1U) {
                        kept = tried;
                        top = tried;
                    } else if (tried > 3U) {
                        low = tried;
                    } else {
                        low = 3U;
                    }
                    const uint32_t gap = (low < top) ? (top - low) : 0U;
                    if (gap < 2U) {
                        break;
                    }
                    const uint32_t half = gap / 2U;
                    if (low < half) {
                        tried = low + low;
                    } else {
                        tried = low + half;
                    }
                    part = 0.9999999999937695;
                }
                if ((kept > 0U) && (elapsed < 2147483648U)) {
                    last_now = elapsed + kept;
                }
                if ((kept == 0U) && (ahead > 0U)) {
                    late = 2U;
                }
            }
            if (last_now > self->last) {
                late = 1U;
            }
            const uint32_t left = (elapsed < last_now) ? (last_now - elapsed) : 0U;
            const double m0 = ((double)left < 3.0) ? 3.0 : (double)left;
            double v;

            /* The exact law in samples. */
            const double z1 = (PACED_W1_1 * x1) + (PACED_W1_2 * x2);
            const double z2 = PACED_W2_2 * x2;
            const double z3 = PACED_W3_3 * self->u1;
            const double m0f1 = m0 + 3.0;
            const double m0f2 = m0f1 * (m0 + 2.0);
            v = ((z1 + (z2 * m0f1) + (z3 * m0f2)) / (m0f2 * (m0 + 1.0))) + self->u1;
            status = PTC_E_RANGE;
            if (PTC_FINITE_F64(v)) {
                double u_now;
                if (elapsed < last_now) {
                    if (v > self->u_max) {
                        u_now = self->u_max;
                    } else if (v < -1.0) {
                        u_now = -1.0;
                    } else {
                        u_now = v;
                    }
                } else {
                    u_now = 0.0;
                }
                self->u1 = u_now;
                self->last = last_now;
                *u = u_now;
                if (elapsed < last_now) {
                    if ((v > self->u_max) || (v < -1.0)) {
                        status = PTC_SATURATED;
                    } else if (late == 2U) {
                        status = PTC_INFEASIBLE;
                    } else if (late == 1U) {
                        status = PTC_LATE;
                    } else {
                        status = PTC_OK;
                    }
                } else {
                    status = PTC_AFTER;
                }
            }
        }
    }
    return status;
}

ptc_status paced_arm_for(paced *self, uint32_t k, uint32_t samples)
{
    ptc_status status = PTC_E_PARAM;

    if (self != NULL) {
        if ((samples > 2U) && (samples < 2147483649U)) {
            self->start = k;
            self->last = samples;
            status = PTC_OK;
        }
    }
    return status;
}

ptc_status paced_soonest(const paced *self, const double x[2], uint32_t *samples)
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (x != NULL) && (samples != NULL)) {
        if (PTC_FINITE_F64(x[0]) && PTC_FINITE_F64(x[1])) {
            const double x1 = x[0];
            const double x2 = x[1];
            const double flat1 = (PACED_S1_1 * x1) + (PACED_S1_2 * x2);
            const double flat2 = PACED_S2_2 * x2;
            const double flat3 = self->u1;
            uint32_t low = 3U;
            uint32_t top = 1073741825U;
            uint32_t kept = 0U;
            uint32_t tried = 4U;
            for (uint32_t attempt = 0U; attempt < 64U; attempt++) {
                const double least = -0.9999999999937695;
                const double most = 0.9999999999937695 * self->u_max;
                uint32_t fits = 0U;
                const double m = (double)tried;
                const double power1 = m + 3.0;
                const double power2 = power1 * (m + 2.0);
                const double power3 = power2 * (m + 1.0);
                const double power4 = power3 * m;
                const double power5 = power4 * (m - 1.0);
                const double power6 = power5 * (m - 2.0);
                const double scaled2 = flat2 * power1;
                const double scaled3 = flat3 * power2;
                const double w1 = ((15.0 * flat1) + (5.0 * scaled2) + (0.5 * scaled3)) / power4;
                const double w2 = ((((-24.0) * flat1) - (9.0 * scaled2)) - scaled3) / power5;
                const double w3 = ((10.0 * flat1) + (4.0 * scaled2) + (0.5 * scaled3)) / power6;
                const double length = m - 4.0;
                const double b0_c = (144.0 * w1) + (480.0 * w2) + (720.0 * w3);
                const double b1_c = ((84.0 * w1) + (520.0 * w2) + (1500.0 * w3)) * length;
                const double b2_l = length * length;
                const double b2_c = ((12.0 * w1) + (180.0 * w2) + (1050.0 * w3)) * b2_l;
                const double b3_l = b2_l * length;
                const double b3_c = ((20.0 * w2) + (300.0 * w3)) * b3_l;
                const double b4_l = b3_l * length;
                const double b4_c = 30.0 * w3 * b4_l;
                const double b1 = b0_c + (0.125 * b1_c);
                const double b2 = b0_c + (0.25 * b1_c) + (0.03571428571428571 * b2_c);
                const double s1 = b0_c + (0.375 * b1_c) + (0.10714285714285714 * b2_c);
                const double b3 = s1 + (0.017857142857142856 * b3_c);
                const double s2 = b0_c + (0.5 * b1_c) + (0.21428571428571427 * b2_c);
                const double s3 = s2 + (0.07142857142857142 * b3_c);
                const double b4 = s3 + (0.014285714285714285 * b4_c);
                const double s4 = b0_c + (0.625 * b1_c) + (0.35714285714285715 * b2_c);
                const double s5 = s4 + (0.17857142857142858 * b3_c);
                const double b5 = s5 + (0.07142857142857142 * b4_c);
                const double s6 = b0_c + (0.75 * b1_c) + (0.5357142857142857 * b2_c);
                const double s7 = s6 + (0.35714285714285715 * b3_c);
                const double b6 = s7 + (0.21428571428571427 * b4_c);
                const double s8 = b0_c + (0.875 * b1_c) + (0.75 * b2_c) + (0.625 * b3_c);
                const double b7 = s8 + (0.5 * b4_c);
                const double b8 = b0_c + b1_c + b2_c + b3_c + b4_c;
                const double end29 = (72.0 * w1) + (120.0 * w2);
                const double end30 = 24.0 * w1;
                if ((least <= b0_c)
                    && (b0_c <= most)
                    && (least <= b1)
                    && (b1 <= most)
                    && (least <= b2)
                    && (b2 <= most)
                    && (least <= b3)
                    && (b3 <= most)
                    && (least <= b4)
                    && (b4 <= most)
                    && (least <= b5)
                    && (b5 <= most)
                    && (least <= b6)
                    && (b6 <= most)
                    && (least <= b7)
                    && (b7 <= most)
                    && (least <= b8)
                    && (b8 <= most)
                    && (least <= end29)
                    && (end29 <= most)
                    && (least <= end30)
                    && (end30 <= most)) {
                    fits = 1U;
                }
                if (fits == 1U) {
                    kept = tried;
                    top = tried;
                } else {
                    low = tried;
                }
                const uint32_t gap = (low < top) ? (top - low) : 0U;
                if (gap < 2U) {
                    break;
                }
                const uint32_t half = gap / 2U;
                if (low < half) {
                    tried = low + low;
                } else {
                    tried = low + half;
                }
            }
            if (PTC_FINITE_F64(flat1) && PTC_FINITE_F64(flat2) && PTC_FINITE_F64(flat3)) {
                if (kept > 0U) {
                    *samples = kept;
                    status = PTC_OK;
                } else {
                    status = PTC_E_SOON;
                }
            } else {
                status = PTC_E_RANGE;
            }
        }
    }
    return status;
}

ptc_status paced_deadline(const paced *self, uint32_t *k)
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (k != NULL)) {
        *k = self->start - (0U - self->last);
        status = PTC_OK;
    }
    return status;
}

ptc_status paced_applied(paced *self, double u)
{
    ptc_status status = PTC_E_INPUT;

    if (self != NULL) {
        if (PTC_FINITE_F64(u)) {
            self->u1 = u;
            status = PTC_OK;
        }
    }
    return status;
}
