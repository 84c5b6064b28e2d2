/*
 * Prescribed-time controller ptc_own_law1_latched: order n = 1, mapping exp.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang cpp --n 1 --mu "exp(a=1)" --name ptc_own_law1_latched --pi0="-2*xi1 - xi1*xi1_0"
 * Version 0.1.0, design fef8ca24aec8.
 *
 * Plant: x1' = f + u. Time in s, x1 in any unit U, u in U/s.
 * Goal: x = 0 at the deadline t0 + tau from any state at t0, up to the error that the hold at
 *       eps, sampling, f and clipping leave. The checks below say what is known of this
 *       design.
 * f is not part of the law: cancel its known terms before the call.
 *
 * SAMPLE PERIOD NOT GIVEN: the gain held at eps limits the sample period for which the loop
 *       is stable. Simulate the sampled loop: ptc-codegen simulate --sample-time.
 *
 * Parameters:
 *   a = 1 [1/s], fixed: rate of stretched time
 *   tau: prescribed settling time [s], from 1e-150 to 1e150
 *   t0: start time [s], finite
 *   eps: time-to-go at which the gains are held [s], >= 1e-150, < tau
 *   u_max: bound of |u| [unit of u], > 0, infinity allowed
 *
 * Time mapping, with time-to-go T = t0 + tau - t and elapsed time Dt = t - t0; t in mu(t) is
 *       the stretched time since t0:
 *   mu(t)     = tau*(1 - exp(-a*t))
 *   kappa(Dt) = -ln(T/tau)/a
 * Derivatives r_k = mu^(k)(kappa(Dt)):
 *   r_k = (-1)^(k-1) a^k T
 *   r_1 = a*T
 * Matrix BB_n, entry (i,j) = B_{i-1,j-1}(r_1, ...), and its next row b_n; zeros are left out:
 *   B_{0,0} = 1
 *
 * Law, Theorem 1, with xi = BB_n x and t_kappa = kappa(Dt) + t0:
 *   u = kappa'^n (pi0(xi, t_kappa) - b_n^T x)
 *   pi0 = -2*xi1 - xi1*xi1_0
 *   xi_i = sum_j (i-1)!/(j-1)! r_1^(j-1) [z^(i-1)] p(z)^(j-1) x_j
 *   p(z) = z + sum_{l>=2} r_l/(r_1 l!) z^l, where [z^i] takes the coefficient of z^i
 *
 * From t0 + tau - eps on, and after the deadline, T is held at eps in the law (status HOLD).
 * |u| <= u_max: u is clipped to it (status SATURATED). Prolonged saturation voids the
 *       deadline.
 * Guard full: t and x are finite and t >= t0, or the call is refused (INPUT).
 * Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
 *       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
 *
 * Checks of the design (details: ptc-codegen check):
 *   membership: sound: exp is of class M for all its parameters.
 *   growth: not checked: the law is not a sum of gains, so its poles are not known.
 *   sampling: not checked: `sample_time` is not given.
 *   deadline: not checked: `error` is not given.
 *   loop: not checked: it needs a linear law.
 *   envelope: not checked: `x_max` is not given.
 *
 * Operations of one step, without input checks and clipping: 5 additions or comparisons, 3
 *       multiplications, 1 division.
 */
#ifndef PTC_OWN_LAW1_LATCHED_360CD31F_HPP
#define PTC_OWN_LAW1_LATCHED_360CD31F_HPP

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
struct PtcOwnLaw1LatchedParams {
    double tau{}; ///< prescribed settling time [s], from 1e-150 to 1e150
    double t0{}; ///< start time [s], finite
    double eps{}; ///< time-to-go at which the gains are held [s], >= 1e-150, < tau
    double u_max{}; ///< bound of |u| [unit of u], > 0, infinity allowed
};

/// Controller: set by init, changed by arm and by what is not const.
class PtcOwnLaw1Latched {
public:
    using Params = PtcOwnLaw1LatchedParams;
    using State = std::array<double, 1>;

    /// Takes the parameters and arms at params.t0 (or the fixed t0), latching the state x0. Ok, or
    /// Param with nothing changed.
    [[nodiscard]] constexpr Status init(const Params& params, const State& x0) noexcept
    {
        PtcOwnLaw1Latched built{};
        const double tau = params.tau;
        const double t0 = params.t0;
        const double eps = params.eps;
        const double u_max = params.u_max;
        if (!(finite(tau)
                && (1e-150 <= tau)
                && (tau <= 1e150)
                && finite(t0)
                && (eps >= 1e-150)
                && (u_max > 0.0)
                && (eps < tau))) {
            return Status::Param;
        }
        const double hold_from = -eps;
        if (!finite(hold_from)) {
            return Status::Param;
        }
        built.tau_ = tau;
        built.eps_ = eps;
        built.hold_from_ = hold_from;
        built.u_max_ = u_max;
        built.t0_ = 0.0;
        built.deadline_ = 0.0;
        built.correction_ = 0.0;
        built.x1_0_ = 0.0;
        const Status status = built.arm(t0, x0);
        if (status == Status::Ok) {
            *this = built;
        }
        return status;
    }

    /// Starts again at t0 [s], latching the state x0.
    /// Ok, or Param with nothing changed.
    [[nodiscard]] constexpr Status arm(double t0, const std::array<double, 1>& x0) noexcept
    {
        if (!(finite(t0) && finite(x0[0]))) {
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
        x1_0_ = x0[0];
        return Status::Ok;
    }

    /// u at time t [s] and state x = (x1, x1', ...).
    /// On a negative status u is 0 and nothing has changed.
    constexpr Control<double> step(double t, const std::array<double, 1>& x) const noexcept
    {
        if (!(t >= t0_)) {
            return {0.0, Status::Input};
        }
        const double past = (t - deadline_) - correction_;
        const double late = (past < hold_from_) ? past : hold_from_;
        const double T = -late;
        const double inv_r1 = 1.0 / T;
        const double law = ((-2.0) * x[0]) - (x[0] * x1_0_);
        const double v = law * inv_r1;
        if (finite(v) && (absolute(v) <= u_max_) && (late < hold_from_)) {
            return {v, Status::Ok};
        } else if (finite(t) && finite(x[0])) {
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
    double tau_{}; // prescribed settling time
    double deadline_{}; // t0 + tau, rounded
    double correction_{}; // low part of t0 + tau (compensated sum)
    double eps_{}; // time-to-go at which the gains are held
    double hold_from_{}; // -eps: later than this the gains are held
    double x1_0_{}; // state at the start
    double u_max_{}; // bound of |u|
};

} // namespace ptc

#endif
