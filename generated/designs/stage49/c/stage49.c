/* Prescribed-time controller stage49: see stage49.h. DO NOT EDIT. */
#include "stage49.h"

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
#define STAGE49_SAMPLES 170U /* samples from the start to rest */

/* Gains of least energy of each state, a row for the samples to go of a node */
static const float stage49_gains[14][4] = {
    {-9986.377f, -348.87903f, -1.9976025f, -2.9924133f},
    {-5777.1006f, -233.30489f, -1.4711981f, -2.0461898f},
    {-3881.3403f, -176.5856f, -1.1873256f, -1.5733153f},
    {-2833.6228f, -142.71356f, -1.005122f, -1.2866975f},
    {-2181.0964f, -120.080894f, -0.8762361f, -1.0928065f},
    {-1018.34033f, -74.13646f, -0.5902821f, -0.6911077f},
    {-599.1994f, -53.811737f, -0.4494777f, -0.50864094f},
    {-281.46225f, -34.714703f, -0.30574974f, -0.33338922f},
    {-162.40263f, -25.523401f, -0.23148729f, -0.2473471f},
    {-72.591675f, -16.511925f, -0.15463428f, -0.16164158f},
    {-10.503921f, -5.7482643f, -0.0560507f, -0.0570108f},
    {-2.4759388f, -3.1387978f, -0.031095704f, -0.03129342f},
    {-0.2871313f, -1.8002806f, -0.018005349f, -0.018005254f},
    {-0.12725501f, -0.7570639f, -0.0075707315f, -0.007571343f},
};
ptc_status stage49_init(stage49 *self, const stage49_params *params)
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

ptc_status stage49_arm(stage49 *self, uint32_t k)
{
    ptc_status status = PTC_OK;

    self->start = k;
    status = PTC_OK;
    return status;
}

ptc_status stage49_step(stage49 *self, uint32_t k, const float x[2], float *u)
{
    ptc_status status = PTC_OK;

    *u = 0.0f;
    const uint32_t elapsed = k - self->start;
    const float x1 = x[0];
    const float x2 = x[1];
    const uint32_t left = (elapsed < STAGE49_SAMPLES) ? (STAGE49_SAMPLES - elapsed) : 0U;
    uint32_t to_go;
    if (left > 4U) {
        to_go = left;
    } else {
        to_go = 4U;
    }

    /* Its place between the nodes of the table. */
    uint32_t row;
    float part;
    if (to_go < 8U) {
        row = to_go - 4U;
        part = 0.0f;
    } else if (to_go < 16U) {
        row = (to_go / 4U) + 2U;
        part = (0.25f * ((float)to_go)) - ((float)(to_go / 4U));
    } else if (to_go < 32U) {
        row = (to_go / 8U) + 4U;
        part = (0.125f * ((float)to_go)) - ((float)(to_go / 8U));
    } else if (to_go < 64U) {
        row = (to_go / 16U) + 6U;
        part = (0.0625f * ((float)to_go)) - ((float)(to_go / 16U));
    } else if (to_go < 128U) {
        row = (to_go / 32U) + 8U;
        part = (0.03125f * ((float)to_go)) - ((float)(to_go / 32U));
    } else {
        row = (to_go / 64U) + 10U;
        part = (0.015625f * ((float)to_go)) - ((float)(to_go / 64U));
    }

    /* The law of least energy. */
    const uint32_t above = row + 1U;
    float v;
    const float s1 = part * (stage49_gains[above][0] - stage49_gains[row][0]);
    const float s2 = part * (stage49_gains[above][1] - stage49_gains[row][1]);
    const float s3 = (stage49_gains[row][0] + s1) * x1;
    const float s4 = part * (stage49_gains[above][2] - stage49_gains[row][2]);
    const float s5 = (stage49_gains[row][2] + s4) * self->u1;
    const float s6 = part * (stage49_gains[above][3] - stage49_gains[row][3]);
    const float s7 = s3 + ((stage49_gains[row][1] + s2) * x2) + s5;
    v = s7 + ((stage49_gains[row][3] + s6) * self->u2);
    status = PTC_E_RANGE;
    if (PTC_FINITE_F32(v)) {
        float u_now;
        if (elapsed < STAGE49_SAMPLES) {
            if (v > self->u_max) {
                u_now = self->u_max;
            } else if (v < -self->u_max) {
                u_now = -self->u_max;
            } else {
                u_now = v;
            }
        } else {
            u_now = 0.0f;
        }
        self->u2 = self->u1;
        self->u1 = u_now;
        *u = u_now;
        if (elapsed < STAGE49_SAMPLES) {
            if ((v > self->u_max) || (v < -self->u_max)) {
                status = PTC_SATURATED;
            } else {
                status = PTC_OK;
            }
        } else {
            status = PTC_AFTER;
        }
    }
    return status;
}
