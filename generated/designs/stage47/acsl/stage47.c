/* Prescribed-time controller stage47: see stage47.h. DO NOT EDIT. */
#include "stage47.h"

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

ptc_status stage47_init(stage47 *self, const stage47_params *params)
{
    ptc_status status = PTC_E_PARAM;

    if ((self != NULL) && (params != NULL)) {
        if ((22U < params->samples) && (0.0 < params->u_max)) {
            const uint32_t samples = params->samples;
            const double u_max = params->u_max;
            self->start = 0U;
            self->samples = samples;
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
            self->u_max = u_max;
            status = PTC_OK;
        }
    }
    return status;
}

ptc_status stage47_arm(stage47 *self, uint32_t k)
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

ptc_status stage47_step(stage47 *self, uint32_t k, const double y[2], double *u)
{
    ptc_status status = PTC_E_INPUT;

    if (u != NULL) {
        *u = 0.0;
    }
    if ((self != NULL) && (y != NULL) && (u != NULL)) {
        if (PTC_FINITE_F64(y[0]) && PTC_FINITE_F64(y[1])) {
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
                x1 = self->x1_next + (0.00010803832226644697 * self->u1);
                x2 = self->x2_next + (0.030892799233141147 * self->u1);
                x3 = self->x3_next + (0.3745921515889058 * self->u1);
                d = self->d_next;
            }

            /* Prediction of the next sample. */
            const double miss1 = y[0] - x1;
            const double miss2 = y[1] - x3;
            const double off1 = miss1;
            const double off2 = miss2;
            const uint32_t left_o = (elapsed < 20U) ? (20U - elapsed) : 0U;
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
                l1_1 = 0.5288853188994155;
                l1_2 = 11.043581739724111;
                l1_3 = -1.95232951580154;
                l1_4 = -4.310227400623051;
                l2_1 = 0.00186202868892253;
                l2_2 = 0.2724600360147846;
                l2_3 = 1.5302977387244094;
                l2_4 = 2.6662087225258313;
            } else if (8.0 < o0) {
                const double r0 = 1.0 / o0;
                const double r1 = 1.0 / (o0 - 1.0);
                l1_1 = ((((-8.0) * r0) + 8.0) * r1) - 0.004980621942852573;
                const double s1 = ((1207.0156938434693 * r0) - 4.007471679722458) * r1;
                l1_2 = s1 + 0.007132886647707467;
                l1_3 = 0.056139026437663865;
                l1_4 = 359.9103398433305 * r0 * r1;
                l2_1 = 0.0014392695129337434;
                const double s2 = (((-1.8587963031465917) * r0) + 0.9913796378212842) * r1;
                l2_2 = s2 + 0.11089234841732894;
                l2_3 = ((((-12.0) * r0) + 12.0) * r1) - 0.4680369753891894;
                l2_4 = 79.82759275642569 * r0 * r1;
            } else if (left_o == 8U) {
                l1_1 = 0.9950193780571475;
                l1_2 = -0.49380107331759976;
                l1_3 = 0.056139026437663865;
                l1_4 = 0.0;
                l2_1 = 0.0014392695129337434;
                l2_2 = 0.220357858722901;
                l2_3 = 1.0319630246108107;
                l2_4 = 1.3304598792737614;
            } else {
                l1_1 = 1.9950193780571475;
                l1_2 = 99.25595014702932;
                l1_3 = 0.056139026437663865;
                l1_4 = 29.992528320277543;
                l2_1 = 0.0014392695129337434;
                l2_2 = 0.24720839921003274;
                l2_3 = 1.5319630246108107;
                l2_4 = 2.660919758547523;
            }
            const double s3 = x1 + (0.009942671770940647 * x2) + (0.000617855984662823 * x3);
            const double x1_on = s3 + (0.00010803832226644697 * d) + (l1_1 * off1) + (l2_1 * off2);
            const double s4 = (0.9857608243445873 * x2) + (0.11206871748434033 * x3);
            const double x2_on = s4 + (0.030892799233141147 * d) + (l1_2 * off1) + (l2_2 * off2);
            const double s5 = ((-0.11206871748434033) * x2) + (0.5412215783233707 * x3);
            const double x3_on = s5 + (0.3745921515889058 * d) + (l1_3 * off1) + (l2_3 * off2);
            const double d_on = d + (l1_4 * off1) + (l2_4 * off2);
            const uint32_t left = (elapsed < self->samples) ? (self->samples - elapsed) : 0U;
            const double m0 = ((double)left < 6.0) ? 6.0 : (double)left;
            double v;

            /* The exact law in samples. */
            const double s6 = ((-106850.90292251826) * x1) + (1124.1848178645955 * x2);
            const double z1 = s6 - (61.894579201640425 * x3);
            const double z2 = ((-642.8726851005619) * x2) + (53.018026963569255 * x3);
            const double z3 = (0.8030787004640786 * x2) - (24.09236101392236 * x3);
            const double s7 = (0.29872942459099683 * x2) + (1.238117262270095 * x3);
            v = ((((((z1 / (m0 + 2.0)) + z2) / (m0 + 1.0)) + z3) / m0) + s7) - d;
            status = PTC_E_RANGE;
            if (PTC_FINITE_F64(v)
                && PTC_FINITE_F64(x1_on)
                && PTC_FINITE_F64(x2_on)
                && PTC_FINITE_F64(x3_on)
                && PTC_FINITE_F64(d_on)) {
                double u_now;
                if (self->u_max < v) {
                    u_now = self->u_max;
                } else if (v < -self->u_max) {
                    u_now = -self->u_max;
                } else {
                    u_now = v;
                }
                self->u1 = u_now;
                self->x1_hat = x1;
                self->x1_next = x1_on;
                self->x2_hat = x2;
                self->x2_next = x2_on;
                self->x3_hat = x3;
                self->x3_next = x3_on;
                self->d_hat = d;
                self->d_next = d_on;
                self->seen = 1U;
                *u = u_now;
                if ((self->u_max < v) || (v < -self->u_max)) {
                    status = PTC_SATURATED;
                } else if ((double)left <= 6.0) {
                    status = PTC_HOLD;
                } else {
                    status = PTC_OK;
                }
            }
        }
    }
    return status;
}

ptc_status stage47_estimate(const stage47 *self, double xhat[3])
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (xhat != NULL)) {
        xhat[0] = self->x1_hat;
        xhat[1] = self->x2_hat;
        xhat[2] = self->x3_hat;
        status = PTC_OK;
    } else {
        if (xhat != NULL) {
            for (uint32_t i = 0U; i < 3U; i++) {
                xhat[i] = 0.0;
            }
        }
    }
    return status;
}

ptc_status stage47_disturbance(const stage47 *self, double *d)
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (d != NULL)) {
        *d = self->d_hat;
        status = PTC_OK;
    }
    return status;
}
