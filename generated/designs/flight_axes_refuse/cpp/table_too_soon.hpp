/*
 * Prescribed-time controller table_too_soon: order n = 3, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang cpp --n 3 --axes 2 --mu "exp(a=1)" --name table_too_soon --clock samples --late=refuse --state-max=inf,0.5,4 --tau=1.5 --eps=0 --u-min=runtime --poles="[[-3,-4,-5],[-4,-5,-6]]" --sample-time=0.01
 * Version 0.1.0, design ed84b87c488b.
 *
 * Plant: x1' = x2, ..., x3' = u; u held from sample to sample.
 * Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
 *       sample period, as long as u is not clipped and nothing else acts on the plant.
 * Law: with M samples to go and z = S x, u h^3 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-2));
 *       the rows are those of Theorem 1 for the mapping exp. From 8 samples to go on these
 *       are M - 2 and the exponents 3, 4, 5, those of least energy. The gains of 3 samples to
 *       go stay: they are deadbeat.
 * Axes: 2, each a chain of its own with this deadline and mapping. step computes what depends
 *       on time once.
 *   axis 1: k = 60, 47, 12
 *   axis 2: k = 120, 74, 15
 *
 * Parameters:
 *   samples = 150 [samples], fixed: samples N from the start to rest
 *   h = 0.01 [s], fixed: sample period
 *   eps = 0 [s], fixed: time-to-go at which the gains are held
 *   u_max [unit of u]: upper limit of u
 *   u_min [unit of u]: lower limit of u
 *   a = 1 [1/s], fixed: rate of stretched time
 *
 * k counts samples and may wrap; arm again within 2^32 - N samples.
 * From sample N on the last gains are held (status HOLD).
 * In flight: arm_for sets another deadline at any tick; rest is exact from any state, so all
 *       else stays as it is.
 * Plan: on the way to rest u and the states are sums of falling powers of the samples to go,
 *       so their Bernstein coefficients, linear in z, bound them. If these are within the
 *       limits, u and |x2| <= 0.5 and |x3| <= 4 stay there at every sample to rest, where
 *       plant and state are as they are known.
 * Axes: all come to rest at the same sample, and each deadline is tested for every one of
 *       them.
 * late refuse: arm_for refuses a deadline without such a plan (status E_SOON).
 * u_min <= u <= u_max: u is clipped to these limits (status SATURATED). Clipping voids the
 *       deadline where it lasts.
 * Guard full: what is measured is finite, or the call is refused (INPUT).
 * Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
 *       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
 *
 * Checks of the design (details: ptc-codegen check):
 *   membership: sound: exp is of class M for all its parameters.
 *   growth: sound: at rest at sample 150 from any state, whatever the poles, and |u| is
 *       bounded.
 *   sampling: not checked: the law is exact in samples, at any period.
 *   deadline: not checked: the law is exact in samples, at any period.
 *   loop: not checked: `x0_max` is not given.
 *   envelope: not checked: it does not examine a clock in samples.
 */
#ifndef TABLE_TOO_SOON_7EA445B8_HPP
#define TABLE_TOO_SOON_7EA445B8_HPP

#include <array>
#include <cfloat>
#include <cstddef>
#include <cstdint>
#include <limits>

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

namespace ptc {

#ifndef PTC_STATUS_HPP
#define PTC_STATUS_HPP
/// Outcome of a call; a negative one leaves u = 0.
enum class Status : int {
    Ok = 0, ///< tracking
    Hold = 1, ///< time-to-go held at eps: the deadline is near or over, u is valid
    Saturated = 2, ///< u clipped to its limits; wins over Hold and After
    After = 3, ///< the deadline is over: u is 0 or that of the user-defined law
    Gated = 4, ///< a reading was not believed: u by prediction alone; wins over all above
    Late = 5, ///< the deadline was put off, as a limit would have been exceeded: u is valid
    Infeasible = 6, ///< nothing is known from here that keeps all limits or bounds: u is valid
    Param = -1, ///< a parameter outside its domain, or coefficients outside the range
    Input = -2, ///< x or t not finite, or t before t0
    Range = -3, ///< u not finite
    Soon = -4 ///< a deadline too soon for the limits, or none that keeps them
};

/// Result of a step.
template <class Real>
struct [[nodiscard]] Control {
    Real u; ///< input of the plant
    Status status; ///< its status
};

/// What the infinite-time system gives.
template <class State>
struct [[nodiscard]] Rate {
    State xi_dot; ///< zeros on a negative status
    Status status;
};
#endif

#ifndef PTC_VALUE_HPP
#define PTC_VALUE_HPP
/// A value and the status of the call that gave it.
template <class Given>
struct [[nodiscard]] Value {
    Given value; ///< zeros on a negative status
    Status status;
};
#endif

#ifndef PTC_AXES_HPP
#define PTC_AXES_HPP
/// Result of a step of several axes.
template <class Real, std::size_t Count>
struct [[nodiscard]] Axes {
    std::array<Real, Count> u{}; ///< inputs of the plants, 0 on a negative status
    std::array<Status, Count> axes{}; ///< status of each axis
    Status status{Status::Input}; ///< that of the first axis that fails; else Saturated where one is
};
#endif

/// Run-time parameters.
struct TableTooSoonParams {
    double u_max{}; ///< upper limit of u [unit of u], > u_min, infinity allowed
    double u_min{}; ///< lower limit of u [unit of u], < u_max, -infinity allowed
};

/// Controller: set by init, changed by arm and by what is not const.
class TableTooSoon {
public:
    using Params = TableTooSoonParams;

    /// Takes the parameters and arms at tick 0. Ok, or Param with nothing changed.
    [[nodiscard]] constexpr Status init(const Params& params) noexcept
    {
        if (!(params.u_min < params.u_max)) {
            return Status::Param;
        }
        const double u_max = params.u_max;
        const double u_min = params.u_min;
        start_ = 0U;
        last_ = 150U;
        u_max_ = u_max;
        u_min_ = u_min;
        return Status::Ok;
    }

    /// Starts again: the deadline is N samples after tick `k`.
    constexpr void arm(std::uint32_t k) noexcept
    {
        start_ = k;
        last_ = 150U;
    }

    /// u of each axis from tick `k`, which may wrap, and the state x = (x1, x1', ...) of each.
    /// Where one of them is not finite, every u is 0; else the status is SATURATED where one was
    /// clipped.
    constexpr Axes<double, 2> step(std::uint32_t k, const std::array<std::array<double, 3>, 2>& x) const noexcept
    {
        Axes<double, 2> all{};
        if (!(finite(x[0][0])
                && finite(x[0][1])
                && finite(x[0][2])
                && finite(x[1][0])
                && finite(x[1][1])
                && finite(x[1][2]))) {
            return {{}, {{Status::Input, Status::Input}}, Status::Input};
        }
        const std::uint32_t elapsed = k - start_;
        const double x1_1 = x[0][0];
        const double x2_1 = x[0][1];
        const double x3_1 = x[0][2];
        const double x1_2 = x[1][0];
        const double x2_2 = x[1][1];
        const double x3_2 = x[1][2];
        const std::uint32_t left = (elapsed < last_) ? (last_ - elapsed) : 0U;
        const double m0_1 = (static_cast<double>(left) < 3.0) ? 3.0 : static_cast<double>(left);
        double law_1{};

        // The exact law in samples.
        const double s1 = (w1_1_1_ * x1_1) + (w1_2_1_ * x2_1);
        const double z1_1 = s1 + (w1_3_1_ * x3_1);
        const double z2_1 = (w2_2_1_ * x2_1) + (w2_3_1_ * x3_1);
        const double z3_1 = w3_3_1_ * x3_1;
        const double m0f_11 = m0_1 + 2.0;
        const double m0f_12 = m0f_11 * (m0_1 + 1.0);
        law_1 = (z1_1 + (z2_1 * m0f_11) + (z3_1 * m0f_12)) / (m0f_12 * m0_1);
        const double m0_2 = (static_cast<double>(left) < 3.0) ? 3.0 : static_cast<double>(left);
        double law_2{};
        const double s2 = (w1_1_2_ * x1_2) + (w1_2_2_ * x2_2);
        const double z1_2 = s2 + (w1_3_2_ * x3_2);
        const double z2_2 = (w2_2_2_ * x2_2) + (w2_3_2_ * x3_2);
        const double z3_2 = w3_3_2_ * x3_2;
        const double m0f_21 = m0_2 + 3.0;
        const double m0f_22 = m0f_21 * (m0_2 + 2.0);
        const double s3 = z1_2 + (z2_2 * m0f_21) + (z3_2 * m0f_22);
        law_2 = s3 / (m0f_22 * (m0_2 + 1.0));
        if (elapsed < last_) {
            all.status = Status::Ok;
        } else {
            all.status = Status::Hold;
        }
        if (finite(law_1) && finite(law_2)) {
            all.u[0] = law_1;
            all.axes[0] = all.status;
            all.u[1] = law_2;
            all.axes[1] = all.status;
            if (law_1 > u_max_) {
                all.u[0] = u_max_;
                all.axes[0] = Status::Saturated;
                all.status = Status::Saturated;
            } else if (law_1 < u_min_) {
                all.u[0] = u_min_;
                all.axes[0] = Status::Saturated;
                all.status = Status::Saturated;
            }
            if (law_2 > u_max_) {
                all.u[1] = u_max_;
                all.axes[1] = Status::Saturated;
                all.status = Status::Saturated;
            } else if (law_2 < u_min_) {
                all.u[1] = u_min_;
                all.axes[1] = Status::Saturated;
                all.status = Status::Saturated;
            }
        } else {
            all.u[0] = 0.0;
            if (finite(law_1)) {
                all.axes[0] = all.status;
            } else {
                all.axes[0] = Status::Range;
            }
            all.u[1] = 0.0;
            if (finite(law_2)) {
                all.axes[1] = all.status;
            } else {
                all.axes[1] = Status::Range;
            }
            all.status = Status::Range;
        }
        return all;
    }

    /// Another deadline, at any tick before the call of `step` at it: rest at tick `k` + `samples`,
    /// 3 to 2147483648 samples. A deadline before which a limit could be exceeded is refused
    /// (E_SOON).
    /// Ok, or Param with nothing changed.
    [[nodiscard]] constexpr Status arm_for(std::uint32_t k, std::uint32_t samples, const std::array<std::array<double, 3>, 2>& x) noexcept
    {
        if (!((samples > 2U) && (samples < 2147483649U))) {
            return Status::Param;
        }
        if (!(finite(x[0][0])
                && finite(x[0][1])
                && finite(x[0][2])
                && finite(x[1][0])
                && finite(x[1][1])
                && finite(x[1][2]))) {
            return Status::Input;
        }
        const double x1_1 = x[0][0];
        const double x2_1 = x[0][1];
        const double x3_1 = x[0][2];
        const double x1_2 = x[1][0];
        const double x2_2 = x[1][1];
        const double x3_2 = x[1][2];
        const double s1 = (s1_1_1_ * x1_1) + (s1_2_1_ * x2_1);
        const double flat1_1 = s1 + (s1_3_1_ * x3_1);
        const double flat2_1 = (s2_2_1_ * x2_1) + (s2_3_1_ * x3_1);
        const double flat3_1 = s3_3_1_ * x3_1;
        const double s2 = (s1_1_2_ * x1_2) + (s1_2_2_ * x2_2);
        const double flat1_2 = s2 + (s1_3_2_ * x3_2);
        const double flat2_2 = (s2_2_2_ * x2_2) + (s2_3_2_ * x3_2);
        const double flat3_2 = s3_3_2_ * x3_2;
        const double least_1 = 0.999999999990586 * u_min_;
        const double most_1 = 0.999999999990586 * u_max_;
        const double most2_1 = 0.499999999995293;
        const double most3_1 = 3.999999999962344;
        const double least_2 = 0.999999999990586 * u_min_;
        const double most_2 = 0.999999999990586 * u_max_;
        const double most2_2 = 0.499999999995293;
        const double most3_2 = 3.999999999962344;
        const std::uint32_t tried = samples;
        std::uint32_t fits = 0U;
        const double m_1 = static_cast<double>(tried);
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
            && (absolute((((-0.0027) * w1_1) - (0.006 * w2_1)) - (0.006 * w3_1)) <= most2_1)
            && (absolute((((-0.0012) * w1_1) - (0.0011999999999999995 * w2_1)) + (8.131516293641283e-19 * w3_1)) <= most2_1)
            && (absolute(((-0.00029999999999999965) * w1_1) + (8.131516293641283e-19 * w2_1) + (8.131516293641283e-19 * w3_1)) <= most2_1)
            && (absolute((0.18 * w1_1) + (0.72 * w2_1) + (1.2 * w3_1)) <= most3_1)
            && (absolute(((0.11999999999999994 * w1_1) + (0.23999999999999982 * w2_1)) - (2.0816681711721685e-16 * w3_1)) <= most3_1)
            && (absolute((0.06000000000000016 * w1_1) + (4.579669976578771e-16 * w2_1) + (6.245004513516506e-16 * w3_1)) <= most3_1)) {
            fits = 1U;
        }
        if (fits == 1U) {
            const double m_2 = static_cast<double>(tried);
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
                && (absolute((((-0.016800000000000002) * w1_2) - (0.036000000000000004 * w2_2)) - (0.036000000000000004 * w3_2)) <= most2_2)
                && (absolute((((-0.005999999999999998) * w1_2) - (0.005999999999999997 * w2_2)) + (4.87890977618477e-18 * w3_2)) <= most2_2)
                && (absolute(((-0.0011999999999999977) * w1_2) + (4.87890977618477e-18 * w2_2) + (4.87890977618477e-18 * w3_2)) <= most2_2)
                && (absolute((1.44 * w1_2) + (4.8 * w2_2) + (7.2 * w3_2)) <= most3_2)
                && (absolute(((0.7199999999999996 * w1_2) + (1.199999999999999 * w2_2)) - (1.2490009027033011e-15 * w3_2)) <= most3_2)
                && (absolute((0.2400000000000011 * w1_2) + (2.914335439641036e-15 * w2_2) + (3.747002708109903e-15 * w3_2)) <= most3_2)) {
                fits = 2U;
            }
        }
        if (!((tried > 3U) && (tried < 1073741825U) && (fits == 2U))) {
            return Status::Soon;
        }
        start_ = k;
        last_ = samples;
        return Status::Ok;
    }

    /// The fewest samples found, from the next call of `step` on, with which the law of each axis
    /// keeps u and the states within their limits at every sample to rest, from the state x of
    /// each, all of which come to rest at one sample, for sure. Give them to `arm_for`.
    /// On a negative status u is 0 and nothing has changed.
    constexpr Value<std::uint32_t> soonest(const std::array<std::array<double, 3>, 2>& x) const noexcept
    {
        if (!(finite(x[0][0])
                && finite(x[0][1])
                && finite(x[0][2])
                && finite(x[1][0])
                && finite(x[1][1])
                && finite(x[1][2]))) {
            return {0, Status::Input};
        }
        const double x1_1 = x[0][0];
        const double x2_1 = x[0][1];
        const double x3_1 = x[0][2];
        const double x1_2 = x[1][0];
        const double x2_2 = x[1][1];
        const double x3_2 = x[1][2];
        const double s1 = (s1_1_1_ * x1_1) + (s1_2_1_ * x2_1);
        const double flat1_1 = s1 + (s1_3_1_ * x3_1);
        const double flat2_1 = (s2_2_1_ * x2_1) + (s2_3_1_ * x3_1);
        const double flat3_1 = s3_3_1_ * x3_1;
        const double s2 = (s1_1_2_ * x1_2) + (s1_2_2_ * x2_2);
        const double flat1_2 = s2 + (s1_3_2_ * x3_2);
        const double flat2_2 = (s2_2_2_ * x2_2) + (s2_3_2_ * x3_2);
        const double flat3_2 = s3_3_2_ * x3_2;
        std::uint32_t low = 3U;
        std::uint32_t top = 1073741825U;
        std::uint32_t kept = 0U;
        std::uint32_t tried = 4U;
        for (std::uint32_t attempt = 0U; attempt < 64U; attempt++) {
            const double least_1 = 0.999999999990586 * u_min_;
            const double most_1 = 0.999999999990586 * u_max_;
            const double most2_1 = 0.499999999995293;
            const double most3_1 = 3.999999999962344;
            const double least_2 = 0.999999999990586 * u_min_;
            const double most_2 = 0.999999999990586 * u_max_;
            const double most2_2 = 0.499999999995293;
            const double most3_2 = 3.999999999962344;
            std::uint32_t fits = 0U;
            const double m_1 = static_cast<double>(tried);
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
                && (absolute((((-0.0027) * w1_1) - (0.006 * w2_1)) - (0.006 * w3_1)) <= most2_1)
                && (absolute((((-0.0012) * w1_1) - (0.0011999999999999995 * w2_1)) + (8.131516293641283e-19 * w3_1)) <= most2_1)
                && (absolute(((-0.00029999999999999965) * w1_1) + (8.131516293641283e-19 * w2_1) + (8.131516293641283e-19 * w3_1)) <= most2_1)
                && (absolute((0.18 * w1_1) + (0.72 * w2_1) + (1.2 * w3_1)) <= most3_1)
                && (absolute(((0.11999999999999994 * w1_1) + (0.23999999999999982 * w2_1)) - (2.0816681711721685e-16 * w3_1)) <= most3_1)
                && (absolute((0.06000000000000016 * w1_1) + (4.579669976578771e-16 * w2_1) + (6.245004513516506e-16 * w3_1)) <= most3_1)) {
                fits = 1U;
            }
            if (fits == 1U) {
                const double m_2 = static_cast<double>(tried);
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
                    && (absolute((((-0.016800000000000002) * w1_2) - (0.036000000000000004 * w2_2)) - (0.036000000000000004 * w3_2)) <= most2_2)
                    && (absolute((((-0.005999999999999998) * w1_2) - (0.005999999999999997 * w2_2)) + (4.87890977618477e-18 * w3_2)) <= most2_2)
                    && (absolute(((-0.0011999999999999977) * w1_2) + (4.87890977618477e-18 * w2_2) + (4.87890977618477e-18 * w3_2)) <= most2_2)
                    && (absolute((1.44 * w1_2) + (4.8 * w2_2) + (7.2 * w3_2)) <= most3_2)
                    && (absolute(((0.7199999999999996 * w1_2) + (1.199999999999999 * w2_2)) - (1.2490009027033011e-15 * w3_2)) <= most3_2)
                    && (absolute((0.2400000000000011 * w1_2) + (2.914335439641036e-15 * w2_2) + (3.747002708109903e-15 * w3_2)) <= most3_2)) {
                    fits = 2U;
                }
            }
            if (fits == 2U) {
                kept = tried;
                top = tried;
            } else {
                low = tried;
            }
            const std::uint32_t gap = (low < top) ? (top - low) : 0U;
            if (gap < 2U) {
                break;
            }
            const std::uint32_t half = gap / 2U;
            if (low < half) {
                tried = low + low;
            } else {
                tried = low + half;
            }
        }
        if (finite(flat1_1)
            && finite(flat2_1)
            && finite(flat3_1)
            && finite(flat1_2)
            && finite(flat2_2)
            && finite(flat3_2)) {
            if (kept > 0U) {
                return {kept, Status::Ok};
            } else {
                return {0, Status::Soon};
            }
        } else {
            return {0, Status::Range};
        }
    }

    /// The tick at which the loop is to be at rest.
    [[nodiscard]] constexpr std::uint32_t deadline() const noexcept
    {
        return start_ - (0U - last_);
    }

private:
    /// std::isfinite is not constexpr in C++17.
    static constexpr bool finite(double v) noexcept
    {
        return (v >= std::numeric_limits<double>::lowest()) && (v <= (std::numeric_limits<double>::max)());
    }

    static constexpr double absolute(double v) noexcept
    {
        return (v > 0.0) ? v : (0.0 - v);
    }
    /// Weight of x1 in the law.
    static constexpr double w1_1_1_{-60000000.0};
    /// Weight of x2 in the law.
    static constexpr double w1_2_1_{600000.0};
    /// Weight of x3 in the law.
    static constexpr double w1_3_1_{-2000.0};
    /// Weight of x2 in the law.
    static constexpr double w2_2_1_{-360000.0};
    /// Weight of x3 in the law.
    static constexpr double w2_3_1_{1800.0};
    /// Weight of x3 in the law.
    static constexpr double w3_3_1_{-900.0};
    /// Weight of x1 in the law.
    static constexpr double w1_1_2_{-120000000.0};
    /// Weight of x2 in the law.
    static constexpr double w1_2_2_{1200000.0};
    /// Weight of x3 in the law.
    static constexpr double w1_3_2_{-4000.0};
    /// Weight of x2 in the law.
    static constexpr double w2_2_2_{-600000.0};
    /// Weight of x3 in the law.
    static constexpr double w2_3_2_{3000.0};
    /// Weight of x3 in the law.
    static constexpr double w3_3_2_{-1200.0};
    /// Weight of x1 in the law.
    static constexpr double s1_1_1_{1000000.0};
    /// Weight of x2 in the law.
    static constexpr double s1_2_1_{-10000.0};
    /// 100/3, weight of x3 in the law.
    static constexpr double s1_3_1_{33.333333333333336};
    /// Weight of x2 in the law.
    static constexpr double s2_2_1_{10000.0};
    /// Weight of x3 in the law.
    static constexpr double s2_3_1_{-50.0};
    /// Weight of x3 in the law.
    static constexpr double s3_3_1_{100.0};
    /// Weight of x1 in the law.
    static constexpr double s1_1_2_{1000000.0};
    /// Weight of x2 in the law.
    static constexpr double s1_2_2_{-10000.0};
    /// 100/3, weight of x3 in the law.
    static constexpr double s1_3_2_{33.333333333333336};
    /// Weight of x2 in the law.
    static constexpr double s2_2_2_{10000.0};
    /// Weight of x3 in the law.
    static constexpr double s2_3_2_{-50.0};
    /// Weight of x3 in the law.
    static constexpr double s3_3_2_{100.0};

    std::uint32_t start_{}; // tick at which it was armed
    std::uint32_t last_{}; // samples from the start to rest, as planned now
    double u_max_{}; // upper limit of u
    double u_min_{}; // lower limit of u
};

} // namespace ptc

#endif
