/*
 * Prescribed-time observer stage14_observer: order n = 3, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang cpp --n 3 --mu "exp(a=1)" --name stage14 --what observer --clock samples --measured=x1 --observer-poles=-4,-5+i,-5-i --observer-samples=12
 * Version 0.1.0, design d1ea1cd2ee5c.
 *
 * Plant: x1' = x2, ..., x3' = u; u held from sample to sample.
 * Goal: the estimates of the state are exact up to rounding from sample 12 after the start
 *       on, from any state and at any sample period, as long as the measurement is exact, u
 *       is what was applied and nothing else acts on the plant.
 * Observer: xhat(k) = p + L (y(k) - p1), p = Phi xhat(k - 1) + Gamma u with the chain
 *       sampled, Phi and Gamma: the estimates of tick k hold y up to tick k. The gains follow
 *       by duality from the rows that Theorem 1 gives for the mapping exp. Close to the end
 *       deadbeat takes over.
 *
 * Parameters:
 *   h [s]: sample period
 *   a = 1 [1/s], fixed: rate of stretched time
 *
 * k counts samples and may wrap; arm again within 2^32 - 12 samples.
 * u is the input of tick k - 1 as it was applied, after clipping: it acted from tick k - 1 to
 *       tick k.
 * From sample 12 on the status is HOLD; with noise or sensor_step given, or observer_eps, the
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
#ifndef STAGE14_OBSERVER_8D5482C0_HPP
#define STAGE14_OBSERVER_8D5482C0_HPP

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
struct Stage14ObserverParams {
    double h{}; ///< sample period [s], from 1e-150 to 1e150
};

/// Observer: set by init, changed by arm and by what is not const.
class Stage14Observer {
public:
    using Params = Stage14ObserverParams;

    /// Takes the parameters and arms at tick 0. Ok, or Param with nothing changed.
    [[nodiscard]] constexpr Status init(const Params& params) noexcept
    {
        if (!((1e-150 <= params.h) && (params.h <= 1e150))) {
            return Status::Param;
        }
        const double phi1_2 = params.h;
        const double phi1_3 = 0.5 * (params.h * params.h);
        const double gamma1 = 0.16666666666666666 * (params.h * params.h * params.h);
        const double q2_1 = (-92.0) * (1.0 / params.h);
        const double q2_2 = 31.0 * (1.0 / params.h);
        const double q3_1 = 20.0 * (1.0 / (params.h * params.h));
        const double e2_2 = 1.5 * (1.0 / params.h);
        const double e2_3 = 1.0 / (params.h * params.h);
        const double e1_2 = 0.9166666666666666 * (1.0 / params.h);
        const double e1_3 = (-0.16666666666666666) * (1.0 / (params.h * params.h));
        const double e0_2 = 0.4880952380952381 * (1.0 / params.h);
        const double e0_3 = 0.16666666666666666 * (1.0 / (params.h * params.h));
        if (!(finite(phi1_3)
                && finite(gamma1)
                && finite(q2_1)
                && finite(q2_2)
                && finite(q3_1)
                && finite(e2_2)
                && finite(e2_3)
                && finite(e1_2)
                && finite(e1_3)
                && finite(e0_2)
                && finite(e0_3)
                && (params.h * params.h * params.h >= 1e-200)
                && (1.0 / (params.h * params.h * params.h) >= 1e-200))) {
            return Status::Param;
        }
        start_ = 0U;
        seen_ = 0U;
        x1_hat_ = 0.0;
        x2_hat_ = 0.0;
        x3_hat_ = 0.0;
        phi1_2_ = phi1_2;
        phi1_3_ = phi1_3;
        gamma1_ = gamma1;
        q2_1_ = q2_1;
        q2_2_ = q2_2;
        q3_1_ = q3_1;
        e2_2_ = e2_2;
        e2_3_ = e2_3;
        e1_2_ = e1_2;
        e1_3_ = e1_3;
        e0_2_ = e0_2;
        e0_3_ = e0_3;
        return Status::Ok;
    }

    /// Starts a round of 12 samples at tick `k`. The estimates are kept. Estimates too large to
    /// compute with begin anew.
    constexpr void arm(std::uint32_t k) noexcept
    {
        start_ = k;
        const double size = absolute(x1_hat_) + absolute(x2_hat_) + absolute(x3_hat_);
        if (!(size <= 1e150)) {
            seen_ = 0U;
            x1_hat_ = 0.0;
            x2_hat_ = 0.0;
            x3_hat_ = 0.0;
        }
    }

    /// The estimates of tick `k`, which may wrap, from what is measured, y = (x1, ...) at that tick
    /// and u, the input of tick `k` - 1 as it was applied, 0 where there was none. Call it once for
    /// each tick, before the law, which takes its estimates. Status Hold from sample 12 on: the
    /// round is over.
    /// On a negative status nothing has changed.
    [[nodiscard]] constexpr Status update(std::uint32_t k, const std::array<double, 1>& y, double u) noexcept
    {
        if (!(finite(y[0]) && finite(u))) {
            return Status::Input;
        }
        const std::uint32_t elapsed = k - start_;

        // Predict.
        const double s1 = x1_hat_ + (phi1_2_ * x2_hat_);
        const double p1 = s1 + (phi1_3_ * x3_hat_) + (gamma1_ * u);
        const double s2 = x2_hat_ + (phi1_2_ * x3_hat_);
        const double p2 = s2 + (phi1_3_ * u);
        const double p3 = x3_hat_ + (phi1_2_ * u);

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
        if (o0 > 7.0) {
            const double o0f2 = o0 * (o0 - 1.0);
            const double r0 = 1.0 / (o0f2 * (o0 - 2.0));
            l1 = (q1_1_ + (q1_2_ * o0) + (q1_3_ * o0f2)) * r0;
            l2 = (q2_1_ + (q2_2_ * o0)) * r0;
            l3 = q3_1_ * r0;
        } else if (left_o == 7U) {
            l1 = 1.0;
            l2 = e0_2_;
            l3 = e0_3_;
        } else if (left_o == 6U) {
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
        const double x3 = p3 + (l3 * miss);
        if (!(finite(x1) && finite(x2) && finite(x3))) {
            return Status::Range;
        }
        x1_hat_ = x1;
        x2_hat_ = x2;
        x3_hat_ = x3;
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
    static constexpr std::uint32_t observer_samples_{12U};
    /// Weight in the observer's gain l1.
    static constexpr double q1_1_{104.0};
    /// Weight in the observer's gain l1.
    static constexpr double q1_2_{-53.0};
    /// Weight in the observer's gain l1.
    static constexpr double q1_3_{11.0};

    std::uint32_t start_{}; // tick at which it was armed
    std::uint32_t seen_{}; // 1 once y has been measured
    double x1_hat_{}; // estimate of x1
    double x2_hat_{}; // estimate of x2
    double x3_hat_{}; // estimate of x3
    double phi1_2_{}; // prediction of x1 from x2
    double phi1_3_{}; // prediction of x1 from x3
    double gamma1_{}; // prediction from u
    double q2_1_{}; // weight in the observer's gain l2
    double q2_2_{}; // weight in the observer's gain l2
    double q3_1_{}; // weight in the observer's gain l3
    double e2_2_{}; // gain of the observer at its end
    double e2_3_{}; // gain of the observer at its end
    double e1_2_{}; // gain of the observer at its end
    double e1_3_{}; // gain of the observer at its end
    double e0_2_{}; // gain of the observer at its end
    double e0_3_{}; // gain of the observer at its end
};

} // namespace ptc

#endif
