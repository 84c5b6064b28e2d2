/*
 * Prescribed-time controller shaken: order n = 2, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang cpp --n 2 --mu "exp(a=1)" --name shaken --clock samples --delay-law=predict --measured=x1 --disturbance="sine(omega=60)" --observer-poles=-4,-5,-6,-7 --observer-samples=200 --observer-eps=0.03 --tau=0.6 --eps=0.01 --u-max=8 --poles="least-energy(weight=1)" --g="2" --sample-time=1e-3 --delay=1.75 --sensor-step=1e-6,0
 * Version 0.1.0, design db5a18285eee.
 *
 * Plant: x1' = x2, x2' = g (u + d), d an unknown sine(omega=60); u held from sample to
 *       sample, 1.75 samples late.
 * Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
 *       sample period, as long as u is not clipped and nothing else acts on the plant. What d
 *       does within a sample remains, of order h^(4-i) in x_i.
 * Law of the state x predicted for the time from which u acts, by x and the inputs under way:
 *       with M samples to go and z = S x, u h^2 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-1));
 *       the rows are those of Theorem 1 for the mapping exp. The gains of 12 samples to go
 *       stay.
 *
 * Parameters:
 *   samples = 600 [samples], fixed: samples N from the start to rest
 *   h = 1e-3 [s], fixed: sample period
 *   eps = 0.01 [s], fixed: time-to-go at which the gains are held
 *   u_max = 8 [unit of u], fixed: bound of |u|
 *   a = 1 [1/s], fixed: rate of stretched time
 *   k_1 = 12 [1/s^2], fixed: gains k_i of pi0 = -sum k_i xi_i
 *   k_2 = 7 [1/s], fixed: gains k_i of pi0 = -sum k_i xi_i
 *
 * k counts samples and may wrap; arm again within 2^32 - N samples.
 * From sample N on the last gains are held (status HOLD).
 * The estimates are exact from sample 200 after the start on where the measurement is; with
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
 *   growth: sound: near rest at sample 600, not at rest: the gains are held from 10 samples
 *       to go, and |u| is bounded; so does what the held observer leaves of its error.
 *   sampling: not checked: the law is exact in samples, at any period.
 *   deadline: not checked: the law is exact in samples, at any period.
 *   loop: not checked: `x0_max` is not given.
 *   envelope: not checked: it does not examine a clock in samples.
 */
#ifndef SHAKEN_E9FD0C3F_HPP
#define SHAKEN_E9FD0C3F_HPP

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
struct ShakenParams {
};

/// Controller: set by init, changed by arm and by what is not const.
class Shaken {
public:
    using Params = ShakenParams;

    /// Takes the parameters and arms at tick 0. Ok, or Param with nothing changed.
    [[nodiscard]] constexpr Status init(const Params&) noexcept
    {
        start_ = 0U;
        u1_ = 0.0;
        u2_ = 0.0;
        u3_ = 0.0;
        seen_ = 0U;
        x1_hat_ = 0.0;
        x2_hat_ = 0.0;
        d_hat_ = 0.0;
        d_rate_hat_ = 0.0;
        return Status::Ok;
    }

    /// Starts again: the deadline is N samples after tick `k`. Estimates and inputs under way are
    /// kept. Estimates too large to compute with begin anew.
    constexpr void arm(std::uint32_t k) noexcept
    {
        start_ = k;
        const double s1 = absolute(x1_hat_) + absolute(x2_hat_) + absolute(d_hat_);
        const double size = s1 + absolute(d_rate_hat_);
        if (!(size <= 1e150)) {
            seen_ = 0U;
            x1_hat_ = 0.0;
            x2_hat_ = 0.0;
            d_hat_ = 0.0;
            d_rate_hat_ = 0.0;
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
        const double s3 = (gamma1_ * u3_) + (late_gamma1_ * u2_);
        const double p1 = s2 + (phi1_4_ * d_rate_hat_) + s3;
        const double s4 = x2_hat_ + (phi2_3_ * d_hat_);
        const double s5 = (gamma2_ * u3_) + (late_gamma2_ * u2_);
        const double p2 = s4 + (phi2_4_ * d_rate_hat_) + s5;
        const double s6 = phi3_4_ * d_rate_hat_;
        const double p3 = (phi3_3_ * d_hat_) + s6;
        const double s7 = phi4_4_ * d_rate_hat_;
        const double p4 = (phi4_3_ * d_hat_) + s7;

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
        const double o0 = (static_cast<double>(left_o) < hold_o_) ? hold_o_ : static_cast<double>(left_o);
        double l1{};
        double l2{};
        double l3{};
        double l4{};
        const double o0f2 = o0 * (o0 - 1.0);
        const double o0f3 = o0f2 * (o0 - 2.0);
        const double r0 = 1.0 / (o0f3 * (o0 - 3.0));
        const double s8 = q1_1_ + (q1_2_ * o0) + (q1_3_ * o0f2);
        l1 = ((s8 + (q1_4_ * o0f3)) * r0) - 3.8011523294569497e-121;
        const double s9 = q2_1_ + (q2_2_ * o0) + (q2_3_ * o0f2);
        l2 = ((s9 + (q2_4_ * o0f3)) * r0) - 3.601080388941686;
        const double s10 = q3_1_ + (q3_2_ * o0) + (q3_3_ * o0f2);
        l3 = ((s10 + (q3_4_ * o0f3)) * r0) + 1.3694003898462869e-117;
        const double s11 = q4_1_ + (q4_2_ * o0) + (q4_3_ * o0f2);
        l4 = ((s11 + (q4_4_ * o0f3)) * r0) + 6481.944700095035;
        const double x1 = base + (l1 * miss);
        const double x2 = p2 + (l2 * miss);
        const double d = p3 + (l3 * miss);
        const double d_rate = p4 + (l4 * miss);

        // The disturbance while each input acts.
        const double d0 = (d0_d_ * d) + (d0_d_rate_ * d_rate);
        const double d1 = (d1_d_ * d) + (d1_d_rate_ * d_rate);
        const double d2 = (d2_d_ * d) + (d2_d_rate_ * d_rate);
        const std::uint32_t left = (elapsed < samples_) ? (samples_ - elapsed) : 0U;
        const double s12 = static_cast<double>(left) - 2.0;
        const double m0 = (s12 < hold_) ? hold_ : s12;
        double v{};

        // The exact law in samples.
        const double s13 = (w1_1_ * x1) + (w1_2_ * x2);
        const double z1 = s13 + (w1_4_ * (u2_ + d2));
        const double s14 = (w2_2_ * x2) + (w2_3_ * (u1_ + d1));
        const double z2 = s14 + (w2_4_ * (u2_ + d2));
        const double m0f1 = m0 + 2.0;
        v = ((z1 + (z2 * m0f1)) / (m0f1 * (m0 + 1.0))) - d0;
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
        u3_ = u2_;
        u2_ = u1_;
        u1_ = u_now;
        x1_hat_ = x1;
        x2_hat_ = x2;
        d_hat_ = d;
        d_rate_hat_ = d_rate;
        seen_ = 1U;
        if ((v > u_max_) || (v < -u_max_)) {
            return {u_now, Status::Saturated};
        } else if (static_cast<double>(left) - 2.0 <= hold_) {
            return {u_now, Status::Hold};
        } else {
            return {u_now, Status::Ok};
        }
    }

    /// The estimate of the state at the last sample.
    [[nodiscard]] constexpr std::array<double, 2> estimate() const noexcept
    {
        return {{x1_hat_, x2_hat_}};
    }

    /// The estimate of the sine that is added to u.
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
    /// Prediction of x1 from d.
    static constexpr double phi1_3_{9.997000359976858e-7};
    /// 3/3200000, prediction from u.
    static constexpr double gamma1_{9.375e-7};
    /// 1/16000000, prediction from u.
    static constexpr double late_gamma1_{6.25e-8};
    /// Prediction of x1 from d_rate.
    static constexpr double phi1_4_{3.3327333847593334e-10};
    /// Prediction of x2 from d.
    static constexpr double phi2_3_{0.001998800215981487};
    /// 3/2000, prediction from u.
    static constexpr double gamma2_{0.0015};
    /// 1/2000, prediction from u.
    static constexpr double late_gamma2_{0.0005};
    /// Prediction of x2 from d_rate.
    static constexpr double phi2_4_{9.997000359976858e-7};
    /// Prediction of d from d_rate.
    static constexpr double phi3_4_{0.0009994001079907434};
    /// Prediction of d from d.
    static constexpr double phi3_3_{0.9982005399352042};
    /// Prediction of d_rate from d_rate.
    static constexpr double phi4_4_{0.9982005399352042};
    /// Prediction of d_rate from d.
    static constexpr double phi4_3_{-3.597840388766676};
    /// Samples of the round of the observer.
    static constexpr std::uint32_t observer_samples_{200U};
    /// Samples to go at which the observer is held.
    static constexpr double hold_o_{30.0};
    /// Weight in the observer's gain l1.
    static constexpr double q1_1_{-840.0};
    /// Weight in the observer's gain l1.
    static constexpr double q1_2_{480.0};
    /// Weight in the observer's gain l1.
    static constexpr double q1_3_{-120.0};
    /// Weight in the observer's gain l1.
    static constexpr double q1_4_{16.0};
    /// Weight in the observer's gain l2.
    static constexpr double q2_1_{907032.0947896534};
    /// Weight in the observer's gain l2.
    static constexpr double q2_2_{-431395.04961199313};
    /// Weight in the observer's gain l2.
    static constexpr double q2_3_{71827.15332755336};
    /// Weight in the observer's gain l2.
    static constexpr double q2_4_{28.808643111533488};
    /// Weight in the observer's gain l3.
    static constexpr double q3_1_{-166538409.07329616};
    /// Weight in the observer's gain l3.
    static constexpr double q3_2_{47150402.59237033};
    /// Weight in the observer's gain l3.
    static constexpr double q3_3_{216000.0};
    /// Weight in the observer's gain l3.
    static constexpr double q3_4_{-28800.0};
    /// Weight in the observer's gain l4.
    static constexpr double q4_1_{10370942877.471207};
    /// Weight in the observer's gain l4.
    static constexpr double q4_2_{776511089.3015876};
    /// Weight in the observer's gain l4.
    static constexpr double q4_3_{-129288875.98959604};
    /// Weight in the observer's gain l4.
    static constexpr double q4_4_{-51855.55760076028};
    /// Weight of d in d0.
    static constexpr double d0_d_{0.990752702693308};
    /// Weight of d_rate in d0.
    static constexpr double d0_d_rate_{0.002242835389486039};
    /// Weight of d in d1.
    static constexpr double d1_d_{0.9970392465203709};
    /// Weight of d_rate in d1.
    static constexpr double d1_d_rate_{0.0012486411387069352};
    /// Weight of d in d2.
    static constexpr double d2_d_{0.9996625341702274};
    /// Weight of d_rate in d2.
    static constexpr double d2_d_rate_{0.0003749367230213299};
    /// Samples from the start to rest.
    static constexpr std::uint32_t samples_{600U};
    /// Samples to go at which the gains are held.
    static constexpr double hold_{10.0};
    /// Weight of x1 in the law.
    static constexpr double w1_1_{-6000000.0};
    /// Weight of x2 in the law.
    static constexpr double w1_2_{-7500.0};
    /// -63/8, weight of u2 in the law.
    static constexpr double w1_4_{-7.875};
    /// Weight of x2 in the law.
    static constexpr double w2_2_{-3000.0};
    /// Weight of u1 in the law.
    static constexpr double w2_3_{-6.0};
    /// -9/2, weight of u2 in the law.
    static constexpr double w2_4_{-4.5};
    /// Bound of |u|.
    static constexpr double u_max_{8.0};

    std::uint32_t start_{}; // tick at which it was armed
    double u1_{}; // input of the last sample
    double u2_{}; // input of 2 samples ago
    double u3_{}; // input of 3 samples ago
    std::uint32_t seen_{}; // 1 once y has been measured
    double x1_hat_{}; // estimate of x1
    double x2_hat_{}; // estimate of x2
    double d_hat_{}; // estimate of d
    double d_rate_hat_{}; // estimate of d_rate
};

} // namespace ptc

#endif
