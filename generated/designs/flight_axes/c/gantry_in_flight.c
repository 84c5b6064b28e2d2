/* Prescribed-time controller gantry_in_flight: see gantry_in_flight.h. DO NOT EDIT. */
#include "gantry_in_flight.h"

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
#define GANTRY_IN_FLIGHT_S1_1_1 120000000.0 /* weight of x1 in the law */
#define GANTRY_IN_FLIGHT_S1_2_1 (-60000.0) /* weight of x2 in the law */
#define GANTRY_IN_FLIGHT_S2_2_1 120000.0 /* weight of x2 in the law */
#define GANTRY_IN_FLIGHT_S1_1_2 45000000.0 /* weight of x1 in the law */
#define GANTRY_IN_FLIGHT_S1_2_2 (-22500.0) /* weight of x2 in the law */
#define GANTRY_IN_FLIGHT_S2_2_2 45000.0 /* weight of x2 in the law */
#define GANTRY_IN_FLIGHT_S1_1_3 12000000.0 /* weight of x1 in the law */
#define GANTRY_IN_FLIGHT_S1_2_3 (-6000.0) /* weight of x2 in the law */
#define GANTRY_IN_FLIGHT_S2_2_3 12000.0 /* weight of x2 in the law */
#define GANTRY_IN_FLIGHT_U_MIN_1 (-900.0) /* lower limit of u */
#define GANTRY_IN_FLIGHT_U_MAX_1 900.0 /* upper limit of u */
#define GANTRY_IN_FLIGHT_U_MIN_2 (-400.0) /* lower limit of u */
#define GANTRY_IN_FLIGHT_U_MAX_2 400.0 /* upper limit of u */
#define GANTRY_IN_FLIGHT_U_MIN_3 (-150.0) /* lower limit of u */
#define GANTRY_IN_FLIGHT_U_MAX_3 60.0 /* upper limit of u */
#define GANTRY_IN_FLIGHT_HOLD 20.0 /* samples to go at which the gains are held */
#define GANTRY_IN_FLIGHT_END_SAMPLES_1 50.0 /* samples to go at which the law of the end takes over */
#define GANTRY_IN_FLIGHT_W1_1_1 (-720000000.0) /* weight of x1 in the law */
#define GANTRY_IN_FLIGHT_W1_2_1 360000.0 /* weight of x2 in the law */
#define GANTRY_IN_FLIGHT_W2_2_1 (-480000.0) /* weight of x2 in the law */
#define GANTRY_IN_FLIGHT_END1_1_1 (-1440000000.0) /* weight of x1 in the law */
#define GANTRY_IN_FLIGHT_END1_2_1 720000.0 /* weight of x2 in the law */
#define GANTRY_IN_FLIGHT_END2_2_1 (-720000.0) /* weight of x2 in the law */
#define GANTRY_IN_FLIGHT_END_SAMPLES_2 50.0 /* samples to go at which the law of the end takes over */
#define GANTRY_IN_FLIGHT_W1_1_2 (-270000000.0) /* weight of x1 in the law */
#define GANTRY_IN_FLIGHT_W1_2_2 135000.0 /* weight of x2 in the law */
#define GANTRY_IN_FLIGHT_W2_2_2 (-180000.0) /* weight of x2 in the law */
#define GANTRY_IN_FLIGHT_END1_1_2 (-540000000.0) /* weight of x1 in the law */
#define GANTRY_IN_FLIGHT_END1_2_2 270000.0 /* weight of x2 in the law */
#define GANTRY_IN_FLIGHT_END2_2_2 (-270000.0) /* weight of x2 in the law */
#define GANTRY_IN_FLIGHT_END_SAMPLES_3 50.0 /* samples to go at which the law of the end takes over */
#define GANTRY_IN_FLIGHT_W1_1_3 (-72000000.0) /* weight of x1 in the law */
#define GANTRY_IN_FLIGHT_W1_2_3 36000.0 /* weight of x2 in the law */
#define GANTRY_IN_FLIGHT_W2_2_3 (-48000.0) /* weight of x2 in the law */
#define GANTRY_IN_FLIGHT_END1_1_3 (-144000000.0) /* weight of x1 in the law */
#define GANTRY_IN_FLIGHT_END1_2_3 72000.0 /* weight of x2 in the law */
#define GANTRY_IN_FLIGHT_END2_2_3 (-72000.0) /* weight of x2 in the law */

ptc_status gantry_in_flight_init(gantry_in_flight *self, const gantry_in_flight_params *params)
{
    ptc_status status = PTC_E_PARAM;

    (void)params;
    if (self != NULL) {
        self->start = 0U;
        self->last = 1500U;
        status = PTC_OK;
    }
    return status;
}

ptc_status gantry_in_flight_arm(gantry_in_flight *self, uint32_t k)
{
    ptc_status status = PTC_E_INPUT;

    if (self != NULL) {
        self->start = k;
        self->last = 1500U;
        status = PTC_OK;
    }
    return status;
}

ptc_status gantry_in_flight_step(
    gantry_in_flight *self,
    uint32_t k,
    const double x[3][2],
    double u[3],
    ptc_status axes[3])
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (x != NULL) && (u != NULL) && (axes != NULL)) {
        if (PTC_FINITE_F64(x[0][0])
            && PTC_FINITE_F64(x[0][1])
            && PTC_FINITE_F64(x[1][0])
            && PTC_FINITE_F64(x[1][1])
            && PTC_FINITE_F64(x[2][0])
            && PTC_FINITE_F64(x[2][1])) {
            const uint32_t elapsed = k - self->start;
            const double x1_1 = x[0][0];
            const double x2_1 = x[0][1];
            const double x1_2 = x[1][0];
            const double x2_2 = x[1][1];
            const double x1_3 = x[2][0];
            const double x2_3 = x[2][1];

            /* The deadline that keeps the limits. */
            uint32_t last_now = self->last;
            uint32_t late = 0U;
            const uint32_t to_rest = (elapsed < self->last) ? (self->last - elapsed) : 0U;
            const uint32_t ahead = to_rest;
            const double flat1_1 = (GANTRY_IN_FLIGHT_S1_1_1 * x1_1) + (GANTRY_IN_FLIGHT_S1_2_1 * x2_1);
            const double flat2_1 = GANTRY_IN_FLIGHT_S2_2_1 * x2_1;
            const double flat1_2 = (GANTRY_IN_FLIGHT_S1_1_2 * x1_2) + (GANTRY_IN_FLIGHT_S1_2_2 * x2_2);
            const double flat2_2 = GANTRY_IN_FLIGHT_S2_2_2 * x2_2;
            const double flat1_3 = (GANTRY_IN_FLIGHT_S1_1_3 * x1_3) + (GANTRY_IN_FLIGHT_S1_2_3 * x2_3);
            const double flat2_3 = GANTRY_IN_FLIGHT_S2_2_3 * x2_3;
            uint32_t below = ((ahead / 16U) < ((1U < ahead) ? (ahead - 1U) : 0U)) ? (((1U < ahead) ? (ahead - 1U) : 0U) - (ahead / 16U)) : 0U;
            if (ahead > 20U) {
                if (below < 20U) {
                    below = 20U;
                }
            } else {
                below = (1U < ahead) ? (ahead - 1U) : 0U;
            }
            uint32_t low = below;
            uint32_t top = 1073741825U;
            uint32_t kept = 0U;
            uint32_t tried = ahead;
            double part = 0.9999999999998739;
            for (uint32_t attempt = 0U; attempt < 64U; attempt++) {
                const double least_1 = GANTRY_IN_FLIGHT_U_MIN_1 * part;
                const double most_1 = GANTRY_IN_FLIGHT_U_MAX_1 * part;
                const double within_1 = (-least_1 < most_1) ? -least_1 : most_1;
                const double most2_1 = 1.5 * part;
                const double least_2 = GANTRY_IN_FLIGHT_U_MIN_2 * part;
                const double most_2 = GANTRY_IN_FLIGHT_U_MAX_2 * part;
                const double within_2 = (-least_2 < most_2) ? -least_2 : most_2;
                const double least_3 = GANTRY_IN_FLIGHT_U_MIN_3 * part;
                const double most_3 = GANTRY_IN_FLIGHT_U_MAX_3 * part;
                const double within_3 = (-least_3 < most_3) ? -least_3 : most_3;
                const double most2_3 = 0.4 * part;
                uint32_t fits = 0U;
                if (tried > 50U) {
                    const double m_1 = (double)tried;
                    const double power1_1 = m_1 + 1.0;
                    const double power2_1 = power1_1 * m_1;
                    const double power3_1 = power2_1 * (m_1 - 1.0);
                    const double scaled2_1 = flat2_1 * power1_1;
                    const double w1_1 = ((3.0 * flat1_1) + scaled2_1) / power2_1;
                    const double w2_1 = (((-2.0) * flat1_1) - scaled2_1) / power3_1;
                    const double length_1 = m_1 - 51.0;
                    const double b0_c_1 = (2.0 * w1_1) + (300.0 * w2_1);
                    const double b1_c_1 = 6.0 * w2_1 * length_1;
                    const double b1_1 = b0_c_1 + b1_c_1;
                    const double s0_c_1 = ((-0.00085) * w1_1) - (0.06375 * w2_1);
                    const double s1_c_1 = (((-1.6666666666666667e-5) * w1_1) - (0.002525 * w2_1)) * length_1;
                    const double s2_l_1 = length_1 * length_1;
                    const double s2_c_1 = (-2.5e-5) * w2_1 * s2_l_1;
                    const double s1_1 = s0_c_1 + (0.16666666666666666 * s1_c_1);
                    const double s1 = s0_c_1 + (0.3333333333333333 * s1_c_1);
                    const double s2_1 = s1 + (0.06666666666666667 * s2_c_1);
                    const double s3_1 = s0_c_1 + (0.5 * s1_c_1) + (0.2 * s2_c_1);
                    const double s4_1 = s0_c_1 + (0.6666666666666666 * s1_c_1) + (0.4 * s2_c_1);
                    const double s2 = s0_c_1 + (0.8333333333333334 * s1_c_1);
                    const double s5_1 = s2 + (0.6666666666666666 * s2_c_1);
                    const double s6_1 = s0_c_1 + s1_c_1 + s2_c_1;
                    const double end21_1 = (2.8506787330316743 * w1_1) + (117.44796380090497 * w2_1);
                    const double end22_1 = (3.0475113122171944 * w1_1) + (145.85746606334843 * w2_1);
                    const double end23_1 = (2.9906485671191554 * w1_1) + (175.02805429864253 * w2_1);
                    const double end24_1 = (2.6800904977375564 * w1_1) + (204.95972850678734 * w2_1);
                    const double end25_1 = (2.1158371040723982 * w1_1) + (235.6524886877828 * w2_1);
                    const double end26_1 = (1.2978883861236803 * w1_1) + (267.10633484162895 * w2_1);
                    const double end27_1 = (0.22624434389140272 * w1_1) + (299.3212669683258 * w2_1);
                    if ((least_1 <= b0_c_1)
                        && (b0_c_1 <= most_1)
                        && (least_1 <= b1_1)
                        && (b1_1 <= most_1)
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
                        && (least_1 <= end21_1)
                        && (end21_1 <= most_1)
                        && (least_1 <= end22_1)
                        && (end22_1 <= most_1)
                        && (least_1 <= end23_1)
                        && (end23_1 <= most_1)
                        && (least_1 <= end24_1)
                        && (end24_1 <= most_1)
                        && (least_1 <= end25_1)
                        && (end25_1 <= most_1)
                        && (least_1 <= end26_1)
                        && (end26_1 <= most_1)
                        && (least_1 <= end27_1)
                        && (end27_1 <= most_1)
                        && (fabs(((-0.0003193815987933635) * w1_1) - (0.01059185520361991 * w2_1)) <= most2_1)
                        && (fabs(((-0.000418474825827767) * w1_1) - (0.014748146951088127 * w2_1)) <= most2_1)
                        && (fabs(((-0.0005236084177260647) * w1_1) - (0.019887508080155138 * w2_1)) <= most2_1)
                        && (fabs(((-0.0006260238454356102) * w1_1) - (0.026036214177978884 * w2_1)) <= most2_1)
                        && (fabs(((-0.0007169625799037563) * w1_1) - (0.0332205408317173 * w2_1)) <= most2_1)
                        && (fabs(((-0.0007876660920778567) * w1_1) - (0.04146676362852834 * w2_1)) <= most2_1)
                        && (fabs(((-0.0008293758529052647) * w1_1) - (0.05080115815556992 * w2_1)) <= most2_1)
                        && (fabs(((-0.0008333333333333334) * w1_1) - (0.06125 * w2_1)) <= most2_1)
                        && (fabs((2.8054298642533926 * w1_1) + (111.58371040723979 * w2_1)) <= 0.9850746268656713 * within_1)
                        && (fabs((2.583924302196364 * w1_1) + (85.00144425360725 * w2_1)) <= 0.9850746268656713 * within_1)
                        && (fabs((1.9885945165034657 * w1_1) + (61.86959300518941 * w2_1)) <= 0.9850746268656713 * within_1)
                        && (fabs((2.9380703330283167 * w1_1) + (105.39729178384643 * w2_1)) <= 0.9850746268656713 * within_1)
                        && (fabs((2.395997187424203 * w1_1) + (77.20565274199532 * w2_1)) <= 0.9850746268656713 * within_1)
                        && (fabs((2.8712027904432142 * w1_1) + (99.5000219686458 * w2_1)) <= 0.9850746268656713 * within_1)
                        && (fabs(((-0.00029562594268476623) * w1_1) - (0.009613122171945702 * w2_1)) <= 0.9850746268656717 * most2_1)
                        && (fabs(((-0.00017656644504526514) * w1_1) - (0.005290649279938502 * w2_1)) <= 0.9850746268656717 * most2_1)
                        && (fabs(((-0.00011677836082279918) * w1_1) - (0.003360345134034913 * w2_1)) <= 0.9850746268656717 * most2_1)
                        && (fabs(((-0.000247869777281542) * w1_1) - (0.007769377681142387 * w2_1)) <= 0.9850746268656717 * most2_1)
                        && (fabs(((-0.00015503374252696212) * w1_1) - (0.004582303911158442 * w2_1)) <= 0.9850746268656717 * most2_1)
                        && (fabs(((-0.00022338585783963935) * w1_1) - (0.006891066916277001 * w2_1)) <= 0.9850746268656717 * most2_1)) {
                        fits = 1U;
                    }
                } else if (tried > 20U) {
                    const double m_1 = (double)tried;
                    const double power1_1 = m_1 + 2.0;
                    const double power2_1 = power1_1 * (m_1 + 1.0);
                    const double power3_1 = power2_1 * m_1;
                    const double power4_1 = power3_1 * (m_1 - 1.0);
                    const double scaled2_1 = flat2_1 * power1_1;
                    const double w1_1 = ((4.0 * flat1_1) + scaled2_1) / power3_1;
                    const double w2_1 = (((-3.0) * flat1_1) - scaled2_1) / power4_1;
                    const double length_1 = m_1 - 21.0;
                    const double b0_c_1 = (126.0 * w1_1) + (5040.0 * w2_1);
                    const double b1_c_1 = ((6.0 * w1_1) + (492.0 * w2_1)) * length_1;
                    const double b2_l_1 = length_1 * length_1;
                    const double b2_c_1 = 12.0 * w2_1 * b2_l_1;
                    const double b1_1 = b0_c_1 + (0.16666666666666666 * b1_c_1);
                    const double s3 = b0_c_1 + (0.3333333333333333 * b1_c_1);
                    const double b2_1 = s3 + (0.06666666666666667 * b2_c_1);
                    const double b3_1 = b0_c_1 + (0.5 * b1_c_1) + (0.2 * b2_c_1);
                    const double b4_1 = b0_c_1 + (0.6666666666666666 * b1_c_1) + (0.4 * b2_c_1);
                    const double s4 = b0_c_1 + (0.8333333333333334 * b1_c_1);
                    const double b5_1 = s4 + (0.6666666666666666 * b2_c_1);
                    const double b6_1 = b0_c_1 + b1_c_1 + b2_c_1;
                    const double s0_c_1 = ((-0.01155) * w1_1) - (0.308 * w2_1);
                    const double s1_c_1 = (((-0.001075) * w1_1) - (0.044066666666666664 * w2_1)) * length_1;
                    const double s2_l_1 = length_1 * length_1;
                    const double s2_c_1 = (((-2.5e-5) * w1_1) - (0.0021 * w2_1)) * s2_l_1;
                    const double s3_l_1 = s2_l_1 * length_1;
                    const double s3_c_1 = (-3.3333333333333335e-5) * w2_1 * s3_l_1;
                    const double s1_1 = s0_c_1 + (0.14285714285714285 * s1_c_1);
                    const double s5 = s0_c_1 + (0.2857142857142857 * s1_c_1);
                    const double s2_1 = s5 + (0.047619047619047616 * s2_c_1);
                    const double s6 = s0_c_1 + (0.42857142857142855 * s1_c_1);
                    const double s7 = s6 + (0.14285714285714285 * s2_c_1);
                    const double s3_1 = s7 + (0.02857142857142857 * s3_c_1);
                    const double s8 = s0_c_1 + (0.5714285714285714 * s1_c_1);
                    const double s9 = s8 + (0.2857142857142857 * s2_c_1);
                    const double s4_1 = s9 + (0.11428571428571428 * s3_c_1);
                    const double s10 = s0_c_1 + (0.7142857142857143 * s1_c_1);
                    const double s11 = s10 + (0.47619047619047616 * s2_c_1);
                    const double s5_1 = s11 + (0.2857142857142857 * s3_c_1);
                    const double s12 = s0_c_1 + (0.8571428571428571 * s1_c_1);
                    const double s13 = s12 + (0.7142857142857143 * s2_c_1);
                    const double s6_1 = s13 + (0.5714285714285714 * s3_c_1);
                    const double s7_1 = s0_c_1 + s1_c_1 + s2_c_1 + s3_c_1;
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
                        && (fabs((119.99999999999996 * w1_1) + (4559.999999999999 * w2_1)) <= 0.9850746268656713 * within_1)
                        && (fabs((92.75321716019634 * w1_1) + (2422.754466594877 * w2_1)) <= 0.9850746268656713 * within_1)
                        && (fabs((67.8353765546998 * w1_1) + (1509.7849977027897 * w2_1)) <= 0.9850746268656713 * within_1)
                        && (fabs((114.21150278293138 * w1_1) + (3629.3877551020414 * w2_1)) <= 0.9850746268656713 * within_1)
                        && (fabs((84.39364430426792 * w1_1) + (2085.179889377806 * w2_1)) <= 0.9850746268656713 * within_1)
                        && (fabs((108.11363033997543 * w1_1) + (3196.9332337421392 * w2_1)) <= 0.9850746268656713 * within_1)
                        && (fabs(((-0.0105) * w1_1) - (0.266 * w2_1)) <= 0.9850746268656717 * most2_1)
                        && (fabs(((-0.005820348615074297) * w1_1) - (0.1137806492473866 * w2_1)) <= 0.9850746268656717 * most2_1)
                        && (fabs(((-0.003710680216503311) * w1_1) - (0.06137180874826767 * w2_1)) <= 0.9850746268656717 * most2_1)
                        && (fabs(((-0.008512987012987014) * w1_1) - (0.19394805194805195 * w2_1)) <= 0.9850746268656717 * most2_1)
                        && (fabs(((-0.005047405138739329) * w1_1) - (0.09359102869242929 * w2_1)) <= 0.9850746268656717 * most2_1)
                        && (fabs(((-0.007561224489795918) * w1_1) - (0.16370315398886828 * w2_1)) <= 0.9850746268656717 * most2_1)) {
                        fits = 1U;
                    }
                } else if ((fabs(((-0.025974025974025976) * flat1_1) - (0.2857142857142857 * flat2_1)) <= 0.9850746268656713 * within_1)
                    && (fabs(((-0.0012475444042476065) * flat1_1) - (0.08276232337733669 * flat2_1)) <= 0.9850746268656713 * within_1)
                    && (fabs((0.0035664936491730252 * flat1_1) - (0.02768331367963576 * flat2_1)) <= 0.9850746268656713 * within_1)
                    && (fabs(((-0.012577404043081223) * flat1_1) - (0.18287834614365228 * flat2_1)) <= 0.9850746268656713 * within_1)
                    && (fabs((0.000902126332826074 * flat1_1) - (0.060363489673773814 * flat2_1)) <= 0.9850746268656713 * within_1)
                    && (fabs(((-0.007827317130259085) * flat1_1) - (0.14320479414568998 * flat2_1)) <= 0.9850746268656713 * within_1)
                    && (fabs(8.333333333333334e-6 * flat2_1) <= 0.9850746268656717 * most2_1)
                    && (fabs(((-5.753277910884418e-7) * flat1_1) + (4.0025382969610726e-7 * flat2_1)) <= 0.9850746268656717 * most2_1)
                    && (fabs(((-5.576228651711587e-7) * flat1_1) - (1.1442500457763455e-6 * flat2_1)) <= 0.9850746268656717 * most2_1)
                    && (fabs(((-3.7105751391465685e-7) * flat1_1) + (4.035250463821892e-6 * flat2_1)) <= 0.9850746268656717 * most2_1)
                    && (fabs(((-5.857239944571719e-7) * flat1_1) - (2.894321984483652e-7 * flat2_1)) <= 0.9850746268656717 * most2_1)
                    && (fabs(((-4.75869214273667e-7) * flat1_1) + (2.5112642459581232e-6 * flat2_1)) <= 0.9850746268656717 * most2_1)) {
                    fits = 1U;
                } else {
                    /* neither */
                }
                if (fits == 1U) {
                    if (tried > 50U) {
                        const double m_2 = (double)tried;
                        const double power1_2 = m_2 + 1.0;
                        const double power2_2 = power1_2 * m_2;
                        const double power3_2 = power2_2 * (m_2 - 1.0);
                        const double scaled2_2 = flat2_2 * power1_2;
                        const double w1_2 = ((3.0 * flat1_2) + scaled2_2) / power2_2;
                        const double w2_2 = (((-2.0) * flat1_2) - scaled2_2) / power3_2;
                        const double length_2 = m_2 - 51.0;
                        const double b0_c_2 = (2.0 * w1_2) + (300.0 * w2_2);
                        const double b1_c_2 = 6.0 * w2_2 * length_2;
                        const double b1_2 = b0_c_2 + b1_c_2;
                        const double end11_2 = (2.8506787330316743 * w1_2) + (117.44796380090497 * w2_2);
                        const double end12_2 = (3.0475113122171944 * w1_2) + (145.85746606334843 * w2_2);
                        const double end13_2 = (2.9906485671191554 * w1_2) + (175.02805429864253 * w2_2);
                        const double end14_2 = (2.6800904977375564 * w1_2) + (204.95972850678734 * w2_2);
                        const double end15_2 = (2.1158371040723982 * w1_2) + (235.6524886877828 * w2_2);
                        const double end16_2 = (1.2978883861236803 * w1_2) + (267.10633484162895 * w2_2);
                        const double end17_2 = (0.22624434389140272 * w1_2) + (299.3212669683258 * w2_2);
                        if ((least_2 <= b0_c_2)
                            && (b0_c_2 <= most_2)
                            && (least_2 <= b1_2)
                            && (b1_2 <= most_2)
                            && (least_2 <= end11_2)
                            && (end11_2 <= most_2)
                            && (least_2 <= end12_2)
                            && (end12_2 <= most_2)
                            && (least_2 <= end13_2)
                            && (end13_2 <= most_2)
                            && (least_2 <= end14_2)
                            && (end14_2 <= most_2)
                            && (least_2 <= end15_2)
                            && (end15_2 <= most_2)
                            && (least_2 <= end16_2)
                            && (end16_2 <= most_2)
                            && (least_2 <= end17_2)
                            && (end17_2 <= most_2)
                            && (fabs((2.8054298642533926 * w1_2) + (111.58371040723979 * w2_2)) <= 0.9850746268656713 * within_2)
                            && (fabs((2.583924302196364 * w1_2) + (85.00144425360725 * w2_2)) <= 0.9850746268656713 * within_2)
                            && (fabs((1.9885945165034657 * w1_2) + (61.86959300518941 * w2_2)) <= 0.9850746268656713 * within_2)
                            && (fabs((2.9380703330283167 * w1_2) + (105.39729178384643 * w2_2)) <= 0.9850746268656713 * within_2)
                            && (fabs((2.395997187424203 * w1_2) + (77.20565274199532 * w2_2)) <= 0.9850746268656713 * within_2)
                            && (fabs((2.8712027904432142 * w1_2) + (99.5000219686458 * w2_2)) <= 0.9850746268656713 * within_2)) {
                            fits = 2U;
                        }
                    } else if (tried > 20U) {
                        const double m_2 = (double)tried;
                        const double power1_2 = m_2 + 2.0;
                        const double power2_2 = power1_2 * (m_2 + 1.0);
                        const double power3_2 = power2_2 * m_2;
                        const double power4_2 = power3_2 * (m_2 - 1.0);
                        const double scaled2_2 = flat2_2 * power1_2;
                        const double w1_2 = ((4.0 * flat1_2) + scaled2_2) / power3_2;
                        const double w2_2 = (((-3.0) * flat1_2) - scaled2_2) / power4_2;
                        const double length_2 = m_2 - 21.0;
                        const double b0_c_2 = (126.0 * w1_2) + (5040.0 * w2_2);
                        const double b1_c_2 = ((6.0 * w1_2) + (492.0 * w2_2)) * length_2;
                        const double b2_l_2 = length_2 * length_2;
                        const double b2_c_2 = 12.0 * w2_2 * b2_l_2;
                        const double b1_2 = b0_c_2 + (0.16666666666666666 * b1_c_2);
                        const double s14 = b0_c_2 + (0.3333333333333333 * b1_c_2);
                        const double b2_2 = s14 + (0.06666666666666667 * b2_c_2);
                        const double b3_2 = b0_c_2 + (0.5 * b1_c_2) + (0.2 * b2_c_2);
                        const double b4_2 = b0_c_2 + (0.6666666666666666 * b1_c_2) + (0.4 * b2_c_2);
                        const double s15 = b0_c_2 + (0.8333333333333334 * b1_c_2);
                        const double b5_2 = s15 + (0.6666666666666666 * b2_c_2);
                        const double b6_2 = b0_c_2 + b1_c_2 + b2_c_2;
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
                            && (fabs((119.99999999999996 * w1_2) + (4559.999999999999 * w2_2)) <= 0.9850746268656713 * within_2)
                            && (fabs((92.75321716019634 * w1_2) + (2422.754466594877 * w2_2)) <= 0.9850746268656713 * within_2)
                            && (fabs((67.8353765546998 * w1_2) + (1509.7849977027897 * w2_2)) <= 0.9850746268656713 * within_2)
                            && (fabs((114.21150278293138 * w1_2) + (3629.3877551020414 * w2_2)) <= 0.9850746268656713 * within_2)
                            && (fabs((84.39364430426792 * w1_2) + (2085.179889377806 * w2_2)) <= 0.9850746268656713 * within_2)
                            && (fabs((108.11363033997543 * w1_2) + (3196.9332337421392 * w2_2)) <= 0.9850746268656713 * within_2)) {
                            fits = 2U;
                        }
                    } else if ((fabs(((-0.025974025974025976) * flat1_2) - (0.2857142857142857 * flat2_2)) <= 0.9850746268656713 * within_2)
                        && (fabs(((-0.0012475444042476065) * flat1_2) - (0.08276232337733669 * flat2_2)) <= 0.9850746268656713 * within_2)
                        && (fabs((0.0035664936491730252 * flat1_2) - (0.02768331367963576 * flat2_2)) <= 0.9850746268656713 * within_2)
                        && (fabs(((-0.012577404043081223) * flat1_2) - (0.18287834614365228 * flat2_2)) <= 0.9850746268656713 * within_2)
                        && (fabs((0.000902126332826074 * flat1_2) - (0.060363489673773814 * flat2_2)) <= 0.9850746268656713 * within_2)
                        && (fabs(((-0.007827317130259085) * flat1_2) - (0.14320479414568998 * flat2_2)) <= 0.9850746268656713 * within_2)) {
                        fits = 2U;
                    } else {
                        /* neither */
                    }
                }
                if (fits == 2U) {
                    if (tried > 50U) {
                        const double m_3 = (double)tried;
                        const double power1_3 = m_3 + 1.0;
                        const double power2_3 = power1_3 * m_3;
                        const double power3_3 = power2_3 * (m_3 - 1.0);
                        const double scaled2_3 = flat2_3 * power1_3;
                        const double w1_3 = ((3.0 * flat1_3) + scaled2_3) / power2_3;
                        const double w2_3 = (((-2.0) * flat1_3) - scaled2_3) / power3_3;
                        const double length_3 = m_3 - 51.0;
                        const double b0_c_3 = (2.0 * w1_3) + (300.0 * w2_3);
                        const double b1_c_3 = 6.0 * w2_3 * length_3;
                        const double b1_3 = b0_c_3 + b1_c_3;
                        const double s0_c_3 = ((-0.0085) * w1_3) - (0.6375 * w2_3);
                        const double s1_c_3 = (((-0.00016666666666666666) * w1_3) - (0.02525 * w2_3)) * length_3;
                        const double s2_l_3 = length_3 * length_3;
                        const double s2_c_3 = (-0.00025) * w2_3 * s2_l_3;
                        const double s1_3 = s0_c_3 + (0.16666666666666666 * s1_c_3);
                        const double s16 = s0_c_3 + (0.3333333333333333 * s1_c_3);
                        const double s2_3 = s16 + (0.06666666666666667 * s2_c_3);
                        const double s3_3 = s0_c_3 + (0.5 * s1_c_3) + (0.2 * s2_c_3);
                        const double s4_3 = s0_c_3 + (0.6666666666666666 * s1_c_3) + (0.4 * s2_c_3);
                        const double s17 = s0_c_3 + (0.8333333333333334 * s1_c_3);
                        const double s5_3 = s17 + (0.6666666666666666 * s2_c_3);
                        const double s6_3 = s0_c_3 + s1_c_3 + s2_c_3;
                        const double end21_3 = (2.8506787330316743 * w1_3) + (117.44796380090497 * w2_3);
                        const double end22_3 = (3.0475113122171944 * w1_3) + (145.85746606334843 * w2_3);
                        const double end23_3 = (2.9906485671191554 * w1_3) + (175.02805429864253 * w2_3);
                        const double end24_3 = (2.6800904977375564 * w1_3) + (204.95972850678734 * w2_3);
                        const double end25_3 = (2.1158371040723982 * w1_3) + (235.6524886877828 * w2_3);
                        const double end26_3 = (1.2978883861236803 * w1_3) + (267.10633484162895 * w2_3);
                        const double end27_3 = (0.22624434389140272 * w1_3) + (299.3212669683258 * w2_3);
                        if ((least_3 <= b0_c_3)
                            && (b0_c_3 <= most_3)
                            && (least_3 <= b1_3)
                            && (b1_3 <= most_3)
                            && (-most2_3 <= s0_c_3)
                            && (s0_c_3 <= most2_3)
                            && (-most2_3 <= s1_3)
                            && (s1_3 <= most2_3)
                            && (-most2_3 <= s2_3)
                            && (s2_3 <= most2_3)
                            && (-most2_3 <= s3_3)
                            && (s3_3 <= most2_3)
                            && (-most2_3 <= s4_3)
                            && (s4_3 <= most2_3)
                            && (-most2_3 <= s5_3)
                            && (s5_3 <= most2_3)
                            && (-most2_3 <= s6_3)
                            && (s6_3 <= most2_3)
                            && (least_3 <= end21_3)
                            && (end21_3 <= most_3)
                            && (least_3 <= end22_3)
                            && (end22_3 <= most_3)
                            && (least_3 <= end23_3)
                            && (end23_3 <= most_3)
                            && (least_3 <= end24_3)
                            && (end24_3 <= most_3)
                            && (least_3 <= end25_3)
                            && (end25_3 <= most_3)
                            && (least_3 <= end26_3)
                            && (end26_3 <= most_3)
                            && (least_3 <= end27_3)
                            && (end27_3 <= most_3)
                            && (fabs(((-0.003193815987933635) * w1_3) - (0.1059185520361991 * w2_3)) <= most2_3)
                            && (fabs(((-0.00418474825827767) * w1_3) - (0.14748146951088129 * w2_3)) <= most2_3)
                            && (fabs(((-0.005236084177260648) * w1_3) - (0.1988750808015514 * w2_3)) <= most2_3)
                            && (fabs(((-0.006260238454356102) * w1_3) - (0.26036214177978884 * w2_3)) <= most2_3)
                            && (fabs(((-0.007169625799037563) * w1_3) - (0.33220540831717305 * w2_3)) <= most2_3)
                            && (fabs(((-0.007876660920778569) * w1_3) - (0.41466763628528336 * w2_3)) <= most2_3)
                            && (fabs(((-0.008293758529052647) * w1_3) - (0.5080115815556993 * w2_3)) <= most2_3)
                            && (fabs(((-0.008333333333333333) * w1_3) - (0.6125 * w2_3)) <= most2_3)
                            && (fabs((2.8054298642533926 * w1_3) + (111.58371040723979 * w2_3)) <= 0.9850746268656713 * within_3)
                            && (fabs((2.583924302196364 * w1_3) + (85.00144425360725 * w2_3)) <= 0.9850746268656713 * within_3)
                            && (fabs((1.9885945165034657 * w1_3) + (61.86959300518941 * w2_3)) <= 0.9850746268656713 * within_3)
                            && (fabs((2.9380703330283167 * w1_3) + (105.39729178384643 * w2_3)) <= 0.9850746268656713 * within_3)
                            && (fabs((2.395997187424203 * w1_3) + (77.20565274199532 * w2_3)) <= 0.9850746268656713 * within_3)
                            && (fabs((2.8712027904432142 * w1_3) + (99.5000219686458 * w2_3)) <= 0.9850746268656713 * within_3)
                            && (fabs(((-0.002956259426847662) * w1_3) - (0.09613122171945701 * w2_3)) <= 0.9850746268656717 * most2_3)
                            && (fabs(((-0.0017656644504526516) * w1_3) - (0.05290649279938503 * w2_3)) <= 0.9850746268656717 * most2_3)
                            && (fabs(((-0.0011677836082279918) * w1_3) - (0.03360345134034914 * w2_3)) <= 0.9850746268656717 * most2_3)
                            && (fabs(((-0.0024786977728154204) * w1_3) - (0.07769377681142388 * w2_3)) <= 0.9850746268656717 * most2_3)
                            && (fabs(((-0.0015503374252696213) * w1_3) - (0.04582303911158442 * w2_3)) <= 0.9850746268656717 * most2_3)
                            && (fabs(((-0.0022338585783963937) * w1_3) - (0.06891066916277001 * w2_3)) <= 0.9850746268656717 * most2_3)) {
                            fits = 3U;
                        }
                    } else if (tried > 20U) {
                        const double m_3 = (double)tried;
                        const double power1_3 = m_3 + 2.0;
                        const double power2_3 = power1_3 * (m_3 + 1.0);
                        const double power3_3 = power2_3 * m_3;
                        const double power4_3 = power3_3 * (m_3 - 1.0);
                        const double scaled2_3 = flat2_3 * power1_3;
                        const double w1_3 = ((4.0 * flat1_3) + scaled2_3) / power3_3;
                        const double w2_3 = (((-3.0) * flat1_3) - scaled2_3) / power4_3;
                        const double length_3 = m_3 - 21.0;
                        const double b0_c_3 = (126.0 * w1_3) + (5040.0 * w2_3);
                        const double b1_c_3 = ((6.0 * w1_3) + (492.0 * w2_3)) * length_3;
                        const double b2_l_3 = length_3 * length_3;
                        const double b2_c_3 = 12.0 * w2_3 * b2_l_3;
                        const double b1_3 = b0_c_3 + (0.16666666666666666 * b1_c_3);
                        const double s18 = b0_c_3 + (0.3333333333333333 * b1_c_3);
                        const double b2_3 = s18 + (0.06666666666666667 * b2_c_3);
                        const double b3_3 = b0_c_3 + (0.5 * b1_c_3) + (0.2 * b2_c_3);
                        const double b4_3 = b0_c_3 + (0.6666666666666666 * b1_c_3) + (0.4 * b2_c_3);
                        const double s19 = b0_c_3 + (0.8333333333333334 * b1_c_3);
                        const double b5_3 = s19 + (0.6666666666666666 * b2_c_3);
                        const double b6_3 = b0_c_3 + b1_c_3 + b2_c_3;
                        const double s0_c_3 = ((-0.1155) * w1_3) - (3.08 * w2_3);
                        const double s1_c_3 = (((-0.01075) * w1_3) - (0.44066666666666665 * w2_3)) * length_3;
                        const double s2_l_3 = length_3 * length_3;
                        const double s2_c_3 = (((-0.00025) * w1_3) - (0.021 * w2_3)) * s2_l_3;
                        const double s3_l_3 = s2_l_3 * length_3;
                        const double s3_c_3 = (-0.0003333333333333333) * w2_3 * s3_l_3;
                        const double s1_3 = s0_c_3 + (0.14285714285714285 * s1_c_3);
                        const double s20 = s0_c_3 + (0.2857142857142857 * s1_c_3);
                        const double s2_3 = s20 + (0.047619047619047616 * s2_c_3);
                        const double s21 = s0_c_3 + (0.42857142857142855 * s1_c_3);
                        const double s22 = s21 + (0.14285714285714285 * s2_c_3);
                        const double s3_3 = s22 + (0.02857142857142857 * s3_c_3);
                        const double s23 = s0_c_3 + (0.5714285714285714 * s1_c_3);
                        const double s24 = s23 + (0.2857142857142857 * s2_c_3);
                        const double s4_3 = s24 + (0.11428571428571428 * s3_c_3);
                        const double s25 = s0_c_3 + (0.7142857142857143 * s1_c_3);
                        const double s26 = s25 + (0.47619047619047616 * s2_c_3);
                        const double s5_3 = s26 + (0.2857142857142857 * s3_c_3);
                        const double s27 = s0_c_3 + (0.8571428571428571 * s1_c_3);
                        const double s28 = s27 + (0.7142857142857143 * s2_c_3);
                        const double s6_3 = s28 + (0.5714285714285714 * s3_c_3);
                        const double s7_3 = s0_c_3 + s1_c_3 + s2_c_3 + s3_c_3;
                        if ((least_3 <= b0_c_3)
                            && (b0_c_3 <= most_3)
                            && (least_3 <= b1_3)
                            && (b1_3 <= most_3)
                            && (least_3 <= b2_3)
                            && (b2_3 <= most_3)
                            && (least_3 <= b3_3)
                            && (b3_3 <= most_3)
                            && (least_3 <= b4_3)
                            && (b4_3 <= most_3)
                            && (least_3 <= b5_3)
                            && (b5_3 <= most_3)
                            && (least_3 <= b6_3)
                            && (b6_3 <= most_3)
                            && (-most2_3 <= s0_c_3)
                            && (s0_c_3 <= most2_3)
                            && (-most2_3 <= s1_3)
                            && (s1_3 <= most2_3)
                            && (-most2_3 <= s2_3)
                            && (s2_3 <= most2_3)
                            && (-most2_3 <= s3_3)
                            && (s3_3 <= most2_3)
                            && (-most2_3 <= s4_3)
                            && (s4_3 <= most2_3)
                            && (-most2_3 <= s5_3)
                            && (s5_3 <= most2_3)
                            && (-most2_3 <= s6_3)
                            && (s6_3 <= most2_3)
                            && (-most2_3 <= s7_3)
                            && (s7_3 <= most2_3)
                            && (fabs((119.99999999999996 * w1_3) + (4559.999999999999 * w2_3)) <= 0.9850746268656713 * within_3)
                            && (fabs((92.75321716019634 * w1_3) + (2422.754466594877 * w2_3)) <= 0.9850746268656713 * within_3)
                            && (fabs((67.8353765546998 * w1_3) + (1509.7849977027897 * w2_3)) <= 0.9850746268656713 * within_3)
                            && (fabs((114.21150278293138 * w1_3) + (3629.3877551020414 * w2_3)) <= 0.9850746268656713 * within_3)
                            && (fabs((84.39364430426792 * w1_3) + (2085.179889377806 * w2_3)) <= 0.9850746268656713 * within_3)
                            && (fabs((108.11363033997543 * w1_3) + (3196.9332337421392 * w2_3)) <= 0.9850746268656713 * within_3)
                            && (fabs(((-0.105) * w1_3) - (2.6599999999999997 * w2_3)) <= 0.9850746268656717 * most2_3)
                            && (fabs(((-0.058203486150742986) * w1_3) - (1.1378064924738662 * w2_3)) <= 0.9850746268656717 * most2_3)
                            && (fabs(((-0.037106802165033106) * w1_3) - (0.6137180874826768 * w2_3)) <= 0.9850746268656717 * most2_3)
                            && (fabs(((-0.08512987012987014) * w1_3) - (1.9394805194805198 * w2_3)) <= 0.9850746268656717 * most2_3)
                            && (fabs(((-0.05047405138739328) * w1_3) - (0.9359102869242929 * w2_3)) <= 0.9850746268656717 * most2_3)
                            && (fabs(((-0.07561224489795919) * w1_3) - (1.637031539888683 * w2_3)) <= 0.9850746268656717 * most2_3)) {
                            fits = 3U;
                        }
                    } else if ((fabs(((-0.025974025974025976) * flat1_3) - (0.2857142857142857 * flat2_3)) <= 0.9850746268656713 * within_3)
                        && (fabs(((-0.0012475444042476065) * flat1_3) - (0.08276232337733669 * flat2_3)) <= 0.9850746268656713 * within_3)
                        && (fabs((0.0035664936491730252 * flat1_3) - (0.02768331367963576 * flat2_3)) <= 0.9850746268656713 * within_3)
                        && (fabs(((-0.012577404043081223) * flat1_3) - (0.18287834614365228 * flat2_3)) <= 0.9850746268656713 * within_3)
                        && (fabs((0.000902126332826074 * flat1_3) - (0.060363489673773814 * flat2_3)) <= 0.9850746268656713 * within_3)
                        && (fabs(((-0.007827317130259085) * flat1_3) - (0.14320479414568998 * flat2_3)) <= 0.9850746268656713 * within_3)
                        && (fabs(8.333333333333333e-5 * flat2_3) <= 0.9850746268656717 * most2_3)
                        && (fabs(((-5.753277910884419e-6) * flat1_3) + (4.002538296961078e-6 * flat2_3)) <= 0.9850746268656717 * most2_3)
                        && (fabs(((-5.576228651711586e-6) * flat1_3) - (1.1442500457763452e-5 * flat2_3)) <= 0.9850746268656717 * most2_3)
                        && (fabs(((-3.7105751391465683e-6) * flat1_3) + (4.035250463821893e-5 * flat2_3)) <= 0.9850746268656717 * most2_3)
                        && (fabs(((-5.857239944571719e-6) * flat1_3) - (2.8943219844836487e-6 * flat2_3)) <= 0.9850746268656717 * most2_3)
                        && (fabs(((-4.75869214273667e-6) * flat1_3) + (2.511264245958124e-5 * flat2_3)) <= 0.9850746268656717 * most2_3)) {
                        fits = 3U;
                    } else {
                        /* neither */
                    }
                }
                if (fits == 3U) {
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
                const uint32_t more = (((ahead < low) ? (low - ahead) : 0U) / 2U) + 1U;
                if ((kept == 0U) && (more < half)) {
                    tried = low + more;
                } else {
                    tried = low + half;
                }
                part = 0.899999999999773;
            }
            if ((kept > 0U) && (elapsed < 2147483648U)) {
                last_now = elapsed + kept;
            }
            if ((kept == 0U) && (ahead > 0U)) {
                late = 2U;
            }
            if (last_now > self->last) {
                late = 1U;
            }
            const uint32_t left = (elapsed < last_now) ? (last_now - elapsed) : 0U;
            const double m0_1 = ((double)left < GANTRY_IN_FLIGHT_HOLD) ? GANTRY_IN_FLIGHT_HOLD : (double)left;
            double law_1;
            const double m0_2 = ((double)left < GANTRY_IN_FLIGHT_HOLD) ? GANTRY_IN_FLIGHT_HOLD : (double)left;
            double law_2;
            const double m0_3 = ((double)left < GANTRY_IN_FLIGHT_HOLD) ? GANTRY_IN_FLIGHT_HOLD : (double)left;
            double law_3;
            if (m0_1 > GANTRY_IN_FLIGHT_END_SAMPLES_1) {
                /* The exact law in samples. */
                const double z1_1 = (GANTRY_IN_FLIGHT_W1_1_1 * x1_1) + (GANTRY_IN_FLIGHT_W1_2_1 * x2_1);
                const double z2_1 = GANTRY_IN_FLIGHT_W2_2_1 * x2_1;
                const double m0f_11 = m0_1 + 1.0;
                law_1 = (z1_1 + (z2_1 * m0f_11)) / (m0f_11 * m0_1);
            } else {
                /* The law of least energy to the end. */
                const double m1_1 = (m0_1 < 2.0) ? 2.0 : m0_1;
                const double y1_1 = (GANTRY_IN_FLIGHT_END1_1_1 * x1_1) + (GANTRY_IN_FLIGHT_END1_2_1 * x2_1);
                const double y2_1 = GANTRY_IN_FLIGHT_END2_2_1 * x2_1;
                const double m1f_11 = m1_1 + 2.0;
                law_1 = (y1_1 + (y2_1 * m1f_11)) / (m1f_11 * (m1_1 + 1.0));
            }
            if (m0_2 > GANTRY_IN_FLIGHT_END_SAMPLES_2) {
                /* The exact law in samples. */
                const double z1_2 = (GANTRY_IN_FLIGHT_W1_1_2 * x1_2) + (GANTRY_IN_FLIGHT_W1_2_2 * x2_2);
                const double z2_2 = GANTRY_IN_FLIGHT_W2_2_2 * x2_2;
                const double m0f_21 = m0_2 + 1.0;
                law_2 = (z1_2 + (z2_2 * m0f_21)) / (m0f_21 * m0_2);
            } else {
                /* The law of least energy to the end. */
                const double m1_2 = (m0_2 < 2.0) ? 2.0 : m0_2;
                const double y1_2 = (GANTRY_IN_FLIGHT_END1_1_2 * x1_2) + (GANTRY_IN_FLIGHT_END1_2_2 * x2_2);
                const double y2_2 = GANTRY_IN_FLIGHT_END2_2_2 * x2_2;
                const double m1f_21 = m1_2 + 2.0;
                law_2 = (y1_2 + (y2_2 * m1f_21)) / (m1f_21 * (m1_2 + 1.0));
            }
            if (m0_3 > GANTRY_IN_FLIGHT_END_SAMPLES_3) {
                /* The exact law in samples. */
                const double z1_3 = (GANTRY_IN_FLIGHT_W1_1_3 * x1_3) + (GANTRY_IN_FLIGHT_W1_2_3 * x2_3);
                const double z2_3 = GANTRY_IN_FLIGHT_W2_2_3 * x2_3;
                const double m0f_31 = m0_3 + 1.0;
                law_3 = (z1_3 + (z2_3 * m0f_31)) / (m0f_31 * m0_3);
            } else {
                /* The law of least energy to the end. */
                const double m1_3 = (m0_3 < 2.0) ? 2.0 : m0_3;
                const double y1_3 = (GANTRY_IN_FLIGHT_END1_1_3 * x1_3) + (GANTRY_IN_FLIGHT_END1_2_3 * x2_3);
                const double y2_3 = GANTRY_IN_FLIGHT_END2_2_3 * x2_3;
                const double m1f_31 = m1_3 + 2.0;
                law_3 = (y1_3 + (y2_3 * m1f_31)) / (m1f_31 * (m1_3 + 1.0));
            }
            if ((double)left > GANTRY_IN_FLIGHT_HOLD) {
                if (late == 2U) {
                    status = PTC_INFEASIBLE;
                } else if (late == 1U) {
                    status = PTC_LATE;
                } else {
                    status = PTC_OK;
                }
            } else {
                status = PTC_HOLD;
            }
            if (PTC_FINITE_F64(law_1) && PTC_FINITE_F64(law_2) && PTC_FINITE_F64(law_3)) {
                u[0] = law_1;
                axes[0] = status;
                u[1] = law_2;
                axes[1] = status;
                u[2] = law_3;
                axes[2] = status;
                if (law_1 > 900.0) {
                    u[0] = 900.0;
                    axes[0] = PTC_SATURATED;
                    status = PTC_SATURATED;
                } else if (law_1 < -900.0) {
                    u[0] = -900.0;
                    axes[0] = PTC_SATURATED;
                    status = PTC_SATURATED;
                } else {
                    /* neither */
                }
                if (law_2 > 400.0) {
                    u[1] = 400.0;
                    axes[1] = PTC_SATURATED;
                    status = PTC_SATURATED;
                } else if (law_2 < -400.0) {
                    u[1] = -400.0;
                    axes[1] = PTC_SATURATED;
                    status = PTC_SATURATED;
                } else {
                    /* neither */
                }
                if (law_3 > 60.0) {
                    u[2] = 60.0;
                    axes[2] = PTC_SATURATED;
                    status = PTC_SATURATED;
                } else if (law_3 < -150.0) {
                    u[2] = -150.0;
                    axes[2] = PTC_SATURATED;
                    status = PTC_SATURATED;
                } else {
                    /* neither */
                }
                self->last = last_now;
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
                u[2] = 0.0;
                if (PTC_FINITE_F64(law_3)) {
                    axes[2] = status;
                } else {
                    axes[2] = PTC_E_RANGE;
                }
                status = PTC_E_RANGE;
            }
        } else {
            for (uint32_t i = 0U; i < 3U; i++) {
                u[i] = 0.0;
                axes[i] = PTC_E_INPUT;
            }
        }
    } else {
        if (u != NULL) {
            for (uint32_t i = 0U; i < 3U; i++) {
                u[i] = 0.0;
            }
        }
        if (axes != NULL) {
            for (uint32_t i = 0U; i < 3U; i++) {
                axes[i] = PTC_E_INPUT;
            }
        }
    }
    return status;
}

ptc_status gantry_in_flight_arm_for(gantry_in_flight *self, uint32_t k, uint32_t samples)
{
    ptc_status status = PTC_E_PARAM;

    if (self != NULL) {
        if ((samples > 1U) && (samples < 2147483649U)) {
            self->start = k;
            self->last = samples;
            status = PTC_OK;
        }
    }
    return status;
}

ptc_status gantry_in_flight_soonest(
    const gantry_in_flight *self,
    const double x[3][2],
    uint32_t *samples)
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (x != NULL) && (samples != NULL)) {
        if (PTC_FINITE_F64(x[0][0])
            && PTC_FINITE_F64(x[0][1])
            && PTC_FINITE_F64(x[1][0])
            && PTC_FINITE_F64(x[1][1])
            && PTC_FINITE_F64(x[2][0])
            && PTC_FINITE_F64(x[2][1])) {
            const double x1_1 = x[0][0];
            const double x2_1 = x[0][1];
            const double x1_2 = x[1][0];
            const double x2_2 = x[1][1];
            const double x1_3 = x[2][0];
            const double x2_3 = x[2][1];
            const double flat1_1 = (GANTRY_IN_FLIGHT_S1_1_1 * x1_1) + (GANTRY_IN_FLIGHT_S1_2_1 * x2_1);
            const double flat2_1 = GANTRY_IN_FLIGHT_S2_2_1 * x2_1;
            const double flat1_2 = (GANTRY_IN_FLIGHT_S1_1_2 * x1_2) + (GANTRY_IN_FLIGHT_S1_2_2 * x2_2);
            const double flat2_2 = GANTRY_IN_FLIGHT_S2_2_2 * x2_2;
            const double flat1_3 = (GANTRY_IN_FLIGHT_S1_1_3 * x1_3) + (GANTRY_IN_FLIGHT_S1_2_3 * x2_3);
            const double flat2_3 = GANTRY_IN_FLIGHT_S2_2_3 * x2_3;
            uint32_t low = 20U;
            uint32_t top = 1073741825U;
            uint32_t kept = 0U;
            uint32_t tried = 21U;
            for (uint32_t attempt = 0U; attempt < 64U; attempt++) {
                const double least_1 = 0.899999999999773 * GANTRY_IN_FLIGHT_U_MIN_1;
                const double most_1 = 0.899999999999773 * GANTRY_IN_FLIGHT_U_MAX_1;
                const double within_1 = (-least_1 < most_1) ? -least_1 : most_1;
                const double most2_1 = 1.3499999999996595;
                const double least_2 = 0.899999999999773 * GANTRY_IN_FLIGHT_U_MIN_2;
                const double most_2 = 0.899999999999773 * GANTRY_IN_FLIGHT_U_MAX_2;
                const double within_2 = (-least_2 < most_2) ? -least_2 : most_2;
                const double least_3 = 0.899999999999773 * GANTRY_IN_FLIGHT_U_MIN_3;
                const double most_3 = 0.899999999999773 * GANTRY_IN_FLIGHT_U_MAX_3;
                const double within_3 = (-least_3 < most_3) ? -least_3 : most_3;
                const double most2_3 = 0.35999999999990917;
                uint32_t fits = 0U;
                if (tried > 50U) {
                    const double m_1 = (double)tried;
                    const double power1_1 = m_1 + 1.0;
                    const double power2_1 = power1_1 * m_1;
                    const double power3_1 = power2_1 * (m_1 - 1.0);
                    const double scaled2_1 = flat2_1 * power1_1;
                    const double w1_1 = ((3.0 * flat1_1) + scaled2_1) / power2_1;
                    const double w2_1 = (((-2.0) * flat1_1) - scaled2_1) / power3_1;
                    const double length_1 = m_1 - 51.0;
                    const double b0_c_1 = (2.0 * w1_1) + (300.0 * w2_1);
                    const double b1_c_1 = 6.0 * w2_1 * length_1;
                    const double b1_1 = b0_c_1 + b1_c_1;
                    const double s0_c_1 = ((-0.00085) * w1_1) - (0.06375 * w2_1);
                    const double s1_c_1 = (((-1.6666666666666667e-5) * w1_1) - (0.002525 * w2_1)) * length_1;
                    const double s2_l_1 = length_1 * length_1;
                    const double s2_c_1 = (-2.5e-5) * w2_1 * s2_l_1;
                    const double s1_1 = s0_c_1 + (0.16666666666666666 * s1_c_1);
                    const double s1 = s0_c_1 + (0.3333333333333333 * s1_c_1);
                    const double s2_1 = s1 + (0.06666666666666667 * s2_c_1);
                    const double s3_1 = s0_c_1 + (0.5 * s1_c_1) + (0.2 * s2_c_1);
                    const double s4_1 = s0_c_1 + (0.6666666666666666 * s1_c_1) + (0.4 * s2_c_1);
                    const double s2 = s0_c_1 + (0.8333333333333334 * s1_c_1);
                    const double s5_1 = s2 + (0.6666666666666666 * s2_c_1);
                    const double s6_1 = s0_c_1 + s1_c_1 + s2_c_1;
                    const double end21_1 = (2.8506787330316743 * w1_1) + (117.44796380090497 * w2_1);
                    const double end22_1 = (3.0475113122171944 * w1_1) + (145.85746606334843 * w2_1);
                    const double end23_1 = (2.9906485671191554 * w1_1) + (175.02805429864253 * w2_1);
                    const double end24_1 = (2.6800904977375564 * w1_1) + (204.95972850678734 * w2_1);
                    const double end25_1 = (2.1158371040723982 * w1_1) + (235.6524886877828 * w2_1);
                    const double end26_1 = (1.2978883861236803 * w1_1) + (267.10633484162895 * w2_1);
                    const double end27_1 = (0.22624434389140272 * w1_1) + (299.3212669683258 * w2_1);
                    if ((least_1 <= b0_c_1)
                        && (b0_c_1 <= most_1)
                        && (least_1 <= b1_1)
                        && (b1_1 <= most_1)
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
                        && (least_1 <= end21_1)
                        && (end21_1 <= most_1)
                        && (least_1 <= end22_1)
                        && (end22_1 <= most_1)
                        && (least_1 <= end23_1)
                        && (end23_1 <= most_1)
                        && (least_1 <= end24_1)
                        && (end24_1 <= most_1)
                        && (least_1 <= end25_1)
                        && (end25_1 <= most_1)
                        && (least_1 <= end26_1)
                        && (end26_1 <= most_1)
                        && (least_1 <= end27_1)
                        && (end27_1 <= most_1)
                        && (fabs(((-0.0003193815987933635) * w1_1) - (0.01059185520361991 * w2_1)) <= most2_1)
                        && (fabs(((-0.000418474825827767) * w1_1) - (0.014748146951088127 * w2_1)) <= most2_1)
                        && (fabs(((-0.0005236084177260647) * w1_1) - (0.019887508080155138 * w2_1)) <= most2_1)
                        && (fabs(((-0.0006260238454356102) * w1_1) - (0.026036214177978884 * w2_1)) <= most2_1)
                        && (fabs(((-0.0007169625799037563) * w1_1) - (0.0332205408317173 * w2_1)) <= most2_1)
                        && (fabs(((-0.0007876660920778567) * w1_1) - (0.04146676362852834 * w2_1)) <= most2_1)
                        && (fabs(((-0.0008293758529052647) * w1_1) - (0.05080115815556992 * w2_1)) <= most2_1)
                        && (fabs(((-0.0008333333333333334) * w1_1) - (0.06125 * w2_1)) <= most2_1)
                        && (fabs((2.8054298642533926 * w1_1) + (111.58371040723979 * w2_1)) <= 0.9850746268656713 * within_1)
                        && (fabs((2.583924302196364 * w1_1) + (85.00144425360725 * w2_1)) <= 0.9850746268656713 * within_1)
                        && (fabs((1.9885945165034657 * w1_1) + (61.86959300518941 * w2_1)) <= 0.9850746268656713 * within_1)
                        && (fabs((2.9380703330283167 * w1_1) + (105.39729178384643 * w2_1)) <= 0.9850746268656713 * within_1)
                        && (fabs((2.395997187424203 * w1_1) + (77.20565274199532 * w2_1)) <= 0.9850746268656713 * within_1)
                        && (fabs((2.8712027904432142 * w1_1) + (99.5000219686458 * w2_1)) <= 0.9850746268656713 * within_1)
                        && (fabs(((-0.00029562594268476623) * w1_1) - (0.009613122171945702 * w2_1)) <= 0.9850746268656717 * most2_1)
                        && (fabs(((-0.00017656644504526514) * w1_1) - (0.005290649279938502 * w2_1)) <= 0.9850746268656717 * most2_1)
                        && (fabs(((-0.00011677836082279918) * w1_1) - (0.003360345134034913 * w2_1)) <= 0.9850746268656717 * most2_1)
                        && (fabs(((-0.000247869777281542) * w1_1) - (0.007769377681142387 * w2_1)) <= 0.9850746268656717 * most2_1)
                        && (fabs(((-0.00015503374252696212) * w1_1) - (0.004582303911158442 * w2_1)) <= 0.9850746268656717 * most2_1)
                        && (fabs(((-0.00022338585783963935) * w1_1) - (0.006891066916277001 * w2_1)) <= 0.9850746268656717 * most2_1)) {
                        fits = 1U;
                    }
                } else {
                    const double m_1 = (double)tried;
                    const double power1_1 = m_1 + 2.0;
                    const double power2_1 = power1_1 * (m_1 + 1.0);
                    const double power3_1 = power2_1 * m_1;
                    const double power4_1 = power3_1 * (m_1 - 1.0);
                    const double scaled2_1 = flat2_1 * power1_1;
                    const double w1_1 = ((4.0 * flat1_1) + scaled2_1) / power3_1;
                    const double w2_1 = (((-3.0) * flat1_1) - scaled2_1) / power4_1;
                    const double length_1 = m_1 - 21.0;
                    const double b0_c_1 = (126.0 * w1_1) + (5040.0 * w2_1);
                    const double b1_c_1 = ((6.0 * w1_1) + (492.0 * w2_1)) * length_1;
                    const double b2_l_1 = length_1 * length_1;
                    const double b2_c_1 = 12.0 * w2_1 * b2_l_1;
                    const double b1_1 = b0_c_1 + (0.16666666666666666 * b1_c_1);
                    const double s3 = b0_c_1 + (0.3333333333333333 * b1_c_1);
                    const double b2_1 = s3 + (0.06666666666666667 * b2_c_1);
                    const double b3_1 = b0_c_1 + (0.5 * b1_c_1) + (0.2 * b2_c_1);
                    const double b4_1 = b0_c_1 + (0.6666666666666666 * b1_c_1) + (0.4 * b2_c_1);
                    const double s4 = b0_c_1 + (0.8333333333333334 * b1_c_1);
                    const double b5_1 = s4 + (0.6666666666666666 * b2_c_1);
                    const double b6_1 = b0_c_1 + b1_c_1 + b2_c_1;
                    const double s0_c_1 = ((-0.01155) * w1_1) - (0.308 * w2_1);
                    const double s1_c_1 = (((-0.001075) * w1_1) - (0.044066666666666664 * w2_1)) * length_1;
                    const double s2_l_1 = length_1 * length_1;
                    const double s2_c_1 = (((-2.5e-5) * w1_1) - (0.0021 * w2_1)) * s2_l_1;
                    const double s3_l_1 = s2_l_1 * length_1;
                    const double s3_c_1 = (-3.3333333333333335e-5) * w2_1 * s3_l_1;
                    const double s1_1 = s0_c_1 + (0.14285714285714285 * s1_c_1);
                    const double s5 = s0_c_1 + (0.2857142857142857 * s1_c_1);
                    const double s2_1 = s5 + (0.047619047619047616 * s2_c_1);
                    const double s6 = s0_c_1 + (0.42857142857142855 * s1_c_1);
                    const double s7 = s6 + (0.14285714285714285 * s2_c_1);
                    const double s3_1 = s7 + (0.02857142857142857 * s3_c_1);
                    const double s8 = s0_c_1 + (0.5714285714285714 * s1_c_1);
                    const double s9 = s8 + (0.2857142857142857 * s2_c_1);
                    const double s4_1 = s9 + (0.11428571428571428 * s3_c_1);
                    const double s10 = s0_c_1 + (0.7142857142857143 * s1_c_1);
                    const double s11 = s10 + (0.47619047619047616 * s2_c_1);
                    const double s5_1 = s11 + (0.2857142857142857 * s3_c_1);
                    const double s12 = s0_c_1 + (0.8571428571428571 * s1_c_1);
                    const double s13 = s12 + (0.7142857142857143 * s2_c_1);
                    const double s6_1 = s13 + (0.5714285714285714 * s3_c_1);
                    const double s7_1 = s0_c_1 + s1_c_1 + s2_c_1 + s3_c_1;
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
                        && (fabs((119.99999999999996 * w1_1) + (4559.999999999999 * w2_1)) <= 0.9850746268656713 * within_1)
                        && (fabs((92.75321716019634 * w1_1) + (2422.754466594877 * w2_1)) <= 0.9850746268656713 * within_1)
                        && (fabs((67.8353765546998 * w1_1) + (1509.7849977027897 * w2_1)) <= 0.9850746268656713 * within_1)
                        && (fabs((114.21150278293138 * w1_1) + (3629.3877551020414 * w2_1)) <= 0.9850746268656713 * within_1)
                        && (fabs((84.39364430426792 * w1_1) + (2085.179889377806 * w2_1)) <= 0.9850746268656713 * within_1)
                        && (fabs((108.11363033997543 * w1_1) + (3196.9332337421392 * w2_1)) <= 0.9850746268656713 * within_1)
                        && (fabs(((-0.0105) * w1_1) - (0.266 * w2_1)) <= 0.9850746268656717 * most2_1)
                        && (fabs(((-0.005820348615074297) * w1_1) - (0.1137806492473866 * w2_1)) <= 0.9850746268656717 * most2_1)
                        && (fabs(((-0.003710680216503311) * w1_1) - (0.06137180874826767 * w2_1)) <= 0.9850746268656717 * most2_1)
                        && (fabs(((-0.008512987012987014) * w1_1) - (0.19394805194805195 * w2_1)) <= 0.9850746268656717 * most2_1)
                        && (fabs(((-0.005047405138739329) * w1_1) - (0.09359102869242929 * w2_1)) <= 0.9850746268656717 * most2_1)
                        && (fabs(((-0.007561224489795918) * w1_1) - (0.16370315398886828 * w2_1)) <= 0.9850746268656717 * most2_1)) {
                        fits = 1U;
                    }
                }
                if (fits == 1U) {
                    if (tried > 50U) {
                        const double m_2 = (double)tried;
                        const double power1_2 = m_2 + 1.0;
                        const double power2_2 = power1_2 * m_2;
                        const double power3_2 = power2_2 * (m_2 - 1.0);
                        const double scaled2_2 = flat2_2 * power1_2;
                        const double w1_2 = ((3.0 * flat1_2) + scaled2_2) / power2_2;
                        const double w2_2 = (((-2.0) * flat1_2) - scaled2_2) / power3_2;
                        const double length_2 = m_2 - 51.0;
                        const double b0_c_2 = (2.0 * w1_2) + (300.0 * w2_2);
                        const double b1_c_2 = 6.0 * w2_2 * length_2;
                        const double b1_2 = b0_c_2 + b1_c_2;
                        const double end11_2 = (2.8506787330316743 * w1_2) + (117.44796380090497 * w2_2);
                        const double end12_2 = (3.0475113122171944 * w1_2) + (145.85746606334843 * w2_2);
                        const double end13_2 = (2.9906485671191554 * w1_2) + (175.02805429864253 * w2_2);
                        const double end14_2 = (2.6800904977375564 * w1_2) + (204.95972850678734 * w2_2);
                        const double end15_2 = (2.1158371040723982 * w1_2) + (235.6524886877828 * w2_2);
                        const double end16_2 = (1.2978883861236803 * w1_2) + (267.10633484162895 * w2_2);
                        const double end17_2 = (0.22624434389140272 * w1_2) + (299.3212669683258 * w2_2);
                        if ((least_2 <= b0_c_2)
                            && (b0_c_2 <= most_2)
                            && (least_2 <= b1_2)
                            && (b1_2 <= most_2)
                            && (least_2 <= end11_2)
                            && (end11_2 <= most_2)
                            && (least_2 <= end12_2)
                            && (end12_2 <= most_2)
                            && (least_2 <= end13_2)
                            && (end13_2 <= most_2)
                            && (least_2 <= end14_2)
                            && (end14_2 <= most_2)
                            && (least_2 <= end15_2)
                            && (end15_2 <= most_2)
                            && (least_2 <= end16_2)
                            && (end16_2 <= most_2)
                            && (least_2 <= end17_2)
                            && (end17_2 <= most_2)
                            && (fabs((2.8054298642533926 * w1_2) + (111.58371040723979 * w2_2)) <= 0.9850746268656713 * within_2)
                            && (fabs((2.583924302196364 * w1_2) + (85.00144425360725 * w2_2)) <= 0.9850746268656713 * within_2)
                            && (fabs((1.9885945165034657 * w1_2) + (61.86959300518941 * w2_2)) <= 0.9850746268656713 * within_2)
                            && (fabs((2.9380703330283167 * w1_2) + (105.39729178384643 * w2_2)) <= 0.9850746268656713 * within_2)
                            && (fabs((2.395997187424203 * w1_2) + (77.20565274199532 * w2_2)) <= 0.9850746268656713 * within_2)
                            && (fabs((2.8712027904432142 * w1_2) + (99.5000219686458 * w2_2)) <= 0.9850746268656713 * within_2)) {
                            fits = 2U;
                        }
                    } else {
                        const double m_2 = (double)tried;
                        const double power1_2 = m_2 + 2.0;
                        const double power2_2 = power1_2 * (m_2 + 1.0);
                        const double power3_2 = power2_2 * m_2;
                        const double power4_2 = power3_2 * (m_2 - 1.0);
                        const double scaled2_2 = flat2_2 * power1_2;
                        const double w1_2 = ((4.0 * flat1_2) + scaled2_2) / power3_2;
                        const double w2_2 = (((-3.0) * flat1_2) - scaled2_2) / power4_2;
                        const double length_2 = m_2 - 21.0;
                        const double b0_c_2 = (126.0 * w1_2) + (5040.0 * w2_2);
                        const double b1_c_2 = ((6.0 * w1_2) + (492.0 * w2_2)) * length_2;
                        const double b2_l_2 = length_2 * length_2;
                        const double b2_c_2 = 12.0 * w2_2 * b2_l_2;
                        const double b1_2 = b0_c_2 + (0.16666666666666666 * b1_c_2);
                        const double s14 = b0_c_2 + (0.3333333333333333 * b1_c_2);
                        const double b2_2 = s14 + (0.06666666666666667 * b2_c_2);
                        const double b3_2 = b0_c_2 + (0.5 * b1_c_2) + (0.2 * b2_c_2);
                        const double b4_2 = b0_c_2 + (0.6666666666666666 * b1_c_2) + (0.4 * b2_c_2);
                        const double s15 = b0_c_2 + (0.8333333333333334 * b1_c_2);
                        const double b5_2 = s15 + (0.6666666666666666 * b2_c_2);
                        const double b6_2 = b0_c_2 + b1_c_2 + b2_c_2;
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
                            && (fabs((119.99999999999996 * w1_2) + (4559.999999999999 * w2_2)) <= 0.9850746268656713 * within_2)
                            && (fabs((92.75321716019634 * w1_2) + (2422.754466594877 * w2_2)) <= 0.9850746268656713 * within_2)
                            && (fabs((67.8353765546998 * w1_2) + (1509.7849977027897 * w2_2)) <= 0.9850746268656713 * within_2)
                            && (fabs((114.21150278293138 * w1_2) + (3629.3877551020414 * w2_2)) <= 0.9850746268656713 * within_2)
                            && (fabs((84.39364430426792 * w1_2) + (2085.179889377806 * w2_2)) <= 0.9850746268656713 * within_2)
                            && (fabs((108.11363033997543 * w1_2) + (3196.9332337421392 * w2_2)) <= 0.9850746268656713 * within_2)) {
                            fits = 2U;
                        }
                    }
                }
                if (fits == 2U) {
                    if (tried > 50U) {
                        const double m_3 = (double)tried;
                        const double power1_3 = m_3 + 1.0;
                        const double power2_3 = power1_3 * m_3;
                        const double power3_3 = power2_3 * (m_3 - 1.0);
                        const double scaled2_3 = flat2_3 * power1_3;
                        const double w1_3 = ((3.0 * flat1_3) + scaled2_3) / power2_3;
                        const double w2_3 = (((-2.0) * flat1_3) - scaled2_3) / power3_3;
                        const double length_3 = m_3 - 51.0;
                        const double b0_c_3 = (2.0 * w1_3) + (300.0 * w2_3);
                        const double b1_c_3 = 6.0 * w2_3 * length_3;
                        const double b1_3 = b0_c_3 + b1_c_3;
                        const double s0_c_3 = ((-0.0085) * w1_3) - (0.6375 * w2_3);
                        const double s1_c_3 = (((-0.00016666666666666666) * w1_3) - (0.02525 * w2_3)) * length_3;
                        const double s2_l_3 = length_3 * length_3;
                        const double s2_c_3 = (-0.00025) * w2_3 * s2_l_3;
                        const double s1_3 = s0_c_3 + (0.16666666666666666 * s1_c_3);
                        const double s16 = s0_c_3 + (0.3333333333333333 * s1_c_3);
                        const double s2_3 = s16 + (0.06666666666666667 * s2_c_3);
                        const double s3_3 = s0_c_3 + (0.5 * s1_c_3) + (0.2 * s2_c_3);
                        const double s4_3 = s0_c_3 + (0.6666666666666666 * s1_c_3) + (0.4 * s2_c_3);
                        const double s17 = s0_c_3 + (0.8333333333333334 * s1_c_3);
                        const double s5_3 = s17 + (0.6666666666666666 * s2_c_3);
                        const double s6_3 = s0_c_3 + s1_c_3 + s2_c_3;
                        const double end21_3 = (2.8506787330316743 * w1_3) + (117.44796380090497 * w2_3);
                        const double end22_3 = (3.0475113122171944 * w1_3) + (145.85746606334843 * w2_3);
                        const double end23_3 = (2.9906485671191554 * w1_3) + (175.02805429864253 * w2_3);
                        const double end24_3 = (2.6800904977375564 * w1_3) + (204.95972850678734 * w2_3);
                        const double end25_3 = (2.1158371040723982 * w1_3) + (235.6524886877828 * w2_3);
                        const double end26_3 = (1.2978883861236803 * w1_3) + (267.10633484162895 * w2_3);
                        const double end27_3 = (0.22624434389140272 * w1_3) + (299.3212669683258 * w2_3);
                        if ((least_3 <= b0_c_3)
                            && (b0_c_3 <= most_3)
                            && (least_3 <= b1_3)
                            && (b1_3 <= most_3)
                            && (-most2_3 <= s0_c_3)
                            && (s0_c_3 <= most2_3)
                            && (-most2_3 <= s1_3)
                            && (s1_3 <= most2_3)
                            && (-most2_3 <= s2_3)
                            && (s2_3 <= most2_3)
                            && (-most2_3 <= s3_3)
                            && (s3_3 <= most2_3)
                            && (-most2_3 <= s4_3)
                            && (s4_3 <= most2_3)
                            && (-most2_3 <= s5_3)
                            && (s5_3 <= most2_3)
                            && (-most2_3 <= s6_3)
                            && (s6_3 <= most2_3)
                            && (least_3 <= end21_3)
                            && (end21_3 <= most_3)
                            && (least_3 <= end22_3)
                            && (end22_3 <= most_3)
                            && (least_3 <= end23_3)
                            && (end23_3 <= most_3)
                            && (least_3 <= end24_3)
                            && (end24_3 <= most_3)
                            && (least_3 <= end25_3)
                            && (end25_3 <= most_3)
                            && (least_3 <= end26_3)
                            && (end26_3 <= most_3)
                            && (least_3 <= end27_3)
                            && (end27_3 <= most_3)
                            && (fabs(((-0.003193815987933635) * w1_3) - (0.1059185520361991 * w2_3)) <= most2_3)
                            && (fabs(((-0.00418474825827767) * w1_3) - (0.14748146951088129 * w2_3)) <= most2_3)
                            && (fabs(((-0.005236084177260648) * w1_3) - (0.1988750808015514 * w2_3)) <= most2_3)
                            && (fabs(((-0.006260238454356102) * w1_3) - (0.26036214177978884 * w2_3)) <= most2_3)
                            && (fabs(((-0.007169625799037563) * w1_3) - (0.33220540831717305 * w2_3)) <= most2_3)
                            && (fabs(((-0.007876660920778569) * w1_3) - (0.41466763628528336 * w2_3)) <= most2_3)
                            && (fabs(((-0.008293758529052647) * w1_3) - (0.5080115815556993 * w2_3)) <= most2_3)
                            && (fabs(((-0.008333333333333333) * w1_3) - (0.6125 * w2_3)) <= most2_3)
                            && (fabs((2.8054298642533926 * w1_3) + (111.58371040723979 * w2_3)) <= 0.9850746268656713 * within_3)
                            && (fabs((2.583924302196364 * w1_3) + (85.00144425360725 * w2_3)) <= 0.9850746268656713 * within_3)
                            && (fabs((1.9885945165034657 * w1_3) + (61.86959300518941 * w2_3)) <= 0.9850746268656713 * within_3)
                            && (fabs((2.9380703330283167 * w1_3) + (105.39729178384643 * w2_3)) <= 0.9850746268656713 * within_3)
                            && (fabs((2.395997187424203 * w1_3) + (77.20565274199532 * w2_3)) <= 0.9850746268656713 * within_3)
                            && (fabs((2.8712027904432142 * w1_3) + (99.5000219686458 * w2_3)) <= 0.9850746268656713 * within_3)
                            && (fabs(((-0.002956259426847662) * w1_3) - (0.09613122171945701 * w2_3)) <= 0.9850746268656717 * most2_3)
                            && (fabs(((-0.0017656644504526516) * w1_3) - (0.05290649279938503 * w2_3)) <= 0.9850746268656717 * most2_3)
                            && (fabs(((-0.0011677836082279918) * w1_3) - (0.03360345134034914 * w2_3)) <= 0.9850746268656717 * most2_3)
                            && (fabs(((-0.0024786977728154204) * w1_3) - (0.07769377681142388 * w2_3)) <= 0.9850746268656717 * most2_3)
                            && (fabs(((-0.0015503374252696213) * w1_3) - (0.04582303911158442 * w2_3)) <= 0.9850746268656717 * most2_3)
                            && (fabs(((-0.0022338585783963937) * w1_3) - (0.06891066916277001 * w2_3)) <= 0.9850746268656717 * most2_3)) {
                            fits = 3U;
                        }
                    } else {
                        const double m_3 = (double)tried;
                        const double power1_3 = m_3 + 2.0;
                        const double power2_3 = power1_3 * (m_3 + 1.0);
                        const double power3_3 = power2_3 * m_3;
                        const double power4_3 = power3_3 * (m_3 - 1.0);
                        const double scaled2_3 = flat2_3 * power1_3;
                        const double w1_3 = ((4.0 * flat1_3) + scaled2_3) / power3_3;
                        const double w2_3 = (((-3.0) * flat1_3) - scaled2_3) / power4_3;
                        const double length_3 = m_3 - 21.0;
                        const double b0_c_3 = (126.0 * w1_3) + (5040.0 * w2_3);
                        const double b1_c_3 = ((6.0 * w1_3) + (492.0 * w2_3)) * length_3;
                        const double b2_l_3 = length_3 * length_3;
                        const double b2_c_3 = 12.0 * w2_3 * b2_l_3;
                        const double b1_3 = b0_c_3 + (0.16666666666666666 * b1_c_3);
                        const double s18 = b0_c_3 + (0.3333333333333333 * b1_c_3);
                        const double b2_3 = s18 + (0.06666666666666667 * b2_c_3);
                        const double b3_3 = b0_c_3 + (0.5 * b1_c_3) + (0.2 * b2_c_3);
                        const double b4_3 = b0_c_3 + (0.6666666666666666 * b1_c_3) + (0.4 * b2_c_3);
                        const double s19 = b0_c_3 + (0.8333333333333334 * b1_c_3);
                        const double b5_3 = s19 + (0.6666666666666666 * b2_c_3);
                        const double b6_3 = b0_c_3 + b1_c_3 + b2_c_3;
                        const double s0_c_3 = ((-0.1155) * w1_3) - (3.08 * w2_3);
                        const double s1_c_3 = (((-0.01075) * w1_3) - (0.44066666666666665 * w2_3)) * length_3;
                        const double s2_l_3 = length_3 * length_3;
                        const double s2_c_3 = (((-0.00025) * w1_3) - (0.021 * w2_3)) * s2_l_3;
                        const double s3_l_3 = s2_l_3 * length_3;
                        const double s3_c_3 = (-0.0003333333333333333) * w2_3 * s3_l_3;
                        const double s1_3 = s0_c_3 + (0.14285714285714285 * s1_c_3);
                        const double s20 = s0_c_3 + (0.2857142857142857 * s1_c_3);
                        const double s2_3 = s20 + (0.047619047619047616 * s2_c_3);
                        const double s21 = s0_c_3 + (0.42857142857142855 * s1_c_3);
                        const double s22 = s21 + (0.14285714285714285 * s2_c_3);
                        const double s3_3 = s22 + (0.02857142857142857 * s3_c_3);
                        const double s23 = s0_c_3 + (0.5714285714285714 * s1_c_3);
                        const double s24 = s23 + (0.2857142857142857 * s2_c_3);
                        const double s4_3 = s24 + (0.11428571428571428 * s3_c_3);
                        const double s25 = s0_c_3 + (0.7142857142857143 * s1_c_3);
                        const double s26 = s25 + (0.47619047619047616 * s2_c_3);
                        const double s5_3 = s26 + (0.2857142857142857 * s3_c_3);
                        const double s27 = s0_c_3 + (0.8571428571428571 * s1_c_3);
                        const double s28 = s27 + (0.7142857142857143 * s2_c_3);
                        const double s6_3 = s28 + (0.5714285714285714 * s3_c_3);
                        const double s7_3 = s0_c_3 + s1_c_3 + s2_c_3 + s3_c_3;
                        if ((least_3 <= b0_c_3)
                            && (b0_c_3 <= most_3)
                            && (least_3 <= b1_3)
                            && (b1_3 <= most_3)
                            && (least_3 <= b2_3)
                            && (b2_3 <= most_3)
                            && (least_3 <= b3_3)
                            && (b3_3 <= most_3)
                            && (least_3 <= b4_3)
                            && (b4_3 <= most_3)
                            && (least_3 <= b5_3)
                            && (b5_3 <= most_3)
                            && (least_3 <= b6_3)
                            && (b6_3 <= most_3)
                            && (-most2_3 <= s0_c_3)
                            && (s0_c_3 <= most2_3)
                            && (-most2_3 <= s1_3)
                            && (s1_3 <= most2_3)
                            && (-most2_3 <= s2_3)
                            && (s2_3 <= most2_3)
                            && (-most2_3 <= s3_3)
                            && (s3_3 <= most2_3)
                            && (-most2_3 <= s4_3)
                            && (s4_3 <= most2_3)
                            && (-most2_3 <= s5_3)
                            && (s5_3 <= most2_3)
                            && (-most2_3 <= s6_3)
                            && (s6_3 <= most2_3)
                            && (-most2_3 <= s7_3)
                            && (s7_3 <= most2_3)
                            && (fabs((119.99999999999996 * w1_3) + (4559.999999999999 * w2_3)) <= 0.9850746268656713 * within_3)
                            && (fabs((92.75321716019634 * w1_3) + (2422.754466594877 * w2_3)) <= 0.9850746268656713 * within_3)
                            && (fabs((67.8353765546998 * w1_3) + (1509.7849977027897 * w2_3)) <= 0.9850746268656713 * within_3)
                            && (fabs((114.21150278293138 * w1_3) + (3629.3877551020414 * w2_3)) <= 0.9850746268656713 * within_3)
                            && (fabs((84.39364430426792 * w1_3) + (2085.179889377806 * w2_3)) <= 0.9850746268656713 * within_3)
                            && (fabs((108.11363033997543 * w1_3) + (3196.9332337421392 * w2_3)) <= 0.9850746268656713 * within_3)
                            && (fabs(((-0.105) * w1_3) - (2.6599999999999997 * w2_3)) <= 0.9850746268656717 * most2_3)
                            && (fabs(((-0.058203486150742986) * w1_3) - (1.1378064924738662 * w2_3)) <= 0.9850746268656717 * most2_3)
                            && (fabs(((-0.037106802165033106) * w1_3) - (0.6137180874826768 * w2_3)) <= 0.9850746268656717 * most2_3)
                            && (fabs(((-0.08512987012987014) * w1_3) - (1.9394805194805198 * w2_3)) <= 0.9850746268656717 * most2_3)
                            && (fabs(((-0.05047405138739328) * w1_3) - (0.9359102869242929 * w2_3)) <= 0.9850746268656717 * most2_3)
                            && (fabs(((-0.07561224489795919) * w1_3) - (1.637031539888683 * w2_3)) <= 0.9850746268656717 * most2_3)) {
                            fits = 3U;
                        }
                    }
                }
                if (fits == 3U) {
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
                && PTC_FINITE_F64(flat1_2)
                && PTC_FINITE_F64(flat2_2)
                && PTC_FINITE_F64(flat1_3)
                && PTC_FINITE_F64(flat2_3)) {
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

ptc_status gantry_in_flight_deadline(const gantry_in_flight *self, uint32_t *k)
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (k != NULL)) {
        *k = self->start - (0U - self->last);
        status = PTC_OK;
    }
    return status;
}
