/*
 * Prescribed-time controller stage13: order n = 2, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang cpp --n 2 --mu "exp(a=1)" --name stage13 --clock samples --A="[[0,1],[49,-0.1]]" --B="[0.1,-1.3]" --C="[[1,0.5],[0.2,-1]]" --precision f32 --eps=0 --after zero --sample-time=0.01
 * Version 0.1.0, design 66f29bb0af19.
 *
 * Plant: x' = A x + B u of --A and --B above; u held from sample to sample, y = C x.
 * Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
 *       sample period, as long as u is not clipped and nothing else acts on the plant.
 * Law: with M samples to go and z = S x, the differences of a flat output, u = sum of row_j
 *       z_j/((M-j+1)...(M-1)) less the drift of z; the rows are those of Theorem 1 for the
 *       mapping exp. Close to the end deadbeat takes over.
 *
 * Parameters:
 *   samples [samples]: samples N from the start to rest
 *   h = 0.01 [s], fixed: sample period
 *   eps = 0 [s], fixed: time-to-go at which the gains are held
 *   u_max [unit of u]: bound of |u|
 *   a = 1 [1/s], fixed: rate of stretched time
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
#ifndef STAGE13_411B6173_HPP
#define STAGE13_411B6173_HPP

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
struct Stage13Params {
    std::uint32_t samples{}; ///< samples N from the start to rest [samples], at least 2
    float u_max{}; ///< bound of |u| [unit of u], > 0, infinity allowed
    std::array<float, 2> k{}; ///< gains k_i of pi0 = -sum k_i xi_i [1/s^2], finite
    float deadbeat{}; ///< samples to go at which deadbeat takes over, 0 for a safe default [samples], finite
};

/// Controller: set by init, changed by arm and by what is not const.
class Stage13 {
public:
    using Params = Stage13Params;

    /// Takes the parameters and arms at tick 0. Ok, or Param with nothing changed.
    [[nodiscard]] constexpr Status init(const Params& params) noexcept
    {
        if (!((params.samples > 1U)
                && (params.u_max > 0.0f)
                && finite(params.k[0])
                && finite(params.k[1])
                && finite(params.deadbeat)
                && (params.deadbeat >= 0.0f))) {
            return Status::Param;
        }
        const std::uint32_t samples = params.samples;
        const float s1 = (params.k[1] - 1.0f) + 2.0f;
        const float s2 = (s1 < 4.0f) ? 4.0f : s1;
        const float deadbeat = (params.deadbeat > 0.0f) ? params.deadbeat : s2;
        const float w1_1 = (-10746.611f) * (-params.k[0]);
        const float w1_2 = (-788.20667f) * (-params.k[0]);
        const float w2_1 = (-412.67474f) * (1.0f - params.k[1]);
        const float w2_2 = (-108.64294f) * (1.0f - params.k[1]);
        const float u_max = params.u_max;
        if (!(finite(deadbeat) && finite(w1_1) && finite(w1_2) && finite(w2_1) && finite(w2_2))) {
            return Status::Param;
        }
        start_ = 0U;
        samples_ = samples;
        deadbeat_ = deadbeat;
        w1_1_ = w1_1;
        w1_2_ = w1_2;
        w2_1_ = w2_1;
        w2_2_ = w2_2;
        u_max_ = u_max;
        return Status::Ok;
    }

    /// Starts again: the deadline is N samples after tick `k`.
    constexpr void arm(std::uint32_t k) noexcept
    {
        start_ = k;
    }

    /// u from tick `k`, which may wrap, and what is measured, y = C x.
    /// On a negative status u is 0 and nothing has changed.
    constexpr Control<float> step(std::uint32_t k, const std::array<float, 2>& y) const noexcept
    {
        if (!(finite(y[0]) && finite(y[1]))) {
            return {0.0f, Status::Input};
        }
        const std::uint32_t elapsed = k - start_;
        const float x1 = (0.90909094f * y[0]) + (0.45454547f * y[1]);
        const float x2 = (0.18181819f * y[0]) - (0.90909094f * y[1]);
        const std::uint32_t left = (elapsed < samples_) ? (samples_ - elapsed) : 0U;
        const float m0 = static_cast<float>(left);
        float v{};
        if (m0 > deadbeat_) {
            // The exact law in samples.
            const float z1 = (w1_1_ * x1) + (w1_2_ * x2);
            const float z2 = (w2_1_ * x1) + (w2_2_ * x2);
            const float s1 = (c_1_ * x1) + (c_2_ * x2);
            v = ((z1 + (z2 * m0)) / (m0 * (m0 - 1.0f))) + s1;
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
    /// Weight of x1 in the law.
    static constexpr float c_1_{54.263023f};
    /// Weight of x2 in the law.
    static constexpr float c_2_{4.2855716f};
    /// Weight of x1 in the law.
    static constexpr float b_1_{11626.225f};
    /// Weight of x2 in the law.
    static constexpr float b_2_{1009.77814f};

    std::uint32_t start_{}; // tick at which it was armed
    std::uint32_t samples_{}; // samples from the start to rest
    float deadbeat_{}; // samples to go at which deadbeat takes over
    float w1_1_{}; // weight of x1 in the law
    float w1_2_{}; // weight of x2 in the law
    float w2_1_{}; // weight of x1 in the law
    float w2_2_{}; // weight of x2 in the law
    float u_max_{}; // bound of |u|
};

} // namespace ptc

#endif
