/*
 * Prescribed-time controller stage26: outputs of order 2, 2, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang cpp --mu exp --name stage26 --clock samples --precision f32 --guard none --eps=0 --states="q1, q2, w1, w2" --inputs=F1,F2 --inertia="[[m + q2^2, q2], [q2, 1]]" --bias="m*q2*w1*w2, w1^2/2 - q1"
 * Version 0.1.0, design 7cc34530b578.
 *
 * Plant: the inputs F1, F2: q = (q1, q2), q' = (w1, w2), M q'' + bias = u, M = [[m + q2^2,
 *       q2], [q2, 1]], bias = [m*q2*w1*w2, w1^2/2 - q1]; u held from sample to sample.
 * Goal: every output with its derivatives is 0 at sample N after the start, from any state,
 *       as long as no u is clipped and the plant is the model. The plant is known at the
 *       samples alone, which leaves an error of order h^(n+2-i) in x_i of an output of order
 *       n.
 * Law of each output, of order n: with M - s samples to go and z = S x, v h^n = sum of row_j
 *       z_j h^(j-1)/((M-j+1)...(M-n+1)); the rows are those of Theorem 1 for the mapping exp.
 *       v_i is law_i in step. s = 0, 0. Output 1: Close to the end deadbeat takes over.
 *       Output 2: Close to the end deadbeat takes over.
 * Output 1, of order n = 2:
 *   x_1 = q1
 *   x_2 = w1
 * Output 2, of order n = 2:
 *   x_1 = q2
 *   x_2 = w2
 * u = M v + bias
 * Outputs: 2, each with a law of its own, with this deadline and mapping; u_max is of the
 *       input of this number.
 *
 * Parameters:
 *   samples [samples]: samples N from the start to rest
 *   h [s]: sample period
 *   eps = 0 [s], fixed: time-to-go at which the gains are held
 *   u_max [unit of u]: bound of |u|
 *   a [1/s]: rate of stretched time
 *   k_1 [1/s^2]: gains k_i of pi0 = -sum k_i xi_i
 *   k_2 [1/s]: gains k_i of pi0 = -sum k_i xi_i
 *   deadbeat [samples]: samples to go at which deadbeat takes over, 0 for a safe default
 *   m [as in its expression]: parameter of an expression of the design
 *
 * k counts samples and may wrap; arm again within 2^32 - N samples.
 * From sample N on the last gains are held (status HOLD).
 * |u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
 *       lasts.
 * Guard none: finite measurements are the responsibility of the caller.
 * Precision f32 (IEEE 754 binary32). Results are bit for bit the same on every IEEE 754
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
 *   zeros: sound: none: the relative degrees are 2, 2, whose sum is the number of states.
 */
#ifndef STAGE26_C6BBE6FF_HPP
#define STAGE26_C6BBE6FF_HPP

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
struct Stage26Params {
    std::uint32_t samples{}; ///< samples N from the start to rest [samples], at least 2
    float h{}; ///< sample period [s], from 1e-18 to 1e18
    float u_max{}; ///< bound of |u| [unit of u], > 0, infinity allowed
    float a{}; ///< rate of stretched time [1/s], from 1e-18 to 1e18
    std::array<float, 2> k{}; ///< gains k_i of pi0 = -sum k_i xi_i [1/s^2], finite
    float deadbeat{}; ///< samples to go at which deadbeat takes over, 0 for a safe default [samples], finite
    float m{}; ///< parameter of an expression of the design [as in its expression], finite
};

/// Controller: set by init, changed by arm and by what is not const.
class Stage26 {
public:
    using Params = Stage26Params;

    /// Takes the parameters and arms at tick 0. Ok, or Param with nothing changed.
    [[nodiscard]] constexpr Status init(const Params& params) noexcept
    {
        if (!((params.samples > 1U)
                && (1e-18f <= params.h)
                && (params.h <= 1e18f)
                && (params.u_max > 0.0f)
                && (1e-18f <= params.a)
                && (params.a <= 1e18f)
                && finite(params.k[0])
                && finite(params.k[1])
                && finite(params.deadbeat)
                && (params.deadbeat >= 0.0f)
                && finite(params.m))) {
            return Status::Param;
        }
        const std::uint32_t samples = params.samples;
        const float s1 = ((params.k[1] / params.a) - 1.0f) + 2.0f;
        const float s2 = (s1 < 4.0f) ? 4.0f : s1;
        const float deadbeat_1 = (params.deadbeat > 0.0f) ? params.deadbeat : s2;
        const float s3 = -(params.k[0] / (params.a * params.a));
        const float w1_1_1 = s3 * (1.0f / (params.h * params.h));
        const float s4 = (-0.5f) * (-(params.k[0] / (params.a * params.a)));
        const float w1_2_1 = s4 * (1.0f / params.h);
        const float w2_2_1 = (1.0f - (params.k[1] / params.a)) * (1.0f / params.h);
        const float b_1_1 = -(1.0f / (params.h * params.h));
        const float b_2_1 = (-1.5f) * (1.0f / params.h);
        const float p_m = params.m;
        const float u_max = params.u_max;
        if (!(finite(deadbeat_1)
                && finite(w1_1_1)
                && finite(w1_2_1)
                && finite(w2_2_1)
                && finite(b_1_1)
                && finite(b_2_1)
                && (params.h * params.h >= 1e-30f)
                && (1.0f / (params.h * params.h) >= 1e-30f))) {
            return Status::Param;
        }
        start_ = 0U;
        samples_ = samples;
        deadbeat_1_ = deadbeat_1;
        w1_1_1_ = w1_1_1;
        w1_2_1_ = w1_2_1;
        w2_2_1_ = w2_2_1;
        b_1_1_ = b_1_1;
        b_2_1_ = b_2_1;
        p_m_ = p_m;
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
        const std::uint32_t elapsed = k - start_;

        // The chain of each output.
        const float x1_1 = x[0];
        const float x2_1 = x[2];
        const float x1_2 = x[1];
        const float x2_2 = x[3];
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
            law_2 = (b_1_1_ * x1_2) + (b_2_1_ * x2_2);
        }

        // The inputs that give all of them.
        const float s1 = ((p_m_ + (x1_2 * x1_2)) * law_1) + (x1_2 * law_2);
        const float control1 = s1 + (p_m_ * x1_2 * x2_1 * x2_2);
        const float control2 = (x1_2 * law_1) + law_2 + ((x2_1 * x2_1 * 0.5f) - x1_1);
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

    std::uint32_t start_{}; // tick at which it was armed
    std::uint32_t samples_{}; // samples from the start to rest
    float deadbeat_1_{}; // samples to go at which deadbeat takes over
    float w1_1_1_{}; // weight of x1 in the law
    float w1_2_1_{}; // weight of x2 in the law
    float w2_2_1_{}; // weight of x2 in the law
    float b_1_1_{}; // weight of x1 in the law
    float b_2_1_{}; // weight of x2 in the law
    float p_m_{}; // parameter of an expression of the design
    float u_max_{}; // bound of |u|
};

} // namespace ptc

#endif
