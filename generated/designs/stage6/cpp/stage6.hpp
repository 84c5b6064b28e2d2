/*
 * Prescribed-time controller stage6: order n = 3, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang cpp --n 3 --mu "exp(a=0.7)" --name stage6 --clock samples --measured=x1,x2 --observer-poles=-4,-5.3 --eps=0 --f="1/2" --g="2" --sample-time=2e-3
 * Version 0.1.0, design 6c8ba09a0bea.
 *
 * Plant: x1' = x2, ..., x3' = f + g u; u held from sample to sample.
 * Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
 *       sample period, as long as u is not clipped and nothing else acts on the plant.
 * Law: with M samples to go and z = S x, u h^3 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-2));
 *       the rows are those of Theorem 1 for the mapping exp. Close to the end deadbeat takes
 *       over.
 *
 * Parameters:
 *   samples [samples]: samples N from the start to rest
 *   h = 2e-3 [s], fixed: sample period
 *   eps = 0 [s], fixed: time-to-go at which the gains are held
 *   u_max [unit of u]: bound of |u|
 *   a = 0.7 [1/s], fixed: rate of stretched time
 *   k_1 [1/s^3]: gains k_i of pi0 = -sum k_i xi_i
 *   k_2 [1/s^2]: gains k_i of pi0 = -sum k_i xi_i
 *   k_3 [1/s]: gains k_i of pi0 = -sum k_i xi_i
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
#ifndef STAGE6_9CE72CEC_HPP
#define STAGE6_9CE72CEC_HPP

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
struct Stage6Params {
    std::uint32_t samples{}; ///< samples N from the start to rest [samples], at least 6
    double u_max{}; ///< bound of |u| [unit of u], > 0, infinity allowed
    std::array<double, 3> k{}; ///< gains k_i of pi0 = -sum k_i xi_i [1/s^3], finite
    double deadbeat{}; ///< samples to go at which deadbeat takes over, 0 for a safe default [samples], finite
};

/// Controller: set by init, changed by arm and by what is not const.
class Stage6 {
public:
    using Params = Stage6Params;

    /// Takes the parameters and arms at tick 0. Ok, or Param with nothing changed.
    [[nodiscard]] constexpr Status init(const Params& params) noexcept
    {
        if (!((params.samples > 5U)
                && (params.u_max > 0.0)
                && finite(params.k[0])
                && finite(params.k[1])
                && finite(params.k[2])
                && finite(params.deadbeat)
                && (params.deadbeat >= 0.0))) {
            return Status::Param;
        }
        const std::uint32_t samples = params.samples;
        const double s1 = ((params.k[2] / 0.7) - 4.0) + 3.0;
        const double s2 = (s1 < 6.0) ? 6.0 : s1;
        const double deadbeat = (params.deadbeat > 0.0) ? params.deadbeat : s2;
        const double w1_1 = 125000000.0 * (0.5 * (-(params.k[0] / 0.343)));
        const double w1_2 = 250000.0 * ((-0.5) * (-(params.k[0] / 0.343)));
        const double w1_3 = 500.0 * (0.16666666666666666 * (-(params.k[0] / 0.343)));
        const double s3 = 0.5 * (((-1.0) - (params.k[1] / 0.49)) + (params.k[2] / 0.7));
        const double w2_2 = 250000.0 * s3;
        const double s4 = (-0.25) * (((-1.0) - (params.k[1] / 0.49)) + (params.k[2] / 0.7));
        const double w2_3 = 500.0 * s4;
        const double w3_3 = 500.0 * (0.5 * (3.0 - (params.k[2] / 0.7)));
        const double u_max = params.u_max;
        if (!(finite(deadbeat)
                && finite(w1_1)
                && finite(w1_2)
                && finite(w1_3)
                && finite(w2_2)
                && finite(w2_3)
                && finite(w3_3))) {
            return Status::Param;
        }
        start_ = 0U;
        samples_ = samples;
        u1_ = 0.0;
        seen_ = 0U;
        x2_hat_ = 0.0;
        x3_hat_ = 0.0;
        deadbeat_ = deadbeat;
        w1_1_ = w1_1;
        w1_2_ = w1_2;
        w1_3_ = w1_3;
        w2_2_ = w2_2;
        w2_3_ = w2_3;
        w3_3_ = w3_3;
        u_max_ = u_max;
        return Status::Ok;
    }

    /// Starts again: the deadline is N samples after tick `k`. Estimates and inputs under way are
    /// kept. Estimates too large to compute with begin anew.
    constexpr void arm(std::uint32_t k) noexcept
    {
        start_ = k;
        const double size = absolute(x2_hat_) + absolute(x3_hat_);
        if (!(size <= 1e150)) {
            seen_ = 0U;
            x2_hat_ = 0.0;
            x3_hat_ = 0.0;
        }
    }

    /// u from tick `k`, which may wrap, and what is measured, y = (x1, ...). Call it once for each
    /// tick.
    /// On a negative status u is 0 and nothing has changed.
    constexpr Control<double> step(std::uint32_t k, const std::array<double, 2>& y) noexcept
    {
        if (!(finite(y[0]) && finite(y[1]))) {
            return {0.0, Status::Input};
        }
        const std::uint32_t elapsed = k - start_;

        // Predict.
        const double s1 = x2_hat_ + (phi1_2_ * x3_hat_);
        const double p1 = s1 + (gamma1_ * (u1_ + 0.25));
        const double p2 = x3_hat_ + (gamma2_ * (u1_ + 0.25));

        // Correct by what is measured.
        double base{};
        double miss{};
        if (seen_ == 0U) {
            base = y[1];
            miss = 0.0;
        } else {
            base = p1;
            miss = y[1] - p1;
        }
        const std::uint32_t left_o = (elapsed < (samples_ / 2U)) ? ((samples_ / 2U) - elapsed) : 0U;
        const double o0 = static_cast<double>(left_o);
        double l1{};
        double l2{};
        if (o0 > 9.0) {
            const double r0 = 1.0 / (o0 * (o0 - 1.0));
            l1 = (q1_1_ + (q1_2_ * o0)) * r0;
            l2 = q2_1_ * r0;
        } else if (left_o == 9U) {
            l1 = 1.0;
            l2 = e0_2_;
        } else {
            l1 = 1.0;
            l2 = e1_2_;
        }
        const double x1 = y[0];
        const double x2 = base + (l1 * miss);
        const double x3 = p2 + (l2 * miss);
        const std::uint32_t left = (elapsed < samples_) ? (samples_ - elapsed) : 0U;
        const double m0 = static_cast<double>(left);
        double v{};
        if (m0 > deadbeat_) {
            // The exact law in samples.
            const double z1 = (w1_1_ * x1) + (w1_2_ * x2) + (w1_3_ * x3);
            const double z2 = (w2_2_ * x2) + (w2_3_ * x3);
            const double z3 = w3_3_ * x3;
            const double m0f2 = m0 * (m0 - 1.0);
            v = ((z1 + (z2 * m0) + (z3 * m0f2)) / (m0f2 * (m0 - 2.0))) - 0.25;
        } else {
            // Deadbeat.
            const double s2 = (b_1_ * x1) + (b_2_ * x2) + (b_3_ * x3);
            v = s2 - 0.25;
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
        u1_ = u_now;
        x2_hat_ = x2;
        x3_hat_ = x3;
        seen_ = 1U;
        if ((v > u_max_) || (v < -u_max_)) {
            return {u_now, Status::Saturated};
        } else if (elapsed < samples_) {
            return {u_now, Status::Ok};
        } else {
            return {u_now, Status::Hold};
        }
    }

    /// The estimates of x2, ... at the last sample.
    [[nodiscard]] constexpr std::array<double, 2> estimate() const noexcept
    {
        return {{x2_hat_, x3_hat_}};
    }

private:
    /// std::isfinite is not constexpr in C++17.
    static constexpr bool finite(double v) noexcept
    {
        return (v >= std::numeric_limits<double>::lowest()) && (v <= (std::numeric_limits<double>::max)());
    }

    static constexpr double absolute(double v) noexcept
    {
        return (v > 0.0) ? v : (0.0 - v);
    }
    /// 1/500, prediction of x2 from x3.
    static constexpr double phi1_2_{0.002};
    /// 1/250000, prediction from u.
    static constexpr double gamma1_{4e-6};
    /// 1/250, prediction from u.
    static constexpr double gamma2_{0.004};
    /// -2120/49, weight in the observer's gain l1.
    static constexpr double q1_1_{-43.265306122448976};
    /// 86/7, weight in the observer's gain l1.
    static constexpr double q1_2_{12.285714285714286};
    /// 759000/49, weight in the observer's gain l2.
    static constexpr double q2_1_{15489.795918367347};
    /// 11500/63, gain of the observer at its end.
    static constexpr double e0_2_{182.53968253968253};
    /// Gain of the observer at its end.
    static constexpr double e1_2_{500.0};
    /// Weight of x1 in the law.
    static constexpr double b_1_{-62500000.0};
    /// Weight of x2 in the law.
    static constexpr double b_2_{-250000.0};
    /// -1375/3, weight of x3 in the law.
    static constexpr double b_3_{-458.3333333333333};

    std::uint32_t start_{}; // tick at which it was armed
    std::uint32_t samples_{}; // samples from the start to rest
    double u1_{}; // input of the last sample
    std::uint32_t seen_{}; // 1 once y has been measured
    double x2_hat_{}; // estimate of x2
    double x3_hat_{}; // estimate of x3
    double deadbeat_{}; // samples to go at which deadbeat takes over
    double w1_1_{}; // weight of x1 in the law
    double w1_2_{}; // weight of x2 in the law
    double w1_3_{}; // weight of x3 in the law
    double w2_2_{}; // weight of x2 in the law
    double w2_3_{}; // weight of x3 in the law
    double w3_3_{}; // weight of x3 in the law
    double u_max_{}; // bound of |u|
};

} // namespace ptc

#endif
