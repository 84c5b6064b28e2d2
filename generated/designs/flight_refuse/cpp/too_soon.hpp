/*
 * Prescribed-time controller too_soon: order n = 3, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang cpp --n 3 --mu "exp(a=1)" --name too_soon --clock samples --late=refuse --state-max=inf,0.5,4 --precision f32 --tau=1.5 --eps=0 --u-max=20 --poles="least-energy(weight=1)" --sample-time=0.01
 * Version 0.1.0, design 9b0d3c826af2.
 *
 * Plant: x1' = x2, ..., x3' = u; u held from sample to sample.
 * Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
 *       sample period, as long as u is not clipped and nothing else acts on the plant.
 * Law: with M - 3 samples to go and z = S x, u h^3 = sum of row_j z_j
 *       h^(j-1)/((M-j+1)...(M-2)); the rows are those of Theorem 1 for the mapping exp. The
 *       gains of 3 samples to go stay: they are deadbeat.
 *
 * Parameters:
 *   samples = 150 [samples], fixed: samples N from the start to rest
 *   h = 0.01 [s], fixed: sample period
 *   eps = 0 [s], fixed: time-to-go at which the gains are held
 *   u_max = 20 [unit of u], fixed: bound of |u|
 *   a = 1 [1/s], fixed: rate of stretched time
 *   k_1 = 120 [1/s^3], fixed: gains k_i of pi0 = -sum k_i xi_i
 *   k_2 = 74 [1/s^2], fixed: gains k_i of pi0 = -sum k_i xi_i
 *   k_3 = 15 [1/s], fixed: gains k_i of pi0 = -sum k_i xi_i
 *
 * k counts samples and may wrap; arm again within 2^32 - N samples.
 * From sample N on the last gains are held (status HOLD).
 * In flight: arm_for sets another deadline at any tick; rest is exact from any state, so all
 *       else stays as it is.
 * Plan: on the way to rest u and the states are sums of falling powers of the samples to go,
 *       so their Bernstein coefficients, linear in z, bound them. If these are within the
 *       limits, u and |x2| <= 0.5 and |x3| <= 4 stay there at every sample to rest, where
 *       plant and state are as they are known.
 * late refuse: arm_for refuses a deadline without such a plan (status E_SOON).
 * |u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
 *       lasts.
 * Guard full: what is measured is finite, or the call is refused (INPUT).
 * Precision f32 (IEEE 754 binary32). Results are bit for bit the same on every IEEE 754
 *       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
 *
 * Checks of the design (details: ptc-codegen check):
 *   membership: sound: exp is of class M for all its parameters.
 *   growth: sound: at rest at sample 150 from any state, whatever the poles, and |u| is
 *       bounded.
 *   sampling: not checked: the law is exact in samples, at any period.
 *   deadline: not checked: the law is exact in samples, at any period.
 *   loop: not checked: `x0_max` is not given.
 *   envelope: not checked: it does not examine a clock in samples.
 */
#ifndef TOO_SOON_426931A1_HPP
#define TOO_SOON_426931A1_HPP

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
struct TooSoonParams {
};

/// Controller: set by init, changed by arm and by what is not const.
class TooSoon {
public:
    using Params = TooSoonParams;

    /// Takes the parameters and arms at tick 0. Ok, or Param with nothing changed.
    [[nodiscard]] constexpr Status init(const Params&) noexcept
    {
        start_ = 0U;
        last_ = 150U;
        return Status::Ok;
    }

    /// Starts again: the deadline is N samples after tick `k`.
    constexpr void arm(std::uint32_t k) noexcept
    {
        start_ = k;
        last_ = 150U;
    }

    /// u from tick `k`, which may wrap, and the state x = (x1, x1', ...).
    /// On a negative status u is 0 and nothing has changed.
    constexpr Control<float> step(std::uint32_t k, const std::array<float, 3>& x) const noexcept
    {
        if (!(finite(x[0]) && finite(x[1]) && finite(x[2]))) {
            return {0.0f, Status::Input};
        }
        const std::uint32_t elapsed = k - start_;
        const float x1 = x[0];
        const float x2 = x[1];
        const float x3 = x[2];
        const std::uint32_t left = (elapsed < last_) ? (last_ - elapsed) : 0U;
        const float m0 = (static_cast<float>(left) < 3.0f) ? 3.0f : static_cast<float>(left);
        float v{};

        // The exact law in samples.
        const float z1 = (w1_1_ * x1) + (w1_2_ * x2) + (w1_3_ * x3);
        const float z2 = (w2_2_ * x2) + (w2_3_ * x3);
        const float z3 = w3_3_ * x3;
        const float m0f1 = m0 + 3.0f;
        const float m0f2 = m0f1 * (m0 + 2.0f);
        v = (z1 + (z2 * m0f1) + (z3 * m0f2)) / (m0f2 * (m0 + 1.0f));
        if (finite(v)) {
            if (v > u_max_) {
                return {u_max_, Status::Saturated};
            } else if (v < -u_max_) {
                return {-u_max_, Status::Saturated};
            } else if (elapsed < last_) {
                return {v, Status::Ok};
            } else {
                return {v, Status::Hold};
            }
        } else {
            return {0.0f, Status::Range};
        }
    }

    /// Another deadline, at any tick before the call of `step` at it: rest at tick `k` + `samples`,
    /// 3 to 2147483648 samples. A deadline before which a limit could be exceeded is refused
    /// (E_SOON).
    /// Ok, or Param with nothing changed.
    [[nodiscard]] constexpr Status arm_for(std::uint32_t k, std::uint32_t samples, const std::array<float, 3>& x) noexcept
    {
        if (!((samples > 2U) && (samples < 2147483649U))) {
            return Status::Param;
        }
        if (!(finite(x[0]) && finite(x[1]) && finite(x[2]))) {
            return Status::Input;
        }
        const float x1 = x[0];
        const float x2 = x[1];
        const float x3 = x[2];
        const float flat1 = (s1_1_ * x1) + (s1_2_ * x2) + (s1_3_ * x3);
        const float flat2 = (s2_2_ * x2) + (s2_3_ * x3);
        const float flat3 = s3_3_ * x3;
        const float least = 0.9949459f * (-u_max_);
        const float most = 0.9949459f * u_max_;
        const float most2 = 0.49747294f;
        const float most3 = 3.9797835f;
        const std::uint32_t tried = samples;
        std::uint32_t fits = 0U;
        const float m = static_cast<float>(tried);
        const float power1 = m + 3.0f;
        const float power2 = power1 * (m + 2.0f);
        const float power3 = power2 * (m + 1.0f);
        const float power4 = power3 * m;
        const float power5 = power4 * (m - 1.0f);
        const float power6 = power5 * (m - 2.0f);
        const float scaled2 = flat2 * power1;
        const float scaled3 = flat3 * power2;
        const float w1 = ((15.0f * flat1) + (5.0f * scaled2) + (0.5f * scaled3)) / power4;
        const float w2 = ((((-24.0f) * flat1) - (9.0f * scaled2)) - scaled3) / power5;
        const float w3 = ((10.0f * flat1) + (4.0f * scaled2) + (0.5f * scaled3)) / power6;
        const float length = m - 4.0f;
        const float b0_c = (((-96.0f) * w1) - (720.0f * w2)) - (2880.0f * w3);
        const float b1_c = ((((-24.0f) * w1) - (420.0f * w2)) - (3120.0f * w3)) * length;
        const float b2_l = length * length;
        const float b2_c = (((-60.0f) * w2) - (1080.0f * w3)) * b2_l;
        const float b3_l = b2_l * length;
        const float b3_c = (-120.0f) * w3 * b3_l;
        const float b1 = b0_c + (0.14285715f * b1_c);
        const float b2 = b0_c + (0.2857143f * b1_c) + (0.04761905f * b2_c);
        const float s10 = b0_c + (0.42857143f * b1_c) + (0.14285715f * b2_c);
        const float b3 = s10 + (0.028571429f * b3_c);
        const float s11 = b0_c + (0.5714286f * b1_c) + (0.2857143f * b2_c);
        const float b4 = s11 + (0.114285715f * b3_c);
        const float s12 = b0_c + (0.71428573f * b1_c) + (0.47619048f * b2_c);
        const float b5 = s12 + (0.2857143f * b3_c);
        const float s13 = b0_c + (0.85714287f * b1_c) + (0.71428573f * b2_c);
        const float b6 = s13 + (0.5714286f * b3_c);
        const float b7 = b0_c + b1_c + b2_c + b3_c;
        const float s0_c = (((-0.036f) * w1) - (0.12f * w2)) - (0.252f * w3);
        const float s1_c = ((((-0.0242f) * w1) - (0.124f * w2)) - (0.3954f * w3)) * length;
        const float s2_l = length * length;
        const float s2_c = ((((-0.0054f) * w1) - (0.0475f * w2)) - (0.2415f * w3)) * s2_l;
        const float s3_l = s2_l * length;
        const float s3_c = ((((-0.0004f) * w1) - (0.008f * w2)) - (0.072f * w3)) * s3_l;
        const float s4_l = s3_l * length;
        const float s4_c = (((-0.0005f) * w2) - (0.0105f * w3)) * s4_l;
        const float s5_l = s4_l * length;
        const float s5_c = (-0.0006f) * w3 * s5_l;
        const float s1 = s0_c + (0.11111111f * s1_c);
        const float s2 = s0_c + (0.22222222f * s1_c) + (0.027777778f * s2_c);
        const float s14 = s0_c + (0.33333334f * s1_c) + (0.083333336f * s2_c);
        const float s3 = s14 + (0.011904762f * s3_c);
        const float s15 = s0_c + (0.44444445f * s1_c) + (0.16666667f * s2_c);
        const float s4 = s15 + (0.04761905f * s3_c) + (0.007936508f * s4_c);
        const float s16 = s0_c + (0.5555556f * s1_c) + (0.2777778f * s2_c);
        const float s17 = s16 + (0.11904762f * s3_c) + (0.03968254f * s4_c);
        const float s5 = s17 + (0.007936508f * s5_c);
        const float s18 = s0_c + (0.6666667f * s1_c) + (0.41666666f * s2_c);
        const float s19 = s18 + (0.23809524f * s3_c) + (0.11904762f * s4_c);
        const float s6 = s19 + (0.04761905f * s5_c);
        const float s20 = s0_c + (0.7777778f * s1_c) + (0.5833333f * s2_c);
        const float s21 = s20 + (0.41666666f * s3_c) + (0.2777778f * s4_c);
        const float s7 = s21 + (0.16666667f * s5_c);
        const float s22 = s0_c + (0.8888889f * s1_c) + (0.7777778f * s2_c);
        const float s23 = s22 + (0.6666667f * s3_c) + (0.5555556f * s4_c);
        const float s8 = s23 + (0.44444445f * s5_c);
        const float s9 = s0_c + s1_c + s2_c + s3_c + s4_c + s5_c;
        const float v0_c = (2.4f * w1) + (12.0f * w2) + (36.0f * w3);
        const float v1_c = ((1.08f * w1) + (9.4f * w2) + (46.2f * w3)) * length;
        const float v2_l = length * length;
        const float v2_c = ((0.12f * w1) + (2.4f * w2) + (21.3f * w3)) * v2_l;
        const float v3_l = v2_l * length;
        const float v3_c = ((0.2f * w2) + (4.2f * w3)) * v3_l;
        const float v4_l = v3_l * length;
        const float v4_c = 0.3f * w3 * v4_l;
        const float v1 = v0_c + (0.125f * v1_c);
        const float v2 = v0_c + (0.25f * v1_c) + (0.035714287f * v2_c);
        const float s24 = v0_c + (0.375f * v1_c) + (0.10714286f * v2_c);
        const float v3 = s24 + (0.017857144f * v3_c);
        const float s25 = v0_c + (0.5f * v1_c) + (0.21428572f * v2_c) + (0.071428575f * v3_c);
        const float v4 = s25 + (0.014285714f * v4_c);
        const float s26 = v0_c + (0.625f * v1_c) + (0.35714287f * v2_c) + (0.17857143f * v3_c);
        const float v5 = s26 + (0.071428575f * v4_c);
        const float s27 = v0_c + (0.75f * v1_c) + (0.53571427f * v2_c) + (0.35714287f * v3_c);
        const float v6 = s27 + (0.21428572f * v4_c);
        const float s28 = v0_c + (0.875f * v1_c) + (0.75f * v2_c) + (0.625f * v3_c);
        const float v7 = s28 + (0.5f * v4_c);
        const float v8 = v0_c + v1_c + v2_c + v3_c + v4_c;
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
            && (-most2 <= s0_c)
            && (s0_c <= most2)
            && (-most2 <= s1)
            && (s1 <= most2)
            && (-most2 <= s2)
            && (s2 <= most2)
            && (-most2 <= s3)
            && (s3 <= most2)
            && (-most2 <= s4)
            && (s4 <= most2)
            && (-most2 <= s5)
            && (s5 <= most2)
            && (-most2 <= s6)
            && (s6 <= most2)
            && (-most2 <= s7)
            && (s7 <= most2)
            && (-most2 <= s8)
            && (s8 <= most2)
            && (-most2 <= s9)
            && (s9 <= most2)
            && (-most3 <= v0_c)
            && (v0_c <= most3)
            && (-most3 <= v1)
            && (v1 <= most3)
            && (-most3 <= v2)
            && (v2 <= most3)
            && (-most3 <= v3)
            && (v3 <= most3)
            && (-most3 <= v4)
            && (v4 <= most3)
            && (-most3 <= v5)
            && (v5 <= most3)
            && (-most3 <= v6)
            && (v6 <= most3)
            && (-most3 <= v7)
            && (v7 <= most3)
            && (-most3 <= v8)
            && (v8 <= most3)
            && (absolute((((-72.0f) * w1) - (360.0f * w2)) - (720.0f * w3)) <= most)
            && (absolute(((-48.0f) * w1) - (120.0f * w2)) <= most)
            && (absolute((-24.0f) * w1) <= most)
            && (absolute((((-0.0168f) * w1) - (0.036f * w2)) - (0.036f * w3)) <= most2)
            && (absolute((((-0.006f) * w1) - (0.006f * w2)) + (4.8789098e-18f * w3)) <= most2)
            && (absolute(((-0.0012f) * w1) + (4.8789098e-18f * w2) + (4.8789098e-18f * w3)) <= most2)
            && (absolute((1.44f * w1) + (4.8f * w2) + (7.2f * w3)) <= most3)
            && (absolute(((0.72f * w1) + (1.2f * w2)) - (1.2490009e-15f * w3)) <= most3)
            && (absolute((0.24f * w1) + (2.9143354e-15f * w2) + (3.7470027e-15f * w3)) <= most3)) {
            fits = 1U;
        }
        if (!((tried > 3U) && (tried < 100001U) && (fits == 1U))) {
            return Status::Soon;
        }
        start_ = k;
        last_ = samples;
        return Status::Ok;
    }

    /// The fewest samples found, from the next call of `step` on, with which the law keeps u and
    /// the states within their limits at every sample to rest, from the state x, for sure. Give
    /// them to `arm_for`.
    /// On a negative status u is 0 and nothing has changed.
    constexpr Value<std::uint32_t> soonest(const std::array<float, 3>& x) const noexcept
    {
        if (!(finite(x[0]) && finite(x[1]) && finite(x[2]))) {
            return {0, Status::Input};
        }
        const float x1 = x[0];
        const float x2 = x[1];
        const float x3 = x[2];
        const float flat1 = (s1_1_ * x1) + (s1_2_ * x2) + (s1_3_ * x3);
        const float flat2 = (s2_2_ * x2) + (s2_3_ * x3);
        const float flat3 = s3_3_ * x3;
        std::uint32_t low = 3U;
        std::uint32_t top = 100001U;
        std::uint32_t kept = 0U;
        std::uint32_t tried = 4U;
        for (std::uint32_t attempt = 0U; attempt < 64U; attempt++) {
            const float least = 0.9949459f * (-u_max_);
            const float most = 0.9949459f * u_max_;
            const float most2 = 0.49747294f;
            const float most3 = 3.9797835f;
            std::uint32_t fits = 0U;
            const float m = static_cast<float>(tried);
            const float power1 = m + 3.0f;
            const float power2 = power1 * (m + 2.0f);
            const float power3 = power2 * (m + 1.0f);
            const float power4 = power3 * m;
            const float power5 = power4 * (m - 1.0f);
            const float power6 = power5 * (m - 2.0f);
            const float scaled2 = flat2 * power1;
            const float scaled3 = flat3 * power2;
            const float w1 = ((15.0f * flat1) + (5.0f * scaled2) + (0.5f * scaled3)) / power4;
            const float w2 = ((((-24.0f) * flat1) - (9.0f * scaled2)) - scaled3) / power5;
            const float w3 = ((10.0f * flat1) + (4.0f * scaled2) + (0.5f * scaled3)) / power6;
            const float length = m - 4.0f;
            const float b0_c = (((-96.0f) * w1) - (720.0f * w2)) - (2880.0f * w3);
            const float b1_c = ((((-24.0f) * w1) - (420.0f * w2)) - (3120.0f * w3)) * length;
            const float b2_l = length * length;
            const float b2_c = (((-60.0f) * w2) - (1080.0f * w3)) * b2_l;
            const float b3_l = b2_l * length;
            const float b3_c = (-120.0f) * w3 * b3_l;
            const float b1 = b0_c + (0.14285715f * b1_c);
            const float b2 = b0_c + (0.2857143f * b1_c) + (0.04761905f * b2_c);
            const float s10 = b0_c + (0.42857143f * b1_c) + (0.14285715f * b2_c);
            const float b3 = s10 + (0.028571429f * b3_c);
            const float s11 = b0_c + (0.5714286f * b1_c) + (0.2857143f * b2_c);
            const float b4 = s11 + (0.114285715f * b3_c);
            const float s12 = b0_c + (0.71428573f * b1_c) + (0.47619048f * b2_c);
            const float b5 = s12 + (0.2857143f * b3_c);
            const float s13 = b0_c + (0.85714287f * b1_c) + (0.71428573f * b2_c);
            const float b6 = s13 + (0.5714286f * b3_c);
            const float b7 = b0_c + b1_c + b2_c + b3_c;
            const float s0_c = (((-0.036f) * w1) - (0.12f * w2)) - (0.252f * w3);
            const float s1_c = ((((-0.0242f) * w1) - (0.124f * w2)) - (0.3954f * w3)) * length;
            const float s2_l = length * length;
            const float s2_c = ((((-0.0054f) * w1) - (0.0475f * w2)) - (0.2415f * w3)) * s2_l;
            const float s3_l = s2_l * length;
            const float s3_c = ((((-0.0004f) * w1) - (0.008f * w2)) - (0.072f * w3)) * s3_l;
            const float s4_l = s3_l * length;
            const float s4_c = (((-0.0005f) * w2) - (0.0105f * w3)) * s4_l;
            const float s5_l = s4_l * length;
            const float s5_c = (-0.0006f) * w3 * s5_l;
            const float s1 = s0_c + (0.11111111f * s1_c);
            const float s2 = s0_c + (0.22222222f * s1_c) + (0.027777778f * s2_c);
            const float s14 = s0_c + (0.33333334f * s1_c) + (0.083333336f * s2_c);
            const float s3 = s14 + (0.011904762f * s3_c);
            const float s15 = s0_c + (0.44444445f * s1_c) + (0.16666667f * s2_c);
            const float s4 = s15 + (0.04761905f * s3_c) + (0.007936508f * s4_c);
            const float s16 = s0_c + (0.5555556f * s1_c) + (0.2777778f * s2_c);
            const float s17 = s16 + (0.11904762f * s3_c) + (0.03968254f * s4_c);
            const float s5 = s17 + (0.007936508f * s5_c);
            const float s18 = s0_c + (0.6666667f * s1_c) + (0.41666666f * s2_c);
            const float s19 = s18 + (0.23809524f * s3_c) + (0.11904762f * s4_c);
            const float s6 = s19 + (0.04761905f * s5_c);
            const float s20 = s0_c + (0.7777778f * s1_c) + (0.5833333f * s2_c);
            const float s21 = s20 + (0.41666666f * s3_c) + (0.2777778f * s4_c);
            const float s7 = s21 + (0.16666667f * s5_c);
            const float s22 = s0_c + (0.8888889f * s1_c) + (0.7777778f * s2_c);
            const float s23 = s22 + (0.6666667f * s3_c) + (0.5555556f * s4_c);
            const float s8 = s23 + (0.44444445f * s5_c);
            const float s9 = s0_c + s1_c + s2_c + s3_c + s4_c + s5_c;
            const float v0_c = (2.4f * w1) + (12.0f * w2) + (36.0f * w3);
            const float v1_c = ((1.08f * w1) + (9.4f * w2) + (46.2f * w3)) * length;
            const float v2_l = length * length;
            const float v2_c = ((0.12f * w1) + (2.4f * w2) + (21.3f * w3)) * v2_l;
            const float v3_l = v2_l * length;
            const float v3_c = ((0.2f * w2) + (4.2f * w3)) * v3_l;
            const float v4_l = v3_l * length;
            const float v4_c = 0.3f * w3 * v4_l;
            const float v1 = v0_c + (0.125f * v1_c);
            const float v2 = v0_c + (0.25f * v1_c) + (0.035714287f * v2_c);
            const float s24 = v0_c + (0.375f * v1_c) + (0.10714286f * v2_c);
            const float v3 = s24 + (0.017857144f * v3_c);
            const float s25 = v0_c + (0.5f * v1_c) + (0.21428572f * v2_c) + (0.071428575f * v3_c);
            const float v4 = s25 + (0.014285714f * v4_c);
            const float s26 = v0_c + (0.625f * v1_c) + (0.35714287f * v2_c) + (0.17857143f * v3_c);
            const float v5 = s26 + (0.071428575f * v4_c);
            const float s27 = v0_c + (0.75f * v1_c) + (0.53571427f * v2_c) + (0.35714287f * v3_c);
            const float v6 = s27 + (0.21428572f * v4_c);
            const float s28 = v0_c + (0.875f * v1_c) + (0.75f * v2_c) + (0.625f * v3_c);
            const float v7 = s28 + (0.5f * v4_c);
            const float v8 = v0_c + v1_c + v2_c + v3_c + v4_c;
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
                && (-most2 <= s0_c)
                && (s0_c <= most2)
                && (-most2 <= s1)
                && (s1 <= most2)
                && (-most2 <= s2)
                && (s2 <= most2)
                && (-most2 <= s3)
                && (s3 <= most2)
                && (-most2 <= s4)
                && (s4 <= most2)
                && (-most2 <= s5)
                && (s5 <= most2)
                && (-most2 <= s6)
                && (s6 <= most2)
                && (-most2 <= s7)
                && (s7 <= most2)
                && (-most2 <= s8)
                && (s8 <= most2)
                && (-most2 <= s9)
                && (s9 <= most2)
                && (-most3 <= v0_c)
                && (v0_c <= most3)
                && (-most3 <= v1)
                && (v1 <= most3)
                && (-most3 <= v2)
                && (v2 <= most3)
                && (-most3 <= v3)
                && (v3 <= most3)
                && (-most3 <= v4)
                && (v4 <= most3)
                && (-most3 <= v5)
                && (v5 <= most3)
                && (-most3 <= v6)
                && (v6 <= most3)
                && (-most3 <= v7)
                && (v7 <= most3)
                && (-most3 <= v8)
                && (v8 <= most3)
                && (absolute((((-72.0f) * w1) - (360.0f * w2)) - (720.0f * w3)) <= most)
                && (absolute(((-48.0f) * w1) - (120.0f * w2)) <= most)
                && (absolute((-24.0f) * w1) <= most)
                && (absolute((((-0.0168f) * w1) - (0.036f * w2)) - (0.036f * w3)) <= most2)
                && (absolute((((-0.006f) * w1) - (0.006f * w2)) + (4.8789098e-18f * w3)) <= most2)
                && (absolute(((-0.0012f) * w1) + (4.8789098e-18f * w2) + (4.8789098e-18f * w3)) <= most2)
                && (absolute((1.44f * w1) + (4.8f * w2) + (7.2f * w3)) <= most3)
                && (absolute(((0.72f * w1) + (1.2f * w2)) - (1.2490009e-15f * w3)) <= most3)
                && (absolute((0.24f * w1) + (2.9143354e-15f * w2) + (3.7470027e-15f * w3)) <= most3)) {
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
    /// Weight of x1 in the law.
    static constexpr float w1_1_{-120000000.0f};
    /// Weight of x2 in the law.
    static constexpr float w1_2_{1200000.0f};
    /// Weight of x3 in the law.
    static constexpr float w1_3_{-4000.0f};
    /// Weight of x2 in the law.
    static constexpr float w2_2_{-600000.0f};
    /// Weight of x3 in the law.
    static constexpr float w2_3_{3000.0f};
    /// Weight of x3 in the law.
    static constexpr float w3_3_{-1200.0f};
    /// Bound of |u|.
    static constexpr float u_max_{20.0f};
    /// Weight of x1 in the law.
    static constexpr float s1_1_{1000000.0f};
    /// Weight of x2 in the law.
    static constexpr float s1_2_{-10000.0f};
    /// 100/3, weight of x3 in the law.
    static constexpr float s1_3_{33.333332f};
    /// Weight of x2 in the law.
    static constexpr float s2_2_{10000.0f};
    /// Weight of x3 in the law.
    static constexpr float s2_3_{-50.0f};
    /// Weight of x3 in the law.
    static constexpr float s3_3_{100.0f};

    std::uint32_t start_{}; // tick at which it was armed
    std::uint32_t last_{}; // samples from the start to rest, as planned now
};

} // namespace ptc

#endif
