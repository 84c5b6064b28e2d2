/*
 * Prescribed-time controller stage50: order n = 2, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang cpp --n 2 --mu "exp(a=1)" --name stage50 --clock samples --A="[[-1,1],[3,-2]]" --B="[1,2]" --output="[-2,1]" --tau=0.2 --eps=0 --poles="least-energy(weight=1)" --reference input --sample-time=0.01
 * Version 0.1.0, design e09f892711c5.
 *
 * Plant: x' = A x + B u of --A and --B above; u held from sample to sample.
 * Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
 *       sample period, as long as u is not clipped and nothing else acts on the plant.
 * Law: u = -K_M x with M samples to go, of all inputs that end at rest those with the least
 *       sum of u^2/M. The gains are a table of 320 bytes: a row for each of them. The gains
 *       of 2 samples to go stay: they are deadbeat.
 * With the reference r with its derivatives r[0]..r[1] at tick k, x - x_r is in place of x
 *       above, and u = w + u_r: with them the output y = -2*x1 + x2 is r, and stays so. At
 *       sample N x = x_r where u_r is constant over each sample; else an error of order
 *       h^(4-i) is left in y^(i-1).
 * r[2] is r^(2) over the sample in which u acts: its mean, (r^(1)(t + h) - r^(1)(t))/h, or
 *       that in its middle. u_r is the mean over that sample. To four digits, the last at one
 *       time:
 *   x_r1 = -1.333*r - 0.3333*r^(1)
 *   x_r2 = -1.667*r - 0.6667*r^(1)
 *   u_r = 0.3333*r - r^(1) - 0.3333*r^(2)
 *
 * Parameters:
 *   samples = 20 [samples], fixed: samples N from the start to rest
 *   h = 0.01 [s], fixed: sample period
 *   eps = 0 [s], fixed: time-to-go at which the gains are held
 *   u_max [unit of u]: bound of |u|
 *   a = 1 [1/s], fixed: rate of stretched time
 *
 * k counts samples and may wrap; arm again within 2^32 - N samples.
 * From sample N on the last gains are held (status HOLD).
 * |u| <= u_max: u is clipped to it (status SATURATED). Clipping voids the deadline where it
 *       lasts.
 * Guard full: what is measured and the reference are finite, or the call is refused (INPUT).
 * Precision f64 (IEEE 754 binary64). Results are bit for bit the same on every IEEE 754
 *       machine without fused multiply-add (gcc, clang: -ffp-contract=off).
 *
 * Checks of the design (details: ptc-codegen check):
 *   membership: sound: exp is of class M for all its parameters.
 *   growth: sound: at rest at sample 20 from any state, but for what r does between samples,
 *       and |u| is bounded.
 *   sampling: not checked: `loop` bounds what the period leaves of a reference that moves.
 *   deadline: not checked: `loop` bounds what the period leaves of a reference that moves.
 *   loop: not checked: `x0_max` is not given.
 *   envelope: not checked: it does not examine a clock in samples.
 */
#ifndef STAGE50_8C26CF8F_HPP
#define STAGE50_8C26CF8F_HPP

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
struct Stage50Params {
    double u_max{}; ///< bound of |u| [unit of u], > 0, infinity allowed
};

/// Controller: set by init, changed by arm and by what is not const.
class Stage50 {
public:
    using Params = Stage50Params;

    /// Takes the parameters and arms at tick 0. Ok, or Param with nothing changed.
    [[nodiscard]] constexpr Status init(const Params& params) noexcept
    {
        if (!(params.u_max > 0.0)) {
            return Status::Param;
        }
        const double u_max = params.u_max;
        start_ = 0U;
        u_max_ = u_max;
        return Status::Ok;
    }

    /// Starts again: the deadline is N samples after tick `k`.
    constexpr void arm(std::uint32_t k) noexcept
    {
        start_ = k;
    }

    /// u from tick `k`, which may wrap, and the state x, and the reference.
    /// On a negative status u is 0 and nothing has changed.
    constexpr Control<double> step(std::uint32_t k, const std::array<double, 2>& x, const std::array<double, 3>& r) const noexcept
    {
        if (!(finite(x[0]) && finite(x[1]) && finite(r[0]) && finite(r[1]) && finite(r[2]))) {
            return {0.0, Status::Input};
        }
        const std::uint32_t elapsed = k - start_;
        const double x1 = x[0];
        const double x2 = x[1];

        // The tracking error.
        const double s1 = (0.3333333333333333 * r[0]) - (0.9983333333333333 * r[1]);
        const double u_r = s1 - (0.3383277777777778 * r[2]);
        const double e1 = x1 - (((-1.3333333333333333) * r[0]) - (0.3333333333333333 * r[1]));
        const double e2 = x2 - (((-1.6666666666666667) * r[0]) - (0.6666666666666666 * r[1]));
        const std::uint32_t left = (elapsed < samples_) ? (samples_ - elapsed) : 0U;
        std::uint32_t to_go{};
        if (left > 2U) {
            to_go = left;
        } else {
            to_go = 2U;
        }
        const std::uint32_t row = to_go - 2U;

        // The law of least energy.
        double v{};
        v = (gains_[row][0] * e1) + (gains_[row][1] * e2) + u_r;
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
            return {0.0, Status::Range};
        }
    }

private:
    /// std::isfinite is not constexpr in C++17.
    static constexpr bool finite(double v) noexcept
    {
        return (v >= std::numeric_limits<double>::lowest()) && (v <= (std::numeric_limits<double>::max)());
    }
    /// Samples from the start to rest.
    static constexpr std::uint32_t samples_{20U};

    /// Gains of least energy of each state, a row for the samples to go of a node.
    static constexpr std::array<std::array<double, 2>, 20> gains_{{
        {{-6519.426971737549, 3185.2084972182897}},
        {{-3857.2972468681514, 1869.370005740587}},
        {{-2535.8123523502322, 1218.7874484331383}},
        {{-1786.1499004408652, 851.2162504195531}},
        {{-1321.0288432240525, 624.1015587650261}},
        {{-1013.2253140462395, 474.4353779733671}},
        {{-799.355679292144, 370.8885689114117}},
        {{-644.9715751559836, 296.46788779068544}},
        {{-530.0507637726341, 241.31624608777554}},
        {{-442.31657026726884, 199.40198143585195}},
        {{-373.9055837746926, 166.86960699606502}},
        {{-319.59468864669316, 141.16347188259604}},
        {{-275.80616425447823, 120.53665432938753}},
        {{-240.02385825378445, 103.76315424562416}},
        {{-210.4372644374064, 89.96267023338274}},
        {{-185.7172734991974, 78.4903488691879}},
        {{-164.8707644351536, 68.86539241539502}},
        {{-147.1439010804336, 60.72364441333584}},
        {{-131.95635856841344, 53.785384714229195}},
        {{-118.85567957234355, 47.83301161237331}},
    }};

    std::uint32_t start_{}; // tick at which it was armed
    double u_max_{}; // bound of |u|
};

} // namespace ptc

#endif
