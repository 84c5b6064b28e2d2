/*
 * Prescribed-time controller stage20: order n = 2, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang cpp --n 2 --mu "exp(a=1)" --name stage20 --clock samples --measured=x1 --disturbance constant --observer-poles=-4,-5,-6 --eps=0 --f="1/4" --g="1/2" --reference input --delay=1.25
 * Version 0.1.0, design c90aea54cafb.
 *
 * Plant: x1' = x2, x2' = f + g (u + d), d constant and unknown; u held from sample to sample,
 *       1.25 samples late.
 * Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
 *       sample period, as long as u is not clipped and nothing else acts on the plant.
 * Law: with M samples to go and z = S x, u h^4 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-3));
 *       the rows are those of Theorem 1 for the mapping exp. Close to the end deadbeat takes
 *       over.
 * With the reference r, e_i = x_i - r^(i-1) is in place of x_i above, and u = w + rho/g,
 *       where the inputs under way count less the rho of their own samples. At sample N e is
 *       0 where r^(n) is constant over each sample; else an error of order h^(4-i) is left in
 *       e_i.
 * e_i = x_i - r[i-1] with r[0]..r[1] the reference and its derivatives at tick k, and rho =
 *       r[2], r^(n) over the sample in which u acts: its mean, (r^(n-1)(t + h) -
 *       r^(n-1)(t))/h, or that in its middle.
 *
 * Parameters:
 *   samples [samples]: samples N from the start to rest
 *   h [s]: sample period
 *   eps = 0 [s], fixed: time-to-go at which the gains are held
 *   u_max [unit of u]: bound of |u|
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
 * Guard full: what is measured and the reference are finite, or the call is refused (INPUT).
 * Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
 *       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
 *
 * Checks of the design (details: ptc-codegen check):
 *   membership: sound: exp is of class M for all its parameters.
 *   growth: sound: at rest at sample N from any state, but for what r does between samples,
 *       whatever the poles, and |u| is bounded.
 *   sampling: not checked: `loop` bounds what the period leaves of a reference that moves.
 *   deadline: not checked: `loop` bounds what the period leaves of a reference that moves.
 *   loop: not checked: `samples` is left to run time.
 *   envelope: not checked: it does not examine a clock in samples.
 */
#ifndef STAGE20_92483E21_HPP
#define STAGE20_92483E21_HPP

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
struct Stage20Params {
    std::uint32_t samples{}; ///< samples N from the start to rest [samples], at least 8
    double h{}; ///< sample period [s], from 1e-150 to 1e150
    double u_max{}; ///< bound of |u| [unit of u], > 0, infinity allowed
    std::array<double, 4> k{}; ///< gains k_i of pi0 = -sum k_i xi_i [1/s^4], finite
    double deadbeat{}; ///< samples to go at which deadbeat takes over, 0 for a safe default [samples], finite
};

/// Controller: set by init, changed by arm and by what is not const.
class Stage20 {
public:
    using Params = Stage20Params;

    /// Takes the parameters and arms at tick 0. Ok, or Param with nothing changed.
    [[nodiscard]] constexpr Status init(const Params& params) noexcept
    {
        if (!((params.samples > 7U)
                && (1e-150 <= params.h)
                && (params.h <= 1e150)
                && (params.u_max > 0.0)
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
        const double phi1_3 = 0.25 * (params.h * params.h);
        const double gamma1 = 0.109375 * (params.h * params.h);
        const double late_gamma1 = 0.140625 * (params.h * params.h);
        const double phi2_3 = 0.5 * params.h;
        const double gamma2 = 0.125 * params.h;
        const double late_gamma2 = 0.375 * params.h;
        const double q2_1 = (-108.0) * (1.0 / params.h);
        const double q2_2 = 36.0 * (1.0 / params.h);
        const double q3_1 = 48.0 * (1.0 / (params.h * params.h));
        const double e2_2 = 1.5 * (1.0 / params.h);
        const double e2_3 = 2.0 * (1.0 / (params.h * params.h));
        const double e1_2 = 0.8571428571428571 * (1.0 / params.h);
        const double e1_3 = (-0.5714285714285714) * (1.0 / (params.h * params.h));
        const double e0_2 = 0.42857142857142855 * (1.0 / params.h);
        const double e0_3 = 0.2857142857142857 * (1.0 / (params.h * params.h));
        const double s1 = (params.k[3] - 9.0) + 4.0;
        const double s2 = (s1 < 8.0) ? 8.0 : s1;
        const double deadbeat = (params.deadbeat > 0.0) ? params.deadbeat : s2;
        const double w1_1 = 2.0 * (-params.k[0]) * (1.0 / (params.h * params.h));
        const double w1_2 = (-2.5) * (-params.k[0]) * (1.0 / params.h);
        const double w1_4 = 0.65625 * (-params.k[0]);
        const double s3 = 2.0 * (((1.0 - params.k[1]) + params.k[2]) - params.k[3]);
        const double w2_2 = s3 * (1.0 / params.h);
        const double w2_4 = (-0.75) * (((1.0 - params.k[1]) + params.k[2]) - params.k[3]);
        const double w3_4 = ((-7.0) - params.k[2]) + (3.0 * params.k[3]);
        const double w4_3 = 6.0 - params.k[3];
        const double w4_4 = -(6.0 - params.k[3]);
        const double b_1 = (-2.0) * (1.0 / (params.h * params.h));
        const double b_2 = (-5.5) * (1.0 / params.h);
        const double u_max = params.u_max;
        if (!(finite(phi1_3)
                && finite(gamma1)
                && finite(late_gamma1)
                && finite(phi2_3)
                && finite(gamma2)
                && finite(late_gamma2)
                && finite(q2_1)
                && finite(q2_2)
                && finite(q3_1)
                && finite(e2_2)
                && finite(e2_3)
                && finite(e1_2)
                && finite(e1_3)
                && finite(e0_2)
                && finite(e0_3)
                && finite(deadbeat)
                && finite(w1_1)
                && finite(w1_2)
                && finite(w1_4)
                && finite(w2_2)
                && finite(w2_4)
                && finite(w3_4)
                && finite(w4_3)
                && finite(w4_4)
                && finite(b_1)
                && finite(b_2)
                && (params.h * params.h >= 1e-200)
                && (1.0 / (params.h * params.h) >= 1e-200))) {
            return Status::Param;
        }
        start_ = 0U;
        samples_ = samples;
        u1_ = 0.0;
        u2_ = 0.0;
        u3_ = 0.0;
        seen_ = 0U;
        x1_hat_ = 0.0;
        x2_hat_ = 0.0;
        d_hat_ = 0.0;
        phi1_2_ = phi1_2;
        phi1_3_ = phi1_3;
        gamma1_ = gamma1;
        late_gamma1_ = late_gamma1;
        phi2_3_ = phi2_3;
        gamma2_ = gamma2;
        late_gamma2_ = late_gamma2;
        q2_1_ = q2_1;
        q2_2_ = q2_2;
        q3_1_ = q3_1;
        e2_2_ = e2_2;
        e2_3_ = e2_3;
        e1_2_ = e1_2;
        e1_3_ = e1_3;
        e0_2_ = e0_2;
        e0_3_ = e0_3;
        rho1_ = 0.0;
        rho2_ = 0.0;
        deadbeat_ = deadbeat;
        w1_1_ = w1_1;
        w1_2_ = w1_2;
        w1_4_ = w1_4;
        w2_2_ = w2_2;
        w2_4_ = w2_4;
        w3_4_ = w3_4;
        w4_3_ = w4_3;
        w4_4_ = w4_4;
        b_1_ = b_1;
        b_2_ = b_2;
        u_max_ = u_max;
        return Status::Ok;
    }

    /// Starts again: the deadline is N samples after tick `k`. Estimates and inputs under way are
    /// kept. Estimates too large to compute with begin anew.
    constexpr void arm(std::uint32_t k) noexcept
    {
        start_ = k;
        const double size = absolute(x1_hat_) + absolute(x2_hat_) + absolute(d_hat_);
        if (!(size <= 1e150)) {
            seen_ = 0U;
            x1_hat_ = 0.0;
            x2_hat_ = 0.0;
            d_hat_ = 0.0;
        }
    }

    /// u from tick `k`, which may wrap, and what is measured, y = (x1, ...), and the reference.
    /// Call it once for each tick.
    /// On a negative status u is 0 and nothing has changed.
    constexpr Control<double> step(std::uint32_t k, const std::array<double, 1>& y, const std::array<double, 3>& r) noexcept
    {
        if (!(finite(y[0]) && finite(r[0]) && finite(r[1]) && finite(r[2]))) {
            return {0.0, Status::Input};
        }
        const std::uint32_t elapsed = k - start_;

        // Predict.
        const double s1 = x1_hat_ + (phi1_2_ * x2_hat_);
        const double s2 = late_gamma1_ * (u2_ + 0.5);
        const double s3 = (gamma1_ * (u3_ + 0.5)) + s2;
        const double p1 = s1 + (phi1_3_ * d_hat_) + s3;
        const double s4 = late_gamma2_ * (u2_ + 0.5);
        const double s5 = x2_hat_ + (phi2_3_ * d_hat_);
        const double p2 = s5 + ((gamma2_ * (u3_ + 0.5)) + s4);
        const double p3 = d_hat_;

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
        const double o0 = static_cast<double>(left_o);
        double l1{};
        double l2{};
        double l3{};
        if (o0 > 8.0) {
            const double o0f2 = o0 * (o0 - 1.0);
            const double r0 = 1.0 / (o0f2 * (o0 - 2.0));
            l1 = (q1_1_ + (q1_2_ * o0) + (q1_3_ * o0f2)) * r0;
            l2 = (q2_1_ + (q2_2_ * o0)) * r0;
            l3 = q3_1_ * r0;
        } else if (left_o == 8U) {
            l1 = 1.0;
            l2 = e0_2_;
            l3 = e0_3_;
        } else if (left_o == 7U) {
            l1 = 1.0;
            l2 = e1_2_;
            l3 = e1_3_;
        } else {
            l1 = 1.0;
            l2 = e2_2_;
            l3 = e2_3_;
        }
        const double x1 = base + (l1 * miss);
        const double x2 = p2 + (l2 * miss);
        const double d = p3 + (l3 * miss);

        // The tracking error.
        const double e1 = x1 - r[0];
        const double e2 = x2 - r[1];
        const std::uint32_t left = (elapsed < samples_) ? (samples_ - elapsed) : 0U;
        const double m0 = static_cast<double>(left);
        double v{};
        if (m0 > deadbeat_) {
            // The exact law in samples.
            const double s6 = w1_4_ * ((u2_ + (d + 0.5)) - (2.0 * rho2_));
            const double z1 = (w1_1_ * e1) + (w1_2_ * e2) + s6;
            const double s7 = w2_4_ * ((u2_ + (d + 0.5)) - (2.0 * rho2_));
            const double z2 = (w2_2_ * e2) + s7;
            const double z3 = w3_4_ * ((u2_ + (d + 0.5)) - (2.0 * rho2_));
            const double s8 = w4_3_ * ((u1_ + (d + 0.5)) - (2.0 * rho1_));
            const double z4 = s8 + (w4_4_ * ((u2_ + (d + 0.5)) - (2.0 * rho2_)));
            const double m0f2 = m0 * (m0 - 1.0);
            const double m0f3 = m0f2 * (m0 - 2.0);
            const double s9 = c_3_ * ((u1_ + (d + 0.5)) - (2.0 * rho1_));
            const double s10 = (z1 + (z2 * m0) + (z3 * m0f2) + (z4 * m0f3)) / (m0f3 * (m0 - 3.0));
            const double s11 = (s10 + (s9 - ((u2_ + (d + 0.5)) - (2.0 * rho2_)))) - (d + 0.5);
            v = s11 + (2.0 * r[2]);
        } else {
            // Deadbeat.
            const double s12 = b_3_ * ((u1_ + (d + 0.5)) - (2.0 * rho1_));
            const double s13 = b_4_ * ((u2_ + (d + 0.5)) - (2.0 * rho2_));
            const double s14 = ((b_1_ * e1) + (b_2_ * e2) + s12 + s13) - (d + 0.5);
            v = s14 + (2.0 * r[2]);
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
        u3_ = u2_;
        u2_ = u1_;
        u1_ = u_now;
        rho2_ = rho1_;
        rho1_ = r[2];
        x1_hat_ = x1;
        x2_hat_ = x2;
        d_hat_ = d;
        seen_ = 1U;
        if ((v > u_max_) || (v < -u_max_)) {
            return {u_now, Status::Saturated};
        } else if (elapsed < samples_) {
            return {u_now, Status::Ok};
        } else {
            return {u_now, Status::Hold};
        }
    }

    /// The estimate of the state at the last sample.
    [[nodiscard]] constexpr std::array<double, 2> estimate() const noexcept
    {
        return {{x1_hat_, x2_hat_}};
    }

    /// The estimate of the constant that is added to u.
    [[nodiscard]] constexpr double disturbance() const noexcept
    {
        return d_hat_;
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
    /// Weight of u1 in the law.
    static constexpr double c_3_{2.0};
    /// Weight of u1 in the law.
    static constexpr double b_3_{-2.0};
    /// -21/32, weight of u2 in the law.
    static constexpr double b_4_{-0.65625};

    std::uint32_t start_{}; // tick at which it was armed
    std::uint32_t samples_{}; // samples from the start to rest
    double u1_{}; // input of the last sample
    double u2_{}; // input of 2 samples ago
    double u3_{}; // input of 3 samples ago
    std::uint32_t seen_{}; // 1 once y has been measured
    double x1_hat_{}; // estimate of x1
    double x2_hat_{}; // estimate of x2
    double d_hat_{}; // estimate of d
    double phi1_2_{}; // prediction of x1 from x2
    double phi1_3_{}; // prediction of x1 from d
    double gamma1_{}; // prediction from u
    double late_gamma1_{}; // prediction from u
    double phi2_3_{}; // prediction of x2 from d
    double gamma2_{}; // prediction from u
    double late_gamma2_{}; // prediction from u
    double q2_1_{}; // weight in the observer's gain l2
    double q2_2_{}; // weight in the observer's gain l2
    double q3_1_{}; // weight in the observer's gain l3
    double e2_2_{}; // gain of the observer at its end
    double e2_3_{}; // gain of the observer at its end
    double e1_2_{}; // gain of the observer at its end
    double e1_3_{}; // gain of the observer at its end
    double e0_2_{}; // gain of the observer at its end
    double e0_3_{}; // gain of the observer at its end
    double rho1_{}; // last one of r, 1 samples ago
    double rho2_{}; // last one of r, 2 samples ago
    double deadbeat_{}; // samples to go at which deadbeat takes over
    double w1_1_{}; // weight of x1 in the law
    double w1_2_{}; // weight of x2 in the law
    double w1_4_{}; // weight of u2 in the law
    double w2_2_{}; // weight of x2 in the law
    double w2_4_{}; // weight of u2 in the law
    double w3_4_{}; // weight of u2 in the law
    double w4_3_{}; // weight of u1 in the law
    double w4_4_{}; // weight of u2 in the law
    double b_1_{}; // weight of x1 in the law
    double b_2_{}; // weight of x2 in the law
    double u_max_{}; // bound of |u|
};

} // namespace ptc

#endif
