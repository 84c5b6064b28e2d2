/*
 * Prescribed-time controller duration_latched: order n = 2, mapping custom.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang cpp --n 2 --kappa="dt/(c*tau*(tau - dt)) + dt" --name duration_latched --in-flight --pi0="-6*xi1 - 5*xi2 + xi1_0/8" --param "c=[0.5,2]" --allow=growth
 * Version 0.1.0, design 618c09f23c7e.
 *
 * Plant: x1' = x2, x2' = f + u. Time in s, x1 in any unit U, x2 in U/s, u in U/s^2.
 * Goal: x = 0 at the deadline t0 + tau from any state at t0, up to the error that the hold at
 *       eps, sampling, f and clipping leave. The checks below say what is known of this
 *       design.
 * f is not part of the law: cancel its known terms before the call.
 *
 * SAMPLE PERIOD NOT GIVEN: the gain held at eps limits the sample period for which the loop
 *       is stable. Simulate the sampled loop: ptc-codegen simulate --sample-time.
 *
 * Parameters:
 *   tau: prescribed settling time [s], from 1e-150 to 1e150
 *   t0: start time [s], finite
 *   eps: time-to-go at which the gains are held [s], >= 1e-150, < tau
 *   u_max: bound of |u| [unit of u], > 0, infinity allowed
 *   c: parameter of kappa, from 0.5 to 2
 *
 * Time mapping, with time-to-go T = t0 + tau - t and elapsed time Dt = t - t0; t in mu(t) is
 *       the stretched time since t0:
 *   kappa(dt) = dt/(c*tau*(tau - dt)) + dt
 *   kappa = (tau + tau^2*c*T - tau*c*T^2 - T)/(tau*c*T)
 *   r_1 = T*(c*T/(1 + c*T^2))
 * r_k and BB_n are computed from the Taylor series of mu at each call.
 *
 * Law, Theorem 1, with xi = BB_n x and t_kappa = kappa(Dt) + t0:
 *   u = kappa'^n (pi0(xi, t_kappa) - b_n^T x)
 *   pi0 = -6*xi1 - 5*xi2 + xi1_0/8
 *   xi_i = sum_j (i-1)!/(j-1)! r_1^(j-1) [z^(i-1)] p(z)^(j-1) x_j
 *   p(z) = z + sum_{l>=2} r_l/(r_1 l!) z^l, where [z^i] takes the coefficient of z^i
 *
 * From t0 + tau - eps on, and after the deadline, T is held at eps in the law (status HOLD).
 * In flight: arm_for starts again at t0 for another tau, at any time, and computes what
 *       follows from tau. arm keeps the tau last used: at first that of the parameters.
 * |u| <= u_max: u is clipped to it (status SATURATED). Prolonged saturation voids the
 *       deadline.
 * Guard full: t and x are finite and t >= t0, or the call is refused (INPUT).
 * Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
 *       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
 *
 * Checks of the design (details: ptc-codegen check):
 *   membership: sound: the mapping is of its class, proved.
 *   growth: not checked: the law is not a sum of gains, so its poles are not known.
 *   sampling: not checked: `sample_time` is not given.
 *   deadline: not checked: `error` is not given.
 *   loop: not checked: it needs a linear law.
 *   envelope: not checked: `x_max` is not given.
 *
 * Operations of one step, without input checks and clipping: 11 additions or comparisons, 15
 *       multiplications, 3 divisions.
 */
#ifndef DURATION_LATCHED_13BE8EC6_HPP
#define DURATION_LATCHED_13BE8EC6_HPP

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
struct DurationLatchedParams {
    double tau{}; ///< prescribed settling time [s], from 1e-150 to 1e150
    double t0{}; ///< start time [s], finite
    double eps{}; ///< time-to-go at which the gains are held [s], >= 1e-150, < tau
    double u_max{}; ///< bound of |u| [unit of u], > 0, infinity allowed
    double c{}; ///< parameter of kappa, from 0.5 to 2
};

/// Controller: set by init, changed by arm and by what is not const.
class DurationLatched {
public:
    using Params = DurationLatchedParams;
    using State = std::array<double, 2>;

    /// Takes the parameters and arms at params.t0 (or the fixed t0) for params.tau, latching the
    /// state x0. Ok, or Param with nothing changed.
    [[nodiscard]] constexpr Status init(const Params& params, const State& x0) noexcept
    {
        DurationLatched built{};
        const double tau = params.tau;
        const double t0 = params.t0;
        const double eps = params.eps;
        const double u_max = params.u_max;
        const double p_c = params.c;
        if (!(finite(tau)
                && (1e-150 <= tau)
                && (tau <= 1e150)
                && finite(t0)
                && (eps >= 1e-150)
                && (u_max > 0.0)
                && (0.5 <= p_c)
                && (p_c <= 2.0)
                && (eps < tau))) {
            return Status::Param;
        }
        const double hold_from = -eps;
        if (!finite(hold_from)) {
            return Status::Param;
        }
        built.eps_ = eps;
        built.hold_from_ = hold_from;
        built.p_c_ = p_c;
        built.u_max_ = u_max;
        built.t0_ = 0.0;
        built.tau_ = 0.0;
        built.deadline_ = 0.0;
        built.correction_ = 0.0;
        built.f44_ = 0.0;
        const Status status = built.arm_for(t0, tau, x0);
        if (status == Status::Ok) {
            *this = built;
        }
        return status;
    }

    /// Starts again at t0 [s], with the tau last used, latching the state x0.
    /// Ok, or Param with nothing changed.
    [[nodiscard]] constexpr Status arm(double t0, const std::array<double, 2>& x0) noexcept
    {
        if (!(finite(t0) && finite(x0[0]) && finite(x0[1]))) {
            return Status::Param;
        }
        const double deadline = t0 + tau_;
        const double v1 = deadline - t0;
        const double correction = (t0 - (deadline - v1)) + (tau_ - v1);
        const double f44 = x0[0] * 0.125;
        if (!(finite(deadline) && finite(f44))) {
            return Status::Param;
        }
        t0_ = t0;
        deadline_ = deadline;
        correction_ = correction;
        f44_ = f44;
        return Status::Ok;
    }

    /// Starts again at t0 [s] with another duration tau [s]: the deadline is t0 + tau, latching the
    /// state x0.
    /// Ok, or Param with nothing changed.
    [[nodiscard]] constexpr Status arm_for(double t0, double tau, const std::array<double, 2>& x0) noexcept
    {
        if (!(finite(t0)
                && finite(x0[0])
                && finite(x0[1])
                && finite(tau)
                && (1e-150 <= tau)
                && (tau <= 1e150)
                && (tau > eps_))) {
            return Status::Param;
        }
        const double deadline = t0 + tau;
        const double v1 = deadline - t0;
        const double correction = (t0 - (deadline - v1)) + (tau - v1);
        const double f44 = x0[0] * 0.125;
        if (!(finite(deadline) && finite(f44))) {
            return Status::Param;
        }
        t0_ = t0;
        tau_ = tau;
        deadline_ = deadline;
        correction_ = correction;
        f44_ = f44;
        return Status::Ok;
    }

    /// u at time t [s] and state x = (x1, x1', ...).
    /// On a negative status u is 0 and nothing has changed.
    constexpr Control<double> step(double t, const std::array<double, 2>& x) const noexcept
    {
        if (!(t >= t0_)) {
            return {0.0, Status::Input};
        }
        const double past = (t - deadline_) - correction_;
        const double late = (past < hold_from_) ? past : hold_from_;
        const double T = -late;
        const double v1 = T * T * p_c_;
        const double v2 = 1.0 + v1;
        const double unit = (T * p_c_) / v2;
        const double v3 = T * unit;
        const double inv_r1 = 1.0 / v3;
        const double xi2 = x[1] * v3;
        const double law = (((-6.0) * x[0]) - (5.0 * xi2)) + f44_;
        const double s1 = (-2.0) * ((((-(v1 * (-2.0) * (1.0 / v2))) - 1.0) - 1.0) * 0.5 * unit);
        const double v = ((law * inv_r1) + (s1 * x[1])) * inv_r1;
        if (finite(v) && (absolute(v) <= u_max_) && (late < hold_from_)) {
            return {v, Status::Ok};
        } else if (finite(t) && finite(x[0]) && finite(x[1])) {
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
    double p_c_{}; // parameter of an expression of the design
    double f44_{}; // derived at the start time
    double u_max_{}; // bound of |u|
};

} // namespace ptc

#endif
