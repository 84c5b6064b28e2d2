/*
 * Prescribed-time controller stage25: outputs of order 1, 2, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang cpp --mu "exp(a=1)" --name stage25 --clock samples --tau=0.3 --eps=0.04 --limits=2,3 --poles="[[-4],[-3,-4.5]]" --states="h, c, e" --inputs=q,p --outputs="h, e" --dynamics="q - 1/10*h, p - c*(1 + h), (c - e)*(1 + h)" --sample-time=0.01
 * Version 0.1.0, design 602ddeccb2d0.
 *
 * Plant: the inputs q, p: h' = q - 1/10*h, c' = p - c*(1 + h), e' = (c - e)*(1 + h), output 1
 *       = h, output 2 = e; u held from sample to sample.
 * Goal: every output with its derivatives is 0 at sample N after the start, from any state,
 *       as long as no u is clipped and the plant is the model. The plant is known at the
 *       samples alone, which leaves an error of order h^(n+2-i) in x_i of an output of order
 *       n.
 * Law of each output, of order n: with M - s samples to go and z = S x, v h^n = sum of row_j
 *       z_j h^(j-1)/((M-j+1)...(M-n+1)); the rows are those of Theorem 1 for the mapping exp.
 *       v_i is law_i in step. s = 2, -2. Output 1: The gains of 4 samples to go stay. Rest is
 *       planned 1 sample early, and the last gains bring down what f and g did between
 *       samples. Output 2: From 6 samples to go on these are M - 2 and the exponents 3, 4,
 *       those of least energy. The gains of 4 samples to go stay. Rest is planned 2 samples
 *       early, and the last gains bring down what f and g did between samples.
 * Output 1, of order n = 1:
 *   x_1 = h
 *   f_1 = -h/10
 * Output 2, of order n = 2:
 *   x_1 = e
 *   x_2 = (c - e)*(1 + h)
 *   f_2 = (-c*(1 + h) - (c - e)*(1 + h))*(1 + h) + (c - e)*(-h/10)
 * u = adj(D) w/det(D) with w_i = v_i - f_i:
 *   det(D) = 1 + h
 *   adj(D) = [[1 + h, 0], [-(c - e), 1]]
 * Outputs: 2, each with a law of its own, with this deadline and mapping; u_max is of the
 *       input of this number.
 *   output 1: k = 4; u_max = 2
 *   output 2: k = 13.5, 7.5; u_max = 3
 *
 * Parameters:
 *   samples = 30 [samples], fixed: samples N from the start to rest
 *   h = 0.01 [s], fixed: sample period
 *   eps = 0.04 [s], fixed: time-to-go at which the gains are held
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
 *   growth: sound: near rest at sample 30, not at rest: the gains are held from 4 samples to
 *       go, and |u| is bounded; so does what f + g u does between samples.
 *   sampling: not checked: `loop` bounds what the period leaves of a plant with several
 *       inputs.
 *   deadline: not checked: `loop` bounds what the period leaves of a plant with several
 *       inputs.
 *   loop: not checked: `x0_max` is not given.
 *   envelope: not checked: `x_max` is not given.
 *   zeros: sound: none: the relative degrees are 1, 2, whose sum is the number of states.
 */
#ifndef STAGE25_2DED160B_HPP
#define STAGE25_2DED160B_HPP

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
struct Stage25Params {
};

/// Controller: set by init, changed by arm and by what is not const.
class Stage25 {
public:
    using Params = Stage25Params;

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

    /// u = (q, p) from tick `k`, which may wrap, and state x = (h, c, e). Where one of them is not
    /// finite, as at a state at which the inputs do not decouple the outputs, every u is 0; else
    /// the status is SATURATED where one was clipped.
    constexpr Axes<double, 2> step(std::uint32_t k, const std::array<double, 3>& x) const noexcept
    {
        Axes<double, 2> all{};
        if (!(finite(x[0]) && finite(x[1]) && finite(x[2]))) {
            return {{}, {{Status::Input, Status::Input}}, Status::Input};
        }
        const std::uint32_t elapsed = k - start_;

        // The chain of each output.
        const double x1_1 = x[0];
        const double x1_2 = x[2];
        const double v1 = x[1] - x1_2;
        const double v2 = 1.0 + x1_1;
        const double x2_2 = v1 * v2;
        const std::uint32_t left = (elapsed < samples_) ? (samples_ - elapsed) : 0U;
        const double s1 = static_cast<double>(left) - 1.0;
        const double m0_1 = (s1 < hold_) ? hold_ : s1;
        double law_1{};

        // The exact law in samples.
        const double z1_1 = w1_1_1_ * x1_1;
        law_1 = z1_1 / (m0_1 + 3.0);
        const double s2 = static_cast<double>(left) - 2.0;
        const double m0_2 = (s2 < hold_) ? hold_ : s2;
        double law_2{};
        if (m0_2 > end_samples_2_) {
            // The exact law in samples.
            const double z1_2 = (w1_1_2_ * x1_2) + (w1_2_2_ * x2_2);
            const double z2_2 = w2_2_2_ * x2_2;
            law_2 = (z1_2 + (z2_2 * m0_2)) / (m0_2 * (m0_2 - 1.0));
        } else {
            // The law of least energy to the end.
            const double m1_2 = (m0_2 < 2.0) ? 2.0 : m0_2;
            const double y1_2 = (end1_1_2_ * x1_2) + (end1_2_2_ * x2_2);
            const double y2_2 = end2_2_2_ * x2_2;
            const double m1f_21 = m1_2 + 2.0;
            law_2 = (y1_2 + (y2_2 * m1f_21)) / (m1f_21 * (m1_2 + 1.0));
        }

        // The inputs that give all of them.
        const double v3 = (-x1_1) * 0.1;
        const double v4 = law_1 - v3;
        const double v5 = ((v2 < 0.0) || (v2 > 0.0)) ? (1.0 / v2) : std::numeric_limits<double>::quiet_NaN();
        const double control1 = v2 * v4 * v5;
        const double s3 = ((-v1) * v4) + (law_2 - (((((-x[1]) * v2) - x2_2) * v2) + (v1 * v3)));
        const double control2 = s3 * v5;
        if (static_cast<double>(left) > hold_) {
            all.status = Status::Ok;
        } else {
            all.status = Status::Hold;
        }
        if (finite(control1) && finite(control2)) {
            all.u[0] = control1;
            all.axes[0] = all.status;
            all.u[1] = control2;
            all.axes[1] = all.status;
            if (control1 > 2.0) {
                all.u[0] = 2.0;
                all.axes[0] = Status::Saturated;
                all.status = Status::Saturated;
            } else if (control1 < -2.0) {
                all.u[0] = -2.0;
                all.axes[0] = Status::Saturated;
                all.status = Status::Saturated;
            }
            if (control2 > 3.0) {
                all.u[1] = 3.0;
                all.axes[1] = Status::Saturated;
                all.status = Status::Saturated;
            } else if (control2 < -3.0) {
                all.u[1] = -3.0;
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
    /// Samples from the start to rest.
    static constexpr std::uint32_t samples_{30U};
    /// Samples to go at which the gains are held.
    static constexpr double hold_{4.0};
    /// Weight of x1 in the law.
    static constexpr double w1_1_1_{-400.0};
    /// Samples to go at which the law of the end takes over.
    static constexpr double end_samples_2_{6.0};
    /// Weight of x1 in the law.
    static constexpr double w1_1_2_{-135000.0};
    /// Weight of x2 in the law.
    static constexpr double w1_2_2_{675.0};
    /// Weight of x2 in the law.
    static constexpr double w2_2_2_{-650.0};
    /// Weight of x1 in the law.
    static constexpr double end1_1_2_{-120000.0};
    /// Weight of x2 in the law.
    static constexpr double end1_2_2_{600.0};
    /// Weight of x2 in the law.
    static constexpr double end2_2_2_{-600.0};

    std::uint32_t start_{}; // tick at which it was armed
};

} // namespace ptc

#endif
