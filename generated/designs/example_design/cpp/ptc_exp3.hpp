/*
 * Prescribed-time controller ptc_exp3: order n = 3, mapping exp.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang cpp --n 3 --mu "exp(a=1)"
 * Version 0.1.0, design 083a85e9f77c.
 *
 * Plant: x1' = x2, ..., x3' = f + u. Time in s, x1 in any unit U, x2 in U/s, x3 in U/s^2, u
 *       in U/s^3.
 * Goal: x = 0 at the deadline t0 + tau from any state at t0, up to the error that the hold at
 *       eps, sampling, f and clipping leave. The checks below say what is known of this
 *       design.
 * f is not part of the law: cancel its known terms before the call.
 *
 * SAMPLE PERIOD NOT GIVEN: the held gains grow as eps falls, and the loop is stable only for
 *       sample periods below a limit that depends on eps and the gains. ptc-codegen check
 *       finds it once tau, eps, the gains and --sample-time are given.
 *
 * Parameters:
 *   a = 1 [1/s], fixed: rate of stretched time
 *   tau: prescribed settling time [s], from 1e-150 to 1e150
 *   t0: start time [s], finite
 *   eps: time-to-go at which the gains are held [s], >= 1e-150, < tau
 *   u_max: bound of |u| [unit of u], > 0, infinity allowed
 *   k: gains of pi0 = -(k_1 xi_1 + ... + k_3 xi_3), finite; k[0] is k_1 [1/s^3], k[1] is k_2
 *       [1/s^2], k[2] is k_3 [1/s]
 *
 * Time mapping, with time-to-go T = t0 + tau - t and elapsed time Dt = t - t0; t in mu(t) is
 *       the stretched time since t0:
 *   mu(t)     = tau*(1 - exp(-a*t))
 *   kappa(Dt) = -ln(T/tau)/a
 * Derivatives r_k = mu^(k)(kappa(Dt)):
 *   r_k = (-1)^(k-1) a^k T
 *   r_1 = a*T
 *   r_2 = -a^2*T
 *   r_3 = a^3*T
 * Matrix BB_n, entry (i,j) = B_{i-1,j-1}(r_1, ...), and its next row b_n; zeros are left out:
 *   B_{0,0} = 1
 *   B_{1,1} = a*T
 *   B_{2,1} = -a^2*T
 *   B_{2,2} = a^2*T^2
 *   B_{3,1} = a^3*T
 *   B_{3,2} = -3*a^3*T^2
 *
 * Law, Theorem 1, with xi = BB_n x and t_kappa = kappa(Dt) + t0:
 *   u = kappa'^n (pi0(xi, t_kappa) - b_n^T x)
 *   pi0 = -(k_1 xi_1 + ... + k_3 xi_3)
 *   u = sum_j gain_j x_j
 *   gain_j = inv_T^(n+1-j) row_j
 *   K1, K2, ...: K_i = k_i/a^(n+1-i)
 *   row_1 = -K1
 *   row_2 = -1 - K2 + K3
 *   row_3 = 3 - K3
 *   inv_T = 1/T
 *
 * From t0 + tau - eps on, and after the deadline, the gains of T = eps are held (status HOLD).
 * |u| <= u_max: u is clipped to it (status SATURATED). Prolonged saturation voids the
 *       deadline.
 * Guard full: t and x are finite and t >= t0, or the call is refused (INPUT).
 * Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
 *       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
 *
 * Checks of the design (details: ptc-codegen check):
 *   membership: sound: exp is of class M for all its parameters.
 *   growth: not checked: the gains are left to run time: their poles must lie left of -n rho.
 *   sampling: not checked: `sample_time` is not given.
 *   deadline: not checked: `error` is not given.
 *   loop: not checked: it needs a value of `tau`.
 *   envelope: not checked: `x_max` is not given.
 *
 * Operations of one step, without input checks and clipping: 5 additions or comparisons, 6
 *       multiplications, 1 division.
 */
#ifndef PTC_EXP3_FD16A08E_HPP
#define PTC_EXP3_FD16A08E_HPP

#include <array>
#include <cfloat>
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
struct PtcExp3Params {
    double tau{}; ///< prescribed settling time [s], from 1e-150 to 1e150
    double t0{}; ///< start time [s], finite
    double eps{}; ///< time-to-go at which the gains are held [s], >= 1e-150, < tau
    double u_max{}; ///< bound of |u| [unit of u], > 0, infinity allowed
    std::array<double, 3> k{}; ///< gains of pi0 = -(k_1 xi_1 + ... + k_3 xi_3), finite; k[0] is k_1 [1/s^3], k[1] is k_2 [1/s^2], k[2] is k_3 [1/s]
};

/// Feedback gains at one time.
struct [[nodiscard]] PtcExp3Gains {
    std::array<double, 3> gain{}; ///< u = gain[0] x[0] + ... + gain[2] x[2]
    double u_max{}; ///< bound of |u|
    Status status{Status::Input}; ///< Ok or Hold; negative where there are no gains

    /// u of one axis from its state x = (x1, x1', ...) and the gains.
    /// On a negative status u is 0 and nothing has changed.
    constexpr Control<double> axis(const std::array<double, 3>& x) const noexcept
    {
        if (status < Status::Ok) {
            return {0.0, status};
        }
        const double s1 = (gain[0] * x[0]) + (gain[1] * x[1]);
        const double v = s1 + (gain[2] * x[2]);
        if (finite(v) && (absolute(v) <= u_max)) {
            return {v, status};
        } else if (finite(x[0]) && finite(x[1]) && finite(x[2])) {
            if (finite(v)) {
                if (v > u_max) {
                    return {u_max, Status::Saturated};
                } else {
                    return {-u_max, Status::Saturated};
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
class PtcExp3 {
public:
    using Params = PtcExp3Params;
    using State = std::array<double, 3>;
    using Gains = PtcExp3Gains;

    /// Takes the parameters and arms at params.t0 (or the fixed t0). Ok, or Param with nothing
    /// changed.
    [[nodiscard]] constexpr Status init(const Params& params) noexcept
    {
        PtcExp3 built{};
        const double tau = params.tau;
        const double t0 = params.t0;
        const double eps = params.eps;
        const double u_max = params.u_max;
        const double k1 = params.k[0];
        const double k2 = params.k[1];
        const double k3 = params.k[2];
        if (!(finite(tau)
                && (1e-150 <= tau)
                && (tau <= 1e150)
                && finite(t0)
                && (eps >= 1e-150)
                && (u_max > 0.0)
                && finite(k1)
                && finite(k2)
                && finite(k3)
                && (eps < tau))) {
            return Status::Param;
        }
        const double c1 = -k1;
        const double c2 = ((-k2) + k3) - 1.0;
        const double c3 = (-k3) + 3.0;
        const double hold_from = -eps;
        const double size_c1 = (absolute(k1) <= 0.0) ? 1e-200 : absolute(c1);
        if (!((size_c1 >= 1e-200) && finite(c1) && finite(c2) && finite(c3) && finite(hold_from))) {
            return Status::Param;
        }
        built.c1_ = c1;
        built.c2_ = c2;
        built.c3_ = c3;
        built.tau_ = tau;
        built.eps_ = eps;
        built.hold_from_ = hold_from;
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

    /// u at time t [s] and state x = (x1, x1', ...).
    /// On a negative status u is 0 and nothing has changed.
    constexpr Control<double> step(double t, const std::array<double, 3>& x) const noexcept
    {
        if (!(t >= t0_)) {
            return {0.0, Status::Input};
        }
        const double past = (t - deadline_) - correction_;
        const double late = (past < hold_from_) ? past : hold_from_;
        const double inv_T = (-1.0) / late;
        const double s1 = ((c1_ * x[0] * inv_T) + (c2_ * x[1])) * inv_T;
        const double v = (s1 + (c3_ * x[2])) * inv_T;
        if (finite(v) && (absolute(v) <= u_max_) && (late < hold_from_)) {
            return {v, Status::Ok};
        } else if (finite(t) && finite(x[0]) && finite(x[1]) && finite(x[2])) {
            if (finite(v)) {
                if (v > u_max_) {
                    return {u_max_, Status::Saturated};
                } else if (v < -u_max_) {
                    return {-u_max_, Status::Saturated};
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

    /// The gains at time t [s], for several axes that share one deadline: tick once, then axis for
    /// each. The result of tick and axis may differ from that of step in the last bits.
    constexpr Gains tick(double t) const noexcept
    {
        if (!(finite(t) && (t >= t0_))) {
            return {};
        }
        const double past = (t - deadline_) - correction_;
        const double late = (past < hold_from_) ? past : hold_from_;
        const double inv_T = (-1.0) / late;
        Gains gains{};
        gains.gain[0] = c1_ * (inv_T * inv_T) * inv_T;
        gains.gain[1] = c2_ * inv_T * inv_T;
        gains.gain[2] = c3_ * inv_T;
        gains.u_max = u_max_;
        if (late < hold_from_) {
            gains.status = Status::Ok;
        } else {
            gains.status = Status::Hold;
        }
        return gains;
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

    double c1_{}; // coefficient of x1
    double c2_{}; // coefficient of x2
    double c3_{}; // coefficient of x3
    double t0_{}; // start time
    double tau_{}; // prescribed settling time
    double deadline_{}; // t0 + tau, rounded
    double correction_{}; // low part of t0 + tau (compensated sum)
    double eps_{}; // time-to-go at which the gains are held
    double hold_from_{}; // -eps: later than this the gains are held
    double u_max_{}; // bound of |u|
};

} // namespace ptc

#endif
