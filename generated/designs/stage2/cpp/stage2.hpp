/*
 * Prescribed-time controller stage2: order n = 3, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang cpp --n 3 --mu "exp(a=1)" --name stage2 --clock samples --guard none --tau=0.02 --eps=0 --u-max=inf --poles=-4,-5,-6 --sample-time=1e-3
 * Version 0.1.0, design 75680df23c07.
 *
 * Plant: x1' = x2, ..., x3' = u; u held from sample to sample.
 * Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
 *       sample period, as long as u is not clipped and nothing else acts on the plant.
 * Law: with M - 3 samples to go and z = S x, u h^3 = sum of row_j z_j
 *       h^(j-1)/((M-j+1)...(M-2)); the rows are those of Theorem 1 for the mapping exp. The
 *       gains of 3 samples to go stay: they are deadbeat.
 *
 * Parameters:
 *   samples = 20 [samples], fixed: samples N from the start to rest
 *   h = 1e-3 [s], fixed: sample period
 *   eps = 0 [s], fixed: time-to-go at which the gains are held
 *   u_max = inf [unit of u], fixed: bound of |u|
 *   a = 1 [1/s], fixed: rate of stretched time
 *   k_1 = 120 [1/s^3], fixed: gains k_i of pi0 = -sum k_i xi_i
 *   k_2 = 74 [1/s^2], fixed: gains k_i of pi0 = -sum k_i xi_i
 *   k_3 = 15 [1/s], fixed: gains k_i of pi0 = -sum k_i xi_i
 *
 * k counts samples and may wrap; arm again within 2^32 - N samples.
 * From sample N on the last gains are held (status HOLD).
 * u is not clipped.
 * Guard none: finite measurements are the responsibility of the caller.
 * Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
 *       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
 *
 * Checks of the design (details: ptc-codegen check):
 *   membership: sound: exp is of class M for all its parameters.
 *   growth: sound: at rest at sample 20 from any state, whatever the poles, and |u| is
 *       bounded.
 *   sampling: not checked: the law is exact in samples, at any period.
 *   deadline: not checked: the law is exact in samples, at any period.
 *   loop: not checked: `x0_max` is not given.
 *   envelope: not checked: it does not examine a clock in samples.
 */
#ifndef STAGE2_3E27E1AB_HPP
#define STAGE2_3E27E1AB_HPP

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
struct Stage2Params {
};

/// Controller: set by init, changed by arm and by what is not const.
class Stage2 {
public:
    using Params = Stage2Params;

    /// Takes the parameters and arms at tick 0. Ok, or Param with nothing changed.
    [[nodiscard]] constexpr Status init(const Params&) noexcept
    {
        start_ = 0U;
        return Status::Ok;
    }

    /// Starts again: the deadline is N samples after tick `k`.
    constexpr void arm(std::uint32_t k) noexcept
    {
        start_ = k;
    }

    /// u from tick `k`, which may wrap, and the state x = (x1, x1', ...).
    /// On a negative status u is 0 and nothing has changed.
    constexpr Control<double> step(std::uint32_t k, const std::array<double, 3>& x) const noexcept
    {
        const std::uint32_t elapsed = k - start_;
        const double x1 = x[0];
        const double x2 = x[1];
        const double x3 = x[2];
        double v{};

        // The exact law in samples.
        const double m0 = (elapsed < 17U) ? (static_cast<double>(23U - elapsed)) : 6.0;
        const double z1 = (w1_1_ * x1) + (w1_2_ * x2) + (w1_3_ * x3);
        const double z2 = (w2_2_ * x2) + (w2_3_ * x3);
        const double z3 = w3_3_ * x3;
        const double m0f2 = m0 * (m0 - 1.0);
        v = (z1 + (z2 * m0) + (z3 * m0f2)) / (m0f2 * (m0 - 2.0));
        if (finite(v)) {
            if (elapsed < samples_) {
                return {v, Status::Ok};
            } else {
                return {v, Status::Hold};
            }
        } else {
            return {0.0, Status::Range};
        }
    }

private:
    /// std::isfinite is not constexpr in C++17.
    static constexpr bool finite(double v) noexcept
    {
        return (v >= std::numeric_limits<double>::lowest()) && (v <= (std::numeric_limits<double>::max)());
    }
    /// Weight of x1 in the law.
    static constexpr double w1_1_{-120000000000.0};
    /// Weight of x2 in the law.
    static constexpr double w1_2_{120000000.0};
    /// Weight of x3 in the law.
    static constexpr double w1_3_{-40000.0};
    /// Weight of x2 in the law.
    static constexpr double w2_2_{-60000000.0};
    /// Weight of x3 in the law.
    static constexpr double w2_3_{30000.0};
    /// Weight of x3 in the law.
    static constexpr double w3_3_{-12000.0};
    /// Samples from the start to rest.
    static constexpr std::uint32_t samples_{20U};

    std::uint32_t start_{}; // tick at which it was armed
};

} // namespace ptc

#endif
