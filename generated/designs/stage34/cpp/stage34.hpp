/*
 * Prescribed-time controller stage34: order n = 3, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang cpp --n 3 --axes 2 --mu exp --name stage34 --clock samples --guard none --eps=0 --g="3" --reference input
 * Version 0.1.0, design 0d8dd7fc9d15.
 *
 * Plant: x1' = x2, ..., x3' = g u; u held from sample to sample.
 * Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
 *       sample period, as long as u is not clipped and nothing else acts on the plant.
 * Law: with M samples to go and z = S x, u h^3 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-2));
 *       the rows are those of Theorem 1 for the mapping exp. Close to the end deadbeat takes
 *       over.
 * With a reference r of each axis, e_i = x_i - r^(i-1) is in place of x_i above, and u = w +
 *       rho/g of each axis. What r^(n) changes over a sample leaves an error of order
 *       h^(n+2-i) in e_i at sample N, h^3 for n = 1, and none where it is constant there.
 * Row i of r is of axis i, of order n: in its places 0..n-1 the reference and its derivatives
 *       at tick k, and in place n rho, r^(n) over the sample in which u acts: its mean,
 *       (r^(n-1)(t + h) - r^(n-1)(t))/h, or that in its middle.
 * Axes: 2, each a chain of its own with this deadline and mapping. step computes what depends
 *       on time once.
 *
 * Parameters:
 *   samples [samples]: samples N from the start to rest
 *   h [s]: sample period
 *   eps = 0 [s], fixed: time-to-go at which the gains are held
 *   u_max [unit of u]: bound of |u|
 *   a [1/s]: rate of stretched time
 *   k_1 [1/s^3]: gains k_i of pi0 = -sum k_i xi_i
 *   k_2 [1/s^2]: gains k_i of pi0 = -sum k_i xi_i
 *   k_3 [1/s]: gains k_i of pi0 = -sum k_i xi_i
 *   deadbeat [samples]: samples to go at which deadbeat takes over, 0 for a safe default
 *
 * k counts samples and may wrap; arm again within 2^32 - N samples.
 * From sample N on the last gains are held (status HOLD).
 * |u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
 *       lasts.
 * Guard none: finite measurements and references are the responsibility of the caller.
 * Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
 *       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
 *
 * Checks of the design (details: ptc-codegen check):
 *   membership: sound: exp is of class M for all its parameters.
 *   growth: sound: at rest at sample N from any state, but for what r does between samples,
 *       whatever the poles, and |u| is bounded.
 *   sampling: not checked: `loop` bounds what the period leaves of a reference that moves.
 *   deadline: not checked: `loop` bounds what the period leaves of a reference that moves.
 *   loop: not checked: `samples` is left to run time.
 *   envelope: not checked: it does not examine a clock in samples.
 */
#ifndef STAGE34_54CF90A9_HPP
#define STAGE34_54CF90A9_HPP

#include <array>
#include <cfloat>
#include <cstddef>
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

#ifndef PTC_AXES_HPP
#define PTC_AXES_HPP
/// Result of a step of several axes.
template <class Real, std::size_t Count>
struct [[nodiscard]] Axes {
    std::array<Real, Count> u{}; ///< inputs of the plants, 0 on a negative status
    std::array<Status, Count> axes{}; ///< status of each axis
    Status status{Status::Input}; ///< that of the first axis that fails; else Saturated where one is
};
#endif

/// Run-time parameters.
struct Stage34Params {
    std::uint32_t samples{}; ///< samples N from the start to rest [samples], at least 3
    double h{}; ///< sample period [s], from 1e-150 to 1e150
    double u_max{}; ///< bound of |u| [unit of u], > 0, infinity allowed
    double a{}; ///< rate of stretched time [1/s], from 1e-150 to 1e150
    std::array<double, 3> k{}; ///< gains k_i of pi0 = -sum k_i xi_i [1/s^3], finite
    double deadbeat{}; ///< samples to go at which deadbeat takes over, 0 for a safe default [samples], finite
};

/// Controller: set by init, changed by arm and by what is not const.
class Stage34 {
public:
    using Params = Stage34Params;

    /// Takes the parameters and arms at tick 0. Ok, or Param with nothing changed.
    [[nodiscard]] constexpr Status init(const Params& params) noexcept
    {
        if (!((params.samples > 2U)
                && (1e-150 <= params.h)
                && (params.h <= 1e150)
                && (params.u_max > 0.0)
                && (1e-150 <= params.a)
                && (params.a <= 1e150)
                && finite(params.k[0])
                && finite(params.k[1])
                && finite(params.k[2])
                && finite(params.deadbeat)
                && (params.deadbeat >= 0.0))) {
            return Status::Param;
        }
        const std::uint32_t samples = params.samples;
        const double s1 = ((params.k[2] / params.a) - 4.0) + 3.0;
        const double s2 = (s1 < 6.0) ? 6.0 : s1;
        const double deadbeat_1 = (params.deadbeat > 0.0) ? params.deadbeat : s2;
        const double s3 = -(params.k[0] / (params.a * params.a * params.a));
        const double s4 = 1.0 / (params.h * params.h * params.h);
        const double w1_1_1 = 0.3333333333333333 * s3 * s4;
        const double s5 = -(params.k[0] / (params.a * params.a * params.a));
        const double w1_2_1 = (-0.3333333333333333) * s5 * (1.0 / (params.h * params.h));
        const double s6 = -(params.k[0] / (params.a * params.a * params.a));
        const double w1_3_1 = 0.1111111111111111 * s6 * (1.0 / params.h);
        const double s7 = (-1.0) - (params.k[1] / (params.a * params.a));
        const double s8 = 0.3333333333333333 * (s7 + (params.k[2] / params.a));
        const double w2_2_1 = s8 * (1.0 / (params.h * params.h));
        const double s9 = (-1.0) - (params.k[1] / (params.a * params.a));
        const double s10 = (-0.16666666666666666) * (s9 + (params.k[2] / params.a));
        const double w2_3_1 = s10 * (1.0 / params.h);
        const double s11 = 0.3333333333333333 * (3.0 - (params.k[2] / params.a));
        const double w3_3_1 = s11 * (1.0 / params.h);
        const double s12 = 1.0 / (params.h * params.h * params.h);
        const double b_1_1 = (-0.3333333333333333) * s12;
        const double b_2_1 = (-0.6666666666666666) * (1.0 / (params.h * params.h));
        const double b_3_1 = (-0.6111111111111112) * (1.0 / params.h);
        const double u_max = params.u_max;
        if (!(finite(deadbeat_1)
                && finite(w1_1_1)
                && finite(w1_2_1)
                && finite(w1_3_1)
                && finite(w2_2_1)
                && finite(w2_3_1)
                && finite(w3_3_1)
                && finite(b_1_1)
                && finite(b_2_1)
                && finite(b_3_1)
                && (params.h * params.h * params.h >= 1e-200)
                && (1.0 / (params.h * params.h * params.h) >= 1e-200))) {
            return Status::Param;
        }
        start_ = 0U;
        samples_ = samples;
        deadbeat_1_ = deadbeat_1;
        w1_1_1_ = w1_1_1;
        w1_2_1_ = w1_2_1;
        w1_3_1_ = w1_3_1;
        w2_2_1_ = w2_2_1;
        w2_3_1_ = w2_3_1;
        w3_3_1_ = w3_3_1;
        b_1_1_ = b_1_1;
        b_2_1_ = b_2_1;
        b_3_1_ = b_3_1;
        u_max_ = u_max;
        return Status::Ok;
    }

    /// Starts again: the deadline is N samples after tick `k`.
    constexpr void arm(std::uint32_t k) noexcept
    {
        start_ = k;
    }

    /// u of each axis from tick `k`, which may wrap, and the state x = (x1, x1', ...) and the
    /// reference r of each. Where one of them is not finite, every u is 0; else the status is
    /// SATURATED where one was clipped.
    constexpr Axes<double, 2> step(std::uint32_t k, const std::array<std::array<double, 3>, 2>& x, const std::array<std::array<double, 4>, 2>& r) const noexcept
    {
        Axes<double, 2> all{};
        const std::uint32_t elapsed = k - start_;
        const double x1_1 = x[0][0];
        const double x2_1 = x[0][1];
        const double x3_1 = x[0][2];
        const double x1_2 = x[1][0];
        const double x2_2 = x[1][1];
        const double x3_2 = x[1][2];

        // The tracking error.
        const double e1_1 = x1_1 - r[0][0];
        const double e2_1 = x2_1 - r[0][1];
        const double e3_1 = x3_1 - r[0][2];
        const double e1_2 = x1_2 - r[1][0];
        const double e2_2 = x2_2 - r[1][1];
        const double e3_2 = x3_2 - r[1][2];
        const std::uint32_t left = (elapsed < samples_) ? (samples_ - elapsed) : 0U;
        const double m0_1 = static_cast<double>(left);
        double law_1{};
        const double m0_2 = static_cast<double>(left);
        double law_2{};
        if (m0_1 > deadbeat_1_) {
            // The exact law in samples.
            const double s1 = (w1_1_1_ * e1_1) + (w1_2_1_ * e2_1);
            const double z1_1 = s1 + (w1_3_1_ * e3_1);
            const double z2_1 = (w2_2_1_ * e2_1) + (w2_3_1_ * e3_1);
            const double z3_1 = w3_3_1_ * e3_1;
            const double m0f_12 = m0_1 * (m0_1 - 1.0);
            const double s2 = (z1_1 + (z2_1 * m0_1) + (z3_1 * m0f_12)) / (m0f_12 * (m0_1 - 2.0));
            law_1 = s2 + (0.3333333333333333 * r[0][3]);
        } else {
            // Deadbeat.
            const double s3 = (b_1_1_ * e1_1) + (b_2_1_ * e2_1);
            law_1 = s3 + (b_3_1_ * e3_1) + (0.3333333333333333 * r[0][3]);
        }
        if (m0_2 > deadbeat_1_) {
            // The exact law in samples.
            const double s4 = (w1_1_1_ * e1_2) + (w1_2_1_ * e2_2);
            const double z1_2 = s4 + (w1_3_1_ * e3_2);
            const double z2_2 = (w2_2_1_ * e2_2) + (w2_3_1_ * e3_2);
            const double z3_2 = w3_3_1_ * e3_2;
            const double m0f_22 = m0_2 * (m0_2 - 1.0);
            const double s5 = (z1_2 + (z2_2 * m0_2) + (z3_2 * m0f_22)) / (m0f_22 * (m0_2 - 2.0));
            law_2 = s5 + (0.3333333333333333 * r[1][3]);
        } else {
            // Deadbeat.
            const double s6 = (b_1_1_ * e1_2) + (b_2_1_ * e2_2);
            law_2 = s6 + (b_3_1_ * e3_2) + (0.3333333333333333 * r[1][3]);
        }
        if (elapsed < samples_) {
            all.status = Status::Ok;
        } else {
            all.status = Status::Hold;
        }
        if (finite(law_1) && finite(law_2)) {
            all.u[0] = law_1;
            all.axes[0] = all.status;
            all.u[1] = law_2;
            all.axes[1] = all.status;
            if (law_1 > u_max_) {
                all.u[0] = u_max_;
                all.axes[0] = Status::Saturated;
                all.status = Status::Saturated;
            } else if (law_1 < -u_max_) {
                all.u[0] = -u_max_;
                all.axes[0] = Status::Saturated;
                all.status = Status::Saturated;
            }
            if (law_2 > u_max_) {
                all.u[1] = u_max_;
                all.axes[1] = Status::Saturated;
                all.status = Status::Saturated;
            } else if (law_2 < -u_max_) {
                all.u[1] = -u_max_;
                all.axes[1] = Status::Saturated;
                all.status = Status::Saturated;
            }
        } else {
            all.u[0] = 0.0;
            if (finite(law_1)) {
                all.axes[0] = all.status;
            } else {
                all.axes[0] = Status::Range;
            }
            all.u[1] = 0.0;
            if (finite(law_2)) {
                all.axes[1] = all.status;
            } else {
                all.axes[1] = Status::Range;
            }
            all.status = Status::Range;
        }
        return all;
    }

private:
    /// std::isfinite is not constexpr in C++17.
    static constexpr bool finite(double v) noexcept
    {
        return (v >= std::numeric_limits<double>::lowest()) && (v <= (std::numeric_limits<double>::max)());
    }

    std::uint32_t start_{}; // tick at which it was armed
    std::uint32_t samples_{}; // samples from the start to rest
    double deadbeat_1_{}; // samples to go at which deadbeat takes over
    double w1_1_1_{}; // weight of x1 in the law
    double w1_2_1_{}; // weight of x2 in the law
    double w1_3_1_{}; // weight of x3 in the law
    double w2_2_1_{}; // weight of x2 in the law
    double w2_3_1_{}; // weight of x3 in the law
    double w3_3_1_{}; // weight of x3 in the law
    double b_1_1_{}; // weight of x1 in the law
    double b_2_1_{}; // weight of x2 in the law
    double b_3_1_{}; // weight of x3 in the law
    double u_max_{}; // bound of |u|
};

} // namespace ptc

#endif
