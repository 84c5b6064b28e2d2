/*
 * Prescribed-time controller stage47: order n = 3, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang cpp --n 3 --mu "exp(a=1)" --name stage47 --clock samples --A="[[0,1,0],[0,-0.5,15],[0,-15,-60]]" --B="[0,0,50]" --C="[[1,0,0],[0,0,1]]" --disturbance constant --observer-poles=-4,-5,-6,-7 --observer-samples=20 --after-observer=stationary --disturbance-walk=1/2 --eps=0.06 --poles=-3,-4,-5 --sample-time=0.01 --noise=1e-5,1e-3
 * Version 0.1.0, design bd3303578b4f.
 *
 * Plant: x' = A x + B (u + d), d constant and unknown of --A and --B above; u held from
 *       sample to sample, y = C x.
 * Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
 *       sample period, as long as u is not clipped and nothing else acts on the plant.
 * Law: with M - 2 samples to go and z = S x, the differences of a flat output, u = sum of
 *       row_j z_j/((M-j+1)...(M-2)) less the drift of z; the rows are those of Theorem 1 for
 *       the mapping exp. The gains of 6 samples to go stay.
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
 * The estimates are exact from sample 20 after the start on where the measurement is; from
 *       there on the observer has the gains of the stationary Kalman filter for the noise and
 *       disturbance_walk.
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
#ifndef STAGE47_344E15DE_HPP
#define STAGE47_344E15DE_HPP

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
struct Stage47Params {
    std::uint32_t samples{}; ///< samples N from the start to rest [samples], at least 23
    double u_max{}; ///< bound of |u| [unit of u], > 0, infinity allowed
};

/// Controller: set by init, changed by arm and by what is not const.
class Stage47 {
public:
    using Params = Stage47Params;

    /// Takes the parameters and arms at tick 0. Ok, or Param with nothing changed.
    [[nodiscard]] constexpr Status init(const Params& params) noexcept
    {
        if (!((params.samples > 22U) && (params.u_max > 0.0))) {
            return Status::Param;
        }
        const std::uint32_t samples = params.samples;
        const double u_max = params.u_max;
        start_ = 0U;
        samples_ = samples;
        u1_ = 0.0;
        seen_ = 0U;
        x1_hat_ = 0.0;
        x1_next_ = 0.0;
        x2_hat_ = 0.0;
        x2_next_ = 0.0;
        x3_hat_ = 0.0;
        x3_next_ = 0.0;
        d_hat_ = 0.0;
        d_next_ = 0.0;
        u_max_ = u_max;
        return Status::Ok;
    }

    /// Starts again: the deadline is N samples after tick `k`. Estimates and inputs under way are
    /// kept. Estimates too large to compute with begin anew.
    constexpr void arm(std::uint32_t k) noexcept
    {
        start_ = k;
        const double s1 = absolute(x1_next_) + absolute(x2_next_);
        const double size = s1 + absolute(x3_next_) + absolute(d_next_);
        if (!(size <= 1e150)) {
            seen_ = 0U;
            x1_hat_ = 0.0;
            x1_next_ = 0.0;
            x2_hat_ = 0.0;
            x2_next_ = 0.0;
            x3_hat_ = 0.0;
            x3_next_ = 0.0;
            d_hat_ = 0.0;
            d_next_ = 0.0;
        }
    }

    /// u from tick `k`, which may wrap, and what is measured, y = C x. Call it once for each tick.
    /// On a negative status u is 0 and nothing has changed.
    constexpr Control<double> step(std::uint32_t k, const std::array<double, 2>& y) noexcept
    {
        if (!(finite(y[0]) && finite(y[1]))) {
            return {0.0, Status::Input};
        }
        const std::uint32_t elapsed = k - start_;

        // The estimates; at first what y shows.
        double x1{};
        double x2{};
        double x3{};
        double d{};
        if (seen_ == 0U) {
            x1 = y[0];
            x2 = 0.0;
            x3 = y[1];
            d = 0.0;
        } else {
            x1 = x1_next_ + (gamma1_ * u1_);
            x2 = x2_next_ + (gamma2_ * u1_);
            x3 = x3_next_ + (gamma3_ * u1_);
            d = d_next_;
        }

        // Prediction of the next sample.
        const double miss1 = y[0] - x1;
        const double miss2 = y[1] - x3;
        const double off1 = miss1;
        const double off2 = miss2;
        const std::uint32_t left_o = (elapsed < observer_samples_) ? (observer_samples_ - elapsed) : 0U;
        const double o0 = static_cast<double>(left_o);
        double l1_1{};
        double l1_2{};
        double l1_3{};
        double l1_4{};
        double l2_1{};
        double l2_2{};
        double l2_3{};
        double l2_4{};
        if (left_o == 0U) {
            l1_1 = 0.5288853188994155;
            l1_2 = 11.043581739724111;
            l1_3 = -1.95232951580154;
            l1_4 = -4.310227400623051;
            l2_1 = 0.00186202868892253;
            l2_2 = 0.2724600360147846;
            l2_3 = 1.5302977387244094;
            l2_4 = 2.6662087225258313;
        } else if (o0 > 8.0) {
            const double r0 = 1.0 / (o0 * (o0 - 1.0));
            const double s1 = (q1_1_1_ + (q1_1_2_ * o0)) * r0;
            l1_1 = s1 - 0.004980621942852573;
            const double s2 = (q1_2_1_ + (q1_2_2_ * o0)) * r0;
            l1_2 = s2 + 0.007132886647707467;
            l1_3 = 0.056139026437663865;
            l1_4 = q1_4_1_ * r0;
            l2_1 = 0.0014392695129337434;
            const double s3 = (q2_2_1_ + (q2_2_2_ * o0)) * r0;
            l2_2 = s3 + 0.11089234841732894;
            const double s4 = (q2_3_1_ + (q2_3_2_ * o0)) * r0;
            l2_3 = s4 - 0.4680369753891894;
            l2_4 = q2_4_1_ * r0;
        } else if (left_o == 8U) {
            l1_1 = e0_1_1_;
            l1_2 = e0_1_2_;
            l1_3 = e0_1_3_;
            l1_4 = 0.0;
            l2_1 = e0_2_1_;
            l2_2 = e0_2_2_;
            l2_3 = e0_2_3_;
            l2_4 = e0_2_4_;
        } else {
            l1_1 = e1_1_1_;
            l1_2 = e1_1_2_;
            l1_3 = e1_1_3_;
            l1_4 = e1_1_4_;
            l2_1 = e1_2_1_;
            l2_2 = e1_2_2_;
            l2_3 = e1_2_3_;
            l2_4 = e1_2_4_;
        }
        const double s5 = x1 + (phi1_2_ * x2) + (phi1_3_ * x3);
        const double x1_on = s5 + (phi1_4_ * d) + (l1_1 * off1) + (l2_1 * off2);
        const double s6 = (phi2_2_ * x2) + (phi2_3_ * x3);
        const double x2_on = s6 + (phi2_4_ * d) + (l1_2 * off1) + (l2_2 * off2);
        const double s7 = (phi3_2_ * x2) + (phi3_3_ * x3);
        const double x3_on = s7 + (phi3_4_ * d) + (l1_3 * off1) + (l2_3 * off2);
        const double d_on = d + (l1_4 * off1) + (l2_4 * off2);
        const std::uint32_t left = (elapsed < samples_) ? (samples_ - elapsed) : 0U;
        const double m0 = (static_cast<double>(left) < hold_) ? hold_ : static_cast<double>(left);
        double v{};

        // The exact law in samples.
        const double z1 = (w1_1_ * x1) + (w1_2_ * x2) + (w1_3_ * x3);
        const double z2 = (w2_2_ * x2) + (w2_3_ * x3);
        const double z3 = (w3_2_ * x2) + (w3_3_ * x3);
        const double m0f1 = m0 + 2.0;
        const double m0f2 = m0f1 * (m0 + 1.0);
        const double s8 = (z1 + (z2 * m0f1) + (z3 * m0f2)) / (m0f2 * m0);
        v = (s8 + ((c_2_ * x2) + (c_3_ * x3))) - d;
        if (!(finite(v) && finite(x1_on) && finite(x2_on) && finite(x3_on) && finite(d_on))) {
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
        x1_hat_ = x1;
        x1_next_ = x1_on;
        x2_hat_ = x2;
        x2_next_ = x2_on;
        x3_hat_ = x3;
        x3_next_ = x3_on;
        d_hat_ = d;
        d_next_ = d_on;
        seen_ = 1U;
        if ((v > u_max_) || (v < -u_max_)) {
            return {u_now, Status::Saturated};
        } else if (static_cast<double>(left) <= hold_) {
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
    /// Prediction from u.
    static constexpr double gamma1_{0.00010803832226644697};
    /// Prediction from u.
    static constexpr double gamma2_{0.030892799233141147};
    /// Prediction from u.
    static constexpr double gamma3_{0.3745921515889058};
    /// Samples of the round of the observer.
    static constexpr std::uint32_t observer_samples_{20U};
    /// Weight in the observer's gain l1_1.
    static constexpr double q1_1_1_{-8.0};
    /// Weight in the observer's gain l1_1.
    static constexpr double q1_1_2_{8.0};
    /// Weight in the observer's gain l1_2.
    static constexpr double q1_2_1_{1207.0156938434693};
    /// Weight in the observer's gain l1_2.
    static constexpr double q1_2_2_{-4.007471679722458};
    /// Weight in the observer's gain l1_4.
    static constexpr double q1_4_1_{359.9103398433305};
    /// Weight in the observer's gain l2_2.
    static constexpr double q2_2_1_{-1.8587963031465917};
    /// Weight in the observer's gain l2_2.
    static constexpr double q2_2_2_{0.9913796378212842};
    /// Weight in the observer's gain l2_3.
    static constexpr double q2_3_1_{-12.0};
    /// Weight in the observer's gain l2_3.
    static constexpr double q2_3_2_{12.0};
    /// Weight in the observer's gain l2_4.
    static constexpr double q2_4_1_{79.82759275642569};
    /// Gain of the observer at its end.
    static constexpr double e0_1_1_{0.9950193780571475};
    /// Gain of the observer at its end.
    static constexpr double e0_1_2_{-0.49380107331759976};
    /// Gain of the observer at its end.
    static constexpr double e0_1_3_{0.056139026437663865};
    /// Gain of the observer at its end.
    static constexpr double e0_2_1_{0.0014392695129337434};
    /// Gain of the observer at its end.
    static constexpr double e0_2_2_{0.220357858722901};
    /// Gain of the observer at its end.
    static constexpr double e0_2_3_{1.0319630246108107};
    /// Gain of the observer at its end.
    static constexpr double e0_2_4_{1.3304598792737614};
    /// Gain of the observer at its end.
    static constexpr double e1_1_1_{1.9950193780571475};
    /// Gain of the observer at its end.
    static constexpr double e1_1_2_{99.25595014702932};
    /// Gain of the observer at its end.
    static constexpr double e1_1_3_{0.056139026437663865};
    /// Gain of the observer at its end.
    static constexpr double e1_1_4_{29.992528320277543};
    /// Gain of the observer at its end.
    static constexpr double e1_2_1_{0.0014392695129337434};
    /// Gain of the observer at its end.
    static constexpr double e1_2_2_{0.24720839921003274};
    /// Gain of the observer at its end.
    static constexpr double e1_2_3_{1.5319630246108107};
    /// Gain of the observer at its end.
    static constexpr double e1_2_4_{2.660919758547523};
    /// Prediction of x1 from x2.
    static constexpr double phi1_2_{0.009942671770940647};
    /// Prediction of x1 from x3.
    static constexpr double phi1_3_{0.000617855984662823};
    /// Prediction of x1 from d.
    static constexpr double phi1_4_{0.00010803832226644697};
    /// Prediction of x2 from x2.
    static constexpr double phi2_2_{0.9857608243445873};
    /// Prediction of x2 from x3.
    static constexpr double phi2_3_{0.11206871748434033};
    /// Prediction of x2 from d.
    static constexpr double phi2_4_{0.030892799233141147};
    /// Prediction of x3 from x2.
    static constexpr double phi3_2_{-0.11206871748434033};
    /// Prediction of x3 from x3.
    static constexpr double phi3_3_{0.5412215783233707};
    /// Prediction of x3 from d.
    static constexpr double phi3_4_{0.3745921515889058};
    /// Samples to go at which the gains are held.
    static constexpr double hold_{6.0};
    /// Weight of x1 in the law.
    static constexpr double w1_1_{-106850.90292251826};
    /// Weight of x2 in the law.
    static constexpr double w1_2_{1124.1848178645955};
    /// Weight of x3 in the law.
    static constexpr double w1_3_{-61.894579201640425};
    /// Weight of x2 in the law.
    static constexpr double w2_2_{-642.8726851005619};
    /// Weight of x3 in the law.
    static constexpr double w2_3_{53.018026963569255};
    /// Weight of x2 in the law.
    static constexpr double w3_2_{0.8030787004640786};
    /// Weight of x3 in the law.
    static constexpr double w3_3_{-24.09236101392236};
    /// Weight of x2 in the law.
    static constexpr double c_2_{0.29872942459099683};
    /// Weight of x3 in the law.
    static constexpr double c_3_{1.238117262270095};

    std::uint32_t start_{}; // tick at which it was armed
    std::uint32_t samples_{}; // samples from the start to rest
    double u1_{}; // input of the last sample
    std::uint32_t seen_{}; // 1 once y has been measured
    double x1_hat_{}; // estimate of x1
    double x1_next_{}; // prediction of x1 without u
    double x2_hat_{}; // estimate of x2
    double x2_next_{}; // prediction of x2 without u
    double x3_hat_{}; // estimate of x3
    double x3_next_{}; // prediction of x3 without u
    double d_hat_{}; // estimate of d
    double d_next_{}; // prediction of d without u
    double u_max_{}; // bound of |u|
};

} // namespace ptc

#endif
