/*
 * Prescribed-time controller stage43: order n = 3, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang cpp --n 3 --mu "exp(a=1)" --name stage43 --clock samples --delay-law=predict --measured=x1 --disturbance constant --observer-poles=-4,-5,-6,-7 --observer-samples=20 --tau=0.4 --eps=0 --u-max=6 --poles="least-energy(weight=1)" --reference="t^2/2" --sample-time=1e-2 --delay=2.75
 * Version 0.1.0, design c760bae9e1f5.
 *
 * Plant: x1' = x2, ..., x3' = (u + d), d constant and unknown; u held from sample to sample,
 *       2.75 samples late.
 * Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
 *       sample period, as long as u is not clipped and nothing else acts on the plant.
 * Law of the state x predicted for the time from which u acts, by x and the inputs under way:
 *       with M samples to go and z = S x, u h^3 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-2));
 *       the rows are those of Theorem 1 for the mapping exp. The gains of 6 samples to go
 *       stay: they are deadbeat.
 * With the reference r, e_i = x_i - r^(i-1) is in place of x_i above, and u = w + rho/g,
 *       where the inputs under way count less the rho of their own samples. At sample N e is
 *       0 where r^(n) is constant over each sample; else an error of order h^(5-i) is left in
 *       e_i.
 * t counts from the tick at which it was armed, and rho is r^(n) in the middle of the time in
 *       which u acts:
 *   e_i = x_i - r^(i-1), with the reference r = t^2/2
 *   r^(1) = t
 *   r^(2) = 1
 *
 * Parameters:
 *   samples = 40 [samples], fixed: samples N from the start to rest
 *   h = 1e-2 [s], fixed: sample period
 *   eps = 0 [s], fixed: time-to-go at which the gains are held
 *   u_max = 6 [unit of u], fixed: bound of |u|
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
 *   growth: sound: at rest at sample 40 from any state, but for what r does between samples,
 *       whatever the poles, and |u| is bounded.
 *   sampling: not checked: `loop` bounds what the period leaves of a reference that moves.
 *   deadline: not checked: `loop` bounds what the period leaves of a reference that moves.
 *   loop: not checked: `x0_max` is not given.
 *   envelope: not checked: it does not examine a clock in samples.
 */
#ifndef STAGE43_C1F1CE85_HPP
#define STAGE43_C1F1CE85_HPP

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
struct Stage43Params {
};

/// Controller: set by init, changed by arm and by what is not const.
class Stage43 {
public:
    using Params = Stage43Params;

    /// Takes the parameters and arms at tick 0. Ok, or Param with nothing changed.
    [[nodiscard]] constexpr Status init(const Params&) noexcept
    {
        start_ = 0U;
        u1_ = 0.0;
        u2_ = 0.0;
        u3_ = 0.0;
        u4_ = 0.0;
        seen_ = 0U;
        x1_hat_ = 0.0;
        x2_hat_ = 0.0;
        x3_hat_ = 0.0;
        d_hat_ = 0.0;
        return Status::Ok;
    }

    /// Starts again: the deadline is N samples after tick `k`. The time of the reference counts
    /// from there. Estimates and inputs under way are kept. Estimates too large to compute with
    /// begin anew.
    constexpr void arm(std::uint32_t k) noexcept
    {
        start_ = k;
        const double s1 = absolute(x1_hat_) + absolute(x2_hat_) + absolute(x3_hat_);
        const double size = s1 + absolute(d_hat_);
        if (!(size <= 1e150)) {
            seen_ = 0U;
            x1_hat_ = 0.0;
            x2_hat_ = 0.0;
            x3_hat_ = 0.0;
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
        const double s2 = s1 + (phi1_3_ * x3_hat_);
        const double s3 = (gamma1_ * u4_) + (late_gamma1_ * u3_);
        const double p1 = s2 + (phi1_4_ * d_hat_) + s3;
        const double s4 = x2_hat_ + (phi2_3_ * x3_hat_);
        const double s5 = (gamma2_ * u4_) + (late_gamma2_ * u3_);
        const double p2 = s4 + (phi2_4_ * d_hat_) + s5;
        const double s6 = (gamma3_ * u4_) + (late_gamma3_ * u3_);
        const double p3 = x3_hat_ + (phi3_4_ * d_hat_) + s6;
        const double p4 = d_hat_;

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
        double l4{};
        if (o0 > 10.0) {
            const double o0f2 = o0 * (o0 - 1.0);
            const double o0f3 = o0f2 * (o0 - 2.0);
            const double r0 = 1.0 / (o0f3 * (o0 - 3.0));
            const double s7 = q1_1_ + (q1_2_ * o0) + (q1_3_ * o0f2);
            l1 = (s7 + (q1_4_ * o0f3)) * r0;
            l2 = (q2_1_ + (q2_2_ * o0) + (q2_3_ * o0f2)) * r0;
            l3 = (q3_1_ + (q3_2_ * o0)) * r0;
            l4 = q4_1_ * r0;
        } else if (left_o == 10U) {
            l1 = 1.0;
            l2 = e0_2_;
            l3 = e0_3_;
            l4 = e0_4_;
        } else if (left_o == 9U) {
            l1 = 1.0;
            l2 = e1_2_;
            l3 = e1_3_;
            l4 = e1_4_;
        } else if (left_o == 8U) {
            l1 = 1.0;
            l2 = e2_2_;
            l3 = 0.0;
            l4 = e2_4_;
        } else {
            l1 = 1.0;
            l2 = e3_2_;
            l3 = e3_3_;
            l4 = e3_4_;
        }
        const double x1 = base + (l1 * miss);
        const double x2 = p2 + (l2 * miss);
        const double x3 = p3 + (l3 * miss);
        const double d = p4 + (l4 * miss);

        // The tracking error.
        const double t = static_cast<double>(elapsed) * h_;
        const double reference1 = t;
        const double reference0 = reference1 * reference1 * 0.5;
        const double e1 = x1 - reference0;
        const double e2 = x2 - reference1;
        const double e3 = x3 - 1.0;
        double v{};

        // The exact law in samples.
        const double m0 = (elapsed < 34U) ? (static_cast<double>(40U - elapsed)) : 6.0;
        const double s8 = (w1_1_ * e1) + (w1_2_ * e2) + (w1_3_ * e3);
        const double z1 = s8 + (w1_6_ * (u3_ + d));
        const double s9 = (w2_2_ * e2) + (w2_3_ * e3);
        const double s10 = s9 + (w2_5_ * (u2_ + d));
        const double z2 = s10 + (w2_6_ * (u3_ + d));
        const double s11 = (w3_3_ * e3) + (w3_4_ * (u1_ + d));
        const double s12 = s11 + (w3_5_ * (u2_ + d));
        const double z3 = s12 + (w3_6_ * (u3_ + d));
        const double m0f2 = m0 * (m0 - 1.0);
        v = ((z1 + (z2 * m0) + (z3 * m0f2)) / (m0f2 * (m0 - 2.0))) - d;
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
        u4_ = u3_;
        u3_ = u2_;
        u2_ = u1_;
        u1_ = u_now;
        x1_hat_ = x1;
        x2_hat_ = x2;
        x3_hat_ = x3;
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
    [[nodiscard]] constexpr std::array<double, 3> estimate() const noexcept
    {
        return {{x1_hat_, x2_hat_, x3_hat_}};
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
    /// 1/100, prediction of x1 from x2.
    static constexpr double phi1_2_{0.01};
    /// 1/20000, prediction of x1 from x3.
    static constexpr double phi1_3_{5e-5};
    /// 21/128000000, prediction from u.
    static constexpr double gamma1_{1.640625e-7};
    /// 1/384000000, prediction from u.
    static constexpr double late_gamma1_{2.604166666666667e-9};
    /// 1/6000000, prediction of x1 from d.
    static constexpr double phi1_4_{1.6666666666666668e-7};
    /// 1/100, prediction of x2 from x3.
    static constexpr double phi2_3_{0.01};
    /// 3/64000, prediction from u.
    static constexpr double gamma2_{4.6875e-5};
    /// 1/320000, prediction from u.
    static constexpr double late_gamma2_{3.125e-6};
    /// 1/20000, prediction of x2 from d.
    static constexpr double phi2_4_{5e-5};
    /// 3/400, prediction from u.
    static constexpr double gamma3_{0.0075};
    /// 1/400, prediction from u.
    static constexpr double late_gamma3_{0.0025};
    /// 1/100, prediction of x3 from d.
    static constexpr double phi3_4_{0.01};
    /// Samples of the round of the observer.
    static constexpr std::uint32_t observer_samples_{20U};
    /// Weight in the observer's gain l1.
    static constexpr double q1_1_{-840.0};
    /// Weight in the observer's gain l1.
    static constexpr double q1_2_{480.0};
    /// Weight in the observer's gain l1.
    static constexpr double q1_3_{-120.0};
    /// Weight in the observer's gain l1.
    static constexpr double q1_4_{16.0};
    /// Weight in the observer's gain l2.
    static constexpr double q2_1_{90800.0};
    /// Weight in the observer's gain l2.
    static constexpr double q2_2_{-43200.0};
    /// Weight in the observer's gain l2.
    static constexpr double q2_3_{7200.0};
    /// Weight in the observer's gain l3.
    static constexpr double q3_1_{-3360000.0};
    /// Weight in the observer's gain l3.
    static constexpr double q3_2_{960000.0};
    /// Weight in the observer's gain l4.
    static constexpr double q4_1_{24000000.0};
    /// 430/9, gain of the observer at its end.
    static constexpr double e0_2_{47.77777777777778};
    /// 8000/3, gain of the observer at its end.
    static constexpr double e0_3_{2666.6666666666665};
    /// -200000/3, gain of the observer at its end.
    static constexpr double e0_4_{-66666.66666666667};
    /// 2200/27, gain of the observer at its end.
    static constexpr double e1_2_{81.48148148148148};
    /// -20000/9, gain of the observer at its end.
    static constexpr double e1_3_{-2222.222222222222};
    /// 4000000/9, gain of the observer at its end.
    static constexpr double e1_4_{444444.44444444444};
    /// 350/3, gain of the observer at its end.
    static constexpr double e2_2_{116.66666666666667};
    /// Gain of the observer at its end.
    static constexpr double e2_4_{-1000000.0};
    /// 550/3, gain of the observer at its end.
    static constexpr double e3_2_{183.33333333333334};
    /// Gain of the observer at its end.
    static constexpr double e3_3_{20000.0};
    /// Gain of the observer at its end.
    static constexpr double e3_4_{1000000.0};
    /// 1/100, sample period.
    static constexpr double h_{0.01};
    /// Weight of x1 in the law.
    static constexpr double w1_1_{-120000000.0};
    /// Weight of x2 in the law.
    static constexpr double w1_2_{-2100000.0};
    /// Weight of x3 in the law.
    static constexpr double w1_3_{-16375.0};
    /// -1155/16, weight of u3 in the law.
    static constexpr double w1_6_{-72.1875};
    /// Weight of x2 in the law.
    static constexpr double w2_2_{-600000.0};
    /// Weight of x3 in the law.
    static constexpr double w2_3_{-13500.0};
    /// Weight of u2 in the law.
    static constexpr double w2_5_{-60.0};
    /// -675/8, weight of u3 in the law.
    static constexpr double w2_6_{-84.375};
    /// Weight of x3 in the law.
    static constexpr double w3_3_{-1200.0};
    /// Weight of u1 in the law.
    static constexpr double w3_4_{-12.0};
    /// Weight of u2 in the law.
    static constexpr double w3_5_{-12.0};
    /// Weight of u3 in the law.
    static constexpr double w3_6_{-9.0};
    /// Bound of |u|.
    static constexpr double u_max_{6.0};
    /// Samples from the start to rest.
    static constexpr std::uint32_t samples_{40U};

    std::uint32_t start_{}; // tick at which it was armed
    double u1_{}; // input of the last sample
    double u2_{}; // input of 2 samples ago
    double u3_{}; // input of 3 samples ago
    double u4_{}; // input of 4 samples ago
    std::uint32_t seen_{}; // 1 once y has been measured
    double x1_hat_{}; // estimate of x1
    double x2_hat_{}; // estimate of x2
    double x3_hat_{}; // estimate of x3
    double d_hat_{}; // estimate of d
};

} // namespace ptc

#endif
