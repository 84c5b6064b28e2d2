/*
 * Prescribed-time controller ptc_exp3_f32: order n = 3, mapping exp.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang cpp --n 3 --mu exp --name ptc_exp3_f32 --precision f32
 * Version 0.1.0, design 0d95d06872ef.
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
 *   tau: prescribed settling time [s], from 1e-18 to 1e18
 *   t0: start time [s], finite
 *   eps: time-to-go at which the gains are held [s], >= 1e-18, < tau
 *   u_max: bound of |u| [unit of u], > 0, infinity allowed
 *   a: rate of stretched time [1/s], from 1e-18 to 1e18
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
 * Precision f32 (IEEE 754 binary32). Results are bit for bit the same on every IEEE 754
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
#ifndef PTC_EXP3_F32_42E0EDD8_HPP
#define PTC_EXP3_F32_42E0EDD8_HPP

#include <array>
#include <cfloat>
#include <limits>

/* What this file requires of its compiler. */
#if (defined(FLT_MANT_DIG) && (FLT_MANT_DIG != 24))
#error "float is not IEEE 754 binary32 here"
#endif
#if defined(FLT_EVAL_METHOD) && !defined(PTC_ALLOW_EXCESS_PRECISION)
#if (FLT_EVAL_METHOD > 0) && (FLT_EVAL_METHOD < 3)
#error "float is computed with more digits than it has: on x86 compile with -msse2 -mfpmath=sse, or define PTC_ALLOW_EXCESS_PRECISION"
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
struct PtcExp3F32Params {
    float tau{}; ///< prescribed settling time [s], from 1e-18 to 1e18
    float t0{}; ///< start time [s], finite
    float eps{}; ///< time-to-go at which the gains are held [s], >= 1e-18, < tau
    float u_max{}; ///< bound of |u| [unit of u], > 0, infinity allowed
    float a{}; ///< rate of stretched time [1/s], from 1e-18 to 1e18
    std::array<float, 3> k{}; ///< gains of pi0 = -(k_1 xi_1 + ... + k_3 xi_3), finite; k[0] is k_1 [1/s^3], k[1] is k_2 [1/s^2], k[2] is k_3 [1/s]
};

/// Feedback gains at one time.
struct [[nodiscard]] PtcExp3F32Gains {
    std::array<float, 3> gain{}; ///< u = gain[0] x[0] + ... + gain[2] x[2]
    float u_max{}; ///< bound of |u|
    Status status{Status::Input}; ///< Ok or Hold; negative where there are no gains

    /// u of one axis from its state x = (x1, x1', ...) and the gains.
    /// On a negative status u is 0 and nothing has changed.
    constexpr Control<float> axis(const std::array<float, 3>& x) const noexcept
    {
        if (status < Status::Ok) {
            return {0.0f, status};
        }
        const float s1 = (gain[0] * x[0]) + (gain[1] * x[1]);
        const float v = s1 + (gain[2] * x[2]);
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
                return {0.0f, Status::Range};
            }
        } else {
            return {0.0f, Status::Input};
        }
    }

private:
    /// std::isfinite is not constexpr in C++17.
    static constexpr bool finite(float v) noexcept
    {
        return (v >= std::numeric_limits<float>::lowest()) && (v <= (std::numeric_limits<float>::max)());
    }

    static constexpr float absolute(float v) noexcept
    {
        return (v > 0.0f) ? v : (0.0f - v);
    }
};

/// Controller: set by init, changed by arm and by what is not const.
class PtcExp3F32 {
public:
    using Params = PtcExp3F32Params;
    using State = std::array<float, 3>;
    using Gains = PtcExp3F32Gains;

    /// Takes the parameters and arms at params.t0 (or the fixed t0). Ok, or Param with nothing
    /// changed.
    [[nodiscard]] constexpr Status init(const Params& params) noexcept
    {
        PtcExp3F32 built{};
        const float tau = params.tau;
        const float t0 = params.t0;
        const float eps = params.eps;
        const float u_max = params.u_max;
        const float a = params.a;
        const float k1 = params.k[0];
        const float k2 = params.k[1];
        const float k3 = params.k[2];
        if (!(finite(tau)
                && (1e-18f <= tau)
                && (tau <= 1e18f)
                && finite(t0)
                && (eps >= 1e-18f)
                && (u_max > 0.0f)
                && finite(a)
                && (1e-18f <= a)
                && (a <= 1e18f)
                && finite(k1)
                && finite(k2)
                && finite(k3)
                && (eps < tau))) {
            return Status::Param;
        }
        const float v1 = a * a;
        const float v2 = a * v1;
        const float K1 = k1 / v2;
        const float K2 = k2 / v1;
        const float K3 = k3 / a;
        const float c1 = -K1;
        const float c2 = ((-K2) + K3) - 1.0f;
        const float c3 = (-K3) + 3.0f;
        const float hold_from = -eps;
        const float size_K1 = (absolute(k1) <= 0.0f) ? 1e-30f : absolute(K1);
        const float size_K2 = (absolute(k2) <= 0.0f) ? 1e-30f : absolute(K2);
        const float size_K3 = (absolute(k3) <= 0.0f) ? 1e-30f : absolute(K3);
        if (!((v2 >= 1e-30f)
                && (size_K1 >= 1e-30f)
                && (size_K2 >= 1e-30f)
                && (size_K3 >= 1e-30f)
                && finite(c1)
                && finite(c2)
                && finite(c3)
                && finite(hold_from))) {
            return Status::Param;
        }
        built.c1_ = c1;
        built.c2_ = c2;
        built.c3_ = c3;
        built.tau_ = tau;
        built.eps_ = eps;
        built.hold_from_ = hold_from;
        built.u_max_ = u_max;
        built.t0_ = 0.0f;
        built.deadline_ = 0.0f;
        built.correction_ = 0.0f;
        const Status status = built.arm(t0);
        if (status == Status::Ok) {
            *this = built;
        }
        return status;
    }

    /// Starts again at t0 [s].
    /// Ok, or Param with nothing changed.
    [[nodiscard]] constexpr Status arm(float t0) noexcept
    {
        if (!finite(t0)) {
            return Status::Param;
        }
        const float deadline = t0 + tau_;
        const float v1 = deadline - t0;
        const float correction = (t0 - (deadline - v1)) + (tau_ - v1);
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
    constexpr Control<float> step(float t, const std::array<float, 3>& x) const noexcept
    {
        if (!(t >= t0_)) {
            return {0.0f, Status::Input};
        }
        const float past = (t - deadline_) - correction_;
        const float late = (past < hold_from_) ? past : hold_from_;
        const float inv_T = (-1.0f) / late;
        const float s1 = ((c1_ * x[0] * inv_T) + (c2_ * x[1])) * inv_T;
        const float v = (s1 + (c3_ * x[2])) * inv_T;
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
                return {0.0f, Status::Range};
            }
        } else {
            return {0.0f, Status::Input};
        }
    }

    /// The gains at time t [s], for several axes that share one deadline: tick once, then axis for
    /// each. The result of tick and axis may differ from that of step in the last bits.
    constexpr Gains tick(float t) const noexcept
    {
        if (!(finite(t) && (t >= t0_))) {
            return {};
        }
        const float past = (t - deadline_) - correction_;
        const float late = (past < hold_from_) ? past : hold_from_;
        const float inv_T = (-1.0f) / late;
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
    static constexpr bool finite(float v) noexcept
    {
        return (v >= std::numeric_limits<float>::lowest()) && (v <= (std::numeric_limits<float>::max)());
    }

    static constexpr float absolute(float v) noexcept
    {
        return (v > 0.0f) ? v : (0.0f - v);
    }

    float c1_{}; // coefficient of x1
    float c2_{}; // coefficient of x2
    float c3_{}; // coefficient of x3
    float t0_{}; // start time
    float tau_{}; // prescribed settling time
    float deadline_{}; // t0 + tau, rounded
    float correction_{}; // low part of t0 + tau (compensated sum)
    float eps_{}; // time-to-go at which the gains are held
    float hold_from_{}; // -eps: later than this the gains are held
    float u_max_{}; // bound of |u|
};

} // namespace ptc

#endif
