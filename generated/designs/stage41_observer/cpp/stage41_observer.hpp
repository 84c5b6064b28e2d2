/*
 * Prescribed-time observer stage41_observer: order n = 3, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang cpp --n 3 --mu "exp(a=1)" --name stage41 --what observer --clock samples --A="[[0,1,0],[0,-0.5,15],[0,-15,-60]]" --B="[0,0,50]" --C="[[1,0,0],[0,0,1]]" --observer-poles=-4,-5,-6 --observer-samples=20 --innovation-max=1,0.75 --coast=1 --precision f32 --sample-time=0.01
 * Version 0.1.0, design 5a4b5fc5ddd5.
 *
 * Plant: x' = A x + B u of --A and --B above; u held from sample to sample, y = C x.
 * Goal: the estimates of the state are exact up to rounding from sample 20 after the start
 *       on, from any state and at any sample period, as long as the measurement is exact, u
 *       is what was applied and nothing else acts on the plant.
 * Observer: xhat(k) = Phi xhat(k - 1) + Gamma u + G (y(k - 1) - C xhat(k - 1)) with the plant
 *       sampled, Phi and Gamma: the estimates of tick k hold y up to tick k - 1. The gains
 *       follow by duality from the rows that Theorem 1 gives for the mapping exp. Close to
 *       the end deadbeat takes over.
 *
 * Parameters:
 *   h = 0.01 [s], fixed: sample period
 *   a = 1 [1/s], fixed: rate of stretched time
 *
 * k counts samples and may wrap; arm again within 2^32 - 20 samples.
 * u is the input of tick k - 1 as it was applied, after clipping: it acted from tick k - 1 to
 *       tick k.
 * From sample 20 on the status is HOLD; with noise or sensor_step given, or observer_eps, the
 *       gains of the observer are then held below deadbeat.
 * Gate: a reading that is not finite or further than 1, 0.75 from its prediction is not
 *       believed, and the estimates are predicted alone (status GATED) for at most 1 sample
 *       in a row. Then the call is refused (E_INPUT) until a reading is believed or arm
 *       starts the estimates anew. The first reading has no prediction.
 * Guard full: what is measured passes this gate, u is finite, or the call is refused (INPUT).
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
#ifndef STAGE41_OBSERVER_C36AF846_HPP
#define STAGE41_OBSERVER_C36AF846_HPP

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
struct Stage41ObserverParams {
};

/// Observer: set by init, changed by arm and by what is not const.
class Stage41Observer {
public:
    using Params = Stage41ObserverParams;

    /// Takes the parameters and arms at tick 0. Ok, or Param with nothing changed.
    [[nodiscard]] constexpr Status init(const Params&) noexcept
    {
        start_ = 0U;
        seen_ = 0U;
        x1_hat_ = 0.0f;
        x1_next_ = 0.0f;
        x2_hat_ = 0.0f;
        x2_next_ = 0.0f;
        x3_hat_ = 0.0f;
        x3_next_ = 0.0f;
        trust_ = 1U;
        return Status::Ok;
    }

    /// Starts a round of 20 samples at tick `k`. The estimates are kept. Estimates that have had no
    /// reading for all samples of `coast`, and those too large to compute with, begin anew.
    constexpr void arm(std::uint32_t k) noexcept
    {
        start_ = k;
        const float s1 = absolute(x1_next_) + absolute(x2_next_);
        const float size = s1 + absolute(x3_next_);
        if (!((trust_ > 1U) && (size <= 1e18f))) {
            seen_ = 0U;
            x1_hat_ = 0.0f;
            x1_next_ = 0.0f;
            x2_hat_ = 0.0f;
            x2_next_ = 0.0f;
            x3_hat_ = 0.0f;
            x3_next_ = 0.0f;
        }
    }

    /// The estimates of tick `k`, which may wrap, from what is measured, y = C x at that tick and
    /// u, the input of tick `k` - 1 as it was applied, 0 where there was none. y of tick `k` shows
    /// in the estimates from the next tick on. Call it once for each tick, before the law, which
    /// takes its estimates. Status Hold from sample 20 on: the round is over.
    /// On a negative status nothing has changed.
    [[nodiscard]] constexpr Status update(std::uint32_t k, const std::array<float, 2>& y, float u) noexcept
    {
        if (!finite(u)) {
            return Status::Input;
        }
        const std::uint32_t elapsed = k - start_;

        // The estimates; at first what y shows.
        float x1{};
        float x2{};
        float x3{};
        if (seen_ == 0U) {
            x1 = y[0];
            x2 = 0.0f;
            x3 = y[1];
        } else {
            x1 = x1_next_ + (gamma1_ * u);
            x2 = x2_next_ + (gamma2_ * u);
            x3 = x3_next_ + (gamma3_ * u);
        }

        // Prediction of the next sample.
        const float gap1 = y[0] - x1;
        const float gap2 = y[1] - x3;
        float miss1{};
        float miss2{};
        std::uint32_t trust{};
        if (finite(y[0]) && (absolute(gap1) <= 1.0f) && finite(y[1]) && (absolute(gap2) <= 0.75f)) {
            miss1 = gap1;
            miss2 = gap2;
            trust = 2U;
        } else {
            miss1 = 0.0f;
            miss2 = 0.0f;
            trust = (1U < trust_) ? (trust_ - 1U) : 0U;
        }
        if (!(trust > 0U)) {
            return Status::Input;
        }
        const float off1 = miss1;
        const float off2 = (11.271489f * miss1) + miss2;
        const std::uint32_t left_o = (elapsed < observer_samples_) ? (observer_samples_ - elapsed) : 0U;
        const float o0 = static_cast<float>(left_o);
        float l1_1{};
        float l1_2{};
        float l1_3{};
        float l2_1{};
        float l2_2{};
        float l2_3{};
        if (o0 > 7.0f) {
            const float r0 = 1.0f / (o0 * (o0 - 1.0f));
            l1_1 = ((q1_1_1_ + (q1_1_2_ * o0)) * r0) - 0.021203334f;
            l1_2 = ((q1_2_1_ + (q1_2_2_ * o0)) * r0) - 1.242789f;
            l1_3 = ((q1_3_1_ + (q1_3_2_ * o0)) * r0) + 5.3316126f;
            l2_1 = 0.0f;
            l2_2 = (q2_2_1_ * r0) + 0.112953566f;
            l2_3 = (q2_3_1_ * r0) - 0.45181426f;
        } else if (left_o == 7U) {
            l1_1 = e0_1_1_;
            l1_2 = e0_1_2_;
            l1_3 = e0_1_3_;
            l2_1 = 0.0f;
            l2_2 = e0_2_2_;
            l2_3 = e0_2_3_;
        } else {
            l1_1 = e1_1_1_;
            l1_2 = e1_1_2_;
            l1_3 = e1_1_3_;
            l2_1 = 0.0f;
            l2_2 = e1_2_2_;
            l2_3 = e1_2_3_;
        }
        const float s1 = x1 + (phi1_2_ * x2) + (phi1_3_ * x3);
        const float x1_on = s1 + (l1_1 * off1) + (l2_1 * off2);
        const float s2 = (phi2_2_ * x2) + (phi2_3_ * x3) + (l1_2 * off1);
        const float x2_on = s2 + (l2_2 * off2);
        const float s3 = (phi3_2_ * x2) + (phi3_3_ * x3) + (l1_3 * off1);
        const float x3_on = s3 + (l2_3 * off2);
        if (!(finite(x1)
                && finite(x1_on)
                && finite(x2)
                && finite(x2_on)
                && finite(x3)
                && finite(x3_on))) {
            return Status::Range;
        }
        x1_hat_ = x1;
        x1_next_ = x1_on;
        x2_hat_ = x2;
        x2_next_ = x2_on;
        x3_hat_ = x3;
        x3_next_ = x3_on;
        seen_ = 1U;
        trust_ = trust;
        if (trust < 2U) {
            return Status::Gated;
        } else if (left_o == 0U) {
            return Status::Hold;
        } else {
            return Status::Ok;
        }
    }

    /// The estimate of the state at the last sample.
    [[nodiscard]] constexpr std::array<float, 3> estimate() const noexcept
    {
        return {{x1_hat_, x2_hat_, x3_hat_}};
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
    /// Prediction from u.
    static constexpr float gamma1_{0.00010803832f};
    /// Prediction from u.
    static constexpr float gamma2_{0.030892799f};
    /// Prediction from u.
    static constexpr float gamma3_{0.37459216f};
    /// Samples of the round of the observer.
    static constexpr std::uint32_t observer_samples_{20U};
    /// Weight in the observer's gain l1_1.
    static constexpr float q1_1_1_{-8.0f};
    /// Weight in the observer's gain l1_1.
    static constexpr float q1_1_2_{8.0f};
    /// Weight in the observer's gain l1_2.
    static constexpr float q1_2_1_{1218.3761f};
    /// Weight in the observer's gain l1_2.
    static constexpr float q1_2_2_{-11.457022f};
    /// Weight in the observer's gain l1_3.
    static constexpr float q1_3_1_{90.17191f};
    /// Weight in the observer's gain l1_3.
    static constexpr float q1_3_2_{-90.17191f};
    /// Weight in the observer's gain l2_2.
    static constexpr float q2_2_1_{-0.37285107f};
    /// Weight in the observer's gain l2_3.
    static constexpr float q2_3_1_{6.0f};
    /// Gain of the observer at its end.
    static constexpr float e0_1_1_{1.1216538f};
    /// Gain of the observer at its end.
    static constexpr float e0_1_2_{11.488578f};
    /// Gain of the observer at its end.
    static constexpr float e0_1_3_{-7.5500894f};
    /// Gain of the observer at its end.
    static constexpr float e0_2_2_{0.05081172f};
    /// Gain of the observer at its end.
    static constexpr float e0_2_3_{0.5481857f};
    /// Gain of the observer at its end.
    static constexpr float e1_1_1_{1.9787967f};
    /// Gain of the observer at its end.
    static constexpr float e1_1_2_{96.46954f};
    /// Gain of the observer at its end.
    static constexpr float e1_1_3_{-17.211365f};
    /// Gain of the observer at its end.
    static constexpr float e1_2_2_{0.05081172f};
    /// Gain of the observer at its end.
    static constexpr float e1_2_3_{0.5481857f};
    /// Prediction of x1 from x2.
    static constexpr float phi1_2_{0.009942672f};
    /// Prediction of x1 from x3.
    static constexpr float phi1_3_{0.000617856f};
    /// Prediction of x2 from x2.
    static constexpr float phi2_2_{0.9857608f};
    /// Prediction of x2 from x3.
    static constexpr float phi2_3_{0.11206872f};
    /// Prediction of x3 from x2.
    static constexpr float phi3_2_{-0.11206872f};
    /// Prediction of x3 from x3.
    static constexpr float phi3_3_{0.54122156f};

    std::uint32_t start_{}; // tick at which it was armed
    std::uint32_t seen_{}; // 1 once y has been measured
    float x1_hat_{}; // estimate of x1
    float x1_next_{}; // prediction of x1 without u
    float x2_hat_{}; // estimate of x2
    float x2_next_{}; // prediction of x2 without u
    float x3_hat_{}; // estimate of x3
    float x3_next_{}; // prediction of x3 without u
    std::uint32_t trust_{}; // samples for which the estimates may be used, the next one included
};

} // namespace ptc

#endif
