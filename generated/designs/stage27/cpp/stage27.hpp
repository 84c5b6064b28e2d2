/*
 * Prescribed-time controller stage27: outputs of order 1, 2, 1, 2, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang cpp --mu "exp(a=0.8)" --name stage27 --clock samples --eps=0 --u-max=inf --poles="[[-4],[-3,-4],[-5],[-2.5,-6]]" --states="a, b, b1, c, d, d1" --inputs=A,B,C,D --outputs="a, b, c, d" --dynamics="A*(2 + b^2) + B - a*c, b1, B*(3 + a) + C*d - b*d1, C + D*a - c^2, d1, D*(2 - b) + A*c + a"
 * Version 0.1.0, design 7fcab43de361.
 *
 * Plant: the inputs A, B, C, D: a' = A*(2 + b^2) + B - a*c, b' = b1, b1' = B*(3 + a) + C*d -
 *       b*d1, c' = C + D*a - c^2, d' = d1, d1' = D*(2 - b) + A*c + a, output 1 = a, output 2
 *       = b, output 3 = c, output 4 = d; u held from sample to sample.
 * Goal: every output with its derivatives is 0 at sample N after the start, from any state,
 *       as long as no u is clipped and the plant is the model. The plant is known at the
 *       samples alone, which leaves an error of order h^(n+2-i) in x_i of an output of order
 *       n.
 * Law of each output, of order n: with M - s samples to go and z = S x, v h^n = sum of row_j
 *       z_j h^(j-1)/((M-j+1)...(M-n+1)); the rows are those of Theorem 1 for the mapping exp.
 *       v_i is law_i in step. s = 3, -2, -1, -2. Output 1: The gains of 1 sample to go stay:
 *       they are deadbeat. Rest is planned 1 sample early, and the last gains bring down what
 *       f and g did between samples. Output 2: From 6 samples to go on these are M - 3 and
 *       the exponents 4, 5, those of least energy. The gains of 2 samples to go stay: they
 *       are deadbeat. Rest is planned 2 samples early, and the last gains bring down what f
 *       and g did between samples. Output 3: From 7 samples to go on these are M - 6 and the
 *       exponents 7, those of least energy. The gains of 1 sample to go stay: they are
 *       deadbeat. Rest is planned 1 sample early, and the last gains bring down what f and g
 *       did between samples. Output 4: From 9 samples to go on these are M - 3 and the
 *       exponents 4, 5, those of least energy. The gains of 2 samples to go stay: they are
 *       deadbeat. Rest is planned 2 samples early, and the last gains bring down what f and g
 *       did between samples.
 * Output 1, of order n = 1:
 *   x_1 = a
 *   f_1 = -a*c
 * Output 2, of order n = 2:
 *   x_1 = b
 *   x_2 = b1
 *   f_2 = -b*d1
 * Output 3, of order n = 1:
 *   x_1 = c
 *   f_3 = -c^2
 * Output 4, of order n = 2:
 *   x_1 = d
 *   x_2 = d1
 *   f_4 = a
 * u of D u = w with w_i = v_i - f_i, by elimination with pivots:
 *   D = [[2 + b^2, 1, 0, 0], [0, 3 + a, d, 0], [0, 0, 1, a], [c, 0, 0, 2 - b]]
 * Outputs: 4, each with a law of its own, with this deadline and mapping; u_max is of the
 *       input of this number.
 *   output 1: k = 4
 *   output 2: k = 12, 7
 *   output 3: k = 5
 *   output 4: k = 15, 8.5
 *
 * Parameters:
 *   samples [samples]: samples N from the start to rest
 *   h [s]: sample period
 *   eps = 0 [s], fixed: time-to-go at which the gains are held
 *   u_max = inf [unit of u], fixed: bound of |u|
 *   a = 0.8 [1/s], fixed: rate of stretched time
 *
 * k counts samples and may wrap; arm again within 2^32 - N samples.
 * From sample N on the last gains are held (status HOLD).
 * u is not clipped.
 * Guard full: what is measured is finite, or the call is refused (INPUT).
 * Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
 *       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
 *
 * Checks of the design (details: ptc-codegen check):
 *   membership: sound: exp is of class M for all its parameters.
 *   growth: sound: at rest at sample N from any state, but for what f + g u does between
 *       samples, whatever the poles, and |u| is bounded.
 *   sampling: not checked: `loop` bounds what the period leaves of a plant with several
 *       inputs.
 *   deadline: not checked: `loop` bounds what the period leaves of a plant with several
 *       inputs.
 *   loop: not checked: `samples` is left to run time.
 *   envelope: not checked: `x_max` is not given.
 *   zeros: sound: none: the relative degrees are 1, 2, 1, 2, whose sum is the number of
 *       states.
 */
#ifndef STAGE27_CF00F8DE_HPP
#define STAGE27_CF00F8DE_HPP

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
struct Stage27Params {
    std::uint32_t samples{}; ///< samples N from the start to rest [samples], at least 2
    double h{}; ///< sample period [s], from 1e-150 to 1e150
};

/// Controller: set by init, changed by arm and by what is not const.
class Stage27 {
public:
    using Params = Stage27Params;

    /// Takes the parameters and arms at tick 0. Ok, or Param with nothing changed.
    [[nodiscard]] constexpr Status init(const Params& params) noexcept
    {
        if (!((params.samples > 1U) && (1e-150 <= params.h) && (params.h <= 1e150))) {
            return Status::Param;
        }
        const std::uint32_t samples = params.samples;
        const double w1_1_1 = (-5.0) * (1.0 / params.h);
        const double w1_1_2 = (-18.75) * (1.0 / (params.h * params.h));
        const double w1_2_2 = 9.375 * (1.0 / params.h);
        const double w2_2_2 = (-7.75) * (1.0 / params.h);
        const double end1_1_2 = (-20.0) * (1.0 / (params.h * params.h));
        const double end1_2_2 = 10.0 * (1.0 / params.h);
        const double end2_2_2 = (-8.0) * (1.0 / params.h);
        const double w1_1_3 = (-6.25) * (1.0 / params.h);
        const double end1_1_3 = (-7.0) * (1.0 / params.h);
        const double w1_1_4 = (-23.4375) * (1.0 / (params.h * params.h));
        const double w1_2_4 = 11.71875 * (1.0 / params.h);
        const double w2_2_4 = (-9.625) * (1.0 / params.h);
        if (!(finite(w1_1_1)
                && finite(w1_1_2)
                && finite(w1_2_2)
                && finite(w2_2_2)
                && finite(end1_1_2)
                && finite(end1_2_2)
                && finite(end2_2_2)
                && finite(w1_1_3)
                && finite(end1_1_3)
                && finite(w1_1_4)
                && finite(w1_2_4)
                && finite(w2_2_4)
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
        w1_1_3_ = w1_1_3;
        end1_1_3_ = end1_1_3;
        w1_1_4_ = w1_1_4;
        w1_2_4_ = w1_2_4;
        w2_2_4_ = w2_2_4;
        return Status::Ok;
    }

    /// Starts again: the deadline is N samples after tick `k`.
    constexpr void arm(std::uint32_t k) noexcept
    {
        start_ = k;
    }

    /// u = (A, B, C, D) from tick `k`, which may wrap, and state x = (a, b, b1, c, d, d1). Where
    /// one of them is not finite, as at a state at which the inputs do not decouple the outputs,
    /// every u is 0; else the status is SATURATED where one was clipped.
    constexpr Axes<double, 4> step(std::uint32_t k, const std::array<double, 6>& x) const noexcept
    {
        Axes<double, 4> all{};
        if (!(finite(x[0])
                && finite(x[1])
                && finite(x[2])
                && finite(x[3])
                && finite(x[4])
                && finite(x[5]))) {
            return {{}, {{Status::Input, Status::Input, Status::Input, Status::Input}}, Status::Input};
        }
        const std::uint32_t elapsed = k - start_;

        // The chain of each output.
        const double x1_1 = x[0];
        const double x1_2 = x[1];
        const double x2_2 = x[2];
        const double x1_3 = x[3];
        const double x1_4 = x[4];
        const double x2_4 = x[5];
        const std::uint32_t left = (elapsed < samples_) ? (samples_ - elapsed) : 0U;
        const double s1 = static_cast<double>(left) - 1.0;
        const double m0_1 = (s1 < 1.0) ? 1.0 : s1;
        double law_1{};

        // The exact law in samples.
        const double z1_1 = w1_1_1_ * x1_1;
        law_1 = z1_1 / (m0_1 + 4.0);
        const double m0_2 = static_cast<double>(left) - 2.0;
        double law_2{};
        const double m0_3 = static_cast<double>(left) - 1.0;
        double law_3{};
        const double m0_4 = static_cast<double>(left) - 2.0;
        double law_4{};
        if (m0_2 > end_samples_2_) {
            // The exact law in samples.
            const double z1_2 = (w1_1_2_ * x1_2) + (w1_2_2_ * x2_2);
            const double z2_2 = w2_2_2_ * x2_2;
            law_2 = (z1_2 + (z2_2 * m0_2)) / (m0_2 * (m0_2 - 1.0));
        } else {
            // The law of least energy to the end.
            const double m1_2 = (m0_2 < 2.0) ? 2.0 : m0_2;
            const double y1_2 = (end1_1_2_ * x1_2) + (end1_2_2_ * x2_2);
            const double y2_2 = end2_2_2_ * x2_2;
            const double m1f_21 = m1_2 + 3.0;
            law_2 = (y1_2 + (y2_2 * m1f_21)) / (m1f_21 * (m1_2 + 2.0));
        }
        if (m0_3 > end_samples_3_) {
            // The exact law in samples.
            const double z1_3 = w1_1_3_ * x1_3;
            law_3 = z1_3 / m0_3;
        } else {
            // The law of least energy to the end.
            const double m1_3 = (m0_3 < 1.0) ? 1.0 : m0_3;
            const double y1_3 = end1_1_3_ * x1_3;
            law_3 = y1_3 / (m1_3 + 6.0);
        }
        if (m0_4 > end_samples_4_) {
            // The exact law in samples.
            const double z1_4 = (w1_1_4_ * x1_4) + (w1_2_4_ * x2_4);
            const double z2_4 = w2_2_4_ * x2_4;
            law_4 = (z1_4 + (z2_4 * m0_4)) / (m0_4 * (m0_4 - 1.0));
        } else {
            // The law of least energy to the end.
            const double m1_4 = (m0_4 < 2.0) ? 2.0 : m0_4;
            const double y1_4 = (end1_1_2_ * x1_4) + (end1_2_2_ * x2_4);
            const double y2_4 = end2_2_2_ * x2_4;
            const double m1f_41 = m1_4 + 3.0;
            law_4 = (y1_4 + (y2_4 * m1f_41)) / (m1f_41 * (m1_4 + 2.0));
        }

        // The inputs that give all of them.
        const std::array<double, 16> v1_a{{
            2.0 + (x1_2 * x1_2),
            1.0,
            0.0,
            0.0,
            0.0,
            3.0 + x1_1,
            x1_4,
            0.0,
            0.0,
            0.0,
            1.0,
            x1_1,
            x1_3,
            0.0,
            0.0,
            2.0 - x1_2,
        }};
        const std::array<double, 4> given_v1{{
            law_1 - ((-x1_1) * x1_3),
            law_2 - ((-x1_2) * x2_4),
            law_3 - (-(x1_3 * x1_3)),
            law_4 - x1_1,
        }};
        const auto v1 = eliminate(given_v1, v1_a);
        const double control1 = v1[0];
        const double control2 = v1[1];
        const double control3 = v1[2];
        const double control4 = v1[3];
        if (elapsed < samples_) {
            all.status = Status::Ok;
        } else {
            all.status = Status::Hold;
        }
        if (finite(control1) && finite(control2) && finite(control3) && finite(control4)) {
            all.u[0] = control1;
            all.axes[0] = all.status;
            all.u[1] = control2;
            all.axes[1] = all.status;
            all.u[2] = control3;
            all.axes[2] = all.status;
            all.u[3] = control4;
            all.axes[3] = all.status;
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
            all.u[2] = 0.0;
            if (finite(control3)) {
                all.axes[2] = all.status;
            } else {
                all.axes[2] = Status::Range;
            }
            all.u[3] = 0.0;
            if (finite(control4)) {
                all.axes[3] = all.status;
            } else {
                all.axes[3] = Status::Range;
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

    static constexpr double absolute(double v) noexcept
    {
        return (v > 0.0) ? v : (0.0 - v);
    }

    /// Solves a x = b, with a row by row, by elimination with the largest pivot of each column: b
    /// becomes x, NaN where a is singular.
    static constexpr std::array<double, 4> eliminate(
        std::array<double, 4> b, std::array<double, 16> a) noexcept
    {
        for (std::uint32_t k = 0U; k < 4U; k++) {
            std::uint32_t most = k;
            double largest = absolute(a[(4U * k) + k]);
            for (std::uint32_t i = k + 1U; i < 4U; i++) {
                const double size = absolute(a[(4U * i) + k]);
                if (largest < size) {
                    largest = size;
                    most = i;
                }
            }
            for (std::uint32_t i = k + 1U; i < 4U; i++) {
                if (most == i) {
                    const double kept = b[k];
                    b[k] = b[i];
                    b[i] = kept;
                    for (std::uint32_t j = k; j < 4U; j++) {
                        const double entry = a[(4U * k) + j];
                        a[(4U * k) + j] = a[(4U * i) + j];
                        a[(4U * i) + j] = entry;
                    }
                }
            }
            a[(4U * k) + k] = ((a[(4U * k) + k] < 0.0) || (a[(4U * k) + k] > 0.0)) ? (a[(4U * k) + k]) : std::numeric_limits<double>::quiet_NaN();
            for (std::uint32_t i = k + 1U; i < 4U; i++) {
                const double factor = a[(4U * i) + k] / a[(4U * k) + k];
                for (std::uint32_t j = k + 1U; j < 4U; j++) {
                    a[(4U * i) + j] = a[(4U * i) + j] - (factor * a[(4U * k) + j]);
                }
                b[i] = b[i] - (factor * b[k]);
            }
        }
        for (std::uint32_t left = 4U; left > 0U; left--) {
            const std::uint32_t k = left - 1U;
            for (std::uint32_t j = k + 1U; j < 4U; j++) {
                b[k] = b[k] - (a[(4U * k) + j] * b[j]);
            }
            b[k] = b[k] / a[(4U * k) + k];
        }
        return b;
    }
    /// Samples to go at which the law of the end takes over.
    static constexpr double end_samples_2_{6.0};
    /// Samples to go at which the law of the end takes over.
    static constexpr double end_samples_3_{7.0};
    /// Samples to go at which the law of the end takes over.
    static constexpr double end_samples_4_{9.0};

    std::uint32_t start_{}; // tick at which it was armed
    std::uint32_t samples_{}; // samples from the start to rest
    double w1_1_1_{}; // weight of x1 in the law
    double w1_1_2_{}; // weight of x1 in the law
    double w1_2_2_{}; // weight of x2 in the law
    double w2_2_2_{}; // weight of x2 in the law
    double end1_1_2_{}; // weight of x1 in the law
    double end1_2_2_{}; // weight of x2 in the law
    double end2_2_2_{}; // weight of x2 in the law
    double w1_1_3_{}; // weight of x1 in the law
    double end1_1_3_{}; // weight of x1 in the law
    double w1_1_4_{}; // weight of x1 in the law
    double w1_2_4_{}; // weight of x2 in the law
    double w2_2_4_{}; // weight of x2 in the law
};

} // namespace ptc

#endif
