/*
 * Prescribed-time controller two_link: outputs of order 2, 2, mapping rational.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang cpp --mu "rational(a=1/20)" --name two_link --tau=20 --eps=1 --limits=120,60 --poles=-1,-1.5 --states="q1, q2, w1, w2" --inputs=M1,M2 --inertia="[[(m1 + m2)*l1^2 + m2*l2^2 + 2*m2*l1*l2*cos(q2), m2*l2^2 + m2*l1*l2*cos(q2)], [m2*l2^2 + m2*l1*l2*cos(q2), m2*l2^2]]" --bias="-m2*l1*l2*sin(q2)*(2*w1*w2 + w2^2) + (m1 + m2)*grav*l1*cos(q1) + m2*grav*l2*cos(q1 + q2), m2*l1*l2*sin(q2)*w1^2 + m2*grav*l2*cos(q1 + q2)" --param grav=9.81 --param l1=0.6 --param l2=0.5 --param m1=2 --param m2=1.5
 * Version 0.1.0, design cf1990ed927f.
 *
 * Plant, with the inputs M1, M2: q = (q1, q2), q' = (w1, w2), M q'' + bias = u, M = [[(m1 +
 *       m2)*l1^2 + m2*l2^2 + 2*m2*l1*l2*cos(q2), m2*l2^2 + m2*l1*l2*cos(q2)], [m2*l2^2 +
 *       m2*l1*l2*cos(q2), m2*l2^2]], bias = [-m2*l1*l2*sin(q2)*(2*w1*w2 + w2^2) + (m1 +
 *       m2)*grav*l1*cos(q1) + m2*grav*l2*cos(q1 + q2), m2*l1*l2*sin(q2)*w1^2 +
 *       m2*grav*l2*cos(q1 + q2)]. Time in s.
 * Goal: every output with its derivatives is 0 at the deadline t0 + tau from any state at t0,
 *       up to the error that the hold at eps, sampling, what differs from the model and
 *       clipping leave. The checks below say what is known of this design.
 * The law takes the plant to be the model. What differs from it is not part of the law.
 * Outputs: 2, each with a law of its own, with this deadline and mapping; u_max is of the
 *       input of this number.
 *   output 1: u_max = 120
 *   output 2: u_max = 60
 *
 * SAMPLE PERIOD NOT GIVEN: the gain held at eps limits the sample period for which the loop
 *       is stable. Run the emitted step with a model of the plant, sampled.
 *
 * Parameters:
 *   tau = 20 [s], fixed: prescribed settling time
 *   eps = 1 [s], fixed: time-to-go at which the gains are held
 *   a = 1/20 [1/s], fixed: rate of stretched time
 *   k_1 = 1.5 [1/s^2], fixed: gain of xi_1
 *   k_2 = 2.5 [1/s], fixed: gain of xi_2
 *   grav = 9.81, fixed: parameter of the model
 *   l1 = 0.6, fixed: parameter of the model
 *   l2 = 0.5, fixed: parameter of the model
 *   m1 = 2, fixed: parameter of the model
 *   m2 = 1.5, fixed: parameter of the model
 *   t0: start time [s], finite
 *
 * Time mapping, with time-to-go T = t0 + tau - t and elapsed time Dt = t - t0; t in mu(t) is
 *       the stretched time since t0:
 *   mu(t)     = tau*a*t/(1 + a*t)
 *   kappa(Dt) = Dt/(a*T)
 * Derivatives r_k = mu^(k)(kappa(Dt)):
 *   r_k = (-1)^(k-1) k! (a/tau)^k T^(k+1)
 *   r_1 = tau^-1*a*T^2
 *   r_2 = -2*tau^-2*a^2*T^3
 * Matrix BB_n, entry (i,j) = B_{i-1,j-1}(r_1, ...), and its next row b_n; zeros are left out:
 *   B_{0,0} = 1
 *   B_{1,1} = tau^-1*a*T^2
 *   B_{2,1} = -2*tau^-2*a^2*T^3
 *
 * Law of each output, Theorem 1, with xi = BB_n x and t_kappa = kappa(Dt) + t0:
 *   v_i = kappa'^n (pi0(xi, t_kappa) - b_n^T x) = sum_j gain_j x_j
 *   pi0 = -(k_1 xi_1 + k_2 xi_2)
 *   gain_j = inv_T_squared^(n+1-j) row_j
 *   K1, K2, ...: K_i = k_i/(tau^-1*a)^(n+1-i)
 *   row_1 = -K1
 *   row_2 = -K2 + 2*T
 *   inv_T_squared = 1/T^2
 * Output 1, of order n = 2:
 *   x_1 = q1
 *   x_2 = w1
 * Output 2, of order n = 2:
 *   x_1 = q2
 *   x_2 = w2
 * u = M v + bias
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
 *   growth: sound: x and u go to 0 at the deadline.
 *   sampling: not checked: `sample_time` is not given.
 *   deadline: not checked: `error` is not given.
 *   loop: not checked: `sample_time` is not given.
 *   envelope: not checked: `x_max` is not given.
 *   zeros: sound: none: the relative degrees are 2, 2, whose sum is the number of states.
 *
 * Operations of one step, without input checks and clipping: 17 additions or comparisons, 26
 *       multiplications, 1 division, 4 function calls.
 */
#ifndef TWO_LINK_61A369E9_HPP
#define TWO_LINK_61A369E9_HPP

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
struct TwoLinkParams {
    double t0{}; ///< start time [s], finite
};

/// Controller: set by init, changed by arm and by what is not const.
class TwoLink {
public:
    using Params = TwoLinkParams;
    using State = std::array<double, 4>;

    /// Takes the parameters and arms at params.t0 (or the fixed t0). Ok, or Param with nothing
    /// changed.
    [[nodiscard]] constexpr Status init(const Params& params) noexcept
    {
        TwoLink built{};
        const double t0 = params.t0;
        if (!finite(t0)) {
            return Status::Param;
        }
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
        const double deadline = t0 + 20.0;
        const double v1 = deadline - t0;
        const double correction = (t0 - (deadline - v1)) + (20.0 - v1);
        if (!finite(deadline)) {
            return Status::Param;
        }
        t0_ = t0;
        deadline_ = deadline;
        correction_ = correction;
        return Status::Ok;
    }

    /// u = (M1, M2) at time t [s] and state x = (q1, q2, w1, w2). Where one of them is not finite,
    /// as at a state at which the inputs do not decouple the outputs, every u is 0; else the status
    /// is SATURATED where one was clipped.
    Axes<double, 2> step(double t, const std::array<double, 4>& x) const noexcept
    {
        Axes<double, 2> all{};
        const double x1 = x[0];
        const double x2 = x[1];
        const double x3 = x[2];
        const double x4 = x[3];
        if (!(finite(t) && (t >= t0_) && finite(x1) && finite(x2) && finite(x3) && finite(x4))) {
            return {{}, {{Status::Input, Status::Input}}, Status::Input};
        }
        const double past = (t - deadline_) - correction_;
        const double late = (past < -1.0) ? past : -1.0;
        const double row2_axis1 = ((-2.0) * late) - 1000.0;
        const double inv_T_squared_axis1 = 1.0 / (late * late);
        const double s1 = ((-240000.0) * x1 * inv_T_squared_axis1) + (row2_axis1 * x3);
        const double wanted_axis1 = s1 * inv_T_squared_axis1;
        const double s2 = ((-240000.0) * x2 * inv_T_squared_axis1) + (row2_axis1 * x4);
        const double wanted_axis2 = s2 * inv_T_squared_axis1;
        const double v1 = std::sin(x2);
        const double v2 = 7.3575 * std::cos(x1 + x2);
        const double v3 = std::cos(x2);
        const double v4 = 0.375 + (0.44999999999999996 * v3);
        const double s3 = (1.635 + (0.8999999999999999 * v3)) * wanted_axis1;
        const double s4 = (-0.44999999999999996) * v1 * ((2.0 * x3 * x4) + (x4 * x4));
        const double control1 = s3 + (v4 * wanted_axis2) + (s4 + (20.601 * std::cos(x1)) + v2);
        const double s5 = (v4 * wanted_axis1) + (0.375 * wanted_axis2);
        const double control2 = s5 + ((0.44999999999999996 * v1 * (x3 * x3)) + v2);
        if (late < -1.0) {
            all.status = Status::Ok;
        } else {
            all.status = Status::Hold;
        }
        if (finite(control1) && finite(control2)) {
            all.u[0] = control1;
            all.axes[0] = all.status;
            all.u[1] = control2;
            all.axes[1] = all.status;
            if (control1 > 120.0) {
                all.u[0] = 120.0;
                all.axes[0] = Status::Saturated;
                all.status = Status::Saturated;
            } else if (control1 < -120.0) {
                all.u[0] = -120.0;
                all.axes[0] = Status::Saturated;
                all.status = Status::Saturated;
            }
            if (control2 > 60.0) {
                all.u[1] = 60.0;
                all.axes[1] = Status::Saturated;
                all.status = Status::Saturated;
            } else if (control2 < -60.0) {
                all.u[1] = -60.0;
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

    double t0_{}; // start time
    double deadline_{}; // t0 + tau, rounded
    double correction_{}; // low part of t0 + tau (compensated sum)
};

} // namespace ptc

#endif
