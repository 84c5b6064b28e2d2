/*
 * Prescribed-time filter stop_filter: order n = 2, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang cpp --n 2 --name stop --what filter --keep-below=0.5,0.8 --keep-above=-0.5,-0.8 --keep-poles=-10,-40 --tau=0.4 --u-max=10 --sample-time=1e-3
 * Version 0.1.0, design 74c45379c0da.
 *
 * Plant: x1' = x2, x2' = u; u held from sample to sample.
 * Goal: -0.5 <= x1 <= 0.5, -0.8 <= x2 <= 0.8, at and between all samples, under any
 *       controller, from every state from which that is possible and as long as nothing else
 *       acts on the plant.
 * Filter: with the control points z = S x of the trajectory, q_0 = z_i and q_j = (Delta +
 *       a_(i+j-1)) q_(j-1), with the rates a_i = (1 - exp(p_i h))/h of the poles -10, -40
 *       1/s. In this cone all states are safe: x_i stays within its bound b as long as all
 *       q_j are within b a_i...a_(i+j-1), j < n+1-i; the last of them, in which u occurs, is
 *       the limit of u.
 * From any other state u is held to the law least-energy of the chain of each x_i less its
 *       bound too, so that x_i is within it at the latest N samples after the last safe one,
 *       as long as neither the limits of u nor those by other bounds are in the way.
 *
 * Parameters:
 *   samples = 400 [samples], fixed: samples N in which a state outside returns
 *   h = 1e-3 [s], fixed: sample period
 *   u_max = 10 [unit of u], fixed: bound of |u|
 *
 * k counts samples and may wrap; call step at least once within 2^32 - N samples.
 * u is u_nominal where no bound is near (status OK), and else the nearest that they allow
 *       (SATURATED).
 * INFEASIBLE: the state is not safe, or not all bounds can be kept: those of x1 go before
 *       those of x2 and so on, the limits of u before all.
 * |u| <= u_max: u is clipped to it (status SATURATED). This goes before all bounds.
 * Guard full: x and u_nominal are finite, or the call is refused (INPUT).
 * Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
 *       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
 *
 * Checks of the design (details: ptc-codegen check):
 *   membership: sound: exp is of class M for all its parameters.
 *   growth: not checked: a filter has no law.
 *   sampling: not checked: a filter has no law.
 *   deadline: not checked: a filter has no law.
 *   loop: sound: from every safe state the bounds are kept at and between all samples, and no
 *       limit is in the way.
 *   envelope: not checked: a filter has no law.
 */
#ifndef STOP_FILTER_7A1582FE_HPP
#define STOP_FILTER_7A1582FE_HPP

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
struct StopFilterParams {
};

/// Filter: set by init, changed by arm and by what is not const.
class StopFilter {
public:
    using Params = StopFilterParams;

    /// Takes the parameters and arms at tick 0. Ok, or Param with nothing changed.
    [[nodiscard]] constexpr Status init(const Params&) noexcept
    {
        start_ = 0U;
        return Status::Ok;
    }

    /// From tick `k` on a state outside has N samples to return.
    constexpr void arm(std::uint32_t k) noexcept
    {
        start_ = k;
    }

    /// u_nominal as it is, or as near to it as the bounds allow, from tick `k`, which may wrap, and
    /// the state x = (x1, x1', ...).
    /// On a negative status u is 0 and nothing has changed.
    constexpr Control<double> step(std::uint32_t k, const std::array<double, 2>& x, double u_nominal) noexcept
    {
        if (!(finite(x[0]) && finite(x[1]) && finite(u_nominal))) {
            return {0.0, Status::Input};
        }
        const double x1 = x[0];
        const double x2 = x[1];
        const double z1 = x1 + (s1_2_ * x2);
        const double z2 = x2;

        // The limits of u that keep a safe state safe.
        const double q1_1 = z2 + (9.950166250831947 * z1);
        const double q1_2 = (49.16072709850874 * z2) + (390.1515992227461 * z1);
        double low1 = (-195.07579961137304) - q1_2;
        double high1 = 195.07579961137304 - q1_2;
        const double q2_1 = 39.21056084767679 * z2;
        double low2 = (-31.368448678141434) - q2_1;
        double high2 = 31.368448678141434 - q2_1;
        std::uint32_t since = start_;
        std::uint32_t safe = 1U;
        if ((-0.5000000004656613 <= z1)
            && (z1 <= 0.5000000004656613)
            && (-4.975083130049381 <= q1_1)
            && (q1_1 <= 4.975083130049381)
            && (-0.8000000007450581 <= z2)
            && (z2 <= 0.8000000007450581)) {
            since = k;
        } else {
            safe = 0U;

            // Outside: u is held to the law of return too.
            const double left = static_cast<double>(((k - since) < 400U) ? (400U - (k - since)) : 0U);
            const double t1 = (left < 2.0) ? 2.0 : left;
            const double law1 = ((((-6000000.0) * z1) / (t1 + 1.0)) - (4000.0 * z2)) / t1;
            const double weight1 = ((-6000000.0) / (t1 + 1.0)) / t1;
            const double low1_back = law1 - ((-0.5) * weight1);
            if (low1 < low1_back) {
                low1 = low1_back;
            }
            const double high1_back = law1 - (0.5 * weight1);
            if (high1_back < high1) {
                high1 = high1_back;
            }
            const double t2 = (left < 1.0) ? 1.0 : left;
            const double law2 = ((-1000.0) * z2) / t2;
            const double weight2 = (-1000.0) / t2;
            const double low2_back = law2 - ((-0.8) * weight2);
            if (low2 < low2_back) {
                low2 = low2_back;
            }
            const double high2_back = law2 - (0.8 * weight2);
            if (high2_back < high2) {
                high2 = high2_back;
            }
        }

        // u within them, the bounds of x1 last.
        double u_now = u_nominal;
        if (u_now < low2) {
            u_now = low2;
        }
        if (high2 < u_now) {
            u_now = high2;
        }
        if (u_now < low1) {
            u_now = low1;
        }
        if (high1 < u_now) {
            u_now = high1;
        }
        if (u_now > u_max_) {
            u_now = u_max_;
        }
        if (u_now < -u_max_) {
            u_now = -u_max_;
        }
        if (!(finite(u_now) && finite(low1) && finite(high1) && finite(low2) && finite(high2))) {
            return {0.0, Status::Range};
        }
        start_ = since;
        if ((safe == 0U) || (high2 + 2.9214144384620184e-8 < u_now) || (u_now < low2 - 2.9214144384620184e-8) || (high1 + 1.816784959392371e-7 < u_now) || (u_now < low1 - 1.816784959392371e-7)) {
            return {u_now, Status::Infeasible};
        } else if ((u_now < u_nominal) || (u_nominal < u_now)) {
            return {u_now, Status::Saturated};
        } else {
            return {u_now, Status::Ok};
        }
    }

private:
    /// std::isfinite is not constexpr in C++17.
    static constexpr bool finite(double v) noexcept
    {
        return (v >= std::numeric_limits<double>::lowest()) && (v <= (std::numeric_limits<double>::max)());
    }
    /// -1/2000, weight of x2 in the law.
    static constexpr double s1_2_{-0.0005};
    /// Bound of |u|.
    static constexpr double u_max_{10.0};

    std::uint32_t start_{}; // tick of the last safe sample, or of `arm`
};

} // namespace ptc

#endif
