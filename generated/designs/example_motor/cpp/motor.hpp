/*
 * Prescribed-time controller motor: order n = 3, clock in samples.
 *
 * DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang cpp --n 3 --mu "exp(a=1)" --name motor --clock samples --A="[[0,1,0],[0,-0.5,1500],[0,-15,-600]]" --B="[0,0,500]" --C="[[1,0,0]]" --delay-law=predict --disturbance constant --observer-poles=-4,-5,-6,-7 --observer-samples=150 --observer-eps=0.04 --tau=0.4 --eps=0.02 --u-max=24 --poles="least-energy(weight=2)" --sample-time=1e-3 --delay=1 --sensor-step=6e-6
 * Version 0.1.0, design 2a5220d7c7d8.
 *
 * Plant: x' = A x + B (u + d), d constant and unknown of --A and --B above; u held from
 *       sample to sample, one sample late, y = C x.
 * Goal: x = 0 at sample N after the start, exact up to rounding, from any state and at any
 *       sample period, as long as u is not clipped and nothing else acts on the plant.
 * Law of the state x predicted for the time from which u acts, by x and the inputs under way:
 *       u = -K_M x with M samples to go, of all inputs that end at rest those with the least
 *       sum of u^2/(M ... (M+1)). The gains are a table of 2112 bytes: exact below 32 samples
 *       to go, and before it those of a grid of 88 nodes, interpolated in a line. The gains
 *       of 21 samples to go stay.
 *
 * Parameters:
 *   samples = 400 [samples], fixed: samples N from the start to rest
 *   h = 1e-3 [s], fixed: sample period
 *   eps = 0.02 [s], fixed: time-to-go at which the gains are held
 *   u_max = 24 [unit of u], fixed: bound of |u|
 *   a = 1 [1/s], fixed: rate of stretched time
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
#ifndef MOTOR_DD76C865_HPP
#define MOTOR_DD76C865_HPP

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
            x1 = x1_next_ + (gamma1_ * u2_);
            x2 = x2_next_ + (gamma2_ * u2_);
            x3 = x3_next_ + (gamma3_ * u2_);
            d = d_next_;
        }

        // Prediction of the next sample.
        const double miss1 = y[0] - x1;
        const double off1 = miss1;
        const std::uint32_t left_o = (elapsed < observer_samples_) ? (observer_samples_ - elapsed) : 0U;
        const double o0 = (static_cast<double>(left_o) < hold_o_) ? hold_o_ : static_cast<double>(left_o);
        double l1{};
        double l2{};
        double l3{};
        double l4{};
        const double o0f2 = o0 * (o0 - 1.0);
        const double o0f3 = o0f2 * (o0 - 2.0);
        const double r0 = 1.0 / (o0f3 * (o0 - 3.0));
        const double s1 = q1_1_ + (q1_2_ * o0) + (q1_3_ * o0f2);
        l1 = ((s1 + (q1_4_ * o0f3)) * r0) - 0.46857164949780494;
        const double s2 = q2_1_ + (q2_2_ * o0) + (q2_3_ * o0f2);
        l2 = ((s2 + (q2_4_ * o0f3)) * r0) + 264.4187821124759;
        const double s3 = q3_1_ + (q3_2_ * o0) + (q3_3_ * o0f2);
        l3 = ((s3 + (q3_4_ * o0f3)) * r0) - 98.64522377262374;
        l4 = q4_1_ * r0;
        const double s4 = x1 + (phi1_2_ * x2) + (phi1_3_ * x3);
        const double x1_on = s4 + (phi1_4_ * d) + (l1 * off1);
        const double s5 = (phi2_2_ * x2) + (phi2_3_ * x3);
        const double x2_on = s5 + (phi2_4_ * d) + (l2 * off1);
        const double s6 = (phi3_2_ * x2) + (phi3_3_ * x3);
        const double x3_on = s6 + (phi3_4_ * d) + (l3 * off1);
        const double d_on = d + (l4 * off1);
        const std::uint32_t left = (elapsed < samples_) ? (samples_ - elapsed) : 0U;
        const std::uint32_t planned = (1U < left) ? (left - 1U) : 0U;
        std::uint32_t to_go{};
        if (planned > 20U) {
            to_go = planned;
        } else {
            to_go = 20U;
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
        } else if (to_go < 128U) {
            row = (to_go / 4U) + 29U;
            part = (0.25 * static_cast<double>(to_go)) - static_cast<double>(to_go / 4U);
        } else if (to_go < 256U) {
            row = (to_go / 8U) + 45U;
            part = (0.125 * static_cast<double>(to_go)) - static_cast<double>(to_go / 8U);
        } else {
            row = (to_go / 16U) + 61U;
            part = (0.0625 * static_cast<double>(to_go)) - static_cast<double>(to_go / 16U);
        }

        // The state from which this input acts.
        const double s7 = x1 + (0.000996505559752715 * x2) + (0.0006188271646029575 * x3);
        const double p1 = s7 + (0.00010816330676811052 * (u1_ + d));
        const double s8 = (0.9902193397510792 * x2) + (1.1234620408672982 * x3);
        const double p2 = s8 + (0.30941358230147875 * (u1_ + d));
        const double s9 = ((-0.011234620408672982) * x2) + (0.5412090107511158 * x3);
        const double p3 = s9 + (0.37459048481653323 * (u1_ + d));

        // The law of least energy.
        const std::uint32_t above = row + 1U;
        double v{};
        const double s10 = part * (gains_[above][0] - gains_[row][0]);
        const double s11 = part * (gains_[above][1] - gains_[row][1]);
        const double s12 = (gains_[row][0] + s10) * p1;
        const double s13 = part * (gains_[above][2] - gains_[row][2]);
        const double s14 = s12 + ((gains_[row][1] + s11) * p2);
        v = (s14 + ((gains_[row][2] + s13) * p3)) - d;
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
        } else if (static_cast<double>(left) - 1.0 <= hold_) {
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
    static constexpr double gamma1_{0.00010816330676811052};
    /// Prediction from u.
    static constexpr double gamma2_{0.30941358230147875};
    /// Prediction from u.
    static constexpr double gamma3_{0.37459048481653323};
    /// Samples of the round of the observer.
    static constexpr std::uint32_t observer_samples_{150U};
    /// Samples to go at which the observer is held.
    static constexpr double hold_o_{40.0};
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
    static constexpr std::uint32_t samples_{400U};
    /// Bound of |u|.
    static constexpr double u_max_{24.0};
    /// Samples to go at which the gains are held.
    static constexpr double hold_{20.0};

    /// Gains of least energy of each state, a row for the samples to go of a node.
    static constexpr std::array<std::array<double, 3>, 88> gains_{{
        {{-1776.8479601183408, -3.433673119968826, -3.4085582810122124}},
        {{-1089.2855660713828, -2.5792538324475585, -2.92715620435224}},
        {{-715.1097776720381, -2.005268116785936, -2.5379317120700415}},
        {{-494.95285763541585, -1.6039167324374313, -2.220199839032561}},
        {{-357.3880718570257, -1.31380805149398, -1.9585623640689978}},
        {{-267.1996825586806, -1.098176456897036, -1.7413581865092544}},
        {{-205.68910041563595, -0.934030901408559, -1.5596487398641914}},
        {{-162.32003662246422, -0.8064560539564851, -1.4065087720571303}},
        {{-130.8587713317818, -0.7054687263312741, -1.2765216589021253}},
        {{-107.46356640472325, -0.6242062303411349, -1.1654158102501366}},
        {{-89.6832288274182, -0.5578412955540902, -1.0697990210360293}},
        {{-75.90627252608341, -0.5029097859456781, -0.9869613689864624}},
        {{-65.04518231831996, -0.45688161590965487, -0.9147267369479838}},
        {{-56.348873339179654, -0.4178796566170861, -0.8513394385098589}},
        {{-49.28777883721612, -0.3844913311440051, -0.7953766746302587}},
        {{-43.481487103886096, -0.35563977177489164, -0.7456803485752753}},
        {{-38.652053478900314, -0.3304941351900456, -0.70130361771621}},
        {{-34.59321725150104, -0.30840618699988964, -0.6614688027166578}},
        {{-31.149704862289127, -0.28886482779590356, -0.6255341277872658}},
        {{-28.203065658180382, -0.27146306931059916, -0.5929673690396564}},
        {{-25.661819927173966, -0.25587377335889633, -0.5633249276142321}},
        {{-23.454503331202414, -0.2418316372933554, -0.5362351731835312}},
        {{-21.524687865701647, -0.2291196839285042, -0.5113851546074136}},
        {{-19.82737149256077, -0.21755903423392625, -0.48850996901608346}},
        {{-18.32632847221013, -0.20700109598969532, -0.4673842324771343}},
        {{-16.992142612265372, -0.19732154685278322, -0.4478152145054596}},
        {{-15.800731757950414, -0.18841566178533486, -0.4296372922162896}},
        {{-14.732229610927645, -0.18019465601352325, -0.41270745338642967}},
        {{-13.770130221219006, -0.1725828012034134, -0.3969016353447562}},
        {{-12.900627507501603, -0.1655151348503219, -0.38211173182343144}},
        {{-11.394711901902335, -0.1527957106102675, -0.35521271035287216}},
        {{-10.141049219434281, -0.14167070006977625, -0.3313814014980151}},
        {{-9.0859382187617, -0.13186043523889596, -0.31012500418563205}},
        {{-8.189345280178369, -0.12314740197880317, -0.291051941766111}},
        {{-7.4209119024392, -0.1153598671926937, -0.2738470715910652}},
        {{-6.757263185703688, -0.10836040805188914, -0.25825381348164067}},
        {{-6.180154034498657, -0.10203772110752699, -0.24406106274895106}},
        {{-5.675167336369847, -0.0963006708178401, -0.2310934652306333}},
        {{-5.23078354245966, -0.09107389593679792, -0.21920409124134224}},
        {{-4.837704973413569, -0.08629451847735992, -0.2082688462665139}},
        {{-4.488357907712668, -0.08190964551549022, -0.1981821563022114}},
        {{-4.176520752701599, -0.07787444952242385, -0.18885360074286894}},
        {{-3.897042956242042, -0.0741506765876409, -0.18020525813059907}},
        {{-3.645630112311628, -0.07070547509517439, -0.17216959422296677}},
        {{-3.418677959919714, -0.06751046718170695, -0.16468776695227477}},
        {{-3.213142915211289, -0.0645410061123608, -0.15770825498484048}},
        {{-2.8563629827678154, -0.05919531249241354, -0.14508018771857667}},
        {{-2.5587724714829676, -0.054525708484506843, -0.13398184231601154}},
        {{-2.308113620148721, -0.05042067250716002, -0.12417284151494208}},
        {{-2.0951329204844162, -0.04679171196401641, -0.1154601789139411}},
        {{-1.9127379597653626, -0.04356766177924224, -0.1076869671269336}},
        {{-1.7554185685093087, -0.04069060588997639, -0.10072427243750298}},
        {{-1.6188414539850762, -0.038112906049917065, -0.09446508810364408}},
        {{-1.499561227614519, -0.03579500166341945, -0.08881981793367545}},
        {{-1.3948110724320861, -0.033703756369920845, -0.08371284469957926}},
        {{-1.302348878102034, -0.031811198751691146, -0.07907988985096792}},
        {{-1.2203426350575814, -0.030093551392916203, -0.07486595850246795}},
        {{-1.1472840267845936, -0.028530473771209493, -0.07102372282687533}},
        {{-1.0819225499528982, -0.027104465688876877, -0.06751223767064869}},
        {{-1.0232147646198977, -0.02580039260729931, -0.0642959106283311}},
        {{-0.9702848242470944, -0.02460510452137872, -0.06134366895222488}},
        {{-0.9223935046222815, -0.02350712731311073, -0.05862828013477268}},
        {{-0.8393108842117797, -0.021564121362904712, -0.053815077953051585}},
        {{-0.7699698793361764, -0.019904570963388015, -0.049696282750678666}},
        {{-0.7114197610619046, -0.01847628415495611, -0.04614604998760003}},
        {{-0.6614486843911724, -0.017238069994469484, -0.04306450036887954}},
        {{-0.618376040841814, -0.01615714175448534, -0.040371749956062936}},
        {{-0.580909230835424, -0.015207210674377572, -0.038003483728444094}},
        {{-0.5480430261884366, -0.014367061940371798, -0.0359076184515256}},
        {{-0.5189876914038467, -0.013619475205229915, -0.03404175183122855}},
        {{-0.49311689516397406, -0.01295039633876588, -0.032371190664881935}},
        {{-0.4699294729238445, -0.012348295640214607, -0.03086741273043335}},
        {{-0.44902103172564, -0.011803666527633948, -0.029506858287357902}},
        {{-0.43006264387433857, -0.011308631376070853, -0.028269974992846874}},
        {{-0.412784708503484, -0.010856629906072501, -0.02714045946264926}},
        {{-0.39696462170158825, -0.01044217168386863, -0.026104652535780325}},
        {{-0.382417280983451, -0.010060638733936785, -0.025151055363835436}},
        {{-0.3689877178699611, -0.009708127525333288, -0.024269940907011043}},
        {{-0.34497940959962575, -0.009077391370552355, -0.022693293777975226}},
        {{-0.3241123814609503, -0.008528775770045835, -0.021321848857245383}},
        {{-0.30577844121579434, -0.008046556247180755, -0.020116346039677765}},
        {{-0.2895206376313575, -0.007618843253415439, -0.019047086121870598}},
        {{-0.2749887956145698, -0.007236487385963142, -0.018091207564737564}},
        {{-0.26190973634472786, -0.006892331759221358, -0.017230823986201984}},
        {{-0.2500669063660991, -0.006580693269853661, -0.016451730481336156}},
        {{-0.23928616016846171, -0.006296996837463818, -0.015742490750417195}},
        {{-0.229425647205262, -0.006037513345111239, -0.015093782691546861}},
        {{-0.22036848884109675, -0.005799168913456865, -0.014497921947623022}},
    }};

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
