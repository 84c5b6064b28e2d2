/* Self-test of the prescribed-time controller stage47: see stage47_selftest.h. DO NOT EDIT. */
#include "stage47_selftest.h"
#include "stage47.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct stage47_selftest_call {
    uint32_t is_armed; /* arm is called before it */
    uint32_t start;
    uint32_t k;
    double y[2]; /* what is measured */
    ptc_status status;
    double u;
    double xhat[3]; /* the estimates behind it */
    double d;
} stage47_selftest_call;

/* A set of parameters that init takes, and the calls with it, one after the other. */
typedef struct stage47_selftest_session {
    stage47_params params;
    uint32_t first; /* of its calls */
    uint32_t count;
} stage47_selftest_session;

static const stage47_selftest_session stage47_selftest_sessions[5] = {
    {.params = {.samples = 60U, .u_max = (double)INFINITY}, .first = 0U, .count = 48U},
    {.params = {.samples = 60U, .u_max = (double)INFINITY}, .first = 48U, .count = 3U},
    {.params = {.samples = 60U, .u_max = (double)INFINITY}, .first = 51U, .count = 1U},
    {.params = {.samples = 60U, .u_max = 1.0}, .first = 52U, .count = 2U},
    {.params = {.samples = 60U, .u_max = 1.0}, .first = 54U, .count = 1U},
};

static const stage47_selftest_call stage47_selftest_calls[55] = {
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.75, 0.25}, .status = PTC_OK, .u = -0.14045833980625277, .xhat = {0.75, 0.0, 0.25}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {0.7252083333333332, 0.2417361111111111}, .status = PTC_OK, .u = -0.29813392024573465, .xhat = {0.7501392891127847, 0.023678028078830196, 0.08269080286421279}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.7008333333333333, 0.2336111111111111}, .status = PTC_OK, .u = -0.438185672027444, .xhat = {0.7402494292830577, -0.03368583335803198, -0.04496716228771809}, .d = 0.010886828448398136},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)NAN, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7402494292830577, -0.03368583335803198, -0.04496716228771809}, .d = 0.010886828448398136},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, (double)NAN}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7402494292830577, -0.03368583335803198, -0.04496716228771809}, .d = 0.010886828448398136},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)INFINITY, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7402494292830577, -0.03368583335803198, -0.04496716228771809}, .d = 0.010886828448398136},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, (double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7402494292830577, -0.03368583335803198, -0.04496716228771809}, .d = 0.010886828448398136},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {-(double)INFINITY, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7402494292830577, -0.03368583335803198, -0.04496716228771809}, .d = 0.010886828448398136},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, -(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7402494292830577, -0.03368583335803198, -0.04496716228771809}, .d = 0.010886828448398136},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {0.676875, 0.225625}, .status = PTC_OK, .u = -0.5581184727388628, .xhat = {0.7229195552398618, -0.15246644629612796, -0.12750372840275115}, .d = 0.03720046397489263},
    {.is_armed = 0U, .start = 0U, .k = 10U, .y = {0.5208333333333334, 0.17361111111111113}, .status = PTC_OK, .u = -0.795323390520688, .xhat = {0.7003381252987706, -0.31517205621330957, -0.16564770850926896}, .d = 0.07991187867053817},
    {.is_armed = 0U, .start = 0U, .k = 16U, .y = {0.40333333333333327, 0.13444444444444442}, .status = PTC_OK, .u = -0.38622786189449665, .xhat = {0.5548033315143847, -2.61210585320089, -0.08407103614033606}, .d = -0.33701496341952264},
    {.is_armed = 0U, .start = 0U, .k = 18U, .y = {0.36749999999999994, 0.12249999999999998}, .status = PTC_OK, .u = 4.6247389346077235, .xhat = {0.22683085975463244, -17.58695607379478, 0.30256746630333714}, .d = -4.298531013700544},
    {.is_armed = 0U, .start = 0U, .k = 19U, .y = {0.35020833333333334, 0.11673611111111111}, .status = PTC_OK, .u = 1.5665382827668823, .xhat = {0.33257020920886965, -3.3748115119810254, 1.988938908534702}, .d = -0.5586529200604057},
    {.is_armed = 0U, .start = 0U, .k = 20U, .y = {0.3333333333333333, 0.1111111111111111}, .status = PTC_OK, .u = 3.906038885272359, .xhat = {0.33284712912036235, -1.7848582330264655, -1.0349418733731328}, .d = -5.011422398413236},
    {.is_armed = 0U, .start = 0U, .k = 21U, .y = {0.316875, 0.10562500000000001}, .status = PTC_OK, .u = 2.1879377703485865, .xhat = {0.316733130547619, -1.5919532490976738, 0.9786789701472529}, .d = -1.9579015854256294},
    {.is_armed = 0U, .start = 0U, .k = 40U, .y = {0.08333333333333333, 0.027777777777777776}, .status = PTC_OK, .u = 2.5414992382763755, .xhat = {0.2999837784305798, -1.6888049577135182, -0.5420494069499973}, .d = -4.286257185469006},
    {.is_armed = 0U, .start = 0U, .k = 56U, .y = {0.003333333333333333, 0.0011111111111111111}, .status = PTC_HOLD, .u = -6.564399124594911, .xhat = {0.1691469306801878, -4.016746770201905, 0.5372990475202007}, .d = -1.8331662904001427},
    {.is_armed = 0U, .start = 0U, .k = 58U, .y = {0.0008333333333333333, 0.0002777777777777778}, .status = PTC_HOLD, .u = 65.51392930425668, .xhat = {0.03993967587969117, -6.136027294951556, -2.901517005781801}, .d = -2.5480609326868935},
    {.is_armed = 0U, .start = 0U, .k = 59U, .y = {0.00020833333333333332, 6.944444444444444e-5}, .status = PTC_HOLD, .u = 5.274489193857146, .xhat = {-0.03133836767152043, -4.069883663142203, 27.220771668294766}, .d = 5.357286859401075},
    {.is_armed = 0U, .start = 0U, .k = 60U, .y = {0.0, 0.0}, .status = PTC_HOLD, .u = 222.37615829767776, .xhat = {-0.0878378706024042, -7.701054518952988, -22.54621310021179}, .d = -67.35476029817733},
    {.is_armed = 0U, .start = 0U, .k = 61U, .y = {0.0, 0.0}, .status = PTC_HOLD, .u = -127.41744571971235, .xhat = {-0.07315113309050357, 1.783908625166032, 81.06127973952786}, .d = -7.620451467149351},
    {.is_armed = 0U, .start = 0U, .k = 2147483647U, .y = {0.0, 0.0}, .status = PTC_HOLD, .u = 657.2462125098361, .xhat = {-0.13216925428744164, -14.606866431309834, -131.10265124321324}, .d = -224.0620405860183},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.0, 0.0}, .status = PTC_HOLD, .u = -871.5913092467576, .xhat = {0.0024166766865002937, 21.470744018735438, 293.31683275643036}, .d = 124.91531216354923},
    {.is_armed = 1U, .start = 4294967293U, .k = 4294967293U, .y = {0.75, 0.25}, .status = PTC_OK, .u = 163.4672728992265, .xhat = {-0.23099132669429903, -48.9740556664003, -572.2131356073035}, .d = -657.1181693692233},
    {.is_armed = 0U, .start = 0U, .k = 4294967294U, .y = {0.7252083333333332, 0.2417361111111111}, .status = PTC_OK, .u = 182.03410524148921, .xhat = {0.08663650965359405, -34.186641207641486, -413.5243494737452}, .d = -535.9302141610649},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.7008333333333333, 0.2336111111111111}, .status = PTC_OK, .u = 196.92102165313702, .xhat = {0.3142098956282846, -22.436258357747693, -284.8397825660466}, .d = -438.67939784947646},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)NAN, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.3142098956282846, -22.436258357747693, -284.8397825660466}, .d = -438.67939784947646},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, (double)NAN}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.3142098956282846, -22.436258357747693, -284.8397825660466}, .d = -438.67939784947646},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)INFINITY, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.3142098956282846, -22.436258357747693, -284.8397825660466}, .d = -438.67939784947646},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, (double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.3142098956282846, -22.436258357747693, -284.8397825660466}, .d = -438.67939784947646},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {-(double)INFINITY, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.3142098956282846, -22.436258357747693, -284.8397825660466}, .d = -438.67939784947646},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, -(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.3142098956282846, -22.436258357747693, -284.8397825660466}, .d = -438.67939784947646},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.676875, 0.225625}, .status = PTC_OK, .u = 207.68297040074606, .xhat = {0.4692288675932321, -13.565106018295332, -185.56207945350096}, .d = -363.856284944221},
    {.is_armed = 0U, .start = 0U, .k = 7U, .y = {0.5208333333333334, 0.17361111111111113}, .status = PTC_OK, .u = 220.16222174147603, .xhat = {0.5669123257418237, -7.276939700914052, -113.2108716384155}, .d = -309.0558467076514},
    {.is_armed = 0U, .start = 0U, .k = 13U, .y = {0.40333333333333327, 0.13444444444444442}, .status = PTC_OK, .u = 200.31879051089604, .xhat = {0.541565307501548, -0.483298702469221, -10.764841463129628}, .d = -208.67111328532025},
    {.is_armed = 0U, .start = 0U, .k = 15U, .y = {0.36749999999999994, 0.12249999999999998}, .status = PTC_OK, .u = 189.16200883590284, .xhat = {0.26911807726089365, -12.966796449668504, 7.788826416447932}, .d = -183.8149144598059},
    {.is_armed = 0U, .start = 0U, .k = 16U, .y = {0.35020833333333334, 0.11673611111111111}, .status = PTC_OK, .u = 198.17294507645946, .xhat = {0.33082347278918345, -3.874278519562857, -4.067372777751046}, .d = -201.26367129285103},
    {.is_armed = 0U, .start = 0U, .k = 17U, .y = {0.3333333333333333, 0.1111111111111111}, .status = PTC_OK, .u = 191.43666712049142, .xhat = {0.334151058421421, -1.4120088100923391, 3.486062082971074}, .d = -189.54869229970836},
    {.is_armed = 0U, .start = 0U, .k = 18U, .y = {0.316875, 0.10562500000000001}, .status = PTC_OK, .u = 196.58149999804132, .xhat = {0.31575303791068937, -1.8714695120054285, -2.4108887823524583}, .d = -198.5434914378976},
    {.is_armed = 0U, .start = 0U, .k = 37U, .y = {0.08333333333333333, 0.027777777777777776}, .status = PTC_OK, .u = 190.251327748161, .xhat = {0.3007232886337081, -1.4775780345608522, 2.018786472120013}, .d = -191.83877635277278},
    {.is_armed = 0U, .start = 0U, .k = 53U, .y = {0.003333333333333333, 0.0011111111111111111}, .status = PTC_HOLD, .u = 194.65592750447004, .xhat = {0.16842635809641937, -4.222570502933032, -1.9588639888442572}, .d = -196.2102209582969},
    {.is_armed = 0U, .start = 0U, .k = 55U, .y = {0.0008333333333333333, 0.0002777777777777778}, .status = PTC_HOLD, .u = 239.38196412508034, .xhat = {0.04139875927618823, -5.7191918577064165, 2.1524739204340335}, .d = -190.27292977187687},
    {.is_armed = 0U, .start = 0U, .k = 56U, .y = {0.00020833333333333332, 6.944444444444444e-5}, .status = PTC_HOLD, .u = 234.52383237658324, .xhat = {-0.03429162078469851, -4.913789785494697, 16.987462857868252}, .d = -195.8362876895966},
    {.is_armed = 0U, .start = 0U, .k = 57U, .y = {0.0, 0.0}, .status = PTC_HOLD, .u = 339.49114787221555, .xhat = {-0.08185677141178983, -5.992274500872396, -1.8264108232194047}, .d = -241.2769268290048},
    {.is_armed = 0U, .start = 0U, .k = 58U, .y = {0.0, 0.0}, .status = PTC_HOLD, .u = 216.74232988071714, .xhat = {-0.08525987512591171, -1.6759048530013168, 39.10847090878087}, .d = -236.76015566028727},
    {.is_armed = 0U, .start = 0U, .k = 2147483644U, .y = {0.0, 0.0}, .status = PTC_HOLD, .u = 541.6944177088211, .xhat = {-0.10765053507602496, -7.601532837007138, -46.15841553773399}, .d = -341.39899137186796},
    {.is_armed = 0U, .start = 0U, .k = 4294967292U, .y = {0.0, 0.0}, .status = PTC_HOLD, .u = -56.337594118738764, .xhat = {-0.04722667095402512, 7.286649730263717, 121.32500783417177}, .d = -218.79501953316617},
    {.is_armed = 0U, .start = 0U, .k = 12U, .y = {0.7904823414645025, -0.5470612866981754}, .status = PTC_OK, .u = -1.133015666842653, .xhat = {0.7904823414645025, 0.0, -0.5470612866981754}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 58U, .y = {1.2569074679345988e302, 7.138694369355342e301}, .status = PTC_HOLD, .u = -248.89927926696768, .xhat = {0.7900219272627913, -0.09631048230937114, -0.7205001494529288}, .d = 0.0},
    {.is_armed = 1U, .start = 4294967290U, .k = 19U, .y = {1.445753444644169e302, -1.4082194342909396e302}, .status = PTC_OK, .u = -4.145174263738937e302, .xhat = {1.445753444644169e302, 0.0, -1.4082194342909396e302}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 59U, .y = {1.0436285701173363e308, 1.4041291220476347e308}, .status = PTC_E_RANGE, .u = 0.0, .xhat = {0.0, 0.0, 0.0}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 4U, .y = {0.929210790610199, -0.7458367212757557}, .status = PTC_SATURATED, .u = -1.0, .xhat = {0.929210790610199, 0.0, -0.7458367212757557}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 18U, .y = {8.301705669304328e307, 6.386095643075268e307}, .status = PTC_E_RANGE, .u = 0.0, .xhat = {0.929210790610199, 0.0, -0.7458367212757557}, .d = 0.0},
    {.is_armed = 1U, .start = 4294967290U, .k = 19U, .y = {-1.2280243887601136e302, 1.0554856607906025e302}, .status = PTC_SATURATED, .u = 1.0, .xhat = {-1.2280243887601136e302, 0.0, 1.0554856607906025e302}, .d = 0.0},
};

/* 1 where a number is not the one that must come. */
static uint32_t stage47_selftest_differs(double value, double wanted)
{
    uint32_t failures = 1U;

    if (fabs(value - wanted) <= 0.0) {
        failures = 0U;
    }
    return failures;
}

/* The failures of one call. */
static uint32_t stage47_selftest_check(stage47 *self, const stage47_selftest_call *call)
{
    uint32_t failures = 0U;
    double u = 12345.0;
    double xhat[3] = {12345.0, 12345.0, 12345.0};
    double d = 12345.0;

    if (call->is_armed != 0U) {
        if (stage47_arm(self, call->start) != PTC_OK) {
            failures++;
        }
    }
    if (stage47_step(self, call->k, call->y, &u) != call->status) {
        failures++;
    }
    failures += stage47_selftest_differs(u, call->u);
    if (stage47_estimate(self, xhat) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 3U; i++) {
        failures += stage47_selftest_differs(xhat[i], call->xhat[i]);
    }
    if (stage47_disturbance(self, &d) != PTC_OK) {
        failures++;
    }
    failures += stage47_selftest_differs(d, call->d);
    return failures;
}

/* The calls of a session, of which init has been called. */
static uint32_t stage47_selftest_calls_of(stage47 *self, const stage47_selftest_session *session)
{
    uint32_t failures = 0U;

    for (uint32_t j = 0U; j < session->count; j++) {
        failures += stage47_selftest_check(self, &stage47_selftest_calls[session->first + j]);
    }
    return failures;
}

/* Every session with its calls. */
static uint32_t stage47_selftest_run(void)
{
    uint32_t failures = 0U;

    for (uint32_t i = 0U; i < 5U; i++) {
        const stage47_selftest_session *session = &stage47_selftest_sessions[i];
        stage47 self;

        if (stage47_init(&self, &session->params) == PTC_OK) {
            failures += stage47_selftest_calls_of(&self, session);
        } else {
            failures++;
        }
    }
    return failures;
}

/* What init must refuse without a change. */
static uint32_t stage47_selftest_refuse(void)
{
    static const stage47_params refused[7] = {
        {.samples = 0U, .u_max = (double)INFINITY},
        {.samples = 22U, .u_max = (double)INFINITY},
        {.samples = 60U, .u_max = (double)NAN},
        {.samples = 60U, .u_max = -(double)INFINITY},
        {.samples = 60U, .u_max = 0.0},
        {.samples = 60U, .u_max = -1.0},
        {.samples = 60U, .u_max = -1.7976931348623157e308},
    };
    const stage47_selftest_session *session = &stage47_selftest_sessions[0];
    uint32_t failures = 0U;
    stage47 self;

    if (stage47_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 7U; i++) {
        if (stage47_init(&self, &refused[i]) != PTC_E_PARAM) {
            failures++;
        }
    }
    if (stage47_init(&self, NULL) != PTC_E_PARAM) {
        failures++;
    }
    if (stage47_init(NULL, &session->params) != PTC_E_PARAM) {
        failures++;
    }
    failures += stage47_selftest_calls_of(&self, session);
    return failures;
}

/* Calls that lack a pointer: each is refused, and changes nothing. */
static uint32_t stage47_selftest_pointers(void)
{
    const stage47_selftest_session *session = &stage47_selftest_sessions[0];
    const stage47_selftest_call *call = &stage47_selftest_calls[0];
    uint32_t failures = 0U;
    double u = 12345.0;
    double xhat[3];
    double d;
    stage47 self;

    if (stage47_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    if (stage47_arm(NULL, call->start) != PTC_E_INPUT) {
        failures++;
    }
    if (stage47_step(NULL, call->k, call->y, &u) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage47_selftest_differs(u, 0.0);
    u = 12345.0;
    if (stage47_step(&self, call->k, NULL, &u) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage47_selftest_differs(u, 0.0);
    if (stage47_step(&self, call->k, call->y, NULL) != PTC_E_INPUT) {
        failures++;
    }
    if (stage47_estimate(NULL, xhat) != PTC_E_INPUT) {
        failures++;
    }
    if (stage47_estimate(&self, NULL) != PTC_E_INPUT) {
        failures++;
    }
    if (stage47_disturbance(NULL, &d) != PTC_E_INPUT) {
        failures++;
    }
    if (stage47_disturbance(&self, NULL) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage47_selftest_calls_of(&self, session);
    return failures;
}

uint32_t stage47_selftest(void)
{
    uint32_t failures = stage47_selftest_run();

    failures += stage47_selftest_refuse();
    failures += stage47_selftest_pointers();
    return failures;
}
