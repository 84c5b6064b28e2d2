/*
 * Prescribed-time controller stage21: order n = 3, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang cpp --n 3 --mu "exp(a=1)" --name stage21 --clock samples --eps=0 --g="2" --reference="size*dt^2/(1 + t^2)" --delay=0.25
 * Version 0.1.0, design 0b4602f00880.
 *
 * Plant: x1' = x2, ..., x3' = g u; u held from sample to sample, 0.25 samples late.
 * Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
 *       sample period, as long as u is not clipped and nothing else acts on the plant.
 * Law: with M samples to go and z = S x, u h^4 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-3));
 *       the rows are those of Theorem 1 for the mapping exp. Close to the end deadbeat takes
 *       over.
 * With the reference r, e_i = x_i - r^(i-1) is in place of x_i above, and u = w + rho/g,
 *       where the inputs under way count less the rho of their own samples. At sample N e is
 *       0 where r^(n) is constant over each sample; else an error of order h^(5-i) is left in
 *       e_i.
 * t counts from the tick at which it was armed, and rho is r^(n) in the middle of the time in
 *       which u acts:
 *   e_i = x_i - r^(i-1), with the reference r = size*dt^2/(1 + t^2)
 *   r^(1) = 2*size*dt*(1 + t^2 - dt*t)/(1 + t^2)^2
 *   r^(2) = 2*size*((1 + t^2)^2 + 4*dt^2*t^2 - 4*(1 + t^2)*dt*t - (1 + t^2)*dt^2)/(1 + t^2)^3
 *   r^(3) = 12*size*(4*(1 + t^2)*dt*t^2 + 2*(1 + t^2)*dt^2*t - (1 + t^2)^2*dt - (1 + t^2)^2*t
 *       - 4*dt^2*t^3)/(1 + t^2)^4
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
 *   size [as in its expression]: parameter of an expression of the design
 *
 * k counts samples and may wrap; arm again within 2^32 - N samples.
 * From sample N on the last gains are held (status HOLD).
 * |u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
 *       lasts.
 * Guard full: what is measured is finite, or the call is refused (INPUT).
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
#ifndef STAGE21_CDA21BE0_HPP
#define STAGE21_CDA21BE0_HPP

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
struct Stage21Params {
    std::uint32_t samples{}; ///< samples N from the start to rest [samples], at least 4
    double h{}; ///< sample period [s], from 1e-150 to 1e150
    double u_max{}; ///< bound of |u| [unit of u], > 0, infinity allowed
    std::array<double, 4> k{}; ///< gains k_i of pi0 = -sum k_i xi_i [1/s^4], finite
    double deadbeat{}; ///< samples to go at which deadbeat takes over, 0 for a safe default [samples], finite
    double size{}; ///< parameter of an expression of the design [as in its expression], finite
};

/// Controller: set by init, changed by arm and by what is not const.
class Stage21 {
public:
    using Params = Stage21Params;

    /// Takes the parameters and arms at tick 0. Ok, or Param with nothing changed.
    [[nodiscard]] constexpr Status init(const Params& params) noexcept
    {
        if (!((params.samples > 3U)
                && (1e-150 <= params.h)
                && (params.h <= 1e150)
                && (params.u_max > 0.0)
                && finite(params.k[0])
                && finite(params.k[1])
                && finite(params.k[2])
                && finite(params.k[3])
                && finite(params.deadbeat)
                && (params.deadbeat >= 0.0)
                && finite(params.size))) {
            return Status::Param;
        }
        const std::uint32_t samples = params.samples;
        const double h = params.h;
        const double p_size = params.size;
        const double c_r3 = 2.0 * p_size;
        const double c_r5 = 12.0 * p_size;
        const double c_r6 = 0.75 * h;
        const double c_r12 = (-0.25) * h;
        const double s1 = (params.k[3] - 9.0) + 4.0;
        const double s2 = (s1 < 8.0) ? 8.0 : s1;
        const double deadbeat = (params.deadbeat > 0.0) ? params.deadbeat : s2;
        const double s3 = 1.0 / (params.h * params.h * params.h);
        const double w1_1 = 0.5 * (-params.k[0]) * s3;
        const double w1_2 = (-0.875) * (-params.k[0]) * (1.0 / (params.h * params.h));
        const double w1_3 = 0.6822916666666666 * (-params.k[0]) * (1.0 / params.h);
        const double w1_4 = (-0.6015625) * (-params.k[0]);
        const double s4 = 0.5 * (((1.0 - params.k[1]) + params.k[2]) - params.k[3]);
        const double w2_2 = s4 * (1.0 / (params.h * params.h));
        const double s5 = (-0.625) * (((1.0 - params.k[1]) + params.k[2]) - params.k[3]);
        const double w2_3 = s5 * (1.0 / params.h);
        const double w2_4 = 0.65625 * (((1.0 - params.k[1]) + params.k[2]) - params.k[3]);
        const double s6 = 0.5 * (((-7.0) - params.k[2]) + (3.0 * params.k[3]));
        const double w3_3 = s6 * (1.0 / params.h);
        const double w3_4 = (-0.75) * (((-7.0) - params.k[2]) + (3.0 * params.k[3]));
        const double w4_4 = 6.0 - params.k[3];
        const double b_1 = (-0.5) * (1.0 / (params.h * params.h * params.h));
        const double b_2 = (-1.125) * (1.0 / (params.h * params.h));
        const double b_3 = (-1.1822916666666667) * (1.0 / params.h);
        const double u_max = params.u_max;
        if (!(finite(c_r3)
                && finite(c_r5)
                && finite(c_r6)
                && finite(c_r12)
                && finite(deadbeat)
                && finite(w1_1)
                && finite(w1_2)
                && finite(w1_3)
                && finite(w1_4)
                && finite(w2_2)
                && finite(w2_3)
                && finite(w2_4)
                && finite(w3_3)
                && finite(w3_4)
                && finite(w4_4)
                && finite(b_1)
                && finite(b_2)
                && finite(b_3)
                && (params.h * params.h * params.h >= 1e-200)
                && (1.0 / (params.h * params.h * params.h) >= 1e-200))) {
            return Status::Param;
        }
        start_ = 0U;
        samples_ = samples;
        u1_ = 0.0;
        h_ = h;
        p_size_ = p_size;
        c_r3_ = c_r3;
        c_r5_ = c_r5;
        c_r6_ = c_r6;
        c_r12_ = c_r12;
        deadbeat_ = deadbeat;
        w1_1_ = w1_1;
        w1_2_ = w1_2;
        w1_3_ = w1_3;
        w1_4_ = w1_4;
        w2_2_ = w2_2;
        w2_3_ = w2_3;
        w2_4_ = w2_4;
        w3_3_ = w3_3;
        w3_4_ = w3_4;
        w4_4_ = w4_4;
        b_1_ = b_1;
        b_2_ = b_2;
        b_3_ = b_3;
        u_max_ = u_max;
        return Status::Ok;
    }

    /// Starts again: the deadline is N samples after tick `k`. The time of the reference counts
    /// from there. Estimates and inputs under way are kept.
    constexpr void arm(std::uint32_t k) noexcept
    {
        start_ = k;
    }

    /// u from tick `k`, which may wrap, and the state x = (x1, x1', ...). Call it once for each
    /// tick.
    /// On a negative status u is 0 and nothing has changed.
    constexpr Control<double> step(std::uint32_t k, const std::array<double, 3>& x) noexcept
    {
        if (!(finite(x[0]) && finite(x[1]) && finite(x[2]))) {
            return {0.0, Status::Input};
        }
        const std::uint32_t elapsed = k - start_;
        const double x1 = x[0];
        const double x2 = x[1];
        const double x3 = x[2];

        // The tracking error.
        const double t = static_cast<double>(elapsed) * h_;
        const double v_r1 = t * t;
        const double v_r2 = 1.0 + v_r1;
        const double reference0 = (p_size_ * v_r1) / v_r2;
        const double v_r4 = v_r2 * v_r2;
        const double reference1 = (c_r3_ * t * (v_r2 - v_r1)) / v_r4;
        const double s1 = ((v_r4 + (4.0 * v_r1 * v_r1)) - (4.0 * v_r2 * t * t)) - (v_r2 * v_r1);
        const double reference2 = (c_r3_ * s1) / (v_r2 * v_r4);
        const double v_r7 = t + c_r6_;
        const double v_r8 = v_r7 * v_r7;
        const double v_r9 = 1.0 + v_r8;
        const double v_r10 = v_r9 * v_r9;
        const double v_r11 = v_r10 * v_r7;
        const double s2 = ((4.0 * v_r9 * v_r7 * v_r8) + (2.0 * v_r9 * v_r8 * v_r7)) - v_r11;
        const double s3 = c_r5_ * ((s2 - v_r11) - (4.0 * v_r8 * (v_r7 * v_r8)));
        const double rho0 = s3 / (v_r10 * v_r10);
        const double v_r13 = t + c_r12_;
        const double v_r14 = (v_r13 < 0.0) ? 0.0 : v_r13;
        const double v_r15 = v_r14 * v_r14;
        const double v_r16 = 1.0 + v_r15;
        const double v_r17 = v_r16 * v_r16;
        const double v_r18 = v_r17 * v_r14;
        const double s4 = (4.0 * v_r16 * v_r14 * v_r15) + (2.0 * v_r16 * v_r15 * v_r14);
        const double s5 = ((s4 - v_r18) - v_r18) - (4.0 * v_r15 * (v_r14 * v_r15));
        const double rho1 = (c_r5_ * s5) / (v_r17 * v_r17);
        const double e1 = x1 - reference0;
        const double e2 = x2 - reference1;
        const double e3 = x3 - reference2;
        const std::uint32_t left = (elapsed < samples_) ? (samples_ - elapsed) : 0U;
        const double m0 = static_cast<double>(left);
        double v{};
        if (m0 > deadbeat_) {
            // The exact law in samples.
            const double s6 = (w1_1_ * e1) + (w1_2_ * e2) + (w1_3_ * e3);
            const double z1 = s6 + (w1_4_ * (u1_ - (0.5 * rho1)));
            const double s7 = w2_4_ * (u1_ - (0.5 * rho1));
            const double z2 = (w2_2_ * e2) + (w2_3_ * e3) + s7;
            const double z3 = (w3_3_ * e3) + (w3_4_ * (u1_ - (0.5 * rho1)));
            const double z4 = w4_4_ * (u1_ - (0.5 * rho1));
            const double m0f2 = m0 * (m0 - 1.0);
            const double m0f3 = m0f2 * (m0 - 2.0);
            const double s8 = (z1 + (z2 * m0) + (z3 * m0f2) + (z4 * m0f3)) / (m0f3 * (m0 - 3.0));
            v = s8 + (u1_ - (0.5 * rho1)) + (0.5 * rho0);
        } else {
            // Deadbeat.
            const double s9 = (b_1_ * e1) + (b_2_ * e2) + (b_3_ * e3);
            v = s9 + (b_4_ * (u1_ - (0.5 * rho1))) + (0.5 * rho0);
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
        u1_ = u_now;
        if ((v > u_max_) || (v < -u_max_)) {
            return {u_now, Status::Saturated};
        } else if (elapsed < samples_) {
            return {u_now, Status::Ok};
        } else {
            return {u_now, Status::Hold};
        }
    }

private:
    /// std::isfinite is not constexpr in C++17.
    static constexpr bool finite(double v) noexcept
    {
        return (v >= std::numeric_limits<double>::lowest()) && (v <= (std::numeric_limits<double>::max)());
    }
    /// -67/128, weight of u1 in the law.
    static constexpr double b_4_{-0.5234375};

    std::uint32_t start_{}; // tick at which it was armed
    std::uint32_t samples_{}; // samples from the start to rest
    double u1_{}; // input of the last sample
    double h_{}; // sample period
    double p_size_{}; // parameter of an expression of the design
    double c_r3_{}; // derived from the parameters
    double c_r5_{}; // derived from the parameters
    double c_r6_{}; // derived from the parameters
    double c_r12_{}; // derived from the parameters
    double deadbeat_{}; // samples to go at which deadbeat takes over
    double w1_1_{}; // weight of x1 in the law
    double w1_2_{}; // weight of x2 in the law
    double w1_3_{}; // weight of x3 in the law
    double w1_4_{}; // weight of u1 in the law
    double w2_2_{}; // weight of x2 in the law
    double w2_3_{}; // weight of x3 in the law
    double w2_4_{}; // weight of u1 in the law
    double w3_3_{}; // weight of x3 in the law
    double w3_4_{}; // weight of u1 in the law
    double w4_4_{}; // weight of u1 in the law
    double b_1_{}; // weight of x1 in the law
    double b_2_{}; // weight of x2 in the law
    double b_3_{}; // weight of x3 in the law
    double u_max_{}; // bound of |u|
};

} // namespace ptc

#endif
