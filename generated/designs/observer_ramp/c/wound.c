/* Prescribed-time controller wound: see wound.h. DO NOT EDIT. */
#include "wound.h"

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
#define WOUND_GAMMA1 1.9966708291701364e-5 /* prediction from u */
#define WOUND_GAMMA2 0.03990016645854149 /* prediction from u */
#define WOUND_PHI1_2 0.0009975041614635374 /* prediction of x1 from x2 */
#define WOUND_PHI1_3 1.9966708291701364e-5 /* prediction of x1 from d */
#define WOUND_PHI1_4 6.65834165972718e-9 /* prediction of x1 from d_rate */
#define WOUND_PHI2_2 0.9950124791926823 /* prediction of x2 from x2 */
#define WOUND_PHI2_3 0.03990016645854149 /* prediction of x2 from d */
#define WOUND_PHI2_4 1.9966708291701364e-5 /* prediction of x2 from d_rate */
#define WOUND_PHI3_4 0.001 /* prediction of d from d_rate */
#define WOUND_D0_D_RATE 0.0005 /* 1/2000, weight of d_rate in d0 */
#define WOUND_SAMPLES 300U /* samples from the start to rest */
#define WOUND_U_MAX 10.0 /* bound of |u| */
#define WOUND_HOLD 10.0 /* samples to go at which the gains are held */

/* Gains of least energy of each state, a row for the samples to go of a node */
static const double wound_gains[133][2] = {
    {-25062.55208331163, -37.45838539928387},
    {-12531.276041655816, -27.02091153629504},
    {-7518.771890597572, -21.17512730136674},
    {-5012.522947839163, -17.41685454673074},
    {-3580.382484960281, -14.791921685154502},
    {-2685.29581446331, -12.853004827701644},
    {-2088.572113309308, -11.361511337588555},
    {-1670.8660445699165, -10.178253886647713},
    {-1367.0801924248185, -9.216462472334808},
    {-1139.2410880456976, -8.419192302134173},
    {-963.9804575280741, -7.7475056835855245},
    {-826.2758484653018, -7.173867479447892},
    {-716.1122988456777, -6.678251755867355},
    {-626.6045265894896, -6.245743125016565},
    {-552.8923356192942, -5.8650030366739845},
    {-491.46558651746074, -5.527257508159454},
    {-439.73786238226137, -5.225610425046795},
    {-395.76935174979474, -4.954566395590321},
    {-358.08210395224614, -4.709692126318068},
    {-325.53406691464073, -4.487371545828679},
    {-297.2314613108345, -4.284625719832186},
    {-272.4667122832038, -4.098978394427451},
    {-250.67376029944174, -3.9283542217508476},
    {-231.3954037153636, -3.7710007577691615},
    {-214.2591080907677, -3.625427994983439},
    {-198.9588631838909, -3.490360996044272},
    {-185.24141929776482, -3.3647024313193445},
    {-172.89573515015255, -3.2475026852219093},
    {-161.7448084859356, -3.1379358050018875},
    {-151.63929374570083, -3.0352800015816697},
    {-142.45247356429783, -2.938901727848315},
    {-134.0762655507691, -2.8482425912471},
    {-126.41802771362536, -2.7628085288985127},
    {-119.39798505450041, -2.682160801615334},
    {-112.9471430233356, -2.6059084599124938},
    {-107.00558533779206, -2.533702008723079},
    {-101.52107732283747, -2.4652280540296214},
    {-96.4479136663855, -2.4002047583056494},
    {-91.74596289998007, -2.3383779656868584},
    {-87.37987113303078, -2.2795178844715838},
    {-83.31839541198548, -2.2234162356068197},
    {-79.53384313623167, -2.1698837925359418},
    {-76.00159867616605, -2.118748251137814},
    {-72.69972202781202, -2.0698523792108214},
    {-69.60860724242359, -2.0230524036126596},
    {-66.71069066856059, -1.9782166001907233},
    {-63.990200873971226, -1.935224057363983},
    {-61.43294357850104, -1.8939635889065702},
    {-59.02611610609145, -1.854332775340262},
    {-56.75814681446088, -1.8162371165287596},
    {-54.618555732244545, -1.7795892807083726},
    {-52.597833261740725, -1.7443084373888083},
    {-50.68733431953344, -1.7103196633950737},
    {-48.87918570957591, -1.6775534128620255},
    {-47.166204871543165, -1.6459450432891332},
    {-45.54182843544784, -1.6154343908569635},
    {-44.00004925285312, -1.5859653891331444},
    {-42.53536077446738, -1.5574857260822101},
    {-41.14270781065835, -1.5299465349637833},
    {-39.81744285128224, -1.5033021152758699},
    {-38.55528723888131, -1.4775096803902563},
    {-37.35229658857752, -1.4525291289479483},
    {-36.20482993199029, -1.4283228374450154},
    {-34.06325919005944, -1.3820938155806135},
    {-32.106536803142006, -1.338564431477856},
    {-30.313985513026402, -1.297505701218112},
    {-28.667740477433156, -1.2587138257138495},
    {-27.152302410418812, -1.2220068207829147},
    {-25.754171416504423, -1.1872216742436565},
    {-24.46154528468084, -1.1542119363133219},
    {-23.264069592318712, -1.1228456681669643},
    {-22.152629694858003, -1.0930036880472276},
    {-21.119176765645577, -1.0645780657608817},
    {-20.156581661606076, -1.0374708254679725},
    {-19.258511641816636, -1.0115928238994039},
    {-18.419325944014677, -0.9868627769342994},
    {-17.63398699291158, -0.9632064121390287},
    {-16.89798462206792, -0.9405557286528212},
    {-16.207271174315228, -0.9188483488839579},
    {-15.558205731836736, -0.8980269489982304},
    {-14.947506037085217, -0.8780387572491501},
    {-14.372206915882634, -0.8588351109048781},
    {-13.829624216800774, -0.8403710639392016},
    {-13.317323445964547, -0.8226050388280604},
    {-12.833092411325039, -0.8054985167729085},
    {-12.374917301162197, -0.7890157614927269},
    {-11.940961712785693, -0.7731235724159998},
    {-11.529548222820779, -0.7577910636853106},
    {-11.139142153050017, -0.7429894658788976},
    {-10.768337237893562, -0.728691947770666},
    {-10.415842943146174, -0.714873455805111},
    {-10.080473222075732, -0.7015105692665033},
    {-9.761136525661026, -0.6885813693808883},
    {-9.456826909609179, -0.6760653208118154},
    {-9.16661610266188, -0.6639431642020094},
    {-8.625124415267713, -0.6408092925783974},
    {-8.130537323271147, -0.6190477039605723},
    {-7.67758988647958, -0.5985413585332934},
    {-7.261735669555908, -0.5791861530901838},
    {-6.879032210126091, -0.5608891815779076},
    {-6.5260472340516715, -0.5435672689587614},
    {-6.1997814312332595, -0.5271457295661145},
    {-5.897604532320134, -0.5115573108473565},
    {-5.617202131130627, -0.49674129098509934},
    {-5.35653123684372, -0.48264270486283967},
    {-5.113782955729232, -0.46921167757142107},
    {-4.887351024780353, -0.4564028484192852},
    {-4.67580517153525, -0.4441748714258962},
    {-4.477868472289474, -0.43248998070631994},
    {-4.2923980372763735, -0.421313611120303},
    {-4.118368475621753, -0.4106140661574739},
    {-3.954857692083967, -0.400362226336105},
    {-3.801034647206928, -0.3905312924645114},
    {-3.6561487767130783, -0.3810965589973729},
    {-3.5195208179677313, -0.372035213450151},
    {-3.3905348336558507, -0.36332615844198357},
    {-3.2686312573789826, -0.35494985344378815},
    {-3.153300814234341, -0.34688817373208025},
    {-3.0440791927863806, -0.33912428440490333},
    {-2.9405423641389032, -0.3316425276161462},
    {-2.8423024598226094, -0.32442832143802014},
    {-2.749004133535985, -0.3174680689764142},
    {-2.660321342903319, -0.31074907654665324},
    {-2.575954496734587, -0.3042594798730975},
    {-2.495627921104846, -0.2979881774093737},
    {-2.4190876041728377, -0.2919247699903831},
    {-2.3460991852392303, -0.28605950612555253},
    {-2.2099282641741778, -0.27488734794385006},
    {-2.085569571646548, -0.2644048657952509},
    {-1.9716947441056276, -0.2545528356422077},
    {-1.8671570099165657, -0.2452785920601236},
    {-1.7709621952622956, -0.23653514437701323},
    {-1.6822449906745098, -0.22828043202923856},
};
ptc_status wound_init(wound *self, const wound_params *params)
{
    ptc_status status = PTC_E_PARAM;

    (void)params;
    if (self != NULL) {
        self->start = 0U;
        self->u1 = 0.0;
        self->seen = 0U;
        self->x1_hat = 0.0;
        self->x1_next = 0.0;
        self->x2_hat = 0.0;
        self->x2_next = 0.0;
        self->d_hat = 0.0;
        self->d_next = 0.0;
        self->d_rate_hat = 0.0;
        self->d_rate_next = 0.0;
        status = PTC_OK;
    }
    return status;
}

ptc_status wound_arm(wound *self, uint32_t k)
{
    ptc_status status = PTC_E_INPUT;

    if (self != NULL) {
        self->start = k;
        const double s1 = fabs(self->x1_next) + fabs(self->x2_next) + fabs(self->d_next);
        const double size = s1 + fabs(self->d_rate_next);
        if (!(size <= 1e150)) {
            self->seen = 0U;
            self->x1_hat = 0.0;
            self->x1_next = 0.0;
            self->x2_hat = 0.0;
            self->x2_next = 0.0;
            self->d_hat = 0.0;
            self->d_next = 0.0;
            self->d_rate_hat = 0.0;
            self->d_rate_next = 0.0;
        }
        status = PTC_OK;
    }
    return status;
}

ptc_status wound_step(wound *self, uint32_t k, const double y[1], double *u)
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
            double d;
            double d_rate;
            if (self->seen == 0U) {
                x1 = y[0];
                x2 = 0.0;
                d = 0.0;
                d_rate = 0.0;
            } else {
                x1 = self->x1_next + (WOUND_GAMMA1 * self->u1);
                x2 = self->x2_next + (WOUND_GAMMA2 * self->u1);
                d = self->d_next;
                d_rate = self->d_rate_next;
            }

            /* Prediction of the next sample. */
            const double miss1 = y[0] - x1;
            const double off1 = miss1;
            const double l1 = 0.5585637305501465;
            const double l2 = 139.80905203556958;
            const double l3 = 543.231381268175;
            const double l4 = 41388.00314050849;
            const double s1 = x1 + (WOUND_PHI1_2 * x2) + (WOUND_PHI1_3 * d);
            const double x1_on = s1 + (WOUND_PHI1_4 * d_rate) + (l1 * off1);
            const double s2 = (WOUND_PHI2_2 * x2) + (WOUND_PHI2_3 * d);
            const double x2_on = s2 + (WOUND_PHI2_4 * d_rate) + (l2 * off1);
            const double d_on = d + (WOUND_PHI3_4 * d_rate) + (l3 * off1);
            const double d_rate_on = d_rate + (l4 * off1);

            /* The disturbance while each input acts. */
            const double d0 = d + (WOUND_D0_D_RATE * d_rate);
            const uint32_t left = (elapsed < WOUND_SAMPLES) ? (WOUND_SAMPLES - elapsed) : 0U;
            uint32_t to_go;
            if (left > 10U) {
                to_go = left;
            } else {
                to_go = 10U;
            }

            /* Its place between the nodes of the table. */
            uint32_t row;
            double part;
            if (to_go < 64U) {
                row = to_go - 2U;
                part = 0.0;
            } else if (to_go < 128U) {
                row = (to_go / 2U) + 30U;
                part = (0.5 * ((double)to_go)) - ((double)(to_go / 2U));
            } else if (to_go < 256U) {
                row = (to_go / 4U) + 62U;
                part = (0.25 * ((double)to_go)) - ((double)(to_go / 4U));
            } else {
                row = (to_go / 8U) + 94U;
                part = (0.125 * ((double)to_go)) - ((double)(to_go / 8U));
            }

            /* The law of least energy. */
            const uint32_t above = row + 1U;
            double v;
            const double s3 = part * (wound_gains[above][0] - wound_gains[row][0]);
            const double s4 = part * (wound_gains[above][1] - wound_gains[row][1]);
            const double s5 = (wound_gains[row][0] + s3) * x1;
            v = (s5 + ((wound_gains[row][1] + s4) * x2)) - d0;
            status = PTC_E_RANGE;
            if (PTC_FINITE_F64(v)
                && PTC_FINITE_F64(x1_on)
                && PTC_FINITE_F64(x2_on)
                && PTC_FINITE_F64(d_on)
                && PTC_FINITE_F64(d_rate_on)) {
                double u_now;
                if (v > WOUND_U_MAX) {
                    u_now = WOUND_U_MAX;
                } else if (v < -WOUND_U_MAX) {
                    u_now = -WOUND_U_MAX;
                } else {
                    u_now = v;
                }
                self->u1 = u_now;
                self->x1_hat = x1;
                self->x1_next = x1_on;
                self->x2_hat = x2;
                self->x2_next = x2_on;
                self->d_hat = d;
                self->d_next = d_on;
                self->d_rate_hat = d_rate;
                self->d_rate_next = d_rate_on;
                self->seen = 1U;
                *u = u_now;
                if ((v > WOUND_U_MAX) || (v < -WOUND_U_MAX)) {
                    status = PTC_SATURATED;
                } else if ((double)left <= WOUND_HOLD) {
                    status = PTC_HOLD;
                } else {
                    status = PTC_OK;
                }
            }
        }
    }
    return status;
}

ptc_status wound_estimate(const wound *self, double xhat[2])
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (xhat != NULL)) {
        xhat[0] = self->x1_hat;
        xhat[1] = self->x2_hat;
        status = PTC_OK;
    }
    if ((status < PTC_OK) && (xhat != NULL)) {
        for (uint32_t i = 0U; i < 2U; i++) {
            xhat[i] = 0.0;
        }
    }
    return status;
}

ptc_status wound_disturbance(const wound *self, double *d)
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (d != NULL)) {
        *d = self->d_hat;
        status = PTC_OK;
    }
    return status;
}
