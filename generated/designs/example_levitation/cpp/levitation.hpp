/*
 * Prescribed-time controller levitation: order n = 3, mapping exp.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang cpp --n 3 --mu "exp(a=1)" --name levitation --eps=1e-3 --poles=-4,-5,-6 --states="z, v, i" --input=u --output="z" --dynamics="v, grav*(1 - ((1 + i/i0)/(1 + z/z0))^2), (u - R*i)/L" --param grav=9.81 --param "i0=[0.1,5]" --param "z0=[5e-3,2e-2]" --x-max=2e-3,1,0.05
 * Version 0.1.0, design 44fd77ede031.
 *
 * Plant, with the input u: z' = v, v' = grav*(1 - ((1 + i/i0)/(1 + z/z0))^2), i' = (u -
 *       R*i)/L, output z. Time in s.
 * Goal: the output and its first 2 derivatives, x, are 0 at the deadline t0 + tau from any
 *       state at t0, up to the error that the hold at eps, sampling, what differs from the
 *       model and clipping leave. The checks below say what is known of this design.
 * The law takes the plant to be the model. What differs from it is not part of the law.
 *
 * SAMPLE PERIOD NOT GIVEN: the held gains grow as eps falls, and the loop is stable only for
 *       sample periods below a limit that depends on eps and the gains. ptc-codegen check
 *       finds it once tau, eps, the gains and --sample-time are given.
 *
 * Parameters:
 *   eps = 1e-3 [s], fixed: time-to-go at which the gains are held
 *   a = 1 [1/s], fixed: rate of stretched time
 *   k_1 = 120 [1/s^3], fixed: gain of xi_1
 *   k_2 = 74 [1/s^2], fixed: gain of xi_2
 *   k_3 = 15 [1/s], fixed: gain of xi_3
 *   grav = 9.81, fixed: parameter of the model
 *   tau: prescribed settling time [s], from 1e-150 to 1e150
 *   t0: start time [s], finite
 *   u_max: bound of |u| [unit of u], > 0, infinity allowed
 *   L: parameter of the model, finite
 *   R: parameter of the model, finite
 *   i0: parameter of the model, from 0.1 to 5
 *   z0: parameter of the model, from 5e-3 to 2e-2
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
 *   u = (kappa'^n (pi0(xi, t_kappa) - b_n^T x) - f)/g
 *   pi0 = -(k_1 xi_1 + ... + k_3 xi_3)
 *   x_1 = z
 *   x_2 = v
 *   x_3 = grav*(1 - ((1 + i/i0)/(1 + z/z0))^2)
 *   f = grav*-(2*((1 + i/i0)/(1 + z/z0))*((-R*i/L/i0*(1 + z/z0) - (1 + i/i0)*(v/z0))/(1 +
 *       z/z0)^2))
 *   g = -2*grav*z0^2*(i0 + i)/(L*i0^2*(z0 + z)^2)
 *   u = (sum_j gain_j x_j - f)/g
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
 *   growth: sound: x and u go to 0 at the deadline.
 *   sampling: not checked: `sample_time` is not given.
 *   deadline: not checked: `error` is not given.
 *   loop: not checked: it needs a value of `tau`.
 *   envelope: not checked: `tau` is left to run time without bounds.
 *   zeros: sound: none: the relative degree is 3, the number of states.
 *
 * Operations of one step, without input checks and clipping: 14 additions or comparisons, 15
 *       multiplications, 6 divisions.
 */
#ifndef LEVITATION_D7784A2A_HPP
#define LEVITATION_D7784A2A_HPP

#ifdef L
#error "a macro L takes the place of the parameter L: include this header before the one that defines it, or rename the parameter"
#endif

#ifdef R
#error "a macro R takes the place of the parameter R: include this header before the one that defines it, or rename the parameter"
#endif

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
struct LevitationParams {
    double tau{}; ///< prescribed settling time [s], from 1e-150 to 1e150
    double t0{}; ///< start time [s], finite
    double u_max{}; ///< bound of |u| [unit of u], > 0, infinity allowed
    double L{}; ///< parameter of the model, finite
    double R{}; ///< parameter of the model, finite
    double i0{}; ///< parameter of the model, from 0.1 to 5
    double z0{}; ///< parameter of the model, from 5e-3 to 2e-2
};

/// Controller: set by init, changed by arm and by what is not const.
class Levitation {
public:
    using Params = LevitationParams;
    using State = std::array<double, 3>;

    /// Takes the parameters and arms at params.t0 (or the fixed t0). Ok, or Param with nothing
    /// changed.
    [[nodiscard]] constexpr Status init(const Params& params) noexcept
    {
        Levitation built{};
        const double tau = params.tau;
        const double t0 = params.t0;
        const double u_max = params.u_max;
        const double p_L = params.L;
        const double p_R = params.R;
        const double p_i0 = params.i0;
        const double p_z0 = params.z0;
        if (!(finite(tau)
                && (1e-150 <= tau)
                && (tau <= 1e150)
                && finite(t0)
                && (u_max > 0.0)
                && finite(p_L)
                && finite(p_R)
                && (0.1 <= p_i0)
                && (p_i0 <= 5.0)
                && (0.005 <= p_z0)
                && (p_z0 <= 0.02)
                && (tau > 0.001))) {
            return Status::Param;
        }
        const double f42 = p_L * (p_i0 * p_i0);
        const double f53 = -p_L;
        const double size_f42 = (absolute(p_L) <= 0.0) ? 1e-200 : absolute(f42);
        const double size_f53 = (absolute(p_L) <= 0.0) ? 1e-200 : absolute(f53);
        const double size_p_R = (absolute(p_R) <= 0.0) ? 1e-200 : absolute(p_R);
        const double f49 = (-19.62) * (p_z0 * p_z0);
        const double f56 = p_R * p_z0;
        const double f61 = f53 * p_i0;
        if (!((size_f42 >= 1e-200)
                && (size_f53 >= 1e-200)
                && (size_p_R >= 1e-200)
                && finite(f42)
                && finite(f49)
                && finite(f53)
                && finite(f56)
                && finite(f61))) {
            return Status::Param;
        }
        built.tau_ = tau;
        built.p_i0_ = p_i0;
        built.p_z0_ = p_z0;
        built.f42_ = f42;
        built.f49_ = f49;
        built.f53_ = f53;
        built.p_R_ = p_R;
        built.f56_ = f56;
        built.f61_ = f61;
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

    /// u at time t [s] and state x = (z, v, i).
    /// On a negative status u is 0 and nothing has changed.
    constexpr Control<double> step(double t, const std::array<double, 3>& x) const noexcept
    {
        if (!(t >= t0_)) {
            return {0.0, Status::Input};
        }
        const double past = (t - deadline_) - correction_;
        const double late = (past < -0.001) ? past : -0.001;
        const double inv_T = (-1.0) / late;
        const double v1 = (1.0 + (x[2] / p_i0_)) / (1.0 + (x[0] / p_z0_));
        const double v2 = p_z0_ + x[0];
        const double s1 = (((-120.0) * x[0] * inv_T) + ((-60.0) * x[1])) * inv_T;
        const double s2 = (s1 + ((-117.72) * (1.0 - (v1 * v1)))) * inv_T;
        const double v3 = s2 * (f42_ * (v2 * v2));
        const double numerator = f49_ * (p_i0_ + x[2]);
        const double s3 = (((f53_ * x[1]) - f56_) - (p_R_ * x[0])) * x[2];
        const double drift = (s3 + (f61_ * x[1])) / v2;
        const double s4 = ((numerator < 0.0) || (numerator > 0.0)) ? (v3 / numerator) : std::numeric_limits<double>::quiet_NaN();
        const double v = s4 - drift;
        if (finite(v) && (absolute(v) <= u_max_) && (late < -0.001)) {
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
    double p_i0_{}; // parameter of an expression of the design
    double p_z0_{}; // parameter of an expression of the design
    double f42_{}; // derived from the parameters
    double f49_{}; // derived from the parameters
    double f53_{}; // derived from the parameters
    double p_R_{}; // parameter of an expression of the design
    double f56_{}; // derived from the parameters
    double f61_{}; // derived from the parameters
    double u_max_{}; // bound of |u|
};

} // namespace ptc

#endif
