/*
 * Prescribed-time controller stage33: order n = 2, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang cpp --n 2 --axes 3 --mu "exp(a=1)" --name stage33 --clock samples --precision f32 --tau=0.3 --eps=0 --limits=1,2,3 --poles="[[-4,-5],[-3+i,-3-i],[-6,-7.5]]" --g="[1/2, 2, -1]" --reference="1/(2 + t^2), size*dt/(3 + dt), t^2/(2 + t^2)" --sample-time=0.01
 * Version 0.1.0, design 600667a7090c.
 *
 * Plant: x1' = x2, x2' = g u; u held from sample to sample.
 * Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
 *       sample period, as long as u is not clipped and nothing else acts on the plant.
 * Law: with M samples to go and z = S x, u h^2 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-1));
 *       the rows are those of Theorem 1 for the mapping exp. From 9 samples to go on these
 *       are M - 2 and the exponents 3, 4, those of least energy. The gains of 2 samples to go
 *       stay: they are deadbeat.
 * With a reference r of each axis, e_i = x_i - r^(i-1) is in place of x_i above, and u = w +
 *       rho/g of each axis. What r^(n) changes over a sample leaves an error of order
 *       h^(n+2-i) in e_i at sample N, h^3 for n = 1, and none where it is constant there.
 * t counts from the tick at which it was armed, and rho is r^(n) in the middle of the time in
 *       which u acts:
 *   of axis 1: r = 1/(2 + t^2), r^(1) = -2*t/(2 + t^2)^2, r^(2) = 2*(4*t^2 - (2 + t^2))/(2 +
 *       t^2)^3
 *   of axis 2: r = size*dt/(3 + dt), r^(1) = size*(3 + dt - dt)/(3 + dt)^2, r^(2) =
 *       2*size*(dt - (3 + dt))/(3 + dt)^3
 *   of axis 3: r = t^2/(2 + t^2), r^(1) = 2*t*(2 + t^2 - t^2)/(2 + t^2)^2, r^(2) = 2*((2 +
 *       t^2)^2 + 4*t^4 - 5*(2 + t^2)*t^2)/(2 + t^2)^3
 * Axes: 3, each a chain of its own with this deadline and mapping. step computes what depends
 *       on time once.
 *   axis 1: k = 20, 9; u_max = 1; g = 1/2
 *   axis 2: k = 10, 6; u_max = 2; g = 2
 *   axis 3: k = 45, 13.5; u_max = 3; g = -1
 *
 * Parameters:
 *   samples = 30 [samples], fixed: samples N from the start to rest
 *   h = 0.01 [s], fixed: sample period
 *   eps = 0 [s], fixed: time-to-go at which the gains are held
 *   a = 1 [1/s], fixed: rate of stretched time
 *   size [as in its expression]: parameter of an expression of the design
 *
 * k counts samples and may wrap; arm again within 2^32 - N samples.
 * From sample N on the last gains are held (status HOLD).
 * |u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
 *       lasts.
 * Guard full: what is measured is finite, or the call is refused (INPUT).
 * Precision f32 (IEEE 754 binary32). Results are bit for bit the same on every IEEE 754
 *       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
 *
 * Checks of the design (details: ptc-codegen check):
 *   membership: sound: exp is of class M for all its parameters.
 *   growth: sound: at rest at sample 30 from any state, but for what r does between samples,
 *       whatever the poles, and |u| is bounded.
 *   sampling: not checked: `loop` bounds what the period leaves of a reference that moves.
 *   deadline: not checked: `loop` bounds what the period leaves of a reference that moves.
 *   loop: not checked: axis 1: `x0_max` is not given.
 *   envelope: not checked: it does not examine a clock in samples.
 */
#ifndef STAGE33_68D3750C_HPP
#define STAGE33_68D3750C_HPP

#include <array>
#include <cfloat>
#include <cstddef>
#include <cstdint>
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
struct Stage33Params {
    float size{}; ///< parameter of an expression of the design [as in its expression], finite
};

/// Controller: set by init, changed by arm and by what is not const.
class Stage33 {
public:
    using Params = Stage33Params;

    /// Takes the parameters and arms at tick 0. Ok, or Param with nothing changed.
    [[nodiscard]] constexpr Status init(const Params& params) noexcept
    {
        if (!finite(params.size)) {
            return Status::Param;
        }
        const float p_size = params.size;
        const float c_r10 = 2.0f * p_size;
        if (!finite(c_r10)) {
            return Status::Param;
        }
        start_ = 0U;
        p_size_ = p_size;
        c_r10_ = c_r10;
        return Status::Ok;
    }

    /// Starts again: the deadline is N samples after tick `k`. The time of the reference counts
    /// from there.
    constexpr void arm(std::uint32_t k) noexcept
    {
        start_ = k;
    }

    /// u of each axis from tick `k`, which may wrap, and the state x = (x1, x1', ...) of each.
    /// Where one of them is not finite, every u is 0; else the status is SATURATED where one was
    /// clipped.
    constexpr Axes<float, 3> step(std::uint32_t k, const std::array<std::array<float, 2>, 3>& x) const noexcept
    {
        Axes<float, 3> all{};
        if (!(finite(x[0][0])
                && finite(x[0][1])
                && finite(x[1][0])
                && finite(x[1][1])
                && finite(x[2][0])
                && finite(x[2][1]))) {
            return {{}, {{Status::Input, Status::Input, Status::Input}}, Status::Input};
        }
        const std::uint32_t elapsed = k - start_;
        const float x1_1 = x[0][0];
        const float x2_1 = x[0][1];
        const float x1_2 = x[1][0];
        const float x2_2 = x[1][1];
        const float x1_3 = x[2][0];
        const float x2_3 = x[2][1];

        // The tracking error.
        const float t = static_cast<float>(elapsed) * h_;
        const float v_r1 = t * t;
        const float v_r2 = 2.0f + v_r1;
        const float reference0_1 = 1.0f / v_r2;
        const float v_r3 = v_r2 * v_r2;
        const float reference1_1 = ((-2.0f) * t) / v_r3;
        const float v_r4 = t + 0.005f;
        const float v_r5 = v_r4 * v_r4;
        const float v_r6 = 2.0f + v_r5;
        const float v_r7 = v_r6 * v_r6;
        const float v_r8 = v_r6 * v_r7;
        const float rho0_1 = (2.0f * ((4.0f * v_r5) - v_r6)) / v_r8;
        const float v_r9 = 3.0f + t;
        const float reference0_2 = (p_size_ * t) / v_r9;
        const float reference1_2 = (p_size_ * (v_r9 - t)) / (v_r9 * v_r9);
        const float v_r11 = 3.0f + v_r4;
        const float rho0_2 = (c_r10_ * (v_r4 - v_r11)) / (v_r11 * (v_r11 * v_r11));
        const float reference0_3 = v_r1 / v_r2;
        const float reference1_3 = (2.0f * t * (v_r2 - v_r1)) / v_r3;
        const float rho0_3 = (2.0f * ((v_r7 + (4.0f * (v_r5 * v_r5))) - (5.0f * v_r6 * v_r5))) / v_r8;
        const float e1_1 = x1_1 - reference0_1;
        const float e2_1 = x2_1 - reference1_1;
        const float e1_2 = x1_2 - reference0_2;
        const float e2_2 = x2_2 - reference1_2;
        const float e1_3 = x1_3 - reference0_3;
        const float e2_3 = x2_3 - reference1_3;
        float law_1{};

        // The exact law in samples.
        const float m0_1 = (elapsed < 28U) ? (static_cast<float>(33U - elapsed)) : 5.0f;
        const float z1_1 = (w1_1_1_ * e1_1) + (w1_2_1_ * e2_1);
        const float z2_1 = w2_2_1_ * e2_1;
        law_1 = ((z1_1 + (z2_1 * m0_1)) / (m0_1 * (m0_1 - 1.0f))) + (2.0f * rho0_1);
        float law_2{};
        float law_3{};
        if (elapsed < 26U) {
            // The exact law in samples.
            const float m0_2 = static_cast<float>(30U - elapsed);
            const float z1_2 = (w1_1_2_ * e1_2) + (w1_2_2_ * e2_2);
            const float z2_2 = w2_2_2_ * e2_2;
            law_2 = ((z1_2 + (z2_2 * m0_2)) / (m0_2 * (m0_2 - 1.0f))) + (0.5f * rho0_2);
        } else {
            // The law of least energy to the end.
            const float m1_2 = (elapsed < 28U) ? (static_cast<float>(32U - elapsed)) : 4.0f;
            const float y1_2 = (end1_1_2_ * e1_2) + (end1_2_2_ * e2_2);
            const float y2_2 = end2_2_2_ * e2_2;
            law_2 = ((y1_2 + (y2_2 * m1_2)) / (m1_2 * (m1_2 - 1.0f))) + (0.5f * rho0_2);
        }
        if (elapsed < 21U) {
            // The exact law in samples.
            const float m0_3 = static_cast<float>(30U - elapsed);
            const float z1_3 = (w1_1_3_ * e1_3) + (w1_2_3_ * e2_3);
            const float z2_3 = w2_2_3_ * e2_3;
            law_3 = ((z1_3 + (z2_3 * m0_3)) / (m0_3 * (m0_3 - 1.0f))) - rho0_3;
        } else {
            // The law of least energy to the end.
            const float m1_3 = (elapsed < 28U) ? (static_cast<float>(35U - elapsed)) : 7.0f;
            const float y1_3 = (end1_1_3_ * e1_3) + (end1_2_3_ * e2_3);
            const float y2_3 = end2_2_3_ * e2_3;
            law_3 = ((y1_3 + (y2_3 * m1_3)) / (m1_3 * (m1_3 - 1.0f))) - rho0_3;
        }
        if (elapsed < 30U) {
            all.status = Status::Ok;
        } else {
            all.status = Status::Hold;
        }
        if (finite(law_1) && finite(law_2) && finite(law_3)) {
            all.u[0] = law_1;
            all.axes[0] = all.status;
            all.u[1] = law_2;
            all.axes[1] = all.status;
            all.u[2] = law_3;
            all.axes[2] = all.status;
            if (law_1 > 1.0f) {
                all.u[0] = 1.0f;
                all.axes[0] = Status::Saturated;
                all.status = Status::Saturated;
            } else if (law_1 < -1.0f) {
                all.u[0] = -1.0f;
                all.axes[0] = Status::Saturated;
                all.status = Status::Saturated;
            }
            if (law_2 > 2.0f) {
                all.u[1] = 2.0f;
                all.axes[1] = Status::Saturated;
                all.status = Status::Saturated;
            } else if (law_2 < -2.0f) {
                all.u[1] = -2.0f;
                all.axes[1] = Status::Saturated;
                all.status = Status::Saturated;
            }
            if (law_3 > 3.0f) {
                all.u[2] = 3.0f;
                all.axes[2] = Status::Saturated;
                all.status = Status::Saturated;
            } else if (law_3 < -3.0f) {
                all.u[2] = -3.0f;
                all.axes[2] = Status::Saturated;
                all.status = Status::Saturated;
            }
        } else {
            all.u[0] = 0.0f;
            if (finite(law_1)) {
                all.axes[0] = all.status;
            } else {
                all.axes[0] = Status::Range;
            }
            all.u[1] = 0.0f;
            if (finite(law_2)) {
                all.axes[1] = all.status;
            } else {
                all.axes[1] = Status::Range;
            }
            all.u[2] = 0.0f;
            if (finite(law_3)) {
                all.axes[2] = all.status;
            } else {
                all.axes[2] = Status::Range;
            }
            all.status = Status::Range;
        }
        return all;
    }

private:
    /// std::isfinite is not constexpr in C++17.
    static constexpr bool finite(float v) noexcept
    {
        return (v >= std::numeric_limits<float>::lowest()) && (v <= (std::numeric_limits<float>::max)());
    }
    /// 1/100, sample period.
    static constexpr float h_{0.01f};
    /// Weight of x1 in the law.
    static constexpr float w1_1_1_{-400000.0f};
    /// Weight of x2 in the law.
    static constexpr float w1_2_1_{2000.0f};
    /// Weight of x2 in the law.
    static constexpr float w2_2_1_{-1600.0f};
    /// Weight of x1 in the law.
    static constexpr float w1_1_2_{-50000.0f};
    /// Weight of x2 in the law.
    static constexpr float w1_2_2_{250.0f};
    /// Weight of x2 in the law.
    static constexpr float w2_2_2_{-250.0f};
    /// Weight of x1 in the law.
    static constexpr float end1_1_2_{-60000.0f};
    /// Weight of x2 in the law.
    static constexpr float end1_2_2_{300.0f};
    /// Weight of x2 in the law.
    static constexpr float end2_2_2_{-300.0f};
    /// Weight of x1 in the law.
    static constexpr float w1_1_3_{450000.0f};
    /// Weight of x2 in the law.
    static constexpr float w1_2_3_{-2250.0f};
    /// Weight of x2 in the law.
    static constexpr float w2_2_3_{1250.0f};
    /// Weight of x1 in the law.
    static constexpr float end1_1_3_{420000.0f};
    /// Weight of x2 in the law.
    static constexpr float end1_2_3_{-2100.0f};
    /// Weight of x2 in the law.
    static constexpr float end2_2_3_{1200.0f};

    std::uint32_t start_{}; // tick at which it was armed
    float p_size_{}; // parameter of an expression of the design
    float c_r10_{}; // derived from the parameters
};

} // namespace ptc

#endif
