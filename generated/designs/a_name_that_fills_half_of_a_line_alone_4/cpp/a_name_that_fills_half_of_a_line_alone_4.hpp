/*
 * Prescribed-time controller a_name_that_fills_half_of_a_line_alone_4: order n = 2, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang cpp --n 2 --mu "exp(a=2)" --name a_name_that_fills_half_of_a_line_alone_4 --clock samples --measured=x1 --disturbance constant --observer-poles=-4,-5,-6 --precision f32 --eps=0 --after zero
 * Version 0.1.0, design 077043d15f79.
 *
 * Plant: x1' = x2, x2' = (u + d), d constant and unknown; u held from sample to sample.
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
 *   a = 2 [1/s], fixed: rate of stretched time
 *   k_1 [1/s^2]: gains k_i of pi0 = -sum k_i xi_i
 *   k_2 [1/s]: gains k_i of pi0 = -sum k_i xi_i
 *   deadbeat [samples]: samples to go at which deadbeat takes over, 0 for a safe default
 *
 * k counts samples and may wrap; arm again within 2^32 - N samples.
 * From sample N on u = 0 (status AFTER).
 * The estimates are exact from sample N/2 after the start on where the measurement is; with
 *       noise or sensor_step given, or observer_eps, the gains of the observer are then held
 *       below deadbeat.
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
#ifndef A_NAME_THAT_FILLS_HALF_OF_A_LINE_ALONE_4_1BD17FF9_HPP
#define A_NAME_THAT_FILLS_HALF_OF_A_LINE_ALONE_4_1BD17FF9_HPP

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
struct ANameThatFillsHalfOfALineAlone4Params {
    std::uint32_t samples{}; ///< samples N from the start to rest [samples], at least 6
    float h{}; ///< sample period [s], from 1e-18 to 1e18
    float u_max{}; ///< bound of |u| [unit of u], > 0, infinity allowed
    std::array<float, 2> k{}; ///< gains k_i of pi0 = -sum k_i xi_i [1/s^2], finite
    float deadbeat{}; ///< samples to go at which deadbeat takes over, 0 for a safe default [samples], finite
};

/// Controller: set by init, changed by arm and by what is not const.
class ANameThatFillsHalfOfALineAlone4 {
public:
    using Params = ANameThatFillsHalfOfALineAlone4Params;

    /// Takes the parameters and arms at tick 0. Ok, or Param with nothing changed.
    [[nodiscard]] constexpr Status init(const Params& params) noexcept
    {
        if (!((params.samples > 5U)
                && (1e-18f <= params.h)
                && (params.h <= 1e18f)
                && (params.u_max > 0.0f)
                && finite(params.k[0])
                && finite(params.k[1])
                && finite(params.deadbeat)
                && (params.deadbeat >= 0.0f))) {
            return Status::Param;
        }
        const std::uint32_t samples = params.samples;
        const float phi1_2 = params.h;
        const float phi1_3 = 0.5f * (params.h * params.h);
        const float q2_1 = (-6.0f) * (1.0f / params.h);
        const float q2_2 = 3.0f * (1.0f / params.h);
        const float e2_2 = 1.5f * (1.0f / params.h);
        const float e2_3 = 1.0f / (params.h * params.h);
        const float e1_2 = 0.45f * (1.0f / params.h);
        const float e1_3 = (-1.1f) * (1.0f / (params.h * params.h));
        const float e0_2 = (-0.425f) * (1.0f / params.h);
        const float e0_3 = 0.35f * (1.0f / (params.h * params.h));
        const float s1 = ((params.k[1] / 2.0f) - 1.0f) + 2.0f;
        const float s2 = (s1 < 4.0f) ? 4.0f : s1;
        const float deadbeat = (params.deadbeat > 0.0f) ? params.deadbeat : s2;
        const float w1_1 = (-(params.k[0] / 4.0f)) * (1.0f / (params.h * params.h));
        const float w1_2 = (-0.5f) * (-(params.k[0] / 4.0f)) * (1.0f / params.h);
        const float w2_2 = (1.0f - (params.k[1] / 2.0f)) * (1.0f / params.h);
        const float b_1 = -(1.0f / (params.h * params.h));
        const float b_2 = (-1.5f) * (1.0f / params.h);
        const float u_max = params.u_max;
        if (!(finite(phi1_3)
                && finite(q2_1)
                && finite(q2_2)
                && finite(e2_2)
                && finite(e2_3)
                && finite(e1_2)
                && finite(e1_3)
                && finite(e0_2)
                && finite(e0_3)
                && finite(deadbeat)
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
        u1_ = 0.0f;
        seen_ = 0U;
        x1_hat_ = 0.0f;
        x2_hat_ = 0.0f;
        d_hat_ = 0.0f;
        phi1_2_ = phi1_2;
        phi1_3_ = phi1_3;
        q2_1_ = q2_1;
        q2_2_ = q2_2;
        e2_2_ = e2_2;
        e2_3_ = e2_3;
        e1_2_ = e1_2;
        e1_3_ = e1_3;
        e0_2_ = e0_2;
        e0_3_ = e0_3;
        deadbeat_ = deadbeat;
        w1_1_ = w1_1;
        w1_2_ = w1_2;
        w2_2_ = w2_2;
        b_1_ = b_1;
        b_2_ = b_2;
        u_max_ = u_max;
        return Status::Ok;
    }

    /// Starts again: the deadline is N samples after tick `k`. Estimates and inputs under way are
    /// kept. Estimates too large to compute with begin anew.
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

    /// u from tick `k`, which may wrap, and what is measured, y = (x1, ...). Call it once for each
    /// tick.
    /// On a negative status u is 0 and nothing has changed.
    constexpr Control<float> step(std::uint32_t k, const std::array<float, 1>& y) noexcept
    {
        if (!finite(y[0])) {
            return {0.0f, Status::Input};
        }
        const std::uint32_t elapsed = k - start_;

        // Predict.
        const float s1 = x1_hat_ + (phi1_2_ * x2_hat_);
        const float p1 = s1 + (phi1_3_ * d_hat_) + (phi1_3_ * u1_);
        const float s2 = x2_hat_ + (phi1_2_ * d_hat_);
        const float p2 = s2 + (phi1_2_ * u1_);
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
        const std::uint32_t left_o = (elapsed < (samples_ / 2U)) ? ((samples_ / 2U) - elapsed) : 0U;
        const float o0 = static_cast<float>(left_o);
        float l1{};
        float l2{};
        float l3{};
        if (o0 > 6.0f) {
            const float r0 = 1.0f / o0;
            const float r1 = 1.0f / (o0 - 1.0f);
            const float r2 = 1.0f / (o0 - 2.0f);
            l1 = ((((q1_1_ * r0) + q1_2_) * r1) + q1_3_) * r2;
            l2 = ((q2_1_ * r0) + q2_2_) * r1 * r2;
            l3 = 0.0f;
        } else if (left_o == 6U) {
            l1 = 1.0f;
            l2 = e0_2_;
            l3 = e0_3_;
        } else if (left_o == 5U) {
            l1 = 1.0f;
            l2 = e1_2_;
            l3 = e1_3_;
        } else {
            l1 = 1.0f;
            l2 = e2_2_;
            l3 = e2_3_;
        }
        const float x1 = base + (l1 * miss);
        const float x2 = p2 + (l2 * miss);
        const float d = p3 + (l3 * miss);
        const std::uint32_t left = (elapsed < samples_) ? (samples_ - elapsed) : 0U;
        const float m0 = static_cast<float>(left);
        float v{};
        if (m0 > deadbeat_) {
            // The exact law in samples.
            const float z1 = (w1_1_ * x1) + (w1_2_ * x2);
            const float z2 = w2_2_ * x2;
            v = ((z1 + (z2 * m0)) / (m0 * (m0 - 1.0f))) - d;
        } else {
            // Deadbeat.
            v = ((b_1_ * x1) + (b_2_ * x2)) - d;
        }
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
        u1_ = u_now;
        x1_hat_ = x1;
        x2_hat_ = x2;
        d_hat_ = d;
        seen_ = 1U;
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
    /// Weight in the observer's gain l1.
    static constexpr float q1_1_{15.0f};
    /// Weight in the observer's gain l1.
    static constexpr float q1_2_{-12.0f};
    /// 9/2, weight in the observer's gain l1.
    static constexpr float q1_3_{4.5f};

    std::uint32_t start_{}; // tick at which it was armed
    std::uint32_t samples_{}; // samples from the start to rest
    float u1_{}; // input of the last sample
    std::uint32_t seen_{}; // 1 once y has been measured
    float x1_hat_{}; // estimate of x1
    float x2_hat_{}; // estimate of x2
    float d_hat_{}; // estimate of d
    float phi1_2_{}; // prediction of x1 from x2
    float phi1_3_{}; // prediction of x1 from d
    float q2_1_{}; // weight in the observer's gain l2
    float q2_2_{}; // weight in the observer's gain l2
    float e2_2_{}; // gain of the observer at its end
    float e2_3_{}; // gain of the observer at its end
    float e1_2_{}; // gain of the observer at its end
    float e1_3_{}; // gain of the observer at its end
    float e0_2_{}; // gain of the observer at its end
    float e0_3_{}; // gain of the observer at its end
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
