/*
 * Prescribed-time controller stage24: order n = 2, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang cpp --n 2 --mu "exp(a=1)" --name stage24 --clock samples --A="[[-1,1],[3,-2]]" --B="[1,2]" --output="[-2,1]" --precision f32 --tau=0.3 --eps=0 --poles=-4,-5 --reference="size*dt^2/(1 + t^2)" --sample-time=0.01
 * Version 0.1.0, design 50bc8ccf34e5.
 *
 * Plant: x' = A x + B u of --A and --B above; u held from sample to sample.
 * Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
 *       sample period, as long as u is not clipped and nothing else acts on the plant.
 * Law: with M - 3 samples to go and z = S x, the differences of a flat output, u = sum of
 *       row_j z_j/((M-j+1)...(M-1)) less the drift of z; the rows are those of Theorem 1 for
 *       the mapping exp. The gains of 2 samples to go stay: they are deadbeat.
 * With the reference r = size*dt^2/(1 + t^2), x - x_r is in place of x above, and u = w +
 *       u_r: with them the output y = -2*x1 + x2 is r, and stays so. At sample N x = x_r
 *       where u_r is constant over each sample; else an error of order h^(4-i) is left in
 *       y^(i-1).
 * t counts from the tick at which it was armed, and u_r is that in the middle of the time in
 *       which u acts. To four digits:
 *   r^(1) = 2*size*dt*(1 + t^2 - dt*t)/(1 + t^2)^2
 *   r^(2) = 2*size*((1 + t^2)^2 + 4*dt^2*t^2 - 4*(1 + t^2)*dt*t - (1 + t^2)*dt^2)/(1 + t^2)^3
 *   x_r1 = -1.333*r - 0.3333*r^(1)
 *   x_r2 = -1.667*r - 0.6667*r^(1)
 *   u_r = 0.3333*r - r^(1) - 0.3333*r^(2)
 *
 * Parameters:
 *   samples = 30 [samples], fixed: samples N from the start to rest
 *   h = 0.01 [s], fixed: sample period
 *   eps = 0 [s], fixed: time-to-go at which the gains are held
 *   u_max [unit of u]: bound of |u|
 *   a = 1 [1/s], fixed: rate of stretched time
 *   k_1 = 20 [1/s^2], fixed: gains k_i of pi0 = -sum k_i xi_i
 *   k_2 = 9 [1/s], fixed: gains k_i of pi0 = -sum k_i xi_i
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
 *   loop: not checked: `size` is left to run time.
 *   envelope: not checked: it does not examine a clock in samples.
 */
#ifndef STAGE24_A3551CC8_HPP
#define STAGE24_A3551CC8_HPP

#include <array>
#include <cfloat>
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

/// Run-time parameters.
struct Stage24Params {
    float u_max{}; ///< bound of |u| [unit of u], > 0, infinity allowed
    float size{}; ///< parameter of an expression of the design [as in its expression], finite
};

/// Controller: set by init, changed by arm and by what is not const.
class Stage24 {
public:
    using Params = Stage24Params;

    /// Takes the parameters and arms at tick 0. Ok, or Param with nothing changed.
    [[nodiscard]] constexpr Status init(const Params& params) noexcept
    {
        if (!((params.u_max > 0.0f) && finite(params.size))) {
            return Status::Param;
        }
        const float p_size = params.size;
        const float c_r4 = 2.0f * p_size;
        const float u_max = params.u_max;
        if (!finite(c_r4)) {
            return Status::Param;
        }
        start_ = 0U;
        p_size_ = p_size;
        c_r4_ = c_r4;
        u_max_ = u_max;
        return Status::Ok;
    }

    /// Starts again: the deadline is N samples after tick `k`. The time of the reference counts
    /// from there.
    constexpr void arm(std::uint32_t k) noexcept
    {
        start_ = k;
    }

    /// u from tick `k`, which may wrap, and the state x.
    /// On a negative status u is 0 and nothing has changed.
    constexpr Control<float> step(std::uint32_t k, const std::array<float, 2>& x) const noexcept
    {
        if (!(finite(x[0]) && finite(x[1]))) {
            return {0.0f, Status::Input};
        }
        const std::uint32_t elapsed = k - start_;
        const float x1 = x[0];
        const float x2 = x[1];

        // The tracking error.
        const float t = static_cast<float>(elapsed) * h_;
        const float v_r1 = t * t;
        const float v_r2 = 1.0f + v_r1;
        const float v_r3 = (p_size_ * v_r1) / v_r2;
        const float v_r5 = (c_r4_ * t * (v_r2 - v_r1)) / (v_r2 * v_r2);
        const float x_r1 = ((-1.3333334f) * v_r3) + ((-0.33333334f) * v_r5);
        const float x_r2 = ((-1.6666666f) * v_r3) + ((-0.6666667f) * v_r5);
        const float v_r6 = t + 0.005f;
        const float v_r7 = v_r6 * v_r6;
        const float v_r8 = 1.0f + v_r7;
        const float v_r9 = v_r8 * v_r8;
        const float s1 = (c_r4_ * v_r6 * (v_r8 - v_r7)) / v_r9;
        const float s2 = (v_r9 + (4.0f * v_r7 * v_r7)) - (4.0f * v_r8 * v_r6 * v_r6);
        const float s3 = (-0.33333334f) * ((c_r4_ * (s2 - (v_r8 * v_r7))) / (v_r8 * v_r9));
        const float u_r0 = ((0.33333334f * ((p_size_ * v_r7) / v_r8)) - s1) + s3;
        const float e1 = x1 - x_r1;
        const float e2 = x2 - x_r2;
        float v{};
        if (elapsed < 28U) {
            // The exact law in samples.
            const float m0 = static_cast<float>(33U - elapsed);
            const float z1 = (w1_1_ * e1) + (w1_2_ * e2);
            const float z2 = (w2_1_ * e1) + (w2_2_ * e2);
            const float s4 = (c_1_ * e1) + (c_2_ * e2);
            v = ((z1 + (z2 * m0)) / (m0 * (m0 - 1.0f))) + s4 + u_r0;
        } else {
            // Deadbeat.
            v = (b_1_ * e1) + (b_2_ * e2) + u_r0;
        }
        if (finite(v)) {
            if (v > u_max_) {
                return {u_max_, Status::Saturated};
            } else if (v < -u_max_) {
                return {-u_max_, Status::Saturated};
            } else if (elapsed < samples_) {
                return {v, Status::Ok};
            } else {
                return {v, Status::Hold};
            }
        } else {
            return {0.0f, Status::Range};
        }
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
    static constexpr float w1_1_{-137042.42f};
    /// Weight of x2 in the law.
    static constexpr float w1_2_{69031.28f};
    /// Weight of x1 in the law.
    static constexpr float w2_1_{1353.4108f};
    /// Weight of x2 in the law.
    static constexpr float w2_2_{-1082.7286f};
    /// Weight of x1 in the law.
    static constexpr float c_1_{-5.658292f};
    /// Weight of x2 in the law.
    static constexpr float c_2_{4.3266335f};
    /// Weight of x1 in the law.
    static constexpr float b_1_{-6519.427f};
    /// Weight of x2 in the law.
    static constexpr float b_2_{3185.2085f};
    /// Samples from the start to rest.
    static constexpr std::uint32_t samples_{30U};

    std::uint32_t start_{}; // tick at which it was armed
    float p_size_{}; // parameter of an expression of the design
    float c_r4_{}; // derived from the parameters
    float u_max_{}; // bound of |u|
};

} // namespace ptc

#endif
