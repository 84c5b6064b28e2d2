/*
 * Prescribed-time controller stage5: order n = 4, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang cpp --n 4 --mu exp --name stage5 --clock samples --guard none --eps=0.01 --delay=2
 * Version 0.1.0, design af29f716abf2.
 *
 * Plant: x1' = x2, ..., x4' = u; u held from sample to sample, 2 samples late.
 * Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
 *       sample period, as long as u is not clipped and nothing else acts on the plant.
 * Law: with M samples to go and z = S x, u h^6 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-5));
 *       the rows are those of Theorem 1 for the mapping exp. Close to the end deadbeat takes
 *       over.
 *
 * Parameters:
 *   samples [samples]: samples N from the start to rest
 *   h [s]: sample period
 *   eps = 0.01 [s], fixed: time-to-go at which the gains are held
 *   u_max [unit of u]: bound of |u|
 *   a [1/s]: rate of stretched time
 *   k_1 [1/s^6]: gains k_i of pi0 = -sum k_i xi_i
 *   k_2 [1/s^5]: gains k_i of pi0 = -sum k_i xi_i
 *   k_3 [1/s^4]: gains k_i of pi0 = -sum k_i xi_i
 *   k_4 [1/s^3]: gains k_i of pi0 = -sum k_i xi_i
 *   k_5 [1/s^2]: gains k_i of pi0 = -sum k_i xi_i
 *   k_6 [1/s]: gains k_i of pi0 = -sum k_i xi_i
 *   deadbeat [samples]: samples to go at which deadbeat takes over, 0 for a safe default
 *
 * k counts samples and may wrap; arm again within 2^32 - N samples.
 * From sample N on the last gains are held (status HOLD).
 * |u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
 *       lasts.
 * Guard none: finite measurements are the responsibility of the caller.
 * Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
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
#ifndef STAGE5_F3DD29C9_HPP
#define STAGE5_F3DD29C9_HPP

#include <array>
#include <cfloat>
#include <cstdint>
#include <limits>

/* What this file requires of its compiler. */
#if defined(__SDCC) || (defined(DBL_MANT_DIG) && (DBL_MANT_DIG != 53))
#error "double is not IEEE 754 binary64 here: emit with --precision f32, or make double 64 bits wide"
#endif
#if defined(FLT_EVAL_METHOD) && !defined(PTC_ALLOW_EXCESS_PRECISION)
#if (FLT_EVAL_METHOD == 2)
#error "double is computed with more digits than it has: on x86 compile with -msse2 -mfpmath=sse, or define PTC_ALLOW_EXCESS_PRECISION"
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
struct Stage5Params {
    std::uint32_t samples{}; ///< samples N from the start to rest [samples], at least 6
    double h{}; ///< sample period [s], from 1e-150 to 1e150
    double u_max{}; ///< bound of |u| [unit of u], > 0, infinity allowed
    double a{}; ///< rate of stretched time [1/s], from 1e-150 to 1e150
    std::array<double, 6> k{}; ///< gains k_i of pi0 = -sum k_i xi_i [1/s^6], finite
    double deadbeat{}; ///< samples to go at which deadbeat takes over, 0 for a safe default [samples], finite
};

/// Controller: set by init, changed by arm and by what is not const.
class Stage5 {
public:
    using Params = Stage5Params;

    /// Takes the parameters and arms at tick 0. Ok, or Param with nothing changed.
    [[nodiscard]] constexpr Status init(const Params& params) noexcept
    {
        if (!((params.samples > 5U)
                && (1e-150 <= params.h)
                && (params.h <= 1e150)
                && (params.u_max > 0.0)
                && (1e-150 <= params.a)
                && (params.a <= 1e150)
                && finite(params.k[0])
                && finite(params.k[1])
                && finite(params.k[2])
                && finite(params.k[3])
                && finite(params.k[4])
                && finite(params.k[5])
                && finite(params.deadbeat)
                && (params.deadbeat >= 0.0))) {
            return Status::Param;
        }
        const std::uint32_t samples = params.samples;
        const double hold = 0.01 / params.h;
        const double s1 = params.a * params.a * params.a * params.a * params.a;
        const double s2 = 1.0 / (params.h * params.h * params.h * params.h);
        const double w1_1 = (-(params.k[0] / (s1 * params.a))) * s2;
        const double s3 = params.a * params.a * params.a * params.a * params.a;
        const double s4 = (-1.5) * (-(params.k[0] / (s3 * params.a)));
        const double w1_2 = s4 * (1.0 / (params.h * params.h * params.h));
        const double s5 = params.a * params.a * params.a * params.a * params.a;
        const double s6 = 0.9166666666666666 * (-(params.k[0] / (s5 * params.a)));
        const double w1_3 = s6 * (1.0 / (params.h * params.h));
        const double s7 = params.a * params.a * params.a * params.a * params.a;
        const double w1_4 = (-0.25) * (-(params.k[0] / (s7 * params.a))) * (1.0 / params.h);
        const double s8 = params.a * params.a * params.a * params.a * params.a;
        const double s9 = params.a * params.a * params.a * params.a;
        const double s10 = params.k[3] / (params.a * params.a * params.a);
        const double s11 = ((1.0 - (params.k[1] / s8)) + (params.k[2] / s9)) - s10;
        const double s12 = s11 + (params.k[4] / (params.a * params.a));
        const double s13 = 1.0 / (params.h * params.h * params.h);
        const double w2_2 = (s12 - (params.k[5] / params.a)) * s13;
        const double s14 = params.a * params.a * params.a * params.a * params.a;
        const double s15 = params.a * params.a * params.a * params.a;
        const double s16 = params.k[3] / (params.a * params.a * params.a);
        const double s17 = ((1.0 - (params.k[1] / s14)) + (params.k[2] / s15)) - s16;
        const double s18 = s17 + (params.k[4] / (params.a * params.a));
        const double s19 = -(s18 - (params.k[5] / params.a));
        const double w2_3 = s19 * (1.0 / (params.h * params.h));
        const double s20 = params.a * params.a * params.a * params.a * params.a;
        const double s21 = params.a * params.a * params.a * params.a;
        const double s22 = params.k[3] / (params.a * params.a * params.a);
        const double s23 = ((1.0 - (params.k[1] / s20)) + (params.k[2] / s21)) - s22;
        const double s24 = s23 + (params.k[4] / (params.a * params.a));
        const double s25 = 0.3333333333333333 * (s24 - (params.k[5] / params.a));
        const double w2_4 = s25 * (1.0 / params.h);
        const double s26 = params.a * params.a * params.a * params.a;
        const double s27 = 3.0 * (params.k[3] / (params.a * params.a * params.a));
        const double s28 = 7.0 * (params.k[4] / (params.a * params.a));
        const double s29 = (((-31.0) - (params.k[2] / s26)) + s27) - s28;
        const double s30 = s29 + (15.0 * (params.k[5] / params.a));
        const double w3_3 = s30 * (1.0 / (params.h * params.h));
        const double s31 = params.a * params.a * params.a * params.a;
        const double s32 = 3.0 * (params.k[3] / (params.a * params.a * params.a));
        const double s33 = 7.0 * (params.k[4] / (params.a * params.a));
        const double s34 = (((-31.0) - (params.k[2] / s31)) + s32) - s33;
        const double s35 = (-0.5) * (s34 + (15.0 * (params.k[5] / params.a)));
        const double w3_4 = s35 * (1.0 / params.h);
        const double s36 = 90.0 - (params.k[3] / (params.a * params.a * params.a));
        const double s37 = s36 + (6.0 * (params.k[4] / (params.a * params.a)));
        const double w4_4 = (s37 - (25.0 * (params.k[5] / params.a))) * (1.0 / params.h);
        const double s38 = (-65.0) - (params.k[4] / (params.a * params.a));
        const double w5_6 = s38 + (10.0 * (params.k[5] / params.a));
        const double w6_5 = 15.0 - (params.k[5] / params.a);
        const double w6_6 = -(15.0 - (params.k[5] / params.a));
        const double b_1 = -(1.0 / (params.h * params.h * params.h * params.h));
        const double b_2 = (-4.5) * (1.0 / (params.h * params.h * params.h));
        const double b_3 = (-9.916666666666666) * (1.0 / (params.h * params.h));
        const double b_4 = (-14.25) * (1.0 / params.h);
        const double u_max = params.u_max;
        if (!(finite(hold)
                && finite(w1_1)
                && finite(w1_2)
                && finite(w1_3)
                && finite(w1_4)
                && finite(w2_2)
                && finite(w2_3)
                && finite(w2_4)
                && finite(w3_3)
                && finite(w3_4)
                && finite(w4_4)
                && finite(w5_6)
                && finite(w6_5)
                && finite(w6_6)
                && finite(b_1)
                && finite(b_2)
                && finite(b_3)
                && finite(b_4)
                && (params.h * params.h * params.h * params.h >= 1e-200)
                && (1.0 / (params.h * params.h * params.h * params.h) >= 1e-200))) {
            return Status::Param;
        }
        start_ = 0U;
        samples_ = samples;
        u1_ = 0.0;
        u2_ = 0.0;
        hold_ = hold;
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
        w5_6_ = w5_6;
        w6_5_ = w6_5;
        w6_6_ = w6_6;
        b_1_ = b_1;
        b_2_ = b_2;
        b_3_ = b_3;
        b_4_ = b_4;
        u_max_ = u_max;
        return Status::Ok;
    }

    /// Starts again: the deadline is N samples after tick `k`. Estimates and inputs under way are
    /// kept.
    constexpr void arm(std::uint32_t k) noexcept
    {
        start_ = k;
    }

    /// u from tick `k`, which may wrap, and the state x = (x1, x1', ...). Call it once for each
    /// tick.
    /// On a negative status u is 0 and nothing has changed.
    constexpr Control<double> step(std::uint32_t k, const std::array<double, 4>& x) noexcept
    {
        const std::uint32_t elapsed = k - start_;
        const double x1 = x[0];
        const double x2 = x[1];
        const double x3 = x[2];
        const double x4 = x[3];
        const std::uint32_t left = (elapsed < samples_) ? (samples_ - elapsed) : 0U;
        const double m0 = (static_cast<double>(left) < hold_) ? hold_ : static_cast<double>(left);
        double v{};
        if (m0 > deadbeat_) {
            // The exact law in samples.
            const double s1 = (w1_1_ * x1) + (w1_2_ * x2) + (w1_3_ * x3);
            const double z1 = s1 + (w1_4_ * x4);
            const double z2 = (w2_2_ * x2) + (w2_3_ * x3) + (w2_4_ * x4);
            const double z3 = (w3_3_ * x3) + (w3_4_ * x4);
            const double z4 = w4_4_ * x4;
            const double z5 = w5_6_ * u2_;
            const double z6 = (w6_5_ * u1_) + (w6_6_ * u2_);
            const double m0f2 = m0 * (m0 - 1.0);
            const double m0f3 = m0f2 * (m0 - 2.0);
            const double m0f4 = m0f3 * (m0 - 3.0);
            const double m0f5 = m0f4 * (m0 - 4.0);
            const double s2 = z1 + (z2 * m0) + (z3 * m0f2) + (z4 * m0f3) + (z5 * m0f4);
            const double s3 = (s2 + (z6 * m0f5)) / (m0f5 * (m0 - 5.0));
            v = s3 + ((c_5_ * u1_) - u2_);
        } else {
            // Deadbeat.
            const double s4 = (b_1_ * x1) + (b_2_ * x2) + (b_3_ * x3);
            const double s5 = s4 + (b_4_ * x4) + (b_5_ * u1_);
            v = s5 + (b_6_ * u2_);
        }
        if (!finite(v)) {
            return {0.0, Status::Range};
        }
        double u_now{};
        if (v > u_max_) {
            u_now = u_max_;
        } else if (v < -u_max_) {
            u_now = -u_max_;
        } else {
            u_now = v;
        }
        u2_ = u1_;
        u1_ = u_now;
        if ((v > u_max_) || (v < -u_max_)) {
            return {u_now, Status::Saturated};
        } else if (static_cast<double>(left) <= hold_) {
            return {u_now, Status::Hold};
        } else {
            return {u_now, Status::Ok};
        }
    }

private:
    /// std::isfinite is not constexpr in C++17.
    static constexpr bool finite(double v) noexcept
    {
        return (v >= std::numeric_limits<double>::lowest()) && (v <= (std::numeric_limits<double>::max)());
    }
    /// 11/2, samples to go at which deadbeat takes over.
    static constexpr double deadbeat_{5.5};
    /// Weight of u1 in the law.
    static constexpr double c_5_{2.0};
    /// Weight of u1 in the law.
    static constexpr double b_5_{-4.0};
    /// Weight of u2 in the law.
    static constexpr double b_6_{-10.0};

    std::uint32_t start_{}; // tick at which it was armed
    std::uint32_t samples_{}; // samples from the start to rest
    double u1_{}; // input of the last sample
    double u2_{}; // input of 2 samples ago
    double hold_{}; // samples to go at which the gains are held
    double w1_1_{}; // weight of x1 in the law
    double w1_2_{}; // weight of x2 in the law
    double w1_3_{}; // weight of x3 in the law
    double w1_4_{}; // weight of x4 in the law
    double w2_2_{}; // weight of x2 in the law
    double w2_3_{}; // weight of x3 in the law
    double w2_4_{}; // weight of x4 in the law
    double w3_3_{}; // weight of x3 in the law
    double w3_4_{}; // weight of x4 in the law
    double w4_4_{}; // weight of x4 in the law
    double w5_6_{}; // weight of u2 in the law
    double w6_5_{}; // weight of u1 in the law
    double w6_6_{}; // weight of u2 in the law
    double b_1_{}; // weight of x1 in the law
    double b_2_{}; // weight of x2 in the law
    double b_3_{}; // weight of x3 in the law
    double b_4_{}; // weight of x4 in the law
    double u_max_{}; // bound of |u|
};

} // namespace ptc

#endif
