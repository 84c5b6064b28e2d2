/*
 * Prescribed-time controller paced: order n = 2, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang cpp --n 2 --mu "exp(a=1)" --name paced --clock samples --late=extend --pace=soonest --tau=1 --eps=0 --u-min=-1 --poles=-4,-5,-6 --after zero --sample-time=0.01 --delay=1
 * Version 0.1.0, design d3e4f699dd7c.
 *
 * Plant: x1' = x2, x2' = u; u held from sample to sample, one sample late.
 * Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
 *       sample period, as long as u is not clipped and nothing else acts on the plant.
 * Law: with M - 3 samples to go and z = S x, u h^3 = sum of row_j z_j
 *       h^(j-1)/((M-j+1)...(M-2)); the rows are those of Theorem 1 for the mapping exp. The
 *       gains of 3 samples to go stay: they are deadbeat.
 *
 * Parameters:
 *   samples = 100 [samples], fixed: samples N from the start to rest
 *   h = 0.01 [s], fixed: sample period
 *   eps = 0 [s], fixed: time-to-go at which the gains are held
 *   u_max [unit of u]: upper limit of u
 *   u_min = -1 [unit of u], fixed: lower limit of u
 *   a = 1 [1/s], fixed: rate of stretched time
 *   k_1 = 120 [1/s^3], fixed: gains k_i of pi0 = -sum k_i xi_i
 *   k_2 = 74 [1/s^2], fixed: gains k_i of pi0 = -sum k_i xi_i
 *   k_3 = 15 [1/s], fixed: gains k_i of pi0 = -sum k_i xi_i
 *
 * k counts samples and may wrap; arm again within 2^32 - N samples.
 * From sample N on u = 0 (status AFTER).
 * In flight: arm_for sets another deadline at any tick; rest is exact from any state, so all
 *       else stays as it is.
 * Plan: on the way to rest u and the states are sums of falling powers of the samples to go,
 *       so their Bernstein coefficients, linear in z, bound them. If these are within the
 *       limits, u stay there at every sample to rest, where plant and state are as they are
 *       known.
 * late extend: a step without such a plan raises N to the soonest that has one (status LATE;
 *       deadline gives its tick), and others lower N, by at most a sixteenth of the samples
 *       to go. Where none is found (status INFEASIBLE), or 2^31 samples after the start, N
 *       stays, and u is clipped; states may leave their bounds then.
 * u_min <= u <= u_max: u is clipped to these limits (status SATURATED). Clipping voids the
 *       deadline where it lasts.
 * Guard full: what is measured is finite, or the call is refused (INPUT).
 * Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
 *       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
 *
 * Checks of the design (details: ptc-codegen check):
 *   membership: sound: exp is of class M for all its parameters.
 *   growth: sound: at rest at sample 100 from any state, whatever the poles, and |u| is
 *       bounded.
 *   sampling: not checked: the law is exact in samples, at any period.
 *   deadline: not checked: the law is exact in samples, at any period.
 *   loop: not checked: `x0_max` is not given.
 *   envelope: not checked: it does not examine a clock in samples.
 */
#ifndef PACED_47F35F3C_HPP
#define PACED_47F35F3C_HPP

#include <array>
#include <cfloat>
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

#ifndef PTC_VALUE_HPP
#define PTC_VALUE_HPP
/// A value and the status of the call that gave it.
template <class Given>
struct [[nodiscard]] Value {
    Given value; ///< zeros on a negative status
    Status status;
};
#endif

/// Run-time parameters.
struct PacedParams {
    double u_max{}; ///< upper limit of u [unit of u], > u_min, infinity allowed
};

/// Controller: set by init, changed by arm and by what is not const.
class Paced {
public:
    using Params = PacedParams;

    /// Takes the parameters and arms at tick 0. Ok, or Param with nothing changed.
    [[nodiscard]] constexpr Status init(const Params& params) noexcept
    {
        if (!((params.u_max > -1.0) && (params.u_max >= 0.0))) {
            return Status::Param;
        }
        const double u_max = params.u_max;
        start_ = 0U;
        last_ = 100U;
        u1_ = 0.0;
        u_max_ = u_max;
        return Status::Ok;
    }

    /// Starts again: the deadline is N samples after tick `k`. Estimates and inputs under way are
    /// kept.
    constexpr void arm(std::uint32_t k) noexcept
    {
        start_ = k;
        last_ = 100U;
    }

    /// u from tick `k`, which may wrap, and the state x = (x1, x1', ...). Call it once for each
    /// tick.
    /// On a negative status u is 0 and nothing has changed.
    constexpr Control<double> step(std::uint32_t k, const std::array<double, 2>& x) noexcept
    {
        if (!(finite(x[0]) && finite(x[1]))) {
            return {0.0, Status::Input};
        }
        const std::uint32_t elapsed = k - start_;
        const double x1 = x[0];
        const double x2 = x[1];

        // The deadline that keeps the limits.
        std::uint32_t last_now = last_;
        std::uint32_t late = 0U;
        if (elapsed < last_) {
            const std::uint32_t to_rest = (elapsed < last_) ? (last_ - elapsed) : 0U;
            const std::uint32_t ahead = to_rest;
            const double flat1 = (s1_1_ * x1) + (s1_2_ * x2);
            const double flat2 = s2_2_ * x2;
            const double flat3 = u1_;
            std::uint32_t below = ((ahead / 16U) < ((1U < ahead) ? (ahead - 1U) : 0U)) ? (((1U < ahead) ? (ahead - 1U) : 0U) - (ahead / 16U)) : 0U;
            if (ahead > 3U) {
                if (below < 3U) {
                    below = 3U;
                }
            } else {
                below = (1U < ahead) ? (ahead - 1U) : 0U;
            }
            std::uint32_t low = below;
            std::uint32_t top = 1073741825U;
            std::uint32_t kept = 0U;
            std::uint32_t tried = ahead;
            double part = 0.9999999999968848;
            for (std::uint32_t attempt = 0U; attempt < 64U; attempt++) {
                const double least = -part;
                const double most = u_max_ * part;
                std::uint32_t fits = 0U;
                if (tried > 3U) {
                    const double m = static_cast<double>(tried);
                    const double power1 = m + 3.0;
                    const double power2 = power1 * (m + 2.0);
                    const double power3 = power2 * (m + 1.0);
                    const double power4 = power3 * m;
                    const double power5 = power4 * (m - 1.0);
                    const double power6 = power5 * (m - 2.0);
                    const double scaled2 = flat2 * power1;
                    const double scaled3 = flat3 * power2;
                    const double w1 = ((15.0 * flat1) + (5.0 * scaled2) + (0.5 * scaled3)) / power4;
                    const double w2 = ((((-24.0) * flat1) - (9.0 * scaled2)) - scaled3) / power5;
                    const double w3 = ((10.0 * flat1) + (4.0 * scaled2) + (0.5 * scaled3)) / power6;
                    const double length = m - 4.0;
                    const double b0_c = (144.0 * w1) + (480.0 * w2) + (720.0 * w3);
                    const double b1_c = ((84.0 * w1) + (520.0 * w2) + (1500.0 * w3)) * length;
                    const double b2_l = length * length;
                    const double b2_c = ((12.0 * w1) + (180.0 * w2) + (1050.0 * w3)) * b2_l;
                    const double b3_l = b2_l * length;
                    const double b3_c = ((20.0 * w2) + (300.0 * w3)) * b3_l;
                    const double b4_l = b3_l * length;
                    const double b4_c = 30.0 * w3 * b4_l;
                    const double b1 = b0_c + (0.125 * b1_c);
                    const double b2 = b0_c + (0.25 * b1_c) + (0.03571428571428571 * b2_c);
                    const double s1 = b0_c + (0.375 * b1_c) + (0.10714285714285714 * b2_c);
                    const double b3 = s1 + (0.017857142857142856 * b3_c);
                    const double s2 = b0_c + (0.5 * b1_c) + (0.21428571428571427 * b2_c);
                    const double s3 = s2 + (0.07142857142857142 * b3_c);
                    const double b4 = s3 + (0.014285714285714285 * b4_c);
                    const double s4 = b0_c + (0.625 * b1_c) + (0.35714285714285715 * b2_c);
                    const double s5 = s4 + (0.17857142857142858 * b3_c);
                    const double b5 = s5 + (0.07142857142857142 * b4_c);
                    const double s6 = b0_c + (0.75 * b1_c) + (0.5357142857142857 * b2_c);
                    const double s7 = s6 + (0.35714285714285715 * b3_c);
                    const double b6 = s7 + (0.21428571428571427 * b4_c);
                    const double s8 = b0_c + (0.875 * b1_c) + (0.75 * b2_c) + (0.625 * b3_c);
                    const double b7 = s8 + (0.5 * b4_c);
                    const double b8 = b0_c + b1_c + b2_c + b3_c + b4_c;
                    const double end29 = (72.0 * w1) + (120.0 * w2);
                    const double end30 = 24.0 * w1;
                    if ((least <= b0_c)
                        && (b0_c <= most)
                        && (least <= b1)
                        && (b1 <= most)
                        && (least <= b2)
                        && (b2 <= most)
                        && (least <= b3)
                        && (b3 <= most)
                        && (least <= b4)
                        && (b4 <= most)
                        && (least <= b5)
                        && (b5 <= most)
                        && (least <= b6)
                        && (b6 <= most)
                        && (least <= b7)
                        && (b7 <= most)
                        && (least <= b8)
                        && (b8 <= most)
                        && (least <= end29)
                        && (end29 <= most)
                        && (least <= end30)
                        && (end30 <= most)) {
                        fits = 1U;
                    }
                } else {
                    const double end0 = ((-flat1) - (3.0 * flat2)) - (2.0 * flat3);
                    const double end1 = flat1 + (2.0 * flat2) + flat3;
                    if ((least <= end0) && (end0 <= most) && (least <= end1) && (end1 <= most)) {
                        fits = 1U;
                    }
                }
                if (fits == 1U) {
                    kept = tried;
                    top = tried;
                } else if (tried > 3U) {
                    low = tried;
                } else {
                    low = 3U;
                }
                const std::uint32_t gap = (low < top) ? (top - low) : 0U;
                if (gap < 2U) {
                    break;
                }
                const std::uint32_t half = gap / 2U;
                if (low < half) {
                    tried = low + low;
                } else {
                    tried = low + half;
                }
                part = 0.9999999999937695;
            }
            if ((kept > 0U) && (elapsed < 2147483648U)) {
                last_now = elapsed + kept;
            }
            if ((kept == 0U) && (ahead > 0U)) {
                late = 2U;
            }
        }
        if (last_now > last_) {
            late = 1U;
        }
        const std::uint32_t left = (elapsed < last_now) ? (last_now - elapsed) : 0U;
        const double m0 = (static_cast<double>(left) < 3.0) ? 3.0 : static_cast<double>(left);
        double v{};

        // The exact law in samples.
        const double z1 = (w1_1_ * x1) + (w1_2_ * x2);
        const double z2 = w2_2_ * x2;
        const double z3 = w3_3_ * u1_;
        const double m0f1 = m0 + 3.0;
        const double m0f2 = m0f1 * (m0 + 2.0);
        v = ((z1 + (z2 * m0f1) + (z3 * m0f2)) / (m0f2 * (m0 + 1.0))) + u1_;
        if (!finite(v)) {
            return {0.0, Status::Range};
        }
        double u_now{};
        if (elapsed < last_now) {
            if (v > u_max_) {
                u_now = u_max_;
            } else if (v < -1.0) {
                u_now = -1.0;
            } else {
                u_now = v;
            }
        } else {
            u_now = 0.0;
        }
        u1_ = u_now;
        last_ = last_now;
        if (elapsed < last_now) {
            if ((v > u_max_) || (v < -1.0)) {
                return {u_now, Status::Saturated};
            } else if (late == 2U) {
                return {u_now, Status::Infeasible};
            } else if (late == 1U) {
                return {u_now, Status::Late};
            } else {
                return {u_now, Status::Ok};
            }
        } else {
            return {u_now, Status::After};
        }
    }

    /// Another deadline, at any tick before the call of `step` at it: rest at tick `k` + `samples`,
    /// 3 to 2147483648 samples. Estimates and inputs under way are kept.
    /// Ok, or Param with nothing changed.
    [[nodiscard]] constexpr Status arm_for(std::uint32_t k, std::uint32_t samples) noexcept
    {
        if (!((samples > 2U) && (samples < 2147483649U))) {
            return Status::Param;
        }
        start_ = k;
        last_ = samples;
        return Status::Ok;
    }

    /// The fewest samples found, from the next call of `step` on, with which the law keeps u and
    /// the states within their limits at every sample to rest, from the state x, for sure. Give
    /// them to `arm_for`.
    /// On a negative status u is 0 and nothing has changed.
    constexpr Value<std::uint32_t> soonest(const std::array<double, 2>& x) const noexcept
    {
        if (!(finite(x[0]) && finite(x[1]))) {
            return {0, Status::Input};
        }
        const double x1 = x[0];
        const double x2 = x[1];
        const double flat1 = (s1_1_ * x1) + (s1_2_ * x2);
        const double flat2 = s2_2_ * x2;
        const double flat3 = u1_;
        std::uint32_t low = 3U;
        std::uint32_t top = 1073741825U;
        std::uint32_t kept = 0U;
        std::uint32_t tried = 4U;
        for (std::uint32_t attempt = 0U; attempt < 64U; attempt++) {
            const double least = -0.9999999999937695;
            const double most = 0.9999999999937695 * u_max_;
            std::uint32_t fits = 0U;
            const double m = static_cast<double>(tried);
            const double power1 = m + 3.0;
            const double power2 = power1 * (m + 2.0);
            const double power3 = power2 * (m + 1.0);
            const double power4 = power3 * m;
            const double power5 = power4 * (m - 1.0);
            const double power6 = power5 * (m - 2.0);
            const double scaled2 = flat2 * power1;
            const double scaled3 = flat3 * power2;
            const double w1 = ((15.0 * flat1) + (5.0 * scaled2) + (0.5 * scaled3)) / power4;
            const double w2 = ((((-24.0) * flat1) - (9.0 * scaled2)) - scaled3) / power5;
            const double w3 = ((10.0 * flat1) + (4.0 * scaled2) + (0.5 * scaled3)) / power6;
            const double length = m - 4.0;
            const double b0_c = (144.0 * w1) + (480.0 * w2) + (720.0 * w3);
            const double b1_c = ((84.0 * w1) + (520.0 * w2) + (1500.0 * w3)) * length;
            const double b2_l = length * length;
            const double b2_c = ((12.0 * w1) + (180.0 * w2) + (1050.0 * w3)) * b2_l;
            const double b3_l = b2_l * length;
            const double b3_c = ((20.0 * w2) + (300.0 * w3)) * b3_l;
            const double b4_l = b3_l * length;
            const double b4_c = 30.0 * w3 * b4_l;
            const double b1 = b0_c + (0.125 * b1_c);
            const double b2 = b0_c + (0.25 * b1_c) + (0.03571428571428571 * b2_c);
            const double s1 = b0_c + (0.375 * b1_c) + (0.10714285714285714 * b2_c);
            const double b3 = s1 + (0.017857142857142856 * b3_c);
            const double s2 = b0_c + (0.5 * b1_c) + (0.21428571428571427 * b2_c);
            const double s3 = s2 + (0.07142857142857142 * b3_c);
            const double b4 = s3 + (0.014285714285714285 * b4_c);
            const double s4 = b0_c + (0.625 * b1_c) + (0.35714285714285715 * b2_c);
            const double s5 = s4 + (0.17857142857142858 * b3_c);
            const double b5 = s5 + (0.07142857142857142 * b4_c);
            const double s6 = b0_c + (0.75 * b1_c) + (0.5357142857142857 * b2_c);
            const double s7 = s6 + (0.35714285714285715 * b3_c);
            const double b6 = s7 + (0.21428571428571427 * b4_c);
            const double s8 = b0_c + (0.875 * b1_c) + (0.75 * b2_c) + (0.625 * b3_c);
            const double b7 = s8 + (0.5 * b4_c);
            const double b8 = b0_c + b1_c + b2_c + b3_c + b4_c;
            const double end29 = (72.0 * w1) + (120.0 * w2);
            const double end30 = 24.0 * w1;
            if ((least <= b0_c)
                && (b0_c <= most)
                && (least <= b1)
                && (b1 <= most)
                && (least <= b2)
                && (b2 <= most)
                && (least <= b3)
                && (b3 <= most)
                && (least <= b4)
                && (b4 <= most)
                && (least <= b5)
                && (b5 <= most)
                && (least <= b6)
                && (b6 <= most)
                && (least <= b7)
                && (b7 <= most)
                && (least <= b8)
                && (b8 <= most)
                && (least <= end29)
                && (end29 <= most)
                && (least <= end30)
                && (end30 <= most)) {
                fits = 1U;
            }
            if (fits == 1U) {
                kept = tried;
                top = tried;
            } else {
                low = tried;
            }
            const std::uint32_t gap = (low < top) ? (top - low) : 0U;
            if (gap < 2U) {
                break;
            }
            const std::uint32_t half = gap / 2U;
            if (low < half) {
                tried = low + low;
            } else {
                tried = low + half;
            }
        }
        if (finite(flat1) && finite(flat2) && finite(flat3)) {
            if (kept > 0U) {
                return {kept, Status::Ok};
            } else {
                return {0, Status::Soon};
            }
        } else {
            return {0, Status::Range};
        }
    }

    /// The tick at which the loop is to be at rest.
    [[nodiscard]] constexpr std::uint32_t deadline() const noexcept
    {
        return start_ - (0U - last_);
    }

    /// The drive applied `u` in place of the u that the last call of `step` gave.
    /// Ok, or Param with nothing changed.
    [[nodiscard]] constexpr Status applied(double u) noexcept
    {
        if (!finite(u)) {
            return Status::Input;
        }
        u1_ = u;
        return Status::Ok;
    }

private:
    /// std::isfinite is not constexpr in C++17.
    static constexpr bool finite(double v) noexcept
    {
        return (v >= std::numeric_limits<double>::lowest()) && (v <= (std::numeric_limits<double>::max)());
    }
    /// Weight of x1 in the law.
    static constexpr double s1_1_{10000.0};
    /// Weight of x2 in the law.
    static constexpr double s1_2_{-50.0};
    /// Weight of x2 in the law.
    static constexpr double s2_2_{100.0};
    /// Weight of x1 in the law.
    static constexpr double w1_1_{-1200000.0};
    /// Weight of x2 in the law.
    static constexpr double w1_2_{6000.0};
    /// Weight of x2 in the law.
    static constexpr double w2_2_{-6000.0};
    /// Weight of u1 in the law.
    static constexpr double w3_3_{-12.0};

    std::uint32_t start_{}; // tick at which it was armed
    std::uint32_t last_{}; // samples from the start to rest, as planned now
    double u1_{}; // input of the last sample
    double u_max_{}; // upper limit of u
};

} // namespace ptc

#endif
