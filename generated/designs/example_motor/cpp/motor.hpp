/*
 * Prescribed-time controller motor: order n = 3, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang cpp --n 3 --mu "exp(a=1)" --name motor --clock samples --A="[[0,1,0],[0,-0.5,1500],[0,-15,-600]]" --B="[0,0,500]" --C="[[1,0,0]]" --disturbance constant --observer-poles=-4,-5,-6,-7 --observer-samples=150 --observer-eps=0.04 --tau=0.4 --eps=0.02 --u-max=24 --poles=-4,-5,-6,-7 --sample-time=1e-3 --delay=1 --sensor-step=6e-6
 * Version 0.1.0, design c4f0b0da5e5e.
 *
 * Plant: x' = A x + B (u + d), d constant and unknown of --A and --B above; u held from
 *       sample to sample, one sample late, y = C x.
 * Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
 *       sample period, as long as u is not clipped and nothing else acts on the plant.
 * Law: with M - 3 samples to go and z = S x, the differences of a flat output, u = sum of
 *       row_j z_j/((M-j+1)...(M-3)) less the drift of z; the rows are those of Theorem 1 for
 *       the mapping exp. The gains of 20 samples to go stay.
 *
 * Parameters:
 *   samples = 400 [samples], fixed: samples N from the start to rest
 *   h = 1e-3 [s], fixed: sample period
 *   eps = 0.02 [s], fixed: time-to-go at which the gains are held
 *   u_max = 24 [unit of u], fixed: bound of |u|
 *   a = 1 [1/s], fixed: rate of stretched time
 *   k_1 = 840 [1/s^4], fixed: gains k_i of pi0 = -sum k_i xi_i
 *   k_2 = 638 [1/s^3], fixed: gains k_i of pi0 = -sum k_i xi_i
 *   k_3 = 179 [1/s^2], fixed: gains k_i of pi0 = -sum k_i xi_i
 *   k_4 = 22 [1/s], fixed: gains k_i of pi0 = -sum k_i xi_i
 *
 * k counts samples and may wrap; arm again within 2^32 - N samples.
 * From sample N on the last gains are held (status HOLD).
 * The estimates are exact from sample 150 after the start on where the measurement is; with
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
 *   growth: sound: near rest at sample 400, not at rest: the gains are held from 20 samples
 *       to go, and |u| is bounded; so does what the held observer leaves of its error.
 *   sampling: not checked: the law is exact in samples, at any period.
 *   deadline: not checked: the law is exact in samples, at any period.
 *   loop: not checked: `x0_max` is not given.
 *   envelope: not checked: it does not examine a clock in samples.
 */
#ifndef MOTOR_4F36736F_HPP
#define MOTOR_4F36736F_HPP

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
    Param = -1, ///< a parameter outside its domain, or coefficients outside the range
    Input = -2, ///< x or t not finite, or t before t0
    Range = -3 ///< u not finite
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
struct MotorParams {
};

/// Controller: set by init, changed by arm and by what is not const.
class Motor {
public:
    using Params = MotorParams;

    /// Takes the parameters and arms at tick 0. Ok, or Param with nothing changed.
    [[nodiscard]] constexpr Status init(const Params&) noexcept
    {
        start_ = 0U;
        u1_ = 0.0;
        u2_ = 0.0;
        seen_ = 0U;
        x1_hat_ = 0.0;
        x1_next_ = 0.0;
        x2_hat_ = 0.0;
        x2_next_ = 0.0;
        x3_hat_ = 0.0;
        x3_next_ = 0.0;
        d_hat_ = 0.0;
        d_next_ = 0.0;
        return Status::Ok;
    }

    /// Starts again: the deadline is N samples after tick `k`. Estimates and inputs under way are
    /// kept. Estimates too large to compute with begin anew.
    constexpr void arm(std::uint32_t k) noexcept
    {
        start_ = k;
        const double s1 = absolute(x1_next_) + absolute(x2_next_);
        const double size = s1 + absolute(x3_next_) + absolute(d_next_);
        if (!(size <= 1e150)) {
            seen_ = 0U;
            x1_hat_ = 0.0;
            x1_next_ = 0.0;
            x2_hat_ = 0.0;
            x2_next_ = 0.0;
            x3_hat_ = 0.0;
            x3_next_ = 0.0;
            d_hat_ = 0.0;
            d_next_ = 0.0;
        }
    }

    /// u from tick `k`, which may wrap, and what is measured, y = C x. Call it once for each tick.
    /// On a negative status u is 0 and nothing has changed.
    constexpr Control<double> step(std::uint32_t k, const std::array<double, 1>& y) noexcept
    {
        if (!finite(y[0])) {
            return {0.0, Status::Input};
        }
        const std::uint32_t elapsed = k - start_;

        // The estimates; at first what y shows.
        double x1{};
        double x2{};
        double x3{};
        double d{};
        if (seen_ == 0U) {
            x1 = y[0];
            x2 = 0.0;
            x3 = 0.0;
            d = 0.0;
        } else {
            x1 = x1_next_ + (0.00010816330676811052 * u2_);
            x2 = x2_next_ + (0.30941358230147875 * u2_);
            x3 = x3_next_ + (0.37459048481653323 * u2_);
            d = d_next_;
        }

        // Prediction of the next sample.
        const double miss1 = y[0] - x1;
        const double off1 = miss1;
        const std::uint32_t left_o = (elapsed < 150U) ? (150U - elapsed) : 0U;
        const double o0 = (static_cast<double>(left_o) < 40.0) ? 40.0 : static_cast<double>(left_o);
        double l1{};
        double l2{};
        double l3{};
        double l4{};
        const double r0 = 1.0 / o0;
        const double r1 = 1.0 / (o0 - 1.0);
        const double r2 = 1.0 / (o0 - 2.0);
        const double r3 = 1.0 / (o0 - 3.0);
        const double s1 = (((((((-96.0) * r0) + 96.0) * r1) - 48.0) * r2) + 16.0) * r3;
        l1 = s1 - 0.46857164949780494;
        const double s2 = ((859382.9277311233 * r0) - 513847.60335174634) * r1;
        const double s3 = (((s2 + 125558.23800330989) * r2) - 9808.939721535125) * r3;
        l2 = s3 + 264.4187821124759;
        const double s4 = (((-620544.0922410007) * r0) + 289368.54342637886) * r1;
        const double s5 = (((s4 - 49493.69520132396) * r2) + 3680.3758886140504) * r3;
        l3 = s5 - 98.64522377262374;
        l4 = 42644.35104284018 * r0 * r1 * r2 * r3;
        const double s6 = x1 + (0.000996505559752715 * x2) + (0.0006188271646029575 * x3);
        const double x1_on = s6 + (0.00010816330676811052 * d) + (l1 * off1);
        const double s7 = (0.9902193397510792 * x2) + (1.1234620408672982 * x3);
        const double x2_on = s7 + (0.30941358230147875 * d) + (l2 * off1);
        const double s8 = ((-0.011234620408672982) * x2) + (0.5412090107511158 * x3);
        const double x3_on = s8 + (0.37459048481653323 * d) + (l3 * off1);
        const double d_on = d + (l4 * off1);
        const std::uint32_t left = (elapsed < 400U) ? (400U - elapsed) : 0U;
        const double m0 = (static_cast<double>(left) < 20.0) ? 20.0 : static_cast<double>(left);
        double v{};

        // The exact law in samples.
        const double s9 = ((-1492552.2864994062) * x1) + (1567.1688802442739 * x2);
        const double z1 = s9 - (863.5135156573022 * x3);
        const double z2 = ((-853.121915155696) * x2) + (704.6828966771754 * x3);
        const double z3 = (0.10681268759856057 * x2) - (320.4380627956817 * x3);
        const double s10 = (0.4798607068523099 * x2) + (19.61787944307025 * x3);
        const double z4 = s10 - (16.0 * (u1_ + d));
        const double s11 = ((((z1 / (m0 + 3.0)) + z2) / (m0 + 2.0)) + z3) / (m0 + 1.0);
        const double s12 = ((-0.014068298956658285) * x2) - (0.5288375642249519 * x3);
        const double s13 = ((s11 + z4) / m0) + (s12 + (1.468571649497805 * (u1_ + d)));
        v = s13 - d;
        if (!(finite(v) && finite(x1_on) && finite(x2_on) && finite(x3_on) && finite(d_on))) {
            return {0.0, Status::Range};
        }
        double u_now{};
        if (24.0 < v) {
            u_now = 24.0;
        } else if (v < -24.0) {
            u_now = -24.0;
        } else {
            u_now = v;
        }
        u2_ = u1_;
        u1_ = u_now;
        x1_hat_ = x1;
        x1_next_ = x1_on;
        x2_hat_ = x2;
        x2_next_ = x2_on;
        x3_hat_ = x3;
        x3_next_ = x3_on;
        d_hat_ = d;
        d_next_ = d_on;
        seen_ = 1U;
        if ((24.0 < v) || (v < -24.0)) {
            return {u_now, Status::Saturated};
        } else if (static_cast<double>(left) <= 20.0) {
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
    std::uint32_t seen_{}; // 1 once y has been measured
    double x1_hat_{}; // estimate of x1
    double x1_next_{}; // prediction of x1 without u
    double x2_hat_{}; // estimate of x2
    double x2_next_{}; // prediction of x2 without u
    double x3_hat_{}; // estimate of x3
    double x3_next_{}; // prediction of x3 without u
    double d_hat_{}; // estimate of d
    double d_next_{}; // prediction of d without u
};

} // namespace ptc

#endif
