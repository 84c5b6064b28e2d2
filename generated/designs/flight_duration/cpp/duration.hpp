/*
 * Prescribed-time controller duration: order n = 3, mapping tan.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang cpp --n 3 --mu tan --name duration --in-flight --precision f32 --u-max=100 --poles=-4,-5,-6
 * Version 0.1.0, design 3d20bda1c4e1.
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
 *   u_max = 100 [unit of u], fixed: bound of |u|
 *   k_1 = 120 [1/s^3], fixed: gain of xi_1
 *   k_2 = 74 [1/s^2], fixed: gain of xi_2
 *   k_3 = 15 [1/s], fixed: gain of xi_3
 *   tau: prescribed settling time [s], from 1e-18 to 1e18
 *   t0: start time [s], finite
 *   eps: time-to-go at which the gains are held [s], >= 1e-18, < tau
 *   a: rate of stretched time [1/s], from 1e-18 to 1e18
 *
 * Time mapping, with time-to-go T = t0 + tau - t and elapsed time Dt = t - t0; t in mu(t) is
 *       the stretched time since t0:
 *   mu(t)     = (2*tau/pi)*atan(a*t)
 *   kappa(Dt) = cot(th)/a, th = pi*T/(2*tau)
 *   in terms of y = cot(th), V = 1/(1 + y^2)
 * Derivatives r_k = mu^(k)(kappa(Dt)):
 *   r_k = (-1)^(k-1) (k-1)! (2*tau/pi) a^k sin(k*th) sin(th)^k
 *   r_1 = 2*pi^-1*tau*a*V
 *   r_2 = -4*pi^-1*tau*a^2*y*V^2
 *   r_3 = 12*pi^-1*tau*a^3*y^2*V^3 - 4*pi^-1*tau*a^3*V^3
 * Matrix BB_n, entry (i,j) = B_{i-1,j-1}(r_1, ...), and its next row b_n; zeros are left out:
 *   B_{0,0} = 1
 *   B_{1,1} = 2*pi^-1*tau*a*V
 *   B_{2,1} = -4*pi^-1*tau*a^2*y*V^2
 *   B_{2,2} = 4*pi^-2*tau^2*a^2*V^2
 *   B_{3,1} = 12*pi^-1*tau*a^3*y^2*V^3 - 4*pi^-1*tau*a^3*V^3
 *   B_{3,2} = -24*pi^-2*tau^2*a^3*y*V^3
 *
 * Law, Theorem 1, with xi = BB_n x and t_kappa = kappa(Dt) + t0:
 *   u = kappa'^n (pi0(xi, t_kappa) - b_n^T x)
 *   pi0 = -(k_1 xi_1 + ... + k_3 xi_3)
 *   u = sum_j gain_j x_j
 *   gain_j = row_j
 *   K1, K2, ...: K_i = k_i/a^(n+1-i)
 *   row_1 = -K1*slope^3
 *   row_2 = -4*pi^-2*tau^2*K2*cot_rate^4 + 4*pi^-1*tau*K3*cot_rate^3 + pi*tau^-1*K3*cot_rate
 *       + 1/2*pi^2*tau^-2 - 1/4*pi^2*tau^-2*K2 - 2*K2*cot_rate^2 - 6*cot_rate^2
 *   row_3 = -2*pi^-1*tau*K3*cot_rate^2 - 1/2*pi*tau^-1*K3 + 6*cot_rate
 *   cot_rate = (pi/(2*tau))*y = (pi/(2*tau))*cot(th)
 *   slope = (pi/(2*tau))*(1 + y^2) = kappa'/a
 *
 * From t0 + tau - eps on, and after the deadline, the gains of T = eps are held (status HOLD).
 * In flight: arm_for starts again at t0 for another tau, at any time, and computes what
 *       follows from tau. arm keeps the tau last used: at first that of the parameters.
 * |u| <= u_max: u is clipped to it (status SATURATED). Prolonged saturation voids the
 *       deadline.
 * Guard full: t and x are finite and t >= t0, or the call is refused (INPUT).
 * Precision f32 (IEEE 754 binary32). Results are bit for bit the same on every IEEE 754
 *       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
 *
 * Checks of the design (details: ptc-codegen check):
 *   membership: sound: tan is of class M for all its parameters.
 *   growth: sound: x and u go to 0 at the deadline.
 *   sampling: not checked: `sample_time` is not given.
 *   deadline: not checked: `error` is not given.
 *   loop: not checked: it needs a value of `tau`.
 *   envelope: not checked: `x_max` is not given.
 *
 * Operations of one step, without input checks and clipping: 21 additions or comparisons, 28
 *       multiplications, 1 division.
 */
#ifndef DURATION_D3D15BAF_HPP
#define DURATION_D3D15BAF_HPP

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
struct DurationParams {
    float tau{}; ///< prescribed settling time [s], from 1e-18 to 1e18
    float t0{}; ///< start time [s], finite
    float eps{}; ///< time-to-go at which the gains are held [s], >= 1e-18, < tau
    float a{}; ///< rate of stretched time [1/s], from 1e-18 to 1e18
};

/// Feedback gains at one time.
struct [[nodiscard]] DurationGains {
    std::array<float, 3> gain{}; ///< u = gain[0] x[0] + ... + gain[2] x[2]
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
        if (finite(v) && (absolute(v) <= 100.0f)) {
            return {v, status};
        } else if (finite(x[0]) && finite(x[1]) && finite(x[2])) {
            if (finite(v)) {
                if (v > 100.0f) {
                    return {100.0f, Status::Saturated};
                } else {
                    return {-100.0f, Status::Saturated};
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
class Duration {
public:
    using Params = DurationParams;
    using State = std::array<float, 3>;
    using Gains = DurationGains;

    /// Takes the parameters and arms at params.t0 (or the fixed t0) for params.tau. Ok, or Param
    /// with nothing changed.
    [[nodiscard]] constexpr Status init(const Params& params) noexcept
    {
        Duration built{};
        const float tau = params.tau;
        const float t0 = params.t0;
        const float eps = params.eps;
        const float a = params.a;
        if (!(finite(tau)
                && (1e-18f <= tau)
                && (tau <= 1e18f)
                && finite(t0)
                && (eps >= 1e-18f)
                && finite(a)
                && (1e-18f <= a)
                && (a <= 1e18f)
                && (eps < tau))) {
            return Status::Param;
        }
        const float v1 = a * a;
        const float v2 = a * v1;
        const float K1 = 120.0f / v2;
        const float K2 = 74.0f / v1;
        const float K3 = 15.0f / a;
        const float c1_3 = -K1;
        const float hold_from = -eps;
        const float c2_2 = (-(2.0f * K2)) - 6.0f;
        const float f69 = (-(2.467401f * K2)) + 4.934802f;
        const float f73 = 3.1415927f * K3;
        const float f81 = 1.2732395f * K3;
        const float f85 = -(0.40528473f * K2);
        const float f99 = -(1.5707964f * K3);
        const float f103 = -(0.63661975f * K3);
        if (!((v2 >= 1e-30f)
                && (K1 >= 1e-30f)
                && finite(c1_3)
                && finite(hold_from)
                && finite(f69)
                && finite(f73)
                && finite(c2_2)
                && finite(f81)
                && finite(f85)
                && finite(f99)
                && finite(f103))) {
            return Status::Param;
        }
        built.c1_3_ = c1_3;
        built.eps_ = eps;
        built.hold_from_ = hold_from;
        built.f69_ = f69;
        built.f73_ = f73;
        built.c2_2_ = c2_2;
        built.f81_ = f81;
        built.f85_ = f85;
        built.f99_ = f99;
        built.f103_ = f103;
        built.tau_ = 0.0f;
        built.angle_rate_ = 0.0f;
        built.inv_angle_rate_ = 0.0f;
        built.t0_ = 0.0f;
        built.deadline_ = 0.0f;
        built.correction_ = 0.0f;
        built.inv_tau_ = 0.0f;
        built.c2_0_ = 0.0f;
        built.c2_1_ = 0.0f;
        built.c2_3_ = 0.0f;
        built.c2_4_ = 0.0f;
        built.c3_0_ = 0.0f;
        built.c3_2_ = 0.0f;
        const Status status = built.arm_for(t0, tau);
        if (status == Status::Ok) {
            *this = built;
        }
        return status;
    }

    /// Starts again at t0 [s], with the tau last used.
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

    /// Starts again at t0 [s] with another duration tau [s]: the deadline is t0 + tau.
    /// Ok, or Param with nothing changed.
    [[nodiscard]] constexpr Status arm_for(float t0, float tau) noexcept
    {
        if (!(finite(t0) && finite(tau) && (1e-18f <= tau) && (tau <= 1e18f) && (tau > eps_))) {
            return Status::Param;
        }
        const float angle_rate = 1.5707964f / tau;
        const float inv_angle_rate = 0.63661975f * tau;
        const float deadline = t0 + tau;
        const float v1 = deadline - t0;
        const float correction = (t0 - (deadline - v1)) + (tau - v1);
        const float inv_tau = 1.0f / tau;
        const float v2 = tau * tau;
        const float c2_0 = f69_ / v2;
        const float c2_1 = f73_ / tau;
        const float c2_3 = f81_ * tau;
        const float c2_4 = f85_ * v2;
        const float c3_0 = f99_ / tau;
        const float c3_2 = f103_ * tau;
        if (!(finite(deadline)
                && (c2_4 <= -1e-30f)
                && finite(angle_rate)
                && finite(inv_angle_rate)
                && finite(inv_tau)
                && finite(c2_0)
                && finite(c2_1)
                && finite(c2_3)
                && finite(c2_4)
                && finite(c3_0)
                && finite(c3_2))) {
            return Status::Param;
        }
        tau_ = tau;
        angle_rate_ = angle_rate;
        inv_angle_rate_ = inv_angle_rate;
        t0_ = t0;
        deadline_ = deadline;
        correction_ = correction;
        inv_tau_ = inv_tau;
        c2_0_ = c2_0;
        c2_1_ = c2_1;
        c2_3_ = c2_3;
        c2_4_ = c2_4;
        c3_0_ = c3_0;
        c3_2_ = c3_2;
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
        const float v1 = late * inv_tau_;
        const float inv_T_squared = 1.0f / (late * late);
        const float v2 = v1 * v1;
        const float s1 = (((((-9.25448e-5f) * v2) - 7.2446054e-9f) * v2) - 0.0006016576f) * v2;
        const float s2 = ((((s1 - 0.0018990984f) * v2) - 0.007859069f) * v2) - 0.031790096f;
        const float th_cot_th = (((((s2 * v2) - 0.13529049f) * v2) - 0.822467f) * v2) + 1.0f;
        const float cot_rate_squared = inv_T_squared * (th_cot_th * th_cot_th);
        const float slope = angle_rate_ + (inv_angle_rate_ * cot_rate_squared);
        const float row1 = c1_3_ * slope * slope * slope;
        const float T = -late;
        const float cot_rate = T * inv_T_squared * th_cot_th;
        const float s3 = (c2_4_ * cot_rate_squared) + c2_2_;
        const float s4 = ((c2_3_ * cot_rate_squared) + c2_1_) * cot_rate;
        const float row2 = (s3 * cot_rate_squared) + c2_0_ + s4;
        const float row3 = (c3_2_ * cot_rate_squared) + c3_0_ + (6.0f * cot_rate);
        const float v = (row1 * x[0]) + (row2 * x[1]) + (row3 * x[2]);
        if (finite(v) && (absolute(v) <= 100.0f) && (late < hold_from_)) {
            return {v, Status::Ok};
        } else if (finite(t) && finite(x[0]) && finite(x[1]) && finite(x[2])) {
            if (finite(v)) {
                if (v > 100.0f) {
                    return {100.0f, Status::Saturated};
                } else if (v < -100.0f) {
                    return {-100.0f, Status::Saturated};
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
        const float v1 = late * inv_tau_;
        const float inv_T_squared = 1.0f / (late * late);
        const float v2 = v1 * v1;
        const float s1 = (((((-9.25448e-5f) * v2) - 7.2446054e-9f) * v2) - 0.0006016576f) * v2;
        const float s2 = ((((s1 - 0.0018990984f) * v2) - 0.007859069f) * v2) - 0.031790096f;
        const float th_cot_th = (((((s2 * v2) - 0.13529049f) * v2) - 0.822467f) * v2) + 1.0f;
        const float cot_rate_squared = inv_T_squared * (th_cot_th * th_cot_th);
        const float slope = angle_rate_ + (inv_angle_rate_ * cot_rate_squared);
        const float row1 = c1_3_ * slope * slope * slope;
        const float T = -late;
        const float cot_rate = T * inv_T_squared * th_cot_th;
        const float s3 = (c2_4_ * cot_rate_squared) + c2_2_;
        const float s4 = ((c2_3_ * cot_rate_squared) + c2_1_) * cot_rate;
        const float row2 = (s3 * cot_rate_squared) + c2_0_ + s4;
        const float row3 = (c3_2_ * cot_rate_squared) + c3_0_ + (6.0f * cot_rate);
        Gains gains{};
        gains.gain[0] = row1;
        gains.gain[1] = row2;
        gains.gain[2] = row3;
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

    float c1_3_{}; // coefficient of slope^3 in the gain of x1
    float tau_{}; // prescribed settling time
    float angle_rate_{}; // pi/(2*tau)
    float inv_angle_rate_{}; // 2*tau/pi
    float t0_{}; // start time
    float deadline_{}; // t0 + tau, rounded
    float correction_{}; // low part of t0 + tau (compensated sum)
    float eps_{}; // time-to-go at which the gains are held
    float hold_from_{}; // -eps: later than this the gains are held
    float inv_tau_{}; // 1/tau
    float f69_{}; // derived from the parameters
    float c2_0_{}; // coefficient of cot_rate^0 in the gain of x2
    float f73_{}; // derived from the parameters
    float c2_1_{}; // coefficient of cot_rate^1 in the gain of x2
    float c2_2_{}; // coefficient of cot_rate^2 in the gain of x2
    float f81_{}; // derived from the parameters
    float c2_3_{}; // coefficient of cot_rate^3 in the gain of x2
    float f85_{}; // derived from the parameters
    float c2_4_{}; // coefficient of cot_rate^4 in the gain of x2
    float f99_{}; // derived from the parameters
    float c3_0_{}; // coefficient of cot_rate^0 in the gain of x3
    float f103_{}; // derived from the parameters
    float c3_2_{}; // coefficient of cot_rate^2 in the gain of x3
};

} // namespace ptc

#endif
