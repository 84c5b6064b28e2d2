/*
 * Prescribed-time controller stage18: order n = 2, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang cpp --n 2 --mu "exp(a=1)" --name stage18 --clock samples --tau=0.3 --eps=0 --poles=-3,-4 --states="q, w" --input=F --output="q + q^3/6" --dynamics="w, F/(2 + q^2) - k*q^3 - 3*w" --sample-time=0.01
 * Version 0.1.0, design 995bd6c0a918.
 *
 * Plant: the input F: q' = w, w' = F/(2 + q^2) - k*q^3 - 3*w, output q + q^3/6; u held from
 *       sample to sample.
 * Goal: the output and its derivatives up to order 1, x, are 0 at sample N after the start,
 *       from any state, as long as u is not clipped and the plant is the model. f and g are
 *       known at the samples alone, which leaves an error of order h^(4-i) in x_i.
 * Law: with M samples to go and z = S x, w h^2 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-1)),
 *       and u = (w - f)/g; the rows are those of Theorem 1 for the mapping exp. The gains of
 *       2 samples to go stay: they are deadbeat. Rest is planned 2 samples early, and the
 *       last gains bring down what f and g did between samples.
 *
 * Parameters:
 *   samples = 30 [samples], fixed: samples N from the start to rest
 *   h = 0.01 [s], fixed: sample period
 *   eps = 0 [s], fixed: time-to-go at which the gains are held
 *   u_max [unit of u]: bound of |u|
 *   a = 1 [1/s], fixed: rate of stretched time
 *   k_1 = 12 [1/s^2], fixed: gains k_i of pi0 = -sum k_i xi_i
 *   k_2 = 7 [1/s], fixed: gains k_i of pi0 = -sum k_i xi_i
 *   k [as in its expression]: parameter of an expression of the design
 *
 * k counts samples and may wrap; arm again within 2^32 - N samples.
 * From sample N on the last gains are held (status HOLD).
 * |u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
 *       lasts.
 * Guard full: what is measured is finite, or the call is refused (INPUT).
 * Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
 *       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
 *
 * Checks of the design (details: ptc-codegen check):
 *   membership: sound: exp is of class M for all its parameters.
 *   growth: sound: at rest at sample 30 from any state, but for what f + g u does between
 *       samples, whatever the poles, and |u| is bounded.
 *   sampling: not checked: `loop` bounds what the period leaves of a model that is not linear.
 *   deadline: not checked: `loop` bounds what the period leaves of a model that is not linear.
 *   loop: not checked: `k` is left to run time.
 *   envelope: not checked: it does not examine a clock in samples.
 *   zeros: sound: none: the relative degree is 2, the number of states.
 */
#ifndef STAGE18_C7334E70_HPP
#define STAGE18_C7334E70_HPP

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
struct Stage18Params {
    double u_max{}; ///< bound of |u| [unit of u], > 0, infinity allowed
    double k{}; ///< parameter of an expression of the design [as in its expression], finite
};

/// Controller: set by init, changed by arm and by what is not const.
class Stage18 {
public:
    using Params = Stage18Params;

    /// Takes the parameters and arms at tick 0. Ok, or Param with nothing changed.
    [[nodiscard]] constexpr Status init(const Params& params) noexcept
    {
        if (!((params.u_max > 0.0) && finite(params.k))) {
            return Status::Param;
        }
        const double p_k = params.k;
        const double u_max = params.u_max;
        start_ = 0U;
        p_k_ = p_k;
        u_max_ = u_max;
        return Status::Ok;
    }

    /// Starts again: the deadline is N samples after tick `k`.
    constexpr void arm(std::uint32_t k) noexcept
    {
        start_ = k;
    }

    /// u from tick `k`, which may wrap, and the state x of the model.
    /// On a negative status u is 0 and nothing has changed.
    constexpr Control<double> step(std::uint32_t k, const std::array<double, 2>& x) const noexcept
    {
        if (!(finite(x[0]) && finite(x[1]))) {
            return {0.0, Status::Input};
        }
        const std::uint32_t elapsed = k - start_;

        // The chain of the output.
        const double v1 = x[0] * x[0];
        const double v2 = x[0] * v1;
        const double x1 = x[0] + (v2 * 0.16666666666666666);
        const double v3 = 2.0 + v1;
        const double x2 = x[1] * v3 * 0.5;
        double w{};

        // The exact law in samples.
        const double m0 = (elapsed < 26U) ? (static_cast<double>(30U - elapsed)) : 4.0;
        const double z1 = (w1_1_ * x1) + (w1_2_ * x2);
        const double z2 = w2_2_ * x2;
        w = (z1 + (z2 * m0)) / (m0 * (m0 - 1.0));
        const double s1 = (-((p_k_ * v2) + (3.0 * x[1]))) * v3;
        const double v = (w - ((s1 + (x[1] * (2.0 * x[0] * x[1]))) * 0.5)) * 2.0;
        if (finite(v)) {
            if (v > u_max_) {
                return {u_max_, Status::Saturated};
            } else if (v < -u_max_) {
                return {-u_max_, Status::Saturated};
            } else if (elapsed < samples_) {
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
    static constexpr double w1_1_{-120000.0};
    /// Weight of x2 in the law.
    static constexpr double w1_2_{600.0};
    /// Weight of x2 in the law.
    static constexpr double w2_2_{-600.0};
    /// Samples from the start to rest.
    static constexpr std::uint32_t samples_{30U};

    std::uint32_t start_{}; // tick at which it was armed
    double p_k_{}; // parameter of an expression of the design
    double u_max_{}; // bound of |u|
};

} // namespace ptc

#endif
