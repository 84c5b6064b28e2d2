/*
 * Prescribed-time controller stage48: order n = 3, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang cpp --n 3 --mu "exp(a=1)" --name stage48 --clock samples --A="[[0,1,0],[0,-0.5,1500],[0,-15,-600]]" --B="[0,0,500]" --C="[[1,0,0]]" --delay-law=predict --disturbance constant --observer-poles=-4,-5,-6,-7 --observer-samples=50 --tau=0.1 --eps=0.006 --u-max=24 --poles=least-energy --sample-time=1e-3 --delay=1.5
 * Version 0.1.0, design 62df3f06bf2c.
 *
 * Plant: x' = A x + B (u + d), d constant and unknown of --A and --B above; u held from
 *       sample to sample, 1.5 samples late, y = C x.
 * Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
 *       sample period, as long as u is not clipped and nothing else acts on the plant.
 * Law of the state x predicted for the time from which u acts, by x and the inputs under way:
 *       u = -K_M x with M samples to go, of all inputs that end at rest those with the least
 *       sum of u^2. The gains are a table of 1344 bytes: exact below 32 samples to go, and
 *       before it those of a grid of 56 nodes, interpolated in a line. The gains of 8 samples
 *       to go stay.
 *
 * Parameters:
 *   samples = 100 [samples], fixed: samples N from the start to rest
 *   h = 1e-3 [s], fixed: sample period
 *   eps = 0.006 [s], fixed: time-to-go at which the gains are held
 *   u_max = 24 [unit of u], fixed: bound of |u|
 *   a = 1 [1/s], fixed: rate of stretched time
 *
 * k counts samples and may wrap; arm again within 2^32 - N samples.
 * From sample N on the last gains are held (status HOLD).
 * The estimates are exact from sample 50 after the start on where the measurement is; with
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
 *   growth: sound: near rest at sample 100, not at rest: the gains are held from 6 samples to
 *       go, and |u| is bounded.
 *   sampling: not checked: the law is exact in samples, at any period.
 *   deadline: not checked: the law is exact in samples, at any period.
 *   loop: not checked: `x0_max` is not given.
 *   envelope: not checked: it does not examine a clock in samples.
 */
#ifndef STAGE48_875730E5_HPP
#define STAGE48_875730E5_HPP

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
struct Stage48Params {
};

/// Controller: set by init, changed by arm and by what is not const.
class Stage48 {
public:
    using Params = Stage48Params;

    /// Takes the parameters and arms at tick 0. Ok, or Param with nothing changed.
    [[nodiscard]] constexpr Status init(const Params&) noexcept
    {
        start_ = 0U;
        u1_ = 0.0;
        u2_ = 0.0;
        u3_ = 0.0;
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
            const double s1 = (gamma1_ * u3_) + (late_gamma1_ * u2_);
            x1 = x1_next_ + s1;
            const double s2 = (gamma2_ * u3_) + (late_gamma2_ * u2_);
            x2 = x2_next_ + s2;
            const double s3 = (gamma3_ * u3_) + (late_gamma3_ * u2_);
            x3 = x3_next_ + s3;
            d = d_next_;
        }

        // Prediction of the next sample.
        const double miss1 = y[0] - x1;
        const double off1 = miss1;
        const std::uint32_t left_o = (elapsed < observer_samples_) ? (observer_samples_ - elapsed) : 0U;
        const double o0 = static_cast<double>(left_o);
        double l1{};
        double l2{};
        double l3{};
        double l4{};
        if (o0 > 10.0) {
            const double o0f2 = o0 * (o0 - 1.0);
            const double o0f3 = o0f2 * (o0 - 2.0);
            const double r0 = 1.0 / (o0f3 * (o0 - 3.0));
            const double s4 = q1_1_ + (q1_2_ * o0) + (q1_3_ * o0f2);
            l1 = ((s4 + (q1_4_ * o0f3)) * r0) - 0.46857164949780494;
            const double s5 = q2_1_ + (q2_2_ * o0) + (q2_3_ * o0f2);
            l2 = ((s5 + (q2_4_ * o0f3)) * r0) + 264.4187821124759;
            const double s6 = q3_1_ + (q3_2_ * o0) + (q3_3_ * o0f2);
            l3 = ((s6 + (q3_4_ * o0f3)) * r0) - 98.64522377262374;
            l4 = q4_1_ * r0;
        } else if (left_o == 10U) {
            l1 = e0_1_;
            l2 = e0_2_;
            l3 = e0_3_;
            l4 = e0_4_;
        } else if (left_o == 9U) {
            l1 = e1_1_;
            l2 = e1_2_;
            l3 = e1_3_;
            l4 = e1_4_;
        } else if (left_o == 8U) {
            l1 = e2_1_;
            l2 = e2_2_;
            l3 = e2_3_;
            l4 = e2_4_;
        } else {
            l1 = e3_1_;
            l2 = e3_2_;
            l3 = e3_3_;
            l4 = e3_4_;
        }
        const double s7 = x1 + (phi1_2_ * x2) + (phi1_3_ * x3);
        const double x1_on = s7 + (phi1_4_ * d) + (l1 * off1);
        const double s8 = (phi2_2_ * x2) + (phi2_3_ * x3);
        const double x2_on = s8 + (phi2_4_ * d) + (l2 * off1);
        const double s9 = (phi3_2_ * x2) + (phi3_3_ * x3);
        const double x3_on = s9 + (phi3_4_ * d) + (l3 * off1);
        const double d_on = d + (l4 * off1);
        const std::uint32_t left = (elapsed < samples_) ? (samples_ - elapsed) : 0U;
        const std::uint32_t planned = (2U < left) ? (left - 2U) : 0U;
        std::uint32_t to_go{};
        if (planned > 6U) {
            to_go = planned;
        } else {
            to_go = 6U;
        }

        // Its place between the nodes of the table.
        std::uint32_t row{};
        double part{};
        if (to_go < 32U) {
            row = to_go - 3U;
            part = 0.0;
        } else if (to_go < 64U) {
            row = (to_go / 2U) + 13U;
            part = (0.5 * static_cast<double>(to_go)) - static_cast<double>(to_go / 2U);
        } else {
            row = (to_go / 4U) + 29U;
            part = (0.25 * static_cast<double>(to_go)) - static_cast<double>(to_go / 4U);
        }

        // The state from which this input acts.
        const double s10 = x1 + (0.0014892124792996978 * x2);
        const double s11 = 0.00010816330676811052 * (u1_ + d);
        const double s12 = s10 + (0.0012719952989597699 * x3) + s11;
        const double p1 = s12 + (0.0002327420309725346 * (u2_ + d));
        const double s13 = (0.9801754642759536 * x2) + (1.4706215395736848 * x3);
        const double s14 = s13 + (0.30941358230147875 * (u1_ + d));
        const double p2 = s14 + (0.32658406717840616 * (u2_ + d));
        const double s15 = ((-0.014706215395736848) * x2) + (0.39241705562633755 * x3);
        const double s16 = s15 + (0.37459048481653323 * (u1_ + d));
        const double p3 = s16 + (0.11582869425785502 * (u2_ + d));

        // The law of least energy.
        const std::uint32_t above = row + 1U;
        double v{};
        const double s17 = part * (gains_[above][0] - gains_[row][0]);
        const double s18 = part * (gains_[above][1] - gains_[row][1]);
        const double s19 = (gains_[row][0] + s17) * p1;
        const double s20 = part * (gains_[above][2] - gains_[row][2]);
        const double s21 = s19 + ((gains_[row][1] + s18) * p2);
        v = (s21 + ((gains_[row][2] + s20) * p3)) - d;
        if (!(finite(v) && finite(x1_on) && finite(x2_on) && finite(x3_on) && finite(d_on))) {
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
        x1_hat_ = x1;
        x1_next_ = x1_on;
        x2_hat_ = x2;
        x2_next_ = x2_on;
        x3_hat_ = x3;
        x3_next_ = x3_on;
        d_hat_ = d;
        d_next_ = d_on;
        seen_ = 1U;
        if ((v > u_max_) || (v < -u_max_)) {
            return {u_now, Status::Saturated};
        } else if (static_cast<double>(left) - 2.0 <= hold_) {
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
    /// Prediction from u.
    static constexpr double gamma1_{9.364814153170347e-5};
    /// Prediction from u.
    static constexpr double late_gamma1_{1.4515165236407059e-5};
    /// Prediction from u.
    static constexpr double gamma2_{0.22442191668610964};
    /// Prediction from u.
    static constexpr double late_gamma2_{0.08499166561536914};
    /// Prediction from u.
    static constexpr double gamma3_{0.15880778157427425};
    /// Prediction from u.
    static constexpr double late_gamma3_{0.21578270324225896};
    /// Samples of the round of the observer.
    static constexpr std::uint32_t observer_samples_{50U};
    /// Weight in the observer's gain l1.
    static constexpr double q1_1_{-96.0};
    /// Weight in the observer's gain l1.
    static constexpr double q1_2_{96.0};
    /// Weight in the observer's gain l1.
    static constexpr double q1_3_{-48.0};
    /// Weight in the observer's gain l1.
    static constexpr double q1_4_{16.0};
    /// Weight in the observer's gain l2.
    static constexpr double q2_1_{859382.9277311233};
    /// Weight in the observer's gain l2.
    static constexpr double q2_2_{-513847.60335174634};
    /// Weight in the observer's gain l2.
    static constexpr double q2_3_{125558.23800330989};
    /// Weight in the observer's gain l2.
    static constexpr double q2_4_{-9808.939721535125};
    /// Weight in the observer's gain l3.
    static constexpr double q3_1_{-620544.0922410007};
    /// Weight in the observer's gain l3.
    static constexpr double q3_2_{289368.54342637886};
    /// Weight in the observer's gain l3.
    static constexpr double q3_3_{-49493.69520132396};
    /// Weight in the observer's gain l3.
    static constexpr double q3_4_{3680.3758886140504};
    /// Weight in the observer's gain l4.
    static constexpr double q4_1_{42644.35104284018};
    /// Gain of the observer at its end.
    static constexpr double e0_1_{1.1314283505021951};
    /// Gain of the observer at its end.
    static constexpr double e0_2_{219.51265205459217};
    /// Gain of the observer at its end.
    static constexpr double e0_3_{75.63157806817};
    /// Gain of the observer at its end.
    static constexpr double e0_4_{-118.45653067455605};
    /// Gain of the observer at its end.
    static constexpr double e1_1_{1.3092061282799727};
    /// Gain of the observer at its end.
    static constexpr double e1_2_{248.77479213018773};
    /// Gain of the observer at its end.
    static constexpr double e1_3_{58.354009083621726};
    /// Gain of the observer at its end.
    static constexpr double e1_4_{789.7102044970403};
    /// Gain of the observer at its end.
    static constexpr double e2_1_{1.531428350502195};
    /// Gain of the observer at its end.
    static constexpr double e2_2_{-7.605455274169628};
    /// Gain of the observer at its end.
    static constexpr double e2_3_{-864.4162017900436};
    /// Gain of the observer at its end.
    static constexpr double e2_4_{-1776.8479601183408};
    /// Gain of the observer at its end.
    static constexpr double e3_1_{3.5314283505021953};
    /// Gain of the observer at its end.
    static constexpr double e3_2_{3400.952825738043};
    /// Gain of the observer at its end.
    static constexpr double e3_3_{1206.9697918675683};
    /// Gain of the observer at its end.
    static constexpr double e3_4_{1776.8479601183408};
    /// Prediction of x1 from x2.
    static constexpr double phi1_2_{0.000996505559752715};
    /// Prediction of x1 from x3.
    static constexpr double phi1_3_{0.0006188271646029575};
    /// Prediction of x1 from d.
    static constexpr double phi1_4_{0.00010816330676811052};
    /// Prediction of x2 from x2.
    static constexpr double phi2_2_{0.9902193397510792};
    /// Prediction of x2 from x3.
    static constexpr double phi2_3_{1.1234620408672982};
    /// Prediction of x2 from d.
    static constexpr double phi2_4_{0.30941358230147875};
    /// Prediction of x3 from x2.
    static constexpr double phi3_2_{-0.011234620408672982};
    /// Prediction of x3 from x3.
    static constexpr double phi3_3_{0.5412090107511158};
    /// Prediction of x3 from d.
    static constexpr double phi3_4_{0.37459048481653323};
    /// Samples from the start to rest.
    static constexpr std::uint32_t samples_{100U};
    /// Bound of |u|.
    static constexpr double u_max_{24.0};
    /// Samples to go at which the gains are held.
    static constexpr double hold_{6.0};

    /// Gains of least energy of each state, a row for the samples to go of a node.
    static constexpr std::array<std::array<double, 3>, 56> gains_{{
        {{-1776.8479601183408, -3.433673119968826, -3.4085582810122124}},
        {{-888.4239800591704, -2.2396226199294076, -2.668895474474135}},
        {{-509.8205499917047, -1.5836352486541563, -2.156303199309816}},
        {{-321.2435999059375, -1.1847458154993364, -1.7840105694740966}},
        {{-216.68093346707525, -0.9242259566604598, -1.5043723951168144}},
        {{-153.9422258341114, -0.7447029385976519, -1.2887857385166759}},
        {{-113.93847902814913, -0.6156792469819268, -1.1190107322495595}},
        {{-87.16471846485014, -0.5197354647522179, -0.9828886639258793}},
        {{-68.52151427846083, -0.4463449878262189, -0.8720333492968331}},
        {{-55.10393872697146, -0.3888498994276202, -0.7805015513958865}},
        {{-45.17340922131986, -0.3428771962392912, -0.7039866926831448}},
        {{-37.645338987867255, -0.3054615992281757, -0.6393092191236842}},
        {{-31.81875620585758, -0.27453657915024465, -0.5840834223761374}},
        {{-27.22654280812768, -0.2486271922797076, -0.5364934991038854}},
        {{-23.548974074041762, -0.22665835728982042, -0.4951395241819548}},
        {{-20.56197731368738, -0.20783163893706613, -0.45892943480696}},
        {{-18.10517741827105, -0.1915440040702233, -0.4270020121187187}},
        {{-16.06160501852228, -0.17733302260561387, -0.3986711637229456}},
        {{-14.34448653985888, -0.16483914791668344, -0.3733850940635477}},
        {{-12.888450440068087, -0.15377927419458942, -0.3506960346235246}},
        {{-11.643553902420525, -0.14392788889388677, -0.3302375620042263}},
        {{-10.57115019711518, -0.13510343327021376, -0.31170743224482}},
        {{-9.640981134457023, -0.12715829319637273, -0.29485446816108246}},
        {{-8.829099689315191, -0.11997135875672672, -0.27946845400384207}},
        {{-8.116364548493685, -0.11344242686372868, -0.2653722821336554}},
        {{-7.4873347145655345, -0.10748794327334095, -0.2524158008059736}},
        {{-6.92944791969951, -0.10203772969328963, -0.24047095757682826}},
        {{-6.432403034640657, -0.09703244352848328, -0.22942793730857275}},
        {{-5.987690902669893, -0.0924215882293794, -0.21919206948913653}},
        {{-5.588234402434218, -0.08816194151833531, -0.20968133494671454}},
        {{-4.90232886736555, -0.08055249332977393, -0.19255867915280173}},
        {{-4.337531609573391, -0.07396200145641044, -0.17758866382046176}},
        {{-3.866962043305151, -0.06820607163189224, -0.1644055236605839}},
        {{-3.470790749314056, -0.06314188514263996, -0.1527212184490728}},
        {{-3.134134775751522, -0.058657163866628094, -0.14230591997800468}},
        {{-2.845649743939376, -0.05466245582716187, -0.13297406684879373}},
        {{-2.5965675236180417, -0.051085636807956664, -0.12457422819671518}},
        {{-2.380025558008824, -0.04786792242488202, -0.11698162121891839}},
        {{-2.1905911599741885, -0.044960929582640426, -0.11009250906350342}},
        {{-2.02391866730071, -0.04232447977954594, -0.10381995183425959}},
        {{-1.8764987244836007, -0.039924935245840495, -0.09809054528111931}},
        {{-1.7454724729656579, -0.03773392339710073, -0.09284188997856772}},
        {{-1.6284921470217775, -0.03572734808777426, -0.08802060737537329}},
        {{-1.523615296707974, -0.03388461531195422, -0.08358076988701066}},
        {{-1.4292236830261014, -0.03218802108556842, -0.07948264775619424}},
        {{-1.3439604848291826, -0.03062226328182328, -0.07569170062633748}},
        {{-1.1964152124156797, -0.02783177725314643, -0.06891436097083738}},
        {{-1.0737303961538518, -0.025425601240773896, -0.06304865259045363}},
        {{-0.970591182471621, -0.02333597818938725, -0.057938311673843924}},
        {{-0.8830294618645727, -0.021509684264473847, -0.053459600787556544}},
        {{-0.8080344337031824, -0.01990435940283023, -0.04951333308196541}},
        {{-0.7432884532951157, -0.01848589655966577, -0.04601913572216292}},
        {{-0.6869841398708345, -0.017226549374695407, -0.04291125081794763}},
        {{-0.6376953878667164, -0.01610353745589099, -0.04013541272877522}},
        {{-0.5942848639897524, -0.01509800278331475, -0.03764649228065479}},
        {{-0.5558366565985665, -0.014194218062618705, -0.035406696215788895}},
    }};

    std::uint32_t start_{}; // tick at which it was armed
    double u1_{}; // input of the last sample
    double u2_{}; // input of 2 samples ago
    double u3_{}; // input of 3 samples ago
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
