/*
 * Prescribed-time controller track: order n = 2, mapping exp.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang cpp --n 2 --mu "exp(a=1)" --name track --tau=1 --t0=0 --eps=4.42e-2 --u-max=50 --poles=-4,-5 --g="2/3" --reference="1/10*sin(2*t + phase)" --param phase=0.3 --sample-time=1e-3 --error=1e-3,1e-2 --x0-max=0.5,0.5
 * Version 0.1.0, design fc9bf2044aac.
 *
 * Plant: x1' = x2, x2' = f + g u. Time in s, x1 in any unit U, x2 in U/s, g u in U/s^2.
 * Goal: x = (r, r', ...) of the reference r(t) at the deadline t0 + tau from any state at t0,
 *       up to the error that the hold at eps, sampling, f and clipping leave. The checks
 *       below say what is known of this design.
 * f is not part of the law: cancel its known terms before the call.
 *
 * Parameters:
 *   tau = 1 [s], fixed: prescribed settling time
 *   t0 = 0 [s], fixed: start time
 *   eps = 4.42e-2 [s], fixed: time-to-go at which the gains are held
 *   u_max = 50 [unit of u], fixed: bound of |u|
 *   a = 1 [1/s], fixed: rate of stretched time
 *   k_1 = 20 [1/s^2], fixed: gain of xi_1
 *   k_2 = 9 [1/s], fixed: gain of xi_2
 *   phase = 0.3, fixed: parameter of reference
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
 *   e_i = x_i - r^(i-1), with the reference r = 1/10*sin(2*t + phase)
 *   r^(1) = cos(phase + 2*t)/5
 *   r^(2) = -2*sin(phase + 2*t)/5
 *   g = 2/3
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
 * Guard full: t and x are finite and t >= t0, or the call is refused (INPUT).
 * Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
 *       machine without fused multiply-add (gcc, clang: -ffp-contract=off) and with the same
 *       mathematical library.
 *
 * Checks of the design (details: ptc-codegen check):
 *   membership: sound: exp is of class M for all its parameters.
 *   growth: sound: x and u go to 0 at the deadline.
 *   sampling: undecided: r is known at the samples alone; with a constant r: eps = 0.0442 s
 *       is 11.05 times the minimum for a period of 0.001 s.
 *   deadline: sound: |x| <= 0.001 for every eps <= 0.04437 s.
 *   loop: not checked: the plant follows a reference that moves between the samples at which
 *       it is known, and what that leaves is not examined.
 *   envelope: not checked: `x_max` is not given.
 *
 * Operations of one step, without input checks and clipping: 8 additions or comparisons, 9
 *       multiplications, 1 division, 2 function calls.
 */
#ifndef TRACK_AD08427D_HPP
#define TRACK_AD08427D_HPP

#include <array>
#include <cfloat>
#include <cmath>
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
struct TrackParams {
};

/// Controller: set by init, changed by arm and by what is not const.
class Track {
public:
    using Params = TrackParams;
    using State = std::array<double, 2>;

    /// Takes the parameters and arms at params.t0 (or the fixed t0). Ok, or Param with nothing
    /// changed.
    [[nodiscard]] constexpr Status init(const Params&) noexcept
    {
        Track built{};
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
        const double deadline = t0 + 1.0;
        const double v1 = deadline - t0;
        const double correction = (t0 - (deadline - v1)) + (1.0 - v1);
        if (!finite(deadline)) {
            return Status::Param;
        }
        t0_ = t0;
        deadline_ = deadline;
        correction_ = correction;
        return Status::Ok;
    }

    /// u at time t [s] and state x = (x1, x1', ...).
    /// On a negative status u is 0 and nothing has changed.
    Control<double> step(double t, const std::array<double, 2>& x) const noexcept
    {
        if (!(finite(t) && (t >= t0_))) {
            return {0.0, Status::Input};
        }
        const double past = (t - deadline_) - correction_;
        const double late = (past < -0.0442) ? past : -0.0442;
        const double inv_T = (-1.0) / late;
        const double v1 = (2.0 * t) + 0.3;
        const double v2 = std::sin(v1);
        const double reference0 = 0.1 * v2;
        const double e1 = x[0] - reference0;
        const double reference1 = std::cos(v1) * 0.2;
        const double e2 = x[1] - reference1;
        const double reference2 = v2 * (-0.4);
        const double v = (((((-20.0) * e1 * inv_T) + ((-8.0) * e2)) * inv_T) + reference2) * 1.5;
        if (finite(v) && (absolute(v) <= 50.0) && (late < -0.0442)) {
            return {v, Status::Ok};
        } else if (finite(x[0]) && finite(x[1])) {
            if (finite(v)) {
                if (v > 50.0) {
                    return {50.0, Status::Saturated};
                } else if (v < -50.0) {
                    return {-50.0, Status::Saturated};
                } else {
                    return {v, Status::Hold};
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

    double t0_{}; // start time
    double deadline_{}; // t0 + tau, rounded
    double correction_{}; // low part of t0 + tau (compensated sum)
};

} // namespace ptc

#endif
