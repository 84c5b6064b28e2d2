/* Prescribed-time controller stage48: see stage48.h. DO NOT EDIT. */
#include "stage48.h"

#include <float.h>
#include <math.h>
#include <stddef.h>
#include <stdint.h>

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

#if !defined(PTC_FINITE_F64)
#if defined(isfinite) && !defined(__MINGW32__)
#define PTC_FINITE_F64(x) (isfinite(x) != 0)
#else
#define PTC_FINITE_F64(x) (fabs(x) <= DBL_MAX)
#endif
#endif

/* Numbers of the design, each rounded once. */
#define STAGE48_GAMMA1 9.364814153170347e-5 /* prediction from u */
#define STAGE48_LATE_GAMMA1 1.4515165236407059e-5 /* prediction from u */
#define STAGE48_GAMMA2 0.22442191668610964 /* prediction from u */
#define STAGE48_LATE_GAMMA2 0.08499166561536914 /* prediction from u */
#define STAGE48_GAMMA3 0.15880778157427425 /* prediction from u */
#define STAGE48_LATE_GAMMA3 0.21578270324225896 /* prediction from u */
#define STAGE48_OBSERVER_SAMPLES 50U /* samples of the round of the observer */
#define STAGE48_Q1_1 (-96.0) /* weight in the observer's gain l1 */
#define STAGE48_Q1_2 96.0 /* weight in the observer's gain l1 */
#define STAGE48_Q1_3 (-48.0) /* weight in the observer's gain l1 */
#define STAGE48_Q1_4 16.0 /* weight in the observer's gain l1 */
#define STAGE48_Q2_1 859382.9277311233 /* weight in the observer's gain l2 */
#define STAGE48_Q2_2 (-513847.60335174634) /* weight in the observer's gain l2 */
#define STAGE48_Q2_3 125558.23800330989 /* weight in the observer's gain l2 */
#define STAGE48_Q2_4 (-9808.939721535125) /* weight in the observer's gain l2 */
#define STAGE48_Q3_1 (-620544.0922410007) /* weight in the observer's gain l3 */
#define STAGE48_Q3_2 289368.54342637886 /* weight in the observer's gain l3 */
#define STAGE48_Q3_3 (-49493.69520132396) /* weight in the observer's gain l3 */
#define STAGE48_Q3_4 3680.3758886140504 /* weight in the observer's gain l3 */
#define STAGE48_Q4_1 42644.35104284018 /* weight in the observer's gain l4 */
#define STAGE48_E0_1 1.1314283505021951 /* gain of the observer at its end */
#define STAGE48_E0_2 219.51265205459217 /* gain of the observer at its end */
#define STAGE48_E0_3 75.63157806817 /* gain of the observer at its end */
#define STAGE48_E0_4 (-118.45653067455605) /* gain of the observer at its end */
#define STAGE48_E1_1 1.3092061282799727 /* gain of the observer at its end */
#define STAGE48_E1_2 248.77479213018773 /* gain of the observer at its end */
#define STAGE48_E1_3 58.354009083621726 /* gain of the observer at its end */
#define STAGE48_E1_4 789.7102044970403 /* gain of the observer at its end */
#define STAGE48_E2_1 1.531428350502195 /* gain of the observer at its end */
#define STAGE48_E2_2 (-7.605455274169628) /* gain of the observer at its end */
#define STAGE48_E2_3 (-864.4162017900436) /* gain of the observer at its end */
#define STAGE48_E2_4 (-1776.8479601183408) /* gain of the observer at its end */
#define STAGE48_E3_1 3.5314283505021953 /* gain of the observer at its end */
#define STAGE48_E3_2 3400.952825738043 /* gain of the observer at its end */
#define STAGE48_E3_3 1206.9697918675683 /* gain of the observer at its end */
#define STAGE48_E3_4 1776.8479601183408 /* gain of the observer at its end */
#define STAGE48_PHI1_2 0.000996505559752715 /* prediction of x1 from x2 */
#define STAGE48_PHI1_3 0.0006188271646029575 /* prediction of x1 from x3 */
#define STAGE48_PHI1_4 0.00010816330676811052 /* prediction of x1 from d */
#define STAGE48_PHI2_2 0.9902193397510792 /* prediction of x2 from x2 */
#define STAGE48_PHI2_3 1.1234620408672982 /* prediction of x2 from x3 */
#define STAGE48_PHI2_4 0.30941358230147875 /* prediction of x2 from d */
#define STAGE48_PHI3_2 (-0.011234620408672982) /* prediction of x3 from x2 */
#define STAGE48_PHI3_3 0.5412090107511158 /* prediction of x3 from x3 */
#define STAGE48_PHI3_4 0.37459048481653323 /* prediction of x3 from d */
#define STAGE48_SAMPLES 100U /* samples from the start to rest */
#define STAGE48_U_MAX 24.0 /* bound of |u| */
#define STAGE48_HOLD 6.0 /* samples to go at which the gains are held */

/* Gains of least energy of each state, a row for the samples to go of a node */
static const double stage48_gains[56][3] = {
    {-1776.8479601183408, -3.433673119968826, -3.4085582810122124},
    {-888.4239800591704, -2.2396226199294076, -2.668895474474135},
    {-509.8205499917047, -1.5836352486541563, -2.156303199309816},
    {-321.2435999059375, -1.1847458154993364, -1.7840105694740966},
    {-216.68093346707525, -0.9242259566604598, -1.5043723951168144},
    {-153.9422258341114, -0.7447029385976519, -1.2887857385166759},
    {-113.93847902814913, -0.6156792469819268, -1.1190107322495595},
    {-87.16471846485014, -0.5197354647522179, -0.9828886639258793},
    {-68.52151427846083, -0.4463449878262189, -0.8720333492968331},
    {-55.10393872697146, -0.3888498994276202, -0.7805015513958865},
    {-45.17340922131986, -0.3428771962392912, -0.7039866926831448},
    {-37.645338987867255, -0.3054615992281757, -0.6393092191236842},
    {-31.81875620585758, -0.27453657915024465, -0.5840834223761374},
    {-27.22654280812768, -0.2486271922797076, -0.5364934991038854},
    {-23.548974074041762, -0.22665835728982042, -0.4951395241819548},
    {-20.56197731368738, -0.20783163893706613, -0.45892943480696},
    {-18.10517741827105, -0.1915440040702233, -0.4270020121187187},
    {-16.06160501852228, -0.17733302260561387, -0.3986711637229456},
    {-14.34448653985888, -0.16483914791668344, -0.3733850940635477},
    {-12.888450440068087, -0.15377927419458942, -0.3506960346235246},
    {-11.643553902420525, -0.14392788889388677, -0.3302375620042263},
    {-10.57115019711518, -0.13510343327021376, -0.31170743224482},
    {-9.640981134457023, -0.12715829319637273, -0.29485446816108246},
    {-8.829099689315191, -0.11997135875672672, -0.27946845400384207},
    {-8.116364548493685, -0.11344242686372868, -0.2653722821336554},
    {-7.4873347145655345, -0.10748794327334095, -0.2524158008059736},
    {-6.92944791969951, -0.10203772969328963, -0.24047095757682826},
    {-6.432403034640657, -0.09703244352848328, -0.22942793730857275},
    {-5.987690902669893, -0.0924215882293794, -0.21919206948913653},
    {-5.588234402434218, -0.08816194151833531, -0.20968133494671454},
    {-4.90232886736555, -0.08055249332977393, -0.19255867915280173},
    {-4.337531609573391, -0.07396200145641044, -0.17758866382046176},
    {-3.866962043305151, -0.06820607163189224, -0.1644055236605839},
    {-3.470790749314056, -0.06314188514263996, -0.1527212184490728},
    {-3.134134775751522, -0.058657163866628094, -0.14230591997800468},
    {-2.845649743939376, -0.05466245582716187, -0.13297406684879373},
    {-2.5965675236180417, -0.051085636807956664, -0.12457422819671518},
    {-2.380025558008824, -0.04786792242488202, -0.11698162121891839},
    {-2.1905911599741885, -0.044960929582640426, -0.11009250906350342},
    {-2.02391866730071, -0.04232447977954594, -0.10381995183425959},
    {-1.8764987244836007, -0.039924935245840495, -0.09809054528111931},
    {-1.7454724729656579, -0.03773392339710073, -0.09284188997856772},
    {-1.6284921470217775, -0.03572734808777426, -0.08802060737537329},
    {-1.523615296707974, -0.03388461531195422, -0.08358076988701066},
    {-1.4292236830261014, -0.03218802108556842, -0.07948264775619424},
    {-1.3439604848291826, -0.03062226328182328, -0.07569170062633748},
    {-1.1964152124156797, -0.02783177725314643, -0.06891436097083738},
    {-1.0737303961538518, -0.025425601240773896, -0.06304865259045363},
    {-0.970591182471621, -0.02333597818938725, -0.057938311673843924},
    {-0.8830294618645727, -0.021509684264473847, -0.053459600787556544},
    {-0.8080344337031824, -0.01990435940283023, -0.04951333308196541},
    {-0.7432884532951157, -0.01848589655966577, -0.04601913572216292},
    {-0.6869841398708345, -0.017226549374695407, -0.04291125081794763},
    {-0.6376953878667164, -0.01610353745589099, -0.04013541272877522},
    {-0.5942848639897524, -0.01509800278331475, -0.03764649228065479},
    {-0.5558366565985665, -0.014194218062618705, -0.035406696215788895},
};
ptc_status stage48_init(stage48 *self, const stage48_params *params)
{
    ptc_status status = PTC_E_PARAM;

    (void)params;
    if (self != NULL) {
        self->start = 0U;
        self->u1 = 0.0;
        self->u2 = 0.0;
        self->u3 = 0.0;
        self->seen = 0U;
        self->x1_hat = 0.0;
        self->x1_next = 0.0;
        self->x2_hat = 0.0;
        self->x2_next = 0.0;
        self->x3_hat = 0.0;
        self->x3_next = 0.0;
        self->d_hat = 0.0;
        self->d_next = 0.0;
        status = PTC_OK;
    }
    return status;
}

ptc_status stage48_arm(stage48 *self, uint32_t k)
{
    ptc_status status = PTC_E_INPUT;

    if (self != NULL) {
        self->start = k;
        const double s1 = fabs(self->x1_next) + fabs(self->x2_next);
        const double size = s1 + fabs(self->x3_next) + fabs(self->d_next);
        if (!(size <= 1e150)) {
            self->seen = 0U;
            self->x1_hat = 0.0;
            self->x1_next = 0.0;
            self->x2_hat = 0.0;
            self->x2_next = 0.0;
            self->x3_hat = 0.0;
            self->x3_next = 0.0;
            self->d_hat = 0.0;
            self->d_next = 0.0;
        }
        status = PTC_OK;
    }
    return status;
}

ptc_status stage48_step(stage48 *self, uint32_t k, const double y[1], double *u)
{
    ptc_status status = PTC_E_INPUT;

    if (u != NULL) {
        *u = 0.0;
    }
    if ((self != NULL) && (y != NULL) && (u != NULL)) {
        if (PTC_FINITE_F64(y[0])) {
            const uint32_t elapsed = k - self->start;

            /* The estimates; at first what y shows. */
            double x1;
            double x2;
            double x3;
            double d;
            if (self->seen == 0U) {
                x1 = y[0];
                x2 = 0.0;
                x3 = 0.0;
                d = 0.0;
            } else {
                const double s1 = (STAGE48_GAMMA1 * self->u3) + (STAGE48_LATE_GAMMA1 * self->u2);
                x1 = self->x1_next + s1;
                const double s2 = (STAGE48_GAMMA2 * self->u3) + (STAGE48_LATE_GAMMA2 * self->u2);
                x2 = self->x2_next + s2;
                const double s3 = (STAGE48_GAMMA3 * self->u3) + (STAGE48_LATE_GAMMA3 * self->u2);
                x3 = self->x3_next + s3;
                d = self->d_next;
            }

            /* Prediction of the next sample. */
            const double miss1 = y[0] - x1;
            const double off1 = miss1;
            const uint32_t left_o = (elapsed < STAGE48_OBSERVER_SAMPLES) ? (STAGE48_OBSERVER_SAMPLES - elapsed) : 0U;
            const double o0 = (double)left_o;
            double l1;
            double l2;
            double l3;
            double l4;
            if (o0 > 10.0) {
                const double o0f2 = o0 * (o0 - 1.0);
                const double o0f3 = o0f2 * (o0 - 2.0);
                const double r0 = 1.0 / (o0f3 * (o0 - 3.0));
                const double s4 = STAGE48_Q1_1 + (STAGE48_Q1_2 * o0) + (STAGE48_Q1_3 * o0f2);
                l1 = ((s4 + (STAGE48_Q1_4 * o0f3)) * r0) - 0.46857164949780494;
                const double s5 = STAGE48_Q2_1 + (STAGE48_Q2_2 * o0) + (STAGE48_Q2_3 * o0f2);
                l2 = ((s5 + (STAGE48_Q2_4 * o0f3)) * r0) + 264.4187821124759;
                const double s6 = STAGE48_Q3_1 + (STAGE48_Q3_2 * o0) + (STAGE48_Q3_3 * o0f2);
                l3 = ((s6 + (STAGE48_Q3_4 * o0f3)) * r0) - 98.64522377262374;
                l4 = STAGE48_Q4_1 * r0;
            } else if (left_o == 10U) {
                l1 = STAGE48_E0_1;
                l2 = STAGE48_E0_2;
                l3 = STAGE48_E0_3;
                l4 = STAGE48_E0_4;
            } else if (left_o == 9U) {
                l1 = STAGE48_E1_1;
                l2 = STAGE48_E1_2;
                l3 = STAGE48_E1_3;
                l4 = STAGE48_E1_4;
            } else if (left_o == 8U) {
                l1 = STAGE48_E2_1;
                l2 = STAGE48_E2_2;
                l3 = STAGE48_E2_3;
                l4 = STAGE48_E2_4;
            } else {
                l1 = STAGE48_E3_1;
                l2 = STAGE48_E3_2;
                l3 = STAGE48_E3_3;
                l4 = STAGE48_E3_4;
            }
            const double s7 = x1 + (STAGE48_PHI1_2 * x2) + (STAGE48_PHI1_3 * x3);
            const double x1_on = s7 + (STAGE48_PHI1_4 * d) + (l1 * off1);
            const double s8 = (STAGE48_PHI2_2 * x2) + (STAGE48_PHI2_3 * x3);
            const double x2_on = s8 + (STAGE48_PHI2_4 * d) + (l2 * off1);
            const double s9 = (STAGE48_PHI3_2 * x2) + (STAGE48_PHI3_3 * x3);
            const double x3_on = s9 + (STAGE48_PHI3_4 * d) + (l3 * off1);
            const double d_on = d + (l4 * off1);
            const uint32_t left = (elapsed < STAGE48_SAMPLES) ? (STAGE48_SAMPLES - elapsed) : 0U;
            const uint32_t planned = (2U < left) ? (left - 2U) : 0U;
            uint32_t to_go;
            if (planned > 6U) {
                to_go = planned;
            } else {
                to_go = 6U;
            }

            /* Its place between the nodes of the table. */
            uint32_t row;
            double part;
            if (to_go < 32U) {
                row = to_go - 3U;
                part = 0.0;
            } else if (to_go < 64U) {
                row = (to_go / 2U) + 13U;
                part = (0.5 * ((double)to_go)) - ((double)(to_go / 2U));
            } else {
                row = (to_go / 4U) + 29U;
                part = (0.25 * ((double)to_go)) - ((double)(to_go / 4U));
            }

            /* The state from which this input acts. */
            const double s10 = x1 + (0.0014892124792996978 * x2);
            const double s11 = 0.00010816330676811052 * (self->u1 + d);
            const double s12 = s10 + (0.0012719952989597699 * x3) + s11;
            const double p1 = s12 + (0.0002327420309725346 * (self->u2 + d));
            const double s13 = (0.9801754642759536 * x2) + (1.4706215395736848 * x3);
            const double s14 = s13 + (0.30941358230147875 * (self->u1 + d));
            const double p2 = s14 + (0.32658406717840616 * (self->u2 + d));
            const double s15 = ((-0.014706215395736848) * x2) + (0.39241705562633755 * x3);
            const double s16 = s15 + (0.37459048481653323 * (self->u1 + d));
            const double p3 = s16 + (0.11582869425785502 * (self->u2 + d));

            /* The law of least energy. */
            const uint32_t above = row + 1U;
            double v;
            const double s17 = part * (stage48_gains[above][0] - stage48_gains[row][0]);
            const double s18 = part * (stage48_gains[above][1] - stage48_gains[row][1]);
            const double s19 = (stage48_gains[row][0] + s17) * p1;
            const double s20 = part * (stage48_gains[above][2] - stage48_gains[row][2]);
            const double s21 = s19 + ((stage48_gains[row][1] + s18) * p2);
            v = (s21 + ((stage48_gains[row][2] + s20) * p3)) - d;
            status = PTC_E_RANGE;
            if (PTC_FINITE_F64(v)
                && PTC_FINITE_F64(x1_on)
                && PTC_FINITE_F64(x2_on)
                && PTC_FINITE_F64(x3_on)
                && PTC_FINITE_F64(d_on)) {
                double u_now;
                if (v > STAGE48_U_MAX) {
                    u_now = STAGE48_U_MAX;
                } else if (v < -STAGE48_U_MAX) {
                    u_now = -STAGE48_U_MAX;
                } else {
                    u_now = v;
                }
                self->u3 = self->u2;
                self->u2 = self->u1;
                self->u1 = u_now;
                self->x1_hat = x1;
                self->x1_next = x1_on;
                self->x2_hat = x2;
                self->x2_next = x2_on;
                self->x3_hat = x3;
                self->x3_next = x3_on;
                self->d_hat = d;
                self->d_next = d_on;
                self->seen = 1U;
                *u = u_now;
                if ((v > STAGE48_U_MAX) || (v < -STAGE48_U_MAX)) {
                    status = PTC_SATURATED;
                } else if (((double)left) - 2.0 <= STAGE48_HOLD) {
                    status = PTC_HOLD;
                } else {
                    status = PTC_OK;
                }
            }
        }
    }
    return status;
}

ptc_status stage48_estimate(const stage48 *self, double xhat[3])
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (xhat != NULL)) {
        xhat[0] = self->x1_hat;
        xhat[1] = self->x2_hat;
        xhat[2] = self->x3_hat;
        status = PTC_OK;
    }
    if ((status < PTC_OK) && (xhat != NULL)) {
        for (uint32_t i = 0U; i < 3U; i++) {
            xhat[i] = 0.0;
        }
    }
    return status;
}

ptc_status stage48_disturbance(const stage48 *self, double *d)
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (d != NULL)) {
        *d = self->d_hat;
        status = PTC_OK;
    }
    return status;
}
