/*
 * Prescribed-time controller pendulum: order n = 2, mapping exp.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang cpp --n 2 --mu "exp(a=1)" --name pendulum --tau=0.8 --eps=6.00e-3 --u-max=25 --poles=-3,-4 --states="q, w" --input=M --output="q" --dynamics="w, (M - drag*w)/(m*l^2) - grav/l*sin(q)" --param drag=0.02 --param grav=9.81 --param l=0.5 --param m=1 --sample-time=1e-3 --noise=1e-4,1e-3
 * Version 0.1.0, design d3c8a839e63d.
 *
 * Plant, with the input M: q' = w, w' = (M - drag*w)/(m*l^2) - grav/l*sin(q), output q. Time
 *       in s.
 * Goal: the output and its rate, x, are 0 at the deadline t0 + tau from any state at t0, up
 *       to the error that the hold at eps, sampling, what differs from the model and clipping
 *       leave. The checks below say what is known of this design.
 * The law takes the plant to be the model. What differs from it is not part of the law.
 *
 * Parameters:
 *   tau = 0.8 [s], fixed: prescribed settling time
 *   eps = 6.00e-3 [s], fixed: time-to-go at which the gains are held
 *   u_max = 25 [unit of u], fixed: bound of |u|
 *   a = 1 [1/s], fixed: rate of stretched time
 *   k_1 = 12 [1/s^2], fixed: gain of xi_1
 *   k_2 = 7 [1/s], fixed: gain of xi_2
 *   drag = 0.02, fixed: parameter of the model
 *   grav = 9.81, fixed: parameter of the model
 *   l = 0.5, fixed: parameter of the model
 *   m = 1, fixed: parameter of the model
 *   t0: start time [s], finite
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
 * Law, Theorem 1, with xi = BB_n x and t_kappa = kappa(Dt) + t0:
 *   u = (kappa'^n (pi0(xi, t_kappa) - b_n^T x) - f)/g
 *   pi0 = -(k_1 xi_1 + k_2 xi_2)
 *   x_1 = q
 *   x_2 = w
 *   f = -(drag*w)/(m*l^2) - grav/l*sin(q)
 *   g = 1/(l^2*m)
 *   u = (sum_j gain_j x_j - f)/g
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
 *   sampling: undecided: f is cancelled at the samples alone; with f = 0: eps = 0.006 s is 2
 *       times the minimum for a period of 0.001 s.
 *   deadline: not checked: `error` is not given.
 *   loop: not checked: `x0_max` is not given.
 *   envelope: not checked: `x_max` is not given.
 *   zeros: sound: none: the relative degree is 2, the number of states.
 *
 * Operations of one step, without input checks and clipping: 6 additions or comparisons, 6
 *       multiplications, 1 division, 1 function call.
 */
#ifndef PENDULUM_7122C95E_HPP
#define PENDULUM_7122C95E_HPP

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
struct PendulumParams {
    double t0{}; ///< start time [s], finite
};

/// Controller: set by init, changed by arm and by what is not const.
class Pendulum {
public:
    using Params = PendulumParams;
    using State = std::array<double, 2>;

    /// Takes the parameters and arms at params.t0 (or the fixed t0). Ok, or Param with nothing
    /// changed.
    [[nodiscard]] constexpr Status init(const Params& params) noexcept
    {
        Pendulum built{};
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
        const double deadline = t0 + 0.8;
        const double v1 = deadline - t0;
        const double correction = (t0 - (deadline - v1)) + (0.8 - v1);
        if (!finite(deadline)) {
            return Status::Param;
        }
        t0_ = t0;
        deadline_ = deadline;
        correction_ = correction;
        return Status::Ok;
    }

    /// u at time t [s] and state x = (q, w).
    /// On a negative status u is 0 and nothing has changed.
    Control<double> step(double t, const std::array<double, 2>& x) const noexcept
    {
        const double x1 = x[0];
        if (!((t >= t0_) && finite(x1))) {
            return {0.0, Status::Input};
        }
        const double past = (t - deadline_) - correction_;
        const double late = (past < -0.006) ? past : -0.006;
        const double inv_T = (-1.0) / late;
        const double drift = ((-4.905) * std::sin(x1)) - (0.02 * x[1]);
        const double v = ((((-3.0) * x1 * inv_T) + ((-1.5) * x[1])) * inv_T) - drift;
        if (finite(v) && (absolute(v) <= 25.0) && (late < -0.006)) {
            return {v, Status::Ok};
        } else if (finite(t) && finite(x[1])) {
            if (finite(v)) {
                if (v > 25.0) {
                    return {25.0, Status::Saturated};
                } else if (v < -25.0) {
                    return {-25.0, Status::Saturated};
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
