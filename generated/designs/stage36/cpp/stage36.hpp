/*
 * Prescribed-time controller stage36: outputs of order 2, 2, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang cpp --mu exp --name stage36 --clock samples --precision f32 --eps=0 --states="q1, q2, w1, w2" --inputs=F1,F2 --inertia="[[2, 1/2], [1/2, 1]]" --bias="3*q1 - c*q2 + w1/4, c*q2" --param c=2 --sample-time=0.02
 * Version 0.1.0, design 9c23f2154001.
 *
 * Plant: the inputs F1, F2: q = (q1, q2), q' = (w1, w2), M q'' + bias = u, M = [[2, 1/2],
 *       [1/2, 1]], bias = [3*q1 - c*q2 + w1/4, c*q2]; u held from sample to sample.
 * Goal: x = 0 at sample N after the start, exact up to rounding, from any state, as long as
 *       no u is clipped and nothing else acts on the plant.
 * Law of each output, of order n, in its chain xi as it is sampled, which is the output with
 *       its derivatives up to O(h), and which held inputs move exactly: with M - s samples to
 *       go and z = S xi, v h^n = sum of row_j z_j h^(j-1)/((M-j+1)...(M-n+1)); the rows are
 *       those of Theorem 1 for the mapping exp. xi_j of output i is xj_i in step, and v_i is
 *       law_i. s = 0, 0. Output 1: Close to the end deadbeat takes over. Output 2: Close to
 *       the end deadbeat takes over.
 * Output 1, of order n = 2, to four digits:
 *   xi_1 = q1 - 4.762e-6*w1 + 5.443e-11*w2
 *   xi_2 = w1 - 5.715e-5*w2
 *   f_1 = -1.712*q1 + 1.712*q2 - 0.1598*w1 + 0.01713*w2
 * Output 2, of order n = 2, to four digits:
 *   xi_1 = q2 + 2.381e-6*w1 - 2.722e-11*w2
 *   xi_2 = -2.858e-5*w1 + w2
 *   f_2 = 0.8558*q1 - 2.856*q2 + 0.07988*w1 - 0.02856*w2
 * u = G^-1 w with w_i = v_i - f_i, to four digits:
 *   G^-1 = [[2.003, 0.4999], [0.5, 1]]
 * Outputs: 2, each with a law of its own, with this deadline and mapping; u_max is of the
 *       input of this number.
 *
 * Parameters:
 *   samples [samples]: samples N from the start to rest
 *   h = 0.02 [s], fixed: sample period
 *   eps = 0 [s], fixed: time-to-go at which the gains are held
 *   u_max [unit of u]: bound of |u|
 *   a [1/s]: rate of stretched time
 *   k_1 [1/s^2]: gains k_i of pi0 = -sum k_i xi_i
 *   k_2 [1/s]: gains k_i of pi0 = -sum k_i xi_i
 *   deadbeat [samples]: samples to go at which deadbeat takes over, 0 for a safe default
 *   c = 2 [as in its expression], fixed: parameter of an expression of the design
 *
 * k counts samples and may wrap; arm again within 2^32 - N samples.
 * From sample N on the last gains are held (status HOLD).
 * |u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
 *       lasts.
 * Guard full: what is measured is finite, or the call is refused (INPUT).
 * Precision f32 (IEEE 754 binary32). Results are bit for bit the same on every IEEE 754
 *       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
 *
 * Checks of the design (details: ptc-codegen check):
 *   membership: sound: exp is of class M for all its parameters.
 *   growth: sound: at rest at sample N from any state, whatever the poles, and |u| is bounded.
 *   sampling: not checked: the law is exact in samples, at any period.
 *   deadline: not checked: the law is exact in samples, at any period.
 *   loop: not checked: `samples` is left to run time.
 *   envelope: not checked: `x_max` is not given.
 *   zeros: sound: none: the relative degrees are 2, 2, whose sum is the number of states.
 */
#ifndef STAGE36_AD4AE918_HPP
#define STAGE36_AD4AE918_HPP

#include <array>
#include <cfloat>
#include <cstddef>
#include <cstdint>
#include <limits>

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
struct Stage36Params {
    std::uint32_t samples{}; ///< samples N from the start to rest [samples], at least 2
    float u_max{}; ///< bound of |u| [unit of u], > 0, infinity allowed
    float a{}; ///< rate of stretched time [1/s], from 1e-18 to 1e18
    std::array<float, 2> k{}; ///< gains k_i of pi0 = -sum k_i xi_i [1/s^2], finite
    float deadbeat{}; ///< samples to go at which deadbeat takes over, 0 for a safe default [samples], finite
};

/// Controller: set by init, changed by arm and by what is not const.
class Stage36 {
public:
    using Params = Stage36Params;

    /// Takes the parameters and arms at tick 0. Ok, or Param with nothing changed.
    [[nodiscard]] constexpr Status init(const Params& params) noexcept
    {
        if (!((params.samples > 1U)
                && (params.u_max > 0.0f)
                && (1e-18f <= params.a)
                && (params.a <= 1e18f)
                && finite(params.k[0])
                && finite(params.k[1])
                && finite(params.deadbeat)
                && (params.deadbeat >= 0.0f))) {
            return Status::Param;
        }
        const std::uint32_t samples = params.samples;
        const float s1 = ((params.k[1] / params.a) - 1.0f) + 2.0f;
        const float s2 = (s1 < 4.0f) ? 4.0f : s1;
        const float deadbeat_1 = (params.deadbeat > 0.0f) ? params.deadbeat : s2;
        const float w1_1_1 = 2500.0f * (-(params.k[0] / (params.a * params.a)));
        const float w1_2_1 = 50.0f * ((-0.5f) * (-(params.k[0] / (params.a * params.a))));
        const float w2_2_1 = 50.0f * (1.0f - (params.k[1] / params.a));
        const float u_max = params.u_max;
        if (!(finite(deadbeat_1) && finite(w1_1_1) && finite(w1_2_1) && finite(w2_2_1))) {
            return Status::Param;
        }
        start_ = 0U;
        samples_ = samples;
        deadbeat_1_ = deadbeat_1;
        w1_1_1_ = w1_1_1;
        w1_2_1_ = w1_2_1;
        w2_2_1_ = w2_2_1;
        u_max_ = u_max;
        return Status::Ok;
    }

    /// Starts again: the deadline is N samples after tick `k`.
    constexpr void arm(std::uint32_t k) noexcept
    {
        start_ = k;
    }

    /// u = (F1, F2) from tick `k`, which may wrap, and state x = (q1, q2, w1, w2). Where one of
    /// them is not finite, as at a state at which the inputs do not decouple the outputs, every u
    /// is 0; else the status is SATURATED where one was clipped.
    constexpr Axes<float, 2> step(std::uint32_t k, const std::array<float, 4>& x) const noexcept
    {
        Axes<float, 2> all{};
        if (!(finite(x[0]) && finite(x[1]) && finite(x[2]) && finite(x[3]))) {
            return {{}, {{Status::Input, Status::Input}}, Status::Input};
        }
        const std::uint32_t elapsed = k - start_;

        // The chain of each output as it is sampled.
        const float x1_1 = x[0] + ((-4.7624485e-6f) * x[2]) + (5.4430127e-11f * x[3]);
        const float x2_1 = (1.0000571f * x[2]) + ((-5.71533e-5f) * x[3]);
        const float x1_2 = x[1] + (2.3814148e-6f * x[2]) + ((-2.7217397e-11f) * x[3]);
        const float x2_2 = ((-2.857665e-5f) * x[2]) + (1.0000952f * x[3]);
        const std::uint32_t left = (elapsed < samples_) ? (samples_ - elapsed) : 0U;
        const float m0_1 = static_cast<float>(left);
        float law_1{};
        const float m0_2 = static_cast<float>(left);
        float law_2{};
        if (m0_1 > deadbeat_1_) {
            // The exact law in samples.
            const float z1_1 = (w1_1_1_ * x1_1) + (w1_2_1_ * x2_1);
            const float z2_1 = w2_2_1_ * x2_1;
            law_1 = (z1_1 + (z2_1 * m0_1)) / (m0_1 * (m0_1 - 1.0f));
        } else {
            // Deadbeat.
            law_1 = (b_1_1_ * x1_1) + (b_2_1_ * x2_1);
        }
        if (m0_2 > deadbeat_1_) {
            // The exact law in samples.
            const float z1_2 = (w1_1_1_ * x1_2) + (w1_2_1_ * x2_2);
            const float z2_2 = w2_2_1_ * x2_2;
            law_2 = (z1_2 + (z2_2 * m0_2)) / (m0_2 * (m0_2 - 1.0f));
        } else {
            // Deadbeat.
            law_2 = (b_1_2_ * x1_2) + (b_2_2_ * x2_2);
        }

        // The inputs that give all of them.
        const float s1 = ((-1.7116923f) * x[0]) + (1.7115782f * x[1]) + ((-0.15976757f) * x[2]);
        const float v1 = law_1 - (s1 + (0.017126543f * x[3]));
        const float s2 = (0.855789f * x[0]) + ((-2.8555987f) * x[1]) + (0.07987902f * x[2]);
        const float v2 = law_2 - (s2 + ((-0.028563272f) * x[3]));
        const float control1 = (2.0026014f * v1) + (0.49993333f * v2);
        const float control2 = (0.49999994f * v1) + (1.0000666f * v2);
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
            all.u[0] = 0.0f;
            if (finite(control1)) {
                all.axes[0] = all.status;
            } else {
                all.axes[0] = Status::Range;
            }
            all.u[1] = 0.0f;
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
    static constexpr bool finite(float v) noexcept
    {
        return (v >= std::numeric_limits<float>::lowest()) && (v <= (std::numeric_limits<float>::max)());
    }
    /// Weight of x1 in the law.
    static constexpr float b_1_1_{-2500.0f};
    /// Weight of x2 in the law.
    static constexpr float b_2_1_{-75.0f};
    /// Weight of x1 in the law.
    static constexpr float b_1_2_{-2500.0f};
    /// Weight of x2 in the law.
    static constexpr float b_2_2_{-75.0f};

    std::uint32_t start_{}; // tick at which it was armed
    std::uint32_t samples_{}; // samples from the start to rest
    float deadbeat_1_{}; // samples to go at which deadbeat takes over
    float w1_1_1_{}; // weight of x1 in the law
    float w1_2_1_{}; // weight of x2 in the law
    float w2_2_1_{}; // weight of x2 in the law
    float u_max_{}; // bound of |u|
};

} // namespace ptc

#endif
