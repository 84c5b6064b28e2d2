/*
 * Prescribed-time controller quadrotor: order n = 2, mapping exp.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang cpp --n 2 --axes 4 --mu "exp(a=1)" --name quadrotor --tau=2 --t0=0 --eps=0.02 --limits=8,0.4,0.4,0.1 --poles="[[-4,-5],[-6,-7],[-6,-7],[-4,-5]]" --g="[1/m, 1/Ix, 1/Iy, 1/Iz]" --reference input --param Ix=0.012 --param Iy=0.013 --param Iz=0.022 --param m=1.2 --sample-time=1e-3
 * Version 0.1.0, design b1624acb7533.
 *
 * Plant: x1' = x2, x2' = f + g u. Time in s, x1 in any unit U, x2 in U/s, g u in U/s^2.
 * Goal: x = (r, r', ...) of the reference that each call is given at the deadline t0 + tau
 *       from any state at t0, up to the error that the hold at eps, sampling, f and clipping
 *       leave. The checks below say what is known of this design.
 * f is not part of the law: cancel its known terms before the call.
 * Axes: 4, each a chain of its own with this deadline and mapping. step computes what depends
 *       on time once.
 *   axis 1: k = 20, 9; u_max = 8; g = 1/m
 *   axis 2: k = 42, 13; u_max = 0.4; g = 1/Ix
 *   axis 3: k = 42, 13; u_max = 0.4; g = 1/Iy
 *   axis 4: k = 20, 9; u_max = 0.1; g = 1/Iz
 *
 * Parameters:
 *   tau = 2 [s], fixed: prescribed settling time
 *   t0 = 0 [s], fixed: start time
 *   eps = 0.02 [s], fixed: time-to-go at which the gains are held
 *   a = 1 [1/s], fixed: rate of stretched time
 *   Ix = 0.012, fixed: parameter of g
 *   Iy = 0.013, fixed: parameter of g
 *   Iz = 0.022, fixed: parameter of g
 *   m = 1.2, fixed: parameter of g
 *
 * Time mapping, with time-to-go T = t0 + tau - t and elapsed time Dt = t - t0; t in mu(t) is
 *       the stretched time since t0:
 *   mu(t)     = tau*(1 - exp(-a*t))
 *   kappa(Dt) = -ln(T/tau)/a
 * Derivatives r_k = mu^(k)(kappa(Dt)):
 *   r_k = (-1)^(k-1) a^k T
 *   r_1 = a*T
 *   r_2 = -a^2*T
 * Matrix BB_n, entry (i,j) = B_{i-1,j-1}(r_1, ...), and its next row b_n; zeros are left out:
 *   B_{0,0} = 1
 *   B_{1,1} = a*T
 *   B_{2,1} = -a^2*T
 *
 * Law, Theorem 1, with xi = BB_n e and t_kappa = kappa(Dt) + t0:
 *   u = (kappa'^n (pi0(xi, t_kappa) - b_n^T e) + r^(2))/g
 *   pi0 = -(k_1 xi_1 + k_2 xi_2)
 *   e_i = x_i - r^(i-1), where r^(0)..r^(2) are the reference and its derivatives, r[0]..r[2]
 *       of each call
 *   u = (sum_j gain_j e_j + r^(2))/g
 *   gain_j = inv_T^(n+1-j) row_j
 *   K1, K2, ...: K_i = k_i/a^(n+1-i)
 *   row_1 = -K1
 *   row_2 = 1 - K2
 *   inv_T = 1/T
 *
 * From t0 + tau - eps on, and after the deadline, the gains of T = eps are held (status HOLD).
 * |u| <= u_max: u is clipped to it (status SATURATED). Prolonged saturation voids the
 *       deadline.
 * Guard full: t, x and r are finite and t >= t0, or the call is refused (INPUT).
 * Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
 *       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
 *
 * Checks of the design (details: ptc-codegen check):
 *   membership: sound: exp is of class M for all its parameters.
 *   growth: sound: x and u go to 0 at the deadline.
 *   sampling: undecided: axis 1: r is known at the samples alone; with a constant r: eps =
 *       0.02 s is 5 times the minimum for a period of 0.001 s.
 *   deadline: not checked: `error` is not given.
 *   loop: not checked: `x0_max` is not given.
 *   envelope: not checked: `x_max` is not given.
 *
 * Operations of one step, without input checks and clipping: 19 additions or comparisons, 14
 *       multiplications, 5 divisions.
 */
#ifndef QUADROTOR_E695D910_HPP
#define QUADROTOR_E695D910_HPP

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
struct QuadrotorParams {
};

/// Feedback gains at one time.
struct [[nodiscard]] QuadrotorGains {
    std::array<double, 8> gain{}; ///< u input_gain = gain[2*axis] e[0] + ... + gain[2*axis + 1] e[1] + r[2], e[i] = x[i] - r[i]
    std::array<double, 4> input_gain{}; ///< g
    std::array<double, 4> u_max{}; ///< bound of |u| of each axis
    Status status{Status::Input}; ///< Ok or Hold; negative where there are no gains

    /// u of one axis from its state x = (x1, x1', ...), its reference r = (r, r', ...) and the
    /// gains.
    /// On a negative status u is 0 and nothing has changed.
    constexpr Control<double> axis(std::uint32_t axis, const std::array<double, 2>& x, const std::array<double, 3>& r) const noexcept
    {
        if (status < Status::Ok) {
            return {0.0, status};
        }
        if (!(axis < 4U)) {
            return {0.0, Status::Input};
        }
        const double e1 = x[0] - r[0];
        const double e2 = x[1] - r[1];
        const double s1 = gain[2U * axis] * e1;
        const double v1 = s1 + (gain[(2U * axis) + 1U] * e2) + r[2];
        const double g = input_gain[axis];
        const double v = ((g < 0.0) || (g > 0.0)) ? (v1 / g) : std::numeric_limits<double>::quiet_NaN();
        if (finite(v) && (absolute(v) <= u_max[axis])) {
            return {v, status};
        } else if (finite(x[0])
            && finite(x[1])
            && finite(r[0])
            && finite(r[1])
            && finite(r[2])) {
            if (finite(v)) {
                if (v > u_max[axis]) {
                    return {u_max[axis], Status::Saturated};
                } else {
                    return {-u_max[axis], Status::Saturated};
                }
            } else {
                return {0.0, Status::Range};
            }
        } else {
            return {0.0, Status::Input};
        }
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
};

/// Controller: set by init, changed by arm and by what is not const.
class Quadrotor {
public:
    using Params = QuadrotorParams;
    using State = std::array<double, 2>;
    using Gains = QuadrotorGains;

    /// Takes the parameters and arms at params.t0 (or the fixed t0). Ok, or Param with nothing
    /// changed.
    [[nodiscard]] constexpr Status init(const Params&) noexcept
    {
        Quadrotor built{};
        built.t0_ = 0.0;
        built.deadline_ = 0.0;
        built.correction_ = 0.0;
        const Status status = built.arm(0.0);
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
        const double deadline = t0 + 2.0;
        const double v1 = deadline - t0;
        const double correction = (t0 - (deadline - v1)) + (2.0 - v1);
        if (!finite(deadline)) {
            return Status::Param;
        }
        t0_ = t0;
        deadline_ = deadline;
        correction_ = correction;
        return Status::Ok;
    }

    /// The gains at time t [s] for all axes, from which step computes u of each.
    constexpr Gains tick(double t) const noexcept
    {
        if (!(finite(t) && (t >= t0_))) {
            return {};
        }
        const double past = (t - deadline_) - correction_;
        const double late = (past < -0.02) ? past : -0.02;
        const double inv_T = (-1.0) / late;
        const double v1 = (-20.0) * inv_T * inv_T;
        const double v2 = (-8.0) * inv_T;
        const double v3 = (-42.0) * inv_T * inv_T;
        const double v4 = (-12.0) * inv_T;
        Gains gains{};
        gains.gain[0] = v1;
        gains.gain[1] = v2;
        gains.gain[2] = v3;
        gains.gain[3] = v4;
        gains.gain[4] = v3;
        gains.gain[5] = v4;
        gains.gain[6] = v1;
        gains.gain[7] = v2;
        gains.input_gain[0] = 0.8333333333333334;
        gains.input_gain[1] = 83.33333333333333;
        gains.input_gain[2] = 76.92307692307692;
        gains.input_gain[3] = 45.45454545454545;
        gains.u_max[0] = 8.0;
        gains.u_max[1] = 0.4;
        gains.u_max[2] = 0.4;
        gains.u_max[3] = 0.1;
        if (late < -0.02) {
            gains.status = Status::Ok;
        } else {
            gains.status = Status::Hold;
        }
        return gains;
    }

    /// u of 4 axes at time t [s], from the state x = (x1, x1', ...) and the reference r = (r, r',
    /// ...) of each. Its status is that of the first axis that fails, and then every u is 0; else
    /// SATURATED where an axis is.
    constexpr Axes<double, 4> step(double t, const std::array<std::array<double, 2>, 4>& x, const std::array<std::array<double, 3>, 4>& r) const noexcept
    {
        Axes<double, 4> all{};
        if (!(finite(t) && (t >= t0_))) {
            return {{}, {{Status::Input, Status::Input, Status::Input, Status::Input}}, Status::Input};
        }
        const double past = (t - deadline_) - correction_;
        const double late = (past < -0.02) ? past : -0.02;
        const double inv_T = (-1.0) / late;
        const double v1 = (-20.0) * inv_T * inv_T;
        const double v2 = (-8.0) * inv_T;
        const double v3 = (-42.0) * inv_T * inv_T;
        const double v4 = (-12.0) * inv_T;
        std::array<double, 8> gain{};
        gain[0] = v1;
        gain[1] = v2;
        gain[2] = v3;
        gain[3] = v4;
        gain[4] = v3;
        gain[5] = v4;
        gain[6] = v1;
        gain[7] = v2;
        std::array<double, 4> input_gain{};
        input_gain[0] = 0.8333333333333334;
        input_gain[1] = 83.33333333333333;
        input_gain[2] = 76.92307692307692;
        input_gain[3] = 45.45454545454545;
        std::array<double, 4> u_max{};
        u_max[0] = 8.0;
        u_max[1] = 0.4;
        u_max[2] = 0.4;
        u_max[3] = 0.1;
        if (late < -0.02) {
            all.status = Status::Ok;
        } else {
            all.status = Status::Hold;
        }
        std::array<double, 4> wanted{};
        for (std::uint32_t axis = 0U; axis < 4U; axis++) {
            const double e1 = x[axis][0] - r[axis][0];
            const double e2 = x[axis][1] - r[axis][1];
            const double v5 = (gain[2U * axis] * e1) + (gain[(2U * axis) + 1U] * e2) + r[axis][2];
            const double g = input_gain[axis];
            wanted[axis] = ((g < 0.0) || (g > 0.0)) ? (v5 / g) : std::numeric_limits<double>::quiet_NaN();
        }
        all.u[0] = wanted[0];
        all.u[1] = wanted[1];
        all.u[2] = wanted[2];
        all.u[3] = wanted[3];
        for (std::uint32_t axis = 0U; axis < 4U; axis++) {
            all.axes[axis] = all.status;
        }
        std::uint32_t outside = 0U;
        for (std::uint32_t axis = 0U; axis < 4U; axis++) {
            const double v = wanted[axis];
            if (!(finite(v) && (absolute(v) <= u_max[axis]))) {
                outside = 1U;
                break;
            }
        }
        if (outside == 1U) {
            for (std::uint32_t axis = 0U; axis < 4U; axis++) {
                const double v = wanted[axis];
                if (!(finite(v) && (absolute(v) <= u_max[axis]))) {
                    if (finite(x[axis][0])
                        && finite(x[axis][1])
                        && finite(r[axis][0])
                        && finite(r[axis][1])
                        && finite(r[axis][2])) {
                        if (finite(v)) {
                            if (u_max[axis] < v) {
                                all.u[axis] = u_max[axis];
                                all.axes[axis] = Status::Saturated;
                            } else {
                                all.u[axis] = -u_max[axis];
                                all.axes[axis] = Status::Saturated;
                            }
                        } else {
                            all.axes[axis] = Status::Range;
                        }
                    } else {
                        all.axes[axis] = Status::Input;
                    }
                    if (all.status >= Status::Ok) {
                        all.status = all.axes[axis];
                    }
                }
            }
            if (all.status < Status::Ok) {
                for (std::uint32_t axis = 0U; axis < 4U; axis++) {
                    all.u[axis] = 0.0;
                }
            }
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

    double t0_{}; // start time
    double deadline_{}; // t0 + tau, rounded
    double correction_{}; // low part of t0 + tau (compensated sum)
};

} // namespace ptc

#endif
