/*
 * Prescribed-time controller gantry_in_flight: order n = 2, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang cpp --n 2 --axes 3 --mu "exp(a=1)" --name gantry_in_flight --clock samples --poles-end="least-energy(weight=1)" --end-samples=50 --late=extend --pace=soonest --state-max="[[inf,1.5],[inf,inf],[inf,0.4]]" --reserve=0.1 --tau=1.5 --eps=0.02 --limits="[[-900,900],[-400,400],[-150,60]]" --poles=least-energy --g="[1/120, 1/45, 1/12]" --sample-time=1e-3
 * Version 0.1.0, design a53c299184a8.
 *
 * Plant: x1' = x2, x2' = g u; u held from sample to sample.
 * Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
 *       sample period, as long as u is not clipped and nothing else acts on the plant.
 * Law: with M - 1 samples to go and z = S x, u h^2 = sum of row_j z_j
 *       h^(j-1)/((M-j+1)...(M-1)); the rows are those of Theorem 1 for the mapping exp. From
 *       50 samples to go on these are M - 2 and the exponents 3, 4, those of least energy.
 *       The gains of 20 samples to go stay.
 * Axes: 3, each a chain of its own with this deadline and mapping. step computes what depends
 *       on time once.
 *   axis 1: u_min = -900, u_max = 900; state_max = inf, 1.5; g = 1/120
 *   axis 2: u_min = -400, u_max = 400; state_max = inf, inf; g = 1/45
 *   axis 3: u_min = -150, u_max = 60; state_max = inf, 0.4; g = 1/12
 *
 * Parameters:
 *   samples = 1500 [samples], fixed: samples N from the start to rest
 *   h = 1e-3 [s], fixed: sample period
 *   eps = 0.02 [s], fixed: time-to-go at which the gains are held
 *   a = 1 [1/s], fixed: rate of stretched time
 *   k_1 = 6 [1/s^2], fixed: gains k_i of pi0 = -sum k_i xi_i
 *   k_2 = 5 [1/s], fixed: gains k_i of pi0 = -sum k_i xi_i
 *
 * k counts samples and may wrap; arm again within 2^32 - N samples.
 * From sample N on the last gains are held (status HOLD).
 * In flight: arm_for sets another deadline at any tick; rest is exact from any state, so all
 *       else stays as it is.
 * Plan: on the way to rest u and the states are sums of falling powers of the samples to go,
 *       so their Bernstein coefficients, linear in z, bound them. If these are within the
 *       limits, u and the states stay there at every sample to rest, where plant and state
 *       are as they are known.
 * Axes: all come to rest at the same sample, and each deadline is tested for every one of
 *       them.
 * late extend: a step without such a plan raises N to the soonest that has one (status LATE;
 *       deadline gives its tick), and others lower N, by at most a sixteenth of the samples
 *       to go. Where none is found (status INFEASIBLE), or 2^31 samples after the start, N
 *       stays, and u is clipped; states may leave their bounds then.
 * reserve: a new deadline leaves 0.1 of each limit free.
 * u_min <= u <= u_max: u is clipped to these limits (status SATURATED). Clipping voids the
 *       deadline where it lasts.
 * Guard full: what is measured is finite, or the call is refused (INPUT).
 * Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
 *       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
 *
 * Checks of the design (details: ptc-codegen check):
 *   membership: sound: exp is of class M for all its parameters.
 *   growth: sound: near rest at sample 1500, not at rest: the gains are held from 20 samples
 *       to go, and |u| is bounded.
 *   sampling: not checked: the law is exact in samples, at any period.
 *   deadline: not checked: the law is exact in samples, at any period.
 *   loop: not checked: `x0_max` is not given.
 *   envelope: not checked: it does not examine a clock in samples.
 */
#ifndef GANTRY_IN_FLIGHT_7CFB44D5_HPP
#define GANTRY_IN_FLIGHT_7CFB44D5_HPP

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
struct GantryInFlightParams {
};

/// Controller: set by init, changed by arm and by what is not const.
class GantryInFlight {
public:
    using Params = GantryInFlightParams;

    /// Takes the parameters and arms at tick 0. Ok, or Param with nothing changed.
    [[nodiscard]] constexpr Status init(const Params&) noexcept
    {
        start_ = 0U;
        last_ = 1500U;
        return Status::Ok;
    }

    /// Starts again: the deadline is N samples after tick `k`.
    constexpr void arm(std::uint32_t k) noexcept
    {
        start_ = k;
        last_ = 1500U;
    }

    /// u of each axis from tick `k`, which may wrap, and the state x = (x1, x1', ...) of each.
    /// Where one of them is not finite, every u is 0; else the status is SATURATED where one was
    /// clipped.
    constexpr Axes<double, 3> step(std::uint32_t k, const std::array<std::array<double, 2>, 3>& x) noexcept
    {
        Axes<double, 3> all{};
        if (!(finite(x[0][0])
                && finite(x[0][1])
                && finite(x[1][0])
                && finite(x[1][1])
                && finite(x[2][0])
                && finite(x[2][1]))) {
            return {{}, {{Status::Input, Status::Input, Status::Input}}, Status::Input};
        }
        const std::uint32_t elapsed = k - start_;
        const double x1_1 = x[0][0];
        const double x2_1 = x[0][1];
        const double x1_2 = x[1][0];
        const double x2_2 = x[1][1];
        const double x1_3 = x[2][0];
        const double x2_3 = x[2][1];

        // The deadline that keeps the limits.
        std::uint32_t last_now = last_;
        std::uint32_t late = 0U;
        const std::uint32_t to_rest = (elapsed < last_) ? (last_ - elapsed) : 0U;
        const std::uint32_t ahead = to_rest;
        const double flat1_1 = (s1_1_1_ * x1_1) + (s1_2_1_ * x2_1);
        const double flat2_1 = s2_2_1_ * x2_1;
        const double flat1_2 = (s1_1_2_ * x1_2) + (s1_2_2_ * x2_2);
        const double flat2_2 = s2_2_2_ * x2_2;
        const double flat1_3 = (s1_1_3_ * x1_3) + (s1_2_3_ * x2_3);
        const double flat2_3 = s2_2_3_ * x2_3;
        std::uint32_t below = ((ahead / 16U) < ((1U < ahead) ? (ahead - 1U) : 0U)) ? (((1U < ahead) ? (ahead - 1U) : 0U) - (ahead / 16U)) : 0U;
        if (ahead > 20U) {
            if (below < 20U) {
                below = 20U;
            }
        } else {
            below = (1U < ahead) ? (ahead - 1U) : 0U;
        }
        std::uint32_t low = below;
        std::uint32_t top = 1073741825U;
        std::uint32_t kept = 0U;
        std::uint32_t tried = ahead;
        double part = 0.9999999999998739;
        for (std::uint32_t attempt = 0U; attempt < 64U; attempt++) {
            const double least_1 = u_min_1_ * part;
            const double most_1 = u_max_1_ * part;
            const double within_1 = (-least_1 < most_1) ? -least_1 : most_1;
            const double most2_1 = 1.5 * part;
            const double least_2 = u_min_2_ * part;
            const double most_2 = u_max_2_ * part;
            const double within_2 = (-least_2 < most_2) ? -least_2 : most_2;
            const double least_3 = u_min_3_ * part;
            const double most_3 = u_max_3_ * part;
            const double within_3 = (-least_3 < most_3) ? -least_3 : most_3;
            const double most2_3 = 0.4 * part;
            std::uint32_t fits = 0U;
            if (tried > 50U) {
                const double m_1 = static_cast<double>(tried);
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
                    && (absolute(((-0.0003193815987933635) * w1_1) - (0.01059185520361991 * w2_1)) <= most2_1)
                    && (absolute(((-0.000418474825827767) * w1_1) - (0.014748146951088127 * w2_1)) <= most2_1)
                    && (absolute(((-0.0005236084177260647) * w1_1) - (0.019887508080155138 * w2_1)) <= most2_1)
                    && (absolute(((-0.0006260238454356102) * w1_1) - (0.026036214177978884 * w2_1)) <= most2_1)
                    && (absolute(((-0.0007169625799037563) * w1_1) - (0.0332205408317173 * w2_1)) <= most2_1)
                    && (absolute(((-0.0007876660920778567) * w1_1) - (0.04146676362852834 * w2_1)) <= most2_1)
                    && (absolute(((-0.0008293758529052647) * w1_1) - (0.05080115815556992 * w2_1)) <= most2_1)
                    && (absolute(((-0.0008333333333333334) * w1_1) - (0.06125 * w2_1)) <= most2_1)
                    && (absolute((2.8054298642533926 * w1_1) + (111.58371040723979 * w2_1)) <= 0.9850746268656713 * within_1)
                    && (absolute((2.583924302196364 * w1_1) + (85.00144425360725 * w2_1)) <= 0.9850746268656713 * within_1)
                    && (absolute((1.9885945165034657 * w1_1) + (61.86959300518941 * w2_1)) <= 0.9850746268656713 * within_1)
                    && (absolute((2.9380703330283167 * w1_1) + (105.39729178384643 * w2_1)) <= 0.9850746268656713 * within_1)
                    && (absolute((2.395997187424203 * w1_1) + (77.20565274199532 * w2_1)) <= 0.9850746268656713 * within_1)
                    && (absolute((2.8712027904432142 * w1_1) + (99.5000219686458 * w2_1)) <= 0.9850746268656713 * within_1)
                    && (absolute(((-0.00029562594268476623) * w1_1) - (0.009613122171945702 * w2_1)) <= 0.9850746268656717 * most2_1)
                    && (absolute(((-0.00017656644504526514) * w1_1) - (0.005290649279938502 * w2_1)) <= 0.9850746268656717 * most2_1)
                    && (absolute(((-0.00011677836082279918) * w1_1) - (0.003360345134034913 * w2_1)) <= 0.9850746268656717 * most2_1)
                    && (absolute(((-0.000247869777281542) * w1_1) - (0.007769377681142387 * w2_1)) <= 0.9850746268656717 * most2_1)
                    && (absolute(((-0.00015503374252696212) * w1_1) - (0.004582303911158442 * w2_1)) <= 0.9850746268656717 * most2_1)
                    && (absolute(((-0.00022338585783963935) * w1_1) - (0.006891066916277001 * w2_1)) <= 0.9850746268656717 * most2_1)) {
                    fits = 1U;
                }
            } else if (tried > 20U) {
                const double m_1 = static_cast<double>(tried);
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
                    && (absolute((119.99999999999996 * w1_1) + (4559.999999999999 * w2_1)) <= 0.9850746268656713 * within_1)
                    && (absolute((92.75321716019634 * w1_1) + (2422.754466594877 * w2_1)) <= 0.9850746268656713 * within_1)
                    && (absolute((67.8353765546998 * w1_1) + (1509.7849977027897 * w2_1)) <= 0.9850746268656713 * within_1)
                    && (absolute((114.21150278293138 * w1_1) + (3629.3877551020414 * w2_1)) <= 0.9850746268656713 * within_1)
                    && (absolute((84.39364430426792 * w1_1) + (2085.179889377806 * w2_1)) <= 0.9850746268656713 * within_1)
                    && (absolute((108.11363033997543 * w1_1) + (3196.9332337421392 * w2_1)) <= 0.9850746268656713 * within_1)
                    && (absolute(((-0.0105) * w1_1) - (0.266 * w2_1)) <= 0.9850746268656717 * most2_1)
                    && (absolute(((-0.005820348615074297) * w1_1) - (0.1137806492473866 * w2_1)) <= 0.9850746268656717 * most2_1)
                    && (absolute(((-0.003710680216503311) * w1_1) - (0.06137180874826767 * w2_1)) <= 0.9850746268656717 * most2_1)
                    && (absolute(((-0.008512987012987014) * w1_1) - (0.19394805194805195 * w2_1)) <= 0.9850746268656717 * most2_1)
                    && (absolute(((-0.005047405138739329) * w1_1) - (0.09359102869242929 * w2_1)) <= 0.9850746268656717 * most2_1)
                    && (absolute(((-0.007561224489795918) * w1_1) - (0.16370315398886828 * w2_1)) <= 0.9850746268656717 * most2_1)) {
                    fits = 1U;
                }
            } else if ((absolute(((-0.025974025974025976) * flat1_1) - (0.2857142857142857 * flat2_1)) <= 0.9850746268656713 * within_1)
                && (absolute(((-0.0012475444042476065) * flat1_1) - (0.08276232337733669 * flat2_1)) <= 0.9850746268656713 * within_1)
                && (absolute((0.0035664936491730252 * flat1_1) - (0.02768331367963576 * flat2_1)) <= 0.9850746268656713 * within_1)
                && (absolute(((-0.012577404043081223) * flat1_1) - (0.18287834614365228 * flat2_1)) <= 0.9850746268656713 * within_1)
                && (absolute((0.000902126332826074 * flat1_1) - (0.060363489673773814 * flat2_1)) <= 0.9850746268656713 * within_1)
                && (absolute(((-0.007827317130259085) * flat1_1) - (0.14320479414568998 * flat2_1)) <= 0.9850746268656713 * within_1)
                && (absolute(8.333333333333334e-6 * flat2_1) <= 0.9850746268656717 * most2_1)
                && (absolute(((-5.753277910884418e-7) * flat1_1) + (4.0025382969610726e-7 * flat2_1)) <= 0.9850746268656717 * most2_1)
                && (absolute(((-5.576228651711587e-7) * flat1_1) - (1.1442500457763455e-6 * flat2_1)) <= 0.9850746268656717 * most2_1)
                && (absolute(((-3.7105751391465685e-7) * flat1_1) + (4.035250463821892e-6 * flat2_1)) <= 0.9850746268656717 * most2_1)
                && (absolute(((-5.857239944571719e-7) * flat1_1) - (2.894321984483652e-7 * flat2_1)) <= 0.9850746268656717 * most2_1)
                && (absolute(((-4.75869214273667e-7) * flat1_1) + (2.5112642459581232e-6 * flat2_1)) <= 0.9850746268656717 * most2_1)) {
                fits = 1U;
            }
            if (fits == 1U) {
                if (tried > 50U) {
                    const double m_2 = static_cast<double>(tried);
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
                        && (absolute((2.8054298642533926 * w1_2) + (111.58371040723979 * w2_2)) <= 0.9850746268656713 * within_2)
                        && (absolute((2.583924302196364 * w1_2) + (85.00144425360725 * w2_2)) <= 0.9850746268656713 * within_2)
                        && (absolute((1.9885945165034657 * w1_2) + (61.86959300518941 * w2_2)) <= 0.9850746268656713 * within_2)
                        && (absolute((2.9380703330283167 * w1_2) + (105.39729178384643 * w2_2)) <= 0.9850746268656713 * within_2)
                        && (absolute((2.395997187424203 * w1_2) + (77.20565274199532 * w2_2)) <= 0.9850746268656713 * within_2)
                        && (absolute((2.8712027904432142 * w1_2) + (99.5000219686458 * w2_2)) <= 0.9850746268656713 * within_2)) {
                        fits = 2U;
                    }
                } else if (tried > 20U) {
                    const double m_2 = static_cast<double>(tried);
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
                        && (absolute((119.99999999999996 * w1_2) + (4559.999999999999 * w2_2)) <= 0.9850746268656713 * within_2)
                        && (absolute((92.75321716019634 * w1_2) + (2422.754466594877 * w2_2)) <= 0.9850746268656713 * within_2)
                        && (absolute((67.8353765546998 * w1_2) + (1509.7849977027897 * w2_2)) <= 0.9850746268656713 * within_2)
                        && (absolute((114.21150278293138 * w1_2) + (3629.3877551020414 * w2_2)) <= 0.9850746268656713 * within_2)
                        && (absolute((84.39364430426792 * w1_2) + (2085.179889377806 * w2_2)) <= 0.9850746268656713 * within_2)
                        && (absolute((108.11363033997543 * w1_2) + (3196.9332337421392 * w2_2)) <= 0.9850746268656713 * within_2)) {
                        fits = 2U;
                    }
                } else if ((absolute(((-0.025974025974025976) * flat1_2) - (0.2857142857142857 * flat2_2)) <= 0.9850746268656713 * within_2)
                    && (absolute(((-0.0012475444042476065) * flat1_2) - (0.08276232337733669 * flat2_2)) <= 0.9850746268656713 * within_2)
                    && (absolute((0.0035664936491730252 * flat1_2) - (0.02768331367963576 * flat2_2)) <= 0.9850746268656713 * within_2)
                    && (absolute(((-0.012577404043081223) * flat1_2) - (0.18287834614365228 * flat2_2)) <= 0.9850746268656713 * within_2)
                    && (absolute((0.000902126332826074 * flat1_2) - (0.060363489673773814 * flat2_2)) <= 0.9850746268656713 * within_2)
                    && (absolute(((-0.007827317130259085) * flat1_2) - (0.14320479414568998 * flat2_2)) <= 0.9850746268656713 * within_2)) {
                    fits = 2U;
                }
            }
            if (fits == 2U) {
                if (tried > 50U) {
                    const double m_3 = static_cast<double>(tried);
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
                        && (absolute(((-0.003193815987933635) * w1_3) - (0.1059185520361991 * w2_3)) <= most2_3)
                        && (absolute(((-0.00418474825827767) * w1_3) - (0.14748146951088129 * w2_3)) <= most2_3)
                        && (absolute(((-0.005236084177260648) * w1_3) - (0.1988750808015514 * w2_3)) <= most2_3)
                        && (absolute(((-0.006260238454356102) * w1_3) - (0.26036214177978884 * w2_3)) <= most2_3)
                        && (absolute(((-0.007169625799037563) * w1_3) - (0.33220540831717305 * w2_3)) <= most2_3)
                        && (absolute(((-0.007876660920778569) * w1_3) - (0.41466763628528336 * w2_3)) <= most2_3)
                        && (absolute(((-0.008293758529052647) * w1_3) - (0.5080115815556993 * w2_3)) <= most2_3)
                        && (absolute(((-0.008333333333333333) * w1_3) - (0.6125 * w2_3)) <= most2_3)
                        && (absolute((2.8054298642533926 * w1_3) + (111.58371040723979 * w2_3)) <= 0.9850746268656713 * within_3)
                        && (absolute((2.583924302196364 * w1_3) + (85.00144425360725 * w2_3)) <= 0.9850746268656713 * within_3)
                        && (absolute((1.9885945165034657 * w1_3) + (61.86959300518941 * w2_3)) <= 0.9850746268656713 * within_3)
                        && (absolute((2.9380703330283167 * w1_3) + (105.39729178384643 * w2_3)) <= 0.9850746268656713 * within_3)
                        && (absolute((2.395997187424203 * w1_3) + (77.20565274199532 * w2_3)) <= 0.9850746268656713 * within_3)
                        && (absolute((2.8712027904432142 * w1_3) + (99.5000219686458 * w2_3)) <= 0.9850746268656713 * within_3)
                        && (absolute(((-0.002956259426847662) * w1_3) - (0.09613122171945701 * w2_3)) <= 0.9850746268656717 * most2_3)
                        && (absolute(((-0.0017656644504526516) * w1_3) - (0.05290649279938503 * w2_3)) <= 0.9850746268656717 * most2_3)
                        && (absolute(((-0.0011677836082279918) * w1_3) - (0.03360345134034914 * w2_3)) <= 0.9850746268656717 * most2_3)
                        && (absolute(((-0.0024786977728154204) * w1_3) - (0.07769377681142388 * w2_3)) <= 0.9850746268656717 * most2_3)
                        && (absolute(((-0.0015503374252696213) * w1_3) - (0.04582303911158442 * w2_3)) <= 0.9850746268656717 * most2_3)
                        && (absolute(((-0.0022338585783963937) * w1_3) - (0.06891066916277001 * w2_3)) <= 0.9850746268656717 * most2_3)) {
                        fits = 3U;
                    }
                } else if (tried > 20U) {
                    const double m_3 = static_cast<double>(tried);
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
                        && (absolute((119.99999999999996 * w1_3) + (4559.999999999999 * w2_3)) <= 0.9850746268656713 * within_3)
                        && (absolute((92.75321716019634 * w1_3) + (2422.754466594877 * w2_3)) <= 0.9850746268656713 * within_3)
                        && (absolute((67.8353765546998 * w1_3) + (1509.7849977027897 * w2_3)) <= 0.9850746268656713 * within_3)
                        && (absolute((114.21150278293138 * w1_3) + (3629.3877551020414 * w2_3)) <= 0.9850746268656713 * within_3)
                        && (absolute((84.39364430426792 * w1_3) + (2085.179889377806 * w2_3)) <= 0.9850746268656713 * within_3)
                        && (absolute((108.11363033997543 * w1_3) + (3196.9332337421392 * w2_3)) <= 0.9850746268656713 * within_3)
                        && (absolute(((-0.105) * w1_3) - (2.6599999999999997 * w2_3)) <= 0.9850746268656717 * most2_3)
                        && (absolute(((-0.058203486150742986) * w1_3) - (1.1378064924738662 * w2_3)) <= 0.9850746268656717 * most2_3)
                        && (absolute(((-0.037106802165033106) * w1_3) - (0.6137180874826768 * w2_3)) <= 0.9850746268656717 * most2_3)
                        && (absolute(((-0.08512987012987014) * w1_3) - (1.9394805194805198 * w2_3)) <= 0.9850746268656717 * most2_3)
                        && (absolute(((-0.05047405138739328) * w1_3) - (0.9359102869242929 * w2_3)) <= 0.9850746268656717 * most2_3)
                        && (absolute(((-0.07561224489795919) * w1_3) - (1.637031539888683 * w2_3)) <= 0.9850746268656717 * most2_3)) {
                        fits = 3U;
                    }
                } else if ((absolute(((-0.025974025974025976) * flat1_3) - (0.2857142857142857 * flat2_3)) <= 0.9850746268656713 * within_3)
                    && (absolute(((-0.0012475444042476065) * flat1_3) - (0.08276232337733669 * flat2_3)) <= 0.9850746268656713 * within_3)
                    && (absolute((0.0035664936491730252 * flat1_3) - (0.02768331367963576 * flat2_3)) <= 0.9850746268656713 * within_3)
                    && (absolute(((-0.012577404043081223) * flat1_3) - (0.18287834614365228 * flat2_3)) <= 0.9850746268656713 * within_3)
                    && (absolute((0.000902126332826074 * flat1_3) - (0.060363489673773814 * flat2_3)) <= 0.9850746268656713 * within_3)
                    && (absolute(((-0.007827317130259085) * flat1_3) - (0.14320479414568998 * flat2_3)) <= 0.9850746268656713 * within_3)
                    && (absolute(8.333333333333333e-5 * flat2_3) <= 0.9850746268656717 * most2_3)
                    && (absolute(((-5.753277910884419e-6) * flat1_3) + (4.002538296961078e-6 * flat2_3)) <= 0.9850746268656717 * most2_3)
                    && (absolute(((-5.576228651711586e-6) * flat1_3) - (1.1442500457763452e-5 * flat2_3)) <= 0.9850746268656717 * most2_3)
                    && (absolute(((-3.7105751391465683e-6) * flat1_3) + (4.035250463821893e-5 * flat2_3)) <= 0.9850746268656717 * most2_3)
                    && (absolute(((-5.857239944571719e-6) * flat1_3) - (2.8943219844836487e-6 * flat2_3)) <= 0.9850746268656717 * most2_3)
                    && (absolute(((-4.75869214273667e-6) * flat1_3) + (2.511264245958124e-5 * flat2_3)) <= 0.9850746268656717 * most2_3)) {
                    fits = 3U;
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
            const std::uint32_t gap = (low < top) ? (top - low) : 0U;
            if (gap < 2U) {
                break;
            }
            const std::uint32_t half = gap / 2U;
            const std::uint32_t more = (((ahead < low) ? (low - ahead) : 0U) / 2U) + 1U;
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
        if (last_now > last_) {
            late = 1U;
        }
        const std::uint32_t left = (elapsed < last_now) ? (last_now - elapsed) : 0U;
        const double m0_1 = (static_cast<double>(left) < hold_) ? hold_ : static_cast<double>(left);
        double law_1{};
        const double m0_2 = (static_cast<double>(left) < hold_) ? hold_ : static_cast<double>(left);
        double law_2{};
        const double m0_3 = (static_cast<double>(left) < hold_) ? hold_ : static_cast<double>(left);
        double law_3{};
        if (m0_1 > end_samples_1_) {
            // The exact law in samples.
            const double z1_1 = (w1_1_1_ * x1_1) + (w1_2_1_ * x2_1);
            const double z2_1 = w2_2_1_ * x2_1;
            const double m0f_11 = m0_1 + 1.0;
            law_1 = (z1_1 + (z2_1 * m0f_11)) / (m0f_11 * m0_1);
        } else {
            // The law of least energy to the end.
            const double m1_1 = (m0_1 < 2.0) ? 2.0 : m0_1;
            const double y1_1 = (end1_1_1_ * x1_1) + (end1_2_1_ * x2_1);
            const double y2_1 = end2_2_1_ * x2_1;
            const double m1f_11 = m1_1 + 2.0;
            law_1 = (y1_1 + (y2_1 * m1f_11)) / (m1f_11 * (m1_1 + 1.0));
        }
        if (m0_2 > end_samples_2_) {
            // The exact law in samples.
            const double z1_2 = (w1_1_2_ * x1_2) + (w1_2_2_ * x2_2);
            const double z2_2 = w2_2_2_ * x2_2;
            const double m0f_21 = m0_2 + 1.0;
            law_2 = (z1_2 + (z2_2 * m0f_21)) / (m0f_21 * m0_2);
        } else {
            // The law of least energy to the end.
            const double m1_2 = (m0_2 < 2.0) ? 2.0 : m0_2;
            const double y1_2 = (end1_1_2_ * x1_2) + (end1_2_2_ * x2_2);
            const double y2_2 = end2_2_2_ * x2_2;
            const double m1f_21 = m1_2 + 2.0;
            law_2 = (y1_2 + (y2_2 * m1f_21)) / (m1f_21 * (m1_2 + 1.0));
        }
        if (m0_3 > end_samples_3_) {
            // The exact law in samples.
            const double z1_3 = (w1_1_3_ * x1_3) + (w1_2_3_ * x2_3);
            const double z2_3 = w2_2_3_ * x2_3;
            const double m0f_31 = m0_3 + 1.0;
            law_3 = (z1_3 + (z2_3 * m0f_31)) / (m0f_31 * m0_3);
        } else {
            // The law of least energy to the end.
            const double m1_3 = (m0_3 < 2.0) ? 2.0 : m0_3;
            const double y1_3 = (end1_1_3_ * x1_3) + (end1_2_3_ * x2_3);
            const double y2_3 = end2_2_3_ * x2_3;
            const double m1f_31 = m1_3 + 2.0;
            law_3 = (y1_3 + (y2_3 * m1f_31)) / (m1f_31 * (m1_3 + 1.0));
        }
        if (static_cast<double>(left) > hold_) {
            if (late == 2U) {
                all.status = Status::Infeasible;
            } else if (late == 1U) {
                all.status = Status::Late;
            } else {
                all.status = Status::Ok;
            }
        } else {
            all.status = Status::Hold;
        }
        if (finite(law_1) && finite(law_2) && finite(law_3)) {
            all.u[0] = law_1;
            all.axes[0] = all.status;
            all.u[1] = law_2;
            all.axes[1] = all.status;
            all.u[2] = law_3;
            all.axes[2] = all.status;
            if (law_1 > 900.0) {
                all.u[0] = 900.0;
                all.axes[0] = Status::Saturated;
                all.status = Status::Saturated;
            } else if (law_1 < -900.0) {
                all.u[0] = -900.0;
                all.axes[0] = Status::Saturated;
                all.status = Status::Saturated;
            }
            if (law_2 > 400.0) {
                all.u[1] = 400.0;
                all.axes[1] = Status::Saturated;
                all.status = Status::Saturated;
            } else if (law_2 < -400.0) {
                all.u[1] = -400.0;
                all.axes[1] = Status::Saturated;
                all.status = Status::Saturated;
            }
            if (law_3 > 60.0) {
                all.u[2] = 60.0;
                all.axes[2] = Status::Saturated;
                all.status = Status::Saturated;
            } else if (law_3 < -150.0) {
                all.u[2] = -150.0;
                all.axes[2] = Status::Saturated;
                all.status = Status::Saturated;
            }
            last_ = last_now;
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
            all.u[2] = 0.0;
            if (finite(law_3)) {
                all.axes[2] = all.status;
            } else {
                all.axes[2] = Status::Range;
            }
            all.status = Status::Range;
        }
        return all;
    }

    /// Another deadline, at any tick before the call of `step` at it: rest at tick `k` + `samples`,
    /// 2 to 2147483648 samples.
    /// Ok, or Param with nothing changed.
    [[nodiscard]] constexpr Status arm_for(std::uint32_t k, std::uint32_t samples) noexcept
    {
        if (!((samples > 1U) && (samples < 2147483649U))) {
            return Status::Param;
        }
        start_ = k;
        last_ = samples;
        return Status::Ok;
    }

    /// The fewest samples found, from the next call of `step` on, with which the law of each axis
    /// keeps u and the states within their limits at every sample to rest, from the state x of
    /// each, all of which come to rest at one sample, for sure. Give them to `arm_for`.
    /// On a negative status u is 0 and nothing has changed.
    constexpr Value<std::uint32_t> soonest(const std::array<std::array<double, 2>, 3>& x) const noexcept
    {
        if (!(finite(x[0][0])
                && finite(x[0][1])
                && finite(x[1][0])
                && finite(x[1][1])
                && finite(x[2][0])
                && finite(x[2][1]))) {
            return {0, Status::Input};
        }
        const double x1_1 = x[0][0];
        const double x2_1 = x[0][1];
        const double x1_2 = x[1][0];
        const double x2_2 = x[1][1];
        const double x1_3 = x[2][0];
        const double x2_3 = x[2][1];
        const double flat1_1 = (s1_1_1_ * x1_1) + (s1_2_1_ * x2_1);
        const double flat2_1 = s2_2_1_ * x2_1;
        const double flat1_2 = (s1_1_2_ * x1_2) + (s1_2_2_ * x2_2);
        const double flat2_2 = s2_2_2_ * x2_2;
        const double flat1_3 = (s1_1_3_ * x1_3) + (s1_2_3_ * x2_3);
        const double flat2_3 = s2_2_3_ * x2_3;
        std::uint32_t low = 20U;
        std::uint32_t top = 1073741825U;
        std::uint32_t kept = 0U;
        std::uint32_t tried = 21U;
        for (std::uint32_t attempt = 0U; attempt < 64U; attempt++) {
            const double least_1 = 0.899999999999773 * u_min_1_;
            const double most_1 = 0.899999999999773 * u_max_1_;
            const double within_1 = (-least_1 < most_1) ? -least_1 : most_1;
            const double most2_1 = 1.3499999999996595;
            const double least_2 = 0.899999999999773 * u_min_2_;
            const double most_2 = 0.899999999999773 * u_max_2_;
            const double within_2 = (-least_2 < most_2) ? -least_2 : most_2;
            const double least_3 = 0.899999999999773 * u_min_3_;
            const double most_3 = 0.899999999999773 * u_max_3_;
            const double within_3 = (-least_3 < most_3) ? -least_3 : most_3;
            const double most2_3 = 0.35999999999990917;
            std::uint32_t fits = 0U;
            if (tried > 50U) {
                const double m_1 = static_cast<double>(tried);
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
                    && (absolute(((-0.0003193815987933635) * w1_1) - (0.01059185520361991 * w2_1)) <= most2_1)
                    && (absolute(((-0.000418474825827767) * w1_1) - (0.014748146951088127 * w2_1)) <= most2_1)
                    && (absolute(((-0.0005236084177260647) * w1_1) - (0.019887508080155138 * w2_1)) <= most2_1)
                    && (absolute(((-0.0006260238454356102) * w1_1) - (0.026036214177978884 * w2_1)) <= most2_1)
                    && (absolute(((-0.0007169625799037563) * w1_1) - (0.0332205408317173 * w2_1)) <= most2_1)
                    && (absolute(((-0.0007876660920778567) * w1_1) - (0.04146676362852834 * w2_1)) <= most2_1)
                    && (absolute(((-0.0008293758529052647) * w1_1) - (0.05080115815556992 * w2_1)) <= most2_1)
                    && (absolute(((-0.0008333333333333334) * w1_1) - (0.06125 * w2_1)) <= most2_1)
                    && (absolute((2.8054298642533926 * w1_1) + (111.58371040723979 * w2_1)) <= 0.9850746268656713 * within_1)
                    && (absolute((2.583924302196364 * w1_1) + (85.00144425360725 * w2_1)) <= 0.9850746268656713 * within_1)
                    && (absolute((1.9885945165034657 * w1_1) + (61.86959300518941 * w2_1)) <= 0.9850746268656713 * within_1)
                    && (absolute((2.9380703330283167 * w1_1) + (105.39729178384643 * w2_1)) <= 0.9850746268656713 * within_1)
                    && (absolute((2.395997187424203 * w1_1) + (77.20565274199532 * w2_1)) <= 0.9850746268656713 * within_1)
                    && (absolute((2.8712027904432142 * w1_1) + (99.5000219686458 * w2_1)) <= 0.9850746268656713 * within_1)
                    && (absolute(((-0.00029562594268476623) * w1_1) - (0.009613122171945702 * w2_1)) <= 0.9850746268656717 * most2_1)
                    && (absolute(((-0.00017656644504526514) * w1_1) - (0.005290649279938502 * w2_1)) <= 0.9850746268656717 * most2_1)
                    && (absolute(((-0.00011677836082279918) * w1_1) - (0.003360345134034913 * w2_1)) <= 0.9850746268656717 * most2_1)
                    && (absolute(((-0.000247869777281542) * w1_1) - (0.007769377681142387 * w2_1)) <= 0.9850746268656717 * most2_1)
                    && (absolute(((-0.00015503374252696212) * w1_1) - (0.004582303911158442 * w2_1)) <= 0.9850746268656717 * most2_1)
                    && (absolute(((-0.00022338585783963935) * w1_1) - (0.006891066916277001 * w2_1)) <= 0.9850746268656717 * most2_1)) {
                    fits = 1U;
                }
            } else {
                const double m_1 = static_cast<double>(tried);
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
                    && (absolute((119.99999999999996 * w1_1) + (4559.999999999999 * w2_1)) <= 0.9850746268656713 * within_1)
                    && (absolute((92.75321716019634 * w1_1) + (2422.754466594877 * w2_1)) <= 0.9850746268656713 * within_1)
                    && (absolute((67.8353765546998 * w1_1) + (1509.7849977027897 * w2_1)) <= 0.9850746268656713 * within_1)
                    && (absolute((114.21150278293138 * w1_1) + (3629.3877551020414 * w2_1)) <= 0.9850746268656713 * within_1)
                    && (absolute((84.39364430426792 * w1_1) + (2085.179889377806 * w2_1)) <= 0.9850746268656713 * within_1)
                    && (absolute((108.11363033997543 * w1_1) + (3196.9332337421392 * w2_1)) <= 0.9850746268656713 * within_1)
                    && (absolute(((-0.0105) * w1_1) - (0.266 * w2_1)) <= 0.9850746268656717 * most2_1)
                    && (absolute(((-0.005820348615074297) * w1_1) - (0.1137806492473866 * w2_1)) <= 0.9850746268656717 * most2_1)
                    && (absolute(((-0.003710680216503311) * w1_1) - (0.06137180874826767 * w2_1)) <= 0.9850746268656717 * most2_1)
                    && (absolute(((-0.008512987012987014) * w1_1) - (0.19394805194805195 * w2_1)) <= 0.9850746268656717 * most2_1)
                    && (absolute(((-0.005047405138739329) * w1_1) - (0.09359102869242929 * w2_1)) <= 0.9850746268656717 * most2_1)
                    && (absolute(((-0.007561224489795918) * w1_1) - (0.16370315398886828 * w2_1)) <= 0.9850746268656717 * most2_1)) {
                    fits = 1U;
                }
            }
            if (fits == 1U) {
                if (tried > 50U) {
                    const double m_2 = static_cast<double>(tried);
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
                        && (absolute((2.8054298642533926 * w1_2) + (111.58371040723979 * w2_2)) <= 0.9850746268656713 * within_2)
                        && (absolute((2.583924302196364 * w1_2) + (85.00144425360725 * w2_2)) <= 0.9850746268656713 * within_2)
                        && (absolute((1.9885945165034657 * w1_2) + (61.86959300518941 * w2_2)) <= 0.9850746268656713 * within_2)
                        && (absolute((2.9380703330283167 * w1_2) + (105.39729178384643 * w2_2)) <= 0.9850746268656713 * within_2)
                        && (absolute((2.395997187424203 * w1_2) + (77.20565274199532 * w2_2)) <= 0.9850746268656713 * within_2)
                        && (absolute((2.8712027904432142 * w1_2) + (99.5000219686458 * w2_2)) <= 0.9850746268656713 * within_2)) {
                        fits = 2U;
                    }
                } else {
                    const double m_2 = static_cast<double>(tried);
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
                        && (absolute((119.99999999999996 * w1_2) + (4559.999999999999 * w2_2)) <= 0.9850746268656713 * within_2)
                        && (absolute((92.75321716019634 * w1_2) + (2422.754466594877 * w2_2)) <= 0.9850746268656713 * within_2)
                        && (absolute((67.8353765546998 * w1_2) + (1509.7849977027897 * w2_2)) <= 0.9850746268656713 * within_2)
                        && (absolute((114.21150278293138 * w1_2) + (3629.3877551020414 * w2_2)) <= 0.9850746268656713 * within_2)
                        && (absolute((84.39364430426792 * w1_2) + (2085.179889377806 * w2_2)) <= 0.9850746268656713 * within_2)
                        && (absolute((108.11363033997543 * w1_2) + (3196.9332337421392 * w2_2)) <= 0.9850746268656713 * within_2)) {
                        fits = 2U;
                    }
                }
            }
            if (fits == 2U) {
                if (tried > 50U) {
                    const double m_3 = static_cast<double>(tried);
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
                        && (absolute(((-0.003193815987933635) * w1_3) - (0.1059185520361991 * w2_3)) <= most2_3)
                        && (absolute(((-0.00418474825827767) * w1_3) - (0.14748146951088129 * w2_3)) <= most2_3)
                        && (absolute(((-0.005236084177260648) * w1_3) - (0.1988750808015514 * w2_3)) <= most2_3)
                        && (absolute(((-0.006260238454356102) * w1_3) - (0.26036214177978884 * w2_3)) <= most2_3)
                        && (absolute(((-0.007169625799037563) * w1_3) - (0.33220540831717305 * w2_3)) <= most2_3)
                        && (absolute(((-0.007876660920778569) * w1_3) - (0.41466763628528336 * w2_3)) <= most2_3)
                        && (absolute(((-0.008293758529052647) * w1_3) - (0.5080115815556993 * w2_3)) <= most2_3)
                        && (absolute(((-0.008333333333333333) * w1_3) - (0.6125 * w2_3)) <= most2_3)
                        && (absolute((2.8054298642533926 * w1_3) + (111.58371040723979 * w2_3)) <= 0.9850746268656713 * within_3)
                        && (absolute((2.583924302196364 * w1_3) + (85.00144425360725 * w2_3)) <= 0.9850746268656713 * within_3)
                        && (absolute((1.9885945165034657 * w1_3) + (61.86959300518941 * w2_3)) <= 0.9850746268656713 * within_3)
                        && (absolute((2.9380703330283167 * w1_3) + (105.39729178384643 * w2_3)) <= 0.9850746268656713 * within_3)
                        && (absolute((2.395997187424203 * w1_3) + (77.20565274199532 * w2_3)) <= 0.9850746268656713 * within_3)
                        && (absolute((2.8712027904432142 * w1_3) + (99.5000219686458 * w2_3)) <= 0.9850746268656713 * within_3)
                        && (absolute(((-0.002956259426847662) * w1_3) - (0.09613122171945701 * w2_3)) <= 0.9850746268656717 * most2_3)
                        && (absolute(((-0.0017656644504526516) * w1_3) - (0.05290649279938503 * w2_3)) <= 0.9850746268656717 * most2_3)
                        && (absolute(((-0.0011677836082279918) * w1_3) - (0.03360345134034914 * w2_3)) <= 0.9850746268656717 * most2_3)
                        && (absolute(((-0.0024786977728154204) * w1_3) - (0.07769377681142388 * w2_3)) <= 0.9850746268656717 * most2_3)
                        && (absolute(((-0.0015503374252696213) * w1_3) - (0.04582303911158442 * w2_3)) <= 0.9850746268656717 * most2_3)
                        && (absolute(((-0.0022338585783963937) * w1_3) - (0.06891066916277001 * w2_3)) <= 0.9850746268656717 * most2_3)) {
                        fits = 3U;
                    }
                } else {
                    const double m_3 = static_cast<double>(tried);
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
                        && (absolute((119.99999999999996 * w1_3) + (4559.999999999999 * w2_3)) <= 0.9850746268656713 * within_3)
                        && (absolute((92.75321716019634 * w1_3) + (2422.754466594877 * w2_3)) <= 0.9850746268656713 * within_3)
                        && (absolute((67.8353765546998 * w1_3) + (1509.7849977027897 * w2_3)) <= 0.9850746268656713 * within_3)
                        && (absolute((114.21150278293138 * w1_3) + (3629.3877551020414 * w2_3)) <= 0.9850746268656713 * within_3)
                        && (absolute((84.39364430426792 * w1_3) + (2085.179889377806 * w2_3)) <= 0.9850746268656713 * within_3)
                        && (absolute((108.11363033997543 * w1_3) + (3196.9332337421392 * w2_3)) <= 0.9850746268656713 * within_3)
                        && (absolute(((-0.105) * w1_3) - (2.6599999999999997 * w2_3)) <= 0.9850746268656717 * most2_3)
                        && (absolute(((-0.058203486150742986) * w1_3) - (1.1378064924738662 * w2_3)) <= 0.9850746268656717 * most2_3)
                        && (absolute(((-0.037106802165033106) * w1_3) - (0.6137180874826768 * w2_3)) <= 0.9850746268656717 * most2_3)
                        && (absolute(((-0.08512987012987014) * w1_3) - (1.9394805194805198 * w2_3)) <= 0.9850746268656717 * most2_3)
                        && (absolute(((-0.05047405138739328) * w1_3) - (0.9359102869242929 * w2_3)) <= 0.9850746268656717 * most2_3)
                        && (absolute(((-0.07561224489795919) * w1_3) - (1.637031539888683 * w2_3)) <= 0.9850746268656717 * most2_3)) {
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
            && finite(flat1_2)
            && finite(flat2_2)
            && finite(flat1_3)
            && finite(flat2_3)) {
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
    static constexpr double s1_1_1_{120000000.0};
    /// Weight of x2 in the law.
    static constexpr double s1_2_1_{-60000.0};
    /// Weight of x2 in the law.
    static constexpr double s2_2_1_{120000.0};
    /// Weight of x1 in the law.
    static constexpr double s1_1_2_{45000000.0};
    /// Weight of x2 in the law.
    static constexpr double s1_2_2_{-22500.0};
    /// Weight of x2 in the law.
    static constexpr double s2_2_2_{45000.0};
    /// Weight of x1 in the law.
    static constexpr double s1_1_3_{12000000.0};
    /// Weight of x2 in the law.
    static constexpr double s1_2_3_{-6000.0};
    /// Weight of x2 in the law.
    static constexpr double s2_2_3_{12000.0};
    /// Lower limit of u.
    static constexpr double u_min_1_{-900.0};
    /// Upper limit of u.
    static constexpr double u_max_1_{900.0};
    /// Lower limit of u.
    static constexpr double u_min_2_{-400.0};
    /// Upper limit of u.
    static constexpr double u_max_2_{400.0};
    /// Lower limit of u.
    static constexpr double u_min_3_{-150.0};
    /// Upper limit of u.
    static constexpr double u_max_3_{60.0};
    /// Samples to go at which the gains are held.
    static constexpr double hold_{20.0};
    /// Samples to go at which the law of the end takes over.
    static constexpr double end_samples_1_{50.0};
    /// Weight of x1 in the law.
    static constexpr double w1_1_1_{-720000000.0};
    /// Weight of x2 in the law.
    static constexpr double w1_2_1_{360000.0};
    /// Weight of x2 in the law.
    static constexpr double w2_2_1_{-480000.0};
    /// Weight of x1 in the law.
    static constexpr double end1_1_1_{-1440000000.0};
    /// Weight of x2 in the law.
    static constexpr double end1_2_1_{720000.0};
    /// Weight of x2 in the law.
    static constexpr double end2_2_1_{-720000.0};
    /// Samples to go at which the law of the end takes over.
    static constexpr double end_samples_2_{50.0};
    /// Weight of x1 in the law.
    static constexpr double w1_1_2_{-270000000.0};
    /// Weight of x2 in the law.
    static constexpr double w1_2_2_{135000.0};
    /// Weight of x2 in the law.
    static constexpr double w2_2_2_{-180000.0};
    /// Weight of x1 in the law.
    static constexpr double end1_1_2_{-540000000.0};
    /// Weight of x2 in the law.
    static constexpr double end1_2_2_{270000.0};
    /// Weight of x2 in the law.
    static constexpr double end2_2_2_{-270000.0};
    /// Samples to go at which the law of the end takes over.
    static constexpr double end_samples_3_{50.0};
    /// Weight of x1 in the law.
    static constexpr double w1_1_3_{-72000000.0};
    /// Weight of x2 in the law.
    static constexpr double w1_2_3_{36000.0};
    /// Weight of x2 in the law.
    static constexpr double w2_2_3_{-48000.0};
    /// Weight of x1 in the law.
    static constexpr double end1_1_3_{-144000000.0};
    /// Weight of x2 in the law.
    static constexpr double end1_2_3_{72000.0};
    /// Weight of x2 in the law.
    static constexpr double end2_2_3_{-72000.0};

    std::uint32_t start_{}; // tick at which it was armed
    std::uint32_t last_{}; // samples from the start to rest, as planned now
};

} // namespace ptc

#endif
