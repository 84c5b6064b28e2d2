/*
 * Prescribed-time controller stage1: order n = 2, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang cpp --n 2 --mu exp --name stage1 --clock samples --precision f32 --eps=0 --after zero
 * Version 0.1.0, design 3500be80ffee.
 *
 * Plant: x1' = x2, x2' = u; u held from sample to sample.
 * Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
 *       sample period, as long as u is not clipped and nothing else acts on the plant.
 * Law: with M samples to go and z = S x, u h^2 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-1));
 *       the rows are those of Theorem 1 for the mapping exp. Close to the end deadbeat takes
 *       over.
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
 *
 * k counts samples and may wrap; arm again within 2^32 - N samples.
 * From sample N on u = 0 (status AFTER).
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
 *   envelope: not checked: it does not examine a clock in samples.
 */
#ifndef STAGE1_3A7747A6_HPP
#define STAGE1_3A7747A6_HPP

#include <array>
#include <cfloat>
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

/// Run-time parameters.
struct Stage1Params {
    std::uint32_t samples{}; ///< samples N from the start to rest [samples], at least 2
    float h{}; ///< sample period [s], from 1e-18 to 1e18
    float u_max{}; ///< bound of |u| [unit of u], > 0, infinity allowed
    float a{}; ///< rate of stretched time [1/s], from 1e-18 to 1e18
    std::array<float, 2> k{}; ///< gains k_i of pi0 = -sum k_i xi_i [1/s^2], finite
    float deadbeat{}; ///< samples to go at which deadbeat takes over, 0 for a safe default [samples], finite
};

/// Controller: set by init, changed by arm and by what is not const.
class Stage1 {
public:
    using Params = Stage1Params;

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
                && (params.deadbeat >= 0.0f))) {
            return Status::Param;
        }
        const std::uint32_t samples = params.samples;
        const float s1 = ((params.k[1] / params.a) - 1.0f) + 2.0f;
        const float s2 = (s1 < 4.0f) ? 4.0f : s1;
        const float deadbeat = (params.deadbeat > 0.0f) ? params.deadbeat : s2;
        const float s3 = -(params.k[0] / (params.a * params.a));
        const float w1_1 = s3 * (1.0f / (params.h * params.h));
        const float s4 = (-0.5f) * (-(params.k[0] / (params.a * params.a)));
        const float w1_2 = s4 * (1.0f / params.h);
        const float w2_2 = (1.0f - (params.k[1] / params.a)) * (1.0f / params.h);
        const float b_1 = -(1.0f / (params.h * params.h));
        const float b_2 = (-1.5f) * (1.0f / params.h);
        const float u_max = params.u_max;
        if (!(finite(deadbeat)
                && finite(w1_1)
                && finite(w1_2)
                && finite(w2_2)
                && finite(b_1)
                && finite(b_2)
                && (params.h * params.h >= 1e-30f)
                && (1.0f / (params.h * params.h) >= 1e-30f))) {
            return Status::Param;
        }
        start_ = 0U;
        samples_ = samples;
        deadbeat_ = deadbeat;
        w1_1_ = w1_1;
        w1_2_ = w1_2;
        w2_2_ = w2_2;
        b_1_ = b_1;
        b_2_ = b_2;
        u_max_ = u_max;
        return Status::Ok;
    }

    /// Starts again: the deadline is N samples after tick `k`.
    constexpr void arm(std::uint32_t k) noexcept
    {
        start_ = k;
    }

    /// u from tick `k`, which may wrap, and the state x = (x1, x1', ...).
    /// On a negative status u is 0 and nothing has changed.
    constexpr Control<float> step(std::uint32_t k, const std::array<float, 2>& x) const noexcept
    {
        if (!(finite(x[0]) && finite(x[1]))) {
            return {0.0f, Status::Input};
        }
        const std::uint32_t elapsed = k - start_;
        const float x1 = x[0];
        const float x2 = x[1];
        const std::uint32_t left = (elapsed < samples_) ? (samples_ - elapsed) : 0U;
        const float m0 = static_cast<float>(left);
        float v{};
        if (m0 > deadbeat_) {
            // The exact law in samples.
            const float z1 = (w1_1_ * x1) + (w1_2_ * x2);
            const float z2 = w2_2_ * x2;
            v = (z1 + (z2 * m0)) / (m0 * (m0 - 1.0f));
        } else {
            // Deadbeat.
            v = (b_1_ * x1) + (b_2_ * x2);
        }
        if (finite(v)) {
            if (elapsed < samples_) {
                if (v > u_max_) {
                    return {u_max_, Status::Saturated};
                } else if (v < -u_max_) {
                    return {-u_max_, Status::Saturated};
                } else {
                    return {v, Status::Ok};
                }
            } else {
                return {0.0f, Status::After};
            }
        } else {
            return {0.0f, Status::Range};
        }
    }

private:
    /// std::isfinite is not constexpr in C++17.
    static constexpr bool finite(float v) noexcept
    {
        return (v >= std::numeric_limits<float>::lowest()) && (v <= (std::numeric_limits<float>::max)());
    }

    std::uint32_t start_{}; // tick at which it was armed
    std::uint32_t samples_{}; // samples from the start to rest
    float deadbeat_{}; // samples to go at which deadbeat takes over
    float w1_1_{}; // weight of x1 in the law
    float w1_2_{}; // weight of x2 in the law
    float w2_2_{}; // weight of x2 in the law
    float b_1_{}; // weight of x1 in the law
    float b_2_{}; // weight of x2 in the law
    float u_max_{}; // bound of |u|
};

} // namespace ptc

#endif
