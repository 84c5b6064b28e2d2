/*
 * Prescribed-time controller stage3: order n = 2, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang cpp --n 2 --mu "exp(a=1)" --name stage3 --clock samples --measured=x1 --disturbance constant --observer-poles=-4,-5,-6 --observer-samples=20 --tau=0.04 --eps=0 --poles=-4,-5,-6 --sample-time=1e-3 --delay=1
 * Version 0.1.0, design f20e905317e3.
 *
 * Plant: x1' = x2, x2' = (u + d), d constant and unknown; u held from sample to sample, one
 *       sample late.
 * Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
 *       sample period, as long as u is not clipped and nothing else acts on the plant.
 * Law: with M - 3 samples to go and z = S x, u h^3 = sum of row_j z_j
 *       h^(j-1)/((M-j+1)...(M-2)); the rows are those of Theorem 1 for the mapping exp. The
 *       gains of 3 samples to go stay: they are deadbeat.
 *
 * Parameters:
 *   samples = 40 [samples], fixed: samples N from the start to rest
 *   h = 1e-3 [s], fixed: sample period
 *   eps = 0 [s], fixed: time-to-go at which the gains are held
 *   u_max [unit of u]: bound of |u|
 *   a = 1 [1/s], fixed: rate of stretched time
 *   k_1 = 120 [1/s^3], fixed: gains k_i of pi0 = -sum k_i xi_i
 *   k_2 = 74 [1/s^2], fixed: gains k_i of pi0 = -sum k_i xi_i
 *   k_3 = 15 [1/s], fixed: gains k_i of pi0 = -sum k_i xi_i
 *
 * k counts samples and may wrap; arm again within 2^32 - N samples.
 * From sample N on the last gains are held (status HOLD).
 * The estimates are exact from sample 20 after the start on where the measurement is; with
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
 *   growth: sound: at rest at sample 40 from any state, whatever the poles, and |u| is
 *       bounded.
 *   sampling: not checked: the law is exact in samples, at any period.
 *   deadline: not checked: the law is exact in samples, at any period.
 *   loop: not checked: `x0_max` is not given.
 *   envelope: not checked: it does not examine a clock in samples.
 */
#ifndef STAGE3_6DE6E194_HPP
#define STAGE3_6DE6E194_HPP

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
struct Stage3Params {
    double u_max{}; ///< bound of |u| [unit of u], > 0, infinity allowed
};

/// Controller: set by init, changed by arm and by what is not const.
class Stage3 {
public:
    using Params = Stage3Params;

    /// Takes the parameters and arms at tick 0. Ok, or Param with nothing changed.
    [[nodiscard]] constexpr Status init(const Params& params) noexcept
    {
        if (!(params.u_max > 0.0)) {
            return Status::Param;
        }
        const double u_max = params.u_max;
        start_ = 0U;
        u1_ = 0.0;
        u2_ = 0.0;
        seen_ = 0U;
        x1_hat_ = 0.0;
        x2_hat_ = 0.0;
        d_hat_ = 0.0;
        u_max_ = u_max;
        return Status::Ok;
    }

    /// Starts again: the deadline is N samples after tick `k`. Estimates and inputs under way are
    /// kept. Estimates too large to compute with begin anew.
    constexpr void arm(std::uint32_t k) noexcept
    {
        start_ = k;
        const double size = absolute(x1_hat_) + absolute(x2_hat_) + absolute(d_hat_);
        if (!(size <= 1e150)) {
            seen_ = 0U;
            x1_hat_ = 0.0;
            x2_hat_ = 0.0;
            d_hat_ = 0.0;
        }
    }

    /// u from tick `k`, which may wrap, and what is measured, y = (x1, ...). Call it once for each
    /// tick.
    /// On a negative status u is 0 and nothing has changed.
    constexpr Control<double> step(std::uint32_t k, const std::array<double, 1>& y) noexcept
    {
        if (!finite(y[0])) {
            return {0.0, Status::Input};
        }
        const std::uint32_t elapsed = k - start_;

        // Predict.
        const double s1 = x1_hat_ + (phi1_2_ * x2_hat_);
        const double s2 = s1 + (phi1_3_ * d_hat_);
        const double p1 = s2 + (gamma1_ * u2_);
        const double s3 = x2_hat_ + (phi2_3_ * d_hat_);
        const double p2 = s3 + (gamma2_ * u2_);
        const double p3 = d_hat_;

        // Correct by what is measured.
        double base{};
        double miss{};
        if (seen_ == 0U) {
            base = y[0];
            miss = 0.0;
        } else {
            base = p1;
            miss = y[0] - p1;
        }
        const std::uint32_t left_o = (elapsed < observer_samples_) ? (observer_samples_ - elapsed) : 0U;
        const double o0 = static_cast<double>(left_o);
        double l1{};
        double l2{};
        double l3{};
        if (o0 > 8.0) {
            const double o0f2 = o0 * (o0 - 1.0);
            const double r0 = 1.0 / (o0f2 * (o0 - 2.0));
            l1 = (q1_1_ + (q1_2_ * o0) + (q1_3_ * o0f2)) * r0;
            l2 = (q2_1_ + (q2_2_ * o0)) * r0;
            l3 = q3_1_ * r0;
        } else if (left_o == 8U) {
            l1 = 1.0;
            l2 = e0_2_;
            l3 = e0_3_;
        } else if (left_o == 7U) {
            l1 = 1.0;
            l2 = e1_2_;
            l3 = e1_3_;
        } else {
            l1 = 1.0;
            l2 = e2_2_;
            l3 = e2_3_;
        }
        const double x1 = base + (l1 * miss);
        const double x2 = p2 + (l2 * miss);
        const double d = p3 + (l3 * miss);
        double v{};

        // The exact law in samples.
        const double m0 = (elapsed < 37U) ? (static_cast<double>(43U - elapsed)) : 6.0;
        const double z1 = (w1_1_ * x1) + (w1_2_ * x2);
        const double z2 = w2_2_ * x2;
        const double z3 = w3_3_ * (u1_ + d);
        const double m0f2 = m0 * (m0 - 1.0);
        const double s4 = (z1 + (z2 * m0) + (z3 * m0f2)) / (m0f2 * (m0 - 2.0));
        v = (s4 + (u1_ + d)) - d;
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
        x1_hat_ = x1;
        x2_hat_ = x2;
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
    [[nodiscard]] constexpr std::array<double, 2> estimate() const noexcept
    {
        return {{x1_hat_, x2_hat_}};
    }

    /// The estimate of the constant that is added to u.
    [[nodiscard]] constexpr double disturbance() const noexcept
    {
        return d_hat_;
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
    /// 1/1000, prediction of x1 from x2.
    static constexpr double phi1_2_{0.001};
    /// 1/2000000, prediction of x1 from d.
    static constexpr double phi1_3_{5e-7};
    /// 1/2000000, prediction from u.
    static constexpr double gamma1_{5e-7};
    /// 1/1000, prediction of x2 from d.
    static constexpr double phi2_3_{0.001};
    /// 1/1000, prediction from u.
    static constexpr double gamma2_{0.001};
    /// Samples of the round of the observer.
    static constexpr std::uint32_t observer_samples_{20U};
    /// Weight in the observer's gain l1.
    static constexpr double q1_1_{120.0};
    /// Weight in the observer's gain l1.
    static constexpr double q1_2_{-60.0};
    /// Weight in the observer's gain l1.
    static constexpr double q1_3_{12.0};
    /// Weight in the observer's gain l2.
    static constexpr double q2_1_{-108000.0};
    /// Weight in the observer's gain l2.
    static constexpr double q2_2_{36000.0};
    /// Weight in the observer's gain l3.
    static constexpr double q3_1_{24000000.0};
    /// 3000/7, gain of the observer at its end.
    static constexpr double e0_2_{428.57142857142856};
    /// 1000000/7, gain of the observer at its end.
    static constexpr double e0_3_{142857.14285714287};
    /// 6000/7, gain of the observer at its end.
    static constexpr double e1_2_{857.1428571428571};
    /// -2000000/7, gain of the observer at its end.
    static constexpr double e1_3_{-285714.28571428574};
    /// Gain of the observer at its end.
    static constexpr double e2_2_{1500.0};
    /// Gain of the observer at its end.
    static constexpr double e2_3_{1000000.0};
    /// Weight of x1 in the law.
    static constexpr double w1_1_{-120000000.0};
    /// Weight of x2 in the law.
    static constexpr double w1_2_{60000.0};
    /// Weight of x2 in the law.
    static constexpr double w2_2_{-60000.0};
    /// Weight of u1 in the law.
    static constexpr double w3_3_{-12.0};
    /// Samples from the start to rest.
    static constexpr std::uint32_t samples_{40U};

    std::uint32_t start_{}; // tick at which it was armed
    double u1_{}; // input of the last sample
    double u2_{}; // input of 2 samples ago
    std::uint32_t seen_{}; // 1 once y has been measured
    double x1_hat_{}; // estimate of x1
    double x2_hat_{}; // estimate of x2
    double d_hat_{}; // estimate of d
    double u_max_{}; // bound of |u|
};

} // namespace ptc

#endif
