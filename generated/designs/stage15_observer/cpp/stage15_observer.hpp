/*
 * Prescribed-time observer stage15_observer: order n = 2, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang cpp --n 2 --mu "exp(a=1.5)" --name stage15 --what observer --clock samples --measured=x1 --disturbance constant --observer-poles=-4,-5,-6 --observer-samples=9 --observer-eps=0.05 --precision f32 --f="-981/100" --g="1/2" --delay=1.5
 * Version 0.1.0, design fa54d2fef2e7.
 *
 * Plant: x1' = x2, x2' = f + g (u + d), d constant and unknown; u held from sample to sample,
 *       1.5 samples late.
 * Goal: the estimates of the state and of d are as near as the hold at observer_eps leaves
 *       them from sample 9 after the start on, from any state and at any sample period, as
 *       long as the measurement is exact, u is what was applied and nothing else acts on the
 *       plant.
 * Observer: xhat(k) = p + L (y(k) - p1), p = Phi xhat(k - 1) + Gamma u with the chain
 *       sampled, Phi and Gamma: the estimates of tick k hold y up to tick k. The gains follow
 *       by duality from the rows that Theorem 1 gives for the mapping exp. Close to the end
 *       deadbeat takes over.
 *
 * Parameters:
 *   h [s]: sample period
 *   a = 1.5 [1/s], fixed: rate of stretched time
 *
 * k counts samples and may wrap; arm again within 2^32 - 9 samples.
 * u is the input of tick k - 1 as it was applied, after clipping: it acts from 1.5 samples
 *       after tick k - 1 on for one sample, and the observer keeps those under way.
 * From sample 9 on the status is HOLD; with noise or sensor_step given, or observer_eps, the
 *       gains of the observer are then held below deadbeat.
 * Guard full: what is measured and u are finite, or the call is refused (INPUT).
 * Precision f32 (IEEE 754 binary32). Results are bit for bit the same on every IEEE 754
 *       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
 *
 * Checks of the design (details: ptc-codegen check):
 *   membership: sound: exp is of class M for all its parameters.
 *   growth: not checked: an observer alone has no law.
 *   sampling: not checked: an observer alone has no law.
 *   deadline: not checked: an observer alone has no law.
 *   loop: not checked: an observer alone has no law.
 *   envelope: not checked: an observer alone has no law.
 */
#ifndef STAGE15_OBSERVER_7D9051D3_HPP
#define STAGE15_OBSERVER_7D9051D3_HPP

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
struct Stage15ObserverParams {
    float h{}; ///< sample period [s], from 1e-18 to 1e18
};

/// Observer: set by init, changed by arm and by what is not const.
class Stage15Observer {
public:
    using Params = Stage15ObserverParams;

    /// Takes the parameters and arms at tick 0. Ok, or Param with nothing changed.
    [[nodiscard]] constexpr Status init(const Params& params) noexcept
    {
        if (!((1e-18f <= params.h) && (params.h <= 1e18f))) {
            return Status::Param;
        }
        const float phi1_2 = params.h;
        const float phi1_3 = 0.25f * (params.h * params.h);
        const float gamma1 = 0.1875f * (params.h * params.h);
        const float late_gamma1 = 0.0625f * (params.h * params.h);
        const float phi2_3 = 0.5f * params.h;
        const float gamma2 = 0.25f * params.h;
        const float hold_o = 0.05f / params.h;
        const float q2_1 = (-22.444445f) * (1.0f / params.h);
        const float q2_2 = 9.888889f * (1.0f / params.h);
        const float q3_1 = 3.5555556f * (1.0f / (params.h * params.h));
        if (!(finite(phi1_3)
                && finite(gamma1)
                && finite(late_gamma1)
                && finite(phi2_3)
                && finite(gamma2)
                && finite(hold_o)
                && finite(q2_1)
                && finite(q2_2)
                && finite(q3_1)
                && (params.h * params.h >= 1e-30f)
                && (1.0f / (params.h * params.h) >= 1e-30f)
                && (hold_o >= 3.0f))) {
            return Status::Param;
        }
        start_ = 0U;
        u1_ = 0.0f;
        u2_ = 0.0f;
        seen_ = 0U;
        x1_hat_ = 0.0f;
        x2_hat_ = 0.0f;
        d_hat_ = 0.0f;
        phi1_2_ = phi1_2;
        phi1_3_ = phi1_3;
        gamma1_ = gamma1;
        late_gamma1_ = late_gamma1;
        phi2_3_ = phi2_3;
        gamma2_ = gamma2;
        hold_o_ = hold_o;
        q2_1_ = q2_1;
        q2_2_ = q2_2;
        q3_1_ = q3_1;
        return Status::Ok;
    }

    /// Starts a round of 9 samples at tick `k`. Estimates and inputs under way are kept. Estimates
    /// too large to compute with begin anew.
    constexpr void arm(std::uint32_t k) noexcept
    {
        start_ = k;
        const float size = absolute(x1_hat_) + absolute(x2_hat_) + absolute(d_hat_);
        if (!(size <= 1e18f)) {
            seen_ = 0U;
            x1_hat_ = 0.0f;
            x2_hat_ = 0.0f;
            d_hat_ = 0.0f;
        }
    }

    /// The estimates of tick `k`, which may wrap, from what is measured, y = (x1, ...) at that tick
    /// and u, the input of tick `k` - 1 as it was applied, 0 where there was none. Call it once for
    /// each tick, before the law, which takes its estimates. Status Hold from sample 9 on: the
    /// round is over.
    /// On a negative status nothing has changed.
    [[nodiscard]] constexpr Status update(std::uint32_t k, const std::array<float, 1>& y, float u) noexcept
    {
        if (!(finite(y[0]) && finite(u))) {
            return Status::Input;
        }
        const std::uint32_t elapsed = k - start_;

        // Predict.
        const float s1 = x1_hat_ + (phi1_2_ * x2_hat_);
        const float s2 = late_gamma1_ * (u1_ - 19.62f);
        const float s3 = (gamma1_ * (u2_ - 19.62f)) + s2;
        const float p1 = s1 + (phi1_3_ * d_hat_) + s3;
        const float s4 = gamma2_ * (u2_ - 19.62f);
        const float s5 = x2_hat_ + (phi2_3_ * d_hat_);
        const float p2 = s5 + (s4 + (gamma2_ * (u1_ - 19.62f)));
        const float p3 = d_hat_;

        // Correct by what is measured.
        float base{};
        float miss{};
        if (seen_ == 0U) {
            base = y[0];
            miss = 0.0f;
        } else {
            base = p1;
            miss = y[0] - p1;
        }
        const std::uint32_t left_o = (elapsed < observer_samples_) ? (observer_samples_ - elapsed) : 0U;
        const float o0 = (static_cast<float>(left_o) < hold_o_) ? hold_o_ : static_cast<float>(left_o);
        float l1{};
        float l2{};
        float l3{};
        const float o0f2 = o0 * (o0 - 1.0f);
        const float r0 = 1.0f / (o0f2 * (o0 - 2.0f));
        l1 = (q1_1_ + (q1_2_ * o0) + (q1_3_ * o0f2)) * r0;
        l2 = (q2_1_ + (q2_2_ * o0)) * r0;
        l3 = q3_1_ * r0;
        const float x1 = base + (l1 * miss);
        const float x2 = p2 + (l2 * miss);
        const float d = p3 + (l3 * miss);
        if (!(finite(x1) && finite(x2) && finite(d))) {
            return Status::Range;
        }
        u2_ = u1_;
        u1_ = u;
        x1_hat_ = x1;
        x2_hat_ = x2;
        d_hat_ = d;
        seen_ = 1U;
        if (left_o == 0U) {
            return Status::Hold;
        } else {
            return Status::Ok;
        }
    }

    /// The estimate of the state at the last sample.
    [[nodiscard]] constexpr std::array<float, 2> estimate() const noexcept
    {
        return {{x1_hat_, x2_hat_}};
    }

    /// The estimate of the constant that is added to u.
    [[nodiscard]] constexpr float disturbance() const noexcept
    {
        return d_hat_;
    }

private:
    /// std::isfinite is not constexpr in C++17.
    static constexpr bool finite(float v) noexcept
    {
        return (v >= std::numeric_limits<float>::lowest()) && (v <= (std::numeric_limits<float>::max)());
    }

    static constexpr float absolute(float v) noexcept
    {
        return (v > 0.0f) ? v : (0.0f - v);
    }
    /// Samples of the round of the observer.
    static constexpr std::uint32_t observer_samples_{9U};
    /// 320/9, weight in the observer's gain l1.
    static constexpr float q1_1_{35.555557f};
    /// -215/9, weight in the observer's gain l1.
    static constexpr float q1_2_{-23.88889f};
    /// Weight in the observer's gain l1.
    static constexpr float q1_3_{7.0f};

    std::uint32_t start_{}; // tick at which it was armed
    float u1_{}; // input of 2 samples ago
    float u2_{}; // input of 3 samples ago
    std::uint32_t seen_{}; // 1 once y has been measured
    float x1_hat_{}; // estimate of x1
    float x2_hat_{}; // estimate of x2
    float d_hat_{}; // estimate of d
    float phi1_2_{}; // prediction of x1 from x2
    float phi1_3_{}; // prediction of x1 from d
    float gamma1_{}; // prediction from u
    float late_gamma1_{}; // prediction from u
    float phi2_3_{}; // prediction of x2 from d
    float gamma2_{}; // prediction from u
    float hold_o_{}; // samples to go at which the observer is held
    float q2_1_{}; // weight in the observer's gain l2
    float q2_2_{}; // weight in the observer's gain l2
    float q3_1_{}; // weight in the observer's gain l3
};

} // namespace ptc

#endif
