/* Prescribed-time controller motor: see motor.h. DO NOT EDIT. */
#include "motor.h"

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
#define MOTOR_GAMMA1 0.00010816330676811052 /* prediction from u */
#define MOTOR_GAMMA2 0.30941358230147875 /* prediction from u */
#define MOTOR_GAMMA3 0.37459048481653323 /* prediction from u */
#define MOTOR_OBSERVER_SAMPLES 150U /* samples of the round of the observer */
#define MOTOR_HOLD_O 40.0 /* samples to go at which the observer is held */
#define MOTOR_Q1_1 (-96.0) /* weight in the observer's gain l1 */
#define MOTOR_Q1_2 96.0 /* weight in the observer's gain l1 */
#define MOTOR_Q1_3 (-48.0) /* weight in the observer's gain l1 */
#define MOTOR_Q1_4 16.0 /* weight in the observer's gain l1 */
#define MOTOR_Q2_1 859382.9277311233 /* weight in the observer's gain l2 */
#define MOTOR_Q2_2 (-513847.60335174634) /* weight in the observer's gain l2 */
#define MOTOR_Q2_3 125558.23800330989 /* weight in the observer's gain l2 */
#define MOTOR_Q2_4 (-9808.939721535125) /* weight in the observer's gain l2 */
#define MOTOR_Q3_1 (-620544.0922410007) /* weight in the observer's gain l3 */
#define MOTOR_Q3_2 289368.54342637886 /* weight in the observer's gain l3 */
#define MOTOR_Q3_3 (-49493.69520132396) /* weight in the observer's gain l3 */
#define MOTOR_Q3_4 3680.3758886140504 /* weight in the observer's gain l3 */
#define MOTOR_Q4_1 42644.35104284018 /* weight in the observer's gain l4 */
#define MOTOR_PHI1_2 0.000996505559752715 /* prediction of x1 from x2 */
#define MOTOR_PHI1_3 0.0006188271646029575 /* prediction of x1 from x3 */
#define MOTOR_PHI1_4 0.00010816330676811052 /* prediction of x1 from d */
#define MOTOR_PHI2_2 0.9902193397510792 /* prediction of x2 from x2 */
#define MOTOR_PHI2_3 1.1234620408672982 /* prediction of x2 from x3 */
#define MOTOR_PHI2_4 0.30941358230147875 /* prediction of x2 from d */
#define MOTOR_PHI3_2 (-0.011234620408672982) /* prediction of x3 from x2 */
#define MOTOR_PHI3_3 0.5412090107511158 /* prediction of x3 from x3 */
#define MOTOR_PHI3_4 0.37459048481653323 /* prediction of x3 from d */
#define MOTOR_SAMPLES 400U /* samples from the start to rest */
#define MOTOR_U_MAX 24.0 /* bound of |u| */
#define MOTOR_HOLD 20.0 /* samples to go at which the gains are held */

/* Gains of least energy of each state, a row for the samples to go of a node */
static const double motor_gains[88][3] = {
    {-1776.8479601183408, -3.433673119968826, -3.4085582810122124},
    {-1089.2855660713828, -2.5792538324475585, -2.92715620435224},
    {-715.1097776720381, -2.005268116785936, -2.5379317120700415},
    {-494.95285763541585, -1.6039167324374313, -2.220199839032561},
    {-357.3880718570257, -1.31380805149398, -1.9585623640689978},
    {-267.1996825586806, -1.098176456897036, -1.7413581865092544},
    {-205.68910041563595, -0.934030901408559, -1.5596487398641914},
    {-162.32003662246422, -0.8064560539564851, -1.4065087720571303},
    {-130.8587713317818, -0.7054687263312741, -1.2765216589021253},
    {-107.46356640472325, -0.6242062303411349, -1.1654158102501366},
    {-89.6832288274182, -0.5578412955540902, -1.0697990210360293},
    {-75.90627252608341, -0.5029097859456781, -0.9869613689864624},
    {-65.04518231831996, -0.45688161590965487, -0.9147267369479838},
    {-56.348873339179654, -0.4178796566170861, -0.8513394385098589},
    {-49.28777883721612, -0.3844913311440051, -0.7953766746302587},
    {-43.481487103886096, -0.35563977177489164, -0.7456803485752753},
    {-38.652053478900314, -0.3304941351900456, -0.70130361771621},
    {-34.59321725150104, -0.30840618699988964, -0.6614688027166578},
    {-31.149704862289127, -0.28886482779590356, -0.6255341277872658},
    {-28.203065658180382, -0.27146306931059916, -0.5929673690396564},
    {-25.661819927173966, -0.25587377335889633, -0.5633249276142321},
    {-23.454503331202414, -0.2418316372933554, -0.5362351731835312},
    {-21.524687865701647, -0.2291196839285042, -0.5113851546074136},
    {-19.82737149256077, -0.21755903423392625, -0.48850996901608346},
    {-18.32632847221013, -0.20700109598969532, -0.4673842324771343},
    {-16.992142612265372, -0.19732154685278322, -0.4478152145054596},
    {-15.800731757950414, -0.18841566178533486, -0.4296372922162896},
    {-14.732229610927645, -0.18019465601352325, -0.41270745338642967},
    {-13.770130221219006, -0.1725828012034134, -0.3969016353447562},
    {-12.900627507501603, -0.1655151348503219, -0.38211173182343144},
    {-11.394711901902335, -0.1527957106102675, -0.35521271035287216},
    {-10.141049219434281, -0.14167070006977625, -0.3313814014980151},
    {-9.0859382187617, -0.13186043523889596, -0.31012500418563205},
    {-8.189345280178369, -0.12314740197880317, -0.291051941766111},
    {-7.4209119024392, -0.1153598671926937, -0.2738470715910652},
    {-6.757263185703688, -0.10836040805188914, -0.25825381348164067},
    {-6.180154034498657, -0.10203772110752699, -0.24406106274895106},
    {-5.675167336369847, -0.0963006708178401, -0.2310934652306333},
    {-5.23078354245966, -0.09107389593679792, -0.21920409124134224},
    {-4.837704973413569, -0.08629451847735992, -0.2082688462665139},
    {-4.488357907712668, -0.08190964551549022, -0.1981821563022114},
    {-4.176520752701599, -0.07787444952242385, -0.18885360074286894},
    {-3.897042956242042, -0.0741506765876409, -0.18020525813059907},
    {-3.645630112311628, -0.07070547509517439, -0.17216959422296677},
    {-3.418677959919714, -0.06751046718170695, -0.16468776695227477},
    {-3.213142915211289, -0.0645410061123608, -0.15770825498484048},
    {-2.8563629827678154, -0.05919531249241354, -0.14508018771857667},
    {-2.5587724714829676, -0.054525708484506843, -0.13398184231601154},
    {-2.308113620148721, -0.05042067250716002, -0.12417284151494208},
    {-2.0951329204844162, -0.04679171196401641, -0.1154601789139411},
    {-1.9127379597653626, -0.04356766177924224, -0.1076869671269336},
    {-1.7554185685093087, -0.04069060588997639, -0.10072427243750298},
    {-1.6188414539850762, -0.038112906049917065, -0.09446508810364408},
    {-1.499561227614519, -0.03579500166341945, -0.08881981793367545},
    {-1.3948110724320861, -0.033703756369920845, -0.08371284469957926},
    {-1.302348878102034, -0.031811198751691146, -0.07907988985096792},
    {-1.2203426350575814, -0.030093551392916203, -0.07486595850246795},
    {-1.1472840267845936, -0.028530473771209493, -0.07102372282687533},
    {-1.0819225499528982, -0.027104465688876877, -0.06751223767064869},
    {-1.0232147646198977, -0.02580039260729931, -0.0642959106283311},
    {-0.9702848242470944, -0.02460510452137872, -0.06134366895222488},
    {-0.9223935046222815, -0.02350712731311073, -0.05862828013477268},
    {-0.8393108842117797, -0.021564121362904712, -0.053815077953051585},
    {-0.7699698793361764, -0.019904570963388015, -0.049696282750678666},
    {-0.7114197610619046, -0.01847628415495611, -0.04614604998760003},
    {-0.6614486843911724, -0.017238069994469484, -0.04306450036887954},
    {-0.618376040841814, -0.01615714175448534, -0.040371749956062936},
    {-0.580909230835424, -0.015207210674377572, -0.038003483728444094},
    {-0.5480430261884366, -0.014367061940371798, -0.0359076184515256},
    {-0.5189876914038467, -0.013619475205229915, -0.03404175183122855},
    {-0.49311689516397406, -0.01295039633876588, -0.032371190664881935},
    {-0.4699294729238445, -0.012348295640214607, -0.03086741273043335},
    {-0.44902103172564, -0.011803666527633948, -0.029506858287357902},
    {-0.43006264387433857, -0.011308631376070853, -0.028269974992846874},
    {-0.412784708503484, -0.010856629906072501, -0.02714045946264926},
    {-0.39696462170158825, -0.01044217168386863, -0.026104652535780325},
    {-0.382417280983451, -0.010060638733936785, -0.025151055363835436},
    {-0.3689877178699611, -0.009708127525333288, -0.024269940907011043},
    {-0.34497940959962575, -0.009077391370552355, -0.022693293777975226},
    {-0.3241123814609503, -0.008528775770045835, -0.021321848857245383},
    {-0.30577844121579434, -0.008046556247180755, -0.020116346039677765},
    {-0.2895206376313575, -0.007618843253415439, -0.019047086121870598},
    {-0.2749887956145698, -0.007236487385963142, -0.018091207564737564},
    {-0.26190973634472786, -0.006892331759221358, -0.017230823986201984},
    {-0.2500669063660991, -0.006580693269853661, -0.016451730481336156},
    {-0.23928616016846171, -0.006296996837463818, -0.015742490750417195},
    {-0.229425647205262, -0.006037513345111239, -0.015093782691546861},
    {-0.22036848884109675, -0.005799168913456865, -0.014497921947623022},
};
ptc_status motor_init(motor *self, const motor_params *params)
{
    ptc_status status = PTC_E_PARAM;

    (void)params;
    if (self != NULL) {
        self->start = 0U;
        self->u1 = 0.0;
        self->u2 = 0.0;
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

ptc_status motor_arm(motor *self, uint32_t k)
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

ptc_status motor_step(motor *self, uint32_t k, const double y[1], double *u)
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
                x1 = self->x1_next + (MOTOR_GAMMA1 * self->u2);
                x2 = self->x2_next + (MOTOR_GAMMA2 * self->u2);
                x3 = self->x3_next + (MOTOR_GAMMA3 * self->u2);
                d = self->d_next;
            }

            /* Prediction of the next sample. */
            const double miss1 = y[0] - x1;
            const double off1 = miss1;
            const uint32_t left_o = (elapsed < MOTOR_OBSERVER_SAMPLES) ? (MOTOR_OBSERVER_SAMPLES - elapsed) : 0U;
            const double o0 = ((double)left_o < MOTOR_HOLD_O) ? MOTOR_HOLD_O : (double)left_o;
            double l1;
            double l2;
            double l3;
            double l4;
            const double o0f2 = o0 * (o0 - 1.0);
            const double o0f3 = o0f2 * (o0 - 2.0);
            const double r0 = 1.0 / (o0f3 * (o0 - 3.0));
            const double s1 = MOTOR_Q1_1 + (MOTOR_Q1_2 * o0) + (MOTOR_Q1_3 * o0f2);
            l1 = ((s1 + (MOTOR_Q1_4 * o0f3)) * r0) - 0.46857164949780494;
            const double s2 = MOTOR_Q2_1 + (MOTOR_Q2_2 * o0) + (MOTOR_Q2_3 * o0f2);
            l2 = ((s2 + (MOTOR_Q2_4 * o0f3)) * r0) + 264.4187821124759;
            const double s3 = MOTOR_Q3_1 + (MOTOR_Q3_2 * o0) + (MOTOR_Q3_3 * o0f2);
            l3 = ((s3 + (MOTOR_Q3_4 * o0f3)) * r0) - 98.64522377262374;
            l4 = MOTOR_Q4_1 * r0;
            const double s4 = x1 + (MOTOR_PHI1_2 * x2) + (MOTOR_PHI1_3 * x3);
            const double x1_on = s4 + (MOTOR_PHI1_4 * d) + (l1 * off1);
            const double s5 = (MOTOR_PHI2_2 * x2) + (MOTOR_PHI2_3 * x3);
            const double x2_on = s5 + (MOTOR_PHI2_4 * d) + (l2 * off1);
            const double s6 = (MOTOR_PHI3_2 * x2) + (MOTOR_PHI3_3 * x3);
            const double x3_on = s6 + (MOTOR_PHI3_4 * d) + (l3 * off1);
            const double d_on = d + (l4 * off1);
            const uint32_t left = (elapsed < MOTOR_SAMPLES) ? (MOTOR_SAMPLES - elapsed) : 0U;
            const uint32_t planned = (1U < left) ? (left - 1U) : 0U;
            uint32_t to_go;
            if (planned > 20U) {
                to_go = planned;
            } else {
                to_go = 20U;
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
            } else if (to_go < 128U) {
                row = (to_go / 4U) + 29U;
                part = (0.25 * ((double)to_go)) - ((double)(to_go / 4U));
            } else if (to_go < 256U) {
                row = (to_go / 8U) + 45U;
                part = (0.125 * ((double)to_go)) - ((double)(to_go / 8U));
            } else {
                row = (to_go / 16U) + 61U;
                part = (0.0625 * ((double)to_go)) - ((double)(to_go / 16U));
            }

            /* The state from which this input acts. */
            const double s7 = x1 + (0.000996505559752715 * x2) + (0.0006188271646029575 * x3);
            const double p1 = s7 + (0.00010816330676811052 * (self->u1 + d));
            const double s8 = (0.9902193397510792 * x2) + (1.1234620408672982 * x3);
            const double p2 = s8 + (0.30941358230147875 * (self->u1 + d));
            const double s9 = ((-0.011234620408672982) * x2) + (0.5412090107511158 * x3);
            const double p3 = s9 + (0.37459048481653323 * (self->u1 + d));

            /* The law of least energy. */
            const uint32_t above = row + 1U;
            double v;
            const double s10 = part * (motor_gains[above][0] - motor_gains[row][0]);
            const double s11 = part * (motor_gains[above][1] - motor_gains[row][1]);
            const double s12 = (motor_gains[row][0] + s10) * p1;
            const double s13 = part * (motor_gains[above][2] - motor_gains[row][2]);
            const double s14 = s12 + ((motor_gains[row][1] + s11) * p2);
            v = (s14 + ((motor_gains[row][2] + s13) * p3)) - d;
            status = PTC_E_RANGE;
            if (PTC_FINITE_F64(v)
                && PTC_FINITE_F64(x1_on)
                && PTC_FINITE_F64(x2_on)
                && PTC_FINITE_F64(x3_on)
                && PTC_FINITE_F64(d_on)) {
                double u_now;
                if (v > MOTOR_U_MAX) {
                    u_now = MOTOR_U_MAX;
                } else if (v < -MOTOR_U_MAX) {
                    u_now = -MOTOR_U_MAX;
                } else {
                    u_now = v;
                }
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
                if ((v > MOTOR_U_MAX) || (v < -MOTOR_U_MAX)) {
                    status = PTC_SATURATED;
                } else if (((double)left) - 1.0 <= MOTOR_HOLD) {
                    status = PTC_HOLD;
                } else {
                    status = PTC_OK;
                }
            }
        }
    }
    return status;
}

ptc_status motor_estimate(const motor *self, double xhat[3])
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

ptc_status motor_disturbance(const motor *self, double *d)
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (d != NULL)) {
        *d = self->d_hat;
        status = PTC_OK;
    }
    return status;
}
