/*
 * Prescribed-time observer drift_observer: order n = 3, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang cpp --n 3 --mu "exp(a=1)" --name drift --what observer --clock samples --measured=x1,x2 --disturbance ramp --observer-poles=-4,-5,-6,-7 --observer-samples=60
 * Version 0.1.0, design 3d13f742d37b.
 *
 * Plant: x1' = x2, ..., x3' = (u + d), d an unknown ramp; u held from sample to sample.
 * Goal: the estimates of the state and of d are exact up to rounding from sample 60 after the
 *       start on, from any state and at any sample period, as long as the measurement is
 *       exact, u is what was applied and nothing else acts on the plant.
 * Observer: xhat(k) = p + L (y(k) - p1), p = Phi xhat(k - 1) + Gamma u with the chain
 *       sampled, Phi and Gamma: the estimates of tick k hold y up to tick k. The gains follow
 *       by duality from the rows that Theorem 1 gives for the mapping exp. Close to the end
 *       deadbeat takes over.
 *
 * Parameters:
 *   h [s]: sample period
 *   a = 1 [1/s], fixed: rate of stretched time
 *
 * k counts samples and may wrap; arm again within 2^32 - 60 samples.
 * u is the input of tick k - 1 as it was applied, after clipping: it acted from tick k - 1 to
 *       tick k.
 * From sample 60 on the status is HOLD; with noise or sensor_step given, or observer_eps, the
 *       gains of the observer are then held below deadbeat.
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
#ifndef DRIFT_OBSERVER_4D3CD772_HPP
#define DRIFT_OBSERVER_4D3CD772_HPP

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
struct DriftObserverParams {
    double h{}; ///< sample period [s], from 1e-150 to 1e150
};

/// Observer: set by init, changed by arm and by what is not const.
class DriftObserver {
public:
    using Params = DriftObserverParams;

    /// Takes the parameters and arms at tick 0. Ok, or Param with nothing changed.
    [[nodiscard]] constexpr Status init(const Params& params) noexcept
    {
        if (!((1e-150 <= params.h) && (params.h <= 1e150))) {
            return Status::Param;
        }
        const double phi1_2 = params.h;
        const double phi1_3 = 0.5 * (params.h * params.h);
        const double phi1_4 = 0.16666666666666666 * (params.h * params.h * params.h);
        const double q2_1 = 908.0 * (1.0 / params.h);
        const double q2_2 = (-432.0) * (1.0 / params.h);
        const double q2_3 = 72.0 * (1.0 / params.h);
        const double q3_1 = (-336.0) * (1.0 / (params.h * params.h));
        const double q3_2 = 96.0 * (1.0 / (params.h * params.h));
        const double q4_1 = 24.0 * (1.0 / (params.h * params.h * params.h));
        const double e3_2 = 1.8333333333333333 * (1.0 / params.h);
        const double e3_3 = 2.0 * (1.0 / (params.h * params.h));
        const double e3_4 = 1.0 / (params.h * params.h * params.h);
        const double e2_2 = 1.1666666666666667 * (1.0 / params.h);
        const double e2_4 = -(1.0 / (params.h * params.h * params.h));
        const double e1_2 = 0.8148148148148148 * (1.0 / params.h);
        const double e1_3 = (-0.2222222222222222) * (1.0 / (params.h * params.h));
        const double s1 = 1.0 / (params.h * params.h * params.h);
        const double e1_4 = 0.4444444444444444 * s1;
        const double e0_2 = 0.4777777777777778 * (1.0 / params.h);
        const double e0_3 = 0.26666666666666666 * (1.0 / (params.h * params.h));
        const double s2 = 1.0 / (params.h * params.h * params.h);
        const double e0_4 = (-0.06666666666666667) * s2;
        if (!(finite(phi1_3)
                && finite(phi1_4)
                && finite(q2_1)
                && finite(q2_2)
                && finite(q2_3)
                && finite(q3_1)
                && finite(q3_2)
                && finite(q4_1)
                && finite(e3_2)
                && finite(e3_3)
                && finite(e3_4)
                && finite(e2_2)
                && finite(e2_4)
                && finite(e1_2)
                && finite(e1_3)
                && finite(e1_4)
                && finite(e0_2)
                && finite(e0_3)
                && finite(e0_4)
                && (params.h * params.h * params.h >= 1e-200)
                && (1.0 / (params.h * params.h * params.h) >= 1e-200))) {
            return Status::Param;
        }
        start_ = 0U;
        seen_ = 0U;
        x2_hat_ = 0.0;
        x3_hat_ = 0.0;
        d_hat_ = 0.0;
        d_rate_hat_ = 0.0;
        phi1_2_ = phi1_2;
        phi1_3_ = phi1_3;
        phi1_4_ = phi1_4;
        q2_1_ = q2_1;
        q2_2_ = q2_2;
        q2_3_ = q2_3;
        q3_1_ = q3_1;
        q3_2_ = q3_2;
        q4_1_ = q4_1;
        e3_2_ = e3_2;
        e3_3_ = e3_3;
        e3_4_ = e3_4;
        e2_2_ = e2_2;
        e2_4_ = e2_4;
        e1_2_ = e1_2;
        e1_3_ = e1_3;
        e1_4_ = e1_4;
        e0_2_ = e0_2;
        e0_3_ = e0_3;
        e0_4_ = e0_4;
        return Status::Ok;
    }

    /// Starts a round of 60 samples at tick `k`. The estimates are kept. Estimates too large to
    /// compute with begin anew.
    constexpr void arm(std::uint32_t k) noexcept
    {
        start_ = k;
        const double s1 = absolute(x2_hat_) + absolute(x3_hat_) + absolute(d_hat_);
        const double size = s1 + absolute(d_rate_hat_);
        if (!(size <= 1e150)) {
            seen_ = 0U;
            x2_hat_ = 0.0;
            x3_hat_ = 0.0;
            d_hat_ = 0.0;
            d_rate_hat_ = 0.0;
        }
    }

    /// The estimates of tick `k`, which may wrap, from what is measured, y = (x1, ...) at that tick
    /// and u, the input of tick `k` - 1 as it was applied, 0 where there was none. Call it once for
    /// each tick, before the law, which takes its estimates. Status Hold from sample 60 on: the
    /// round is over.
    /// On a negative status nothing has changed.
    [[nodiscard]] constexpr Status update(std::uint32_t k, const std::array<double, 2>& y, double u) noexcept
    {
        if (!(finite(y[0]) && finite(y[1]) && finite(u))) {
            return Status::Input;
        }
        const std::uint32_t elapsed = k - start_;

        // Predict.
        const double s1 = x2_hat_ + (phi1_2_ * x3_hat_);
        const double s2 = s1 + (phi1_3_ * d_hat_);
        const double p1 = s2 + (phi1_4_ * d_rate_hat_) + (phi1_3_ * u);
        const double s3 = x3_hat_ + (phi1_2_ * d_hat_);
        const double p2 = s3 + (phi1_3_ * d_rate_hat_) + (phi1_2_ * u);
        const double p3 = d_hat_ + (phi1_2_ * d_rate_hat_);
        const double p4 = d_rate_hat_;

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
            const double s4 = q1_1_ + (q1_2_ * o0) + (q1_3_ * o0f2);
            l1 = (s4 + (q1_4_ * o0f3)) * r0;
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
        const double x2 = base + (l1 * miss);
        const double x3 = p2 + (l2 * miss);
        const double d = p3 + (l3 * miss);
        const double d_rate = p4 + (l4 * miss);
        if (!(finite(x2) && finite(x3) && finite(d) && finite(d_rate))) {
            return Status::Range;
        }
        x2_hat_ = x2;
        x3_hat_ = x3;
        d_hat_ = d;
        d_rate_hat_ = d_rate;
        seen_ = 1U;
        if (left_o == 0U) {
            return Status::Hold;
        } else {
            return Status::Ok;
        }
    }

    /// The estimates of x2, ... at the last sample.
    [[nodiscard]] constexpr std::array<double, 2> estimate() const noexcept
    {
        return {{x2_hat_, x3_hat_}};
    }

    /// The estimate of the ramp that is added to u.
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
    /// Samples of the round of the observer.
    static constexpr std::uint32_t observer_samples_{60U};
    /// Weight in the observer's gain l1.
    static constexpr double q1_1_{-840.0};
    /// Weight in the observer's gain l1.
    static constexpr double q1_2_{480.0};
    /// Weight in the observer's gain l1.
    static constexpr double q1_3_{-120.0};
    /// Weight in the observer's gain l1.
    static constexpr double q1_4_{16.0};

    std::uint32_t start_{}; // tick at which it was armed
    std::uint32_t seen_{}; // 1 once y has been measured
    double x2_hat_{}; // estimate of x2
    double x3_hat_{}; // estimate of x3
    double d_hat_{}; // estimate of d
    double d_rate_hat_{}; // estimate of d_rate
    double phi1_2_{}; // prediction of x2 from x3
    double phi1_3_{}; // prediction of x2 from d
    double phi1_4_{}; // prediction of x2 from d_rate
    double q2_1_{}; // weight in the observer's gain l2
    double q2_2_{}; // weight in the observer's gain l2
    double q2_3_{}; // weight in the observer's gain l2
    double q3_1_{}; // weight in the observer's gain l3
    double q3_2_{}; // weight in the observer's gain l3
    double q4_1_{}; // weight in the observer's gain l4
    double e3_2_{}; // gain of the observer at its end
    double e3_3_{}; // gain of the observer at its end
    double e3_4_{}; // gain of the observer at its end
    double e2_2_{}; // gain of the observer at its end
    double e2_4_{}; // gain of the observer at its end
    double e1_2_{}; // gain of the observer at its end
    double e1_3_{}; // gain of the observer at its end
    double e1_4_{}; // gain of the observer at its end
    double e0_2_{}; // gain of the observer at its end
    double e0_3_{}; // gain of the observer at its end
    double e0_4_{}; // gain of the observer at its end
};

} // namespace ptc

#endif
