/* Prescribed-time controller stage50: see stage50.h. DO NOT EDIT. */
#include "stage50.h"

#include <float.h>
#include <math.h>
#include <stddef.h>

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
#define STAGE50_SAMPLES 20U /* samples from the start to rest */

/* Gains of least energy of each state, a row for the samples to go of a node */
static const double stage50_gains[20][2] = {
    {-6519.426971737549, 3185.2084972182897},
    {-3857.2972468681514, 1869.370005740587},
    {-2535.8123523502322, 1218.7874484331383},
    {-1786.1499004408652, 851.2162504195531},
    {-1321.0288432240525, 624.1015587650261},
    {-1013.2253140462395, 474.4353779733671},
    {-799.355679292144, 370.8885689114117},
    {-644.9715751559836, 296.46788779068544},
    {-530.0507637726341, 241.31624608777554},
    {-442.31657026726884, 199.40198143585195},
    {-373.9055837746926, 166.86960699606502},
    {-319.59468864669316, 141.16347188259604},
    {-275.80616425447823, 120.53665432938753},
    {-240.02385825378445, 103.76315424562416},
    {-210.4372644374064, 89.96267023338274},
    {-185.7172734991974, 78.4903488691879},
    {-164.8707644351536, 68.86539241539502},
    {-147.1439010804336, 60.72364441333584},
    {-131.95635856841344, 53.785384714229195},
    {-118.85567957234355, 47.83301161237331},
};
ptc_status stage50_init(stage50 *self, const stage50_params *params)
{
    ptc_status status = PTC_E_PARAM;

    if ((self != NULL) && (params != NULL)) {
        if (params->u_max > 0.0) {
            const double u_max = params->u_max;
            self->start = 0U;
            self->u_max = u_max;
            status = PTC_OK;
        }
    }
    return status;
}

ptc_status stage50_arm(stage50 *self, uint32_t k)
{
    ptc_status status = PTC_E_INPUT;

    if (self != NULL) {
        self->start = k;
        status = PTC_OK;
    }
    return status;
}

ptc_status stage50_step(
    const stage50 *self,
    uint32_t k,
    const double x[2],
    const double r[3],
    double *u)
{
    ptc_status status = PTC_E_INPUT;

    if (u != NULL) {
        *u = 0.0;
    }
    if ((self != NULL) && (x != NULL) && (r != NULL) && (u != NULL)) {
        if (PTC_FINITE_F64(x[0])
            && PTC_FINITE_F64(x[1])
            && PTC_FINITE_F64(r[0])
            && PTC_FINITE_F64(r[1])
            && PTC_FINITE_F64(r[2])) {
            const uint32_t elapsed = k - self->start;
            const double x1 = x[0];
            const double x2 = x[1];

            /* The tracking error. */
            const double s1 = (0.3333333333333333 * r[0]) - (0.9983333333333333 * r[1]);
            const double u_r = s1 - (0.3383277777777778 * r[2]);
            const double e1 = x1 - (((-1.3333333333333333) * r[0]) - (0.3333333333333333 * r[1]));
            const double e2 = x2 - (((-1.6666666666666667) * r[0]) - (0.6666666666666666 * r[1]));
            const uint32_t left = (elapsed < STAGE50_SAMPLES) ? (STAGE50_SAMPLES - elapsed) : 0U;
            uint32_t to_go;
            if (left > 2U) {
                to_go = left;
            } else {
                to_go = 2U;
            }
            const uint32_t row = to_go - 2U;

            /* The law of least energy. */
            double v;
            v = (stage50_gains[row][0] * e1) + (stage50_gains[row][1] * e2) + u_r;
            if (PTC_FINITE_F64(v)) {
                if (v > self->u_max) {
                    *u = self->u_max;
                    status = PTC_SATURATED;
                } else if (v < -self->u_max) {
                    *u = -self->u_max;
                    status = PTC_SATURATED;
                } else if (elapsed < STAGE50_SAMPLES) {
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
