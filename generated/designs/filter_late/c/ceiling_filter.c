/* Prescribed-time filter ceiling_filter: see ceiling_filter.h. DO NOT EDIT. */
#include "ceiling_filter.h"

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

/* Numbers of the design, each rounded once. */
#define CEILING_FILTER_S1_1 (-0.5f) /* -1/2, weight of x1 in the law */
#define CEILING_FILTER_S1_2 (-0.0025f) /* -1/400, weight of x2 in the law */
#define CEILING_FILTER_S1_3 2.0833334e-6f /* 1/480000, weight of x3 in the law */
#define CEILING_FILTER_S1_5 (-6.25e-8f) /* -1/16000000, weight of u2 in the law */
#define CEILING_FILTER_S2_2 (-0.5f) /* -1/2, weight of x2 in the law */
#define CEILING_FILTER_S2_3 (-0.005f) /* -1/200, weight of x3 in the law */
#define CEILING_FILTER_S2_5 3.75e-5f /* 3/80000, weight of u2 in the law */
#define CEILING_FILTER_S3_3 (-0.5f) /* -1/2, weight of x3 in the law */
#define CEILING_FILTER_S3_4 0.01f /* 1/100, weight of u1 in the law */
#define CEILING_FILTER_S3_5 0.005f /* 1/200, weight of u2 in the law */

ptc_status ceiling_filter_init(ceiling_filter *self, const ceiling_filter_params *params)
{
    ptc_status status = PTC_E_PARAM;

    if ((self != NULL) && (params != NULL)) {
        if (params->u_max > 0.0f) {
            const float u_max = params->u_max;
            self->start = 0U;
            self->u1 = 0.0f;
            self->u2 = 0.0f;
            self->u_max = u_max;
            status = PTC_OK;
        }
    }
    return status;
}

ptc_status ceiling_filter_arm(ceiling_filter *self, uint32_t k)
{
    ptc_status status = PTC_E_INPUT;

    if (self != NULL) {
        self->start = k;
        status = PTC_OK;
    }
    return status;
}

ptc_status ceiling_filter_step(
    ceiling_filter *self,
    uint32_t k,
    const float x[3],
    float u_nominal,
    float *u)
{
    ptc_status status = PTC_E_INPUT;

    if (u != NULL) {
        *u = 0.0f;
    }
    if ((self != NULL) && (x != NULL) && (u != NULL)) {
        if (PTC_FINITE_F32(x[0])
            && PTC_FINITE_F32(x[1])
            && PTC_FINITE_F32(x[2])
            && PTC_FINITE_F32(u_nominal)) {
            const float x1 = x[0];
            const float x2 = x[1];
            const float x3 = x[2];
            const float s1 = (CEILING_FILTER_S1_1 * x1) + (CEILING_FILTER_S1_2 * x2) + (CEILING_FILTER_S1_3 * x3);
            const float z1 = s1 + (CEILING_FILTER_S1_5 * (self->u2 - 0.25f));
            const float s2 = (CEILING_FILTER_S2_2 * x2) + (CEILING_FILTER_S2_3 * x3);
            const float z2 = s2 + (CEILING_FILTER_S2_5 * (self->u2 - 0.25f));
            const float s3 = (CEILING_FILTER_S3_3 * x3) + (CEILING_FILTER_S3_4 * (self->u1 - 0.25f));
            const float z3 = s3 + (CEILING_FILTER_S3_5 * (self->u2 - 0.25f));

            /* The limits of u that keep a safe state safe. */
            const float q1_1 = z2 + (2.9554467f * z1);
            const float q1_2 = z3 + (7.8325043f * z2) + (14.413883f * z1);
            const float q1_3 = (15.520869f * z3) + (74.63303f * z2) + (110.8192f * z1);
            float low1 = (-55.1596f) - q1_3;
            uint32_t since = self->start;
            uint32_t safe = 1U;
            if ((z1 >= -0.5005f) && (q1_1 >= -1.4792011f) && (q1_2 >= -7.2141485f)) {
                since = k;
            } else {
                safe = 0U;

                /* Outside: u is held to the law of return too. */
                const float left = (float)(((k - since) < 98U) ? (98U - (k - since)) : 0U);
                const float t1 = (left < 3.0f) ? 3.0f : left;
                const float s4 = ((((-120000000.0f) * z1) / (t1 + 3.0f)) - (600000.0f * z2)) / (t1 + 2.0f);
                const float law1 = ((s4 - (1200.0f * z3)) / (t1 + 1.0f)) + 0.25f;
                const float weight1 = (((-120000000.0f) / (t1 + 3.0f)) / (t1 + 2.0f)) / (t1 + 1.0f);
                const float low1_back = law1 - ((-0.5f) * weight1);
                if (low1 < low1_back) {
                    low1 = low1_back;
                }
            }

            /* u within them, the bounds of x1 last. */
            float u_now = u_nominal;
            if (u_now < low1) {
                u_now = low1;
            }
            if (u_now > self->u_max) {
                u_now = self->u_max;
            }
            if (u_now < -self->u_max) {
                u_now = -self->u_max;
            }
            status = PTC_E_RANGE;
            if (PTC_FINITE_F32(u_now) && PTC_FINITE_F32(low1)) {
                self->u2 = self->u1;
                self->u1 = u_now;
                self->start = since;
                *u = u_now;
                if ((safe == 0U) || (u_now < low1 - 0.0554096f)) {
                    status = PTC_INFEASIBLE;
                } else if ((u_now < u_nominal) || (u_nominal < u_now)) {
                    status = PTC_SATURATED;
                } else {
                    status = PTC_OK;
                }
            }
        }
    }
    return status;
}
