/*
 * Prescribed-time controller stage32: outputs of order 2, 2, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang cpp --mu exp --name stage32 --clock samples --tau=0.3 --eps=0.04 --states="q1, q2, w1, w2" --inputs=F1,F2 --inertia="[[m + q2^2, q2], [q2, 1]]" --bias="m*q2*w1*w2, w1^2/2 - q1" --reference="size*dt^2/(1 + t^2), 0" --sample-time=0.01
 * Version 0.1.0, design 241446d65458.
 *
 * Plant: the inputs F1, F2: q = (q1, q2), q' = (w1, w2), M q'' + bias = u, M = [[m + q2^2,
 *       q2], [q2, 1]], bias = [m*q2*w1*w2, w1^2/2 - q1]; u held from sample to sample.
 * Goal: every output with its derivatives is 0 at sample N after the start, from any state,
 *       as long as no u is clipped and the plant is the model. The plant is known at the
 *       samples alone, which leaves an error of order h^(n+2-i) in x_i of an output of order
 *       n.
 * Law of each output, of order n: with M - s samples to go and z = S x, v h^n = sum of row_j
 *       z_j h^(j-1)/((M-j+1)...(M-n+1)); the rows are those of Theorem 1 for the mapping exp.
 *       v_i is law_i in step. s = 0, 0. Output 1: Close to the end deadbeat takes over.
 *       Output 2: Close to the end deadbeat takes over.
 * Output 1, of order n = 2:
 *   x_1 = q1
 *   x_2 = w1
 * Output 2, of order n = 2:
 *   x_1 = q2
 *   x_2 = w2
 * u = M v + bias
 * With a reference r of each output, e_i = x_i - r^(i-1) is in place of x_i above, and law_i
 *       = v_i + rho of output i is in place of v_i. What r^(n) changes over a sample leaves
 *       an error of order h^(n+2-i) in e_i at sample N, h^3 for n = 1, and none where it is
 *       constant there.
 * t counts from the tick at which it was armed, and rho is r^(n) in the middle of the time in
 *       which u acts:
 *   of output 1: r = size*dt^2/(1 + t^2), r^(1) = 2*size*dt*(1 + t^2 - dt*t)/(1 + t^2)^2,
 *       r^(2) = 2*size*((1 + t^2)^2 + 4*dt^2*t^2 - 4*(1 + t^2)*dt*t - (1 + t^2)*dt^2)/(1 +
 *       t^2)^3
 *   of output 2: r = 0, r^(1) = 0, r^(2) = 0
 * Outputs: 2, each with a law of its own, with this deadline and mapping; u_max is of the
 *       input of this number.
 *
 * Parameters:
 *   samples = 30 [samples], fixed: samples N from the start to rest
 *   h = 0.01 [s], fixed: sample period
 *   eps = 0.04 [s], fixed: time-to-go at which the gains are held
 *   u_max [unit of u]: bound of |u|
 *   a [1/s]: rate of stretched time
 *   k_1 [1/s^2]: gains k_i of pi0 = -sum k_i xi_i
 *   k_2 [1/s]: gains k_i of pi0 = -sum k_i xi_i
 *   deadbeat [samples]: samples to go at which deadbeat takes over, 0 for a safe default
 *   m [as in its expression]: parameter of an expression of the design
 *   size [as in its expression]: parameter of an expression of the design
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
 *   growth: sound: output 1: near rest at sample 30, not at rest: the gains are held from 4
 *       samples to go, and |u| is bounded; so does what f + g u and r do between samples.
 *   sampling: not checked: `loop` bounds what the period leaves of a plant with several
 *       inputs.
 *   deadline: not checked: `loop` bounds what the period leaves of a plant with several
 *       inputs.
 *   loop: not checked: `a` is left to run time.
 *   envelope: not checked: `x_max` is not given.
 *   zeros: sound: none: the relative degrees are 2, 2, whose sum is the number of states.
 */
#ifndef STAGE32_328BBFFB_HPP
#define STAGE32_328BBFFB_HPP

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
struct Stage32Params {
    double u_max{}; ///< bound of |u| [unit of u], > 0, infinity allowed
    double a{}; ///< rate of stretched time [1/s], from 1e-150 to 1e150
    std::array<double, 2> k{}; ///< gains k_i of pi0 = -sum k_i xi_i [1/s^2], finite
    double deadbeat{}; ///< samples to go at which deadbeat takes over, 0 for a safe default [samples], finite
    double m{}; ///< parameter of an expression of the design [as in its expression], finite
    double size{}; ///< parameter of an expression of the design [as in its expression], finite
};

/// Controller: set by init, changed by arm and by what is not const.
class Stage32 {
public:
    using Params = Stage32Params;

    /// Takes the parameters and arms at tick 0. Ok, or Param with nothing changed.
    [[nodiscard]] constexpr Status init(const Params& params) noexcept
    {
        if (!((params.u_max > 0.0)
                && (1e-150 <= params.a)
                && (params.a <= 1e150)
                && finite(params.k[0])
                && finite(params.k[1])
                && finite(params.deadbeat)
                && (params.deadbeat >= 0.0)
                && finite(params.m)
                && finite(params.size))) {
            return Status::Param;
        }
        const double p_size = params.size;
        const double c_r3 = 2.0 * p_size;
        const double w1_1_1 = 10000.0 * (-(params.k[0] / (params.a * params.a)));
        const double w1_2_1 = 100.0 * ((-0.5) * (-(params.k[0] / (params.a * params.a))));
        const double w2_2_1 = 100.0 * (1.0 - (params.k[1] / params.a));
        const double p_m = params.m;
        const double u_max = params.u_max;
        if (!(finite(c_r3) && finite(w1_1_1) && finite(w1_2_1) && finite(w2_2_1))) {
            return Status::Param;
        }
        start_ = 0U;
        p_size_ = p_size;
        c_r3_ = c_r3;
        w1_1_1_ = w1_1_1;
        w1_2_1_ = w1_2_1;
        w2_2_1_ = w2_2_1;
        p_m_ = p_m;
        u_max_ = u_max;
        return Status::Ok;
    }

    /// Starts again: the deadline is N samples after tick `k`. The time of the reference counts
    /// from there.
    constexpr void arm(std::uint32_t k) noexcept
    {
        start_ = k;
    }

    /// u = (F1, F2) from tick `k`, which may wrap, and state x = (q1, q2, w1, w2). Where one of
    /// them is not finite, as at a state at which the inputs do not decouple the outputs, every u
    /// is 0; else the status is SATURATED where one was clipped.
    constexpr Axes<double, 2> step(std::uint32_t k, const std::array<double, 4>& x) const noexcept
    {
        Axes<double, 2> all{};
        if (!(finite(x[0]) && finite(x[1]) && finite(x[2]) && finite(x[3]))) {
            return {{}, {{Status::Input, Status::Input}}, Status::Input};
        }
        const std::uint32_t elapsed = k - start_;

        // The chain of each output.
        const double x1_1 = x[0];
        const double x2_1 = x[2];
        const double x1_2 = x[1];
        const double x2_2 = x[3];

        // The tracking error.
        const double t = static_cast<double>(elapsed) * h_;
        const double v_r1 = t * t;
        const double v_r2 = 1.0 + v_r1;
        const double reference0_1 = (p_size_ * v_r1) / v_r2;
        const double reference1_1 = (c_r3_ * t * (v_r2 - v_r1)) / (v_r2 * v_r2);
        const double v_r4 = t + 0.005;
        const double v_r5 = v_r4 * v_r4;
        const double v_r6 = 1.0 + v_r5;
        const double v_r7 = v_r6 * v_r6;
        const double s1 = (v_r7 + (4.0 * v_r5 * v_r5)) - (4.0 * v_r6 * v_r4 * v_r4);
        const double rho0_1 = (c_r3_ * (s1 - (v_r6 * v_r5))) / (v_r6 * v_r7);
        const double e1_1 = x1_1 - reference0_1;
        const double e2_1 = x2_1 - reference1_1;
        const double e1_2 = x1_2;
        const double e2_2 = x2_2;
        const std::uint32_t left = (elapsed < samples_) ? (samples_ - elapsed) : 0U;
        const double m0_1 = (static_cast<double>(left) < hold_) ? hold_ : static_cast<double>(left);
        double law_1{};

        // The exact law in samples.
        const double z1_1 = (w1_1_1_ * e1_1) + (w1_2_1_ * e2_1);
        const double z2_1 = w2_2_1_ * e2_1;
        law_1 = ((z1_1 + (z2_1 * m0_1)) / (m0_1 * (m0_1 - 1.0))) + rho0_1;
        const double m0_2 = (static_cast<double>(left) < hold_) ? hold_ : static_cast<double>(left);
        double law_2{};
        const double z1_2 = (w1_1_1_ * e1_2) + (w1_2_1_ * e2_2);
        const double z2_2 = w2_2_1_ * e2_2;
        law_2 = (z1_2 + (z2_2 * m0_2)) / (m0_2 * (m0_2 - 1.0));

        // The inputs that give all of them.
        const double s2 = ((p_m_ + (x1_2 * x1_2)) * law_1) + (x1_2 * law_2);
        const double control1 = s2 + (p_m_ * x1_2 * x2_1 * x2_2);
        const double control2 = (x1_2 * law_1) + law_2 + ((x2_1 * x2_1 * 0.5) - x1_1);
        if (static_cast<double>(left) > hold_) {
            all.status = Status::Ok;
        } else {
            all.status = Status::Hold;
        }
        if (finite(control1) && finite(control2)) {
            all.u[0] = control1;
            all.axes[0] = all.status;
            all.u[1] = control2;
            all.axes[1] = all.status;
            if (control1 > u_max_) {
                all.u[0] = u_max_;
                all.axes[0] = Status::Saturated;
                all.status = Status::Saturated;
            } else if (control1 < -u_max_) {
                all.u[0] = -u_max_;
                all.axes[0] = Status::Saturated;
                all.status = Status::Saturated;
            }
            if (control2 > u_max_) {
                all.u[1] = u_max_;
                all.axes[1] = Status::Saturated;
                all.status = Status::Saturated;
            } else if (control2 < -u_max_) {
                all.u[1] = -u_max_;
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
    /// 1/100, sample period.
    static constexpr double h_{0.01};
    /// Samples from the start to rest.
    static constexpr std::uint32_t samples_{30U};
    /// Samples to go at which the gains are held.
    static constexpr double hold_{4.0};

    std::uint32_t start_{}; // tick at which it was armed
    double p_size_{}; // parameter of an expression of the design
    double c_r3_{}; // derived from the parameters
    double w1_1_1_{}; // weight of x1 in the law
    double w1_2_1_{}; // weight of x2 in the law
    double w2_2_1_{}; // weight of x2 in the law
    double p_m_{}; // parameter of an expression of the design
    double u_max_{}; // bound of |u|
};

} // namespace ptc

#endif
