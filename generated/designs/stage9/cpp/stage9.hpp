/*
 * Prescribed-time controller stage9: order n = 3, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang cpp --n 3 --mu "exp(a=1)" --name stage9 --clock samples --measured=x1 --observer-poles=-4,-5,-6 --observer-eps=0.05 --eps=0.02 --u-max=1e3 --delay=1
 * Version 0.1.0, design a9f2dd91a5f7.
 *
 * Plant: x1' = x2, ..., x3' = u; u held from sample to sample, one sample late.
 * Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
 *       sample period, as long as u is not clipped and nothing else acts on the plant.
 * Law: with M samples to go and z = S x, u h^4 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-3));
 *       the rows are those of Theorem 1 for the mapping exp. Close to the end deadbeat takes
 *       over.
 *
 * Parameters:
 *   samples [samples]: samples N from the start to rest
 *   h [s]: sample period
 *   eps = 0.02 [s], fixed: time-to-go at which the gains are held
 *   u_max = 1e3 [unit of u], fixed: bound of |u|
 *   a = 1 [1/s], fixed: rate of stretched time
 *   k_1 [1/s^4]: gains k_i of pi0 = -sum k_i xi_i
 *   k_2 [1/s^3]: gains k_i of pi0 = -sum k_i xi_i
 *   k_3 [1/s^2]: gains k_i of pi0 = -sum k_i xi_i
 *   k_4 [1/s]: gains k_i of pi0 = -sum k_i xi_i
 *   deadbeat [samples]: samples to go at which deadbeat takes over, 0 for a safe default
 *
 * k counts samples and may wrap; arm again within 2^32 - N samples.
 * From sample N on the last gains are held (status HOLD).
 * The estimates are exact from sample N/2 after the start on where the measurement is; with
 *       noise or sensor_step given, or observer_eps, the gains of the observer are then held
 *       below deadbeat.
 * |u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
 *       lasts.
 * Guard full: what is measured is finite, or the call is refused (INPUT).
 * Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
 *       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
 *
 * Checks of the design (details: ptc-codegen check):
 *   membership: sound: exp is of class M for all its parameters.
 *   growth: sound: at rest at sample N from any state, but for what the held observer leaves
 *       of its error, whatever the poles, and |u| is bounded.
 *   sampling: not checked: the law is exact in samples, at any period.
 *   deadline: not checked: the law is exact in samples, at any period.
 *   loop: not checked: `samples` is left to run time.
 *   envelope: not checked: it does not examine a clock in samples.
 */
#ifndef STAGE9_38AAF62E_HPP
#define STAGE9_38AAF62E_HPP

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

/// Run-time parameters.
struct Stage9Params {
    std::uint32_t samples{}; ///< samples N from the start to rest [samples], at least 8
    double h{}; ///< sample period [s], from 1e-150 to 1e150
    std::array<double, 4> k{}; ///< gains k_i of pi0 = -sum k_i xi_i [1/s^4], finite
    double deadbeat{}; ///< samples to go at which deadbeat takes over, 0 for a safe default [samples], finite
};

/// Controller: set by init, changed by arm and by what is not const.
class Stage9 {
public:
    using Params = Stage9Params;

    /// Takes the parameters and arms at tick 0. Ok, or Param with nothing changed.
    [[nodiscard]] constexpr Status init(const Params& params) noexcept
    {
        if (!((params.samples > 7U)
                && (1e-150 <= params.h)
                && (params.h <= 1e150)
                && finite(params.k[0])
                && finite(params.k[1])
                && finite(params.k[2])
                && finite(params.k[3])
                && finite(params.deadbeat)
                && (params.deadbeat >= 0.0))) {
            return Status::Param;
        }
        const std::uint32_t samples = params.samples;
        const double phi1_2 = params.h;
        const double phi1_3 = 0.5 * (params.h * params.h);
        const double gamma1 = 0.16666666666666666 * (params.h * params.h * params.h);
        const double hold_o = 0.05 / params.h;
        const double q2_1 = (-108.0) * (1.0 / params.h);
        const double q2_2 = 36.0 * (1.0 / params.h);
        const double q3_1 = 24.0 * (1.0 / (params.h * params.h));
        const double hold = 0.02 / params.h;
        const double w1_1 = (-params.k[0]) * (1.0 / (params.h * params.h * params.h));
        const double w1_2 = params.k[0] * (1.0 / (params.h * params.h));
        const double w1_3 = 0.3333333333333333 * (-params.k[0]) * (1.0 / params.h);
        const double s1 = ((1.0 - params.k[1]) + params.k[2]) - params.k[3];
        const double w2_2 = s1 * (1.0 / (params.h * params.h));
        const double s2 = (-0.5) * (((1.0 - params.k[1]) + params.k[2]) - params.k[3]);
        const double w2_3 = s2 * (1.0 / params.h);
        const double w3_3 = (((-7.0) - params.k[2]) + (3.0 * params.k[3])) * (1.0 / params.h);
        const double w4_4 = 6.0 - params.k[3];
        const double b_1 = -(1.0 / (params.h * params.h * params.h));
        const double b_2 = (-3.0) * (1.0 / (params.h * params.h));
        const double b_3 = (-4.333333333333333) * (1.0 / params.h);
        if (!(finite(phi1_3)
                && finite(gamma1)
                && finite(hold_o)
                && finite(q2_1)
                && finite(q2_2)
                && finite(q3_1)
                && finite(hold)
                && finite(w1_1)
                && finite(w1_2)
                && finite(w1_3)
                && finite(w2_2)
                && finite(w2_3)
                && finite(w3_3)
                && finite(w4_4)
                && finite(b_1)
                && finite(b_2)
                && finite(b_3)
                && (params.h * params.h * params.h >= 1e-200)
                && (1.0 / (params.h * params.h * params.h) >= 1e-200)
                && (hold_o >= 3.0))) {
            return Status::Param;
        }
        start_ = 0U;
        samples_ = samples;
        u1_ = 0.0;
        u2_ = 0.0;
        seen_ = 0U;
        x1_hat_ = 0.0;
        x2_hat_ = 0.0;
        x3_hat_ = 0.0;
        phi1_2_ = phi1_2;
        phi1_3_ = phi1_3;
        gamma1_ = gamma1;
        hold_o_ = hold_o;
        q2_1_ = q2_1;
        q2_2_ = q2_2;
        q3_1_ = q3_1;
        hold_ = hold;
        w1_1_ = w1_1;
        w1_2_ = w1_2;
        w1_3_ = w1_3;
        w2_2_ = w2_2;
        w2_3_ = w2_3;
        w3_3_ = w3_3;
        w4_4_ = w4_4;
        b_1_ = b_1;
        b_2_ = b_2;
        b_3_ = b_3;
        return Status::Ok;
    }

    /// Starts again: the deadline is N samples after tick `k`. Estimates and inputs under way are
    /// kept. Estimates too large to compute with begin anew.
    constexpr void arm(std::uint32_t k) noexcept
    {
        start_ = k;
        const double size = absolute(x1_hat_) + absolute(x2_hat_) + absolute(x3_hat_);
        if (!(size <= 1e150)) {
            seen_ = 0U;
            x1_hat_ = 0.0;
            x2_hat_ = 0.0;
            x3_hat_ = 0.0;
        }
    }

    /// u from tick `k`, which may wrap, and what is measured, y = (x1, ...). Call it once for each
    /// tick.
    /// On a negative status u is 0 and nothing has changed.
    constexpr Control<double> step(std::uint32_t k, const std::array<double, 1>& y) noexcept
    {
        if (!finite(y[0])) {
            return {0.0, Status::Input};
        }
        const std::uint32_t elapsed = k - start_;

        // Predict.
        const double s1 = x1_hat_ + (phi1_2_ * x2_hat_);
        const double p1 = s1 + (phi1_3_ * x3_hat_) + (gamma1_ * u2_);
        const double s2 = x2_hat_ + (phi1_2_ * x3_hat_);
        const double p2 = s2 + (phi1_3_ * u2_);
        const double p3 = x3_hat_ + (phi1_2_ * u2_);

        // Correct by what is measured.
        double base{};
        double miss{};
        if (seen_ == 0U) {
            base = y[0];
            miss = 0.0;
        } else {
            base = p1;
            miss = y[0] - p1;
        }
        const std::uint32_t left_o = (elapsed < (samples_ / 2U)) ? ((samples_ / 2U) - elapsed) : 0U;
        const double o0 = (static_cast<double>(left_o) < hold_o_) ? hold_o_ : static_cast<double>(left_o);
        double l1{};
        double l2{};
        double l3{};
        const double o0f2 = o0 * (o0 - 1.0);
        const double r0 = 1.0 / (o0f2 * (o0 - 2.0));
        l1 = (q1_1_ + (q1_2_ * o0) + (q1_3_ * o0f2)) * r0;
        l2 = (q2_1_ + (q2_2_ * o0)) * r0;
        l3 = q3_1_ * r0;
        const double x1 = base + (l1 * miss);
        const double x2 = p2 + (l2 * miss);
        const double x3 = p3 + (l3 * miss);
        const std::uint32_t left = (elapsed < samples_) ? (samples_ - elapsed) : 0U;
        const double m0 = (static_cast<double>(left) < hold_) ? hold_ : static_cast<double>(left);
        double v{};
        if (m0 > deadbeat_) {
            // The exact law in samples.
            const double z1 = (w1_1_ * x1) + (w1_2_ * x2) + (w1_3_ * x3);
            const double z2 = (w2_2_ * x2) + (w2_3_ * x3);
            const double z3 = w3_3_ * x3;
            const double z4 = w4_4_ * u1_;
            const double m0f2 = m0 * (m0 - 1.0);
            const double m0f3 = m0f2 * (m0 - 2.0);
            const double s3 = (z1 + (z2 * m0) + (z3 * m0f2) + (z4 * m0f3)) / (m0f3 * (m0 - 3.0));
            v = s3 + u1_;
        } else {
            // Deadbeat.
            const double s4 = (b_1_ * x1) + (b_2_ * x2) + (b_3_ * x3);
            v = s4 + (b_4_ * u1_);
        }
        if (!finite(v)) {
            return {0.0, Status::Range};
        }
        double u_now{};
        if (v > u_max_) {
            u_now = u_max_;
        } else if (v < -u_max_) {
            u_now = -u_max_;
        } else {
            u_now = v;
        }
        u2_ = u1_;
        u1_ = u_now;
        x1_hat_ = x1;
        x2_hat_ = x2;
        x3_hat_ = x3;
        seen_ = 1U;
        if ((v > u_max_) || (v < -u_max_)) {
            return {u_now, Status::Saturated};
        } else if (static_cast<double>(left) <= hold_) {
            return {u_now, Status::Hold};
        } else {
            return {u_now, Status::Ok};
        }
    }

    /// The estimate of the state at the last sample.
    [[nodiscard]] constexpr std::array<double, 3> estimate() const noexcept
    {
        return {{x1_hat_, x2_hat_, x3_hat_}};
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
    /// Weight in the observer's gain l1.
    static constexpr double q1_1_{120.0};
    /// Weight in the observer's gain l1.
    static constexpr double q1_2_{-60.0};
    /// Weight in the observer's gain l1.
    static constexpr double q1_3_{12.0};
    /// 7/2, samples to go at which deadbeat takes over.
    static constexpr double deadbeat_{3.5};
    /// Weight of u1 in the law.
    static constexpr double b_4_{-3.0};
    /// Bound of |u|.
    static constexpr double u_max_{1000.0};

    std::uint32_t start_{}; // tick at which it was armed
    std::uint32_t samples_{}; // samples from the start to rest
    double u1_{}; // input of the last sample
    double u2_{}; // input of 2 samples ago
    std::uint32_t seen_{}; // 1 once y has been measured
    double x1_hat_{}; // estimate of x1
    double x2_hat_{}; // estimate of x2
    double x3_hat_{}; // estimate of x3
    double phi1_2_{}; // prediction of x1 from x2
    double phi1_3_{}; // prediction of x1 from x3
    double gamma1_{}; // prediction from u
    double hold_o_{}; // samples to go at which the observer is held
    double q2_1_{}; // weight in the observer's gain l2
    double q2_2_{}; // weight in the observer's gain l2
    double q3_1_{}; // weight in the observer's gain l3
    double hold_{}; // samples to go at which the gains are held
    double w1_1_{}; // weight of x1 in the law
    double w1_2_{}; // weight of x2 in the law
    double w1_3_{}; // weight of x3 in the law
    double w2_2_{}; // weight of x2 in the law
    double w2_3_{}; // weight of x3 in the law
    double w3_3_{}; // weight of x3 in the law
    double w4_4_{}; // weight of u1 in the law
    double b_1_{}; // weight of x1 in the law
    double b_2_{}; // weight of x2 in the law
    double b_3_{}; // weight of x3 in the law
};

} // namespace ptc

#endif
