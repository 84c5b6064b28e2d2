/*
 * Prescribed-time controller stage35: outputs of order 2, 1, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang cpp --mu "exp(a=1)" --name stage35 --clock samples --tau=0.3 --eps=0 --limits=20,30 --poles="[[-3,-4],[-4]]" --states="s, v, i" --inputs=F,V --outputs="s, i" --dynamics="v, 3*i - 2*s - v/2 + F, V - 4*i + s/8" --sample-time=0.01
 * Version 0.1.0, design 28ee8693b5c2.
 *
 * Plant: the inputs F, V: s' = v, v' = 3*i - 2*s - v/2 + F, i' = V - 4*i + s/8, output 1 = s,
 *       output 2 = i; u held from sample to sample.
 * Goal: x = 0 at sample N after the start, exact up to rounding, from any state, as long as
 *       no u is clipped and nothing else acts on the plant.
 * Law of each output, of order n, in its chain xi as it is sampled, which is the output with
 *       its derivatives up to O(h), and which held inputs move exactly: with M - s samples to
 *       go and z = S xi, v h^n = sum of row_j z_j h^(j-1)/((M-j+1)...(M-n+1)); the rows are
 *       those of Theorem 1 for the mapping exp. xi_j of output i is xj_i in step, and v_i is
 *       law_i. s = 2, 3. Output 1: The gains of 2 samples to go stay: they are deadbeat.
 *       Output 2: The gains of 1 sample to go stay: they are deadbeat.
 * Output 1, of order n = 2, to four digits:
 *   xi_1 = s - 4.167e-6*v + 2.5e-5*i
 *   xi_2 = v
 *   f_1 = -1.993*s - 0.5087*v + 2.933*i
 * Output 2, of order n = 1, to four digits:
 *   xi_1 = i
 *   f_2 = 0.1225*s + 6.157e-4*v - 3.921*i
 * u = G^-1 w with w_i = v_i - f_i, to four digits:
 *   G^-1 = [[1.003, -0.01511], [-2.107e-6, 1.02]]
 * Outputs: 2, each with a law of its own, with this deadline and mapping; u_max is of the
 *       input of this number.
 *   output 1: k = 12, 7; u_max = 20
 *   output 2: k = 4; u_max = 30
 *
 * Parameters:
 *   samples = 30 [samples], fixed: samples N from the start to rest
 *   h = 0.01 [s], fixed: sample period
 *   eps = 0 [s], fixed: time-to-go at which the gains are held
 *   a = 1 [1/s], fixed: rate of stretched time
 *
 * k counts samples and may wrap; arm again within 2^32 - N samples.
 * From sample N on the last gains are held (status HOLD).
 * |u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
 *       lasts.
 * Guard full: what is measured is finite, or the call is refused (INPUT).
 * Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
 *       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
 *
 * Checks of the design (details: ptc-codegen check):
 *   membership: sound: exp is of class M for all its parameters.
 *   growth: sound: at rest at sample 30 from any state, whatever the poles, and |u| is
 *       bounded.
 *   sampling: not checked: the law is exact in samples, at any period.
 *   deadline: not checked: the law is exact in samples, at any period.
 *   loop: not checked: `x0_max` is not given.
 *   envelope: not checked: `x_max` is not given.
 *   zeros: sound: none: the relative degrees are 2, 1, whose sum is the number of states.
 */
#ifndef STAGE35_106B0AAF_HPP
#define STAGE35_106B0AAF_HPP

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
struct Stage35Params {
};

/// Controller: set by init, changed by arm and by what is not const.
class Stage35 {
public:
    using Params = Stage35Params;

    /// Takes the parameters and arms at tick 0. Ok, or Param with nothing changed.
    [[nodiscard]] constexpr Status init(const Params&) noexcept
    {
        start_ = 0U;
        return Status::Ok;
    }

    /// Starts again: the deadline is N samples after tick `k`.
    constexpr void arm(std::uint32_t k) noexcept
    {
        start_ = k;
    }

    /// u = (F, V) from tick `k`, which may wrap, and state x = (s, v, i). Where one of them is not
    /// finite, as at a state at which the inputs do not decouple the outputs, every u is 0; else
    /// the status is SATURATED where one was clipped.
    constexpr Axes<double, 2> step(std::uint32_t k, const std::array<double, 3>& x) const noexcept
    {
        Axes<double, 2> all{};
        if (!(finite(x[0]) && finite(x[1]) && finite(x[2]))) {
            return {{}, {{Status::Input, Status::Input}}, Status::Input};
        }
        const std::uint32_t elapsed = k - start_;

        // The chain of each output as it is sampled.
        const double x1_2 = x[2];
        const double s1 = x[0] + ((-4.16676736285295e-6) * x[1]);
        const double x1_1 = s1 + (2.499973960459077e-5 * x1_2);
        const double x2_1 = 1.0000166669696244 * x[1];
        double law_1{};

        // The exact law in samples.
        const double m0_1 = (elapsed < 28U) ? (static_cast<double>(32U - elapsed)) : 4.0;
        const double z1_1 = (w1_1_1_ * x1_1) + (w1_2_1_ * x2_1);
        const double z2_1 = w2_2_1_ * x2_1;
        law_1 = (z1_1 + (z2_1 * m0_1)) / (m0_1 * (m0_1 - 1.0));
        double law_2{};
        const double m0_2 = (elapsed < 29U) ? (static_cast<double>(33U - elapsed)) : 4.0;
        const double z1_2 = w1_1_2_ * x1_2;
        law_2 = z1_2 / m0_2;

        // The inputs that give all of them.
        const double s2 = ((-1.993127946172519) * x[0]) + ((-0.5087209499488312) * x[1]);
        const double v1 = law_1 - (s2 + (2.9333536080559304 * x1_2));
        const double s3 = (0.12252888444119461 * x[0]) + (0.0006157089861155933 * x[1]);
        const double v2 = law_2 - (s3 + ((-3.921049966023507) * x1_2));
        const double control1 = (1.002518807547881 * v1) + ((-0.015112747669367257) * v2);
        const double control2 = ((-2.106833310985952e-6) * v1) + (1.0201333455511812 * v2);
        if (elapsed < 30U) {
            all.status = Status::Ok;
        } else {
            all.status = Status::Hold;
        }
        if (finite(control1) && finite(control2)) {
            all.u[0] = control1;
            all.axes[0] = all.status;
            all.u[1] = control2;
            all.axes[1] = all.status;
            if (control1 > 20.0) {
                all.u[0] = 20.0;
                all.axes[0] = Status::Saturated;
                all.status = Status::Saturated;
            } else if (control1 < -20.0) {
                all.u[0] = -20.0;
                all.axes[0] = Status::Saturated;
                all.status = Status::Saturated;
            }
            if (control2 > 30.0) {
                all.u[1] = 30.0;
                all.axes[1] = Status::Saturated;
                all.status = Status::Saturated;
            } else if (control2 < -30.0) {
                all.u[1] = -30.0;
                all.axes[1] = Status::Saturated;
                all.status = Status::Saturated;
            }
        } else {
            all.u[0] = 0.0;
            if (finite(control1)) {
                all.axes[0] = all.status;
            } else {
                all.axes[0] = Status::Range;
            }
            all.u[1] = 0.0;
            if (finite(control2)) {
                all.axes[1] = all.status;
            } else {
                all.axes[1] = Status::Range;
            }
            all.status = Status::Range;
        }
        return all;
    }

private:
    /// std::isfinite is not constexpr in C++17.
    static constexpr bool finite(double v) noexcept
    {
        return (v >= std::numeric_limits<double>::lowest()) && (v <= (std::numeric_limits<double>::max)());
    }
    /// Weight of x1 in the law.
    static constexpr double w1_1_1_{-120000.0};
    /// Weight of x2 in the law.
    static constexpr double w1_2_1_{600.0};
    /// Weight of x2 in the law.
    static constexpr double w2_2_1_{-600.0};
    /// Weight of x1 in the law.
    static constexpr double w1_1_2_{-400.0};

    std::uint32_t start_{}; // tick at which it was armed
};

} // namespace ptc

#endif
