/*
 * Prescribed-time controller stage44: order n = 3, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang cpp --n 3 --mu "exp(a=1)" --name stage44 --clock samples --A="[[0,1,0],[0,-0.5,15],[0,-15,-60]]" --B="[0,0,50]" --C="[[1,0,0]]" --delay-law=predict --observer-poles=-4,-5,-6 --eps=0.06 --poles=-3,-4,-5 --sample-time=0.01 --delay=1.5
 * Version 0.1.0, design 985c02d3ad50.
 *
 * Plant: x' = A x + B u of --A and --B above; u held from sample to sample, 1.5 samples late,
 *       y = C x.
 * Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
 *       sample period, as long as u is not clipped and nothing else acts on the plant.
 * Law of the state x predicted for the time from which u acts, by x and the inputs under way:
 *       with M samples to go and z = S x, the differences of a flat output, u = sum of row_j
 *       z_j/((M-j+1)...(M-2)) less the drift of z; the rows are those of Theorem 1 for the
 *       mapping exp. The gains of 8 samples to go stay.
 *
 * Parameters:
 *   samples [samples]: samples N from the start to rest
 *   h = 0.01 [s], fixed: sample period
 *   eps = 0.06 [s], fixed: time-to-go at which the gains are held
 *   u_max [unit of u]: bound of |u|
 *   a = 1 [1/s], fixed: rate of stretched time
 *   k_1 = 60 [1/s^3], fixed: gains k_i of pi0 = -sum k_i xi_i
 *   k_2 = 47 [1/s^2], fixed: gains k_i of pi0 = -sum k_i xi_i
 *   k_3 = 12 [1/s], fixed: gains k_i of pi0 = -sum k_i xi_i
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
 *   growth: sound: near rest at sample N, not at rest: the gains are held from 6 samples to
 *       go, and |u| is bounded.
 *   sampling: not checked: the law is exact in samples, at any period.
 *   deadline: not checked: the law is exact in samples, at any period.
 *   loop: not checked: `samples` is left to run time.
 *   envelope: not checked: it does not examine a clock in samples.
 */
#ifndef STAGE44_D7199B5B_HPP
#define STAGE44_D7199B5B_HPP

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
struct Stage44Params {
    std::uint32_t samples{}; ///< samples N from the start to rest [samples], at least 10
    double u_max{}; ///< bound of |u| [unit of u], > 0, infinity allowed
};

/// Controller: set by init, changed by arm and by what is not const.
class Stage44 {
public:
    using Params = Stage44Params;

    /// Takes the parameters and arms at tick 0. Ok, or Param with nothing changed.
    [[nodiscard]] constexpr Status init(const Params& params) noexcept
    {
        if (!((params.samples > 9U) && (params.u_max > 0.0))) {
            return Status::Param;
        }
        const std::uint32_t samples = params.samples;
        const double u_max = params.u_max;
        start_ = 0U;
        samples_ = samples;
        u1_ = 0.0;
        u2_ = 0.0;
        u3_ = 0.0;
        seen_ = 0U;
        x1_hat_ = 0.0;
        x1_next_ = 0.0;
        x2_hat_ = 0.0;
        x2_next_ = 0.0;
        x3_hat_ = 0.0;
        x3_next_ = 0.0;
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

    /// u from tick `k`, which may wrap, and what is measured, y = C x. Call it once for each tick.
    /// On a negative status u is 0 and nothing has changed.
    constexpr Control<double> step(std::uint32_t k, const std::array<double, 1>& y) noexcept
    {
        if (!finite(y[0])) {
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
            const double s1 = (gamma1_ * u3_) + (late_gamma1_ * u2_);
            x1 = x1_next_ + s1;
            const double s2 = (gamma2_ * u3_) + (late_gamma2_ * u2_);
            x2 = x2_next_ + s2;
            const double s3 = (gamma3_ * u3_) + (late_gamma3_ * u2_);
            x3 = x3_next_ + s3;
        }

        // Prediction of the next sample.
        const double miss1 = y[0] - x1;
        const double off1 = miss1;
        const std::uint32_t left_o = (elapsed < (samples_ / 2U)) ? ((samples_ / 2U) - elapsed) : 0U;
        const double o0 = static_cast<double>(left_o);
        double l1{};
        double l2{};
        double l3{};
        if (o0 > 8.0) {
            const double o0f2 = o0 * (o0 - 1.0);
            const double r0 = 1.0 / (o0f2 * (o0 - 2.0));
            const double s4 = (q1_1_ + (q1_2_ * o0) + (q1_3_ * o0f2)) * r0;
            l1 = s4 - 0.47301759733204196;
            const double s5 = (q2_1_ + (q2_2_ * o0) + (q2_3_ * o0f2)) * r0;
            l2 = s5 + 26.72716299730578;
            const double s6 = (q3_1_ + (q3_2_ * o0) + (q3_3_ * o0f2)) * r0;
            l3 = s6 - 98.86735283457841;
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
        const std::uint32_t left = (elapsed < samples_) ? (samples_ - elapsed) : 0U;
        const double s7 = static_cast<double>(left) - 2.0;
        const double m0 = (s7 < hold_) ? hold_ : s7;
        double v{};

        // The exact law in samples.
        const double s8 = (w1_1_ * x1) + (w1_2_ * x2) + (w1_3_ * x3);
        const double z1 = s8 + (w1_4_ * u1_) + (w1_5_ * u2_);
        const double s9 = (w2_2_ * x2) + (w2_3_ * x3);
        const double z2 = s9 + (w2_4_ * u1_) + (w2_5_ * u2_);
        const double s10 = (w3_2_ * x2) + (w3_3_ * x3);
        const double z3 = s10 + (w3_4_ * u1_) + (w3_5_ * u2_);
        const double m0f1 = m0 + 2.0;
        const double m0f2 = m0f1 * (m0 + 1.0);
        const double s11 = (c_2_ * x2) + (c_3_ * x3);
        const double s12 = s11 + (c_4_ * u1_) + (c_5_ * u2_);
        v = ((z1 + (z2 * m0f1) + (z3 * m0f2)) / (m0f2 * m0)) + s12;
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
        u3_ = u2_;
        u2_ = u1_;
        u1_ = u_now;
        x1_hat_ = x1;
        x1_next_ = x1_on;
        x2_hat_ = x2;
        x2_next_ = x2_on;
        x3_hat_ = x3;
        x3_next_ = x3_on;
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
    static constexpr double gamma1_{9.353143640028875e-5};
    /// Prediction from u.
    static constexpr double late_gamma1_{1.4506885866158227e-5};
    /// Prediction from u.
    static constexpr double gamma2_{0.02240015856569381};
    /// Prediction from u.
    static constexpr double late_gamma2_{0.008492640667447336};
    /// Prediction from u.
    static constexpr double gamma3_{0.15880933131841984};
    /// Prediction from u.
    static constexpr double late_gamma3_{0.21578282027048595};
    /// Weight in the observer's gain l1.
    static constexpr double q1_1_{24.0};
    /// Weight in the observer's gain l1.
    static constexpr double q1_2_{-24.0};
    /// Weight in the observer's gain l1.
    static constexpr double q1_3_{12.0};
    /// Weight in the observer's gain l2.
    static constexpr double q2_1_{-12889.952685745366};
    /// Weight in the observer's gain l2.
    static constexpr double q2_2_{6304.212917508586};
    /// Weight in the observer's gain l2.
    static constexpr double q2_3_{-742.8703573620571};
    /// Weight in the observer's gain l3.
    static constexpr double q3_1_{72521.99132748511};
    /// Weight in the observer's gain l3.
    static constexpr double q3_2_{-24808.851670034343};
    /// Weight in the observer's gain l3.
    static constexpr double q3_3_{2767.4814294482285};
    /// Gain of the observer at its end.
    static constexpr double e0_1_{1.026982402667958};
    /// Gain of the observer at its end.
    static constexpr double e0_2_{9.393065010983802};
    /// Gain of the observer at its end.
    static constexpr double e0_3_{72.1724949708503};
    /// Gain of the observer at its end.
    static constexpr double e1_1_{1.2412681169536723};
    /// Gain of the observer at its end.
    static constexpr double e1_2_{-0.9955098611216602};
    /// Gain of the observer at its end.
    static constexpr double e1_3_{-271.5264302640074};
    /// Gain of the observer at its end.
    static constexpr double e2_1_{2.526982402667958};
    /// Gain of the observer at its end.
    static constexpr double e2_2_{168.91277532831796};
    /// Gain of the observer at its end.
    static constexpr double e2_3_{171.81438886235838};
    /// Prediction of x1 from x2.
    static constexpr double phi1_2_{0.009942671770940647};
    /// Prediction of x1 from x3.
    static constexpr double phi1_3_{0.000617855984662823};
    /// Prediction of x2 from x2.
    static constexpr double phi2_2_{0.9857608243445873};
    /// Prediction of x2 from x3.
    static constexpr double phi2_3_{0.11206871748434033};
    /// Prediction of x3 from x2.
    static constexpr double phi3_2_{-0.11206871748434033};
    /// Prediction of x3 from x3.
    static constexpr double phi3_3_{0.5412215783233707};
    /// Samples to go at which the gains are held.
    static constexpr double hold_{6.0};
    /// Weight of x1 in the law.
    static constexpr double w1_1_{-106850.90292251826};
    /// Weight of x2 in the law.
    static constexpr double w1_2_{-482.3692808208648};
    /// Weight of x3 in the law.
    static constexpr double w1_3_{4.807633485406011};
    /// Weight of u1 in the law.
    static constexpr double w1_4_{-1.2197801784387233e-74};
    /// Weight of u2 in the law.
    static constexpr double w1_5_{4.609258112111791};
    /// Weight of x2 in the law.
    static constexpr double w2_2_{-633.6322203514217};
    /// Weight of x3 in the law.
    static constexpr double w2_3_{-73.36956899710586};
    /// Weight of u1 in the law.
    static constexpr double w2_4_{-1.2733281521282373e-76};
    /// Weight of u2 in the law.
    static constexpr double w2_5_{-14.786896717013052};
    /// Weight of x2 in the law.
    static constexpr double w3_2_{4.311208496599377};
    /// Weight of x3 in the law.
    static constexpr double w3_3_{-9.337493806987991};
    /// Weight of u1 in the law.
    static constexpr double w3_4_{-9.0};
    /// Weight of u2 in the law.
    static constexpr double w3_5_{-2.7645844206856207};
    /// Weight of x2 in the law.
    static constexpr double c_2_{0.10945032226632541};
    /// Weight of x3 in the law.
    static constexpr double c_3_{0.5296658086896372};
    /// Weight of u1 in the law.
    static constexpr double c_4_{0.47301759733204196};
    /// Weight of u2 in the law.
    static constexpr double c_5_{0.15314166966017376};

    std::uint32_t start_{}; // tick at which it was armed
    std::uint32_t samples_{}; // samples from the start to rest
    double u1_{}; // input of the last sample
    double u2_{}; // input of 2 samples ago
    double u3_{}; // input of 3 samples ago
    std::uint32_t seen_{}; // 1 once y has been measured
    double x1_hat_{}; // estimate of x1
    double x1_next_{}; // prediction of x1 without u
    double x2_hat_{}; // estimate of x2
    double x2_next_{}; // prediction of x2 without u
    double x3_hat_{}; // estimate of x3
    double x3_next_{}; // prediction of x3 without u
    double u_max_{}; // bound of |u|
};

} // namespace ptc

#endif
