/*
 * Prescribed-time controller ptc_tanh3_extern: order n = 3, mapping tanh.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang cpp --n 3 --mu tanh --name ptc_tanh3_extern --pi0 extern --after extern
 * Version 0.1.0, design 04514e738293.
 *
 * Plant: x1' = x2, ..., x3' = f + u. Time in s, x1 in any unit U, x2 in U/s, x3 in U/s^2, u
 *       in U/s^3.
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
 *   a: rate of stretched time [1/s], from 1e-150 to 1e150
 *
 * Time mapping, with time-to-go T = t0 + tau - t and elapsed time Dt = t - t0; t in mu(t) is
 *       the stretched time since t0:
 *   mu(t)     = tau*tanh(a*t)
 *   kappa(Dt) = -ln(E)/(2*a), E = T/(2*tau - T)
 *   in terms of T = time-to-go, E = exp(-2*a*t) = T/(2*tau - T), L = 1/(1 + E)
 * Derivatives r_k = mu^(k)(kappa(Dt)):
 *   r_k = 2*tau*(-2*a)^k Li_{-k}(-E)
 *   r_1 = 2*a*T*L
 *   r_2 = 4*a^2*T*E*L^2 - 4*a^2*T*L^2
 *   r_3 = -32*a^3*T*E*L^3 + 8*a^3*T*E^2*L^3 + 8*a^3*T*L^3
 * Matrix BB_n, entry (i,j) = B_{i-1,j-1}(r_1, ...), and its next row b_n; zeros are left out:
 *   B_{0,0} = 1
 *   B_{1,1} = 2*a*T*L
 *   B_{2,1} = 4*a^2*T*E*L^2 - 4*a^2*T*L^2
 *   B_{2,2} = 4*a^2*T^2*L^2
 *   B_{3,1} = -32*a^3*T*E*L^3 + 8*a^3*T*E^2*L^3 + 8*a^3*T*L^3
 *   B_{3,2} = 24*a^3*T^2*E*L^3 - 24*a^3*T^2*L^3
 *
 * Law, Theorem 1, with xi = BB_n x and t_kappa = kappa(Dt) + t0:
 *   u = kappa'^n (pi0(xi, t_kappa) - b_n^T x)
 *   pi0 = a user-defined function of xi and t_kappa
 *   xi_i = sum_j (i-1)!/(j-1)! r_1^(j-1) [z^(i-1)] p(z)^(j-1) x_j
 *   p(z) = z + sum_{l>=2} r_l/(r_1 l!) z^l, where [z^i] takes the coefficient of z^i
 *
 * From t0 + tau - eps on, T is held at eps in the law (status HOLD). From t0 + tau on, u is
 *       the result of the user-defined function after (status AFTER).
 * |u| <= u_max: u is clipped to it (status SATURATED). Prolonged saturation voids the
 *       deadline.
 * Guard full: t and x are finite and t >= t0, or the call is refused (INPUT).
 * Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
 *       machine without fused multiply-add (gcc, clang: -ffp-contract=off) and with the same
 *       mathematical library.
 *
 * Checks of the design (details: ptc-codegen check):
 *   membership: sound: tanh is of class M for all its parameters.
 *   growth: not checked: the law is not a sum of gains, so its poles are not known.
 *   sampling: not checked: `sample_time` is not given.
 *   deadline: not checked: `error` is not given.
 *   loop: not checked: it needs a linear law.
 *   envelope: not checked: `x_max` is not given.
 *
 * Operations of one step, without input checks and clipping: 16 additions or comparisons, 24
 *       multiplications, 4 divisions, 2 function calls.
 */
#ifndef PTC_TANH3_EXTERN_54CEE75E_HPP
#define PTC_TANH3_EXTERN_54CEE75E_HPP

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
struct PtcTanh3ExternParams {
    double tau{}; ///< prescribed settling time [s], from 1e-150 to 1e150
    double t0{}; ///< start time [s], finite
    double eps{}; ///< time-to-go at which the gains are held [s], >= 1e-150, < tau
    double u_max{}; ///< bound of |u| [unit of u], > 0, infinity allowed
    double a{}; ///< rate of stretched time [1/s], from 1e-150 to 1e150
};

/// Controller: set by init, changed by arm and by what is not const.
class PtcTanh3Extern {
public:
    using Params = PtcTanh3ExternParams;
    using State = std::array<double, 3>;

    /// Takes the parameters and arms at params.t0 (or the fixed t0). Ok, or Param with nothing
    /// changed.
    [[nodiscard]] constexpr Status init(const Params& params) noexcept
    {
        PtcTanh3Extern built{};
        const double tau = params.tau;
        const double t0 = params.t0;
        const double eps = params.eps;
        const double u_max = params.u_max;
        const double a = params.a;
        if (!(finite(tau)
                && (1e-150 <= tau)
                && (tau <= 1e150)
                && finite(t0)
                && (eps >= 1e-150)
                && (u_max > 0.0)
                && finite(a)
                && (1e-150 <= a)
                && (a <= 1e150)
                && (eps < tau))) {
            return Status::Param;
        }
        const double hold_from = -eps;
        const double f16 = 2.0 * tau;
        const double f22 = 2.0 * a;
        const double f24 = f16 * a;
        const double f29 = 1.0 / tau;
        if (!(finite(hold_from) && finite(f16) && finite(f22) && finite(f24) && finite(f29))) {
            return Status::Param;
        }
        built.tau_ = tau;
        built.eps_ = eps;
        built.hold_from_ = hold_from;
        built.f16_ = f16;
        built.a_ = a;
        built.f22_ = f22;
        built.f24_ = f24;
        built.f29_ = f29;
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
    /// `pi0`: User-defined law pi0(xi, t); t is the stretched time kappa + t0.
    /// `after`: User-defined law for t >= t0 + tau.
    /// On a negative status u is 0 and nothing has changed.
    template <class Pi0, class Then>
    Control<double> step(double t, const std::array<double, 3>& x, Pi0&& pi0, Then&& after) const
    {
        const double x1 = x[0];
        const double x2 = x[1];
        const double x3 = x[2];
        if (!(finite(t) && (t >= t0_) && finite(x1) && finite(x2) && finite(x3))) {
            return {0.0, Status::Input};
        }
        const double past = (t - deadline_) - correction_;
        const double late = (past < hold_from_) ? past : hold_from_;
        const double T = -late;
        const double v1 = T * a_;
        const double v2 = f24_ + (-v1);
        const double unit = f29_ * v2;
        const double v3 = v1 * (1.0 / v2);
        const double v4 = v3 - 1.0;
        const double v5 = v4 * 0.5;
        const double v6 = T * unit;
        const double inv_r1 = 1.0 / v6;
        const double xi2 = x2 * v6;
        const double xi3 = ((x3 * v6) + (2.0 * (v5 * unit) * x2)) * v6;
        const double t_kappa = t0_ + ((-std::log(T / (f16_ - T))) / f22_);
        const std::array<double, 3> xi{{x1, xi2, xi3}};
        const double law = pi0(xi, t_kappa);
        double applied{};
        if (past >= 0.0) {
            applied = after(x, t);
        } else {
            const double s1 = ((v4 * v4) + (2.0 * (-v3))) * 0.16666666666666666;
            const double s2 = ((law * inv_r1) + ((-6.0) * (s1 * (unit * unit)) * x2)) * inv_r1;
            applied = (s2 + ((-3.0) * ((v5 + v5) * unit) * x3)) * inv_r1;
        }
        const double v = applied;
        if (finite(v)) {
            if (v > u_max_) {
                return {u_max_, Status::Saturated};
            } else if (v < -u_max_) {
                return {-u_max_, Status::Saturated};
            } else if (late < hold_from_) {
                return {v, Status::Ok};
            } else if (past >= 0.0) {
                return {v, Status::After};
            } else {
                return {v, Status::Hold};
            }
        } else {
            return {0.0, Status::Range};
        }
    }

private:
    /// std::isfinite is not constexpr in C++17.
    static constexpr bool finite(double v) noexcept
    {
        return (v >= std::numeric_limits<double>::lowest()) && (v <= (std::numeric_limits<double>::max)());
    }

    double t0_{}; // start time
    double tau_{}; // prescribed settling time
    double deadline_{}; // t0 + tau, rounded
    double correction_{}; // low part of t0 + tau (compensated sum)
    double eps_{}; // time-to-go at which the gains are held
    double hold_from_{}; // -eps: later than this the gains are held
    double f16_{}; // derived from the parameters
    double a_{}; // rate of stretched time
    double f22_{}; // derived from the parameters
    double f24_{}; // derived from the parameters
    double f29_{}; // derived from the parameters
    double u_max_{}; // bound of |u|
};

} // namespace ptc

#endif
