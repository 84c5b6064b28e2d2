/*
 * Prescribed-time controller stage31: outputs of order 1, 2, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang cpp --mu "exp(a=1)" --name stage31 --clock samples --eps=0 --limits=2,3 --poles="[[-4],[-3,-4.5]]" --states="h, c, e" --inputs=q,p --outputs="h, e" --dynamics="q - 1/10*h, p - c*(1 + h), (c - e)*(1 + h)" --reference input
 * Version 0.1.0, design 2c157dacc07c.
 *
 * Plant: the inputs q, p: h' = q - 1/10*h, c' = p - c*(1 + h), e' = (c - e)*(1 + h), output 1
 *       = h, output 2 = e; u held from sample to sample.
 * Goal: every output with its derivatives is 0 at sample N after the start, from any state,
 *       as long as no u is clipped and the plant is the model. The plant is known at the
 *       samples alone, which leaves an error of order h^(n+2-i) in x_i of an output of order
 *       n.
 * Law of each output, of order n: with M - s samples to go and z = S x, v h^n = sum of row_j
 *       z_j h^(j-1)/((M-j+1)...(M-n+1)); the rows are those of Theorem 1 for the mapping exp.
 *       v_i is law_i in step. s = 2, -2. Output 1: The gains of 1 sample to go stay: they are
 *       deadbeat. Rest is planned 1 sample early, and the last gains bring down what f and g
 *       did between samples. Output 2: From 6 samples to go on these are M - 2 and the
 *       exponents 3, 4, those of least energy. The gains of 2 samples to go stay: they are
 *       deadbeat. Rest is planned 2 samples early, and the last gains bring down what f and g
 *       did between samples.
 * Output 1, of order n = 1:
 *   x_1 = h
 *   f_1 = -h/10
 * Output 2, of order n = 2:
 *   x_1 = e
 *   x_2 = (c - e)*(1 + h)
 *   f_2 = (-c*(1 + h) - (c - e)*(1 + h))*(1 + h) + (c - e)*(-h/10)
 * u = adj(D) w/det(D) with w_i = v_i - f_i:
 *   det(D) = 1 + h
 *   adj(D) = [[1 + h, 0], [-(c - e), 1]]
 * With a reference r of each output, e_i = x_i - r^(i-1) is in place of x_i above, and law_i
 *       = v_i + rho of output i is in place of v_i. What r^(n) changes over a sample leaves
 *       an error of order h^(n+2-i) in e_i at sample N, h^3 for n = 1, and none where it is
 *       constant there.
 * Row i of r is of output i, of order n: in its places 0..n-1 the reference and its
 *       derivatives at tick k, and in place n rho, r^(n) over the sample in which u acts: its
 *       mean, (r^(n-1)(t + h) - r^(n-1)(t))/h, or that in its middle.
 * Outputs: 2, each with a law of its own, with this deadline and mapping; u_max is of the
 *       input of this number.
 *   output 1: k = 4; u_max = 2
 *   output 2: k = 13.5, 7.5; u_max = 3
 *
 * Parameters:
 *   samples [samples]: samples N from the start to rest
 *   h [s]: sample period
 *   eps = 0 [s], fixed: time-to-go at which the gains are held
 *   a = 1 [1/s], fixed: rate of stretched time
 *
 * k counts samples and may wrap; arm again within 2^32 - N samples.
 * From sample N on the last gains are held (status HOLD).
 * |u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
 *       lasts.
 * Guard full: what is measured and the reference are finite, or the call is refused (INPUT).
 * Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
 *       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
 *
 * Checks of the design (details: ptc-codegen check):
 *   membership: sound: exp is of class M for all its parameters.
 *   growth: sound: at rest at sample N from any state, but for what f + g u and r do between
 *       samples, whatever the poles, and |u| is bounded.
 *   sampling: not checked: `loop` bounds what the period leaves of a plant with several
 *       inputs.
 *   deadline: not checked: `loop` bounds what the period leaves of a plant with several
 *       inputs.
 *   loop: not checked: `samples` is left to run time.
 *   envelope: not checked: `x_max` is not given.
 *   zeros: sound: none: the relative degrees are 1, 2, whose sum is the number of states.
 */
#ifndef STAGE31_EF41FFF8_HPP
#define STAGE31_EF41FFF8_HPP

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
struct Stage31Params {
    std::uint32_t samples{}; ///< samples N from the start to rest [samples], at least 2
    double h{}; ///< sample period [s], from 1e-150 to 1e150
};

/// Controller: set by init, changed by arm and by what is not const.
class Stage31 {
public:
    using Params = Stage31Params;

    /// Takes the parameters and arms at tick 0. Ok, or Param with nothing changed.
    [[nodiscard]] constexpr Status init(const Params& params) noexcept
    {
        if (!((params.samples > 1U) && (1e-150 <= params.h) && (params.h <= 1e150))) {
            return Status::Param;
        }
        const std::uint32_t samples = params.samples;
        const double w1_1_1 = (-4.0) * (1.0 / params.h);
        const double w1_1_2 = (-13.5) * (1.0 / (params.h * params.h));
        const double w1_2_2 = 6.75 * (1.0 / params.h);
        const double w2_2_2 = (-6.5) * (1.0 / params.h);
        const double end1_1_2 = (-12.0) * (1.0 / (params.h * params.h));
        const double end1_2_2 = 6.0 * (1.0 / params.h);
        const double end2_2_2 = (-6.0) * (1.0 / params.h);
        if (!(finite(w1_1_1)
                && finite(w1_1_2)
                && finite(w1_2_2)
                && finite(w2_2_2)
                && finite(end1_1_2)
                && finite(end1_2_2)
                && finite(end2_2_2)
                && (params.h * params.h >= 1e-200)
                && (1.0 / (params.h * params.h) >= 1e-200))) {
            return Status::Param;
        }
        start_ = 0U;
        samples_ = samples;
        w1_1_1_ = w1_1_1;
        w1_1_2_ = w1_1_2;
        w1_2_2_ = w1_2_2;
        w2_2_2_ = w2_2_2;
        end1_1_2_ = end1_1_2;
        end1_2_2_ = end1_2_2;
        end2_2_2_ = end2_2_2;
        return Status::Ok;
    }

    /// Starts again: the deadline is N samples after tick `k`.
    constexpr void arm(std::uint32_t k) noexcept
    {
        start_ = k;
    }

    /// u = (q, p) from tick `k`, which may wrap, state x = (h, c, e) and the reference r of each
    /// output. Where one of them is not finite, as at a state at which the inputs do not decouple
    /// the outputs, every u is 0; else the status is SATURATED where one was clipped.
    constexpr Axes<double, 2> step(std::uint32_t k, const std::array<double, 3>& x, const std::array<std::array<double, 3>, 2>& r) const noexcept
    {
        Axes<double, 2> all{};
        if (!(finite(x[0])
                && finite(x[1])
                && finite(x[2])
                && finite(r[0][0])
                && finite(r[0][1])
                && finite(r[1][0])
                && finite(r[1][1])
                && finite(r[1][2]))) {
            return {{}, {{Status::Input, Status::Input}}, Status::Input};
        }
        const std::uint32_t elapsed = k - start_;

        // The chain of each output.
        const double x1_1 = x[0];
        const double x1_2 = x[2];
        const double v1 = x[1] - x1_2;
        const double v2 = 1.0 + x1_1;
        const double x2_2 = v1 * v2;

        // The tracking error.
        const double e1_1 = x1_1 - r[0][0];
        const double e1_2 = x1_2 - r[1][0];
        const double e2_2 = x2_2 - r[1][1];
        const std::uint32_t left = (elapsed < samples_) ? (samples_ - elapsed) : 0U;
        const double s1 = static_cast<double>(left) - 1.0;
        const double m0_1 = (s1 < 1.0) ? 1.0 : s1;
        double law_1{};

        // The exact law in samples.
        const double z1_1 = w1_1_1_ * e1_1;
        law_1 = (z1_1 / (m0_1 + 3.0)) + r[0][1];
        const double m0_2 = static_cast<double>(left) - 2.0;
        double law_2{};
        if (m0_2 > end_samples_2_) {
            // The exact law in samples.
            const double z1_2 = (w1_1_2_ * e1_2) + (w1_2_2_ * e2_2);
            const double z2_2 = w2_2_2_ * e2_2;
            law_2 = ((z1_2 + (z2_2 * m0_2)) / (m0_2 * (m0_2 - 1.0))) + r[1][2];
        } else {
            // The law of least energy to the end.
            const double m1_2 = (m0_2 < 2.0) ? 2.0 : m0_2;
            const double y1_2 = (end1_1_2_ * e1_2) + (end1_2_2_ * e2_2);
            const double y2_2 = end2_2_2_ * e2_2;
            const double m1f_21 = m1_2 + 2.0;
            law_2 = ((y1_2 + (y2_2 * m1f_21)) / (m1f_21 * (m1_2 + 1.0))) + r[1][2];
        }

        // The inputs that give all of them.
        const double v3 = (-x1_1) * 0.1;
        const double v4 = law_1 - v3;
        const double v5 = ((v2 < 0.0) || (v2 > 0.0)) ? (1.0 / v2) : std::numeric_limits<double>::quiet_NaN();
        const double control1 = v2 * v4 * v5;
        const double s2 = ((-v1) * v4) + (law_2 - (((((-x[1]) * v2) - x2_2) * v2) + (v1 * v3)));
        const double control2 = s2 * v5;
        if (elapsed < samples_) {
            all.status = Status::Ok;
        } else {
            all.status = Status::Hold;
        }
        if (finite(control1) && finite(control2)) {
            all.u[0] = control1;
            all.axes[0] = all.status;
            all.u[1] = control2;
            all.axes[1] = all.status;
            if (control1 > 2.0) {
                all.u[0] = 2.0;
                all.axes[0] = Status::Saturated;
                all.status = Status::Saturated;
            } else if (control1 < -2.0) {
                all.u[0] = -2.0;
                all.axes[0] = Status::Saturated;
                all.status = Status::Saturated;
            }
            if (control2 > 3.0) {
                all.u[1] = 3.0;
                all.axes[1] = Status::Saturated;
                all.status = Status::Saturated;
            } else if (control2 < -3.0) {
                all.u[1] = -3.0;
                all.axes[1] = Status::Saturated;
                all.status = Status::Saturated;
            }
        } else {
            all.u[0] = 0.0;
            if (finite(control1)) {
                all.axes[0] = all.status;
            } else {
                all.axes[0] = Status::Range;
            }
            all.u[1] = 0.0;
            if (finite(control2)) {
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
    /// Samples to go at which the law of the end takes over.
    static constexpr double end_samples_2_{6.0};

    std::uint32_t start_{}; // tick at which it was armed
    std::uint32_t samples_{}; // samples from the start to rest
    double w1_1_1_{}; // weight of x1 in the law
    double w1_1_2_{}; // weight of x1 in the law
    double w1_2_2_{}; // weight of x2 in the law
    double w2_2_2_{}; // weight of x2 in the law
    double end1_1_2_{}; // weight of x1 in the law
    double end1_2_2_{}; // weight of x2 in the law
    double end2_2_2_{}; // weight of x2 in the law
};

} // namespace ptc

#endif
