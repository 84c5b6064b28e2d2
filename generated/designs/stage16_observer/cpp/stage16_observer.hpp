/*
 * Prescribed-time observer stage16_observer: order n = 3, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang cpp --n 3 --mu "exp(a=1)" --name stage16 --what observer --clock samples --A="[[0,1,0],[0,-0.5,1500],[0,-15,-600]]" --B="[0,0,500]" --C="[[1,0,0],[0,0,1]]" --disturbance constant --observer-poles=-4,-5,-6,-7 --observer-samples=20 --after-observer=-90+20i,-90-20i,-100,-120 --sample-time=1e-3 --delay=1
 * Version 0.1.0, design 76c16d95e916.
 *
 * Plant: x' = A x + B (u + d), d constant and unknown of --A and --B above; u held from
 *       sample to sample, one sample late, y = C x.
 * Goal: the estimates of the state and of d are exact up to rounding from sample 20 after the
 *       start on, from any state and at any sample period, as long as the measurement is
 *       exact, u is what was applied and nothing else acts on the plant.
 * Observer: xhat(k) = Phi xhat(k - 1) + Gamma u + G (y(k - 1) - C xhat(k - 1)) with the plant
 *       sampled, Phi and Gamma: the estimates of tick k hold y up to tick k - 1. The gains
 *       follow by duality from the rows that Theorem 1 gives for the mapping exp. Close to
 *       the end deadbeat takes over.
 *
 * Parameters:
 *   h = 1e-3 [s], fixed: sample period
 *   a = 1 [1/s], fixed: rate of stretched time
 *
 * k counts samples and may wrap; arm again within 2^32 - 20 samples.
 * u is the input of tick k - 1 as it was applied, after clipping: it acts from tick k to tick
 *       k + 1, and the observer keeps it until then.
 * From sample 20 on the status is HOLD; from there on the observer has the poles
 *       after_observer.
 * Guard full: what is measured and u are finite, or the call is refused (INPUT).
 * Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
 *       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
 *
 * Checks of the design (details: ptc-codegen check):
 *   membership: sound: exp is of class M for all its parameters.
 *   growth: not checked: an observer alone has no law.
 *   sampling: not checked: an observer alone has no law.
 *   deadline: not checked: an observer alone has no law.
 *   loop: not checked: an observer alone has no law.
 *   envelope: not checked: an observer alone has no law.
 */
#ifndef STAGE16_OBSERVER_4188989A_HPP
#define STAGE16_OBSERVER_4188989A_HPP

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
struct Stage16ObserverParams {
};

/// Observer: set by init, changed by arm and by what is not const.
class Stage16Observer {
public:
    using Params = Stage16ObserverParams;

    /// Takes the parameters and arms at tick 0. Ok, or Param with nothing changed.
    [[nodiscard]] constexpr Status init(const Params&) noexcept
    {
        start_ = 0U;
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
        return Status::Ok;
    }

    /// Starts a round of 20 samples at tick `k`. Estimates and inputs under way are kept. Estimates
    /// too large to compute with begin anew.
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

    /// The estimates of tick `k`, which may wrap, from what is measured, y = C x at that tick and
    /// u, the input of tick `k` - 1 as it was applied, 0 where there was none. y of tick `k` shows
    /// in the estimates from the next tick on. Call it once for each tick, before the law, which
    /// takes its estimates. Status Hold from sample 20 on: the round is over.
    /// On a negative status nothing has changed.
    [[nodiscard]] constexpr Status update(std::uint32_t k, const std::array<double, 2>& y, double u) noexcept
    {
        if (!(finite(y[0]) && finite(y[1]) && finite(u))) {
            return Status::Input;
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
            l1_1 = 0.17200400622757925;
            l1_2 = 7.693835124666324;
            l1_3 = 0.005627803367048088;
            l1_4 = 0.23319622641969587;
            l2_1 = 0.0014420897963740578;
            l2_2 = 1.2843129003368876;
            l2_3 = -0.2598303207324358;
            l2_4 = 0.028634005234458536;
        } else if (o0 > 8.0) {
            const double r0 = 1.0 / (o0 * (o0 - 1.0));
            const double s1 = (q1_1_1_ + (q1_1_2_ * o0)) * r0;
            l1_1 = s1 - 0.0004991835184862197;
            const double s2 = (q1_2_1_ + (q1_2_2_ * o0)) * r0;
            l1_2 = s2 + 0.004899465284856127;
            l1_3 = 0.005627803367048088;
            l1_4 = q1_4_1_ * r0;
            l2_1 = 0.0014420897963740578;
            const double s3 = (q2_2_1_ + (q2_2_2_ * o0)) * r0;
            l2_2 = s3 + 1.1153817526860825;
            const double s4 = (q2_3_1_ + (q2_3_2_ * o0)) * r0;
            l2_3 = s4 - 0.46807246597931873;
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
        if (!(finite(x1)
                && finite(x1_on)
                && finite(x2)
                && finite(x2_on)
                && finite(x3)
                && finite(x3_on)
                && finite(d)
                && finite(d_on))) {
            return Status::Range;
        }
        u1_ = u;
        x1_hat_ = x1;
        x1_next_ = x1_on;
        x2_hat_ = x2;
        x2_next_ = x2_on;
        x3_hat_ = x3;
        x3_next_ = x3_on;
        d_hat_ = d;
        d_next_ = d_on;
        seen_ = 1U;
        if (left_o == 0U) {
            return Status::Hold;
        } else {
            return Status::Ok;
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
    static constexpr double gamma1_{0.00010816330676811052};
    /// Prediction from u.
    static constexpr double gamma2_{0.30941358230147875};
    /// Prediction from u.
    static constexpr double gamma3_{0.37459048481653323};
    /// Samples of the round of the observer.
    static constexpr std::uint32_t observer_samples_{20U};
    /// Weight in the observer's gain l1_1.
    static constexpr double q1_1_1_{-8.0};
    /// Weight in the observer's gain l1_1.
    static constexpr double q1_1_2_{8.0};
    /// Weight in the observer's gain l1_2.
    static constexpr double q1_2_1_{12007.013438558752};
    /// Weight in the observer's gain l1_2.
    static constexpr double q1_2_2_{-4.007472019404232};
    /// Weight in the observer's gain l1_4.
    static constexpr double q1_4_1_{359.9910335767149};
    /// Weight in the observer's gain l2_2.
    static constexpr double q2_2_1_{-18.578489051610646};
    /// Weight in the observer's gain l2_2.
    static constexpr double q2_2_2_{9.913794744612098};
    /// Weight in the observer's gain l2_3.
    static constexpr double q2_3_1_{-12.0};
    /// Weight in the observer's gain l2_3.
    static constexpr double q2_3_2_{12.0};
    /// Weight in the observer's gain l2_4.
    static constexpr double q2_4_1_{79.8275894892242};
    /// Gain of the observer at its end.
    static constexpr double e0_1_1_{0.9995008164815138};
    /// Gain of the observer at its end.
    static constexpr double e0_1_2_{-0.4960345371406728};
    /// Gain of the observer at its end.
    static constexpr double e0_1_3_{0.005627803367048088};
    /// Gain of the observer at its end.
    static constexpr double e0_2_1_{0.0014420897963740578};
    /// Gain of the observer at its end.
    static constexpr double e0_2_2_{2.2101945239792857};
    /// Gain of the observer at its end.
    static constexpr double e0_2_3_{1.0319275340206813};
    /// Gain of the observer at its end.
    static constexpr double e0_2_4_{1.3304598248204031};
    /// Gain of the observer at its end.
    static constexpr double e1_1_1_{1.9995008164815138};
    /// Gain of the observer at its end.
    static constexpr double e1_1_2_{999.2535286720462};
    /// Gain of the observer at its end.
    static constexpr double e1_1_3_{0.005627803367048088};
    /// Gain of the observer at its end.
    static constexpr double e1_1_4_{29.999252798059576};
    /// Gain of the observer at its end.
    static constexpr double e1_2_1_{0.0014420897963740578};
    /// Gain of the observer at its end.
    static constexpr double e1_2_2_{2.4788577332214805};
    /// Gain of the observer at its end.
    static constexpr double e1_2_3_{1.5319275340206813};
    /// Gain of the observer at its end.
    static constexpr double e1_2_4_{2.6609196496408063};
    /// Prediction of x1 from x2.
    static constexpr double phi1_2_{0.000996505559752715};
    /// Prediction of x1 from x3.
    static constexpr double phi1_3_{0.0006188271646029575};
    /// Prediction of x1 from d.
    static constexpr double phi1_4_{0.00010816330676811052};
    /// Prediction of x2 from x2.
    static constexpr double phi2_2_{0.9902193397510792};
    /// Prediction of x2 from x3.
    static constexpr double phi2_3_{1.1234620408672982};
    /// Prediction of x2 from d.
    static constexpr double phi2_4_{0.30941358230147875};
    /// Prediction of x3 from x2.
    static constexpr double phi3_2_{-0.011234620408672982};
    /// Prediction of x3 from x3.
    static constexpr double phi3_3_{0.5412090107511158};
    /// Prediction of x3 from d.
    static constexpr double phi3_4_{0.37459048481653323};

    std::uint32_t start_{}; // tick at which it was armed
    double u1_{}; // input of 2 samples ago
    std::uint32_t seen_{}; // 1 once y has been measured
    double x1_hat_{}; // estimate of x1
    double x1_next_{}; // prediction of x1 without u
    double x2_hat_{}; // estimate of x2
    double x2_next_{}; // prediction of x2 without u
    double x3_hat_{}; // estimate of x3
    double x3_next_{}; // prediction of x3 without u
    double d_hat_{}; // estimate of d
    double d_next_{}; // prediction of d without u
};

} // namespace ptc

#endif
