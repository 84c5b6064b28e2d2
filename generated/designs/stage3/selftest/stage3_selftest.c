/* Self-test of the prescribed-time controller stage3: see stage3_selftest.h. DO NOT EDIT. */
#include "stage3_selftest.h"
#include "stage3.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct stage3_selftest_call {
    uint32_t is_armed; /* arm is called before it */
    uint32_t start;
    uint32_t k;
    double y[1]; /* what is measured */
    ptc_status status;
    double u;
    double xhat[2]; /* the estimates behind it */
    double d;
} stage3_selftest_call;

/* A set of parameters that init takes, and the calls with it, one after the other. */
typedef struct stage3_selftest_session {
    stage3_params params;
    uint32_t first; /* of its calls */
    uint32_t count;
} stage3_selftest_session;

static const stage3_selftest_session stage3_selftest_sessions[4] = {
    {.params = {.u_max = (double)INFINITY}, .first = 0U, .count = 42U},
    {.params = {.u_max = (double)INFINITY}, .first = 42U, .count = 3U},
    {.params = {.u_max = (double)INFINITY}, .first = 45U, .count = 2U},
    {.params = {.u_max = 1.0}, .first = 47U, .count = 2U},
};

static const stage3_selftest_call stage3_selftest_calls[49] = {
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.75}, .status = PTC_OK, .u = -1215.4606595899845, .xhat = {0.75, 0.0}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {0.7129687499999999}, .status = PTC_OK, .u = -1946.3361967320284, .xhat = {0.7303570046439628, -3.6687306501548056}, .d = -152.86377708978358},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.676875}, .status = PTC_OK, .u = -2145.044538921656, .xhat = {0.6987904371155275, -10.455707120893553}, .d = -393.69275638129375},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)NAN}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.6987904371155275, -10.455707120893553}, .d = -393.69275638129375},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.6987904371155275, -10.455707120893553}, .d = -393.69275638129375},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {-(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.6987904371155275, -10.455707120893553}, .d = -393.69275638129375},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {0.6417187500000001}, .status = PTC_OK, .u = -1869.939780375608, .xhat = {0.6608327884384855, -18.40964946153405}, .d = -661.0219653111592},
    {.is_armed = 0U, .start = 0U, .k = 10U, .y = {0.421875}, .status = PTC_OK, .u = 6000.02061449175, .xhat = {0.4583991842874725, -97.91650296945912}, .d = -7965.858822805661},
    {.is_armed = 0U, .start = 0U, .k = 16U, .y = {0.27}, .status = PTC_OK, .u = 67155.1844404137, .xhat = {0.27, -236.09947459727454}, .d = -93530.64083922842},
    {.is_armed = 0U, .start = 0U, .k = 18U, .y = {0.22687500000000005}, .status = PTC_OK, .u = -47857.769347056965, .xhat = {0.22687500000000005, 31.479582242453148}, .d = 143209.14387041447},
    {.is_armed = 0U, .start = 0U, .k = 19U, .y = {0.20671875}, .status = PTC_OK, .u = -17125.118714908574, .xhat = {0.20671875, 6.616915956480341}, .d = -13608.852527452837},
    {.is_armed = 0U, .start = 0U, .k = 20U, .y = {0.1875}, .status = PTC_OK, .u = 1422.071931639577, .xhat = {0.1875, -47.503238446867634}, .d = -8711.207546678284},
    {.is_armed = 0U, .start = 0U, .k = 21U, .y = {0.16921875}, .status = PTC_OK, .u = -20304.91047592589, .xhat = {0.16921875, -10.129337341962938}, .d = 33428.94403098276},
    {.is_armed = 0U, .start = 0U, .k = 30U, .y = {0.046875}, .status = PTC_OK, .u = 174744.18410764908, .xhat = {0.046875, -169.7382023383629}, .d = -96210.97660836544},
    {.is_armed = 0U, .start = 0U, .k = 36U, .y = {0.0075000000000000015}, .status = PTC_OK, .u = -465016.485829181, .xhat = {0.007500000000000007, -3.322370601891464}, .d = 92410.16927214312},
    {.is_armed = 0U, .start = 0U, .k = 38U, .y = {0.0018750000000000004}, .status = PTC_OK, .u = 908536.1979912122, .xhat = {0.0018749999999999878, 60.01227364589377}, .d = -43469.63681586152},
    {.is_armed = 0U, .start = 0U, .k = 39U, .y = {0.0004687500000000001}, .status = PTC_OK, .u = -1867513.2423542035, .xhat = {0.00046874999999999, -159.2370424842075}, .d = 149354.90086076595},
    {.is_armed = 0U, .start = 0U, .k = 40U, .y = {0.0}, .status = PTC_HOLD, .u = 3539023.125563707, .xhat = {0.0, 343.3881709550983}, .d = -220822.3560810156},
    {.is_armed = 0U, .start = 0U, .k = 41U, .y = {0.0}, .status = PTC_HOLD, .u = -6783473.104956014, .xhat = {0.0, -693.7779850863542}, .d = 479957.2721814956},
    {.is_armed = 0U, .start = 0U, .k = 2147483647U, .y = {0.0}, .status = PTC_HOLD, .u = 12695125.80477759, .xhat = {0.0, 1351.6340919794777}, .d = -835754.9416047516},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.0}, .status = PTC_HOLD, .u = -23805366.434568807, .xhat = {0.0, -2580.624057629931}, .d = 1622224.989696153},
    {.is_armed = 1U, .start = 4294967293U, .k = 4294967293U, .y = {0.75}, .status = PTC_OK, .u = -17700849.588478666, .xhat = {2.6304462720876196, 11394.216880142138}, .d = 1608793.2306098128},
    {.is_armed = 0U, .start = 0U, .k = 4294967294U, .y = {0.7129687499999999}, .status = PTC_OK, .u = -12479914.339046365, .xhat = {1.7522882021298947, -11021.641307123384}, .d = 1599656.356305374},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.676875}, .status = PTC_OK, .u = -8202234.776803529, .xhat = {-7.351120341266139, -25137.890636236363}, .d = 1687876.0853302768},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)NAN}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {-7.351120341266139, -25137.890636236363}, .d = 1687876.0853302768},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {-7.351120341266139, -25137.890636236363}, .d = 1687876.0853302768},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {-(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {-7.351120341266139, -25137.890636236363}, .d = 1687876.0853302768},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.6417187500000001}, .status = PTC_OK, .u = -4954709.16777151, .xhat = {-15.562178562275172, -31170.74226676674}, .d = 1914504.0197676918},
    {.is_armed = 0U, .start = 0U, .k = 7U, .y = {0.421875}, .status = PTC_OK, .u = -3233233.0790678486, .xhat = {-7.961235201259967, -19853.94160115664}, .d = 3591126.0600196864},
    {.is_armed = 0U, .start = 0U, .k = 13U, .y = {0.27}, .status = PTC_OK, .u = -19164606.259282876, .xhat = {0.2699999999999996, 21932.927825530318}, .d = 32358094.416312207},
    {.is_armed = 0U, .start = 0U, .k = 15U, .y = {0.22687500000000005}, .status = PTC_OK, .u = -6595283.840423409, .xhat = {0.22687499999999972, -3749.936078454062}, .d = -4180389.0778402872},
    {.is_armed = 0U, .start = 0U, .k = 16U, .y = {0.20671875}, .status = PTC_OK, .u = -8667347.743995436, .xhat = {0.20671875000000028, -3991.515170053757}, .d = 11221888.419175355},
    {.is_armed = 0U, .start = 0U, .k = 17U, .y = {0.1875}, .status = PTC_OK, .u = -11465221.801909193, .xhat = {0.1875, 3123.580604714866}, .d = 12880882.549853139},
    {.is_armed = 0U, .start = 0U, .k = 18U, .y = {0.16921875}, .status = PTC_OK, .u = -9094570.82275327, .xhat = {0.16921874999999975, -535.8284758930085}, .d = 7632253.29220942},
    {.is_armed = 0U, .start = 0U, .k = 27U, .y = {0.046875}, .status = PTC_OK, .u = -9677730.021091346, .xhat = {0.046875, -873.8435144784394}, .d = 9962222.272952316},
    {.is_armed = 0U, .start = 0U, .k = 33U, .y = {0.0075000000000000015}, .status = PTC_OK, .u = -12345949.182562474, .xhat = {0.007500000000000007, 594.7721197889821}, .d = 10362865.062331233},
    {.is_armed = 0U, .start = 0U, .k = 35U, .y = {0.0018750000000000004}, .status = PTC_OK, .u = -3233328.4016806763, .xhat = {0.00187499999999996, -134.53979958451873}, .d = 9419900.421922307},
    {.is_armed = 0U, .start = 0U, .k = 36U, .y = {0.0004687500000000001}, .status = PTC_OK, .u = -24916107.838699922, .xhat = {0.00046875000000001776, -666.3516653677812}, .d = 11016058.35182691},
    {.is_armed = 0U, .start = 0U, .k = 37U, .y = {0.0}, .status = PTC_HOLD, .u = 20765098.812984005, .xhat = {0.0, 2278.155195220449}, .d = 7790576.292121574},
    {.is_armed = 0U, .start = 0U, .k = 38U, .y = {0.0}, .status = PTC_HOLD, .u = -70204607.02590187, .xhat = {0.0, -5420.460484254811}, .d = 14075186.8701903},
    {.is_armed = 0U, .start = 0U, .k = 2147483644U, .y = {0.0}, .status = PTC_HOLD, .u = 105631946.3559274, .xhat = {0.0, 11420.301662920985}, .d = 2075504.5128579605},
    {.is_armed = 0U, .start = 0U, .k = 4294967292U, .y = {0.0}, .status = PTC_HOLD, .u = -228567088.88192782, .xhat = {0.0, -22742.42645972148}, .d = 24719754.106458925},
    {.is_armed = 0U, .start = 0U, .k = 12U, .y = {-0.6436469406731915}, .status = PTC_OK, .u = 2863.83510866826, .xhat = {-0.6436469406731915, 0.0}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 13U, .y = {0.2610565074889896}, .status = PTC_OK, .u = 55740.49158756193, .xhat = {0.2610565074889897, 775.4600984247267}, .d = -258486.69947490894},
    {.is_armed = 0U, .start = 0U, .k = 40U, .y = {1.4463899282428682e302}, .status = PTC_E_RANGE, .u = 0.0, .xhat = {0.2610565074889897, 775.4600984247267}, .d = -258486.69947490894},
    {.is_armed = 1U, .start = 4294967290U, .k = 33U, .y = {4.377355581021666e153}, .status = PTC_OK, .u = -4.377355581021666e159, .xhat = {4.377355581021666e153, 0.0}, .d = 0.0},
    {.is_armed = 1U, .start = 0U, .k = 30U, .y = {-6.056058047674721e153}, .status = PTC_OK, .u = 8.21441979230971e158, .xhat = {-6.056058047674721e153, 0.0}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {-0.5918653123115474}, .status = PTC_SATURATED, .u = 1.0, .xhat = {-0.5918653123115474, 0.0}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {0.9637360253933878}, .status = PTC_SATURATED, .u = -1.0, .xhat = {0.23329370479922307, 154.11530280668086}, .d = 6421.47095027837},
};

/* 1 where a number is not the one that must come. */
static uint32_t stage3_selftest_differs(double value, double wanted)
{
    uint32_t failures = 1U;

    if (fabs(value - wanted) <= 0.0) {
        failures = 0U;
    }
    return failures;
}

/* The failures of one call. */
static uint32_t stage3_selftest_check(stage3 *self, const stage3_selftest_call *call)
{
    uint32_t failures = 0U;
    double u = 12345.0;
    double xhat[2] = {12345.0, 12345.0};
    double d = 12345.0;

    if (call->is_armed != 0U) {
        if (stage3_arm(self, call->start) != PTC_OK) {
            failures++;
        }
    }
    if (stage3_step(self, call->k, call->y, &u) != call->status) {
        failures++;
    }
    failures += stage3_selftest_differs(u, call->u);
    if (stage3_estimate(self, xhat) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 2U; i++) {
        failures += stage3_selftest_differs(xhat[i], call->xhat[i]);
    }
    if (stage3_disturbance(self, &d) != PTC_OK) {
        failures++;
    }
    failures += stage3_selftest_differs(d, call->d);
    return failures;
}

/* The calls of a session, of which init has been called. */
static uint32_t stage3_selftest_calls_of(stage3 *self, const stage3_selftest_session *session)
{
    uint32_t failures = 0U;

    for (uint32_t j = 0U; j < session->count; j++) {
        failures += stage3_selftest_check(self, &stage3_selftest_calls[session->first + j]);
    }
    return failures;
}

/* Every session with its calls. */
static uint32_t stage3_selftest_run(void)
{
    uint32_t failures = 0U;

    for (uint32_t i = 0U; i < 4U; i++) {
        const stage3_selftest_session *session = &stage3_selftest_sessions[i];
        stage3 self;

        if (stage3_init(&self, &session->params) == PTC_OK) {
            failures += stage3_selftest_calls_of(&self, session);
        } else {
            failures++;
        }
    }
    return failures;
}

/* What init must refuse without a change. */
static uint32_t stage3_selftest_refuse(void)
{
    static const stage3_params refused[5] = {
        {.u_max = (double)NAN},
        {.u_max = -(double)INFINITY},
        {.u_max = 0.0},
        {.u_max = -1.0},
        {.u_max = -1.7976931348623157e308},
    };
    const stage3_selftest_session *session = &stage3_selftest_sessions[0];
    uint32_t failures = 0U;
    stage3 self;

    if (stage3_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 5U; i++) {
        if (stage3_init(&self, &refused[i]) != PTC_E_PARAM) {
            failures++;
        }
    }
    if (stage3_init(&self, NULL) != PTC_E_PARAM) {
        failures++;
    }
    if (stage3_init(NULL, &session->params) != PTC_E_PARAM) {
        failures++;
    }
    failures += stage3_selftest_calls_of(&self, session);
    return failures;
}

/* Calls that lack a pointer: each is refused, and changes nothing. */
static uint32_t stage3_selftest_pointers(void)
{
    const stage3_selftest_session *session = &stage3_selftest_sessions[0];
    const stage3_selftest_call *call = &stage3_selftest_calls[0];
    uint32_t failures = 0U;
    double u = 12345.0;
    double xhat[2];
    double d;
    stage3 self;

    if (stage3_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    if (stage3_arm(NULL, call->start) != PTC_E_INPUT) {
        failures++;
    }
    if (stage3_step(NULL, call->k, call->y, &u) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage3_selftest_differs(u, 0.0);
    u = 12345.0;
    if (stage3_step(&self, call->k, NULL, &u) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage3_selftest_differs(u, 0.0);
    if (stage3_step(&self, call->k, call->y, NULL) != PTC_E_INPUT) {
        failures++;
    }
    if (stage3_estimate(NULL, xhat) != PTC_E_INPUT) {
        failures++;
    }
    if (stage3_estimate(&self, NULL) != PTC_E_INPUT) {
        failures++;
    }
    if (stage3_disturbance(NULL, &d) != PTC_E_INPUT) {
        failures++;
    }
    if (stage3_disturbance(&self, NULL) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage3_selftest_calls_of(&self, session);
    return failures;
}

uint32_t stage3_selftest(void)
{
    uint32_t failures = stage3_selftest_run();

    failures += stage3_selftest_refuse();
    failures += stage3_selftest_pointers();
    return failures;
}
