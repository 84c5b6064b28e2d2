/*
 * Prescribed-time controller ptc_exp_sum2: order n = 2, mapping exp_sum.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang cpp --n 2 --mu "exp_sum(2)"
 * Version 0.1.0, design b16d2a0d4a86.
 *
 * Plant: x1' = x2, x2' = f + u. Time in s, x1 in any unit U, x2 in U/s, u in U/s^2.
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
 *   tau: prescribed settling time [s], from 1e-150 to 1e150
 *   t0: start time [s], finite
 *   eps: time-to-go at which the gains are held [s], >= 1e-150, < tau
 *   u_max: bound of |u| [unit of u], > 0, infinity allowed
 *   rates: rates a_i of stretched time, from 1e-150 to 1e150; rates[0] is a_1 [1/s], rates[1]
 *       is a_2 [1/s]
 *   k: gains of pi0 = -(k_1 xi_1 + k_2 xi_2), finite; k[0] is k_1 [1/s^2], k[1] is k_2 [1/s]
 *
 * Time mapping, with time-to-go T = t0 + tau - t and elapsed time Dt = t - t0; t in mu(t) is
 *       the stretched time since t0:
 *   mu(t)     = tau*mean_i(1 - exp(-a_i*t))
 *   kappa(Dt) = the root t of mean_i(exp(-a_i*t)) = T/tau, by a bracketed iteration
 *   in terms of e_i = exp(-a_i*t)
 * Derivatives r_k = mu^(k)(kappa(Dt)):
 *   r_k = (-1)^(k-1) tau mean_i(a_i^k e_i)
 *   r_1 = 1/2*tau*a1*e1 + 1/2*tau*a2*e2
 *   r_2 = -1/2*tau*a1^2*e1 - 1/2*tau*a2^2*e2
 * Matrix BB_n, entry (i,j) = B_{i-1,j-1}(r_1, ...), and its next row b_n; zeros are left out:
 *   B_{0,0} = 1
 *   B_{1,1} = r1
 *   B_{2,1} = r2
 *
 * Law, Theorem 1, with xi = BB_n x and t_kappa = kappa(Dt) + t0:
 *   u = kappa'^n (pi0(xi, t_kappa) - b_n^T x)
 *   pi0 = -(k_1 xi_1 + k_2 xi_2)
 *   u = sum_j gain_j x_j
 *   gain_j = r_1^-(n+1-j) row_j
 *   row_j = -1/(j-1)! sum_{i=j..n+1} k_i (i-1)! [z^(i-1)] p(z)^(j-1), with k_(n+1) = 1
 *   p(z) = z + sum_{l>=2} r_l/(r_1 l!) z^l, where [z^i] takes the coefficient of z^i
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
 *   membership: sound: exp_sum is of class M for all its parameters.
 *   growth: not checked: the gains are left to run time: their poles must lie left of -n rho.
 *   sampling: not checked: `sample_time` is not given.
 *   deadline: not checked: `error` is not given.
 *   loop: not checked: it needs a value of `tau`.
 *   envelope: not checked: `x_max` is not given.
 *
 * Operations of one step, without input checks and clipping: 34 additions or comparisons, 50
 *       multiplications, 5 divisions, 5 function calls. One round of the iteration is
 *       counted; it takes at most 12.
 */
#ifndef PTC_EXP_SUM2_32CA0CEA_HPP
#define PTC_EXP_SUM2_32CA0CEA_HPP

#include <array>
#include <cfloat>
#include <cmath>
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

/// Run-time parameters.
struct PtcExpSum2Params {
    double tau{}; ///< prescribed settling time [s], from 1e-150 to 1e150
    double t0{}; ///< start time [s], finite
    double eps{}; ///< time-to-go at which the gains are held [s], >= 1e-150, < tau
    double u_max{}; ///< bound of |u| [unit of u], > 0, infinity allowed
    std::array<double, 2> rates{}; ///< rates a_i of stretched time, from 1e-150 to 1e150; rates[0] is a_1 [1/s], rates[1] is a_2 [1/s]
    std::array<double, 2> k{}; ///< gains of pi0 = -(k_1 xi_1 + k_2 xi_2), finite; k[0] is k_1 [1/s^2], k[1] is k_2 [1/s]
};

/// Feedback gains at one time.
struct [[nodiscard]] PtcExpSum2Gains {
    std::array<double, 2> gain{}; ///< u = gain[0] x[0] + ... + gain[1] x[1]
    double u_max{}; ///< bound of |u|
    Status status{Status::Input}; ///< Ok or Hold; negative where there are no gains

    /// u of one axis from its state x = (x1, x1', ...) and the gains.
    /// On a negative status u is 0 and nothing has changed.
    constexpr Control<double> axis(const std::array<double, 2>& x) const noexcept
    {
        if (status < Status::Ok) {
            return {0.0, status};
        }
        const double v = (gain[0] * x[0]) + (gain[1] * x[1]);
        if (finite(v) && (absolute(v) <= u_max)) {
            return {v, status};
        } else if (finite(x[0]) && finite(x[1])) {
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
class PtcExpSum2 {
public:
    using Params = PtcExpSum2Params;
    using State = std::array<double, 2>;
    using Gains = PtcExpSum2Gains;

    /// Takes the parameters and arms at params.t0 (or the fixed t0). Ok, or Param with nothing
    /// changed.
    [[nodiscard]] constexpr Status init(const Params& params) noexcept
    {
        PtcExpSum2 built{};
        const double tau = params.tau;
        const double t0 = params.t0;
        const double eps = params.eps;
        const double u_max = params.u_max;
        const double a1 = params.rates[0];
        const double a2 = params.rates[1];
        const double k1 = params.k[0];
        const double k2 = params.k[1];
        if (!(finite(tau)
                && (1e-150 <= tau)
                && (tau <= 1e150)
                && finite(t0)
                && (eps >= 1e-150)
                && (u_max > 0.0)
                && finite(a1)
                && (1e-150 <= a1)
                && (a1 <= 1e150)
                && finite(a2)
                && (1e-150 <= a2)
                && (a2 <= 1e150)
                && finite(k1)
                && finite(k2)
                && (eps < tau))) {
            return Status::Param;
        }
        const double hold_from = -eps;
        const double target_rate = 2.0 / tau;
        const double v1 = 1.0 / a1;
        const double v2 = 1.0 / a2;
        const double slowest = (v1 < v2) ? v2 : v1;
        const double mean_period = 2.0 / (a1 + a2);
        const double s1 = (a1 < a2) ? a2 : a1;
        const double tolerance = 0.03 / s1;
        const double b1_1 = 0.5 * a1 * tau;
        const double b1_2 = 0.5 * a2 * tau;
        const double b2_1 = (-0.25) * (a1 * a1) * tau;
        const double b2_2 = (-0.25) * (a2 * a2) * tau;
        const double w1 = -k1;
        const double w2 = -k2;
        const double size_w1 = (absolute(k1) <= 0.0) ? 1e-200 : absolute(w1);
        const double size_w2 = (absolute(k2) <= 0.0) ? 1e-200 : absolute(w2);
        if (!((b2_1 <= -1e-200)
                && (b2_2 <= -1e-200)
                && (size_w1 >= 1e-200)
                && (size_w2 >= 1e-200)
                && finite(hold_from)
                && finite(target_rate)
                && finite(slowest)
                && finite(mean_period)
                && finite(tolerance)
                && finite(b1_1)
                && finite(b1_2)
                && finite(b2_1)
                && finite(b2_2)
                && finite(w1)
                && finite(w2))) {
            return Status::Param;
        }
        built.a1_ = a1;
        built.a2_ = a2;
        built.tau_ = tau;
        built.eps_ = eps;
        built.hold_from_ = hold_from;
        built.target_rate_ = target_rate;
        built.slowest_ = slowest;
        built.mean_period_ = mean_period;
        built.tolerance_ = tolerance;
        built.b1_1_ = b1_1;
        built.b1_2_ = b1_2;
        built.b2_1_ = b2_1;
        built.b2_2_ = b2_2;
        built.w1_ = w1;
        built.w2_ = w2;
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
    Control<double> step(double t, const std::array<double, 2>& x) const noexcept
    {
        if (!(t >= t0_)) {
            return {0.0, Status::Input};
        }
        const double past = (t - deadline_) - correction_;
        const double late = (past < hold_from_) ? past : hold_from_;
        const double T = -late;
        const double target = T * target_rate_;
        const double v1 = -std::log(target / 2.0);
        const double v2 = v1 * mean_period_;
        const double v3 = (v1 - 0.6931467056274414) * slowest_;
        double y = (v2 < v3) ? v3 : v2;
        double y_low = v2;
        double y_high = v1 * slowest_;
        for (std::uint32_t attempt = 0U; attempt < 12U; attempt++) {
            const double v4 = std::exp(-(a1_ * y));
            const double v5 = std::exp(-(a2_ * y));
            const double v6 = a1_ * v4;
            const double v7 = v4 + v5;
            const double v8 = a2_ * v5;
            const double v9 = (2.0 * (v7 - target)) / (v7 + target);
            const double v10 = v9 * (1.0 + (0.08333333333333333 * (v9 * v9)));
            const double v11 = 1.0 / (v6 + v8);
            const double v12 = v7 * v11;
            const double s1 = (((a1_ * v6) + (a2_ * v8)) * v11 * v12) - 1.0;
            const double v13 = v10 * v12 * (1.0 + (0.5 * v10 * s1));
            const double y_next = y + v13;
            const double y_size = absolute(v13);
            if (v10 > 0.0) {
                y_low = y;
            } else {
                y_high = y;
            }
            if ((y_low <= y_next) && (y_next <= y_high)) {
                y = y_next;
            } else {
                y = 0.5 * (y_low + y_high);
            }
            if (y_size <= tolerance_) {
                break;
            }
        }
        const double v14 = std::exp(-(a1_ * y));
        const double v15 = std::exp(-(a2_ * y));
        const double v16 = a1_ * v14;
        const double v17 = a2_ * v15;
        const double v18 = 1.0 / (v16 + v17);
        const double v19 = ((v14 + v15) - target) * v18;
        const double s2 = 1.0 + (0.5 * (((a1_ * v16) + (a2_ * v17)) * v18 * v19));
        const double v20 = v19 * s2;
        const double v21 = a1_ * v20;
        const double v22 = v14 - (v14 * (v21 * (1.0 - (0.5 * v21))));
        const double v23 = a2_ * v20;
        const double v24 = v15 - (v15 * (v23 * (1.0 - (0.5 * v23))));
        const double inv_r1 = 1.0 / ((b1_1_ * v22) + (b1_2_ * v24));
        const double p2 = ((b2_1_ * v22) + (b2_2_ * v24)) * inv_r1;
        const double s3 = (w1_ * x[0] * inv_r1) + ((w2_ + ((-2.0) * p2)) * x[1]);
        const double v = s3 * inv_r1;
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

    /// The gains at time t [s], for several axes that share one deadline: tick once, then axis for
    /// each. The result of tick and axis may differ from that of step in the last bits.
    Gains tick(double t) const noexcept
    {
        if (!(finite(t) && (t >= t0_))) {
            return {};
        }
        const double past = (t - deadline_) - correction_;
        const double late = (past < hold_from_) ? past : hold_from_;
        const double T = -late;
        const double target = T * target_rate_;
        const double v1 = -std::log(target / 2.0);
        const double v2 = v1 * mean_period_;
        const double v3 = (v1 - 0.6931467056274414) * slowest_;
        double y = (v2 < v3) ? v3 : v2;
        double y_low = v2;
        double y_high = v1 * slowest_;
        for (std::uint32_t attempt = 0U; attempt < 12U; attempt++) {
            const double v4 = std::exp(-(a1_ * y));
            const double v5 = std::exp(-(a2_ * y));
            const double v6 = a1_ * v4;
            const double v7 = v4 + v5;
            const double v8 = a2_ * v5;
            const double v9 = (2.0 * (v7 - target)) / (v7 + target);
            const double v10 = v9 * (1.0 + (0.08333333333333333 * (v9 * v9)));
            const double v11 = 1.0 / (v6 + v8);
            const double v12 = v7 * v11;
            const double s1 = (((a1_ * v6) + (a2_ * v8)) * v11 * v12) - 1.0;
            const double v13 = v10 * v12 * (1.0 + (0.5 * v10 * s1));
            const double y_next = y + v13;
            const double y_size = absolute(v13);
            if (v10 > 0.0) {
                y_low = y;
            } else {
                y_high = y;
            }
            if ((y_low <= y_next) && (y_next <= y_high)) {
                y = y_next;
            } else {
                y = 0.5 * (y_low + y_high);
            }
            if (y_size <= tolerance_) {
                break;
            }
        }
        const double v14 = std::exp(-(a1_ * y));
        const double v15 = std::exp(-(a2_ * y));
        const double v16 = a1_ * v14;
        const double v17 = a2_ * v15;
        const double v18 = 1.0 / (v16 + v17);
        const double v19 = ((v14 + v15) - target) * v18;
        const double s2 = 1.0 + (0.5 * (((a1_ * v16) + (a2_ * v17)) * v18 * v19));
        const double v20 = v19 * s2;
        const double v21 = a1_ * v20;
        const double v22 = v14 - (v14 * (v21 * (1.0 - (0.5 * v21))));
        const double v23 = a2_ * v20;
        const double v24 = v15 - (v15 * (v23 * (1.0 - (0.5 * v23))));
        const double inv_r1 = 1.0 / ((b1_1_ * v22) + (b1_2_ * v24));
        const double p2 = ((b2_1_ * v22) + (b2_2_ * v24)) * inv_r1;
        Gains gains{};
        gains.gain[0] = w1_ * inv_r1 * inv_r1;
        gains.gain[1] = (w2_ + ((-2.0) * p2)) * inv_r1;
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

    double a1_{}; // rates a_i of stretched time
    double a2_{}; // rates a_i of stretched time
    double t0_{}; // start time
    double tau_{}; // prescribed settling time
    double deadline_{}; // t0 + tau, rounded
    double correction_{}; // low part of t0 + tau (compensated sum)
    double eps_{}; // time-to-go at which the gains are held
    double hold_from_{}; // -eps: later than this the gains are held
    double target_rate_{}; // N/tau, N the number of rates
    double slowest_{}; // 1/min a_i
    double mean_period_{}; // 1/mean a_i
    double tolerance_{}; // size of the last step of the iteration
    double b1_1_{}; // weight of exp(-a1*y) in r1/1!
    double b1_2_{}; // weight of exp(-a2*y) in r1/1!
    double b2_1_{}; // weight of exp(-a1*y) in r2/2!
    double b2_2_{}; // weight of exp(-a2*y) in r2/2!
    double w1_{}; // weighted gain -0!*k1
    double w2_{}; // weighted gain -1!*k2
    double u_max_{}; // bound of |u|
};

} // namespace ptc

#endif
