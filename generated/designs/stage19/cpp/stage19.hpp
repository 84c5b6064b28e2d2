/*
 * Prescribed-time controller stage19: order n = 3, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang cpp --n 3 --mu "exp(a=1)" --name stage19 --clock samples --precision f32 --guard none --eps=0 --u-max=inf --states="q, w, i" --input=V --output="q" --dynamics="w, i/(1 + q^2) - w/4, 50*(V - 2*i - w)" --after zero
 * Version 0.1.0, design 837b86fb35a8.
 *
 * Plant: the input V: q' = w, w' = i/(1 + q^2) - w/4, i' = 50*(V - 2*i - w), output q; u held
 *       from sample to sample.
 * Goal: the output and its derivatives up to order 2, x, are 0 at sample N after the start,
 *       from any state, as long as u is not clipped and the plant is the model. f and g are
 *       known at the samples alone, which leaves an error of order h^(5-i) in x_i.
 * Law: with M samples to go and z = S x, w h^3 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-2)),
 *       and u = (w - f)/g; the rows are those of Theorem 1 for the mapping exp. Close to the
 *       end deadbeat takes over.
 *
 * Parameters:
 *   samples [samples]: samples N from the start to rest
 *   h [s]: sample period
 *   eps = 0 [s], fixed: time-to-go at which the gains are held
 *   u_max = inf [unit of u], fixed: bound of |u|
 *   a = 1 [1/s], fixed: rate of stretched time
 *   k_1 [1/s^3]: gains k_i of pi0 = -sum k_i xi_i
 *   k_2 [1/s^2]: gains k_i of pi0 = -sum k_i xi_i
 *   k_3 [1/s]: gains k_i of pi0 = -sum k_i xi_i
 *   deadbeat [samples]: samples to go at which deadbeat takes over, 0 for a safe default
 *
 * k counts samples and may wrap; arm again within 2^32 - N samples.
 * From sample N on u = 0 (status AFTER).
 * u is not clipped.
 * Guard none: finite measurements are the responsibility of the caller.
 * Precision f32 (IEEE 754 binary32). Results are bit for bit the same on every IEEE 754
 *       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
 *
 * Checks of the design (details: ptc-codegen check):
 *   membership: sound: exp is of class M for all its parameters.
 *   growth: sound: at rest at sample N from any state, but for what f + g u does between
 *       samples, whatever the poles, and |u| is bounded.
 *   sampling: not checked: `loop` bounds what the period leaves of a model that is not linear.
 *   deadline: not checked: `loop` bounds what the period leaves of a model that is not linear.
 *   loop: not checked: `samples` is left to run time.
 *   envelope: not checked: it does not examine a clock in samples.
 *   zeros: sound: none: the relative degree is 3, the number of states.
 */
#ifndef STAGE19_5BDA2CA0_HPP
#define STAGE19_5BDA2CA0_HPP

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
struct Stage19Params {
    std::uint32_t samples{}; ///< samples N from the start to rest [samples], at least 3
    float h{}; ///< sample period [s], from 1e-18 to 1e18
    std::array<float, 3> k{}; ///< gains k_i of pi0 = -sum k_i xi_i [1/s^3], finite
    float deadbeat{}; ///< samples to go at which deadbeat takes over, 0 for a safe default [samples], finite
};

/// Controller: set by init, changed by arm and by what is not const.
class Stage19 {
public:
    using Params = Stage19Params;

    /// Takes the parameters and arms at tick 0. Ok, or Param with nothing changed.
    [[nodiscard]] constexpr Status init(const Params& params) noexcept
    {
        if (!((params.samples > 2U)
                && (1e-18f <= params.h)
                && (params.h <= 1e18f)
                && finite(params.k[0])
                && finite(params.k[1])
                && finite(params.k[2])
                && finite(params.deadbeat)
                && (params.deadbeat >= 0.0f))) {
            return Status::Param;
        }
        const std::uint32_t samples = params.samples;
        const float s1 = (params.k[2] - 4.0f) + 3.0f;
        const float s2 = (s1 < 6.0f) ? 6.0f : s1;
        const float deadbeat = (params.deadbeat > 0.0f) ? params.deadbeat : s2;
        const float w1_1 = (-params.k[0]) * (1.0f / (params.h * params.h * params.h));
        const float w1_2 = params.k[0] * (1.0f / (params.h * params.h));
        const float w1_3 = 0.33333334f * (-params.k[0]) * (1.0f / params.h);
        const float s3 = ((-1.0f) - params.k[1]) + params.k[2];
        const float w2_2 = s3 * (1.0f / (params.h * params.h));
        const float s4 = (-0.5f) * (((-1.0f) - params.k[1]) + params.k[2]);
        const float w2_3 = s4 * (1.0f / params.h);
        const float w3_3 = (3.0f - params.k[2]) * (1.0f / params.h);
        const float b_1 = -(1.0f / (params.h * params.h * params.h));
        const float b_2 = (-2.0f) * (1.0f / (params.h * params.h));
        const float b_3 = (-1.8333334f) * (1.0f / params.h);
        if (!(finite(deadbeat)
                && finite(w1_1)
                && finite(w1_2)
                && finite(w1_3)
                && finite(w2_2)
                && finite(w2_3)
                && finite(w3_3)
                && finite(b_1)
                && finite(b_2)
                && finite(b_3)
                && (params.h * params.h * params.h >= 1e-30f)
                && (1.0f / (params.h * params.h * params.h) >= 1e-30f))) {
            return Status::Param;
        }
        start_ = 0U;
        samples_ = samples;
        deadbeat_ = deadbeat;
        w1_1_ = w1_1;
        w1_2_ = w1_2;
        w1_3_ = w1_3;
        w2_2_ = w2_2;
        w2_3_ = w2_3;
        w3_3_ = w3_3;
        b_1_ = b_1;
        b_2_ = b_2;
        b_3_ = b_3;
        return Status::Ok;
    }

    /// Starts again: the deadline is N samples after tick `k`.
    constexpr void arm(std::uint32_t k) noexcept
    {
        start_ = k;
    }

    /// u from tick `k`, which may wrap, and the state x of the model.
    /// On a negative status u is 0 and nothing has changed.
    constexpr Control<float> step(std::uint32_t k, const std::array<float, 3>& x) const noexcept
    {
        const std::uint32_t elapsed = k - start_;

        // The chain of the output.
        const float x1 = x[0];
        const float x2 = x[1];
        const float v1 = 1.0f + (x1 * x1);
        const float x3 = (x[2] / v1) - (x2 * 0.25f);
        const std::uint32_t left = (elapsed < samples_) ? (samples_ - elapsed) : 0U;
        const float m0 = static_cast<float>(left);
        float w{};
        if (m0 > deadbeat_) {
            // The exact law in samples.
            const float z1 = (w1_1_ * x1) + (w1_2_ * x2) + (w1_3_ * x3);
            const float z2 = (w2_2_ * x2) + (w2_3_ * x3);
            const float z3 = w3_3_ * x3;
            w = ((((z1 / m0) + z2) / (m0 - 1.0f)) + z3) / (m0 - 2.0f);
        } else {
            // Deadbeat.
            w = (b_1_ * x1) + (b_2_ * x2) + (b_3_ * x3);
        }
        const float s1 = ((-50.0f) * (x2 + (2.0f * x[2])) * v1) - (x[2] * (2.0f * x1 * x2));
        const float v = (w - ((s1 / (v1 * v1)) - (x3 * 0.25f))) * v1 * 0.02f;
        if (finite(v)) {
            if (elapsed < samples_) {
                return {v, Status::Ok};
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
    float w1_3_{}; // weight of x3 in the law
    float w2_2_{}; // weight of x2 in the law
    float w2_3_{}; // weight of x3 in the law
    float w3_3_{}; // weight of x3 in the law
    float b_1_{}; // weight of x1 in the law
    float b_2_{}; // weight of x2 in the law
    float b_3_{}; // weight of x3 in the law
};

} // namespace ptc

#endif
