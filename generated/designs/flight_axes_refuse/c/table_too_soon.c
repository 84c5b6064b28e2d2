/* Prescribed-time controller table_too_soon: see table_too_soon.h. DO NOT EDIT. */
#include "table_too_soon.h"

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
#define TABLE_TOO_SOON_W1_1_1 (-60000000.0) /* weight of x1 in the law */
#define TABLE_TOO_SOON_W1_2_1 600000.0 /* weight of x2 in the law */
#define TABLE_TOO_SOON_W1_3_1 (-2000.0) /* weight of x3 in the law */
#define TABLE_TOO_SOON_W2_2_1 (-360000.0) /* weight of x2 in the law */
#define TABLE_TOO_SOON_W2_3_1 1800.0 /* weight of x3 in the law */
#define TABLE_TOO_SOON_W3_3_1 (-900.0) /* weight of x3 in the law */
#define TABLE_TOO_SOON_W1_1_2 (-120000000.0) /* weight of x1 in the law */
#define TABLE_TOO_SOON_W1_2_2 1200000.0 /* weight of x2 in the law */
#define TABLE_TOO_SOON_W1_3_2 (-4000.0) /* weight of x3 in the law */
#define TABLE_TOO_SOON_W2_2_2 (-600000.0) /* weight of x2 in the law */
#define TABLE_TOO_SOON_W2_3_2 3000.0 /* weight of x3 in the law */
#define TABLE_TOO_SOON_W3_3_2 (-1200.0) /* weight of x3 in the law */
#define TABLE_TOO_SOON_S1_1_1 1000000.0 /* weight of x1 in the law */
#define TABLE_TOO_SOON_S1_2_1 (-10000.0) /* weight of x2 in the law */
#define TABLE_TOO_SOON_S1_3_1 33.333333333333336 /* 100/3, weight of x3 in the law */
#define TABLE_TOO_SOON_S2_2_1 10000.0 /* weight of x2 in the law */
#define TABLE_TOO_SOON_S2_3_1 (-50.0) /* weight of x3 in the law */
#define TABLE_TOO_SOON_S3_3_1 100.0 /* weight of x3 in the law */
#define TABLE_TOO_SOON_S1_1_2 1000000.0 /* weight of x1 in the law */
#define TABLE_TOO_SOON_S1_2_2 (-10000.0) /* weight of x2 in the law */
#define TABLE_TOO_SOON_S1_3_2 33.333333333333336 /* 100/3, weight of x3 in the law */
#define TABLE_TOO_SOON_S2_2_2 10000.0 /* weight of x2 in the law */
#define TABLE_TOO_SOON_S2_3_2 (-50.0) /* weight of x3 in the law */
#define TABLE_TOO_SOON_S3_3_2 100.0 /* weight of x3 in the law */

ptc_status table_too_soon_init(table_too_soon *self, const table_too_soon_params *params)
{
    ptc_status status = PTC_E_PARAM;

    if ((self != NULL) && (params != NULL)) {
        if (params->u_min < params->u_max) {
            const double u_max = params->u_max;
            const double u_min = params->u_min;
            self->start = 0U;
            self->last = 150U;
            self->u_max = u_max;
            self->u_min = u_min;
            status = PTC_OK;
        }
    }
    return status;
}

ptc_status table_too_soon_arm(table_too_soon *self, uint32_t k)
{
    ptc_status status = PTC_E_INPUT;

    if (self != NULL) {
        self->start = k;
        self->last = 150U;
        status = PTC_OK;
    }
    return status;
}

ptc_status table_too_soon_step(
    const table_too_soon *self,
    uint32_t k,
    const double x[2][3],
    double u[2],
    ptc_status axes[2])
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (x != NULL) && (u != NULL) && (axes != NULL)) {
        if (PTC_FINITE_F64(x[0][0])
            && PTC_FINITE_F64(x[0][1])
            && PTC_FINITE_F64(x[0][2])
            && PTC_FINITE_F64(x[1][0])
            && PTC_FINITE_F64(x[1][1])
            && PTC_FINITE_F64(x[1][2])) {
            const uint32_t elapsed = k - self->start;
            const double x1_1 = x[0][0];
            const double x2_1 = x[0][1];
            const double x3_1 = x[0][2];
            const double x1_2 = x[1][0];
            const double x2_2 = x[1][1];
            const double x3_2 = x[1][2];
            const uint32_t left = (elapsed < self->last) ? (self->last - elapsed) : 0U;
            const double m0_1 = ((double)left < 3.0) ? 3.0 : (double)left;
            double law_1;

            /* The exact law in samples. */
            const double s1 = (TABLE_TOO_SOON_W1_1_1 * x1_1) + (TABLE_TOO_SOON_W1_2_1 * x2_1);
            const double z1_1 = s1 + (TABLE_TOO_SOON_W1_3_1 * x3_1);
            const double z2_1 = (TABLE_TOO_SOON_W2_2_1 * x2_1) + (TABLE_TOO_SOON_W2_3_1 * x3_1);
            const double z3_1 = TABLE_TOO_SOON_W3_3_1 * x3_1;
            const double m0f_11 = m0_1 + 2.0;
            const double m0f_12 = m0f_11 * (m0_1 + 1.0);
            law_1 = (z1_1 + (z2_1 * m0f_11) + (z3_1 * m0f_12)) / (m0f_12 * m0_1);
            const double m0_2 = ((double)left < 3.0) ? 3.0 : (double)left;
            double law_2;
            const double s2 = (TABLE_TOO_SOON_W1_1_2 * x1_2) + (TABLE_TOO_SOON_W1_2_2 * x2_2);
            const double z1_2 = s2 + (TABLE_TOO_SOON_W1_3_2 * x3_2);
            const double z2_2 = (TABLE_TOO_SOON_W2_2_2 * x2_2) + (TABLE_TOO_SOON_W2_3_2 * x3_2);
            const double z3_2 = TABLE_TOO_SOON_W3_3_2 * x3_2;
            const double m0f_21 = m0_2 + 3.0;
            const double m0f_22 = m0f_21 * (m0_2 + 2.0);
            const double s3 = z1_2 + (z2_2 * m0f_21) + (z3_2 * m0f_22);
            law_2 = s3 / (m0f_22 * (m0_2 + 1.0));
            if (elapsed < self->last) {
                status = PTC_OK;
            } else {
                status = PTC_HOLD;
            }
            if (PTC_FINITE_F64(law_1) && PTC_FINITE_F64(law_2)) {
                u[0] = law_1;
                axes[0] = status;
                u[1] = law_2;
                axes[1] = status;
                if (law_1 > self->u_max) {
                    u[0] = self->u_max;
                    axes[0] = PTC_SATURATED;
                    status = PTC_SATURATED;
                } else if (law_1 < self->u_min) {
                    u[0] = self->u_min;
                    axes[0] = PTC_SATURATED;
                    status = PTC_SATURATED;
                } else {
                    /* neither */
                }
                if (law_2 > self->u_max) {
                    u[1] = self->u_max;
                    axes[1] = PTC_SATURATED;
                    status = PTC_SATURATED;
                } else if (law_2 < self->u_min) {
                    u[1] = self->u_min;
                    axes[1] = PTC_SATURATED;
                    status = PTC_SATURATED;
                } else {
                    /* neither */
                }
            } else {
                u[0] = 0.0;
                if (PTC_FINITE_F64(law_1)) {
                    axes[0] = status;
                } else {
                    axes[0] = PTC_E_RANGE;
                }
                u[1] = 0.0;
                if (PTC_FINITE_F64(law_2)) {
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
        if (axes != NULL) {
            for (uint32_t i = 0U; i < 2U; i++) {
                axes[i] = PTC_E_INPUT;
            }
        }
    }
    return status;
}

ptc_status table_too_soon_arm_for(
    table_too_soon *self,
    uint32_t k,
    uint32_t samples,
    const double x[2][3])
{
    ptc_status status = PTC_E_PARAM;

    if ((self != NULL) && (x != NULL)) {
        if ((samples > 2U) && (samples < 2147483649U)) {
            status = PTC_E_INPUT;
            if (PTC_FINITE_F64(x[0][0])
                && PTC_FINITE_F64(x[0][1])
                && PTC_FINITE_F64(x[0][2])
                && PTC_FINITE_F64(x[1][0])
                && PTC_FINITE_F64(x[1][1])
                && PTC_FINITE_F64(x[1][2])) {
                const double x1_1 = x[0][0];
                const double x2_1 = x[0][1];
                const double x3_1 = x[0][2];
                const double x1_2 = x[1][0];
                const double x2_2 = x[1][1];
                const double x3_2 = x[1][2];
                const double s1 = (TABLE_TOO_SOON_S1_1_1 * x1_1) + (TABLE_TOO_SOON_S1_2_1 * x2_1);
                const double flat1_1 = s1 + (TABLE_TOO_SOON_S1_3_1 * x3_1);
                const double flat2_1 = (TABLE_TOO_SOON_S2_2_1 * x2_1) + (TABLE_TOO_SOON_S2_3_1 * x3_1);
                const double flat3_1 = TABLE_TOO_SOON_S3_3_1 * x3_1;
                const double s2 = (TABLE_TOO_SOON_S1_1_2 * x1_2) + (TABLE_TOO_SOON_S1_2_2 * x2_2);
                const double flat1_2 = s2 + (TABLE_TOO_SOON_S1_3_2 * x3_2);
                const double flat2_2 = (TABLE_TOO_SOON_S2_2_2 * x2_2) + (TABLE_TOO_SOON_S2_3_2 * x3_2);
                const double flat3_2 = TABLE_TOO_SOON_S3_3_2 * x3_2;
                const double least_1 = 0.999999999990586 * self->u_min;
                const double most_1 = 0.999999999990586 * self->u_max;
                const double most2_1 = 0.499999999995293;
                const double most3_1 = 3.999999999962344;
                const double least_2 = 0.999999999990586 * self->u_min;
                const double most_2 = 0.999999999990586 * self->u_max;
                const double most2_2 = 0.499999999995293;
                const double most3_2 = 3.999999999962344;
                const uint32_t tried = samples;
                uint32_t fits = 0U;
                const double m_1 = (double)tried;
                const double power1_1 = m_1 + 2.0;
                const double power2_1 = power1_1 * (m_1 + 1.0);
                const double power3_1 = power2_1 * m_1;
                const double power4_1 = power3_1 * (m_1 - 1.0);
                const double power5_1 = power4_1 * (m_1 - 2.0);
                const double scaled2_1 = flat2_1 * power1_1;
                const double scaled3_1 = flat3_1 * power2_1;
                const double s3 = (10.0 * flat1_1) + (4.0 * scaled2_1) + (0.5 * scaled3_1);
                const double w1_1 = s3 / power3_1;
                const double w2_1 = ((((-15.0) * flat1_1) - (7.0 * scaled2_1)) - scaled3_1) / power4_1;
                const double s4 = (6.0 * flat1_1) + (3.0 * scaled2_1) + (0.5 * scaled3_1);
                const double w3_1 = s4 / power5_1;
                const double length_1 = m_1 - 4.0;
                const double b0_c_1 = (((-6.0) * w1_1) - (72.0 * w2_1)) - (360.0 * w3_1);
                const double b1_c_1 = (((-24.0) * w2_1) - (300.0 * w3_1)) * length_1;
                const double b2_l_1 = length_1 * length_1;
                const double b2_c_1 = (-60.0) * w3_1 * b2_l_1;
                const double b1_1 = b0_c_1 + (0.16666666666666666 * b1_c_1);
                const double s5 = b0_c_1 + (0.3333333333333333 * b1_c_1);
                const double b2_1 = s5 + (0.06666666666666667 * b2_c_1);
                const double b3_1 = b0_c_1 + (0.5 * b1_c_1) + (0.2 * b2_c_1);
                const double b4_1 = b0_c_1 + (0.6666666666666666 * b1_c_1) + (0.4 * b2_c_1);
                const double s6 = b0_c_1 + (0.8333333333333334 * b1_c_1);
                const double b5_1 = s6 + (0.6666666666666666 * b2_c_1);
                const double b6_1 = b0_c_1 + b1_c_1 + b2_c_1;
                const double s0_c_1 = (((-0.0048) * w1_1) - (0.0168 * w2_1)) - (0.036 * w3_1);
                const double s1_c_1 = ((((-0.0024) * w1_1) - (0.0146 * w2_1)) - (0.051 * w3_1)) * length_1;
                const double s2_l_1 = length_1 * length_1;
                const double s2_c_1 = ((((-0.0003) * w1_1) - (0.0042 * w2_1)) - (0.0265 * w3_1)) * s2_l_1;
                const double s3_l_1 = s2_l_1 * length_1;
                const double s3_c_1 = (((-0.0004) * w2_1) - (0.006 * w3_1)) * s3_l_1;
                const double s4_l_1 = s3_l_1 * length_1;
                const double s4_c_1 = (-0.0005) * w3_1 * s4_l_1;
                const double s1_1 = s0_c_1 + (0.125 * s1_c_1);
                const double s2_1 = s0_c_1 + (0.25 * s1_c_1) + (0.03571428571428571 * s2_c_1);
                const double s7 = s0_c_1 + (0.375 * s1_c_1) + (0.10714285714285714 * s2_c_1);
                const double s3_1 = s7 + (0.017857142857142856 * s3_c_1);
                const double s8 = s0_c_1 + (0.5 * s1_c_1) + (0.21428571428571427 * s2_c_1);
                const double s9 = s8 + (0.07142857142857142 * s3_c_1);
                const double s4_1 = s9 + (0.014285714285714285 * s4_c_1);
                const double s10 = s0_c_1 + (0.625 * s1_c_1) + (0.35714285714285715 * s2_c_1);
                const double s11 = s10 + (0.17857142857142858 * s3_c_1);
                const double s5_1 = s11 + (0.07142857142857142 * s4_c_1);
                const double s12 = s0_c_1 + (0.75 * s1_c_1) + (0.5357142857142857 * s2_c_1);
                const double s13 = s12 + (0.35714285714285715 * s3_c_1);
                const double s6_1 = s13 + (0.21428571428571427 * s4_c_1);
                const double s14 = s0_c_1 + (0.875 * s1_c_1) + (0.75 * s2_c_1) + (0.625 * s3_c_1);
                const double s7_1 = s14 + (0.5 * s4_c_1);
                const double s8_1 = s0_c_1 + s1_c_1 + s2_c_1 + s3_c_1 + s4_c_1;
                const double v0_c_1 = (0.24 * w1_1) + (1.44 * w2_1) + (4.8 * w3_1);
                const double v1_c_1 = ((0.06 * w1_1) + (0.84 * w2_1) + (5.2 * w3_1)) * length_1;
                const double v2_l_1 = length_1 * length_1;
                const double v2_c_1 = ((0.12 * w2_1) + (1.8 * w3_1)) * v2_l_1;
                const double v3_l_1 = v2_l_1 * length_1;
                const double v3_c_1 = 0.2 * w3_1 * v3_l_1;
                const double v1_1 = v0_c_1 + (0.14285714285714285 * v1_c_1);
                const double s15 = v0_c_1 + (0.2857142857142857 * v1_c_1);
                const double v2_1 = s15 + (0.047619047619047616 * v2_c_1);
                const double s16 = v0_c_1 + (0.42857142857142855 * v1_c_1);
                const double s17 = s16 + (0.14285714285714285 * v2_c_1);
                const double v3_1 = s17 + (0.02857142857142857 * v3_c_1);
                const double s18 = v0_c_1 + (0.5714285714285714 * v1_c_1);
                const double s19 = s18 + (0.2857142857142857 * v2_c_1);
                const double v4_1 = s19 + (0.11428571428571428 * v3_c_1);
                const double s20 = v0_c_1 + (0.7142857142857143 * v1_c_1);
                const double s21 = s20 + (0.47619047619047616 * v2_c_1);
                const double v5_1 = s21 + (0.2857142857142857 * v3_c_1);
                const double s22 = v0_c_1 + (0.8571428571428571 * v1_c_1);
                const double s23 = s22 + (0.7142857142857143 * v2_c_1);
                const double v6_1 = s23 + (0.5714285714285714 * v3_c_1);
                const double v7_1 = v0_c_1 + v1_c_1 + v2_c_1 + v3_c_1;
                const double end51_1 = (((-6.0) * w1_1) - (48.0 * w2_1)) - (120.0 * w3_1);
                const double end52_1 = ((-6.0) * w1_1) - (24.0 * w2_1);
                const double end53_1 = (-6.0) * w1_1;
                if ((least_1 <= b0_c_1)
                    && (b0_c_1 <= most_1)
                    && (least_1 <= b1_1)
                    && (b1_1 <= most_1)
                    && (least_1 <= b2_1)
                    && (b2_1 <= most_1)
                    && (least_1 <= b3_1)
                    && (b3_1 <= most_1)
                    && (least_1 <= b4_1)
                    && (b4_1 <= most_1)
                    && (least_1 <= b5_1)
                    && (b5_1 <= most_1)
                    && (least_1 <= b6_1)
                    && (b6_1 <= most_1)
                    && (-most2_1 <= s0_c_1)
                    && (s0_c_1 <= most2_1)
                    && (-most2_1 <= s1_1)
                    && (s1_1 <= most2_1)
                    && (-most2_1 <= s2_1)
                    && (s2_1 <= most2_1)
                    && (-most2_1 <= s3_1)
                    && (s3_1 <= most2_1)
                    && (-most2_1 <= s4_1)
                    && (s4_1 <= most2_1)
                    && (-most2_1 <= s5_1)
                    && (s5_1 <= most2_1)
                    && (-most2_1 <= s6_1)
                    && (s6_1 <= most2_1)
                    && (-most2_1 <= s7_1)
                    && (s7_1 <= most2_1)
                    && (-most2_1 <= s8_1)
                    && (s8_1 <= most2_1)
                    && (-most3_1 <= v0_c_1)
                    && (v0_c_1 <= most3_1)
                    && (-most3_1 <= v1_1)
                    && (v1_1 <= most3_1)
                    && (-most3_1 <= v2_1)
                    && (v2_1 <= most3_1)
                    && (-most3_1 <= v3_1)
                    && (v3_1 <= most3_1)
                    && (-most3_1 <= v4_1)
                    && (v4_1 <= most3_1)
                    && (-most3_1 <= v5_1)
                    && (v5_1 <= most3_1)
                    && (-most3_1 <= v6_1)
                    && (v6_1 <= most3_1)
                    && (-most3_1 <= v7_1)
                    && (v7_1 <= most3_1)
                    && (least_1 <= end51_1)
                    && (end51_1 <= most_1)
                    && (least_1 <= end52_1)
                    && (end52_1 <= most_1)
                    && (least_1 <= end53_1)
                    && (end53_1 <= most_1)
                    && (fabs((((-0.0027) * w1_1) - (0.006 * w2_1)) - (0.006 * w3_1)) <= most2_1)
                    && (fabs((((-0.0012) * w1_1) - (0.0011999999999999995 * w2_1)) + (8.131516293641283e-19 * w3_1)) <= most2_1)
                    && (fabs(((-0.00029999999999999965) * w1_1) + (8.131516293641283e-19 * w2_1) + (8.131516293641283e-19 * w3_1)) <= most2_1)
                    && (fabs((0.18 * w1_1) + (0.72 * w2_1) + (1.2 * w3_1)) <= most3_1)
                    && (fabs(((0.11999999999999994 * w1_1) + (0.23999999999999982 * w2_1)) - (2.0816681711721685e-16 * w3_1)) <= most3_1)
                    && (fabs((0.06000000000000016 * w1_1) + (4.579669976578771e-16 * w2_1) + (6.245004513516506e-16 * w3_1)) <= most3_1)) {
                    fits = 1U;
                }
                if (fits == 1U) {
                    const double m_2 = (double)tried;
                    const double power1_2 = m_2 + 3.0;
                    const double power2_2 = power1_2 * (m_2 + 2.0);
                    const double power3_2 = power2_2 * (m_2 + 1.0);
                    const double power4_2 = power3_2 * m_2;
                    const double power5_2 = power4_2 * (m_2 - 1.0);
                    const double power6_2 = power5_2 * (m_2 - 2.0);
                    const double scaled2_2 = flat2_2 * power1_2;
                    const double scaled3_2 = flat3_2 * power2_2;
                    const double s24 = (15.0 * flat1_2) + (5.0 * scaled2_2) + (0.5 * scaled3_2);
                    const double w1_2 = s24 / power4_2;
                    const double w2_2 = ((((-24.0) * flat1_2) - (9.0 * scaled2_2)) - scaled3_2) / power5_2;
                    const double s25 = (10.0 * flat1_2) + (4.0 * scaled2_2) + (0.5 * scaled3_2);
                    const double w3_2 = s25 / power6_2;
                    const double length_2 = m_2 - 4.0;
                    const double b0_c_2 = (((-96.0) * w1_2) - (720.0 * w2_2)) - (2880.0 * w3_2);
                    const double b1_c_2 = ((((-24.0) * w1_2) - (420.0 * w2_2)) - (3120.0 * w3_2)) * length_2;
                    const double b2_l_2 = length_2 * length_2;
                    const double b2_c_2 = (((-60.0) * w2_2) - (1080.0 * w3_2)) * b2_l_2;
                    const double b3_l_2 = b2_l_2 * length_2;
                    const double b3_c_2 = (-120.0) * w3_2 * b3_l_2;
                    const double b1_2 = b0_c_2 + (0.14285714285714285 * b1_c_2);
                    const double s26 = b0_c_2 + (0.2857142857142857 * b1_c_2);
                    const double b2_2 = s26 + (0.047619047619047616 * b2_c_2);
                    const double s27 = b0_c_2 + (0.42857142857142855 * b1_c_2);
                    const double s28 = s27 + (0.14285714285714285 * b2_c_2);
                    const double b3_2 = s28 + (0.02857142857142857 * b3_c_2);
                    const double s29 = b0_c_2 + (0.5714285714285714 * b1_c_2);
                    const double s30 = s29 + (0.2857142857142857 * b2_c_2);
                    const double b4_2 = s30 + (0.11428571428571428 * b3_c_2);
                    const double s31 = b0_c_2 + (0.7142857142857143 * b1_c_2);
                    const double s32 = s31 + (0.47619047619047616 * b2_c_2);
                    const double b5_2 = s32 + (0.2857142857142857 * b3_c_2);
                    const double s33 = b0_c_2 + (0.8571428571428571 * b1_c_2);
                    const double s34 = s33 + (0.7142857142857143 * b2_c_2);
                    const double b6_2 = s34 + (0.5714285714285714 * b3_c_2);
                    const double b7_2 = b0_c_2 + b1_c_2 + b2_c_2 + b3_c_2;
                    const double s0_c_2 = (((-0.036) * w1_2) - (0.12 * w2_2)) - (0.252 * w3_2);
                    const double s1_c_2 = ((((-0.0242) * w1_2) - (0.124 * w2_2)) - (0.3954 * w3_2)) * length_2;
                    const double s2_l_2 = length_2 * length_2;
                    const double s2_c_2 = ((((-0.0054) * w1_2) - (0.0475 * w2_2)) - (0.2415 * w3_2)) * s2_l_2;
                    const double s3_l_2 = s2_l_2 * length_2;
                    const double s3_c_2 = ((((-0.0004) * w1_2) - (0.008 * w2_2)) - (0.072 * w3_2)) * s3_l_2;
                    const double s4_l_2 = s3_l_2 * length_2;
                    const double s4_c_2 = (((-0.0005) * w2_2) - (0.0105 * w3_2)) * s4_l_2;
                    const double s5_l_2 = s4_l_2 * length_2;
                    const double s5_c_2 = (-0.0006) * w3_2 * s5_l_2;
                    const double s1_2 = s0_c_2 + (0.1111111111111111 * s1_c_2);
                    const double s35 = s0_c_2 + (0.2222222222222222 * s1_c_2);
                    const double s2_2 = s35 + (0.027777777777777776 * s2_c_2);
                    const double s36 = s0_c_2 + (0.3333333333333333 * s1_c_2);
                    const double s37 = s36 + (0.08333333333333333 * s2_c_2);
                    const double s3_2 = s37 + (0.011904761904761904 * s3_c_2);
                    const double s38 = s0_c_2 + (0.4444444444444444 * s1_c_2);
                    const double s39 = s38 + (0.16666666666666666 * s2_c_2);
                    const double s40 = s39 + (0.047619047619047616 * s3_c_2);
                    const double s4_2 = s40 + (0.007936507936507936 * s4_c_2);
                    const double s41 = s0_c_2 + (0.5555555555555556 * s1_c_2);
                    const double s42 = s41 + (0.2777777777777778 * s2_c_2);
                    const double s43 = s42 + (0.11904761904761904 * s3_c_2);
                    const double s44 = s43 + (0.03968253968253968 * s4_c_2);
                    const double s5_2 = s44 + (0.007936507936507936 * s5_c_2);
                    const double s45 = s0_c_2 + (0.6666666666666666 * s1_c_2);
                    const double s46 = s45 + (0.4166666666666667 * s2_c_2);
                    const double s47 = s46 + (0.23809523809523808 * s3_c_2);
                    const double s48 = s47 + (0.11904761904761904 * s4_c_2);
                    const double s6_2 = s48 + (0.047619047619047616 * s5_c_2);
                    const double s49 = s0_c_2 + (0.7777777777777778 * s1_c_2);
                    const double s50 = s49 + (0.5833333333333334 * s2_c_2);
                    const double s51 = s50 + (0.4166666666666667 * s3_c_2);
                    const double s52 = s51 + (0.2777777777777778 * s4_c_2);
                    const double s7_2 = s52 + (0.16666666666666666 * s5_c_2);
                    const double s53 = s0_c_2 + (0.8888888888888888 * s1_c_2);
                    const double s54 = s53 + (0.7777777777777778 * s2_c_2);
                    const double s55 = s54 + (0.6666666666666666 * s3_c_2);
                    const double s56 = s55 + (0.5555555555555556 * s4_c_2);
                    const double s8_2 = s56 + (0.4444444444444444 * s5_c_2);
                    const double s9_2 = s0_c_2 + s1_c_2 + s2_c_2 + s3_c_2 + s4_c_2 + s5_c_2;
                    const double v0_c_2 = (2.4 * w1_2) + (12.0 * w2_2) + (36.0 * w3_2);
                    const double v1_c_2 = ((1.08 * w1_2) + (9.4 * w2_2) + (46.2 * w3_2)) * length_2;
                    const double v2_l_2 = length_2 * length_2;
                    const double v2_c_2 = ((0.12 * w1_2) + (2.4 * w2_2) + (21.3 * w3_2)) * v2_l_2;
                    const double v3_l_2 = v2_l_2 * length_2;
                    const double v3_c_2 = ((0.2 * w2_2) + (4.2 * w3_2)) * v3_l_2;
                    const double v4_l_2 = v3_l_2 * length_2;
                    const double v4_c_2 = 0.3 * w3_2 * v4_l_2;
                    const double v1_2 = v0_c_2 + (0.125 * v1_c_2);
                    const double v2_2 = v0_c_2 + (0.25 * v1_c_2) + (0.03571428571428571 * v2_c_2);
                    const double s57 = v0_c_2 + (0.375 * v1_c_2) + (0.10714285714285714 * v2_c_2);
                    const double v3_2 = s57 + (0.017857142857142856 * v3_c_2);
                    const double s58 = v0_c_2 + (0.5 * v1_c_2) + (0.21428571428571427 * v2_c_2);
                    const double s59 = s58 + (0.07142857142857142 * v3_c_2);
                    const double v4_2 = s59 + (0.014285714285714285 * v4_c_2);
                    const double s60 = v0_c_2 + (0.625 * v1_c_2) + (0.35714285714285715 * v2_c_2);
                    const double s61 = s60 + (0.17857142857142858 * v3_c_2);
                    const double v5_2 = s61 + (0.07142857142857142 * v4_c_2);
                    const double s62 = v0_c_2 + (0.75 * v1_c_2) + (0.5357142857142857 * v2_c_2);
                    const double s63 = s62 + (0.35714285714285715 * v3_c_2);
                    const double v6_2 = s63 + (0.21428571428571427 * v4_c_2);
                    const double s64 = v0_c_2 + (0.875 * v1_c_2) + (0.75 * v2_c_2) + (0.625 * v3_c_2);
                    const double v7_2 = s64 + (0.5 * v4_c_2);
                    const double v8_2 = v0_c_2 + v1_c_2 + v2_c_2 + v3_c_2 + v4_c_2;
                    const double end61_2 = (((-72.0) * w1_2) - (360.0 * w2_2)) - (720.0 * w3_2);
                    const double end62_2 = ((-48.0) * w1_2) - (120.0 * w2_2);
                    const double end63_2 = (-24.0) * w1_2;
                    if ((least_2 <= b0_c_2)
                        && (b0_c_2 <= most_2)
                        && (least_2 <= b1_2)
                        && (b1_2 <= most_2)
                        && (least_2 <= b2_2)
                        && (b2_2 <= most_2)
                        && (least_2 <= b3_2)
                        && (b3_2 <= most_2)
                        && (least_2 <= b4_2)
                        && (b4_2 <= most_2)
                        && (least_2 <= b5_2)
                        && (b5_2 <= most_2)
                        && (least_2 <= b6_2)
                        && (b6_2 <= most_2)
                        && (least_2 <= b7_2)
                        && (b7_2 <= most_2)
                        && (-most2_2 <= s0_c_2)
                        && (s0_c_2 <= most2_2)
                        && (-most2_2 <= s1_2)
                        && (s1_2 <= most2_2)
                        && (-most2_2 <= s2_2)
                        && (s2_2 <= most2_2)
                        && (-most2_2 <= s3_2)
                        && (s3_2 <= most2_2)
                        && (-most2_2 <= s4_2)
                        && (s4_2 <= most2_2)
                        && (-most2_2 <= s5_2)
                        && (s5_2 <= most2_2)
                        && (-most2_2 <= s6_2)
                        && (s6_2 <= most2_2)
                        && (-most2_2 <= s7_2)
                        && (s7_2 <= most2_2)
                        && (-most2_2 <= s8_2)
                        && (s8_2 <= most2_2)
                        && (-most2_2 <= s9_2)
                        && (s9_2 <= most2_2)
                        && (-most3_2 <= v0_c_2)
                        && (v0_c_2 <= most3_2)
                        && (-most3_2 <= v1_2)
                        && (v1_2 <= most3_2)
                        && (-most3_2 <= v2_2)
                        && (v2_2 <= most3_2)
                        && (-most3_2 <= v3_2)
                        && (v3_2 <= most3_2)
                        && (-most3_2 <= v4_2)
                        && (v4_2 <= most3_2)
                        && (-most3_2 <= v5_2)
                        && (v5_2 <= most3_2)
                        && (-most3_2 <= v6_2)
                        && (v6_2 <= most3_2)
                        && (-most3_2 <= v7_2)
                        && (v7_2 <= most3_2)
                        && (-most3_2 <= v8_2)
                        && (v8_2 <= most3_2)
                        && (least_2 <= end61_2)
                        && (end61_2 <= most_2)
                        && (least_2 <= end62_2)
                        && (end62_2 <= most_2)
                        && (least_2 <= end63_2)
                        && (end63_2 <= most_2)
                        && (fabs((((-0.016800000000000002) * w1_2) - (0.036000000000000004 * w2_2)) - (0.036000000000000004 * w3_2)) <= most2_2)
                        && (fabs((((-0.005999999999999998) * w1_2) - (0.005999999999999997 * w2_2)) + (4.87890977618477e-18 * w3_2)) <= most2_2)
                        && (fabs(((-0.0011999999999999977) * w1_2) + (4.87890977618477e-18 * w2_2) + (4.87890977618477e-18 * w3_2)) <= most2_2)
                        && (fabs((1.44 * w1_2) + (4.8 * w2_2) + (7.2 * w3_2)) <= most3_2)
                        && (fabs(((0.7199999999999996 * w1_2) + (1.199999999999999 * w2_2)) - (1.2490009027033011e-15 * w3_2)) <= most3_2)
                        && (fabs((0.2400000000000011 * w1_2) + (2.914335439641036e-15 * w2_2) + (3.747002708109903e-15 * w3_2)) <= most3_2)) {
                        fits = 2U;
                    }
                }
                status = PTC_E_SOON;
                if ((tried > 3U) && (tried < 1073741825U) && (fits == 2U)) {
                    self->start = k;
                    self->last = samples;
                    status = PTC_OK;
                }
            }
        }
    }
    return status;
}

ptc_status table_too_soon_soonest(
    const table_too_soon *self,
    const double x[2][3],
    uint32_t *samples)
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (x != NULL) && (samples != NULL)) {
        if (PTC_FINITE_F64(x[0][0])
            && PTC_FINITE_F64(x[0][1])
            && PTC_FINITE_F64(x[0][2])
            && PTC_FINITE_F64(x[1][0])
            && PTC_FINITE_F64(x[1][1])
            && PTC_FINITE_F64(x[1][2])) {
            const double x1_1 = x[0][0];
            const double x2_1 = x[0][1];
            const double x3_1 = x[0][2];
            const double x1_2 = x[1][0];
            const double x2_2 = x[1][1];
            const double x3_2 = x[1][2];
            const double s1 = (TABLE_TOO_SOON_S1_1_1 * x1_1) + (TABLE_TOO_SOON_S1_2_1 * x2_1);
            const double flat1_1 = s1 + (TABLE_TOO_SOON_S1_3_1 * x3_1);
            const double flat2_1 = (TABLE_TOO_SOON_S2_2_1 * x2_1) + (TABLE_TOO_SOON_S2_3_1 * x3_1);
            const double flat3_1 = TABLE_TOO_SOON_S3_3_1 * x3_1;
            const double s2 = (TABLE_TOO_SOON_S1_1_2 * x1_2) + (TABLE_TOO_SOON_S1_2_2 * x2_2);
            const double flat1_2 = s2 + (TABLE_TOO_SOON_S1_3_2 * x3_2);
            const double flat2_2 = (TABLE_TOO_SOON_S2_2_2 * x2_2) + (TABLE_TOO_SOON_S2_3_2 * x3_2);
            const double flat3_2 = TABLE_TOO_SOON_S3_3_2 * x3_2;
            uint32_t low = 3U;
            uint32_t top = 1073741825U;
            uint32_t kept = 0U;
            uint32_t tried = 4U;
            for (uint32_t attempt = 0U; attempt < 64U; attempt++) {
                const double least_1 = 0.999999999990586 * self->u_min;
                const double most_1 = 0.999999999990586 * self->u_max;
                const double most2_1 = 0.499999999995293;
                const double most3_1 = 3.999999999962344;
                const double least_2 = 0.999999999990586 * self->u_min;
                const double most_2 = 0.999999999990586 * self->u_max;
                const double most2_2 = 0.499999999995293;
                const double most3_2 = 3.999999999962344;
                uint32_t fits = 0U;
                const double m_1 = (double)tried;
                const double power1_1 = m_1 + 2.0;
                const double power2_1 = power1_1 * (m_1 + 1.0);
                const double power3_1 = power2_1 * m_1;
                const double power4_1 = power3_1 * (m_1 - 1.0);
                const double power5_1 = power4_1 * (m_1 - 2.0);
                const double scaled2_1 = flat2_1 * power1_1;
                const double scaled3_1 = flat3_1 * power2_1;
                const double s3 = (10.0 * flat1_1) + (4.0 * scaled2_1) + (0.5 * scaled3_1);
                const double w1_1 = s3 / power3_1;
                const double w2_1 = ((((-15.0) * flat1_1) - (7.0 * scaled2_1)) - scaled3_1) / power4_1;
                const double s4 = (6.0 * flat1_1) + (3.0 * scaled2_1) + (0.5 * scaled3_1);
                const double w3_1 = s4 / power5_1;
                const double length_1 = m_1 - 4.0;
                const double b0_c_1 = (((-6.0) * w1_1) - (72.0 * w2_1)) - (360.0 * w3_1);
                const double b1_c_1 = (((-24.0) * w2_1) - (300.0 * w3_1)) * length_1;
                const double b2_l_1 = length_1 * length_1;
                const double b2_c_1 = (-60.0) * w3_1 * b2_l_1;
                const double b1_1 = b0_c_1 + (0.16666666666666666 * b1_c_1);
                const double s5 = b0_c_1 + (0.3333333333333333 * b1_c_1);
                const double b2_1 = s5 + (0.06666666666666667 * b2_c_1);
                const double b3_1 = b0_c_1 + (0.5 * b1_c_1) + (0.2 * b2_c_1);
                const double b4_1 = b0_c_1 + (0.6666666666666666 * b1_c_1) + (0.4 * b2_c_1);
                const double s6 = b0_c_1 + (0.8333333333333334 * b1_c_1);
                const double b5_1 = s6 + (0.6666666666666666 * b2_c_1);
                const double b6_1 = b0_c_1 + b1_c_1 + b2_c_1;
                const double s0_c_1 = (((-0.0048) * w1_1) - (0.0168 * w2_1)) - (0.036 * w3_1);
                const double s1_c_1 = ((((-0.0024) * w1_1) - (0.0146 * w2_1)) - (0.051 * w3_1)) * length_1;
                const double s2_l_1 = length_1 * length_1;
                const double s2_c_1 = ((((-0.0003) * w1_1) - (0.0042 * w2_1)) - (0.0265 * w3_1)) * s2_l_1;
                const double s3_l_1 = s2_l_1 * length_1;
                const double s3_c_1 = (((-0.0004) * w2_1) - (0.006 * w3_1)) * s3_l_1;
                const double s4_l_1 = s3_l_1 * length_1;
                const double s4_c_1 = (-0.0005) * w3_1 * s4_l_1;
                const double s1_1 = s0_c_1 + (0.125 * s1_c_1);
                const double s2_1 = s0_c_1 + (0.25 * s1_c_1) + (0.03571428571428571 * s2_c_1);
                const double s7 = s0_c_1 + (0.375 * s1_c_1) + (0.10714285714285714 * s2_c_1);
                const double s3_1 = s7 + (0.017857142857142856 * s3_c_1);
                const double s8 = s0_c_1 + (0.5 * s1_c_1) + (0.21428571428571427 * s2_c_1);
                const double s9 = s8 + (0.07142857142857142 * s3_c_1);
                const double s4_1 = s9 + (0.014285714285714285 * s4_c_1);
                const double s10 = s0_c_1 + (0.625 * s1_c_1) + (0.35714285714285715 * s2_c_1);
                const double s11 = s10 + (0.17857142857142858 * s3_c_1);
                const double s5_1 = s11 + (0.07142857142857142 * s4_c_1);
                const double s12 = s0_c_1 + (0.75 * s1_c_1) + (0.5357142857142857 * s2_c_1);
                const double s13 = s12 + (0.35714285714285715 * s3_c_1);
                const double s6_1 = s13 + (0.21428571428571427 * s4_c_1);
                const double s14 = s0_c_1 + (0.875 * s1_c_1) + (0.75 * s2_c_1) + (0.625 * s3_c_1);
                const double s7_1 = s14 + (0.5 * s4_c_1);
                const double s8_1 = s0_c_1 + s1_c_1 + s2_c_1 + s3_c_1 + s4_c_1;
                const double v0_c_1 = (0.24 * w1_1) + (1.44 * w2_1) + (4.8 * w3_1);
                const double v1_c_1 = ((0.06 * w1_1) + (0.84 * w2_1) + (5.2 * w3_1)) * length_1;
                const double v2_l_1 = length_1 * length_1;
                const double v2_c_1 = ((0.12 * w2_1) + (1.8 * w3_1)) * v2_l_1;
                const double v3_l_1 = v2_l_1 * length_1;
                const double v3_c_1 = 0.2 * w3_1 * v3_l_1;
                const double v1_1 = v0_c_1 + (0.14285714285714285 * v1_c_1);
                const double s15 = v0_c_1 + (0.2857142857142857 * v1_c_1);
                const double v2_1 = s15 + (0.047619047619047616 * v2_c_1);
                const double s16 = v0_c_1 + (0.42857142857142855 * v1_c_1);
                const double s17 = s16 + (0.14285714285714285 * v2_c_1);
                const double v3_1 = s17 + (0.02857142857142857 * v3_c_1);
                const double s18 = v0_c_1 + (0.5714285714285714 * v1_c_1);
                const double s19 = s18 + (0.2857142857142857 * v2_c_1);
                const double v4_1 = s19 + (0.11428571428571428 * v3_c_1);
                const double s20 = v0_c_1 + (0.7142857142857143 * v1_c_1);
                const double s21 = s20 + (0.47619047619047616 * v2_c_1);
                const double v5_1 = s21 + (0.2857142857142857 * v3_c_1);
                const double s22 = v0_c_1 + (0.8571428571428571 * v1_c_1);
                const double s23 = s22 + (0.7142857142857143 * v2_c_1);
                const double v6_1 = s23 + (0.5714285714285714 * v3_c_1);
                const double v7_1 = v0_c_1 + v1_c_1 + v2_c_1 + v3_c_1;
                const double end51_1 = (((-6.0) * w1_1) - (48.0 * w2_1)) - (120.0 * w3_1);
                const double end52_1 = ((-6.0) * w1_1) - (24.0 * w2_1);
                const double end53_1 = (-6.0) * w1_1;
                if ((least_1 <= b0_c_1)
                    && (b0_c_1 <= most_1)
                    && (least_1 <= b1_1)
                    && (b1_1 <= most_1)
                    && (least_1 <= b2_1)
                    && (b2_1 <= most_1)
                    && (least_1 <= b3_1)
                    && (b3_1 <= most_1)
                    && (least_1 <= b4_1)
                    && (b4_1 <= most_1)
                    && (least_1 <= b5_1)
                    && (b5_1 <= most_1)
                    && (least_1 <= b6_1)
                    && (b6_1 <= most_1)
                    && (-most2_1 <= s0_c_1)
                    && (s0_c_1 <= most2_1)
                    && (-most2_1 <= s1_1)
                    && (s1_1 <= most2_1)
                    && (-most2_1 <= s2_1)
                    && (s2_1 <= most2_1)
                    && (-most2_1 <= s3_1)
                    && (s3_1 <= most2_1)
                    && (-most2_1 <= s4_1)
                    && (s4_1 <= most2_1)
                    && (-most2_1 <= s5_1)
                    && (s5_1 <= most2_1)
                    && (-most2_1 <= s6_1)
                    && (s6_1 <= most2_1)
                    && (-most2_1 <= s7_1)
                    && (s7_1 <= most2_1)
                    && (-most2_1 <= s8_1)
                    && (s8_1 <= most2_1)
                    && (-most3_1 <= v0_c_1)
                    && (v0_c_1 <= most3_1)
                    && (-most3_1 <= v1_1)
                    && (v1_1 <= most3_1)
                    && (-most3_1 <= v2_1)
                    && (v2_1 <= most3_1)
                    && (-most3_1 <= v3_1)
                    && (v3_1 <= most3_1)
                    && (-most3_1 <= v4_1)
                    && (v4_1 <= most3_1)
                    && (-most3_1 <= v5_1)
                    && (v5_1 <= most3_1)
                    && (-most3_1 <= v6_1)
                    && (v6_1 <= most3_1)
                    && (-most3_1 <= v7_1)
                    && (v7_1 <= most3_1)
                    && (least_1 <= end51_1)
                    && (end51_1 <= most_1)
                    && (least_1 <= end52_1)
                    && (end52_1 <= most_1)
                    && (least_1 <= end53_1)
                    && (end53_1 <= most_1)
                    && (fabs((((-0.0027) * w1_1) - (0.006 * w2_1)) - (0.006 * w3_1)) <= most2_1)
                    && (fabs((((-0.0012) * w1_1) - (0.0011999999999999995 * w2_1)) + (8.131516293641283e-19 * w3_1)) <= most2_1)
                    && (fabs(((-0.00029999999999999965) * w1_1) + (8.131516293641283e-19 * w2_1) + (8.131516293641283e-19 * w3_1)) <= most2_1)
                    && (fabs((0.18 * w1_1) + (0.72 * w2_1) + (1.2 * w3_1)) <= most3_1)
                    && (fabs(((0.11999999999999994 * w1_1) + (0.23999999999999982 * w2_1)) - (2.0816681711721685e-16 * w3_1)) <= most3_1)
                    && (fabs((0.06000000000000016 * w1_1) + (4.579669976578771e-16 * w2_1) + (6.245004513516506e-16 * w3_1)) <= most3_1)) {
                    fits = 1U;
                }
                if (fits == 1U) {
                    const double m_2 = (double)tried;
                    const double power1_2 = m_2 + 3.0;
                    const double power2_2 = power1_2 * (m_2 + 2.0);
                    const double power3_2 = power2_2 * (m_2 + 1.0);
                    const double power4_2 = power3_2 * m_2;
                    const double power5_2 = power4_2 * (m_2 - 1.0);
                    const double power6_2 = power5_2 * (m_2 - 2.0);
                    const double scaled2_2 = flat2_2 * power1_2;
                    const double scaled3_2 = flat3_2 * power2_2;
                    const double s24 = (15.0 * flat1_2) + (5.0 * scaled2_2) + (0.5 * scaled3_2);
                    const double w1_2 = s24 / power4_2;
                    const double w2_2 = ((((-24.0) * flat1_2) - (9.0 * scaled2_2)) - scaled3_2) / power5_2;
                    const double s25 = (10.0 * flat1_2) + (4.0 * scaled2_2) + (0.5 * scaled3_2);
                    const double w3_2 = s25 / power6_2;
                    const double length_2 = m_2 - 4.0;
                    const double b0_c_2 = (((-96.0) * w1_2) - (720.0 * w2_2)) - (2880.0 * w3_2);
                    const double b1_c_2 = ((((-24.0) * w1_2) - (420.0 * w2_2)) - (3120.0 * w3_2)) * length_2;
                    const double b2_l_2 = length_2 * length_2;
                    const double b2_c_2 = (((-60.0) * w2_2) - (1080.0 * w3_2)) * b2_l_2;
                    const double b3_l_2 = b2_l_2 * length_2;
                    const double b3_c_2 = (-120.0) * w3_2 * b3_l_2;
                    const double b1_2 = b0_c_2 + (0.14285714285714285 * b1_c_2);
                    const double s26 = b0_c_2 + (0.2857142857142857 * b1_c_2);
                    const double b2_2 = s26 + (0.047619047619047616 * b2_c_2);
                    const double s27 = b0_c_2 + (0.42857142857142855 * b1_c_2);
                    const double s28 = s27 + (0.14285714285714285 * b2_c_2);
                    const double b3_2 = s28 + (0.02857142857142857 * b3_c_2);
                    const double s29 = b0_c_2 + (0.5714285714285714 * b1_c_2);
                    const double s30 = s29 + (0.2857142857142857 * b2_c_2);
                    const double b4_2 = s30 + (0.11428571428571428 * b3_c_2);
                    const double s31 = b0_c_2 + (0.7142857142857143 * b1_c_2);
                    const double s32 = s31 + (0.47619047619047616 * b2_c_2);
                    const double b5_2 = s32 + (0.2857142857142857 * b3_c_2);
                    const double s33 = b0_c_2 + (0.8571428571428571 * b1_c_2);
                    const double s34 = s33 + (0.7142857142857143 * b2_c_2);
                    const double b6_2 = s34 + (0.5714285714285714 * b3_c_2);
                    const double b7_2 = b0_c_2 + b1_c_2 + b2_c_2 + b3_c_2;
                    const double s0_c_2 = (((-0.036) * w1_2) - (0.12 * w2_2)) - (0.252 * w3_2);
                    const double s1_c_2 = ((((-0.0242) * w1_2) - (0.124 * w2_2)) - (0.3954 * w3_2)) * length_2;
                    const double s2_l_2 = length_2 * length_2;
                    const double s2_c_2 = ((((-0.0054) * w1_2) - (0.0475 * w2_2)) - (0.2415 * w3_2)) * s2_l_2;
                    const double s3_l_2 = s2_l_2 * length_2;
                    const double s3_c_2 = ((((-0.0004) * w1_2) - (0.008 * w2_2)) - (0.072 * w3_2)) * s3_l_2;
                    const double s4_l_2 = s3_l_2 * length_2;
                    const double s4_c_2 = (((-0.0005) * w2_2) - (0.0105 * w3_2)) * s4_l_2;
                    const double s5_l_2 = s4_l_2 * length_2;
                    const double s5_c_2 = (-0.0006) * w3_2 * s5_l_2;
                    const double s1_2 = s0_c_2 + (0.1111111111111111 * s1_c_2);
                    const double s35 = s0_c_2 + (0.2222222222222222 * s1_c_2);
                    const double s2_2 = s35 + (0.027777777777777776 * s2_c_2);
                    const double s36 = s0_c_2 + (0.3333333333333333 * s1_c_2);
                    const double s37 = s36 + (0.08333333333333333 * s2_c_2);
                    const double s3_2 = s37 + (0.011904761904761904 * s3_c_2);
                    const double s38 = s0_c_2 + (0.4444444444444444 * s1_c_2);
                    const double s39 = s38 + (0.16666666666666666 * s2_c_2);
                    const double s40 = s39 + (0.047619047619047616 * s3_c_2);
                    const double s4_2 = s40 + (0.007936507936507936 * s4_c_2);
                    const double s41 = s0_c_2 + (0.5555555555555556 * s1_c_2);
                    const double s42 = s41 + (0.2777777777777778 * s2_c_2);
                    const double s43 = s42 + (0.11904761904761904 * s3_c_2);
                    const double s44 = s43 + (0.03968253968253968 * s4_c_2);
                    const double s5_2 = s44 + (0.007936507936507936 * s5_c_2);
                    const double s45 = s0_c_2 + (0.6666666666666666 * s1_c_2);
                    const double s46 = s45 + (0.4166666666666667 * s2_c_2);
                    const double s47 = s46 + (0.23809523809523808 * s3_c_2);
                    const double s48 = s47 + (0.11904761904761904 * s4_c_2);
                    const double s6_2 = s48 + (0.047619047619047616 * s5_c_2);
                    const double s49 = s0_c_2 + (0.7777777777777778 * s1_c_2);
                    const double s50 = s49 + (0.5833333333333334 * s2_c_2);
                    const double s51 = s50 + (0.4166666666666667 * s3_c_2);
                    const double s52 = s51 + (0.2777777777777778 * s4_c_2);
                    const double s7_2 = s52 + (0.16666666666666666 * s5_c_2);
                    const double s53 = s0_c_2 + (0.8888888888888888 * s1_c_2);
                    const double s54 = s53 + (0.7777777777777778 * s2_c_2);
                    const double s55 = s54 + (0.6666666666666666 * s3_c_2);
                    const double s56 = s55 + (0.5555555555555556 * s4_c_2);
                    const double s8_2 = s56 + (0.4444444444444444 * s5_c_2);
                    const double s9_2 = s0_c_2 + s1_c_2 + s2_c_2 + s3_c_2 + s4_c_2 + s5_c_2;
                    const double v0_c_2 = (2.4 * w1_2) + (12.0 * w2_2) + (36.0 * w3_2);
                    const double v1_c_2 = ((1.08 * w1_2) + (9.4 * w2_2) + (46.2 * w3_2)) * length_2;
                    const double v2_l_2 = length_2 * length_2;
                    const double v2_c_2 = ((0.12 * w1_2) + (2.4 * w2_2) + (21.3 * w3_2)) * v2_l_2;
                    const double v3_l_2 = v2_l_2 * length_2;
                    const double v3_c_2 = ((0.2 * w2_2) + (4.2 * w3_2)) * v3_l_2;
                    const double v4_l_2 = v3_l_2 * length_2;
                    const double v4_c_2 = 0.3 * w3_2 * v4_l_2;
                    const double v1_2 = v0_c_2 + (0.125 * v1_c_2);
                    const double v2_2 = v0_c_2 + (0.25 * v1_c_2) + (0.03571428571428571 * v2_c_2);
                    const double s57 = v0_c_2 + (0.375 * v1_c_2) + (0.10714285714285714 * v2_c_2);
                    const double v3_2 = s57 + (0.017857142857142856 * v3_c_2);
                    const double s58 = v0_c_2 + (0.5 * v1_c_2) + (0.21428571428571427 * v2_c_2);
                    const double s59 = s58 + (0.07142857142857142 * v3_c_2);
                    const double v4_2 = s59 + (0.014285714285714285 * v4_c_2);
                    const double s60 = v0_c_2 + (0.625 * v1_c_2) + (0.35714285714285715 * v2_c_2);
                    const double s61 = s60 + (0.17857142857142858 * v3_c_2);
                    const double v5_2 = s61 + (0.07142857142857142 * v4_c_2);
                    const double s62 = v0_c_2 + (0.75 * v1_c_2) + (0.5357142857142857 * v2_c_2);
                    const double s63 = s62 + (0.35714285714285715 * v3_c_2);
                    const double v6_2 = s63 + (0.21428571428571427 * v4_c_2);
                    const double s64 = v0_c_2 + (0.875 * v1_c_2) + (0.75 * v2_c_2) + (0.625 * v3_c_2);
                    const double v7_2 = s64 + (0.5 * v4_c_2);
                    const double v8_2 = v0_c_2 + v1_c_2 + v2_c_2 + v3_c_2 + v4_c_2;
                    const double end61_2 = (((-72.0) * w1_2) - (360.0 * w2_2)) - (720.0 * w3_2);
                    const double end62_2 = ((-48.0) * w1_2) - (120.0 * w2_2);
                    const double end63_2 = (-24.0) * w1_2;
                    if ((least_2 <= b0_c_2)
                        && (b0_c_2 <= most_2)
                        && (least_2 <= b1_2)
                        && (b1_2 <= most_2)
                        && (least_2 <= b2_2)
                        && (b2_2 <= most_2)
                        && (least_2 <= b3_2)
                        && (b3_2 <= most_2)
                        && (least_2 <= b4_2)
                        && (b4_2 <= most_2)
                        && (least_2 <= b5_2)
                        && (b5_2 <= most_2)
                        && (least_2 <= b6_2)
                        && (b6_2 <= most_2)
                        && (least_2 <= b7_2)
                        && (b7_2 <= most_2)
                        && (-most2_2 <= s0_c_2)
                        && (s0_c_2 <= most2_2)
                        && (-most2_2 <= s1_2)
                        && (s1_2 <= most2_2)
                        && (-most2_2 <= s2_2)
                        && (s2_2 <= most2_2)
                        && (-most2_2 <= s3_2)
                        && (s3_2 <= most2_2)
                        && (-most2_2 <= s4_2)
                        && (s4_2 <= most2_2)
                        && (-most2_2 <= s5_2)
                        && (s5_2 <= most2_2)
                        && (-most2_2 <= s6_2)
                        && (s6_2 <= most2_2)
                        && (-most2_2 <= s7_2)
                        && (s7_2 <= most2_2)
                        && (-most2_2 <= s8_2)
                        && (s8_2 <= most2_2)
                        && (-most2_2 <= s9_2)
                        && (s9_2 <= most2_2)
                        && (-most3_2 <= v0_c_2)
                        && (v0_c_2 <= most3_2)
                        && (-most3_2 <= v1_2)
                        && (v1_2 <= most3_2)
                        && (-most3_2 <= v2_2)
                        && (v2_2 <= most3_2)
                        && (-most3_2 <= v3_2)
                        && (v3_2 <= most3_2)
                        && (-most3_2 <= v4_2)
                        && (v4_2 <= most3_2)
                        && (-most3_2 <= v5_2)
                        && (v5_2 <= most3_2)
                        && (-most3_2 <= v6_2)
                        && (v6_2 <= most3_2)
                        && (-most3_2 <= v7_2)
                        && (v7_2 <= most3_2)
                        && (-most3_2 <= v8_2)
                        && (v8_2 <= most3_2)
                        && (least_2 <= end61_2)
                        && (end61_2 <= most_2)
                        && (least_2 <= end62_2)
                        && (end62_2 <= most_2)
                        && (least_2 <= end63_2)
                        && (end63_2 <= most_2)
                        && (fabs((((-0.016800000000000002) * w1_2) - (0.036000000000000004 * w2_2)) - (0.036000000000000004 * w3_2)) <= most2_2)
                        && (fabs((((-0.005999999999999998) * w1_2) - (0.005999999999999997 * w2_2)) + (4.87890977618477e-18 * w3_2)) <= most2_2)
                        && (fabs(((-0.0011999999999999977) * w1_2) + (4.87890977618477e-18 * w2_2) + (4.87890977618477e-18 * w3_2)) <= most2_2)
                        && (fabs((1.44 * w1_2) + (4.8 * w2_2) + (7.2 * w3_2)) <= most3_2)
                        && (fabs(((0.7199999999999996 * w1_2) + (1.199999999999999 * w2_2)) - (1.2490009027033011e-15 * w3_2)) <= most3_2)
                        && (fabs((0.2400000000000011 * w1_2) + (2.914335439641036e-15 * w2_2) + (3.747002708109903e-15 * w3_2)) <= most3_2)) {
                        fits = 2U;
                    }
                }
                if (fits == 2U) {
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
            if (PTC_FINITE_F64(flat1_1)
                && PTC_FINITE_F64(flat2_1)
                && PTC_FINITE_F64(flat3_1)
                && PTC_FINITE_F64(flat1_2)
                && PTC_FINITE_F64(flat2_2)
                && PTC_FINITE_F64(flat3_2)) {
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

ptc_status table_too_soon_deadline(const table_too_soon *self, uint32_t *k)
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (k != NULL)) {
        *k = self->start - (0U - self->last);
        status = PTC_OK;
    }
    return status;
}
