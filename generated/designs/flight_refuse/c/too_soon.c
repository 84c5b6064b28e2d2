/* Prescribed-time controller too_soon: see too_soon.h. DO NOT EDIT. */
#include "too_soon.h"

#include <float.h>
#include <math.h>
#include <stddef.h>
#include <stdint.h>

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

/* Numbers of the design, each rounded once. */
#define TOO_SOON_W1_1 (-120000000.0f) /* weight of x1 in the law */
#define TOO_SOON_W1_2 1200000.0f /* weight of x2 in the law */
#define TOO_SOON_W1_3 (-4000.0f) /* weight of x3 in the law */
#define TOO_SOON_W2_2 (-600000.0f) /* weight of x2 in the law */
#define TOO_SOON_W2_3 3000.0f /* weight of x3 in the law */
#define TOO_SOON_W3_3 (-1200.0f) /* weight of x3 in the law */
#define TOO_SOON_U_MAX 20.0f /* bound of |u| */
#define TOO_SOON_S1_1 1000000.0f /* weight of x1 in the law */
#define TOO_SOON_S1_2 (-10000.0f) /* weight of x2 in the law */
#define TOO_SOON_S1_3 33.333332f /* 100/3, weight of x3 in the law */
#define TOO_SOON_S2_2 10000.0f /* weight of x2 in the law */
#define TOO_SOON_S2_3 (-50.0f) /* weight of x3 in the law */
#define TOO_SOON_S3_3 100.0f /* weight of x3 in the law */

ptc_status too_soon_init(too_soon *self, const too_soon_params *params)
{
    ptc_status status = PTC_E_PARAM;

    (void)params;
    if (self != NULL) {
        self->start = 0U;
        self->last = 150U;
        status = PTC_OK;
    }
    return status;
}

ptc_status too_soon_arm(too_soon *self, uint32_t k)
{
    ptc_status status = PTC_E_INPUT;

    if (self != NULL) {
        self->start = k;
        self->last = 150U;
        status = PTC_OK;
    }
    return status;
}

ptc_status too_soon_step(const too_soon *self, uint32_t k, const float x[3], float *u)
{
    ptc_status status = PTC_E_INPUT;

    if (u != NULL) {
        *u = 0.0f;
    }
    if ((self != NULL) && (x != NULL) && (u != NULL)) {
        if (PTC_FINITE_F32(x[0]) && PTC_FINITE_F32(x[1]) && PTC_FINITE_F32(x[2])) {
            const uint32_t elapsed = k - self->start;
            const float x1 = x[0];
            const float x2 = x[1];
            const float x3 = x[2];
            const uint32_t left = (elapsed < self->last) ? (self->last - elapsed) : 0U;
            const float m0 = ((float)left < 3.0f) ? 3.0f : (float)left;
            float v;

            /* The exact law in samples. */
            const float z1 = (TOO_SOON_W1_1 * x1) + (TOO_SOON_W1_2 * x2) + (TOO_SOON_W1_3 * x3);
            const float z2 = (TOO_SOON_W2_2 * x2) + (TOO_SOON_W2_3 * x3);
            const float z3 = TOO_SOON_W3_3 * x3;
            const float m0f1 = m0 + 3.0f;
            const float m0f2 = m0f1 * (m0 + 2.0f);
            v = (z1 + (z2 * m0f1) + (z3 * m0f2)) / (m0f2 * (m0 + 1.0f));
            if (PTC_FINITE_F32(v)) {
                if (v > TOO_SOON_U_MAX) {
                    *u = TOO_SOON_U_MAX;
                    status = PTC_SATURATED;
                } else if (v < -TOO_SOON_U_MAX) {
                    *u = -TOO_SOON_U_MAX;
                    status = PTC_SATURATED;
                } else if (elapsed < self->last) {
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

ptc_status too_soon_arm_for(too_soon *self, uint32_t k, uint32_t samples, const float x[3])
{
    ptc_status status = PTC_E_PARAM;

    if ((self != NULL) && (x != NULL)) {
        if ((samples > 2U) && (samples < 2147483649U)) {
            status = PTC_E_INPUT;
            if (PTC_FINITE_F32(x[0]) && PTC_FINITE_F32(x[1]) && PTC_FINITE_F32(x[2])) {
                const float x1 = x[0];
                const float x2 = x[1];
                const float x3 = x[2];
                const float flat1 = (TOO_SOON_S1_1 * x1) + (TOO_SOON_S1_2 * x2) + (TOO_SOON_S1_3 * x3);
                const float flat2 = (TOO_SOON_S2_2 * x2) + (TOO_SOON_S2_3 * x3);
                const float flat3 = TOO_SOON_S3_3 * x3;
                const float least = 0.9949459f * (-TOO_SOON_U_MAX);
                const float most = 0.9949459f * TOO_SOON_U_MAX;
                const float most2 = 0.49747294f;
                const float most3 = 3.9797835f;
                const uint32_t tried = samples;
                uint32_t fits = 0U;
                const float m = (float)tried;
                const float power1 = m + 3.0f;
                const float power2 = power1 * (m + 2.0f);
                const float power3 = power2 * (m + 1.0f);
                const float power4 = power3 * m;
                const float power5 = power4 * (m - 1.0f);
                const float power6 = power5 * (m - 2.0f);
                const float scaled2 = flat2 * power1;
                const float scaled3 = flat3 * power2;
                const float w1 = ((15.0f * flat1) + (5.0f * scaled2) + (0.5f * scaled3)) / power4;
                const float w2 = ((((-24.0f) * flat1) - (9.0f * scaled2)) - scaled3) / power5;
                const float w3 = ((10.0f * flat1) + (4.0f * scaled2) + (0.5f * scaled3)) / power6;
                const float length = m - 4.0f;
                const float b0_c = (((-96.0f) * w1) - (720.0f * w2)) - (2880.0f * w3);
                const float b1_c = ((((-24.0f) * w1) - (420.0f * w2)) - (3120.0f * w3)) * length;
                const float b2_l = length * length;
                const float b2_c = (((-60.0f) * w2) - (1080.0f * w3)) * b2_l;
                const float b3_l = b2_l * length;
                const float b3_c = (-120.0f) * w3 * b3_l;
                const float b1 = b0_c + (0.14285715f * b1_c);
                const float b2 = b0_c + (0.2857143f * b1_c) + (0.04761905f * b2_c);
                const float s10 = b0_c + (0.42857143f * b1_c) + (0.14285715f * b2_c);
                const float b3 = s10 + (0.028571429f * b3_c);
                const float s11 = b0_c + (0.5714286f * b1_c) + (0.2857143f * b2_c);
                const float b4 = s11 + (0.114285715f * b3_c);
                const float s12 = b0_c + (0.71428573f * b1_c) + (0.47619048f * b2_c);
                const float b5 = s12 + (0.2857143f * b3_c);
                const float s13 = b0_c + (0.85714287f * b1_c) + (0.71428573f * b2_c);
                const float b6 = s13 + (0.5714286f * b3_c);
                const float b7 = b0_c + b1_c + b2_c + b3_c;
                const float s0_c = (((-0.036f) * w1) - (0.12f * w2)) - (0.252f * w3);
                const float s1_c = ((((-0.0242f) * w1) - (0.124f * w2)) - (0.3954f * w3)) * length;
                const float s2_l = length * length;
                const float s2_c = ((((-0.0054f) * w1) - (0.0475f * w2)) - (0.2415f * w3)) * s2_l;
                const float s3_l = s2_l * length;
                const float s3_c = ((((-0.0004f) * w1) - (0.008f * w2)) - (0.072f * w3)) * s3_l;
                const float s4_l = s3_l * length;
                const float s4_c = (((-0.0005f) * w2) - (0.0105f * w3)) * s4_l;
                const float s5_l = s4_l * length;
                const float s5_c = (-0.0006f) * w3 * s5_l;
                const float s1 = s0_c + (0.11111111f * s1_c);
                const float s2 = s0_c + (0.22222222f * s1_c) + (0.027777778f * s2_c);
                const float s14 = s0_c + (0.33333334f * s1_c) + (0.083333336f * s2_c);
                const float s3 = s14 + (0.011904762f * s3_c);
                const float s15 = s0_c + (0.44444445f * s1_c) + (0.16666667f * s2_c);
                const float s4 = s15 + (0.04761905f * s3_c) + (0.007936508f * s4_c);
                const float s16 = s0_c + (0.5555556f * s1_c) + (0.2777778f * s2_c);
                const float s17 = s16 + (0.11904762f * s3_c) + (0.03968254f * s4_c);
                const float s5 = s17 + (0.007936508f * s5_c);
                const float s18 = s0_c + (0.6666667f * s1_c) + (0.41666666f * s2_c);
                const float s19 = s18 + (0.23809524f * s3_c) + (0.11904762f * s4_c);
                const float s6 = s19 + (0.04761905f * s5_c);
                const float s20 = s0_c + (0.7777778f * s1_c) + (0.5833333f * s2_c);
                const float s21 = s20 + (0.41666666f * s3_c) + (0.2777778f * s4_c);
                const float s7 = s21 + (0.16666667f * s5_c);
                const float s22 = s0_c + (0.8888889f * s1_c) + (0.7777778f * s2_c);
                const float s23 = s22 + (0.6666667f * s3_c) + (0.5555556f * s4_c);
                const float s8 = s23 + (0.44444445f * s5_c);
                const float s9 = s0_c + s1_c + s2_c + s3_c + s4_c + s5_c;
                const float v0_c = (2.4f * w1) + (12.0f * w2) + (36.0f * w3);
                const float v1_c = ((1.08f * w1) + (9.4f * w2) + (46.2f * w3)) * length;
                const float v2_l = length * length;
                const float v2_c = ((0.12f * w1) + (2.4f * w2) + (21.3f * w3)) * v2_l;
                const float v3_l = v2_l * length;
                const float v3_c = ((0.2f * w2) + (4.2f * w3)) * v3_l;
                const float v4_l = v3_l * length;
                const float v4_c = 0.3f * w3 * v4_l;
                const float v1 = v0_c + (0.125f * v1_c);
                const float v2 = v0_c + (0.25f * v1_c) + (0.035714287f * v2_c);
                const float s24 = v0_c + (0.375f * v1_c) + (0.10714286f * v2_c);
                const float v3 = s24 + (0.017857144f * v3_c);
                const float s25 = v0_c + (0.5f * v1_c) + (0.21428572f * v2_c) + (0.071428575f * v3_c);
                const float v4 = s25 + (0.014285714f * v4_c);
                const float s26 = v0_c + (0.625f * v1_c) + (0.35714287f * v2_c) + (0.17857143f * v3_c);
                const float v5 = s26 + (0.071428575f * v4_c);
                const float s27 = v0_c + (0.75f * v1_c) + (0.53571427f * v2_c) + (0.35714287f * v3_c);
                const float v6 = s27 + (0.21428572f * v4_c);
                const float s28 = v0_c + (0.875f * v1_c) + (0.75f * v2_c) + (0.625f * v3_c);
                const float v7 = s28 + (0.5f * v4_c);
                const float v8 = v0_c + v1_c + v2_c + v3_c + v4_c;
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
                    && (-most2 <= s0_c)
                    && (s0_c <= most2)
                    && (-most2 <= s1)
                    && (s1 <= most2)
                    && (-most2 <= s2)
                    && (s2 <= most2)
                    && (-most2 <= s3)
                    && (s3 <= most2)
                    && (-most2 <= s4)
                    && (s4 <= most2)
                    && (-most2 <= s5)
                    && (s5 <= most2)
                    && (-most2 <= s6)
                    && (s6 <= most2)
                    && (-most2 <= s7)
                    && (s7 <= most2)
                    && (-most2 <= s8)
                    && (s8 <= most2)
                    && (-most2 <= s9)
                    && (s9 <= most2)
                    && (-most3 <= v0_c)
                    && (v0_c <= most3)
                    && (-most3 <= v1)
                    && (v1 <= most3)
                    && (-most3 <= v2)
                    && (v2 <= most3)
                    && (-most3 <= v3)
                    && (v3 <= most3)
                    && (-most3 <= v4)
                    && (v4 <= most3)
                    && (-most3 <= v5)
                    && (v5 <= most3)
                    && (-most3 <= v6)
                    && (v6 <= most3)
                    && (-most3 <= v7)
                    && (v7 <= most3)
                    && (-most3 <= v8)
                    && (v8 <= most3)
                    && (fabsf((((-72.0f) * w1) - (360.0f * w2)) - (720.0f * w3)) <= most)
                    && (fabsf(((-48.0f) * w1) - (120.0f * w2)) <= most)
                    && (fabsf((-24.0f) * w1) <= most)
                    && (fabsf((((-0.0168f) * w1) - (0.036f * w2)) - (0.036f * w3)) <= most2)
                    && (fabsf((((-0.006f) * w1) - (0.006f * w2)) + (4.8789098e-18f * w3)) <= most2)
                    && (fabsf(((-0.0012f) * w1) + (4.8789098e-18f * w2) + (4.8789098e-18f * w3)) <= most2)
                    && (fabsf((1.44f * w1) + (4.8f * w2) + (7.2f * w3)) <= most3)
                    && (fabsf(((0.72f * w1) + (1.2f * w2)) - (1.2490009e-15f * w3)) <= most3)
                    && (fabsf((0.24f * w1) + (2.9143354e-15f * w2) + (3.7470027e-15f * w3)) <= most3)) {
                    fits = 1U;
                }
                status = PTC_E_SOON;
                if ((tried > 3U) && (tried < 100001U) && (fits == 1U)) {
                    self->start = k;
                    self->last = samples;
                    status = PTC_OK;
                }
            }
        }
    }
    return status;
}

ptc_status too_soon_soonest(const too_soon *self, const float x[3], uint32_t *samples)
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (x != NULL) && (samples != NULL)) {
        if (PTC_FINITE_F32(x[0]) && PTC_FINITE_F32(x[1]) && PTC_FINITE_F32(x[2])) {
            const float x1 = x[0];
            const float x2 = x[1];
            const float x3 = x[2];
            const float flat1 = (TOO_SOON_S1_1 * x1) + (TOO_SOON_S1_2 * x2) + (TOO_SOON_S1_3 * x3);
            const float flat2 = (TOO_SOON_S2_2 * x2) + (TOO_SOON_S2_3 * x3);
            const float flat3 = TOO_SOON_S3_3 * x3;
            uint32_t low = 3U;
            uint32_t top = 100001U;
            uint32_t kept = 0U;
            uint32_t tried = 4U;
            for (uint32_t attempt = 0U; attempt < 64U; attempt++) {
                const float least = 0.9949459f * (-TOO_SOON_U_MAX);
                const float most = 0.9949459f * TOO_SOON_U_MAX;
                const float most2 = 0.49747294f;
                const float most3 = 3.9797835f;
                uint32_t fits = 0U;
                const float m = (float)tried;
                const float power1 = m + 3.0f;
                const float power2 = power1 * (m + 2.0f);
                const float power3 = power2 * (m + 1.0f);
                const float power4 = power3 * m;
                const float power5 = power4 * (m - 1.0f);
                const float power6 = power5 * (m - 2.0f);
                const float scaled2 = flat2 * power1;
                const float scaled3 = flat3 * power2;
                const float w1 = ((15.0f * flat1) + (5.0f * scaled2) + (0.5f * scaled3)) / power4;
                const float w2 = ((((-24.0f) * flat1) - (9.0f * scaled2)) - scaled3) / power5;
                const float w3 = ((10.0f * flat1) + (4.0f * scaled2) + (0.5f * scaled3)) / power6;
                const float length = m - 4.0f;
                const float b0_c = (((-96.0f) * w1) - (720.0f * w2)) - (2880.0f * w3);
                const float b1_c = ((((-24.0f) * w1) - (420.0f * w2)) - (3120.0f * w3)) * length;
                const float b2_l = length * length;
                const float b2_c = (((-60.0f) * w2) - (1080.0f * w3)) * b2_l;
                const float b3_l = b2_l * length;
                const float b3_c = (-120.0f) * w3 * b3_l;
                const float b1 = b0_c + (0.14285715f * b1_c);
                const float b2 = b0_c + (0.2857143f * b1_c) + (0.04761905f * b2_c);
                const float s10 = b0_c + (0.42857143f * b1_c) + (0.14285715f * b2_c);
                const float b3 = s10 + (0.028571429f * b3_c);
                const float s11 = b0_c + (0.5714286f * b1_c) + (0.2857143f * b2_c);
                const float b4 = s11 + (0.114285715f * b3_c);
                const float s12 = b0_c + (0.71428573f * b1_c) + (0.47619048f * b2_c);
                const float b5 = s12 + (0.2857143f * b3_c);
                const float s13 = b0_c + (0.85714287f * b1_c) + (0.71428573f * b2_c);
                const float b6 = s13 + (0.5714286f * b3_c);
                const float b7 = b0_c + b1_c + b2_c + b3_c;
                const float s0_c = (((-0.036f) * w1) - (0.12f * w2)) - (0.252f * w3);
                const float s1_c = ((((-0.0242f) * w1) - (0.124f * w2)) - (0.3954f * w3)) * length;
                const float s2_l = length * length;
                const float s2_c = ((((-0.0054f) * w1) - (0.0475f * w2)) - (0.2415f * w3)) * s2_l;
                const float s3_l = s2_l * length;
                const float s3_c = ((((-0.0004f) * w1) - (0.008f * w2)) - (0.072f * w3)) * s3_l;
                const float s4_l = s3_l * length;
                const float s4_c = (((-0.0005f) * w2) - (0.0105f * w3)) * s4_l;
                const float s5_l = s4_l * length;
                const float s5_c = (-0.0006f) * w3 * s5_l;
                const float s1 = s0_c + (0.11111111f * s1_c);
                const float s2 = s0_c + (0.22222222f * s1_c) + (0.027777778f * s2_c);
                const float s14 = s0_c + (0.33333334f * s1_c) + (0.083333336f * s2_c);
                const float s3 = s14 + (0.011904762f * s3_c);
                const float s15 = s0_c + (0.44444445f * s1_c) + (0.16666667f * s2_c);
                const float s4 = s15 + (0.04761905f * s3_c) + (0.007936508f * s4_c);
                const float s16 = s0_c + (0.5555556f * s1_c) + (0.2777778f * s2_c);
                const float s17 = s16 + (0.11904762f * s3_c) + (0.03968254f * s4_c);
                const float s5 = s17 + (0.007936508f * s5_c);
                const float s18 = s0_c + (0.6666667f * s1_c) + (0.41666666f * s2_c);
                const float s19 = s18 + (0.23809524f * s3_c) + (0.11904762f * s4_c);
                const float s6 = s19 + (0.04761905f * s5_c);
                const float s20 = s0_c + (0.7777778f * s1_c) + (0.5833333f * s2_c);
                const float s21 = s20 + (0.41666666f * s3_c) + (0.2777778f * s4_c);
                const float s7 = s21 + (0.16666667f * s5_c);
                const float s22 = s0_c + (0.8888889f * s1_c) + (0.7777778f * s2_c);
                const float s23 = s22 + (0.6666667f * s3_c) + (0.5555556f * s4_c);
                const float s8 = s23 + (0.44444445f * s5_c);
                const float s9 = s0_c + s1_c + s2_c + s3_c + s4_c + s5_c;
                const float v0_c = (2.4f * w1) + (12.0f * w2) + (36.0f * w3);
                const float v1_c = ((1.08f * w1) + (9.4f * w2) + (46.2f * w3)) * length;
                const float v2_l = length * length;
                const float v2_c = ((0.12f * w1) + (2.4f * w2) + (21.3f * w3)) * v2_l;
                const float v3_l = v2_l * length;
                const float v3_c = ((0.2f * w2) + (4.2f * w3)) * v3_l;
                const float v4_l = v3_l * length;
                const float v4_c = 0.3f * w3 * v4_l;
                const float v1 = v0_c + (0.125f * v1_c);
                const float v2 = v0_c + (0.25f * v1_c) + (0.035714287f * v2_c);
                const float s24 = v0_c + (0.375f * v1_c) + (0.10714286f * v2_c);
                const float v3 = s24 + (0.017857144f * v3_c);
                const float s25 = v0_c + (0.5f * v1_c) + (0.21428572f * v2_c) + (0.071428575f * v3_c);
                const float v4 = s25 + (0.014285714f * v4_c);
                const float s26 = v0_c + (0.625f * v1_c) + (0.35714287f * v2_c) + (0.17857143f * v3_c);
                const float v5 = s26 + (0.071428575f * v4_c);
                const float s27 = v0_c + (0.75f * v1_c) + (0.53571427f * v2_c) + (0.35714287f * v3_c);
                const float v6 = s27 + (0.21428572f * v4_c);
                const float s28 = v0_c + (0.875f * v1_c) + (0.75f * v2_c) + (0.625f * v3_c);
                const float v7 = s28 + (0.5f * v4_c);
                const float v8 = v0_c + v1_c + v2_c + v3_c + v4_c;
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
                    && (-most2 <= s0_c)
                    && (s0_c <= most2)
                    && (-most2 <= s1)
                    && (s1 <= most2)
                    && (-most2 <= s2)
                    && (s2 <= most2)
                    && (-most2 <= s3)
                    && (s3 <= most2)
                    && (-most2 <= s4)
                    && (s4 <= most2)
                    && (-most2 <= s5)
                    && (s5 <= most2)
                    && (-most2 <= s6)
                    && (s6 <= most2)
                    && (-most2 <= s7)
                    && (s7 <= most2)
                    && (-most2 <= s8)
                    && (s8 <= most2)
                    && (-most2 <= s9)
                    && (s9 <= most2)
                    && (-most3 <= v0_c)
                    && (v0_c <= most3)
                    && (-most3 <= v1)
                    && (v1 <= most3)
                    && (-most3 <= v2)
                    && (v2 <= most3)
                    && (-most3 <= v3)
                    && (v3 <= most3)
                    && (-most3 <= v4)
                    && (v4 <= most3)
                    && (-most3 <= v5)
                    && (v5 <= most3)
                    && (-most3 <= v6)
                    && (v6 <= most3)
                    && (-most3 <= v7)
                    && (v7 <= most3)
                    && (-most3 <= v8)
                    && (v8 <= most3)
                    && (fabsf((((-72.0f) * w1) - (360.0f * w2)) - (720.0f * w3)) <= most)
                    && (fabsf(((-48.0f) * w1) - (120.0f * w2)) <= most)
                    && (fabsf((-24.0f) * w1) <= most)
                    && (fabsf((((-0.0168f) * w1) - (0.036f * w2)) - (0.036f * w3)) <= most2)
                    && (fabsf((((-0.006f) * w1) - (0.006f * w2)) + (4.8789098e-18f * w3)) <= most2)
                    && (fabsf(((-0.0012f) * w1) + (4.8789098e-18f * w2) + (4.8789098e-18f * w3)) <= most2)
                    && (fabsf((1.44f * w1) + (4.8f * w2) + (7.2f * w3)) <= most3)
                    && (fabsf(((0.72f * w1) + (1.2f * w2)) - (1.2490009e-15f * w3)) <= most3)
                    && (fabsf((0.24f * w1) + (2.9143354e-15f * w2) + (3.7470027e-15f * w3)) <= most3)) {
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
            if (PTC_FINITE_F32(flat1) && PTC_FINITE_F32(flat2) && PTC_FINITE_F32(flat3)) {
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

ptc_status too_soon_deadline(const too_soon *self, uint32_t *k)
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (k != NULL)) {
        *k = self->start - (0U - self->last);
        status = PTC_OK;
    }
    return status;
}
