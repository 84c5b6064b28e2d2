/*
 * Prescribed-time controller stage28: outputs of order 1, 1, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang cpp --mu "exp(a=1)" --name stage28 --clock samples --deadbeat=9 --eps=0 --gains="[[3],[4.5]]" --states="a, b" --inputs=A,B --outputs="a, b" --dynamics="A*(b - 1), A + B - k*a"
 * Version 0.1.0, design e8fd88f575ec.
 *
 * Plant: the inputs A, B: a' = A*(b - 1), b' = A + B - k*a, output 1 = a, output 2 = b; u
 *       held from sample to sample.
 * Goal: every output with its derivatives is 0 at sample N after the start, from any state,
 *       as long as no u is clipped and the plant is the model. The plant is known at the
 *       samples alone, which leaves an error of order h^(n+2-i) in x_i of an output of order
 *       n.
 * Law of each output, of order n: with M - s samples to go and z = S x, v h^n = sum of row_j
 *       z_j h^(j-1)/((M-j+1)...(M-n+1)); the rows are those of Theorem 1 for the mapping exp.
 *       v_i is law_i in step. s = 0, 0. Output 1: Close to the end, with 9 samples to go
 *       deadbeat takes over. Output 2: Close to the end, with 9 samples to go deadbeat takes
 *       over.
 * Output 1, of order n = 1:
 *   x_1 = a
 * Output 2, of order n = 1:
 *   x_1 = b
 *   f_2 = -k*a
 * u = adj(D) w/det(D) with w_i = v_i - f_i:
 *   det(D) = b - 1
 *   adj(D) = [[1, 0], [-1, b - 1]]
 * Outputs: 2, each with a law of its own, with this deadline and mapping; u_max is of the
 *       input of this number.
 *   output 1: k = 3
 *   output 2: k = 4.5
 *
 * Parameters:
 *   samples [samples]: samples N from the start to rest
 *   h [s]: sample period
 *   eps = 0 [s], fixed: time-to-go at which the gains are held
 *   u_max [unit of u]: bound of |u|
 *   a = 1 [1/s], fixed: rate of stretched time
 *   k [as in its expression]: parameter of an expression of the design
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
 *   growth: sound: at rest at sample N from any state, but for what f + g u does between
 *       samples, whatever the poles, and |u| is bounded.
 *   sampling: not checked: `loop` bounds what the period leaves of a plant with several
 *       inputs.
 *   deadline: not checked: `loop` bounds what the period leaves of a plant with several
 *       inputs.
 *   loop: not checked: `samples` is left to run time.
 *   envelope: not checked: `x_max` is not given.
 *   zeros: sound: none: the relative degrees are 1, 1, whose sum is the number of states.
 */
#ifndef STAGE28_42E99100_HPP
#define STAGE28_42E99100_HPP

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
struct Stage28Params {
    std::uint32_t samples{}; ///< samples N from the start to rest [samples], at least 1
    double h{}; ///< sample period [s], from 1e-150 to 1e150
    double u_max{}; ///< bound of |u| [unit of u], > 0, infinity allowed
    double k{}; ///< parameter of an expression of the design [as in its expression], finite
};

/// Controller: set by init, changed by arm and by what is not const.
class Stage28 {
public:
    using Params = Stage28Params;

    /// Takes the parameters and arms at tick 0. Ok, or Param with nothing changed.
    [[nodiscard]] constexpr Status init(const Params& params) noexcept
    {
        if (!((params.samples > 0U)
                && (1e-150 <= params.h)
                && (params.h <= 1e150)
                && (params.u_max > 0.0)
                && finite(params.k))) {
            return Status::Param;
        }
        const std::uint32_t samples = params.samples;
        const double w1_1_1 = (-3.0) * (1.0 / params.h);
        const double b_1_1 = -(1.0 / params.h);
        const double w1_1_2 = (-4.5) * (1.0 / params.h);
        const double p_k = params.k;
        const double c1 = -p_k;
        const double u_max = params.u_max;
        if (!(finite(w1_1_1)
                && finite(b_1_1)
                && finite(w1_1_2)
                && finite(c1)
                && (params.h >= 1e-200)
                && (1.0 / params.h >= 1e-200))) {
            return Status::Param;
        }
        start_ = 0U;
        samples_ = samples;
        w1_1_1_ = w1_1_1;
        b_1_1_ = b_1_1;
        w1_1_2_ = w1_1_2;
        p_k_ = p_k;
        c1_ = c1;
        u_max_ = u_max;
        return Status::Ok;
    }

    /// Starts again: the deadline is N samples after tick `k`.
    constexpr void arm(std::uint32_t k) noexcept
    {
        start_ = k;
    }

    /// u = (A, B) from tick `k`, which may wrap, and state x = (a, b). Where one of them is not
    /// finite, as at a state at which the inputs do not decouple the outputs, every u is 0; else
    /// the status is SATURATED where one was clipped.
    constexpr Axes<double, 2> step(std::uint32_t k, const std::array<double, 2>& x) const noexcept
    {
        Axes<double, 2> all{};
        if (!(finite(x[0]) && finite(x[1]))) {
            return {{}, {{Status::Input, Status::Input}}, Status::Input};
        }
        const std::uint32_t elapsed = k - start_;

        // The chain of each output.
        const double x1_1 = x[0];
        const double x1_2 = x[1];
        const std::uint32_t left = (elapsed < samples_) ? (samples_ - elapsed) : 0U;
        const double m0_1 = static_cast<double>(left);
        double law_1{};
        const double m0_2 = static_cast<double>(left);
        double law_2{};
        if (m0_1 > deadbeat_1_) {
            // The exact law in samples.
            const double z1_1 = w1_1_1_ * x1_1;
            law_1 = z1_1 / m0_1;
        } else {
            // Deadbeat.
            law_1 = b_1_1_ * x1_1;
        }
        if (m0_2 > deadbeat_2_) {
            // The exact law in samples.
            const double z1_2 = w1_1_2_ * x1_2;
            law_2 = z1_2 / m0_2;
        } else {
            // Deadbeat.
            law_2 = b_1_1_ * x1_2;
        }

        // The inputs that give all of them.
        const double v2 = x1_2 - 1.0;
        const double v3 = ((v2 < 0.0) || (v2 > 0.0)) ? (1.0 / v2) : std::numeric_limits<double>::quiet_NaN();
        const double control1 = law_1 * v3;
        const double control2 = ((-law_1) + (v2 * (law_2 - (c1_ * x1_1)))) * v3;
        if (elapsed < samples_) {
            all.status = Status::Ok;
        } else {
            all.status = Status::Hold;
        }
        if (finite(control1) && finite(control2)) {
            all.u[0] = control1;
            all.axes[0] = all.status;
            all.u[1] = control2;
            all.axes[1] = all.status;
            if (control1 > u_max_) {
                all.u[0] = u_max_;
                all.axes[0] = Status::Saturated;
                all.status = Status::Saturated;
            } else if (control1 < -u_max_) {
                all.u[0] = -u_max_;
                all.axes[0] = Status::Saturated;
                all.status = Status::Saturated;
            }
            if (control2 > u_max_) {
                all.u[1] = u_max_;
                all.axes[1] = Status::Saturated;
                all.status = Status::Saturated;
            } else if (control2 < -u_max_) {
                all.u[1] = -u_max_;
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
    /// Samples to go at which deadbeat takes over.
    static constexpr double deadbeat_1_{9.0};
    /// Samples to go at which deadbeat takes over.
    static constexpr double deadbeat_2_{9.0};

    std::uint32_t start_{}; // tick at which it was armed
    std::uint32_t samples_{}; // samples from the start to rest
    double w1_1_1_{}; // weight of x1 in the law
    double b_1_1_{}; // weight of x1 in the law
    double w1_1_2_{}; // weight of x1 in the law
    double p_k_{}; // parameter of an expression of the design
    double c1_{}; // derived from the parameters
    double u_max_{}; // bound of |u|
};

} // namespace ptc

#endif
