/*
 * Prescribed-time controller stage49: order n = 2, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang cpp --n 2 --mu "exp(a=1)" --name stage49 --clock samples --A="[[0,1],[-4,-0.2]]" --B="[0,1]" --delay-law=extend --poles-end="least-energy(weight=2)" --end-samples=50 --precision f32 --guard none --tau=1.7 --eps=0 --poles=least-energy --gain-bytes=300 --after zero --sample-time=0.01 --delay=2
 * Version 0.1.0, design 50fbb26d547a.
 *
 * Plant: x' = A x + B u of --A and --B above; u held from sample to sample, 2 samples late.
 * Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
 *       sample period, as long as u is not clipped and nothing else acts on the plant.
 * Law: u = -K_M x with M samples to go, of all inputs that end at rest those with the least
 *       sum of u^2. From 50 samples to go on it is that of u^2/(M ... (M+1)). The gains are a
 *       table of 224 bytes: exact below 8 samples to go, and before it those of a grid of 14
 *       nodes, interpolated in a line. The gains of 4 samples to go stay: they are deadbeat.
 *
 * Parameters:
 *   samples = 170 [samples], fixed: samples N from the start to rest
 *   h = 0.01 [s], fixed: sample period
 *   eps = 0 [s], fixed: time-to-go at which the gains are held
 *   u_max [unit of u]: bound of |u|
 *   a = 1 [1/s], fixed: rate of stretched time
 *
 * k counts samples and may wrap; arm again within 2^32 - N samples.
 * From sample N on u = 0 (status AFTER).
 * |u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
 *       lasts.
 * Guard none: finite measurements are the responsibility of the caller.
 * Precision f32 (IEEE 754 binary32). Results are bit for bit the same on every IEEE 754
 *       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
 *
 * Checks of the design (details: ptc-codegen check):
 *   membership: sound: exp is of class M for all its parameters.
 *   growth: sound: at rest at sample 170 from any state, and |u| is bounded.
 *   sampling: not checked: the law is exact in samples, at any period.
 *   deadline: not checked: the law is exact in samples, at any period.
 *   loop: not checked: `x0_max` is not given.
 *   envelope: not checked: it does not examine a clock in samples.
 */
#ifndef STAGE49_37E58668_HPP
#define STAGE49_37E58668_HPP

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
struct Stage49Params {
    float u_max{}; ///< bound of |u| [unit of u], > 0, infinity allowed
};

/// Controller: set by init, changed by arm and by what is not const.
class Stage49 {
public:
    using Params = Stage49Params;

    /// Takes the parameters and arms at tick 0. Ok, or Param with nothing changed.
    [[nodiscard]] constexpr Status init(const Params& params) noexcept
    {
        if (!(params.u_max > 0.0f)) {
            return Status::Param;
        }
        const float u_max = params.u_max;
        start_ = 0U;
        u1_ = 0.0f;
        u2_ = 0.0f;
        u_max_ = u_max;
        return Status::Ok;
    }

    /// Starts again: the deadline is N samples after tick `k`. Estimates and inputs under way are
    /// kept.
    constexpr void arm(std::uint32_t k) noexcept
    {
        start_ = k;
    }

    /// u from tick `k`, which may wrap, and the state x. Call it once for each tick.
    /// On a negative status u is 0 and nothing has changed.
    constexpr Control<float> step(std::uint32_t k, const std::array<float, 2>& x) noexcept
    {
        const std::uint32_t elapsed = k - start_;
        const float x1 = x[0];
        const float x2 = x[1];
        const std::uint32_t left = (elapsed < samples_) ? (samples_ - elapsed) : 0U;
        std::uint32_t to_go{};
        if (left > 4U) {
            to_go = left;
        } else {
            to_go = 4U;
        }

        // Its place between the nodes of the table.
        std::uint32_t row{};
        float part{};
        if (to_go < 8U) {
            row = to_go - 4U;
            part = 0.0f;
        } else if (to_go < 16U) {
            row = (to_go / 4U) + 2U;
            part = (0.25f * static_cast<float>(to_go)) - static_cast<float>(to_go / 4U);
        } else if (to_go < 32U) {
            row = (to_go / 8U) + 4U;
            part = (0.125f * static_cast<float>(to_go)) - static_cast<float>(to_go / 8U);
        } else if (to_go < 64U) {
            row = (to_go / 16U) + 6U;
            part = (0.0625f * static_cast<float>(to_go)) - static_cast<float>(to_go / 16U);
        } else if (to_go < 128U) {
            row = (to_go / 32U) + 8U;
            part = (0.03125f * static_cast<float>(to_go)) - static_cast<float>(to_go / 32U);
        } else {
            row = (to_go / 64U) + 10U;
            part = (0.015625f * static_cast<float>(to_go)) - static_cast<float>(to_go / 64U);
        }

        // The law of least energy.
        const std::uint32_t above = row + 1U;
        float v{};
        const float s1 = part * (gains_[above][0] - gains_[row][0]);
        const float s2 = part * (gains_[above][1] - gains_[row][1]);
        const float s3 = (gains_[row][0] + s1) * x1;
        const float s4 = part * (gains_[above][2] - gains_[row][2]);
        const float s5 = (gains_[row][2] + s4) * u1_;
        const float s6 = part * (gains_[above][3] - gains_[row][3]);
        const float s7 = s3 + ((gains_[row][1] + s2) * x2) + s5;
        v = s7 + ((gains_[row][3] + s6) * u2_);
        if (!finite(v)) {
            return {0.0f, Status::Range};
        }
        float u_now{};
        if (elapsed < samples_) {
            if (v > u_max_) {
                u_now = u_max_;
            } else if (v < -u_max_) {
                u_now = -u_max_;
            } else {
                u_now = v;
            }
        } else {
            u_now = 0.0f;
        }
        u2_ = u1_;
        u1_ = u_now;
        if (elapsed < samples_) {
            if ((v > u_max_) || (v < -u_max_)) {
                return {u_now, Status::Saturated};
            } else {
                return {u_now, Status::Ok};
            }
        } else {
            return {u_now, Status::After};
        }
    }

private:
    /// std::isfinite is not constexpr in C++17.
    static constexpr bool finite(float v) noexcept
    {
        return (v >= std::numeric_limits<float>::lowest()) && (v <= (std::numeric_limits<float>::max)());
    }
    /// Samples from the start to rest.
    static constexpr std::uint32_t samples_{170U};

    /// Gains of least energy of each state, a row for the samples to go of a node.
    static constexpr std::array<std::array<float, 4>, 14> gains_{{
        {{-9986.377f, -348.87903f, -1.9976025f, -2.9924133f}},
        {{-5777.1006f, -233.30489f, -1.4711981f, -2.0461898f}},
        {{-3881.3403f, -176.5856f, -1.1873256f, -1.5733153f}},
        {{-2833.6228f, -142.71356f, -1.005122f, -1.2866975f}},
        {{-2181.0964f, -120.080894f, -0.8762361f, -1.0928065f}},
        {{-1018.34033f, -74.13646f, -0.5902821f, -0.6911077f}},
        {{-599.1994f, -53.811737f, -0.4494777f, -0.50864094f}},
        {{-281.46225f, -34.714703f, -0.30574974f, -0.33338922f}},
        {{-162.40263f, -25.523401f, -0.23148729f, -0.2473471f}},
        {{-72.591675f, -16.511925f, -0.15463428f, -0.16164158f}},
        {{-10.503921f, -5.7482643f, -0.0560507f, -0.0570108f}},
        {{-2.4759388f, -3.1387978f, -0.031095704f, -0.03129342f}},
        {{-0.2871313f, -1.8002806f, -0.018005349f, -0.018005254f}},
        {{-0.12725501f, -0.7570639f, -0.0075707315f, -0.007571343f}},
    }};

    std::uint32_t start_{}; // tick at which it was armed
    float u1_{}; // input of the last sample
    float u2_{}; // input of 2 samples ago
    float u_max_{}; // bound of |u|
};

} // namespace ptc

#endif
