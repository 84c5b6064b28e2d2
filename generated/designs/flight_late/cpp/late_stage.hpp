/*
 * Prescribed-time controller late_stage: order n = 2, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang cpp --n 2 --mu "exp(a=1)" --name late_stage --clock samples --delay-law=predict --poles-end="least-energy(weight=1)" --end-samples=50 --late=extend --reserve=0.1 --measured=x1 --disturbance constant --observer-poles=-4,-5,-6 --observer-samples=200 --observer-eps=0.03 --tau=0.8 --eps=0.02 --u-max=6 --poles=least-energy --g="2/3" --sample-time=1e-3 --delay=1 --sensor-step=1e-6,0
 * Version 0.1.0, design ccd999de2243.
 *
 * Plant: x1' = x2, x2' = g (u + d), d constant and unknown; u held from sample to sample, one
 *       sample late.
 * Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
 *       sample period, as long as u is not clipped and nothing else acts on the plant.
 * Law of the state x predicted for the time from which u acts, by x and the inputs under way:
 *       with M samples to go and z = S x, u h^2 = sum of row_j z_j h^(j-1)/((M-j+1)...(M-1));
 *       the rows are those of Theorem 1 for the mapping exp. From 50 samples to go on these
 *       are M - 2 and the exponents 3, 4, those of least energy. The gains of 21 samples to
 *       go stay.
 *
 * Parameters:
 *   samples = 800 [samples], fixed: samples N from the start to rest
 *   h = 1e-3 [s], fixed: sample period
 *   eps = 0.02 [s], fixed: time-to-go at which the gains are held
 *   u_max = 6 [unit of u], fixed: bound of |u|
 *   a = 1 [1/s], fixed: rate of stretched time
 *   k_1 = 6 [1/s^2], fixed: gains k_i of pi0 = -sum k_i xi_i
 *   k_2 = 5 [1/s], fixed: gains k_i of pi0 = -sum k_i xi_i
 *
 * k counts samples and may wrap; arm again within 2^32 - N samples.
 * From sample N on the last gains are held (status HOLD).
 * The estimates are exact from sample 200 after the start on where the measurement is; with
 *       noise or sensor_step given, or observer_eps, the gains of the observer are then held
 *       below deadbeat.
 * In flight: arm_for sets another deadline at any tick; rest is exact from any state, so all
 *       else stays as it is.
 * Plan: on the way to rest u and the states are sums of falling powers of the samples to go,
 *       so their Bernstein coefficients, linear in z, bound them. If these are within the
 *       limits, u stay there at every sample to rest, where plant and state are as they are
 *       known.
 * late extend: a step without such a plan raises N to the soonest that has one (status LATE;
 *       deadline gives its tick). Where none is found (status INFEASIBLE), or 2^31 samples
 *       after the start, N stays, and u is clipped; states may leave their bounds then.
 * reserve: a new deadline leaves 0.1 of each limit free.
 * |u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
 *       lasts.
 * Guard full: what is measured is finite, or the call is refused (INPUT).
 * Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
 *       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
 *
 * Checks of the design (details: ptc-codegen check):
 *   membership: sound: exp is of class M for all its parameters.
 *   growth: sound: near rest at sample 800, not at rest: the gains are held from 20 samples
 *       to go, and |u| is bounded; so does what the held observer leaves of its error.
 *   sampling: not checked: the law is exact in samples, at any period.
 *   deadline: not checked: the law is exact in samples, at any period.
 *   loop: not checked: `x0_max` is not given.
 *   envelope: not checked: it does not examine a clock in samples.
 */
#ifndef LATE_STAGE_870F6D8D_HPP
#define LATE_STAGE_870F6D8D_HPP

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
struct LateStageParams {
};

/// Controller: set by init, changed by arm and by what is not const.
class LateStage {
public:
    using Params = LateStageParams;

    /// Takes the parameters and arms at tick 0. Ok, or Param with nothing changed.
    [[nodiscard]] constexpr Status init(const Params&) noexcept
    {
        start_ = 0U;
        last_ = 800U;
        u1_ = 0.0;
        u2_ = 0.0;
        round_ = 200U;
        seen_ = 0U;
        x1_hat_ = 0.0;
        x2_hat_ = 0.0;
        d_hat_ = 0.0;
        return Status::Ok;
    }

    /// Starts again: the deadline is N samples after tick `k`. Estimates and inputs under way are
    /// kept. Estimates too large to compute with begin anew.
    constexpr void arm(std::uint32_t k) noexcept
    {
        start_ = k;
        last_ = 800U;
        round_ = 200U;
        const double size = absolute(x1_hat_) + absolute(x2_hat_) + absolute(d_hat_);
        if (!(size <= 1e150)) {
            seen_ = 0U;
            x1_hat_ = 0.0;
            x2_hat_ = 0.0;
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
        const double s1 = x1_hat_ + (phi1_2_ * x2_hat_);
        const double s2 = s1 + (phi1_3_ * d_hat_);
        const double p1 = s2 + (gamma1_ * u2_);
        const double s3 = x2_hat_ + (phi2_3_ * d_hat_);
        const double p2 = s3 + (gamma2_ * u2_);
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
        const std::uint32_t left_o = (elapsed < round_) ? (round_ - elapsed) : 0U;
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
        const double d = p3 + (l3 * miss);

        // The deadline that keeps the limits.
        std::uint32_t last_now = last_;
        std::uint32_t late = 0U;
        const std::uint32_t to_rest = (elapsed < last_) ? (last_ - elapsed) : 0U;
        const std::uint32_t ahead = (1U < to_rest) ? (to_rest - 1U) : 0U;
        const double flat1 = (s1_1_ * x1) + (s1_2_ * x2);
        const double flat2 = (s2_2_ * x2) + (u1_ + d);
        std::uint32_t low = (1U < ahead) ? (ahead - 1U) : 0U;
        std::uint32_t top = 1073741825U;
        std::uint32_t kept = 0U;
        std::uint32_t tried = ahead;
        double part = 0.9999999999998739;
        for (std::uint32_t attempt = 0U; attempt < 64U; attempt++) {
            const double least = ((-u_max_) * part) + d;
            const double most = (u_max_ * part) + d;
            const double within = (-least < most) ? -least : most;
            std::uint32_t fits = 0U;
            if (tried > 50U) {
                const double m = static_cast<double>(tried);
                const double power1 = m + 1.0;
                const double power2 = power1 * m;
                const double power3 = power2 * (m - 1.0);
                const double scaled2 = flat2 * power1;
                const double w1 = ((3.0 * flat1) + scaled2) / power2;
                const double w2 = (((-2.0) * flat1) - scaled2) / power3;
                const double length = m - 51.0;
                const double b0_c = (2.0 * w1) + (300.0 * w2);
                const double b1_c = 6.0 * w2 * length;
                const double b1 = b0_c + b1_c;
                const double end11 = (2.8506787330316743 * w1) + (117.44796380090497 * w2);
                const double end12 = (3.0475113122171944 * w1) + (145.85746606334843 * w2);
                const double end13 = (2.9906485671191554 * w1) + (175.02805429864253 * w2);
                const double end14 = (2.6800904977375564 * w1) + (204.95972850678734 * w2);
                const double end15 = (2.1158371040723982 * w1) + (235.6524886877828 * w2);
                const double end16 = (1.2978883861236803 * w1) + (267.10633484162895 * w2);
                const double end17 = (0.22624434389140272 * w1) + (299.3212669683258 * w2);
                if ((least <= b0_c)
                    && (b0_c <= most)
                    && (least <= b1)
                    && (b1 <= most)
                    && (least <= end11)
                    && (end11 <= most)
                    && (least <= end12)
                    && (end12 <= most)
                    && (least <= end13)
                    && (end13 <= most)
                    && (least <= end14)
                    && (end14 <= most)
                    && (least <= end15)
                    && (end15 <= most)
                    && (least <= end16)
                    && (end16 <= most)
                    && (least <= end17)
                    && (end17 <= most)
                    && (absolute((2.8054298642533926 * w1) + (111.58371040723979 * w2)) <= 0.9850746268656713 * within)
                    && (absolute((2.583924302196364 * w1) + (85.00144425360725 * w2)) <= 0.9850746268656713 * within)
                    && (absolute((1.9885945165034657 * w1) + (61.86959300518941 * w2)) <= 0.9850746268656713 * within)
                    && (absolute((2.9380703330283167 * w1) + (105.39729178384643 * w2)) <= 0.9850746268656713 * within)
                    && (absolute((2.395997187424203 * w1) + (77.20565274199532 * w2)) <= 0.9850746268656713 * within)
                    && (absolute((2.8712027904432142 * w1) + (99.5000219686458 * w2)) <= 0.9850746268656713 * within)) {
                    fits = 1U;
                }
            } else if (tried > 20U) {
                const double m = static_cast<double>(tried);
                const double power1 = m + 2.0;
                const double power2 = power1 * (m + 1.0);
                const double power3 = power2 * m;
                const double power4 = power3 * (m - 1.0);
                const double scaled2 = flat2 * power1;
                const double w1 = ((4.0 * flat1) + scaled2) / power3;
                const double w2 = (((-3.0) * flat1) - scaled2) / power4;
                const double length = m - 21.0;
                const double b0_c = (126.0 * w1) + (5040.0 * w2);
                const double b1_c = ((6.0 * w1) + (492.0 * w2)) * length;
                const double b2_l = length * length;
                const double b2_c = 12.0 * w2 * b2_l;
                const double b1 = b0_c + (0.16666666666666666 * b1_c);
                const double s4 = b0_c + (0.3333333333333333 * b1_c);
                const double b2 = s4 + (0.06666666666666667 * b2_c);
                const double b3 = b0_c + (0.5 * b1_c) + (0.2 * b2_c);
                const double b4 = b0_c + (0.6666666666666666 * b1_c) + (0.4 * b2_c);
                const double s5 = b0_c + (0.8333333333333334 * b1_c);
                const double b5 = s5 + (0.6666666666666666 * b2_c);
                const double b6 = b0_c + b1_c + b2_c;
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
                    && (absolute((119.99999999999996 * w1) + (4559.999999999999 * w2)) <= 0.9850746268656713 * within)
                    && (absolute((92.75321716019634 * w1) + (2422.754466594877 * w2)) <= 0.9850746268656713 * within)
                    && (absolute((67.8353765546998 * w1) + (1509.7849977027897 * w2)) <= 0.9850746268656713 * within)
                    && (absolute((114.21150278293138 * w1) + (3629.3877551020414 * w2)) <= 0.9850746268656713 * within)
                    && (absolute((84.39364430426792 * w1) + (2085.179889377806 * w2)) <= 0.9850746268656713 * within)
                    && (absolute((108.11363033997543 * w1) + (3196.9332337421392 * w2)) <= 0.9850746268656713 * within)) {
                    fits = 1U;
                }
            } else if ((absolute(((-0.025974025974025976) * flat1) - (0.2857142857142857 * flat2)) <= 0.9850746268656713 * within)
                && (absolute(((-0.0012475444042476065) * flat1) - (0.08276232337733669 * flat2)) <= 0.9850746268656713 * within)
                && (absolute((0.0035664936491730252 * flat1) - (0.02768331367963576 * flat2)) <= 0.9850746268656713 * within)
                && (absolute(((-0.012577404043081223) * flat1) - (0.18287834614365228 * flat2)) <= 0.9850746268656713 * within)
                && (absolute((0.000902126332826074 * flat1) - (0.060363489673773814 * flat2)) <= 0.9850746268656713 * within)
                && (absolute(((-0.007827317130259085) * flat1) - (0.14320479414568998 * flat2)) <= 0.9850746268656713 * within)) {
                fits = 1U;
            }
            if (fits == 1U) {
                kept = tried;
                top = tried;
            } else if (tried > 20U) {
                low = tried;
            } else {
                low = 20U;
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
            part = 0.899999999999773;
        }
        if ((ahead < kept) && (elapsed < 2147483648U)) {
            last_now = (elapsed + kept) + 1U;
        }
        if ((kept == 0U) && (ahead > 0U)) {
            late = 2U;
        }
        if (last_now > last_) {
            late = 1U;
        }
        const std::uint32_t left = (elapsed < last_now) ? (last_now - elapsed) : 0U;
        const double s6 = static_cast<double>(left) - 1.0;
        const double m0 = (s6 < hold_) ? hold_ : s6;
        double v{};
        if (m0 > end_samples_) {
            // The exact law in samples.
            const double z1 = (w1_1_ * x1) + (w1_2_ * x2);
            const double z2 = (w2_2_ * x2) + (w2_3_ * (u1_ + d));
            const double m0f1 = m0 + 1.0;
            v = ((z1 + (z2 * m0f1)) / (m0f1 * m0)) - d;
        } else {
            // The law of least energy to the end.
            const double m1 = (m0 < 2.0) ? 2.0 : m0;
            const double y1 = (end1_1_ * x1) + (end1_2_ * x2);
            const double y2 = (end2_2_ * x2) + (end2_3_ * (u1_ + d));
            const double m1f1 = m1 + 2.0;
            v = ((y1 + (y2 * m1f1)) / (m1f1 * (m1 + 1.0))) - d;
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
        last_ = last_now;
        x1_hat_ = x1;
        x2_hat_ = x2;
        d_hat_ = d;
        seen_ = 1U;
        if ((v > u_max_) || (v < -u_max_)) {
            return {u_now, Status::Saturated};
        } else if (static_cast<double>(left) - 1.0 <= hold_) {
            return {u_now, Status::Hold};
        } else if (late == 2U) {
            return {u_now, Status::Infeasible};
        } else if (late == 1U) {
            return {u_now, Status::Late};
        } else {
            return {u_now, Status::Ok};
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
        const std::uint32_t elapsed = k - start_;
        round_ = (elapsed < round_) ? (round_ - elapsed) : 0U;
        start_ = k;
        last_ = samples;
        return Status::Ok;
    }

    /// The fewest samples found, from the next call of `step` on, with which the law keeps u and
    /// the states within their limits at every sample to rest, from the estimates as they are
    /// predicted for the next tick, for sure. Give them to `arm_for`.
    /// On a negative status u is 0 and nothing has changed.
    constexpr Value<std::uint32_t> soonest() const noexcept
    {
        const double s1 = x1_hat_ + (phi1_2_ * x2_hat_);
        const double s2 = s1 + (phi1_3_ * d_hat_);
        const double p1 = s2 + (gamma1_ * u2_);
        const double s3 = x2_hat_ + (phi2_3_ * d_hat_);
        const double p2 = s3 + (gamma2_ * u2_);
        const double p3 = d_hat_;
        const double x1 = p1;
        const double x2 = p2;
        const double d = p3;
        const double flat1 = (s1_1_ * x1) + (s1_2_ * x2);
        const double flat2 = (s2_2_ * x2) + (u1_ + d);
        std::uint32_t low = 20U;
        std::uint32_t top = 1073741825U;
        std::uint32_t kept = 0U;
        std::uint32_t tried = 21U;
        for (std::uint32_t attempt = 0U; attempt < 64U; attempt++) {
            const double least = (0.899999999999773 * (-u_max_)) + d;
            const double most = (0.899999999999773 * u_max_) + d;
            const double within = (-least < most) ? -least : most;
            std::uint32_t fits = 0U;
            if (tried > 50U) {
                const double m = static_cast<double>(tried);
                const double power1 = m + 1.0;
                const double power2 = power1 * m;
                const double power3 = power2 * (m - 1.0);
                const double scaled2 = flat2 * power1;
                const double w1 = ((3.0 * flat1) + scaled2) / power2;
                const double w2 = (((-2.0) * flat1) - scaled2) / power3;
                const double length = m - 51.0;
                const double b0_c = (2.0 * w1) + (300.0 * w2);
                const double b1_c = 6.0 * w2 * length;
                const double b1 = b0_c + b1_c;
                const double end11 = (2.8506787330316743 * w1) + (117.44796380090497 * w2);
                const double end12 = (3.0475113122171944 * w1) + (145.85746606334843 * w2);
                const double end13 = (2.9906485671191554 * w1) + (175.02805429864253 * w2);
                const double end14 = (2.6800904977375564 * w1) + (204.95972850678734 * w2);
                const double end15 = (2.1158371040723982 * w1) + (235.6524886877828 * w2);
                const double end16 = (1.2978883861236803 * w1) + (267.10633484162895 * w2);
                const double end17 = (0.22624434389140272 * w1) + (299.3212669683258 * w2);
                if ((least <= b0_c)
                    && (b0_c <= most)
                    && (least <= b1)
                    && (b1 <= most)
                    && (least <= end11)
                    && (end11 <= most)
                    && (least <= end12)
                    && (end12 <= most)
                    && (least <= end13)
                    && (end13 <= most)
                    && (least <= end14)
                    && (end14 <= most)
                    && (least <= end15)
                    && (end15 <= most)
                    && (least <= end16)
                    && (end16 <= most)
                    && (least <= end17)
                    && (end17 <= most)
                    && (absolute((2.8054298642533926 * w1) + (111.58371040723979 * w2)) <= 0.9850746268656713 * within)
                    && (absolute((2.583924302196364 * w1) + (85.00144425360725 * w2)) <= 0.9850746268656713 * within)
                    && (absolute((1.9885945165034657 * w1) + (61.86959300518941 * w2)) <= 0.9850746268656713 * within)
                    && (absolute((2.9380703330283167 * w1) + (105.39729178384643 * w2)) <= 0.9850746268656713 * within)
                    && (absolute((2.395997187424203 * w1) + (77.20565274199532 * w2)) <= 0.9850746268656713 * within)
                    && (absolute((2.8712027904432142 * w1) + (99.5000219686458 * w2)) <= 0.9850746268656713 * within)) {
                    fits = 1U;
                }
            } else {
                const double m = static_cast<double>(tried);
                const double power1 = m + 2.0;
                const double power2 = power1 * (m + 1.0);
                const double power3 = power2 * m;
                const double power4 = power3 * (m - 1.0);
                const double scaled2 = flat2 * power1;
                const double w1 = ((4.0 * flat1) + scaled2) / power3;
                const double w2 = (((-3.0) * flat1) - scaled2) / power4;
                const double length = m - 21.0;
                const double b0_c = (126.0 * w1) + (5040.0 * w2);
                const double b1_c = ((6.0 * w1) + (492.0 * w2)) * length;
                const double b2_l = length * length;
                const double b2_c = 12.0 * w2 * b2_l;
                const double b1 = b0_c + (0.16666666666666666 * b1_c);
                const double s4 = b0_c + (0.3333333333333333 * b1_c);
                const double b2 = s4 + (0.06666666666666667 * b2_c);
                const double b3 = b0_c + (0.5 * b1_c) + (0.2 * b2_c);
                const double b4 = b0_c + (0.6666666666666666 * b1_c) + (0.4 * b2_c);
                const double s5 = b0_c + (0.8333333333333334 * b1_c);
                const double b5 = s5 + (0.6666666666666666 * b2_c);
                const double b6 = b0_c + b1_c + b2_c;
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
                    && (absolute((119.99999999999996 * w1) + (4559.999999999999 * w2)) <= 0.9850746268656713 * within)
                    && (absolute((92.75321716019634 * w1) + (2422.754466594877 * w2)) <= 0.9850746268656713 * within)
                    && (absolute((67.8353765546998 * w1) + (1509.7849977027897 * w2)) <= 0.9850746268656713 * within)
                    && (absolute((114.21150278293138 * w1) + (3629.3877551020414 * w2)) <= 0.9850746268656713 * within)
                    && (absolute((84.39364430426792 * w1) + (2085.179889377806 * w2)) <= 0.9850746268656713 * within)
                    && (absolute((108.11363033997543 * w1) + (3196.9332337421392 * w2)) <= 0.9850746268656713 * within)) {
                    fits = 1U;
                }
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
        if (finite(flat1) && finite(flat2)) {
            if (kept > 0U) {
                return {kept + 1U, Status::Ok};
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

    /// The target moves by `dx`: from now on y is measured from the new one, and so are the
    /// estimates.
    /// Ok, or Param with nothing changed.
    [[nodiscard]] constexpr Status move(double dx) noexcept
    {
        const double moved = x1_hat_ - dx;
        if (!finite(moved)) {
            return Status::Input;
        }
        x1_hat_ = moved;
        return Status::Ok;
    }

    /// The estimates at the tick of the next call are known: it corrects them by what is measured
    /// then.
    /// Ok, or Param with nothing changed.
    [[nodiscard]] constexpr Status assume(const std::array<double, 2>& xhat) noexcept
    {
        const double g1 = xhat[0] - (gamma1_ * u2_);
        const double g2 = xhat[1] - (gamma2_ * u2_);
        const double n1 = g1 + (back1_2_ * g2) + (back1_3_ * d_hat_);
        const double n2 = g2 + (back2_3_ * d_hat_);
        if (!(finite(n1) && finite(n2))) {
            return Status::Input;
        }
        x1_hat_ = n1;
        x2_hat_ = n2;
        seen_ = 1U;
        return Status::Ok;
    }

    /// The constant that is added to u is known.
    /// Ok, or Param with nothing changed.
    [[nodiscard]] constexpr Status assume_disturbance(double d) noexcept
    {
        if (!finite(d)) {
            return Status::Input;
        }
        d_hat_ = d;
        return Status::Ok;
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
    /// 1/1000, prediction of x1 from x2.
    static constexpr double phi1_2_{0.001};
    /// 1/3000000, prediction of x1 from d.
    static constexpr double phi1_3_{3.3333333333333335e-7};
    /// 1/3000000, prediction from u.
    static constexpr double gamma1_{3.3333333333333335e-7};
    /// 1/1500, prediction of x2 from d.
    static constexpr double phi2_3_{0.0006666666666666666};
    /// 1/1500, prediction from u.
    static constexpr double gamma2_{0.0006666666666666666};
    /// Samples to go at which the observer is held.
    static constexpr double hold_o_{30.0};
    /// Weight in the observer's gain l1.
    static constexpr double q1_1_{120.0};
    /// Weight in the observer's gain l1.
    static constexpr double q1_2_{-60.0};
    /// Weight in the observer's gain l1.
    static constexpr double q1_3_{12.0};
    /// Weight in the observer's gain l2.
    static constexpr double q2_1_{-108000.0};
    /// Weight in the observer's gain l2.
    static constexpr double q2_2_{36000.0};
    /// Weight in the observer's gain l3.
    static constexpr double q3_1_{36000000.0};
    /// Weight of x1 in the law.
    static constexpr double s1_1_{1500000.0};
    /// Weight of x2 in the law.
    static constexpr double s1_2_{750.0};
    /// Weight of x2 in the law.
    static constexpr double s2_2_{1500.0};
    /// Bound of |u|.
    static constexpr double u_max_{6.0};
    /// Samples to go at which the gains are held.
    static constexpr double hold_{20.0};
    /// Samples to go at which the law of the end takes over.
    static constexpr double end_samples_{50.0};
    /// Weight of x1 in the law.
    static constexpr double w1_1_{-9000000.0};
    /// Weight of x2 in the law.
    static constexpr double w1_2_{-4500.0};
    /// Weight of x2 in the law.
    static constexpr double w2_2_{-6000.0};
    /// Weight of u1 in the law.
    static constexpr double w2_3_{-4.0};
    /// Weight of x1 in the law.
    static constexpr double end1_1_{-18000000.0};
    /// Weight of x2 in the law.
    static constexpr double end1_2_{-9000.0};
    /// Weight of x2 in the law.
    static constexpr double end2_2_{-9000.0};
    /// Weight of u1 in the law.
    static constexpr double end2_3_{-6.0};
    /// -1/1000, a state of a sample ago.
    static constexpr double back1_2_{-0.001};
    /// 1/3000000, a state of a sample ago.
    static constexpr double back1_3_{3.3333333333333335e-7};
    /// -1/1500, a state of a sample ago.
    static constexpr double back2_3_{-0.0006666666666666666};

    std::uint32_t start_{}; // tick at which it was armed
    std::uint32_t last_{}; // samples from the start to rest, as planned now
    double u1_{}; // input of the last sample
    double u2_{}; // input of 2 samples ago
    std::uint32_t round_{}; // samples of the observer's round left at the start
    std::uint32_t seen_{}; // 1 once y has been measured
    double x1_hat_{}; // estimate of x1
    double x2_hat_{}; // estimate of x2
    double d_hat_{}; // estimate of d
};

} // namespace ptc

#endif
