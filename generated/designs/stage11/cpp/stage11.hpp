/*
 * Prescribed-time controller stage11: order n = 4, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang cpp --n 4 --mu "exp(a=1)" --name stage11 --clock samples --measured=x1 --disturbance constant --observer-poles=-4,-5,-6,-7,-8 --precision f32 --eps=0 --sample-time=0.01
 * Version 0.1.0, design a4fcc16c71ec.
 *
 * Plant: x1' = x2, ..., x4' = (u + d), d constant and unknown; u held from sample to sample.
 * Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
 *       sample period, as long as u is not clipped and nothing else acts on the plant.
 * Law: with M samples to go and z = S x, u h^4 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-3));
 *       the rows are those of Theorem 1 for the mapping exp. Close to the end deadbeat takes
 *       over.
 *
 * Parameters:
 *   samples [samples]: samples N from the start to rest
 *   h = 0.01 [s], fixed: sample period
 *   eps = 0 [s], fixed: time-to-go at which the gains are held
 *   u_max [unit of u]: bound of |u|
 *   a = 1 [1/s], fixed: rate of stretched time
 *   k_1 [1/s^4]: gains k_i of pi0 = -sum k_i xi_i
 *   k_2 [1/s^3]: gains k_i of pi0 = -sum k_i xi_i
 *   k_3 [1/s^2]: gains k_i of pi0 = -sum k_i xi_i
 *   k_4 [1/s]: gains k_i of pi0 = -sum k_i xi_i
 *   deadbeat [samples]: samples to go at which deadbeat takes over, 0 for a safe default
 *
 * k counts samples and may wrap; arm again within 2^32 - N samples.
 * From sample N on the last gains are held (status HOLD).
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
#ifndef STAGE11_E45A6FD0_HPP
#define STAGE11_E45A6FD0_HPP

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
struct Stage11Params {
    std::uint32_t samples{}; ///< samples N from the start to rest [samples], at least 10
    float u_max{}; ///< bound of |u| [unit of u], > 0, infinity allowed
    std::array<float, 4> k{}; ///< gains k_i of pi0 = -sum k_i xi_i [1/s^4], finite
    float deadbeat{}; ///< samples to go at which deadbeat takes over, 0 for a safe default [samples], finite
};

/// Controller: set by init, changed by arm and by what is not const.
class Stage11 {
public:
    using Params = Stage11Params;

    /// Takes the parameters and arms at tick 0. Ok, or Param with nothing changed.
    [[nodiscard]] constexpr Status init(const Params& params) noexcept
    {
        if (!((params.samples > 9U)
                && (params.u_max > 0.0f)
                && finite(params.k[0])
                && finite(params.k[1])
                && finite(params.k[2])
                && finite(params.k[3])
                && finite(params.deadbeat)
                && (params.deadbeat >= 0.0f))) {
            return Status::Param;
        }
        const std::uint32_t samples = params.samples;
        const float s1 = (params.k[3] - 9.0f) + 4.0f;
        const float s2 = (s1 < 8.0f) ? 8.0f : s1;
        const float deadbeat = (params.deadbeat > 0.0f) ? params.deadbeat : s2;
        const float w1_1 = 100000000.0f * (-params.k[0]);
        const float w1_2 = 1000000.0f * ((-1.5f) * (-params.k[0]));
        const float w1_3 = 10000.0f * (0.9166667f * (-params.k[0]));
        const float w1_4 = 100.0f * ((-0.25f) * (-params.k[0]));
        const float s3 = ((1.0f - params.k[1]) + params.k[2]) - params.k[3];
        const float w2_2 = 1000000.0f * s3;
        const float s4 = -(((1.0f - params.k[1]) + params.k[2]) - params.k[3]);
        const float w2_3 = 10000.0f * s4;
        const float s5 = ((1.0f - params.k[1]) + params.k[2]) - params.k[3];
        const float w2_4 = 100.0f * (0.33333334f * s5);
        const float w3_3 = 10000.0f * (((-7.0f) - params.k[2]) + (3.0f * params.k[3]));
        const float w3_4 = 100.0f * ((-0.5f) * (((-7.0f) - params.k[2]) + (3.0f * params.k[3])));
        const float w4_4 = 100.0f * (6.0f - params.k[3]);
        const float u_max = params.u_max;
        if (!(finite(deadbeat)
                && finite(w1_1)
                && finite(w1_2)
                && finite(w1_3)
                && finite(w1_4)
                && finite(w2_2)
                && finite(w2_3)
                && finite(w2_4)
                && finite(w3_3)
                && finite(w3_4)
                && finite(w4_4))) {
            return Status::Param;
        }
        start_ = 0U;
        samples_ = samples;
        u1_ = 0.0f;
        seen_ = 0U;
        x1_hat_ = 0.0f;
        x2_hat_ = 0.0f;
        x3_hat_ = 0.0f;
        x4_hat_ = 0.0f;
        d_hat_ = 0.0f;
        deadbeat_ = deadbeat;
        w1_1_ = w1_1;
        w1_2_ = w1_2;
        w1_3_ = w1_3;
        w1_4_ = w1_4;
        w2_2_ = w2_2;
        w2_3_ = w2_3;
        w2_4_ = w2_4;
        w3_3_ = w3_3;
        w3_4_ = w3_4;
        w4_4_ = w4_4;
        u_max_ = u_max;
        return Status::Ok;
    }

    /// Starts again: the deadline is N samples after tick `k`. Estimates and inputs under way are
    /// kept. Estimates too large to compute with begin anew.
    constexpr void arm(std::uint32_t k) noexcept
    {
        start_ = k;
        const float s1 = absolute(x1_hat_) + absolute(x2_hat_) + absolute(x3_hat_);
        const float size = s1 + absolute(x4_hat_) + absolute(d_hat_);
        if (!(size <= 1e18f)) {
            seen_ = 0U;
            x1_hat_ = 0.0f;
            x2_hat_ = 0.0f;
            x3_hat_ = 0.0f;
            x4_hat_ = 0.0f;
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
        const float s2 = s1 + (phi1_3_ * x3_hat_);
        const float s3 = s2 + (phi1_4_ * x4_hat_);
        const float s4 = s3 + (phi1_5_ * d_hat_);
        const float p1 = s4 + (gamma1_ * u1_);
        const float s5 = x2_hat_ + (phi2_3_ * x3_hat_);
        const float s6 = s5 + (phi2_4_ * x4_hat_);
        const float s7 = s6 + (phi2_5_ * d_hat_);
        const float p2 = s7 + (gamma2_ * u1_);
        const float s8 = x3_hat_ + (phi3_4_ * x4_hat_);
        const float s9 = s8 + (phi3_5_ * d_hat_);
        const float p3 = s9 + (gamma3_ * u1_);
        const float s10 = x4_hat_ + (phi4_5_ * d_hat_);
        const float p4 = s10 + (gamma4_ * u1_);
        const float p5 = d_hat_;

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
        float l4{};
        float l5{};
        if (o0 > 12.0f) {
            const float r0 = 1.0f / o0;
            const float r1 = 1.0f / (o0 - 1.0f);
            const float r2 = 1.0f / (o0 - 2.0f);
            const float r3 = 1.0f / (o0 - 3.0f);
            const float r4 = 1.0f / (o0 - 4.0f);
            const float s11 = ((((q1_1_ * r0) + q1_2_) * r1) + q1_3_) * r2;
            l1 = (((s11 + q1_4_) * r3) + q1_5_) * r4;
            const float s12 = ((((q2_1_ * r0) + q2_2_) * r1) + q2_3_) * r2;
            l2 = (s12 + q2_4_) * r3 * r4;
            const float s13 = ((((q3_1_ * r0) + q3_2_) * r1) + q3_3_) * r2;
            l3 = s13 * r3 * r4;
            l4 = ((q4_1_ * r0) + q4_2_) * r1 * r2 * r3 * r4;
            l5 = 0.0f;
        } else if (left_o == 12U) {
            l1 = 1.0f;
            l2 = e0_2_;
            l3 = e0_3_;
            l4 = e0_4_;
            l5 = e0_5_;
        } else if (left_o == 11U) {
            l1 = 1.0f;
            l2 = e1_2_;
            l3 = e1_3_;
            l4 = e1_4_;
            l5 = e1_5_;
        } else if (left_o == 10U) {
            l1 = 1.0f;
            l2 = e2_2_;
            l3 = e2_3_;
            l4 = e2_4_;
            l5 = e2_5_;
        } else if (left_o == 9U) {
            l1 = 1.0f;
            l2 = e3_2_;
            l3 = e3_3_;
            l4 = e3_4_;
            l5 = e3_5_;
        } else {
            l1 = 1.0f;
            l2 = e4_2_;
            l3 = e4_3_;
            l4 = e4_4_;
            l5 = e4_5_;
        }
        const float x1 = base + (l1 * miss);
        const float x2 = p2 + (l2 * miss);
        const float x3 = p3 + (l3 * miss);
        const float x4 = p4 + (l4 * miss);
        const float d = p5 + (l5 * miss);
        const std::uint32_t left = (elapsed < samples_) ? (samples_ - elapsed) : 0U;
        const float m0 = static_cast<float>(left);
        float v{};
        if (m0 > deadbeat_) {
            // The exact law in samples.
            const float s14 = (w1_1_ * x1) + (w1_2_ * x2) + (w1_3_ * x3);
            const float z1 = s14 + (w1_4_ * x4);
            const float z2 = (w2_2_ * x2) + (w2_3_ * x3) + (w2_4_ * x4);
            const float z3 = (w3_3_ * x3) + (w3_4_ * x4);
            const float z4 = w4_4_ * x4;
            const float s15 = (((((z1 / m0) + z2) / (m0 - 1.0f)) + z3) / (m0 - 2.0f)) + z4;
            v = (s15 / (m0 - 3.0f)) - d;
        } else {
            // Deadbeat.
            const float s16 = (b_1_ * x1) + (b_2_ * x2) + (b_3_ * x3);
            v = (s16 + (b_4_ * x4)) - d;
        }
        if (!finite(v)) {
            return {0.0f, Status::Range};
        }
        float u_now{};
        if (v > u_max_) {
            u_now = u_max_;
        } else if (v < -u_max_) {
            u_now = -u_max_;
        } else {
            u_now = v;
        }
        u1_ = u_now;
        x1_hat_ = x1;
        x2_hat_ = x2;
        x3_hat_ = x3;
        x4_hat_ = x4;
        d_hat_ = d;
        seen_ = 1U;
        if ((v > u_max_) || (v < -u_max_)) {
            return {u_now, Status::Saturated};
        } else if (elapsed < samples_) {
            return {u_now, Status::Ok};
        } else {
            return {u_now, Status::Hold};
        }
    }

    /// The estimate of the state at the last sample.
    [[nodiscard]] constexpr std::array<float, 4> estimate() const noexcept
    {
        return {{x1_hat_, x2_hat_, x3_hat_, x4_hat_}};
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
    /// 1/100, prediction of x1 from x2.
    static constexpr float phi1_2_{0.01f};
    /// 1/20000, prediction of x1 from x3.
    static constexpr float phi1_3_{5e-5f};
    /// 1/6000000, prediction of x1 from x4.
    static constexpr float phi1_4_{1.6666667e-7f};
    /// 1/2400000000, prediction of x1 from d.
    static constexpr float phi1_5_{4.1666667e-10f};
    /// 1/2400000000, prediction from u.
    static constexpr float gamma1_{4.1666667e-10f};
    /// 1/100, prediction of x2 from x3.
    static constexpr float phi2_3_{0.01f};
    /// 1/20000, prediction of x2 from x4.
    static constexpr float phi2_4_{5e-5f};
    /// 1/6000000, prediction of x2 from d.
    static constexpr float phi2_5_{1.6666667e-7f};
    /// 1/6000000, prediction from u.
    static constexpr float gamma2_{1.6666667e-7f};
    /// 1/100, prediction of x3 from x4.
    static constexpr float phi3_4_{0.01f};
    /// 1/20000, prediction of x3 from d.
    static constexpr float phi3_5_{5e-5f};
    /// 1/20000, prediction from u.
    static constexpr float gamma3_{5e-5f};
    /// 1/100, prediction of x4 from d.
    static constexpr float phi4_5_{0.01f};
    /// 1/100, prediction from u.
    static constexpr float gamma4_{0.01f};
    /// Weight in the observer's gain l1.
    static constexpr float q1_1_{6720.0f};
    /// Weight in the observer's gain l1.
    static constexpr float q1_2_{-4200.0f};
    /// Weight in the observer's gain l1.
    static constexpr float q1_3_{1200.0f};
    /// Weight in the observer's gain l1.
    static constexpr float q1_4_{-200.0f};
    /// Weight in the observer's gain l1.
    static constexpr float q1_5_{20.0f};
    /// Weight in the observer's gain l2.
    static constexpr float q2_1_{-808000.0f};
    /// Weight in the observer's gain l2.
    static constexpr float q2_2_{454000.0f};
    /// Weight in the observer's gain l2.
    static constexpr float q2_3_{-108000.0f};
    /// Weight in the observer's gain l2.
    static constexpr float q2_4_{12000.0f};
    /// Weight in the observer's gain l3.
    static constexpr float q3_1_{38400000.0f};
    /// Weight in the observer's gain l3.
    static constexpr float q3_2_{-16800000.0f};
    /// Weight in the observer's gain l3.
    static constexpr float q3_3_{2400000.0f};
    /// Weight in the observer's gain l4.
    static constexpr float q4_1_{-480000000.0f};
    /// Weight in the observer's gain l4.
    static constexpr float q4_2_{120000000.0f};
    /// 1675/33, gain of the observer at its end.
    static constexpr float e0_2_{50.757576f};
    /// 1092500/297, gain of the observer at its end.
    static constexpr float e0_3_{3678.4512f};
    /// -500000/3, gain of the observer at its end.
    static constexpr float e0_4_{-166666.67f};
    /// 700000000/99, gain of the observer at its end.
    static constexpr float e0_5_{7070707.0f};
    /// 7850/99, gain of the observer at its end.
    static constexpr float e1_2_{79.29293f};
    /// -140000/99, gain of the observer at its end.
    static constexpr float e1_3_{-1414.1414f};
    /// 23000000/33, gain of the observer at its end.
    static constexpr float e1_4_{696969.7f};
    /// -1600000000/33, gain of the observer at its end.
    static constexpr float e1_5_{-48484850.0f};
    /// 950/9, gain of the observer at its end.
    static constexpr float e2_2_{105.55556f};
    /// -10000/9, gain of the observer at its end.
    static constexpr float e2_3_{-1111.1111f};
    /// -1000000/3, gain of the observer at its end.
    static constexpr float e2_4_{-333333.34f};
    /// 400000000/3, gain of the observer at its end.
    static constexpr float e2_5_{133333336.0f};
    /// 1250/9, gain of the observer at its end.
    static constexpr float e3_2_{138.88889f};
    /// 100000/27, gain of the observer at its end.
    static constexpr float e3_3_{3703.7036f};
    /// -5000000/3, gain of the observer at its end.
    static constexpr float e3_4_{-1666666.6f};
    /// -1600000000/9, gain of the observer at its end.
    static constexpr float e3_5_{-177777780.0f};
    /// 625/3, gain of the observer at its end.
    static constexpr float e4_2_{208.33333f};
    /// 87500/3, gain of the observer at its end.
    static constexpr float e4_3_{29166.666f};
    /// Gain of the observer at its end.
    static constexpr float e4_4_{2500000.0f};
    /// Gain of the observer at its end.
    static constexpr float e4_5_{100000000.0f};
    /// Weight of x1 in the law.
    static constexpr float b_1_{-100000000.0f};
    /// Weight of x2 in the law.
    static constexpr float b_2_{-2500000.0f};
    /// -87500/3, weight of x3 in the law.
    static constexpr float b_3_{-29166.666f};
    /// -625/3, weight of x4 in the law.
    static constexpr float b_4_{-208.33333f};

    std::uint32_t start_{}; // tick at which it was armed
    std::uint32_t samples_{}; // samples from the start to rest
    float u1_{}; // input of the last sample
    std::uint32_t seen_{}; // 1 once y has been measured
    float x1_hat_{}; // estimate of x1
    float x2_hat_{}; // estimate of x2
    float x3_hat_{}; // estimate of x3
    float x4_hat_{}; // estimate of x4
    float d_hat_{}; // estimate of d
    float deadbeat_{}; // samples to go at which deadbeat takes over
    float w1_1_{}; // weight of x1 in the law
    float w1_2_{}; // weight of x2 in the law
    float w1_3_{}; // weight of x3 in the law
    float w1_4_{}; // weight of x4 in the law
    float w2_2_{}; // weight of x2 in the law
    float w2_3_{}; // weight of x3 in the law
    float w2_4_{}; // weight of x4 in the law
    float w3_3_{}; // weight of x3 in the law
    float w3_4_{}; // weight of x4 in the law
    float w4_4_{}; // weight of x4 in the law
    float u_max_{}; // bound of |u|
};

} // namespace ptc

#endif
