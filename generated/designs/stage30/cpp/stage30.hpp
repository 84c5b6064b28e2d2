/*
 * Prescribed-time controller stage30: order n = 3, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang cpp --n 3 --axes 2 --mu exp --name stage30 --clock samples --precision f32 --eps=0.02 --g="3"
 * Version 0.1.0, design 466927f5ebf7.
 *
 * Plant: x1' = x2, ..., x3' = g u; u held from sample to sample.
 * Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
 *       sample period, as long as u is not clipped and nothing else acts on the plant.
 * Law: with M samples to go and z = S x, u h^3 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-2));
 *       the rows are those of Theorem 1 for the mapping exp. Close to the end deadbeat takes
 *       over.
 * Axes: 2, each a chain of its own with this deadline and mapping. step computes what depends
 *       on time once.
 *
 * Parameters:
 *   samples [samples]: samples N from the start to rest
 *   h [s]: sample period
 *   eps = 0.02 [s], fixed: time-to-go at which the gains are held
 *   u_max [unit of u]: bound of |u|
 *   a [1/s]: rate of stretched time
 *   k_1 [1/s^3]: gains k_i of pi0 = -sum k_i xi_i
 *   k_2 [1/s^2]: gains k_i of pi0 = -sum k_i xi_i
 *   k_3 [1/s]: gains k_i of pi0 = -sum k_i xi_i
 *   deadbeat [samples]: samples to go at which deadbeat takes over, 0 for a safe default
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
 *   envelope: not checked: it does not examine a clock in samples.
 */
#ifndef STAGE30_F5CC1323_HPP
#define STAGE30_F5CC1323_HPP

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
struct Stage30Params {
    std::uint32_t samples{}; ///< samples N from the start to rest [samples], at least 3
    float h{}; ///< sample period [s], from 1e-18 to 1e18
    float u_max{}; ///< bound of |u| [unit of u], > 0, infinity allowed
    float a{}; ///< rate of stretched time [1/s], from 1e-18 to 1e18
    std::array<float, 3> k{}; ///< gains k_i of pi0 = -sum k_i xi_i [1/s^3], finite
    float deadbeat{}; ///< samples to go at which deadbeat takes over, 0 for a safe default [samples], finite
};

/// Controller: set by init, changed by arm and by what is not const.
class Stage30 {
public:
    using Params = Stage30Params;

    /// Takes the parameters and arms at tick 0. Ok, or Param with nothing changed.
    [[nodiscard]] constexpr Status init(const Params& params) noexcept
    {
        if (!((params.samples > 2U)
                && (1e-18f <= params.h)
                && (params.h <= 1e18f)
                && (params.u_max > 0.0f)
                && (1e-18f <= params.a)
                && (params.a <= 1e18f)
                && finite(params.k[0])
                && finite(params.k[1])
                && finite(params.k[2])
                && finite(params.deadbeat)
                && (params.deadbeat >= 0.0f))) {
            return Status::Param;
        }
        const std::uint32_t samples = params.samples;
        const float hold = 0.02f / params.h;
        const float s1 = -(params.k[0] / (params.a * params.a * params.a));
        const float w1_1_1 = 0.33333334f * s1 * (1.0f / (params.h * params.h * params.h));
        const float s2 = -(params.k[0] / (params.a * params.a * params.a));
        const float w1_2_1 = (-0.33333334f) * s2 * (1.0f / (params.h * params.h));
        const float s3 = -(params.k[0] / (params.a * params.a * params.a));
        const float w1_3_1 = 0.11111111f * s3 * (1.0f / params.h);
        const float s4 = (-1.0f) - (params.k[1] / (params.a * params.a));
        const float s5 = 0.33333334f * (s4 + (params.k[2] / params.a));
        const float w2_2_1 = s5 * (1.0f / (params.h * params.h));
        const float s6 = (-1.0f) - (params.k[1] / (params.a * params.a));
        const float s7 = (-0.16666667f) * (s6 + (params.k[2] / params.a));
        const float w2_3_1 = s7 * (1.0f / params.h);
        const float s8 = 0.33333334f * (3.0f - (params.k[2] / params.a));
        const float w3_3_1 = s8 * (1.0f / params.h);
        const float b_1_1 = (-0.33333334f) * (1.0f / (params.h * params.h * params.h));
        const float b_2_1 = (-0.6666667f) * (1.0f / (params.h * params.h));
        const float b_3_1 = (-0.6111111f) * (1.0f / params.h);
        const float u_max = params.u_max;
        if (!(finite(hold)
                && finite(w1_1_1)
                && finite(w1_2_1)
                && finite(w1_3_1)
                && finite(w2_2_1)
                && finite(w2_3_1)
                && finite(w3_3_1)
                && finite(b_1_1)
                && finite(b_2_1)
                && finite(b_3_1)
                && (params.h * params.h * params.h >= 1e-30f)
                && (1.0f / (params.h * params.h * params.h) >= 1e-30f))) {
            return Status::Param;
        }
        start_ = 0U;
        samples_ = samples;
        hold_ = hold;
        w1_1_1_ = w1_1_1;
        w1_2_1_ = w1_2_1;
        w1_3_1_ = w1_3_1;
        w2_2_1_ = w2_2_1;
        w2_3_1_ = w2_3_1;
        w3_3_1_ = w3_3_1;
        b_1_1_ = b_1_1;
        b_2_1_ = b_2_1;
        b_3_1_ = b_3_1;
        u_max_ = u_max;
        return Status::Ok;
    }

    /// Starts again: the deadline is N samples after tick `k`.
    constexpr void arm(std::uint32_t k) noexcept
    {
        start_ = k;
    }

    /// u of each axis from tick `k`, which may wrap, and the state x = (x1, x1', ...) of each.
    /// Where one of them is not finite, every u is 0; else the status is SATURATED where one was
    /// clipped.
    constexpr Axes<float, 2> step(std::uint32_t k, const std::array<std::array<float, 3>, 2>& x) const noexcept
    {
        Axes<float, 2> all{};
        if (!(finite(x[0][0])
                && finite(x[0][1])
                && finite(x[0][2])
                && finite(x[1][0])
                && finite(x[1][1])
                && finite(x[1][2]))) {
            return {{}, {{Status::Input, Status::Input}}, Status::Input};
        }
        const std::uint32_t elapsed = k - start_;
        const float x1_1 = x[0][0];
        const float x2_1 = x[0][1];
        const float x3_1 = x[0][2];
        const float x1_2 = x[1][0];
        const float x2_2 = x[1][1];
        const float x3_2 = x[1][2];
        const std::uint32_t left = (elapsed < samples_) ? (samples_ - elapsed) : 0U;
        const float m0_1 = (static_cast<float>(left) < hold_) ? hold_ : static_cast<float>(left);
        float law_1{};
        const float m0_2 = (static_cast<float>(left) < hold_) ? hold_ : static_cast<float>(left);
        float law_2{};
        if (m0_1 > deadbeat_1_) {
            // The exact law in samples.
            const float s1 = (w1_1_1_ * x1_1) + (w1_2_1_ * x2_1);
            const float z1_1 = s1 + (w1_3_1_ * x3_1);
            const float z2_1 = (w2_2_1_ * x2_1) + (w2_3_1_ * x3_1);
            const float z3_1 = w3_3_1_ * x3_1;
            law_1 = ((((z1_1 / m0_1) + z2_1) / (m0_1 - 1.0f)) + z3_1) / (m0_1 - 2.0f);
        } else {
            // Deadbeat.
            const float s2 = (b_1_1_ * x1_1) + (b_2_1_ * x2_1);
            law_1 = s2 + (b_3_1_ * x3_1);
        }
        if (m0_2 > deadbeat_2_) {
            // The exact law in samples.
            const float s3 = (w1_1_1_ * x1_2) + (w1_2_1_ * x2_2);
            const float z1_2 = s3 + (w1_3_1_ * x3_2);
            const float z2_2 = (w2_2_1_ * x2_2) + (w2_3_1_ * x3_2);
            const float z3_2 = w3_3_1_ * x3_2;
            law_2 = ((((z1_2 / m0_2) + z2_2) / (m0_2 - 1.0f)) + z3_2) / (m0_2 - 2.0f);
        } else {
            // Deadbeat.
            const float s4 = (b_1_1_ * x1_2) + (b_2_1_ * x2_2);
            law_2 = s4 + (b_3_1_ * x3_2);
        }
        if (static_cast<float>(left) > hold_) {
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
            } else if (law_1 < -u_max_) {
                all.u[0] = -u_max_;
                all.axes[0] = Status::Saturated;
                all.status = Status::Saturated;
            }
            if (law_2 > u_max_) {
                all.u[1] = u_max_;
                all.axes[1] = Status::Saturated;
                all.status = Status::Saturated;
            } else if (law_2 < -u_max_) {
                all.u[1] = -u_max_;
                all.axes[1] = Status::Saturated;
                all.status = Status::Saturated;
            }
        } else {
            all.u[0] = 0.0f;
            if (finite(law_1)) {
                all.axes[0] = all.status;
            } else {
                all.axes[0] = Status::Range;
            }
            all.u[1] = 0.0f;
            if (finite(law_2)) {
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
    /// 5/2, samples to go at which deadbeat takes over.
    static constexpr float deadbeat_1_{2.5f};
    /// 5/2, samples to go at which deadbeat takes over.
    static constexpr float deadbeat_2_{2.5f};

    std::uint32_t start_{}; // tick at which it was armed
    std::uint32_t samples_{}; // samples from the start to rest
    float hold_{}; // samples to go at which the gains are held
    float w1_1_1_{}; // weight of x1 in the law
    float w1_2_1_{}; // weight of x2 in the law
    float w1_3_1_{}; // weight of x3 in the law
    float w2_2_1_{}; // weight of x2 in the law
    float w2_3_1_{}; // weight of x3 in the law
    float w3_3_1_{}; // weight of x3 in the law
    float b_1_1_{}; // weight of x1 in the law
    float b_2_1_{}; // weight of x2 in the law
    float b_3_1_{}; // weight of x3 in the law
    float u_max_{}; // bound of |u|
};

} // namespace ptc

#endif
