/*
 * Prescribed-time filter ceiling_filter: order n = 3, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang cpp --n 3 --name ceiling --what filter --keep-below=1 --keep-tolerance=1e-3 --keep-poles=-3,-5,-8 --poles="least-energy(weight=1)" --precision f32 --tau=1 --f="1/2" --g="-2" --sample-time=0.01 --delay=1.5
 * Version 0.1.0, design deb0d31bb8ee.
 *
 * Plant: x1' = x2, ..., x3' = f + g u; u held from sample to sample, 1.5 samples late.
 * Goal: x1 <= 1, at and between all samples, under any controller, from every state from
 *       which that is possible and as long as nothing else acts on the plant.
 * Filter: with the control points z = S x of the trajectory, q_0 = z_i and q_j = (Delta +
 *       a_(i+j-1)) q_(j-1), with the rates a_i = (1 - exp(p_i h))/h of the poles -3, -5, -8
 *       1/s. In this cone all states are safe: x_i stays within its bound b as long as all
 *       q_j are within b a_i...a_(i+j-1), j < n+1-i; the last of them, in which u occurs, is
 *       the limit of u.
 * From any other state u is held to the law least-energy(weight=1) of the chain of each x_i
 *       less its bound too, so that x_i is within it at the latest N samples after the last
 *       safe one, as long as neither the limits of u nor those by other bounds are in the way.
 *
 * Parameters:
 *   samples = 100 [samples], fixed: samples N in which a state outside returns
 *   h = 0.01 [s], fixed: sample period
 *   u_max [unit of u]: bound of |u|
 *
 * k counts samples and may wrap; call step at least once within 2^32 - N samples.
 * u is u_nominal where no bound is near (status OK), and else the nearest that they allow
 *       (SATURATED).
 * INFEASIBLE: the state is not safe, or not all bounds can be kept: those of x1 go before
 *       those of x2 and so on, the limits of u before all.
 * |u| <= u_max: u is clipped to it (status SATURATED). This goes before all bounds.
 * Guard full: x and u_nominal are finite, or the call is refused (INPUT).
 * Precision f32 (IEEE 754 binary32). Results are bit for bit the same on every IEEE 754
 *       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
 *
 * Checks of the design (details: ptc-codegen check):
 *   membership: sound: exp is of class M for all its parameters.
 *   growth: not checked: a filter has no law.
 *   sampling: not checked: a filter has no law.
 *   deadline: not checked: a filter has no law.
 *   loop: not checked: `u_max` is left to run time.
 *   envelope: not checked: a filter has no law.
 */
#ifndef CEILING_FILTER_3249C3F4_HPP
#define CEILING_FILTER_3249C3F4_HPP

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
struct CeilingFilterParams {
    float u_max{}; ///< bound of |u| [unit of u], > 0, infinity allowed
};

/// Filter: set by init, changed by arm and by what is not const.
class CeilingFilter {
public:
    using Params = CeilingFilterParams;

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

    /// From tick `k` on a state outside has N samples to return. Estimates and inputs under way are
    /// kept.
    constexpr void arm(std::uint32_t k) noexcept
    {
        start_ = k;
    }

    /// u_nominal as it is, or as near to it as the bounds allow, from tick `k`, which may wrap, and
    /// the state x = (x1, x1', ...). Call it once for each tick.
    /// On a negative status u is 0 and nothing has changed.
    constexpr Control<float> step(std::uint32_t k, const std::array<float, 3>& x, float u_nominal) noexcept
    {
        if (!(finite(x[0]) && finite(x[1]) && finite(x[2]) && finite(u_nominal))) {
            return {0.0f, Status::Input};
        }
        const float x1 = x[0];
        const float x2 = x[1];
        const float x3 = x[2];
        const float s1 = (s1_1_ * x1) + (s1_2_ * x2) + (s1_3_ * x3);
        const float z1 = s1 + (s1_5_ * (u2_ - 0.25f));
        const float s2 = (s2_2_ * x2) + (s2_3_ * x3);
        const float z2 = s2 + (s2_5_ * (u2_ - 0.25f));
        const float s3 = (s3_3_ * x3) + (s3_4_ * (u1_ - 0.25f));
        const float z3 = s3 + (s3_5_ * (u2_ - 0.25f));

        // The limits of u that keep a safe state safe.
        const float q1_1 = z2 + (2.9554467f * z1);
        const float q1_2 = z3 + (7.8325043f * z2) + (14.413883f * z1);
        const float q1_3 = (15.520869f * z3) + (74.63303f * z2) + (110.8192f * z1);
        float low1 = (-55.1596f) - q1_3;
        std::uint32_t since = start_;
        std::uint32_t safe = 1U;
        if ((z1 >= -0.5005f) && (q1_1 >= -1.4792011f) && (q1_2 >= -7.2141485f)) {
            since = k;
        } else {
            safe = 0U;

            // Outside: u is held to the law of return too.
            const float left = static_cast<float>(((k - since) < 98U) ? (98U - (k - since)) : 0U);
            const float t1 = (left < 3.0f) ? 3.0f : left;
            const float s4 = ((((-120000000.0f) * z1) / (t1 + 3.0f)) - (600000.0f * z2)) / (t1 + 2.0f);
            const float law1 = ((s4 - (1200.0f * z3)) / (t1 + 1.0f)) + 0.25f;
            const float weight1 = (((-120000000.0f) / (t1 + 3.0f)) / (t1 + 2.0f)) / (t1 + 1.0f);
            const float low1_back = law1 - ((-0.5f) * weight1);
            if (low1 < low1_back) {
                low1 = low1_back;
            }
        }

        // u within them, the bounds of x1 last.
        float u_now = u_nominal;
        if (u_now < low1) {
            u_now = low1;
        }
        if (u_now > u_max_) {
            u_now = u_max_;
        }
        if (u_now < -u_max_) {
            u_now = -u_max_;
        }
        if (!(finite(u_now) && finite(low1))) {
            return {0.0f, Status::Range};
        }
        u2_ = u1_;
        u1_ = u_now;
        start_ = since;
        if ((safe == 0U) || (u_now < low1 - 0.0554096f)) {
            return {u_now, Status::Infeasible};
        } else if ((u_now < u_nominal) || (u_nominal < u_now)) {
            return {u_now, Status::Saturated};
        } else {
            return {u_now, Status::Ok};
        }
    }

private:
    /// std::isfinite is not constexpr in C++17.
    static constexpr bool finite(float v) noexcept
    {
        return (v >= std::numeric_limits<float>::lowest()) && (v <= (std::numeric_limits<float>::max)());
    }
    /// -1/2, weight of x1 in the law.
    static constexpr float s1_1_{-0.5f};
    /// -1/400, weight of x2 in the law.
    static constexpr float s1_2_{-0.0025f};
    /// 1/480000, weight of x3 in the law.
    static constexpr float s1_3_{2.0833334e-6f};
    /// -1/16000000, weight of u2 in the law.
    static constexpr float s1_5_{-6.25e-8f};
    /// -1/2, weight of x2 in the law.
    static constexpr float s2_2_{-0.5f};
    /// -1/200, weight of x3 in the law.
    static constexpr float s2_3_{-0.005f};
    /// 3/80000, weight of u2 in the law.
    static constexpr float s2_5_{3.75e-5f};
    /// -1/2, weight of x3 in the law.
    static constexpr float s3_3_{-0.5f};
    /// 1/100, weight of u1 in the law.
    static constexpr float s3_4_{0.01f};
    /// 1/200, weight of u2 in the law.
    static constexpr float s3_5_{0.005f};

    std::uint32_t start_{}; // tick of the last safe sample, or of `arm`
    float u1_{}; // input of the last sample
    float u2_{}; // input of 2 samples ago
    float u_max_{}; // bound of |u|
};

} // namespace ptc

#endif
