/*
 * Prescribed-time controller stage23: order n = 3, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang cpp --n 3 --mu "exp(a=1)" --name stage23 --clock samples --A="[[0,1,0],[0,-1,10],[0,-2,-50]]" --B="[0,0,100]" --C="[[1,0,0]]" --output="[1,0,0]" --observer-poles=-4,-5,-6 --observer-samples=25 --tau=0.5 --eps=0 --poles=-4,-5,-6,-7 --reference input --sample-time=0.01 --delay=1
 * Version 0.1.0, design da426a349de3.
 *
 * Plant: x' = A x + B u of --A and --B above; u held from sample to sample, one sample late,
 *       y = C x.
 * Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
 *       sample period, as long as u is not clipped and nothing else acts on the plant.
 * Law: with M - 3 samples to go and z = S x, the differences of a flat output, u = sum of
 *       row_j z_j/((M-j+1)...(M-3)) less the drift of z; the rows are those of Theorem 1 for
 *       the mapping exp. The gains of 4 samples to go stay: they are deadbeat.
 * With the reference r with its derivatives r[0]..r[2] at tick k, x - x_r is in place of x
 *       above, and u = w + u_r, where the inputs under way count less the u_r of their own
 *       samples: with them the output y = x1 is r, and stays so. At sample N x = x_r where
 *       u_r is constant over each sample; else an error of order h^(5-i) is left in y^(i-1).
 * r[3] is r^(3) over the sample in which u acts: its mean, (r^(2)(t + h) - r^(2)(t))/h, or
 *       that in its middle. u_r is the mean over that sample. To four digits, the last at one
 *       time:
 *   x_r1 = r
 *   x_r2 = r^(1)
 *   x_r3 = 0.1*r^(1) + 0.1*r^(2)
 *   u_r = 0.07*r^(1) + 0.051*r^(2) + 0.001*r^(3)
 *
 * Parameters:
 *   samples = 50 [samples], fixed: samples N from the start to rest
 *   h = 0.01 [s], fixed: sample period
 *   eps = 0 [s], fixed: time-to-go at which the gains are held
 *   u_max [unit of u]: bound of |u|
 *   a = 1 [1/s], fixed: rate of stretched time
 *   k_1 = 840 [1/s^4], fixed: gains k_i of pi0 = -sum k_i xi_i
 *   k_2 = 638 [1/s^3], fixed: gains k_i of pi0 = -sum k_i xi_i
 *   k_3 = 179 [1/s^2], fixed: gains k_i of pi0 = -sum k_i xi_i
 *   k_4 = 22 [1/s], fixed: gains k_i of pi0 = -sum k_i xi_i
 *
 * k counts samples and may wrap; arm again within 2^32 - N samples.
 * From sample N on the last gains are held (status HOLD).
 * The estimates are exact from sample 25 after the start on where the measurement is; with
 *       noise or sensor_step given, or observer_eps, the gains of the observer are then held
 *       below deadbeat.
 * |u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
 *       lasts.
 * Guard full: what is measured and the reference are finite, or the call is refused (INPUT).
 * Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
 *       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
 *
 * Checks of the design (details: ptc-codegen check):
 *   membership: sound: exp is of class M for all its parameters.
 *   growth: sound: at rest at sample 50 from any state, but for what r does between samples,
 *       whatever the poles, and |u| is bounded.
 *   sampling: not checked: `loop` bounds what the period leaves of a reference that moves.
 *   deadline: not checked: `loop` bounds what the period leaves of a reference that moves.
 *   loop: not checked: `x0_max` is not given.
 *   envelope: not checked: it does not examine a clock in samples.
 */
#ifndef STAGE23_2FF4BCA9_HPP
#define STAGE23_2FF4BCA9_HPP

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
struct Stage23Params {
    double u_max{}; ///< bound of |u| [unit of u], > 0, infinity allowed
};

/// Controller: set by init, changed by arm and by what is not const.
class Stage23 {
public:
    using Params = Stage23Params;

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
        x1_next_ = 0.0;
        x2_hat_ = 0.0;
        x2_next_ = 0.0;
        x3_hat_ = 0.0;
        x3_next_ = 0.0;
        u_r1_ = 0.0;
        u_max_ = u_max;
        return Status::Ok;
    }

    /// Starts again: the deadline is N samples after tick `k`. Estimates and inputs under way are
    /// kept. Estimates too large to compute with begin anew.
    constexpr void arm(std::uint32_t k) noexcept
    {
        start_ = k;
        const double s1 = absolute(x1_next_) + absolute(x2_next_);
        const double size = s1 + absolute(x3_next_);
        if (!(size <= 1e150)) {
            seen_ = 0U;
            x1_hat_ = 0.0;
            x1_next_ = 0.0;
            x2_hat_ = 0.0;
            x2_next_ = 0.0;
            x3_hat_ = 0.0;
            x3_next_ = 0.0;
        }
    }

    /// u from tick `k`, which may wrap, and what is measured, y = C x, and the reference. Call it
    /// once for each tick.
    /// On a negative status u is 0 and nothing has changed.
    constexpr Control<double> step(std::uint32_t k, const std::array<double, 1>& y, const std::array<double, 4>& r) noexcept
    {
        if (!(finite(y[0]) && finite(r[0]) && finite(r[1]) && finite(r[2]) && finite(r[3]))) {
            return {0.0, Status::Input};
        }
        const std::uint32_t elapsed = k - start_;

        // The estimates; at first what y shows.
        double x1{};
        double x2{};
        double x3{};
        if (seen_ == 0U) {
            x1 = y[0];
            x2 = 0.0;
            x3 = 0.0;
        } else {
            x1 = x1_next_ + (gamma1_ * u2_);
            x2 = x2_next_ + (gamma2_ * u2_);
            x3 = x3_next_ + (gamma3_ * u2_);
        }

        // Prediction of the next sample.
        const double miss1 = y[0] - x1;
        const double off1 = miss1;
        const std::uint32_t left_o = (elapsed < observer_samples_) ? (observer_samples_ - elapsed) : 0U;
        const double o0 = static_cast<double>(left_o);
        double l1{};
        double l2{};
        double l3{};
        if (o0 > 8.0) {
            const double o0f2 = o0 * (o0 - 1.0);
            const double r0 = 1.0 / (o0f2 * (o0 - 2.0));
            const double s1 = (q1_1_ + (q1_2_ * o0) + (q1_3_ * o0f2)) * r0;
            l1 = s1 - 0.4049846310800092;
            const double s2 = (q2_1_ + (q2_2_ * o0) + (q2_3_ * o0f2)) * r0;
            l2 = s2 + 20.107642470674392;
            const double s3 = (q3_1_ + (q3_2_ * o0) + (q3_3_ * o0f2)) * r0;
            l3 = s3 - 97.7033199358119;
        } else if (left_o == 8U) {
            l1 = e0_1_;
            l2 = e0_2_;
            l3 = e0_3_;
        } else if (left_o == 7U) {
            l1 = e1_1_;
            l2 = e1_2_;
            l3 = e1_3_;
        } else {
            l1 = e2_1_;
            l2 = e2_2_;
            l3 = e2_3_;
        }
        const double x1_on = x1 + (phi1_2_ * x2) + (phi1_3_ * x3) + (l1 * off1);
        const double x2_on = (phi2_2_ * x2) + (phi2_3_ * x3) + (l2 * off1);
        const double x3_on = (phi3_2_ * x2) + (phi3_3_ * x3) + (l3 * off1);

        // The tracking error.
        const double u_r = (0.07 * r[1]) + (0.05205 * r[2]) + (0.0017731666666666666 * r[3]);
        const double e1 = x1 - r[0];
        const double e2 = x2 - r[1];
        const double e3 = x3 - ((0.1 * r[1]) + (0.1 * r[2]));
        double v{};
        if (elapsed < 46U) {
            // The exact law in samples.
            const double m0 = static_cast<double>(53U - elapsed);
            const double z1 = (w1_1_ * e1) + (w1_2_ * e2) + (w1_3_ * e3);
            const double z2 = (w2_2_ * e2) + (w2_3_ * e3);
            const double z3 = (w3_2_ * e2) + (w3_3_ * e3);
            const double s4 = w4_4_ * (u1_ - u_r1_);
            const double z4 = (w4_2_ * e2) + (w4_3_ * e3) + s4;
            const double m0f2 = m0 * (m0 - 1.0);
            const double m0f3 = m0f2 * (m0 - 2.0);
            const double s5 = c_4_ * (u1_ - u_r1_);
            const double s6 = (z1 + (z2 * m0) + (z3 * m0f2) + (z4 * m0f3)) / (m0f3 * (m0 - 3.0));
            v = s6 + ((c_2_ * e2) + (c_3_ * e3) + s5) + u_r;
        } else {
            // Deadbeat.
            const double s7 = (b_1_ * e1) + (b_2_ * e2) + (b_3_ * e3);
            v = s7 + (b_4_ * (u1_ - u_r1_)) + u_r;
        }
        if (!(finite(v) && finite(x1_on) && finite(x2_on) && finite(x3_on))) {
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
        u_r1_ = u_r;
        x1_hat_ = x1;
        x1_next_ = x1_on;
        x2_hat_ = x2;
        x2_next_ = x2_on;
        x3_hat_ = x3;
        x3_next_ = x3_on;
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
    /// Prediction from u.
    static constexpr double gamma1_{0.00014736313620654503};
    /// Prediction from u.
    static constexpr double gamma2_{0.04245805872561294};
    /// Prediction from u.
    static constexpr double gamma3_{0.7866781644184895};
    /// Samples of the round of the observer.
    static constexpr std::uint32_t observer_samples_{25U};
    /// Weight in the observer's gain l1.
    static constexpr double q1_1_{24.0};
    /// Weight in the observer's gain l1.
    static constexpr double q1_2_{-24.0};
    /// Weight in the observer's gain l1.
    static constexpr double q1_3_{12.0};
    /// Weight in the observer's gain l2.
    static constexpr double q2_1_{-12098.699806867564};
    /// Weight in the observer's gain l2.
    static constexpr double q2_2_{5834.153087954333};
    /// Weight in the observer's gain l2.
    static constexpr double q2_3_{-616.5581920200482};
    /// Weight in the observer's gain l3.
    static constexpr double q3_1_{90981.25917900148};
    /// Weight in the observer's gain l3.
    static constexpr double q3_2_{-29002.765439771665};
    /// Weight in the observer's gain l3.
    static constexpr double q3_3_{2998.7909601002407};
    /// Gain of the observer at its end.
    static constexpr double e0_1_{1.0950153689199909};
    /// Gain of the observer at its end.
    static constexpr double e0_2_{15.297392853547647};
    /// Gain of the observer at its end.
    static constexpr double e0_3_{98.32269091567703};
    /// Gain of the observer at its end.
    static constexpr double e1_1_{1.309301083205705};
    /// Gain of the observer at its end.
    static constexpr double e1_2_{6.605837883444068};
    /// Gain of the observer at its end.
    static constexpr double e1_3_{-407.1438225313707};
    /// Gain of the observer at its end.
    static constexpr double e2_1_{2.5950153689199906};
    /// Gain of the observer at its end.
    static constexpr double e2_2_{180.07490250022406};
    /// Gain of the observer at its end.
    static constexpr double e2_3_{358.78371927742626};
    /// Prediction of x1 from x2.
    static constexpr double phi1_2_{0.009947226521739929};
    /// Prediction of x1 from x3.
    static constexpr double phi1_3_{0.00042458058725612934};
    /// Prediction of x2 from x2.
    static constexpr double phi2_2_{0.9892036123037478};
    /// Prediction of x2 from x3.
    static constexpr double phi2_3_{0.07824323585459282};
    /// Prediction of x3 from x2.
    static constexpr double phi3_2_{-0.015648647170918566};
    /// Prediction of x3 from x3.
    static constexpr double phi3_3_{0.605811756616243};
    /// Weight of x1 in the law.
    static constexpr double w1_1_{-1072951.6050632286};
    /// Weight of x2 in the law.
    static constexpr double w1_2_{11224.193450693596};
    /// Weight of x3 in the law.
    static constexpr double w1_3_{-404.795716419329};
    /// Weight of x2 in the law.
    static constexpr double w2_2_{-6164.422229232715};
    /// Weight of x3 in the law.
    static constexpr double w2_3_{332.70200299979865};
    /// Weight of x2 in the law.
    static constexpr double w3_2_{15.336789013047456};
    /// Weight of x3 in the law.
    static constexpr double w3_3_{-153.36789013047456};
    /// Weight of u1 in the law.
    static constexpr double w4_4_{-16.0};
    /// Weight of x2 in the law.
    static constexpr double w4_2_{0.29792241063993585};
    /// Weight of x3 in the law.
    static constexpr double w4_3_{8.220775893600642};
    /// Weight of u1 in the law.
    static constexpr double c_4_{1.4049846310800091};
    /// Weight of x2 in the law.
    static constexpr double c_2_{-0.00824128170492625};
    /// Weight of x3 in the law.
    static constexpr double c_3_{-0.20107642470674394};
    /// Weight of x1 in the law.
    static constexpr double b_1_{-1277.3233393609864};
    /// Weight of x2 in the law.
    static constexpr double b_2_{-37.174971411649004};
    /// Weight of x3 in the law.
    static constexpr double b_3_{-3.523659928569286};
    /// Weight of u1 in the law.
    static constexpr double b_4_{-2.5950153689199906};
    /// Samples from the start to rest.
    static constexpr std::uint32_t samples_{50U};

    std::uint32_t start_{}; // tick at which it was armed
    double u1_{}; // input of the last sample
    double u2_{}; // input of 2 samples ago
    std::uint32_t seen_{}; // 1 once y has been measured
    double x1_hat_{}; // estimate of x1
    double x1_next_{}; // prediction of x1 without u
    double x2_hat_{}; // estimate of x2
    double x2_next_{}; // prediction of x2 without u
    double x3_hat_{}; // estimate of x3
    double x3_next_{}; // prediction of x3 without u
    double u_r1_{}; // input on the reference, 1 samples ago
    double u_max_{}; // bound of |u|
};

} // namespace ptc

#endif
