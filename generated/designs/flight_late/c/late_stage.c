/* Prescribed-time controller late_stage: see late_stage.h. DO NOT EDIT. */
#include "late_stage.h"

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
#define LATE_STAGE_PHI1_2 0.001 /* 1/1000, prediction of x1 from x2 */
#define LATE_STAGE_PHI1_3 3.3333333333333335e-7 /* 1/3000000, prediction of x1 from d */
#define LATE_STAGE_GAMMA1 3.3333333333333335e-7 /* 1/3000000, prediction from u */
#define LATE_STAGE_PHI2_3 0.0006666666666666666 /* 1/1500, prediction of x2 from d */
#define LATE_STAGE_GAMMA2 0.0006666666666666666 /* 1/1500, prediction from u */
#define LATE_STAGE_HOLD_O 30.0 /* samples to go at which the observer is held */
#define LATE_STAGE_Q1_1 120.0 /* weight in the observer's gain l1 */
#define LATE_STAGE_Q1_2 (-60.0) /* weight in the observer's gain l1 */
#define LATE_STAGE_Q1_3 12.0 /* weight in the observer's gain l1 */
#define LATE_STAGE_Q2_1 (-108000.0) /* weight in the observer's gain l2 */
#define LATE_STAGE_Q2_2 36000.0 /* weight in the observer's gain l2 */
#define LATE_STAGE_Q3_1 36000000.0 /* weight in the observer's gain l3 */
#define LATE_STAGE_S1_1 1500000.0 /* weight of x1 in the law */
#define LATE_STAGE_S1_2 750.0 /* weight of x2 in the law */
#define LATE_STAGE_S2_2 1500.0 /* weight of x2 in the law */
#define LATE_STAGE_U_MAX 6.0 /* bound of |u| */
#define LATE_STAGE_HOLD 20.0 /* samples to go at which the gains are held */
#define LATE_STAGE_END_SAMPLES 50.0 /* samples to go at which the law of the end takes over */
#define LATE_STAGE_W1_1 (-9000000.0) /* weight of x1 in the law */
#define LATE_STAGE_W1_2 (-4500.0) /* weight of x2 in the law */
#define LATE_STAGE_W2_2 (-6000.0) /* weight of x2 in the law */
#define LATE_STAGE_W2_3 (-4.0) /* weight of u1 in the law */
#define LATE_STAGE_END1_1 (-18000000.0) /* weight of x1 in the law */
#define LATE_STAGE_END1_2 (-9000.0) /* weight of x2 in the law */
#define LATE_STAGE_END2_2 (-9000.0) /* weight of x2 in the law */
#define LATE_STAGE_END2_3 (-6.0) /* weight of u1 in the law */
#define LATE_STAGE_BACK1_2 (-0.001) /* -1/1000, a state of a sample ago */
#define LATE_STAGE_BACK1_3 3.3333333333333335e-7 /* 1/3000000, a state of a sample ago */
#define LATE_STAGE_BACK2_3 (-0.0006666666666666666) /* -1/1500, a state of a sample ago */

ptc_status late_stage_init(late_stage *self, const late_stage_params *params)
{
    ptc_status status = PTC_E_PARAM;

    (void)params;
    if (self != NULL) {
        self->start = 0U;
        self->last = 800U;
        self->u1 = 0.0;
        self->u2 = 0.0;
        self->round = 200U;
        self->seen = 0U;
        self->x1_hat = 0.0;
        self->x2_hat = 0.0;
        self->d_hat = 0.0;
        status = PTC_OK;
    }
    return status;
}

ptc_status late_stage_arm(late_stage *self, uint32_t k)
{
    ptc_status status = PTC_E_INPUT;

    if (self != NULL) {
        self->start = k;
        self->last = 800U;
        self->round = 200U;
        const double size = fabs(self->x1_hat) + fabs(self->x2_hat) + fabs(self->d_hat);
        if (!(size <= 1e150)) {
            self->seen = 0U;
            self->x1_hat = 0.0;
            self->x2_hat = 0.0;
            self->d_hat = 0.0;
        }
        status = PTC_OK;
    }
    return status;
}

ptc_status late_stage_step(late_stage *self, uint32_t k, const double y[1], double *u)
{
    ptc_status status = PTC_E_INPUT;

    if (u != NULL) {
        *u = 0.0;
    }
    if ((self != NULL) && (y != NULL) && (u != NULL)) {
        if (PTC_FINITE_F64(y[0])) {
            const uint32_t elapsed = k - self->start;

            /* Predict. */
            const double s1 = self->x1_hat + (LATE_STAGE_PHI1_2 * self->x2_hat);
            const double s2 = s1 + (LATE_STAGE_PHI1_3 * self->d_hat);
            const double p1 = s2 + (LATE_STAGE_GAMMA1 * self->u2);
            const double s3 = self->x2_hat + (LATE_STAGE_PHI2_3 * self->d_hat);
            const double p2 = s3 + (LATE_STAGE_GAMMA2 * self->u2);
            const double p3 = self->d_hat;

            /* Correct by what is measured. */
            double base;
            double miss;
            if (self->seen == 0U) {
                base = y[0];
                miss = 0.0;
            } else {
                base = p1;
                miss = y[0] - p1;
            }
            const uint32_t left_o = (elapsed < self->round) ? (self->round - elapsed) : 0U;
            const double o0 = ((double)left_o < LATE_STAGE_HOLD_O) ? LATE_STAGE_HOLD_O : (double)left_o;
            double l1;
            double l2;
            double l3;
            const double o0f2 = o0 * (o0 - 1.0);
            const double r0 = 1.0 / (o0f2 * (o0 - 2.0));
            l1 = (LATE_STAGE_Q1_1 + (LATE_STAGE_Q1_2 * o0) + (LATE_STAGE_Q1_3 * o0f2)) * r0;
            l2 = (LATE_STAGE_Q2_1 + (LATE_STAGE_Q2_2 * o0)) * r0;
            l3 = LATE_STAGE_Q3_1 * r0;
            const double x1 = base + (l1 * miss);
            const double x2 = p2 + (l2 * miss);
            const double d = p3 + (l3 * miss);

            /* The deadline that keeps the limits. */
            uint32_t last_now = self->last;
            uint32_t late = 0U;
            const uint32_t to_rest = (elapsed < self->last) ? (self->last - elapsed) : 0U;
            const uint32_t ahead = (1U < to_rest) ? (to_rest - 1U) : 0U;
            const double flat1 = (LATE_STAGE_S1_1 * x1) + (LATE_STAGE_S1_2 * x2);
            const double flat2 = (LATE_STAGE_S2_2 * x2) + (self->u1 + d);
            uint32_t low = (1U < ahead) ? (ahead - 1U) : 0U;
            uint32_t top = 1073741825U;
            uint32_t kept = 0U;
            uint32_t tried = ahead;
            double part = 0.9999999999998739;
            for (uint32_t attempt = 0U; attempt < 64U; attempt++) {
                const double least = ((-LATE_STAGE_U_MAX) * part) + d;
                const double most = (LATE_STAGE_U_MAX * part) + d;
                const double within = (-least < most) ? -least : most;
                uint32_t fits = 0U;
                if (tried > 50U) {
                    const double m = (double)tried;
                    const double power1 = m + 1.0;
                    const double power2 = power1 * m;
                    const double power3 = power2 * (m - 1.0);
                    const double scaled2 = flat2 * power1;
                    const double w1 = ((3.0 * flat1) + scaled2) / power2;
                    const double w2 = (((-2.0) * flat1) - scaled2) / power3;
                    const double length = m - 51.0;
                    const double b0_c = (2.0 * w1) + (300.0 * w2);
                    const double b1_c = 6.0 * w2 * length;
                    const double b1 = b0_c + b1_c;
                    const double end11 = (2.8506787330316743 * w1) + (117.44796380090497 * w2);
                    const double end12 = (3.0475113122171944 * w1) + (145.85746606334843 * w2);
                    const double end13 = (2.9906485671191554 * w1) + (175.02805429864253 * w2);
                    const double end14 = (2.6800904977375564 * w1) + (204.95972850678734 * w2);
                    const double end15 = (2.1158371040723982 * w1) + (235.6524886877828 * w2);
                    const double end16 = (1.2978883861236803 * w1) + (267.10633484162895 * w2);
                    const double end17 = (0.22624434389140272 * w1) + (299.3212669683258 * w2);
                    if ((least <= b0_c)
                        && (b0_c <= most)
                        && (least <= b1)
                        && (b1 <= most)
                        && (least <= end11)
                        && (end11 <= most)
                        && (least <= end12)
                        && (end12 <= most)
                        && (least <= end13)
                        && (end13 <= most)
                        && (least <= end14)
                        && (end14 <= most)
                        && (least <= end15)
                        && (end15 <= most)
                        && (least <= end16)
                        && (end16 <= most)
                        && (least <= end17)
                        && (end17 <= most)
                        && (fabs((2.8054298642533926 * w1) + (111.58371040723979 * w2)) <= 0.9850746268656713 * within)
                        && (fabs((2.583924302196364 * w1) + (85.00144425360725 * w2)) <= 0.9850746268656713 * within)
                        && (fabs((1.9885945165034657 * w1) + (61.86959300518941 * w2)) <= 0.9850746268656713 * within)
                        && (fabs((2.9380703330283167 * w1) + (105.39729178384643 * w2)) <= 0.9850746268656713 * within)
                        && (fabs((2.395997187424203 * w1) + (77.20565274199532 * w2)) <= 0.9850746268656713 * within)
                        && (fabs((2.8712027904432142 * w1) + (99.5000219686458 * w2)) <= 0.9850746268656713 * within)) {
                        fits = 1U;
                    }
                } else if (tried > 20U) {
                    const double m = (double)tried;
                    const double power1 = m + 2.0;
                    const double power2 = power1 * (m + 1.0);
                    const double power3 = power2 * m;
                    const double power4 = power3 * (m - 1.0);
                    const double scaled2 = flat2 * power1;
                    const double w1 = ((4.0 * flat1) + scaled2) / power3;
                    const double w2 = (((-3.0) * flat1) - scaled2) / power4;
                    const double length = m - 21.0;
                    const double b0_c = (126.0 * w1) + (5040.0 * w2);
                    const double b1_c = ((6.0 * w1) + (492.0 * w2)) * length;
                    const double b2_l = length * length;
                    const double b2_c = 12.0 * w2 * b2_l;
                    const double b1 = b0_c + (0.16666666666666666 * b1_c);
                    const double s4 = b0_c + (0.3333333333333333 * b1_c);
                    const double b2 = s4 + (0.06666666666666667 * b2_c);
                    const double b3 = b0_c + (0.5 * b1_c) + (0.2 * b2_c);
                    const double b4 = b0_c + (0.6666666666666666 * b1_c) + (0.4 * b2_c);
                    const double s5 = b0_c + (0.8333333333333334 * b1_c);
                    const double b5 = s5 + (0.6666666666666666 * b2_c);
                    const double b6 = b0_c + b1_c + b2_c;
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
                        && (fabs((119.99999999999996 * w1) + (4559.999999999999 * w2)) <= 0.9850746268656713 * within)
                        && (fabs((92.75321716019634 * w1) + (2422.754466594877 * w2)) <= 0.9850746268656713 * within)
                        && (fabs((67.8353765546998 * w1) + (1509.7849977027897 * w2)) <= 0.9850746268656713 * within)
                        && (fabs((114.21150278293138 * w1) + (3629.3877551020414 * w2)) <= 0.9850746268656713 * within)
                        && (fabs((84.39364430426792 * w1) + (2085.179889377806 * w2)) <= 0.9850746268656713 * within)
                        && (fabs((108.11363033997543 * w1) + (3196.9332337421392 * w2)) <= 0.9850746268656713 * within)) {
                        fits = 1U;
                    }
                } else if ((fabs(((-0.025974025974025976) * flat1) - (0.2857142857142857 * flat2)) <= 0.9850746268656713 * within)
                    && (fabs(((-0.0012475444042476065) * flat1) - (0.08276232337733669 * flat2)) <= 0.9850746268656713 * within)
                    && (fabs((0.0035664936491730252 * flat1) - (0.02768331367963576 * flat2)) <= 0.9850746268656713 * within)
                    && (fabs(((-0.012577404043081223) * flat1) - (0.18287834614365228 * flat2)) <= 0.9850746268656713 * within)
                    && (fabs((0.000902126332826074 * flat1) - (0.060363489673773814 * flat2)) <= 0.9850746268656713 * within)
                    && (fabs(((-0.007827317130259085) * flat1) - (0.14320479414568998 * flat2)) <= 0.9850746268656713 * within)) {
                    fits = 1U;
                } else {
                    /* neither */
                }
                if (fits == 1U) {
                    kept = tried;
                    top = tried;
                } else if (tried > 20U) {
                    low = tried;
                } else {
                    low = 20U;
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
                part = 0.899999999999773;
            }
            if ((ahead < kept) && (elapsed < 2147483648U)) {
                last_now = (elapsed + kept) + 1U;
            }
            if ((kept == 0U) && (ahead > 0U)) {
                late = 2U;
            }
            if (last_now > self->last) {
                late = 1U;
            }
            const uint32_t left = (elapsed < last_now) ? (last_now - elapsed) : 0U;
            const double s6 = ((double)left) - 1.0;
            const double m0 = (s6 < LATE_STAGE_HOLD) ? LATE_STAGE_HOLD : s6;
            double v;
            if (m0 > LATE_STAGE_END_SAMPLES) {
                /* The exact law in samples. */
                const double z1 = (LATE_STAGE_W1_1 * x1) + (LATE_STAGE_W1_2 * x2);
                const double z2 = (LATE_STAGE_W2_2 * x2) + (LATE_STAGE_W2_3 * (self->u1 + d));
                const double m0f1 = m0 + 1.0;
                v = ((z1 + (z2 * m0f1)) / (m0f1 * m0)) - d;
            } else {
                /* The law of least energy to the end. */
                const double m1 = (m0 < 2.0) ? 2.0 : m0;
                const double y1 = (LATE_STAGE_END1_1 * x1) + (LATE_STAGE_END1_2 * x2);
                const double y2 = (LATE_STAGE_END2_2 * x2) + (LATE_STAGE_END2_3 * (self->u1 + d));
                const double m1f1 = m1 + 2.0;
                v = ((y1 + (y2 * m1f1)) / (m1f1 * (m1 + 1.0))) - d;
            }
            status = PTC_E_RANGE;
            if (PTC_FINITE_F64(v)) {
                double u_now;
                if (v > LATE_STAGE_U_MAX) {
                    u_now = LATE_STAGE_U_MAX;
                } else if (v < -LATE_STAGE_U_MAX) {
                    u_now = -LATE_STAGE_U_MAX;
                } else {
                    u_now = v;
                }
                self->u2 = self->u1;
                self->u1 = u_now;
                self->last = last_now;
                self->x1_hat = x1;
                self->x2_hat = x2;
                self->d_hat = d;
                self->seen = 1U;
                *u = u_now;
                if ((v > LATE_STAGE_U_MAX) || (v < -LATE_STAGE_U_MAX)) {
                    status = PTC_SATURATED;
                } else if (((double)left) - 1.0 <= LATE_STAGE_HOLD) {
                    status = PTC_HOLD;
                } else if (late == 2U) {
                    status = PTC_INFEASIBLE;
                } else if (late == 1U) {
                    status = PTC_LATE;
                } else {
                    status = PTC_OK;
                }
            }
        }
    }
    return status;
}

ptc_status late_stage_arm_for(late_stage *self, uint32_t k, uint32_t samples)
{
    ptc_status status = PTC_E_PARAM;

    if (self != NULL) {
        if ((samples > 2U) && (samples < 2147483649U)) {
            const uint32_t elapsed = k - self->start;
            self->round = (elapsed < self->round) ? (self->round - elapsed) : 0U;
            self->start = k;
            self->last = samples;
            status = PTC_OK;
        }
    }
    return status;
}

ptc_status late_stage_soonest(const late_stage *self, uint32_t *samples)
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (samples != NULL)) {
        const double s1 = self->x1_hat + (LATE_STAGE_PHI1_2 * self->x2_hat);
        const double s2 = s1 + (LATE_STAGE_PHI1_3 * self->d_hat);
        const double p1 = s2 + (LATE_STAGE_GAMMA1 * self->u2);
        const double s3 = self->x2_hat + (LATE_STAGE_PHI2_3 * self->d_hat);
        const double p2 = s3 + (LATE_STAGE_GAMMA2 * self->u2);
        const double p3 = self->d_hat;
        const double x1 = p1;
        const double x2 = p2;
        const double d = p3;
        const double flat1 = (LATE_STAGE_S1_1 * x1) + (LATE_STAGE_S1_2 * x2);
        const double flat2 = (LATE_STAGE_S2_2 * x2) + (self->u1 + d);
        uint32_t low = 20U;
        uint32_t top = 1073741825U;
        uint32_t kept = 0U;
        uint32_t tried = 21U;
        for (uint32_t attempt = 0U; attempt < 64U; attempt++) {
            const double least = (0.899999999999773 * (-LATE_STAGE_U_MAX)) + d;
            const double most = (0.899999999999773 * LATE_STAGE_U_MAX) + d;
            const double within = (-least < most) ? -least : most;
            uint32_t fits = 0U;
            if (tried > 50U) {
                const double m = (double)tried;
                const double power1 = m + 1.0;
                const double power2 = power1 * m;
                const double power3 = power2 * (m - 1.0);
                const double scaled2 = flat2 * power1;
                const double w1 = ((3.0 * flat1) + scaled2) / power2;
                const double w2 = (((-2.0) * flat1) - scaled2) / power3;
                const double length = m - 51.0;
                const double b0_c = (2.0 * w1) + (300.0 * w2);
                const double b1_c = 6.0 * w2 * length;
                const double b1 = b0_c + b1_c;
                const double end11 = (2.8506787330316743 * w1) + (117.44796380090497 * w2);
                const double end12 = (3.0475113122171944 * w1) + (145.85746606334843 * w2);
                const double end13 = (2.9906485671191554 * w1) + (175.02805429864253 * w2);
                const double end14 = (2.6800904977375564 * w1) + (204.95972850678734 * w2);
                const double end15 = (2.1158371040723982 * w1) + (235.6524886877828 * w2);
                const double end16 = (1.2978883861236803 * w1) + (267.10633484162895 * w2);
                const double end17 = (0.22624434389140272 * w1) + (299.3212669683258 * w2);
                if ((least <= b0_c)
                    && (b0_c <= most)
                    && (least <= b1)
                    && (b1 <= most)
                    && (least <= end11)
                    && (end11 <= most)
                    && (least <= end12)
                    && (end12 <= most)
                    && (least <= end13)
                    && (end13 <= most)
                    && (least <= end14)
                    && (end14 <= most)
                    && (least <= end15)
                    && (end15 <= most)
                    && (least <= end16)
                    && (end16 <= most)
                    && (least <= end17)
                    && (end17 <= most)
                    && (fabs((2.8054298642533926 * w1) + (111.58371040723979 * w2)) <= 0.9850746268656713 * within)
                    && (fabs((2.583924302196364 * w1) + (85.00144425360725 * w2)) <= 0.9850746268656713 * within)
                    && (fabs((1.9885945165034657 * w1) + (61.86959300518941 * w2)) <= 0.9850746268656713 * within)
                    && (fabs((2.9380703330283167 * w1) + (105.39729178384643 * w2)) <= 0.9850746268656713 * within)
                    && (fabs((2.395997187424203 * w1) + (77.20565274199532 * w2)) <= 0.9850746268656713 * within)
                    && (fabs((2.8712027904432142 * w1) + (99.5000219686458 * w2)) <= 0.9850746268656713 * within)) {
                    fits = 1U;
                }
            } else {
                const double m = (double)tried;
                const double power1 = m + 2.0;
                const double power2 = power1 * (m + 1.0);
                const double power3 = power2 * m;
                const double power4 = power3 * (m - 1.0);
                const double scaled2 = flat2 * power1;
                const double w1 = ((4.0 * flat1) + scaled2) / power3;
                const double w2 = (((-3.0) * flat1) - scaled2) / power4;
                const double length = m - 21.0;
                const double b0_c = (126.0 * w1) + (5040.0 * w2);
                const double b1_c = ((6.0 * w1) + (492.0 * w2)) * length;
                const double b2_l = length * length;
                const double b2_c = 12.0 * w2 * b2_l;
                const double b1 = b0_c + (0.16666666666666666 * b1_c);
                const double s4 = b0_c + (0.3333333333333333 * b1_c);
                const double b2 = s4 + (0.06666666666666667 * b2_c);
                const double b3 = b0_c + (0.5 * b1_c) + (0.2 * b2_c);
                const double b4 = b0_c + (0.6666666666666666 * b1_c) + (0.4 * b2_c);
                const double s5 = b0_c + (0.8333333333333334 * b1_c);
                const double b5 = s5 + (0.6666666666666666 * b2_c);
                const double b6 = b0_c + b1_c + b2_c;
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
                    && (fabs((119.99999999999996 * w1) + (4559.999999999999 * w2)) <= 0.9850746268656713 * within)
                    && (fabs((92.75321716019634 * w1) + (2422.754466594877 * w2)) <= 0.9850746268656713 * within)
                    && (fabs((67.8353765546998 * w1) + (1509.7849977027897 * w2)) <= 0.9850746268656713 * within)
                    && (fabs((114.21150278293138 * w1) + (3629.3877551020414 * w2)) <= 0.9850746268656713 * within)
                    && (fabs((84.39364430426792 * w1) + (2085.179889377806 * w2)) <= 0.9850746268656713 * within)
                    && (fabs((108.11363033997543 * w1) + (3196.9332337421392 * w2)) <= 0.9850746268656713 * within)) {
                    fits = 1U;
                }
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
        if (PTC_FINITE_F64(flat1) && PTC_FINITE_F64(flat2)) {
            if (kept > 0U) {
                *samples = kept + 1U;
                status = PTC_OK;
            } else {
                status = PTC_E_SOON;
            }
        } else {
            status = PTC_E_RANGE;
        }
    }
    return status;
}

ptc_status late_stage_deadline(const late_stage *self, uint32_t *k)
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (k != NULL)) {
        *k = self->start - (0U - self->last);
        status = PTC_OK;
    }
    return status;
}

ptc_status late_stage_move(late_stage *self, double dx)
{
    ptc_status status = PTC_E_INPUT;

    if (self != NULL) {
        const double moved = self->x1_hat - dx;
        if (PTC_FINITE_F64(moved)) {
            self->x1_hat = moved;
            status = PTC_OK;
        }
    }
    return status;
}

ptc_status late_stage_assume(late_stage *self, const double xhat[2])
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (xhat != NULL)) {
        const double g1 = xhat[0] - (LATE_STAGE_GAMMA1 * self->u2);
        const double g2 = xhat[1] - (LATE_STAGE_GAMMA2 * self->u2);
        const double n1 = g1 + (LATE_STAGE_BACK1_2 * g2) + (LATE_STAGE_BACK1_3 * self->d_hat);
        const double n2 = g2 + (LATE_STAGE_BACK2_3 * self->d_hat);
        if (PTC_FINITE_F64(n1) && PTC_FINITE_F64(n2)) {
            self->x1_hat = n1;
            self->x2_hat = n2;
            self->seen = 1U;
            status = PTC_OK;
        }
    }
    return status;
}

ptc_status late_stage_assume_disturbance(late_stage *self, double d)
{
    ptc_status status = PTC_E_INPUT;

    if (self != NULL) {
        if (PTC_FINITE_F64(d)) {
            self->d_hat = d;
            status = PTC_OK;
        }
    }
    return status;
}

ptc_status late_stage_applied(late_stage *self, double u)
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

ptc_status late_stage_estimate(const late_stage *self, double xhat[2])
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (xhat != NULL)) {
        xhat[0] = self->x1_hat;
        xhat[1] = self->x2_hat;
        status = PTC_OK;
    }
    if ((status < PTC_OK) && (xhat != NULL)) {
        for (uint32_t i = 0U; i < 2U; i++) {
            xhat[i] = 0.0;
        }
    }
    return status;
}

ptc_status late_stage_disturbance(const late_stage *self, double *d)
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (d != NULL)) {
        *d = self->d_hat;
        status = PTC_OK;
    }
    return status;
}
