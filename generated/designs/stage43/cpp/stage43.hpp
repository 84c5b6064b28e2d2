/*
 * Prescribed-time controller stage43: order n = 3, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang cpp --n 3 --mu "exp(a=1)" --name stage43 --clock samples --delay-law=predict --measured=x1 --disturbance constant --observer-poles=-4,-5,-6,-7 --observer-samples=20 --tau=0.4 --eps=0 --u-max=6 --poles="least-energy(weight=1)" --reference="t^2/2" --sample-time=1e-2 --delay=2.75
 * Version 0.1.0, design c760bae9e1f5.
 *
 * Plant: x1' = x2, ..., x3' = (u + d), d constant and unknown; u held from sample to sample,
 *       2.75 samples late.
 * Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
 *       sample period, as long as u is not clipped and nothing else acts on the plant.
 * Law of the state x predicted for the time from which u acts, by x and the inputs under way:
 *       with M samples to go and z = S x, u h^3 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-2));
 *       the rows are those of Theorem 1 for the mapping exp. The gains of 6 samples to go
 *       stay: they are deadbeat.
 * With the reference r, e_i = x_i - r^(i-1) is in place of x_i above, and u = w + rho/g,
 *       where the inputs under way count less the rho of their own samples. At sample N e is
 *       0 where r^(n) is constant over each sample; else an error of order h^(5-i) is left in
 *       e_i.
 * t counts from the tick at which it was armed, and rho is r^(n) in the middle of the time in
 *       which u acts:
 *   e_i = x_i - r^(i-1), with the reference r = t^2/2
 *   r^(1) = t
 *   r^(2) = 1
 *
 * Parameters:
 *   samples = 40 [samples], fixed: samples N from the start to rest
 *   h = 1e-2 [s], fixed: sample period
 *   eps = 0 [s], fixed: time-to-go at which the gains are held
 *   u_max = 6 [unit of u], fixed: bound of |u|
 *   a = 1 [1/s], fixed: rate of stretched time
 *   k_1 = 120 [1/s^3], fixed: gains k_i of pi0 = -sum k_i xi_i
 *   k_2 = 74 [1/s^2], fixed: gains k_i of pi0 = -sum k_i xi_i
 *   k_3 = 15 [1/s], fixed: gains k_i of pi0 = -sum k_i xi_i
 *
 * k counts samples and may wrap; arm again within 2^32 - N samples.
 * From sample N on the last gains are held (status HOLD).
 * The estimates are exact from sample 20 after the start on where the measurement is; with
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
 *   growth: sound: at rest at sample 40 from any state, but for what r does between samples,
 *       whatever the poles, and |u| is bounded.
 *   sampling: not checked: `loop` bounds what the period leaves of a reference that moves.
 *   deadline: not checked: `loop` bounds what the period leaves of a reference that moves.
 *   loop: not checked: `x0_max` is not given.
 *   envelope: not checked: it does not examine a clock in samples.
 */
#ifndef STAGE43_1F078439_HPP
#define STAGE43_1F078439_HPP

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
struct Stage43Params {
};

/// Controller: set by init, changed by arm and by what is not const.
class Stage43 {
public:
    using Params = Stage43Params;

    /// Takes the parameters and arms at tick 0. Ok, or Param with nothing changed.
    [[nodiscard]] constexpr Status init(const Params&) noexcept
    {
        start_ = 0U;
        u1_ = 0.0;
        u2_ = 0.0;
        u3_ = 0.0;
        u4_ = 0.0;
        seen_ = 0U;
        x1_hat_ = 0.0;
        x2_hat_ = 0.0;
        x3_hat_ = 0.0;
        d_hat_ = 0.0;
        return Status::Ok;
    }

    /// Starts again: the deadline is N samples after tick `k`. The time of the reference counts
    /// from there. Estimates and inputs under way are kept. Estimates too large to compute with
    /// begin anew.
    constexpr void arm(std::uint32_t k) noexcept
    {
        start_ = k;
        const double s1 = absolute(x1_hat_) + absolute(x2_hat_) + absolute(x3_hat_);
        const double size = s1 + absolute(d_hat_);
        if (!(size <= 1e150)) {
            seen_ = 0U;
            x1_hat_ = 0.0;
            x2_hat_ = 0.0;
            x3_hat_ = 0.0;
            d_hat_ = 0.0;
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
        const double s1 = x1_hat_ + (0.01 * x2_hat_) + (5e-5 * x3_hat_);
        const double s2 = (1.640625e-7 * u4_) + (2.604166666666667e-9 * u3_);
        const double p1 = s1 + (1.6666666666666668e-7 * d_hat_) + s2;
        const double s3 = x2_hat_ + (0.01 * x3_hat_) + (5e-5 * d_hat_);
        const double p2 = s3 + ((4.6875e-5 * u4_) + (3.125e-6 * u3_));
        const double s4 = (0.0075 * u4_) + (0.0025 * u3_);
        const double p3 = x3_hat_ + (0.01 * d_hat_) + s4;
        const double p4 = d_hat_;

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
        const std::uint32_t left_o = (elapsed < 20U) ? (20U - elapsed) : 0U;
        const double o0 = static_cast<double>(left_o);
        double l1{};
        double l2{};
        double l3{};
        double l4{};
        if (10.0 < o0) {
            const double r0 = 1.0 / o0;
            const double r1 = 1.0 / (o0 - 1.0);
            const double r2 = 1.0 / (o0 - 2.0);
            const double r3 = 1.0 / (o0 - 3.0);
            l1 = (((((((-840.0) * r0) + 480.0) * r1) - 120.0) * r2) + 16.0) * r3;
            l2 = ((((90800.0 * r0) - 43200.0) * r1) + 7200.0) * r2 * r3;
            l3 = (((-3360000.0) * r0) + 960000.0) * r1 * r2 * r3;
            l4 = 24000000.0 * r0 * r1 * r2 * r3;
        } else if (left_o == 10U) {
            l1 = 1.0;
            l2 = 47.77777777777778;
            l3 = 2666.6666666666665;
            l4 = -66666.66666666667;
        } else if (left_o == 9U) {
            l1 = 1.0;
            l2 = 81.48148148148148;
            l3 = -2222.222222222222;
            l4 = 444444.44444444444;
        } else if (left_o == 8U) {
            l1 = 1.0;
            l2 = 116.66666666666667;
            l3 = 0.0;
            l4 = -1000000.0;
        } else {
            l1 = 1.0;
            l2 = 183.33333333333334;
            l3 = 20000.0;
            l4 = 1000000.0;
        }
        const double x1 = base + (l1 * miss);
        const double x2 = p2 + (l2 * miss);
        const double x3 = p3 + (l3 * miss);
        const double d = p4 + (l4 * miss);

        // The tracking error.
        const double t = 0.01 * static_cast<double>(elapsed);
        const double reference1 = t;
        const double reference0 = reference1 * reference1 * 0.5;
        const double e1 = x1 - reference0;
        const double e2 = x2 - reference1;
        const double e3 = x3 - 1.0;
        double v{};

        // The exact law in samples.
        const double m0 = (elapsed < 34U) ? (static_cast<double>(40U - elapsed)) : 6.0;
        const double s5 = (((-120000000.0) * e1) - (2100000.0 * e2)) - (16375.0 * e3);
        const double z1 = s5 - (72.1875 * (u3_ + d));
        const double s6 = (((-600000.0) * e2) - (13500.0 * e3)) - (60.0 * (u2_ + d));
        const double z2 = s6 - (84.375 * (u3_ + d));
        const double s7 = ((-1200.0) * e3) - (12.0 * (u1_ + d));
        const double z3 = (s7 - (12.0 * (u2_ + d))) - (9.0 * (u3_ + d));
        v = (((((z1 / m0) + z2) / (m0 - 1.0)) + z3) / (m0 - 2.0)) - d;
        if (!finite(v)) {
            return {0.0, Status::Range};
        }
        double u_now{};
        if (6.0 < v) {
            u_now = 6.0;
        } else if (v < -6.0) {
            u_now = -6.0;
        } else {
            u_now = v;
        }
        u4_ = u3_;
        u3_ = u2_;
        u2_ = u1_;
        u1_ = u_now;
        x1_hat_ = x1;
        x2_hat_ = x2;
        x3_hat_ = x3;
        d_hat_ = d;
        seen_ = 1U;
        if ((6.0 < v) || (v < -6.0)) {
            return {u_now, Status::Saturated};
        } else if (elapsed < 40U) {
            return {u_now, Status::Ok};
        } else {
            return {u_now, Status::Hold};
        }
    }

    /// The estimate of the state at the last sample.
    [[nodiscard]] constexpr std::array<double, 3> estimate() const noexcept
    {
        return {{x1_hat_, x2_hat_, x3_hat_}};
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

    std::uint32_t start_{}; // tick at which it was armed
    double u1_{}; // input of the last sample
    double u2_{}; // input of 2 samples ago
    double u3_{}; // input of 3 samples ago
    double u4_{}; // input of 4 samples ago
    std::uint32_t seen_{}; // 1 once y has been measured
    double x1_hat_{}; // estimate of x1
    double x2_hat_{}; // estimate of x2
    double x3_hat_{}; // estimate of x3
    double d_hat_{}; // estimate of d
};

} // namespace ptc

#endif
