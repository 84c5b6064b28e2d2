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
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.75, 0.25}, .status = PTC_OK, .u = -0.14045833980625283, .xhat = {0.75, 0.0, 0.25}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {0.7252083333333332, 0.2417361111111111}, .status = PTC_OK, .u = -0.2981339202457347, .xhat = {0.7501392891127847, 0.023678028078830196, 0.08269080286421276}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.7008333333333333, 0.2336111111111111}, .status = PTC_OK, .u = -0.43818567202744396, .xhat = {0.7402494292830577, -0.033685833358031984, -0.04496716228771813}, .d = 0.010886828448398143},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)NAN, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7402494292830577, -0.033685833358031984, -0.04496716228771813}, .d = 0.010886828448398143},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, (double)NAN}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7402494292830577, -0.033685833358031984, -0.04496716228771813}, .d = 0.010886828448398143},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)INFINITY, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7402494292830577, -0.033685833358031984, -0.04496716228771813}, .d = 0.010886828448398143},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, (double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7402494292830577, -0.033685833358031984, -0.04496716228771813}, .d = 0.010886828448398143},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {-(double)INFINITY, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7402494292830577, -0.033685833358031984, -0.04496716228771813}, .d = 0.010886828448398143},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, -(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7402494292830577, -0.033685833358031984, -0.04496716228771813}, .d = 0.010886828448398143},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {0.676875, 0.225625}, .status = PTC_OK, .u = -0.5581184727388628, .xhat = {0.7229195552398618, -0.15246644629612793, -0.12750372840275115}, .d = 0.03720046397489267},
    {.is_armed = 0U, .start = 0U, .k = 10U, .y = {0.5208333333333334, 0.17361111111111113}, .status = PTC_OK, .u = -0.795323390520688, .xhat = {0.7003381252987706, -0.31517205621330957, -0.165647708509269}, .d = 0.07991187867053823},
    {.is_armed = 0U, .start = 0U, .k = 16U, .y = {0.40333333333333327, 0.13444444444444442}, .status = PTC_OK, .u = -0.3862278618944965, .xhat = {0.5548033315143845, -2.61210585320089, -0.08407103614033601}, .d = -0.3370149634195226},
    {.is_armed = 0U, .start = 0U, .k = 18U, .y = {0.36749999999999994, 0.12249999999999998}, .status = PTC_OK, .u = 4.624738934607722, .xhat = {0.22683085975463244, -17.586956073794767, 0.30256746630333714}, .d = -4.298531013700542},
    {.is_armed = 0U, .start = 0U, .k = 19U, .y = {0.35020833333333334, 0.11673611111111111}, .status = PTC_OK, .u = 1.5665382827668783, .xhat = {0.3325702092088698, -3.374811511981011, 1.988938908534701}, .d = -0.558652920060403},
    {.is_armed = 0U, .start = 0U, .k = 20U, .y = {0.3333333333333333, 0.1111111111111111}, .status = PTC_OK, .u = 3.906038885272358, .xhat = {0.3328471291203623, -1.7848582330264684, -1.0349418733731335}, .d = -5.011422398413235},
    {.is_armed = 0U, .start = 0U, .k = 21U, .y = {0.316875, 0.10562500000000001}, .status = PTC_OK, .u = 2.1879377703485847, .xhat = {0.3167331305476189, -1.5919532490976753, 0.978678970147254}, .d = -1.9579015854256268},
    {.is_armed = 0U, .start = 0U, .k = 40U, .y = {0.08333333333333333, 0.027777777777777776}, .status = PTC_OK, .u = 2.5414992382763764, .xhat = {0.29998377843057966, -1.6888049577135191, -0.5420494069499979}, .d = -4.286257185469006},
    {.is_armed = 0U, .start = 0U, .k = 56U, .y = {0.003333333333333333, 0.0011111111111111111}, .status = PTC_HOLD, .u = -6.564399124594882, .xhat = {0.16914693068018774, -4.016746770201904, 0.5372990475202014}, .d = -1.8331662904001413},
    {.is_armed = 0U, .start = 0U, .k = 58U, .y = {0.0008333333333333333, 0.0002777777777777778}, .status = PTC_HOLD, .u = 65.51392930425665, .xhat = {0.03993967587969114, -6.136027294951553, -2.9015170057817903}, .d = -2.5480609326868944},
    {.is_armed = 0U, .start = 0U, .k = 59U, .y = {0.00020833333333333332, 6.944444444444444e-5}, .status = PTC_HOLD, .u = 5.274489193857194, .xhat = {-0.03133836767152042, -4.069883663142203, 27.220771668294745}, .d = 5.357286859401045},
    {.is_armed = 0U, .start = 0U, .k = 60U, .y = {0.0, 0.0}, .status = PTC_HOLD, .u = 222.37615829767762, .xhat = {-0.08783787060240417, -7.701054518952983, -22.54621310021176}, .d = -67.3547602981773},
    {.is_armed = 0U, .start = 0U, .k = 61U, .y = {0.0, 0.0}, .status = PTC_HOLD, .u = -127.41744571971218, .xhat = {-0.0731511330905035, 1.7839086251660303, 81.06127973952778}, .d = -7.620451467149408},
    {.is_armed = 0U, .start = 0U, .k = 2147483647U, .y = {0.0, 0.0}, .status = PTC_HOLD, .u = 657.2462125098356, .xhat = {-0.1321692542874415, -14.606866431309822, -131.1026512432131}, .d = -224.06204058601813},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.0, 0.0}, .status = PTC_HOLD, .u = -871.5913092467567, .xhat = {0.002416676686500238, 21.47074401873542, 293.31683275643}, .d = 124.915312163549},
    {.is_armed = 1U, .start = 4294967293U, .k = 4294967293U, .y = {0.75, 0.25}, .status = PTC_OK, .u = 163.46727289922654, .xhat = {-0.2309913266942989, -48.974055666400226, -572.2131356073028}, .d = -657.1181693692226},
    {.is_armed = 0U, .start = 0U, .k = 4294967294U, .y = {0.7252083333333332, 0.2417361111111111}, .status = PTC_OK, .u = 182.03410524148921, .xhat = {0.08663650965359429, -34.18664120764146, -413.52434947374456}, .d = -535.9302141610643},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.7008333333333333, 0.2336111111111111}, .status = PTC_OK, .u = 196.9210216531369, .xhat = {0.3142098956282846, -22.436258357747665, -284.8397825660462}, .d = -438.679397849476},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)NAN, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.3142098956282846, -22.436258357747665, -284.8397825660462}, .d = -438.679397849476},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, (double)NAN}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.3142098956282846, -22.436258357747665, -284.8397825660462}, .d = -438.679397849476},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)INFINITY, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.3142098956282846, -22.436258357747665, -284.8397825660462}, .d = -438.679397849476},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, (double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.3142098956282846, -22.436258357747665, -284.8397825660462}, .d = -438.679397849476},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {-(double)INFINITY, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.3142098956282846, -22.436258357747665, -284.8397825660462}, .d = -438.679397849476},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, -(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.3142098956282846, -22.436258357747665, -284.8397825660462}, .d = -438.679397849476},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.676875, 0.225625}, .status = PTC_OK, .u = 207.68297040074594, .xhat = {0.4692288675932321, -13.565106018295314, -185.5620794535007}, .d = -363.85628494422065},
    {.is_armed = 0U, .start = 0U, .k = 7U, .y = {0.5208333333333334, 0.17361111111111113}, .status = PTC_OK, .u = 220.16222174147583, .xhat = {0.5669123257418237, -7.276939700914034, -113.21087163841537}, .d = -309.05584670765114},
    {.is_armed = 0U, .start = 0U, .k = 13U, .y = {0.40333333333333327, 0.13444444444444442}, .status = PTC_OK, .u = 200.3187905108959, .xhat = {0.5415653075015479, -0.4832987024692095, -10.764841463129613}, .d = -208.67111328532008},
    {.is_armed = 0U, .start = 0U, .k = 15U, .y = {0.36749999999999994, 0.12249999999999998}, .status = PTC_OK, .u = 189.16200883590267, .xhat = {0.2691180772608938, -12.966796449668482, 7.788826416447904}, .d = -183.81491445980575},
    {.is_armed = 0U, .start = 0U, .k = 16U, .y = {0.35020833333333334, 0.11673611111111111}, .status = PTC_OK, .u = 198.17294507645926, .xhat = {0.33082347278918345, -3.87427851956285, -4.067372777751018}, .d = -201.2636712928508},
    {.is_armed = 0U, .start = 0U, .k = 17U, .y = {0.3333333333333333, 0.1111111111111111}, .status = PTC_OK, .u = 191.43666712049122, .xhat = {0.334151058421421, -1.4120088100923347, 3.48606208297106}, .d = -189.5486922997082},
    {.is_armed = 0U, .start = 0U, .k = 18U, .y = {0.316875, 0.10562500000000001}, .status = PTC_OK, .u = 196.5814999980411, .xhat = {0.3157530379106895, -1.8714695120054232, -2.4108887823524583}, .d = -198.54349143789736},
    {.is_armed = 0U, .start = 0U, .k = 37U, .y = {0.08333333333333333, 0.027777777777777776}, .status = PTC_OK, .u = 190.25132774816078, .xhat = {0.30072328863370823, -1.477578034560847, 2.018786472120013}, .d = -191.83877635277256},
    {.is_armed = 0U, .start = 0U, .k = 53U, .y = {0.003333333333333333, 0.0011111111111111111}, .status = PTC_HOLD, .u = 194.65592750446973, .xhat = {0.16842635809641948, -4.222570502933027, -1.9588639888442572}, .d = -196.21022095829667},
    {.is_armed = 0U, .start = 0U, .k = 55U, .y = {0.0008333333333333333, 0.0002777777777777778}, .status = PTC_HOLD, .u = 239.38196412508015, .xhat = {0.041398759276188336, -5.719191857706414, 2.152473920433991}, .d = -190.27292977187665},
    {.is_armed = 0U, .start = 0U, .k = 56U, .y = {0.00020833333333333332, 6.944444444444444e-5}, .status = PTC_HOLD, .u = 234.52383237658267, .xhat = {-0.034291620784698384, -4.9137897854946875, 16.98746285786831}, .d = -195.83628768959625},
    {.is_armed = 0U, .start = 0U, .k = 57U, .y = {0.0, 0.0}, .status = PTC_HOLD, .u = 339.49114787221566, .xhat = {-0.08185677141178979, -5.992274500872406, -1.8264108232195468}, .d = -241.2769268290046},
    {.is_armed = 0U, .start = 0U, .k = 58U, .y = {0.0, 0.0}, .status = PTC_HOLD, .u = 216.74232988071583, .xhat = {-0.08525987512591154, -1.675904853001299, 39.10847090878114}, .d = -236.76015566028667},
    {.is_armed = 0U, .start = 0U, .k = 2147483644U, .y = {0.0, 0.0}, .status = PTC_HOLD, .u = 541.6944177088228, .xhat = {-0.10765053507602512, -7.6015328370071895, -46.15841553773454}, .d = -341.3989913718681},
    {.is_armed = 0U, .start = 0U, .k = 4294967292U, .y = {0.0, 0.0}, .status = PTC_HOLD, .u = -56.3375941187432, .xhat = {-0.047226670954024864, 7.286649730263807, 121.32500783417294}, .d = -218.7950195331648},
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
