/*
 * Prescribed-time controller mix_fixed: outputs of order 2, 1, mapping exp.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang cpp --mu "exp(a=1)" --name mix_fixed --guard result --tau=1 --eps=1e-2 --limits=40,15 --poles="[[-4,-5],[-3]]" --states="p, v, h" --inputs=a,b --outputs="p, h" --dynamics="v, -v + (2 + sin(p))*a + h*b, v*h + h*a + (2 + h^2)*b"
 * Version 0.1.0, design 63889dce100a.
 *
 * Plant, with the inputs a, b: p' = v, v' = -v + (2 + sin(p))*a + h*b, h' = v*h + h*a + (2 +
 *       h^2)*b, output 1 = p, output 2 = h. Time in s.
 * Goal: every output with its derivatives is 0 at the deadline t0 + tau from any state at t0,
 *       up to the error that the hold at eps, sampling, what differs from the model and
 *       clipping leave. The checks below say what is known of this design.
 * The law takes the plant to be the model. What differs from it is not part of the law.
 * Outputs: 2, each with a law of its own, with this deadline and mapping; u_max is of the
 *       input of this number.
 *   output 1: k = 20, 9; u_max = 40
 *   output 2: k = 3; u_max = 15
 *
 * SAMPLE PERIOD NOT GIVEN: the gain held at eps limits the sample period for which the loop
 *       is stable. Run the emitted step with a model of the plant, sampled.
 *
 * Parameters:
 *   tau = 1 [s], fixed: prescribed settling time
 *   eps = 1e-2 [s], fixed: time-to-go at which the gains are held
 *   a = 1 [1/s], fixed: rate of stretched time
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
 * Law of each output, Theorem 1, with xi = BB_n x and t_kappa = kappa(Dt) + t0:
 *   v_i = kappa'^n (pi0(xi, t_kappa) - b_n^T x) = sum_j gain_j x_j
 * Order n = 1:
 *   pi0 = -k_1 xi_1
 *   gain_j = inv_T^(n+1-j) row_j
 *   K1, K2, ...: K_i = k_i/a^(n+1-i)
 *   row_1 = -K1
 *   inv_T = 1/T
 * Order n = 2:
 *   pi0 = -(k_1 xi_1 + k_2 xi_2)
 *   gain_j = inv_T^(n+1-j) row_j
 *   K1, K2, ...: K_i = k_i/a^(n+1-i)
 *   row_1 = -K1
 *   row_2 = 1 - K2
 *   inv_T = 1/T
 * Output 1, of order n = 2:
 *   x_1 = p
 *   x_2 = v
 *   f_1 = -v
 * Output 2, of order n = 1:
 *   x_1 = h
 *   f_2 = v*h
 * u = adj(D) w/det(D) with w_i = v_i - f_i:
 *   det(D) = (2 + sin(p))*(2 + h^2) - h*h
 *   adj(D) = [[2 + h^2, -h], [-h, 2 + sin(p)]]
 *
 * From t0 + tau - eps on, and after the deadline, the gains of T = eps are held (status HOLD).
 * |u| <= u_max: u is clipped to it (status SATURATED). Prolonged saturation voids the
 *       deadline.
 * Guard result: t or x that is not finite is refused by one test on u (RANGE). t >= t0 is the
 *       responsibility of the caller.
 * Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
 *       machine without fused multiply-add (gcc, clang: -ffp-contract=off) and with the same
 *       mathematical library.
 *
 * Checks of the design (details: ptc-codegen check):
 *   membership: sound: exp is of class M for all its parameters.
 *   growth: sound: x and u go to 0 at the deadline.
 *   sampling: not checked: `sample_time` is not given.
 *   deadline: not checked: `error` is not given.
 *   loop: not checked: `sample_time` is not given.
 *   envelope: not checked: `x_max` is not given.
 *   zeros: sound: none: the relative degrees are 2, 1, whose sum is the number of states.
 *
 * Operations of one step, without input checks and clipping: 13 additions or comparisons, 15
 *       multiplications, 2 divisions, 1 function call.
 */
#ifndef MIX_FIXED_F4DCA4E7_HPP
#define MIX_FIXED_F4DCA4E7_HPP

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
struct MixFixedParams {
    double t0{}; ///< start time [s], finite
};

/// Controller: set by init, changed by arm and by what is not const.
class MixFixed {
public:
    using Params = MixFixedParams;
    using State = std::array<double, 3>;

    /// Takes the parameters and arms at params.t0 (or the fixed t0). Ok, or Param with nothing
    /// changed.
    [[nodiscard]] constexpr Status init(const Params& params) noexcept
    {
        MixFixed built{};
        const double t0 = params.t0;
        if (!finite(t0)) {
            return Status::Param;
        }
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
        const double deadline = t0 + 1.0;
        const double v1 = deadline - t0;
        const double correction = (t0 - (deadline - v1)) + (1.0 - v1);
        if (!finite(deadline)) {
            return Status::Param;
        }
        deadline_ = deadline;
        correction_ = correction;
        return Status::Ok;
    }

    /// u = (a, b) at time t [s] and state x = (p, v, h). Where one of them is not finite, as at a
    /// state at which the inputs do not decouple the outputs, every u is 0; else the status is
    /// SATURATED where one was clipped.
    Axes<double, 2> step(double t, const std::array<double, 3>& x) const noexcept
    {
        Axes<double, 2> all{};
        const double x1 = x[0];
        const double x2 = x[1];
        const double x3 = x[2];
        const double past = (t - deadline_) - correction_;
        const double late = (past < -0.01) ? past : -0.01;
        const double inv_T_axis1 = (-1.0) / late;
        const double drift_axis1 = -x2;
        const double s1 = (((-20.0) * x1 * inv_T_axis1) + ((-8.0) * x2)) * inv_T_axis1;
        const double wanted_axis1 = s1 - drift_axis1;
        const double drift_axis2 = x2 * x3;
        const double wanted_axis2 = ((-3.0) * x3 * inv_T_axis1) - drift_axis2;
        const double v1 = 2.0 + std::sin(x1);
        const double v2 = x3 * x3;
        const double v3 = 2.0 + v2;
        const double determinant = (v1 * v3) - v2;
        const double over_determinant = ((determinant < 0.0) || (determinant > 0.0)) ? (1.0 / determinant) : std::numeric_limits<double>::quiet_NaN();
        const double v4 = -x3;
        const double s2 = ((v3 * wanted_axis1) + (v4 * wanted_axis2)) * over_determinant;
        const double control1 = s2 + (t - t);
        const double s3 = ((v4 * wanted_axis1) + (v1 * wanted_axis2)) * over_determinant;
        const double control2 = s3 + (t - t);
        if (late < -0.01) {
            all.status = Status::Ok;
        } else {
            all.status = Status::Hold;
        }
        if (finite(control1) && finite(control2)) {
            all.u[0] = control1;
            all.axes[0] = all.status;
            all.u[1] = control2;
            all.axes[1] = all.status;
            if (control1 > 40.0) {
                all.u[0] = 40.0;
                all.axes[0] = Status::Saturated;
                all.status = Status::Saturated;
            } else if (control1 < -40.0) {
                all.u[0] = -40.0;
                all.axes[0] = Status::Saturated;
                all.status = Status::Saturated;
            }
            if (control2 > 15.0) {
                all.u[1] = 15.0;
                all.axes[1] = Status::Saturated;
                all.status = Status::Saturated;
            } else if (control2 < -15.0) {
                all.u[1] = -15.0;
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

    double deadline_{}; // t0 + tau, rounded
    double correction_{}; // low part of t0 + tau (compensated sum)
};

} // namespace ptc

#endif
