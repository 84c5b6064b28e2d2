/*
 * Prescribed-time controller ptc_rational_inputs4: outputs of order 1, 1, 1, 1, mapping rational.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang cpp --mu rational --name ptc_rational_inputs4 --states="p, q, r, s" --inputs=a,b,c,d --outputs="p, q, r, s" --dynamics="sin(q)*b + 3*c + r*d, 2*a + p*b + m*d + p*r, r*a + (3 + q^2)*b + s*c, a - p*c + 4*d" --allow=zeros
 * Version 0.1.0, design d53160516d12.
 *
 * Plant, with the inputs a, b, c, d: p' = sin(q)*b + 3*c + r*d, q' = 2*a + p*b + m*d + p*r,
 *       r' = r*a + (3 + q^2)*b + s*c, s' = a - p*c + 4*d, output 1 = p, output 2 = q, output
 *       3 = r, output 4 = s. Time in s.
 * Goal: every output with its derivatives is 0 at the deadline t0 + tau from any state at t0,
 *       up to the error that the hold at eps, sampling, what differs from the model and
 *       clipping leave. The checks below say what is known of this design.
 * The law takes the plant to be the model. What differs from it is not part of the law.
 * Outputs: 4, each with a law of its own, with this deadline and mapping; u_max is of the
 *       input of this number.
 *
 * SAMPLE PERIOD NOT GIVEN: the gain held at eps limits the sample period for which the loop
 *       is stable. Run the emitted step with a model of the plant, sampled.
 *
 * Parameters:
 *   tau: prescribed settling time [s], from 1e-150 to 1e150
 *   t0: start time [s], finite
 *   eps: time-to-go at which the gains are held [s], >= 1e-150, < tau
 *   u_max: bound of |u| [unit of u], > 0, infinity allowed
 *   a: rate of stretched time [1/s], from 1e-150 to 1e150
 *   k: gains of pi0 = -k_1 xi_1, finite; k[0] is k_1 [1/s]
 *   m: parameter of the model, finite
 *
 * Time mapping, with time-to-go T = t0 + tau - t and elapsed time Dt = t - t0; t in mu(t) is
 *       the stretched time since t0:
 *   mu(t)     = tau*a*t/(1 + a*t)
 *   kappa(Dt) = Dt/(a*T)
 * Derivatives r_k = mu^(k)(kappa(Dt)):
 *   r_k = (-1)^(k-1) k! (a/tau)^k T^(k+1)
 *   r_1 = tau^-1*a*T^2
 * Matrix BB_n, entry (i,j) = B_{i-1,j-1}(r_1, ...), and its next row b_n; zeros are left out:
 *   B_{0,0} = 1
 *
 * Law of each output, Theorem 1, with xi = BB_n x and t_kappa = kappa(Dt) + t0:
 *   v_i = kappa'^n (pi0(xi, t_kappa) - b_n^T x) = sum_j gain_j x_j
 *   pi0 = -k_1 xi_1
 *   gain_j = inv_T_squared^(n+1-j) row_j
 *   K1, K2, ...: K_i = k_i/(tau^-1*a)^(n+1-i)
 *   row_1 = -K1
 *   inv_T_squared = 1/T^2
 * Output 1, of order n = 1:
 *   x_1 = p
 * Output 2, of order n = 1:
 *   x_1 = q
 *   f_2 = p*r
 * Output 3, of order n = 1:
 *   x_1 = r
 * Output 4, of order n = 1:
 *   x_1 = s
 * u of D u = w with w_i = v_i - f_i, by elimination with pivots:
 *   D = [[0, sin(q), 3, r], [2, p, 0, m], [r, 3 + q^2, s, 0], [1, 0, -p, 4]]
 *
 * From t0 + tau - eps on, and after the deadline, the gains of T = eps are held (status HOLD).
 * |u| <= u_max: u is clipped to it (status SATURATED). Prolonged saturation voids the
 *       deadline.
 * Guard full: t and x are finite and t >= t0, or the call is refused (INPUT).
 * Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
 *       machine without fused multiply-add (gcc, clang: -ffp-contract=off) and with the same
 *       mathematical library.
 *
 * Checks of the design (details: ptc-codegen check):
 *   membership: sound: rational is of class M for all its parameters.
 *   growth: not checked: the gains are left to run time: their poles must lie left of -n rho.
 *   sampling: not checked: `sample_time` is not given.
 *   deadline: not checked: `error` is not given.
 *   loop: not checked: it needs a value of `tau`.
 *   envelope: not checked: `x_max` is not given.
 *   zeros: sound: none: the relative degrees are 1, 1, 1, 1, whose sum is the number of
 *       states.
 *
 * Operations of one step, without input checks and clipping: 38 additions or comparisons, 33
 *       multiplications, 14 divisions, 1 function call.
 */
#ifndef PTC_RATIONAL_INPUTS4_358BB88A_HPP
#define PTC_RATIONAL_INPUTS4_358BB88A_HPP

#include <array>
#include <cfloat>
#include <cmath>
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
struct PtcRationalInputs4Params {
    double tau{}; ///< prescribed settling time [s], from 1e-150 to 1e150
    double t0{}; ///< start time [s], finite
    double eps{}; ///< time-to-go at which the gains are held [s], >= 1e-150, < tau
    double u_max{}; ///< bound of |u| [unit of u], > 0, infinity allowed
    double a{}; ///< rate of stretched time [1/s], from 1e-150 to 1e150
    std::array<double, 1> k{}; ///< gains of pi0 = -k_1 xi_1, finite; k[0] is k_1 [1/s]
    double m{}; ///< parameter of the model, finite
};

/// Controller: set by init, changed by arm and by what is not const.
class PtcRationalInputs4 {
public:
    using Params = PtcRationalInputs4Params;
    using State = std::array<double, 4>;

    /// Takes the parameters and arms at params.t0 (or the fixed t0). Ok, or Param with nothing
    /// changed.
    [[nodiscard]] constexpr Status init(const Params& params) noexcept
    {
        PtcRationalInputs4 built{};
        const double tau = params.tau;
        const double t0 = params.t0;
        const double eps = params.eps;
        const double u_max = params.u_max;
        const double a = params.a;
        const double k1 = params.k[0];
        const double p_m = params.m;
        if (!(finite(tau)
                && (1e-150 <= tau)
                && (tau <= 1e150)
                && finite(t0)
                && (eps >= 1e-150)
                && (u_max > 0.0)
                && finite(a)
                && (1e-150 <= a)
                && (a <= 1e150)
                && finite(k1)
                && finite(p_m)
                && (eps < tau))) {
            return Status::Param;
        }
        const double rate_axis1 = a / tau;
        const double K1_axis1 = k1 / rate_axis1;
        const double c1_axis1 = -K1_axis1;
        const double hold_from = -eps;
        const double size_K1_axis1 = (absolute(k1) <= 0.0) ? 1e-200 : absolute(K1_axis1);
        const double size_p_m = (absolute(p_m) <= 0.0) ? 1e-200 : absolute(p_m);
        if (!((size_K1_axis1 >= 1e-200)
                && (size_p_m >= 1e-200)
                && finite(c1_axis1)
                && finite(hold_from))) {
            return Status::Param;
        }
        built.tau_ = tau;
        built.c1_axis1_ = c1_axis1;
        built.eps_ = eps;
        built.hold_from_ = hold_from;
        built.p_m_ = p_m;
        built.u_max_ = u_max;
        built.t0_ = 0.0;
        built.deadline_ = 0.0;
        built.correction_ = 0.0;
        const Status status = built.arm(t0);
        if (status == Status::Ok) {
            *this = built;
        }
        return status;
    }

    /// Starts again at t0 [s].
    /// Ok, or Param with nothing changed.
    [[nodiscard]] constexpr Status arm(double t0) noexcept
    {
        if (!finite(t0)) {
            return Status::Param;
        }
        const double deadline = t0 + tau_;
        const double v1 = deadline - t0;
        const double correction = (t0 - (deadline - v1)) + (tau_ - v1);
        if (!finite(deadline)) {
            return Status::Param;
        }
        t0_ = t0;
        deadline_ = deadline;
        correction_ = correction;
        return Status::Ok;
    }

    /// u = (a, b, c, d) at time t [s] and state x = (p, q, r, s). Where one of them is not finite,
    /// as at a state at which the inputs do not decouple the outputs, every u is 0; else the status
    /// is SATURATED where one was clipped.
    Axes<double, 4> step(double t, const std::array<double, 4>& x) const noexcept
    {
        Axes<double, 4> all{};
        const double x1 = x[0];
        const double x2 = x[1];
        const double x3 = x[2];
        const double x4 = x[3];
        if (!(finite(t) && (t >= t0_) && finite(x1) && finite(x2) && finite(x3) && finite(x4))) {
            return {{}, {{Status::Input, Status::Input, Status::Input, Status::Input}}, Status::Input};
        }
        const double past = (t - deadline_) - correction_;
        const double late = (past < hold_from_) ? past : hold_from_;
        const double v1 = late * late;
        const double wanted_axis1 = (c1_axis1_ * x1) / v1;
        const double drift_axis2 = x1 * x3;
        const double wanted_axis2 = ((c1_axis1_ * x2) / v1) - drift_axis2;
        const double wanted_axis3 = (c1_axis1_ * x3) / v1;
        const double wanted_axis4 = (c1_axis1_ * x4) / v1;
        const std::array<double, 16> inputs_a{{
            0.0,
            std::sin(x2),
            3.0,
            x3,
            2.0,
            x1,
            0.0,
            p_m_,
            x3,
            3.0 + (x2 * x2),
            x4,
            0.0,
            1.0,
            0.0,
            -x1,
            4.0,
        }};
        const std::array<double, 4> given_inputs{{
            wanted_axis1,
            wanted_axis2,
            wanted_axis3,
            wanted_axis4,
        }};
        const auto inputs = eliminate(given_inputs, inputs_a);
        const double control1 = inputs[0];
        const double control2 = inputs[1];
        const double control3 = inputs[2];
        const double control4 = inputs[3];
        if (late < hold_from_) {
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
            if (control3 > u_max_) {
                all.u[2] = u_max_;
                all.axes[2] = Status::Saturated;
                all.status = Status::Saturated;
            } else if (control3 < -u_max_) {
                all.u[2] = -u_max_;
                all.axes[2] = Status::Saturated;
                all.status = Status::Saturated;
            }
            if (control4 > u_max_) {
                all.u[3] = u_max_;
                all.axes[3] = Status::Saturated;
                all.status = Status::Saturated;
            } else if (control4 < -u_max_) {
                all.u[3] = -u_max_;
                all.axes[3] = Status::Saturated;
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

    double tau_{}; // prescribed settling time
    double c1_axis1_{}; // coefficient of x1, axis 1
    double t0_{}; // start time
    double deadline_{}; // t0 + tau, rounded
    double correction_{}; // low part of t0 + tau (compensated sum)
    double eps_{}; // time-to-go at which the gains are held
    double hold_from_{}; // -eps: later than this the gains are held
    double p_m_{}; // parameter of an expression of the design
    double u_max_{}; // bound of |u|
};

} // namespace ptc

#endif
